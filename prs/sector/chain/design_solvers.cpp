#include "prs/sector/chain/design_solvers.h"

#include <tuple>

#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/nut_condensation.h"
#include "prs/sector/chain/sector_solve.h"
#include "simd/dispatch.h"

namespace prs {
namespace {

/// Largest number of designs of one call of a kernel.
constexpr std::size_t kMostAtOnce = 256;

bool are_zero(const std::vector<double>& gaps) {
  return std::ranges::all_of(gaps, [](double gap) { return gap == 0.0; });
}

/// Fills the columns of sectors of one kind; columns of zeros are empty.
void set_columns(BarDesigns& d, std::span<const SectorModel> sectors, std::span<const double> axial_forces,
                 std::span<const std::size_t> order) {
  const std::size_t designs = order.size();
  for_each_number([=](std::vector<double>& column) { column.resize(designs); }, d);
  d.axial_force.resize(designs);
  d.flange_count = 0;
  for (const std::size_t k : order) d.flange_count = std::max(d.flange_count, sectors[k].flanges.size());
  if (d.flange_count > d.flanges.size()) d.flanges.resize(d.flange_count);
  for (std::size_t i = 0; i < d.flange_count; ++i)
    for (auto* values : {&d.flanges[i].from, &d.flanges[i].to, &d.flanges[i].axial_rigidity}) values->resize(designs);
  for (std::size_t at = 0; at < designs; ++at) {
    const SectorModel& s = sectors[order[at]];
    for_each_number([at](std::vector<double>& column, const double& number) { column[at] = number; }, d, s);
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
    if (std::ranges::all_of(order, [&](std::size_t k) { return are_zero(sectors[k].gaps[i]); })) continue;
    for (const std::size_t k : order)
      d.gaps[i].insert(d.gaps[i].end(), sectors[k].gaps[i].begin(), sectors[k].gaps[i].end());
  }
}

/// Properties that sectors side by side must share, as a sortable tuple.
auto kind(const SectorModel& sector) {
  const RefinedBodies& bodies = sector.bodies;
  const RefinedEffects& e = bodies.effects;
  return std::tuple<decltype(bodies.line.thrust), const decltype(bodies.line.contacts)&, const decltype(bodies.same)&,
                    std::array<bool, 6>>(bodies.line.thrust, bodies.line.contacts, bodies.same,
                                         {e.hoop, e.poisson, e.flange, e.radial, e.concentration, bodies.has_ring});
}

}  // namespace

void BarDesignSolver::solve(std::span<const SectorModel> sectors, std::span<const double> axial_forces,
                            std::span<LoadDistribution> results) {
  assert(axial_forces.size() == sectors.size() && results.size() == sectors.size());
  const auto kind = [&](std::size_t k) { return std::pair(sectors[k].contacts(), sectors[k].has_compliance()); };
  const auto place = [&](std::size_t k) { return std::pair(kind(k), k); };
  order_.clear();
  for (std::size_t k = 0; k < sectors.size(); ++k)
    if (!sectors[k].is_refined) order_.push_back(k);
  if (!std::ranges::is_sorted(order_, {}, place)) std::ranges::sort(order_, {}, place);
  for (std::size_t first = 0, end = 0; first < order_.size(); first = end) {
    while (end < order_.size() && end - first < kMostAtOnce && kind(order_[end]) == kind(order_[first])) ++end;
    designs_.contacts = sectors[order_[first]].contacts();
    set_columns(designs_, sectors, axial_forces, std::span(order_).subspan(first, end - first));
    const auto threads = static_cast<std::size_t>(designs_.contacts);
    loads_.resize(designs_.size(), threads, tangent_stiffness);
    double* const memory =
        workspace_.reserve(kStationNumbers<BarStation<double>> * threads * static_cast<std::size_t>(batch_size(set_)));
    simd::run_kernel(set_, SectorKernel{}, set_ == InstructionSet::scalar, designs_, options, loads_, memory);
    for (std::size_t k = first; k < end; ++k) loads_.copy(k - first, options.residual_tolerance, results[order_[k]]);
  }
}

void RefinedDesignSolver::solve(std::span<const SectorModel> sectors, std::span<const double> axial_forces,
                                std::span<LoadDistribution> results) {
  assert(axial_forces.size() == sectors.size() && results.size() == sectors.size());
  order_.clear();
  for (std::size_t k = 0; k < sectors.size(); ++k)
    if (takes(sectors[k])) order_.push_back(k);
  const auto before = [&](std::size_t a, std::size_t b) {
    const auto one = kind(sectors[a]), other = kind(sectors[b]);
    return one != other ? one < other : a < b;
  };
  if (!std::ranges::is_sorted(order_, before)) std::ranges::sort(order_, before);
  for (std::size_t first = 0, end = 0; first < order_.size(); first = end) {
    sectors_.clear();
    forces_.clear();
    for (; end < order_.size() && sectors_.size() < kMostAtOnce; ++end) {
      const SectorModel& s = sectors[order_[end]];
      if (end > first && kind(sectors[order_[first]]) != kind(s)) break;
      sectors_.push_back({&s,
                          &s.bodies.numbers,
                          s.bodies.line.sections.data(),
                          s.bodies.line.outer_radius.data(),
                          s.bodies.bore.root.data(),
                          {s.gaps.screw.data(), s.gaps.nut.data()}});
      forces_.push_back(axial_forces[order_[end]]);
    }
    if (set_ == InstructionSet::scalar) {
      for (std::size_t k = first; k < end; ++k) {
        SectorModel sector = sectors[order_[k]];
        work_out(sector);
        ChainSolver solver(sector);
        solver.options = options;
        solver.solve(axial_forces[order_[k]], results[order_[k]]);
      }
      continue;
    }
    solve_side_by_side(sectors[order_[first]]);
    for (std::size_t k = first; k < end; ++k) loads_.copy(k - first, options.residual_tolerance, results[order_[k]]);
  }
}

void RefinedDesignSolver::solve_side_by_side(const SectorModel& first) {
  const NutShape shape = first.bodies.shape();
  set_segments_of(shape, segment_of_);
  loads_.resize(sectors_.size(), shape.contacts.size(), tangent_stiffness);
  double* const memory = workspace_.reserve(
      (RefinedKernel::kNumbersOfContact * shape.contacts.size() + RefinedKernel::kNumbersOfNode * shape.nodes()) *
      static_cast<std::size_t>(batch_size(set_)));
  simd::run_kernel(set_, RefinedKernel{}, RefinedDesigns{sectors_, forces_, shape, segment_of_}, options, loads_,
                   memory);
}

}  // namespace prs
