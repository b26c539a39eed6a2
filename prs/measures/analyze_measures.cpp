#include "prs/measures/analyze_measures.h"

namespace prs {

MeasuresResult measured(const Conditions& c, Result analysis, Detail detail) {
  MeasuresResult result;
  result.analysis = std::move(analysis);
  const Contacts& contacts = result.analysis.contacts;
  result.measures = measures_of(c, contacts);
  if (detail == Detail::complete)
    for (std::string& note : unusual_measures(c, contacts, result.measures))
      result.analysis.warnings.push_back(std::move(note));
  for (LoadCaseResult& load_case : result.analysis.load_cases) {
    if (!load_case.converged()) {
      result.load_measures.push_back(std::nullopt);
      continue;
    }
    const LoadMeasures& measures = *result.load_measures.emplace_back(
        load_measures_of(c, contacts, result.measures, load_case, detail));
    if (detail == Detail::complete)
      for (std::string& note : unusual_load_measures(c, result.measures, measures, load_case))
        load_case.warnings.push_back(std::move(note));
  }
  return result;
}

MeasuresResult analyze_measures(const Conditions& c, Contacts found, AnalysisOptions options) {
  return measured(c,
                  c.load_cases.empty() ? analyze_contacts(c, std::move(found), options.detail)
                                       : analyze(c, std::move(found), options),
                  options.detail);
}

}  // namespace prs
