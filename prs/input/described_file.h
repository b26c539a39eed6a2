#pragma once

#include "prs/input/echo.h"
#include "prs/input/field.h"

/// Files other than a case whose keys are described in the same vocabulary.
namespace prs::input {

/// Reads a document by the description of its keys, each value independently.
void read_described(const Node& root, const Value& description, ErrorList& errors);

/// Values of the document with defaults filled in, each as it was written.
nlohmann::ordered_json resolved(const Node& root, const Value& description);

/// Entry for every value, with the text that was written for it.
std::vector<EchoEntry> echo_of(const Node& root, const Value& description);

/// JSON Schema of such a file, see `schema`.
nlohmann::ordered_json schema_of(std::string_view title, const Value& description);

// Blocks of a case that other files share.
void alternatives(Choices& io, Mechanism::Type& type);
void alternatives(Choices& io, MeasureOptions::Ends& ends);
void alternatives(Choices& io, Direction& direction);
void alternatives(Choices& io, BackDriving& wanted);
void alternatives(Choices& io, ModelOptions::Loads& loads);
void alternatives(Choices& io, Friction& friction);
void fields(const Fields& io, Lubricant& lubricant);
void fields(const Fields& io, Carrier& carrier);
void fields(const Fields& io, Heat& heat);
void fields(const Fields& io, Life& life);
void fields(const Fields& io, Bearings& bearings);
void fields(const Fields& io, Operation& operation);
void fields(const Fields& io, MeasureOptions& measures);
void fields(const Fields& io, Limits& limits);
void fields(const Fields& io, DriveMotor& motor);
void fields(const Fields& io, MotorDuty& duty);
void fields(const Fields& io, PrsLinkage& linkage);
void fields(const Fields& io, Preload& preload);
/// Keys of a mission in `heat`.
void mission_fields(const Fields& io, std::optional<int>& cycles, std::optional<PerPart<double>>& start, bool has_duty);

}  // namespace prs::input
