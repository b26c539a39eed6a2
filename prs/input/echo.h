#pragma once

#include "prs/input/document.h"
#include "prs/input/units.h"
#include "prs/json_type.h"
#include "prs/model/command.h"
#include "prs/model/warning.h"

namespace prs::input {

struct CaseFile;

/// One value of the resolved input.
struct EchoEntry {
  std::string path;   ///< `mechanism.flank_angle`
  std::string value;  ///< Value with its unit, in the form of a file: `45 deg`.
  bool is_default = false;
  std::string origin = {};               ///< Origin of a default that follows from a name: `of iso-vg-100`.
  std::string written = {};              ///< Text in the file; empty for a default.
  std::optional<double> number = {};     ///< SI value; the end farther from 0 of a range.
  const Dimension* dimension = nullptr;  ///< Dimension of the number, if it has one.
};

/// Every value of a case in the order of case_fields.cpp, without absent values that have no default. The case must
/// have passed `check_case`. `root` is the document that the case was read from: values that it lacks are defaults.
std::vector<EchoEntry> echo(CaseFile file, const Node& root);

/// Warnings on values of the file that are possible but unusual, such as a modulus of `210 MPa`: each names the key,
/// the value as written, usual values, and the unit that would fit.
std::vector<Warning> unusual_values(const std::vector<EchoEntry>& fields);

/// Reason why each assumed value was assumed, by its path. A comment behind a value, or on the lines above its key,
/// marks it:
///
///     flank_angle: 45 deg                 # assumed 45 deg: as on nearly all screws
///     # assumed {roller: 1}: as in makers' catalogues
///     starts: {screw: 5, roller: 1}
///
/// The text between `assumed` and the colon is the value when it was assumed; a map may name some of the keys, a list
/// the first items. A value that differs from it was changed since then and is no longer assumed, nor is a value from
/// `--set`. `assumed: REASON` marks any value.
std::map<std::string, std::string> assumptions(const std::vector<EchoEntry>& entries, const Source& source);

/// The text of a source with its overrides written into it and all else unchanged, comments too: a case with the same
/// values and without overrides. Absent if a value cannot be replaced in place, such as an anchor that others refer to.
/// Throws InputError if the source is wrong.
std::optional<std::string> written_case(const Source& source);

/// The file of a source with its overrides and defaults in place: a case with the same results. Absent values without
/// default stay absent; a history has its absolute path and its SHA-256. Throws InputError.
nlohmann::ordered_json resolved_input(const Source& source);

/// SHA-256 of all input that is computed from, hexadecimal: of the file; with overrides or a history, of the file, then
/// each override and the SHA-256 of the history, with a NUL before each. The files of a fit's curves and of references
/// follow for the commands that read them.
std::string input_sha256(const Source& source, std::optional<Command> command = {});
/// SHA-256 of a source that names these files, by their texts.
std::string input_sha256(const Source& source, const std::vector<std::string>& files);

}  // namespace prs::input
