#pragma once

#include "prs/curves/system_curves.h"
#include "prs/record/analysis.h"

namespace prs {

/// Description of an exported model.
struct ModelText {
  std::string name;         ///< An identifier of C and Modelica, see `model_name`.
  std::string case_file;    ///< Path as given.
  std::string case_sha256;  ///< SHA-256 of the case's text.
};

/// The curves of a case file, and texts about them.
struct SystemModel {
  SystemCurves curves;
  ModelText text;
  DocumentInfo info;
  std::optional<ResponseInput> drive = {};  ///< Input of a model with the drive.
  std::optional<Case> case_with_drive = {};
};

/// Whether the model holds the drive of the case: never, if the case states one, always.
enum class WithDrive { never, stated, needed };

/// Reads the case and computes its curves; their warnings include those on single values. With the drive they are those
/// of `prs response`. Throws InputError if the case is incomplete or wrong.
SystemModel system_model(const input::Source& source, const CurveOptions& options,
                         WithDrive with_drive = WithDrive::never);

/// An identifier made of the name of a case file: `12_preload.yaml` -> `screw_12_preload`.
std::string model_name(const std::string& case_file);

/// Sentences on the ends of the curves and on their accuracy.
std::string curves_text(const SystemCurves& curves);

/// Deflections, forces, stiffnesses and torques of the curves.
nlohmann::ordered_json curves_json(const SystemCurves& curves);

}  // namespace prs
