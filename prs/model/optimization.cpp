#include "prs/model/optimization.h"

#include <array>

namespace prs {

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
