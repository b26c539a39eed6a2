#include "prs/sector/chain/bar_designs.h"

#include <cassert>

#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/sector_kernel.h"
#include "prs/sector/chain/sector_solve.h"
#include "simd/dispatch.h"

namespace prs {
namespace {

/// Columns that are filled before a call of the kernel.
constexpr std::size_t kChunk = 256;

bool is_without(const std::vector<double>& gaps) {
  return std::ranges::all_of(gaps, [](double gap) { return gap == 0.0; });
}

/// Columns of the sectors of a kind; those of zeros are empty.
void set_columns(BarDesigns& d, std::span<const SectorModel> sectors,
                 std::span<const double> axial_forces, std::span<const std::size_t> order) {
  const std::size_t designs = order.size();
  for_each_number([=](std::vector<double>& column) { column.resize(designs); }, d);
  d.axial_force.resize(designs);
  d.flange_count = 0;
  for (const std::size_t k : order)
    d.flange_count = std::max(d.flange_count, sectors[k].flanges.size());
  if (d.flange_count > d.flanges.size()) d.flanges.resize(d.flange_count);
  for (std::size_t i = 0; i < d.flange_count; ++i)
    for (auto* values : {&d.flanges[i].from, &d.flanges[i].to, &d.flanges[i].axial_rigidity})
      values->resize(designs);
  for (std::size_t at = 0; at < designs; ++at) {
    const SectorModel& s = sectors[order[at]];
    for_each_number(
        [at](std::vector<double>& column, const double& number) { column[at] = number; }, d, s);
    d.axial_force[at] = axial_forces[order[at]];
    for (std::size_t i = 0; i < d.flange_count; ++i) {
      const SectorModel::Flange f = i < s.flanges.size() ? s.flanges[i] : SectorModel::Flange{};
      d.flanges[i].from[at] = f.from;
      d.flanges[i].to[at] = f.to;
      d.flanges[i].axial_rigidity[at] = f.axial_rigidity;
    }
  }
  const bool with_compliance = sectors[order.front()].has_compliance();
  for (const Interface i : kInterfaces) {
    if (!with_compliance) d.compliance[i].clear();
    d.gaps[i].clear();
    if (std::ranges::all_of(order, [&](std::size_t k) { return is_without(sectors[k].gaps[i]); }))
      continue;
    for (const std::size_t k : order)
      d.gaps[i].insert(d.gaps[i].end(), sectors[k].gaps[i].begin(), sectors[k].gaps[i].end());
  }
}

}  // namespace

void BarDesignSolver::solve(std::span<const SectorModel> sectors,
                            std::span<const double> axial_forces,
                            std::span<LoadDistribution> results) {
  assert(axial_forces.size() == sectors.size() && results.size() == sectors.size());
  const auto kind = [&](std::size_t k) {
    return std::pair(sectors[k].contacts(), sectors[k].has_compliance());
  };
  const auto place = [&](std::size_t k) { return std::pair(kind(k), k); };
  order_.clear();
  for (std::size_t k = 0; k < sectors.size(); ++k)
    if (!sectors[k].is_refined) order_.push_back(k);
  if (!std::ranges::is_sorted(order_, {}, place)) std::ranges::sort(order_, {}, place);
  for (std::size_t first = 0, end = 0; first < order_.size(); first = end) {
    while (end < order_.size() && end - first < kChunk && kind(order_[end]) == kind(order_[first]))
      ++end;
    designs_.contacts = sectors[order_[first]].contacts();
    set_columns(designs_, sectors, axial_forces, std::span(order_).subspan(first, end - first));
    const auto threads = static_cast<std::size_t>(designs_.contacts);
    loads_.resize(designs_.size(), threads, tangent_stiffness);
    double* const memory = workspace_.reserve(kStationNumbers<BarStation<double>> * threads *
                                              static_cast<std::size_t>(batch_size(set_)));
    simd::run_kernel(set_, SectorKernel{}, set_ == InstructionSet::scalar, designs_, options,
                     loads_, memory);
    for (std::size_t k = first; k < end; ++k)
      loads_.copy(k - first, options.residual_tolerance, results[order_[k]]);
  }
}

}  // namespace prs
