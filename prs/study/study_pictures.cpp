#include "prs/study/study_pictures.h"

namespace prs {

// Each stands in a file `*_figures.cpp`; none where the result holds no data.
Figures study_power(const StudyResult& result, const FigureOptions& options);
Figures study_envelope(const StudyResult& result, const FigureOptions& options);
Figures study_maps(const StudyResult& result, const FigureOptions& options);
Figures contributions(const StudyResult& result, const FigureOptions& options);
Figures histograms(const StudyResult& result, const FigureOptions& options);
Figures elasticities(const CaseDerivatives& result, const FigureOptions& options);

Pictures study_pictures(const StudyResult& r) {
  const Study& study = r.study;
  const bool map = r.summary.envelope || suits_map(study);
  const bool sampled = is_sampled(study.plan);
  const auto lines = varies_one_at_a_time(study) ? one_at_a_time_lines
                     : study.plan == Plan::grid  ? grid_lines
                                                 : design_clouds;
  const bool power = varies_one_at_a_time(study) && has_power(r);
  return {
      {"envelope", "`study.envelope` in the case", of_result(r, study_envelope)},
      {"map", "`plan: grid` with two factors of numbers", of_result(r, study_maps), drawn_if(map)},
      {"power", "`plan: one_at_a_time` of slip", of_result(r, study_power)},
      {"contributions", "a plan that draws samples, and a response that varies",
       of_result(r, contributions)},
      {"lines", "designs with an answer", of_result(r, lines),
       drawn_if(sampled || (!map && !power))},
      {"histogram", "several designs whose responses differ", of_result(r, histograms),
       drawn_if(sampled)},
  };
}

Pictures derivatives_pictures(const CaseDerivatives& r) {
  return {{"elasticities", "factors and responses other than 0 in the file",
           of_result(r, elasticities)}};
}

}  // namespace prs
