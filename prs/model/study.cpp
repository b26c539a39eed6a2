#include "prs/model/study.h"

#include <algorithm>

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

}  // namespace prs
