#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <typeinfo>

#include "prs/model/criterion.h"
#include "prs/model/warning.h"
#include "prs/record/csv_writer.h"
#include "prs/record/pictures.h"

namespace prs {

/// Origin, as every document states it.
struct DocumentInfo {
  std::string version;                      ///< Version of the program.
  std::string schema_version;               ///< Version of the input's schema.
  std::string input_sha256;                 ///< Hash of file, overrides and history, `input::input_sha256`.
  std::vector<std::string> overrides = {};  ///< Overrides, `path=value` each.
  std::string command = {};                 ///< Command that was run.
  std::string case_file = {};               ///< Path of the case as given.
  /// The case with overrides and defaults in place; called once per document.
  std::function<Json()> resolved_input = {};
};

/// Beginning of every document: its origin and the warnings on the whole input.
Json document_head(const DocumentInfo& info, const std::vector<Warning>& warnings);

/// Text of a document, two spaces deep, with a newline at the end. Malformed UTF-8 becomes U+FFFD.
std::string json_text(const Json& document);

/// Receives the pieces of a text.
using TextSink = std::function<void(std::string_view)>;

/// Writes the text that `json_text` gives for a document whose list under `key` is empty in `outline` and filled by
/// `item`, one after the other, so that only one item is in memory.
void write_with_list(const Json& outline, std::string_view key,
                     const std::function<std::optional<Json>(std::size_t)>& item, const TextSink& sink);

struct OutputFile {
  std::string name;  ///< Path inside the output directory.
  std::string content;
  std::filesystem::path copy_of = {};  ///< The file that was copied, which is not replaced by its copy.
};

/// Rows of a record that are shown unfolded, with a heading if needed.
struct OpenRows {
  std::string record;  ///< Path of the record in the document or in a load case: `life.system`.
  std::vector<std::string> rows;
  std::string heading = {};
};

/// Rows of texts under the titles of their columns.
struct PageTable {
  std::string heading;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// Layout of a result on the page: rows that are shown first, and parts that are folded. Without open rows all numbers
/// are shown.
struct PageSection {
  std::vector<OpenRows> in_cases = {}, in_document = {};
  std::vector<std::string> folded = {};     ///< Pictures that are folded.
  std::vector<std::string> estimates = {};  ///< Keys to omit: each quantity has one headline.
  std::string note = {};                    ///< Text at the top.
  std::vector<PageTable> tables = {};       ///< Tables after the pictures, unfolded.
};

/// Title of an analysis on the page, and its order among the others; no title if another section shows it.
struct PagePlace {
  std::string_view title = {};
  int order = 100;
};

/// Puts warnings on single values first; effects of unusual values are not reported twice.
void put_first(const std::vector<Warning>& values, std::vector<Warning>& warnings);

std::vector<std::string> as_notes(const std::vector<Warning>& warnings);

/// A number that the page shows beside the verdict, without a limit.
struct Headline {
  std::string title;
  std::string key;  ///< Key of the quantity, with its unit: `power_loss_W`.
  double value = 0.0;
  std::string where = {};  ///< Name of the load case.
};

/// Result of a command, in every form of output. Each form is computed on demand.
struct Delivery {
  std::string file;  ///< Name of the document in the output folder: `slip.json`.
  std::function<Json(const DocumentInfo&)> document = {};
  std::function<std::string()> table = {};              ///< Text for a terminal.
  std::vector<std::string> notes = {};                  ///< Lines for readers of the printed document.
  std::function<std::vector<Warning>()> warnings = {};  ///< Warnings; those of load cases name their load case.
  std::function<std::vector<OutputFile>(const CsvStyle&)> files = {};  ///< Files besides the document.
  std::function<Pictures()> pictures = {};  ///< Pictures, which may refer to data of the other forms.
  bool keeps_figures = false;  ///< Whether figures are also saved as data, for reports that are made later.
  std::vector<std::string> without_figure = {};  ///< Reasons why figures are missing, one per line.
  bool converged = true;
  bool within_tolerance = true;                  ///< Whether the result meets its tolerance.
  std::string wrong_input = {};                  ///< Error of the input that is reported besides; empty: none.
  std::function<std::string()> full_table = {};  ///< Table printed with `--all`, if there is more.
  /// The document without the lists that `write` fills; empty: use `document`.
  std::function<Json(const DocumentInfo&)> outline = {};
  /// Writes the document as text, piece by piece, from its outline; empty: use `json_text`.
  std::function<void(const Json&, const TextSink&)> write = {};
  std::function<std::vector<Headline>()> headlines = {};
  std::function<std::vector<FoundCriterion>(const JudgedCase&)> criteria = {};
  std::function<PageSection()> section = {};  ///< Layout on the page.

  /// The result itself; null if it is of another type.
  template <class R>
  const R* result() const {
    return result_type && *result_type == typeid(R) ? static_cast<const R*>(held.get()) : nullptr;
  }
  std::shared_ptr<const void> held = {};
  const std::type_info* result_type = nullptr;
};

}  // namespace prs
