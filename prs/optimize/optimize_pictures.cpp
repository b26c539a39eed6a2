#include "prs/optimize/optimize_pictures.h"

namespace prs {

Figures optimization_history(const OptimizationResult& result);
Figures pareto_front(const OptimizationResult& result);

Pictures optimization_pictures(const OptimizationResult& r) {
  return {{"history", "designs", of_result(r, optimization_history)},
          {"front", "several objectives", of_result(r, pareto_front)}};
}

}  // namespace prs
