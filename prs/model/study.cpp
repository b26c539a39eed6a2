#include "prs/model/study.h"

#include <algorithm>

#include "prs/model/optimization.h"

namespace prs {

bool Factor::is_numeric() const {
  return std::ranges::all_of(levels, [](const Level& level) { return level.number.has_value(); });
}

bool is_sampled(Plan plan) {
  return plan == Plan::latin_hypercube || plan == Plan::sobol || plan == Plan::monte_carlo ||
         plan == Plan::sobol_indices;
}

std::vector<DrawnInput> drawn_inputs(const Study& study) {
  std::vector<DrawnInput> inputs;
  for (std::size_t i = 0; i < study.factors.size(); ++i) {
    inputs.push_back({i, &study.factors[i]});
    for (const Factor& companion : study.factors[i].companions) inputs.push_back({i, &companion});
  }
  return inputs;
}

std::string_view name(Algorithm algorithm) {
  constexpr std::array kNames{"nsga2", "nspso", "moead", "sade", "pso", "cmaes"};
  return kNames.at(static_cast<std::size_t>(algorithm));
}

bool takes_several_objectives(Algorithm algorithm) {
  return algorithm == Algorithm::nsga2 || algorithm == Algorithm::nspso ||
         algorithm == Algorithm::moead;
}

std::size_t design_count(const Optimization& optimization) {
  const std::size_t searches = optimization.check ? 2 : 1;
  return 1 + searches * optimization.population * optimization.generations;
}

}  // namespace prs
