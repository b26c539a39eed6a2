#pragma once

#include "prs/input/reader.h"
#include "prs/record/delivery.h"
#include "prs/record/record_table.h"

namespace prs {

/// Path of a record in documents: `life`, `load_cases[]` for each item of a list, or `load_cases[].slip` for a key that
/// an analysis adds to the record of another.
struct Place {
  std::string_view path;
  const RecordInfo& (*record)() = nullptr;
  bool required = true;           ///< Whether every document of the analysis has it.
  std::string_view meaning = {};  ///< Meaning of an added key.
};

/// Read and write access to the warnings of a result on the whole case.
template <class R>
struct OwnWarnings {
  template <class Get>
  constexpr OwnWarnings(Get get) : read(get), write(get) {}

  const std::vector<Warning>& operator()(const R& result) const { return read(result); }
  std::vector<Warning>& operator()(R& result) const { return write(result); }

  const std::vector<Warning>& (*read)(const R&);
  std::vector<Warning>& (*write)(R&);
};

/// An analysis of a case: all that the program needs to know about it, read by commands, documents, schemas, files,
/// pages, studies and Python.
template <class R>
struct Analysis {
  Command command;
  std::string_view help;
  std::string_view file;  ///< Name of the document.
  /// Computes the result, with the warnings of the command. Throws InputError.
  R (*run)(const input::Source&, const input::CaseInput&) = nullptr;
  std::span<const Place> places;
  /// Writes the result into its document after the head, at the places; lists of load cases empty if `load_case` gives
  /// their items.
  void (*put)(Json&, const R&) = nullptr;
  std::optional<Json> (*load_case)(const R&, std::size_t) = nullptr;
  std::string (*table)(const R&) = nullptr;
  std::string (*full_table)(const R&) = nullptr;  ///< Table printed with `--all`, if there is more.
  /// Lines for readers of the printed document; without the function the warnings.
  std::vector<std::string> (*notes)(const R&) = nullptr;
  std::vector<OutputFile> (*files)(const R&, const CsvStyle&) = nullptr;
  Pictures (*pictures)(const R&, const Case&) = nullptr;
  std::vector<std::string> (*without_figure)(const R&) = nullptr;
  bool (*converged)(const R&) = nullptr;
  bool (*within_tolerance)(const R&) = nullptr;    ///< Whether the result meets its tolerance.
  std::string (*wrong_input)(const R&) = nullptr;  ///< Error of the input that the result only reports; empty: none.
  std::vector<Headline> (*headlines)(const R&) = nullptr;
  std::vector<FoundCriterion> (*criteria)(const R&, const JudgedCase&) = nullptr;  ///< See prs/model/criterion.h.
  OwnWarnings<R> warnings = [](auto& result) -> decltype(auto) { return (result.warnings); };
  /// Warnings of load cases included; without the function as `warnings`.
  std::vector<Warning> (*all_warnings)(const R&) = nullptr;
  PagePlace place = {};  ///< Place on the page.
  PageSection (*section)(const R&) = nullptr;
  std::span<const std::string_view> responses = {};  ///< Responses of a study that names none.
  bool takes_load_cases_apart = false;               ///< Whether each load case has a separate answer.
};

/// Document of a result: its origin, then the analysis's own content.
template <class R>
Json document_of(const Analysis<R>& analysis, const R& result, const DocumentInfo& info, bool is_whole = true) {
  Json document = document_head(info, analysis.warnings(result));
  analysis.put(document, result);
  if (analysis.load_case && is_whole)
    for (std::size_t k = 0; auto item = analysis.load_case(result, k); ++k)
      document["load_cases"].push_back(*std::move(item));
  return document;
}

/// An analysis of any result; one without `run` is a search, which continues interrupted runs.
struct AnyAnalysis {
  Command command;
  std::string_view help;
  /// Runs the analysis on a case that was read from the source for it. Throws InputError, also for errors of the case
  /// found during the analysis.
  std::function<Delivery(const input::Source&, const input::CaseInput&)> run = {};
  std::span<const Place> places = {};
  PagePlace place = {};
  std::span<const std::string_view> responses = {};
  bool takes_load_cases_apart = false;
  std::string_view result_class = {};  ///< Class in Python; empty: that of the command's name.
  bool is_built = true;                ///< false in a program that only lists the command (PRS_FULL).
  bool is_judged = false;              ///< Whether it has criteria.
};

/// A kind of file other than a case, and the analysis that reads it.
struct OtherFile {
  Command command;
  std::string_view help;
  std::string_view name;  ///< Name for `prs schema`: `requirement`.
  std::string_view key;   ///< Key that only this kind of file has: `motion`.
  /// Computes the command's output without its own options. Throws InputError, as the others.
  Delivery (*run)(const input::Source&) = nullptr;
  Delivery (*check)(const input::Source&) = nullptr;  ///< Output of `prs check` for the file.
  Json (*schema)() = nullptr;
  Json (*resolved_input)(const input::Source&) = nullptr;
  std::vector<std::string> (*files)(const input::Source&) = nullptr;  ///< Texts of the files that it names.
  const RecordInfo& (*record)() = nullptr;                            ///< Document of the command, after its head.
  std::string_view result_class = {};                                 ///< Class in Python.
};

/// All forms of a result; the analysis must outlive them. Errors of the case that `run` finds are reported at their
/// places.
template <class R, class Run>
Delivery delivered(const input::Source& source, const input::CaseInput& in, const Analysis<R>& analysis,
                   const Run& run) {
  R computed = input::compute_from(source, [&] { return run(source, in); });
  put_first(in.warnings, analysis.warnings(computed));
  Delivery d{std::string(analysis.file)};
  const auto result = std::make_shared<const R>(std::move(computed));
  d.held = result;
  d.result_type = &typeid(R);
  d.document = [&analysis, result](const DocumentInfo& info) { return document_of(analysis, *result, info); };
  d.table = [&analysis, result] { return analysis.table(*result); };
  d.warnings = [&analysis, result] {
    return analysis.all_warnings ? analysis.all_warnings(*result) : analysis.warnings(*result);
  };
  d.notes = analysis.notes ? analysis.notes(*result) : as_notes(d.warnings());
  if (analysis.full_table) d.full_table = [&analysis, result] { return analysis.full_table(*result); };
  if (analysis.files) d.files = [&analysis, result](const CsvStyle& style) { return analysis.files(*result, style); };
  if (analysis.pictures)
    d.pictures = [&analysis, result, c = std::make_shared<const Case>(in.values)] {
      return analysis.pictures(*result, *c);
    };
  if (analysis.without_figure) d.without_figure = analysis.without_figure(*result);
  if (analysis.converged) d.converged = analysis.converged(*result);
  if (analysis.within_tolerance) d.within_tolerance = analysis.within_tolerance(*result);
  if (analysis.wrong_input) d.wrong_input = analysis.wrong_input(*result);
  if (analysis.section) d.section = [&analysis, result] { return analysis.section(*result); };
  if (analysis.headlines) d.headlines = [&analysis, result] { return analysis.headlines(*result); };
  if (analysis.criteria)
    d.criteria = [&analysis, result](const JudgedCase& of) { return analysis.criteria(*result, of); };
  if (!analysis.load_case) return d;
  d.outline = [&analysis, result](const DocumentInfo& info) { return document_of(analysis, *result, info, false); };
  d.write = [&analysis, result](const Json& outline, const TextSink& sink) {
    write_with_list(
        outline, "load_cases", [&](std::size_t k) { return analysis.load_case(*result, k); }, sink);
  };
  return d;
}

template <class R>
AnyAnalysis any(const Analysis<R>& analysis) {
  return {analysis.command,
          analysis.help,
          [&analysis](const input::Source& source, const input::CaseInput& in) {
            return delivered(source, in, analysis, analysis.run);
          },
          analysis.places,
          analysis.place,
          analysis.responses,
          analysis.takes_load_cases_apart,
          {},
          true,
          analysis.criteria != nullptr};
}

}  // namespace prs
