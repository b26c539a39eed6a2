#pragma once

#include "prs/json_type.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/load_case_result.h"
#include "prs/measures/measures.h"
#include "prs/model/command.h"

namespace prs {

/// The number at a path of the first load case of a result document or, where that has none, of the
/// document: `slip.efficiency`, `screw.peak_pressure_MPa.max`, `contact.nut.backlash_mm`,
/// `load_cases[1].axial_displacement_um`. Arrays take `[k]` from 0, `.max`, `.min` and `.mean`.
std::optional<double> response(const Json& document, std::string_view path);

/// Number of entries of the array of numbers at a path; 0 where there is none.
std::size_t entries(const Json& document, std::string_view path);

/// Every path of a document that has a response, for an array `.max` only.
std::vector<std::string> response_paths(const Json& document);

/// Responses recorded for a command if the study lists none.
std::vector<std::string> default_responses(Command command);

/// Results from which a response is read.
struct Answer {
  const Contacts& contacts;
  const LoadCaseResult* load_case = nullptr;  ///< The response's load case.
  const Measures* measures = nullptr;         ///< Present on request.
  const LoadMeasures* load_measures = nullptr;
  const LifeResult* life = nullptr;  ///< Command `life` only.
  const HeatCycle* cycle = nullptr;  ///< Cases with a duty only.
};

/// A response in the tables of quantities, read from the results without a document. Its value is
/// the one that the document would have.
struct ResultNumber {
  /// Index of its load case; none: it belongs to the mechanism.
  std::optional<std::size_t> load_case;
  bool needs_complete = false;  ///< Whether Detail::numbers lacks it.
  bool needs_duty = false;      ///< Whether it is read from the periodic state of a duty.
  std::function<std::optional<double>(const Answer&)> value;
};

/// The response at a path, see `response`; none if only the document has it: numbers about the solution, such as its
/// iterations.
std::optional<ResultNumber> result_number(std::string_view path);

}  // namespace prs
