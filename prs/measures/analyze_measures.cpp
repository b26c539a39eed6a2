#include "prs/measures/analyze_measures.h"

#include <map>

#include "prs/life/analyze_life.h"

namespace prs {
namespace {

/// Static ratings of all load cases, each solved once: forces of one sense at one place have one.
class StaticRatings {
 public:
  StaticRatings(const Conditions& c, const Contacts& contacts) : c_(c), contacts_(contacts) {}

  void rate(const LoadCase& load, LoadMeasures& m) {
    if (c_.model.mechanism == ModelOptions::Mechanism::full || !load.direction || !load.position ||
        load.share != LoadCase::Share::solved || !(load.axial_force > 0.0))
      return;
    const auto [known, is_new] = ratings_.try_emplace({*load.direction, *load.position});
    if (is_new)
      known->second =
          solved_static_rating(c_, contacts_, *load.direction, *load.position, load.axial_force);
    if (!known->second) return;
    m.solved_static_safety = known->second->force / load.axial_force;
    m.solved_static_safety_limit = known->second->limit;
  }

 private:
  const Conditions& c_;
  const Contacts& contacts_;
  std::map<std::pair<Direction, double>, std::optional<StaticRating>> ratings_;
};

}  // namespace

MeasuresResult measured(const Conditions& c, Result analysis, Detail detail) {
  MeasuresResult result;
  result.analysis = std::move(analysis);
  const Contacts& contacts = result.analysis.contacts;
  result.measures = measures_of(c, contacts);
  if (detail == Detail::complete)
    for (Warning& note : unusual_measures(c, contacts, result.measures))
      result.analysis.warnings.push_back(std::move(note));
  StaticRatings ratings(c, contacts);
  for (LoadCaseResult& load_case : result.analysis.load_cases) {
    if (!load_case.converged()) {
      result.load_measures.push_back(std::nullopt);
      continue;
    }
    LoadMeasures& measures = *result.load_measures.emplace_back(
        load_measures_of(c, contacts, result.measures, load_case, detail));
    if (detail != Detail::complete) continue;
    ratings.rate(load_case.load_case, measures);
    for (Warning& note : unusual_load_measures(c, result.measures, measures, load_case))
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
