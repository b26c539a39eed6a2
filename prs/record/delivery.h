#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <typeinfo>

#include "prs/model/criterion.h"
#include "prs/model/warning.h"
#include "prs/record/csv_writer.h"
#include "prs/record/pictures.h"

namespace prs {

/// What every document says of its origin.
struct DocumentInfo {
  std::string version;                      ///< Version of the program.
  std::string schema_version;               ///< Version of the input's schema.
  std::string input_sha256;                 ///< Hash of file, overrides and history, `input::input_sha256`.
  std::vector<std::string> overrides = {};  ///< `path=value` that changed it.
  std::string command = {};                 ///< The command that was run.
  std::string case_file = {};               ///< As it was given.
  /// The case with overrides and defaults in place; asked for once per document.
  std::function<Json()> resolved_input = {};
};

/// How every document begins: its origin and the warnings on the whole input.
Json document_head(const DocumentInfo& info, const std::vector<Warning>& warnings);

/// Text of a document, two spaces deep, with a newline at the end. Malformed UTF-8 becomes U+FFFD.
std::string json_text(const Json& document);

/// Takes the pieces of a text.
using TextSink = std::function<void(std::string_view)>;

/// What `json_text` gives of a document whose list under `key` is empty in `outline` and filled by
/// `item`, one after the other: memory for one of them is enough.
void write_with_list(const Json& outline, std::string_view key,
                     const std::function<std::optional<Json>(std::size_t)>& item, const TextSink& sink);

struct OutputFile {
  std::string name;  ///< Inside the output directory.
  std::string content;
};

/// Rows of a record that stand open, under a heading where one is needed.
struct OpenRows {
  std::string record;  ///< Its place in the document or in a load case: `life.system`.
  std::vector<std::string> rows;
  std::string heading = {};
};

/// Rows of texts under the titles of their columns.
struct PageTable {
  std::string heading;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// How the page shows a result: what a reader asks for first, and what folds. Without open rows all
/// numbers stand open.
struct PageSection {
  std::vector<OpenRows> in_cases = {}, in_document = {};
  std::vector<std::string> folded = {};     ///< Pictures.
  std::vector<std::string> estimates = {};  ///< Keys that are left out: each quantity has one headline.
  std::string note = {};                    ///< Above all.
  std::vector<PageTable> tables = {};       ///< Open, behind the pictures.
};

/// The title of an analysis on the page, and where it stands among the others; none where another
/// section shows it.
struct PagePlace {
  std::string_view title = {};
  int order = 100;
};

/// Warnings on single values; what they bring about has no warning of its own.
void put_first(const std::vector<Warning>& values, std::vector<Warning>& warnings);

std::vector<std::string> as_notes(const std::vector<Warning>& warnings);

/// A number that the page shows beside the verdict, without a limit.
struct Headline {
  std::string title;
  std::string key;  ///< Key of the quantity, with its unit: `power_loss_W`.
  double value = 0.0;
  std::string where = {};  ///< The load case.
};

/// What a command found, in every form in which it leaves the program. Each form is made when it is
/// asked for.
struct Delivery {
  std::string file;  ///< Name of the document in the output folder: `slip.json`.
  std::function<Json(const DocumentInfo&)> document = {};
  std::function<std::string()> table = {};                             ///< On a terminal.
  std::vector<std::string> notes = {};                                 ///< To whom the document is printed.
  std::function<std::vector<Warning>()> warnings = {};                 ///< Those of load cases name them.
  std::function<std::vector<OutputFile>(const CsvStyle&)> files = {};  ///< Beside the document.
  std::function<Pictures()> pictures = {};                             ///< They may refer to what the other forms hold.
  bool keeps_figures = false;                    ///< As data in a file too, for reports that are made later.
  std::vector<std::string> without_figure = {};  ///< Why some are missing, a line each.
  bool converged = true;
  bool within_tolerance = true;                  ///< Whether the result meets what it is held against.
  std::string wrong_input = {};                  ///< Error of the input that is reported besides; empty: none.
  std::function<std::string()> full_table = {};  ///< Table printed with `--all`, if there is more.
  /// The document without the lists that `write` fills; empty: `document`.
  std::function<Json(const DocumentInfo&)> outline = {};
  /// The document as text, piece by piece, from its outline; empty: `json_text`.
  std::function<void(const Json&, const TextSink&)> write = {};
  std::function<std::vector<Headline>()> headlines = {};
  std::function<std::vector<FoundCriterion>(const JudgedCase&)> criteria = {};
  std::function<PageSection()> section = {};  ///< On the page.

  /// The result itself; null where it is of another type.
  template <class R>
  const R* result() const {
    return result_type && *result_type == typeid(R) ? static_cast<const R*>(held.get()) : nullptr;
  }
  std::shared_ptr<const void> held = {};
  const std::type_info* result_type = nullptr;
};

}  // namespace prs
