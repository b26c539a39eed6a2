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

/// Every path of a document that has a response, of an array `.max` only.
std::vector<std::string> response_paths(const Json& document);

/// Responses recorded for a command where the study lists none.
std::vector<std::string> default_responses(Command command);

/// What a response is read from.
struct Answer {
  const Contacts& contacts;
  const LoadCaseResult* load_case = nullptr;  ///< The response's load case.
  const Measures* measures = nullptr;         ///< If asked for.
  const LoadMeasures* load_measures = nullptr;
  const LifeResult* life = nullptr;  ///< Command `life` only.
  const HeatCycle* cycle = nullptr;  ///< Cases with a duty only.
};

/// A response in the tables of quantities, read from the results without a document. Its value is
/// the one that the document would have.
struct ResultNumber {
  /// Index of the load case that it belongs to; none: it is the mechanism's.
  std::optional<std::size_t> load_case;
  bool needs_complete = false;  ///< Detail::numbers does not have it.
  bool needs_duty = false;      ///< It is read from the state that a duty comes to.
  std::function<std::optional<double>(const Answer&)> value;
};

/// The response at a path, see `response`; none where only the document has it: numbers about the
/// solution, as the iterations that it took.
std::optional<ResultNumber> result_number(std::string_view path);

}  // namespace prs
