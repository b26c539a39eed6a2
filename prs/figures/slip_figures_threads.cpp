#include "prs/quantities/slip_quantities.h"
#include "prs/figures/slip_figures.h"
#include "prs/figures/thread_figure.h"

namespace prs {
namespace {

bool has_thread_power(const LoadCaseResult& result) { return has_slip(result) && result.threads; }

const std::vector<double>& power(const LoadCaseResult& result, Interface i) {
  return result.slip->threads[i].power;
}

std::optional<double> with_equal_shares(const LoadCaseResult& result, Interface i) {
  const std::optional<EqualShareSlip>& equal = result.slip->equal_shares;
  return equal ? std::optional(equal->thread_power[i]) : std::nullopt;
}

}  // namespace

std::optional<Figure> thread_power_figure(const Result& result) {
  std::optional<Figure> figure =
      thread_figure({"thread_power", "Power lost at each thread of a roller", "Power (W)", power,
                     1.0, has_thread_power, with_equal_shares, "every thread with equal shares"},
                    result);
  if (figure) fit_y_range(*figure);
  return figure;
}

}  // namespace prs
