#include "prs/sector/chain/bar_designs.h"

#include <algorithm>
#include <cassert>
#include <tuple>

#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/sector_kernel.h"
#include "prs/sector/chain/sector_solve.h"
#include "simd/dispatch.h"

namespace prs {
namespace {

/// Columns that are filled before a call of the kernel.
constexpr std::size_t kChunk = 256;

void clear(BarDesigns& d) {
  for_each_number([](std::vector<double>& column) { column.clear(); }, d);
  for (BarDesigns::Flange& f : d.flanges)
    for (auto* values : {&f.from, &f.to, &f.axial_rigidity}) values->clear();
  for (auto* values : {&d.axial_force, &d.gaps.screw, &d.gaps.nut}) values->clear();
  d.flange_count = 0;
}

void add(BarDesigns& d, const SectorModel& s, double force) {
  for_each_number(
      [](std::vector<double>& column, const double& number) { column.push_back(number); }, d, s);
  d.axial_force.push_back(force);
  d.flange_count = std::max(d.flange_count, s.flanges.size());
  if (d.flange_count > d.flanges.size()) d.flanges.resize(d.flange_count);
  for (std::size_t i = 0; i < d.flange_count; ++i) {
    BarDesigns::Flange& column = d.flanges[i];
    const SectorModel::Flange flange = i < s.flanges.size() ? s.flanges[i] : SectorModel::Flange{};
    for (auto* values : {&column.from, &column.to, &column.axial_rigidity})
      values->resize(d.size());
    column.from.back() = flange.from;
    column.to.back() = flange.to;
    column.axial_rigidity.back() = flange.axial_rigidity;
  }
  for (const Interface i : kInterfaces)
    d.gaps[i].insert(d.gaps[i].end(), s.gaps[i].begin(), s.gaps[i].end());
}

/// Empties the columns of zeros.
void leave_out_zeros(BarDesigns& d, bool with_compliance) {
  for (const Interface i : kInterfaces) {
    if (!with_compliance) d.compliance[i].clear();
    if (std::ranges::all_of(d.gaps[i], [](double gap) { return gap == 0.0; })) d.gaps[i].clear();
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
    const auto [contacts, with_compliance] = kind(order_[first]);
    clear(designs_);
    designs_.contacts = contacts;
    for (; end < order_.size() && designs_.size() < kChunk; ++end) {
      if (kind(order_[end]) != kind(order_[first])) break;
      add(designs_, sectors[order_[end]], axial_forces[order_[end]]);
    }
    leave_out_zeros(designs_, with_compliance);
    const auto threads = static_cast<std::size_t>(contacts);
    loads_.resize(designs_.size(), threads);
    double* const memory = workspace_.reserve(kStationNumbers<BarStation<double>> * threads *
                                              static_cast<std::size_t>(batch_size(set_)));
    simd::run_kernel(set_, SectorKernel{}, set_ == InstructionSet::scalar, designs_, options,
                     loads_, memory);
    for (std::size_t k = first; k < end; ++k)
      loads_.copy(k - first, options.residual_tolerance, results[order_[k]]);
  }
}

}  // namespace prs
