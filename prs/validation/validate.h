#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "prs/loads/load_json.h"
#include "prs/loads/result.h"
#include "prs/model/case.h"
#include "prs/output/files.h"
#include "prs/record/figure.h"
#include "prs/validation/reference.h"
#include "prs/validation/statement.h"
#include "prs/validation/table.h"

namespace prs {

enum class Outcome {
  reproduces,
  differs,     ///< Listed as different with a reason; a corrected number, where given, is met.
  unexpected,  ///< Not reproduced and not listed, or listed and reproduced all the same.
  missing,     ///< The result does not hold the quantity.
};

const char* name(Outcome outcome);

/// A printed number against the computed one.
struct Comparison {
  std::string case_name;  ///< Case file without its ending; or name of the formulas.
  PrintedValue reference;
  std::optional<double> computed;  ///< Absent where the result does not hold the quantity.

  Outcome outcome() const;
  bool unexpected() const {
    return outcome() == Outcome::unexpected || outcome() == Outcome::missing;
  }
};

/// What the code of a source finds on its case and in the data next to it.
struct Supplement {
  std::vector<ComparedStatement> statements = {};
  std::vector<ValidationTable> tables = {};
  std::vector<Figure> figures = {};
  std::vector<OutputFile> files = {};
};

/// What the run says of one folder below `validation/`.
struct SourceReport : Supplement {
  std::string name;    ///< Name of the folder.
  std::string source;  ///< Citation.
  std::vector<Comparison> comparisons;
};

/// What the code of one folder adds to its `reference.yaml`.
struct SourceExtension {
  std::string folder;
  /// What the source prints of a result and the JSON document does not hold, by key; stands below
  /// `derived` there.
  std::function<nlohmann::ordered_json(const Result&)> derived = {};
  /// What the source's formulas give without a case, by key.
  std::function<nlohmann::ordered_json()> formulas = {};
  std::function<std::vector<ValidationTable>()> tables = {};
  /// On the case `subject` and the source's folder.
  std::function<Supplement(const Case&, const std::filesystem::path&)> supplement = {};
  /// File of that case; empty for the first one of the reference.
  std::string subject = {};
};

/// Is told which source comes next, and how many of all are done.
using ValidationProgress =
    std::function<void(const std::string& source, std::size_t done, std::size_t all)>;

/// Runs every folder of `directory` that has a `reference.yaml`, or `directory` itself where it has
/// one. Throws input::InputError.
std::vector<SourceReport> validate(const std::filesystem::path& directory,
                                   const std::vector<SourceExtension>& extensions,
                                   const ValidationProgress& progress = {});

/// The reports as a text, digit by digit.
std::string validation_text(const std::vector<SourceReport>& reports);

nlohmann::ordered_json validation_json(const std::vector<SourceReport>& reports,
                                       const DocumentInfo& info);

}  // namespace prs
