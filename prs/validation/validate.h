#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "prs/case.h"
#include "prs/output/json.h"
#include "prs/validation/reference.h"
#include "prs/validation/statement.h"

namespace prs {

/// A printed number against the computed one.
struct Comparison {
  PrintedValue reference;
  std::optional<double> computed;  ///< Absent where the result does not hold the quantity.

  bool reproduces() const;
  /// Neither reproduced nor listed as different with a reason, or listed and reproduced all the
  /// same.
  bool unexpected() const { return reproduces() != reference.differs.empty(); }
};

struct JudgedStatement {
  std::string section;
  std::string text;
  Verdict verdict;
};

/// What the run says of one folder below `validation/`.
struct SourceReport {
  std::string name;    ///< Of the folder.
  std::string source;  ///< Citation.
  std::vector<Comparison> comparisons;
  std::vector<JudgedStatement> statements;
};

/// Judges the statements that a source makes in words about the screw of its case.
using StatementJudge = std::function<std::vector<JudgedStatement>(const Case&)>;

/// Statements by folder name.
using StatementJudges = std::vector<std::pair<std::string, StatementJudge>>;

/// Runs every folder of `directory` that has a `reference.yaml`, or `directory` itself where it has
/// one. Throws input::InputError.
std::vector<SourceReport> validate(const std::filesystem::path& directory,
                                   const StatementJudges& judges);

/// The reports as a text, digit by digit.
std::string validation_text(const std::vector<SourceReport>& reports);

nlohmann::ordered_json validation_json(const std::vector<SourceReport>& reports,
                                       const DocumentInfo& info);

}  // namespace prs
