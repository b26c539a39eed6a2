#include "prs/model/optimization.h"

namespace prs {

std::string_view name(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::nsga2:
      return "nsga2";
    case Algorithm::nspso:
      return "nspso";
    case Algorithm::moead:
      return "moead";
    case Algorithm::sade:
      return "sade";
    case Algorithm::pso:
      return "pso";
    case Algorithm::cmaes:
      return "cmaes";
  }
  return "";
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
