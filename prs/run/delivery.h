#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "prs/figures/pictures.h"
#include "prs/output/csv_style.h"
#include "prs/output/files.h"
#include "prs/quantities/load_case_stream.h"

namespace prs {

struct VerdictFacts;

/// What a command found, in every form in which it leaves the program. Each form is made when it is
/// asked for.
struct Delivery {
  std::string file;  ///< Name of the document in the output folder: `slip.json`.
  std::function<nlohmann::ordered_json(const DocumentInfo&)> document;
  std::function<std::string()> table;                   ///< On a terminal.
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
  /// Says what it found of the verdict, as long as this lives.
  std::function<void(VerdictFacts&)> facts = {};
};

}  // namespace prs
