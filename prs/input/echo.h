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
  std::string value;  ///< Value with its unit, as it could stand in the file: `45 deg`.
  bool is_default = false;
  std::string origin = {};               ///< Origin of a default that a name stands for: `of iso-vg-100`.
  std::string written = {};              ///< As the file has it; empty for a default.
  std::optional<double> number = {};     ///< SI; of a range the end that is farther from 0.
  const Dimension* dimension = nullptr;  ///< Dimension of the number, if it has one.
};

/// Every value of a case in the order of case_fields.cpp; absent ones without default are left out.
/// The case must have passed `check_case`.
/// `root` is the document that the case was read from: what it lacks is a default.
std::vector<EchoEntry> echo(CaseFile file, const Node& root);

/// Warnings on values that the file states and that are possible but odd, as `210 MPa` of a modulus
/// is: each names the key, the value as written, what is usual, and the unit that would fit.
std::vector<Warning> unusual_values(const std::vector<EchoEntry>& fields);

/// Why each assumed value was assumed, by its path. A comment behind a value, or on the lines above
/// its key, marks it:
///
///     flank_angle: 45 deg                 # assumed 45 deg: as on nearly all screws
///     # assumed {roller: 1}: as in makers' catalogues
///     starts: {screw: 5, roller: 1}
///
/// What stands between `assumed` and the colon is the value as it was assumed; a map may name some
/// of the keys, a list the first items. A value that differs from it by now was changed and is none
/// any more, nor is one that `--set` gives. `assumed: REASON` marks whatever stands there.
std::map<std::string, std::string> assumptions(const std::vector<EchoEntry>& entries, const Source& source);

/// The text of a source with its overrides written into it, all else as it stands, comments too: a
/// case with the same values and without overrides. Absent where a value cannot be replaced in
/// place, as that of an anchor which others refer to. Throws InputError where the source is wrong.
std::optional<std::string> written_case(const Source& source);

/// The file of a source with its overrides and defaults in place: a case with the same results.
/// What is absent and has no default stays absent; a history has its place and its SHA-256. Throws
/// InputError.
nlohmann::ordered_json resolved_input(const Source& source);

/// SHA-256 of what is computed, hexadecimal: of the file; with overrides, or a history that it
/// names, of the file, then of each of these and of the SHA-256 of the history, with a NUL before.
/// The files of a fit's curves and of references follow it for the commands that read them.
std::string input_sha256(const Source& source, std::optional<Command> command = {});
/// The same of a source that names these files, by their texts.
std::string input_sha256(const Source& source, const std::vector<std::string>& files);

}  // namespace prs::input
