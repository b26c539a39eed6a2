#include "prs/reference/referenced_analyses.h"

#include "modules/response/response_analysis.h"
#include "prs/loads/load_analysis.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/preload_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"

namespace prs {

std::span<const AnyAnalysis> referenced_analyses() {
  static const AnyAnalysis all[] = {any(solve_analysis()),   any(slip_analysis()), any(contact_analysis()),
                                    any(preload_analysis()), any(life_analysis()), any(measures_analysis()),
                                    any(response_analysis())};
  return all;
}

}  // namespace prs
