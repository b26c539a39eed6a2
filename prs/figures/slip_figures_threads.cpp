#include <fmt/format.h>

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

std::vector<Figure> slip_figures(
    const Result& result, const std::vector<std::pair<std::size_t, SlipPictures>>& pictures) {
  std::vector<Figure> all = power_over_load_figures(result);
  if (std::optional<Figure> figure = thread_power_figure(result)) all.push_back(*figure);
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    const auto& [index, shown] = pictures[k];
    for (const auto make : {slip_patch_figure, slip_residue_figure}) {
      Figure& figure = all.emplace_back(make(result.load_cases[index], shown));
      if (pictures.size() > 1) figure.name += fmt::format("_{}", k + 1);
    }
  }
  return all;
}

}  // namespace prs
