#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <typeinfo>
#include <vector>

#include "prs/model/warning.h"
#include "prs/record/csv_style.h"
#include "prs/record/document.h"
#include "prs/record/output_file.h"
#include "prs/record/page_section.h"
#include "prs/record/pictures.h"

namespace prs {

/// A number that the page shows beside the verdict, without a limit.
struct Headline {
  std::string title;
  std::string key;  ///< Of the quantity, with its unit: `power_loss_W`.
  double value = 0.0;
  std::string where = {};  ///< The load case.
};

/// What a command found, in every form in which it leaves the program. Each form is made when it is
/// asked for.
struct Delivery {
  std::string file;  ///< Name of the document in the output folder: `slip.json`.
  std::function<nlohmann::ordered_json(const DocumentInfo&)> document = {};
  std::function<std::string()> table = {};              ///< On a terminal.
  std::vector<std::string> notes = {};                  ///< To whom the document is printed.
  std::function<std::vector<Warning>()> warnings = {};  ///< Those of load cases name them.
  std::function<std::vector<OutputFile>(const CsvStyle&)> files = {};  ///< Beside the document.
  std::function<Pictures()> pictures = {};  ///< They may refer to what the other forms hold.
  bool keeps_figures = false;  ///< As data in a file too, for reports that are made later.
  std::vector<std::string> without_figure = {};  ///< Why some are missing, a line each.
  bool converged = true;
  std::function<std::string()> full_table = {};  ///< With `--all`, where there is more.
  /// The document without the lists that `write` fills; empty: `document`.
  std::function<nlohmann::ordered_json(const DocumentInfo&)> outline = {};
  /// The document as text, piece by piece, from its outline; empty: `json_text`.
  std::function<void(const nlohmann::ordered_json&, const TextSink&)> write = {};
  std::function<std::vector<Headline>()> headlines = {};
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
