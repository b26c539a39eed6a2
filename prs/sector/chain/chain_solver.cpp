#include "prs/sector/chain/chain_solver.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>
#include <vector>

#include "fe/chain_laws.h"
#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/condense.h"
#include "prs/sector/chain/dispatch.h"
#include "prs/sector/chain/distribution.h"
#include "prs/sector/chain/sector_kernel.h"
#include "prs/sector/chain/shell_station.h"
#include "prs/sector/chain/sweep.h"
#include "prs/sector/chain/workspace.h"

namespace prs {
namespace {

template <class Station>
std::size_t station_numbers() {
  using OneSweep = Sweep<double, Station, fe::ChainHertz<double>>;
  constexpr std::size_t kArrays = 4;  // nut, ground and two compliances
  return sizeof(typename OneSweep::Record) / sizeof(double) + kArrays +
         OneSweep::kAges * OneSweep::M;
}

/// Numbers that the kernel's workspace holds for a contact and a lane.
std::size_t sector_workspace(ChainSector::Kind kind) {
  using Kind = ChainSector::Kind;
  switch (kind) {
    case Kind::bars:
      return station_numbers<BarStation<double>>();
    case Kind::shell:
      return station_numbers<ShellStation<double, Kind::shell>>();
    case Kind::apart_nut_first:
      return station_numbers<ShellStation<double, Kind::apart_nut_first>>();
    case Kind::apart_screw_first:
      return station_numbers<ShellStation<double, Kind::apart_screw_first>>();
  }
  return 0;
}

}  // namespace

struct ChainSolver::Implementation {
  ChainSector sector;
  InstructionSet set;
  Workspace workspace;
  ThreadLoadBuffer buffer;
  std::vector<std::size_t> order;
  std::vector<double> ascending;

  Implementation(const Sector& s, InstructionSet instructions)
      : sector(condense(s)), set(instructions) {}

  void run(InstructionSet instructions, std::span<const double> forces,
           const fe::NewtonOptions& options, const ThreadLoads& results) {
    const bool apart =
        sector.kind != ChainSector::Kind::bars && sector.kind != ChainSector::Kind::shell;
    if (apart) instructions = InstructionSet::baseline;
    const std::size_t numbers = sector_workspace(sector.kind) *
                                static_cast<std::size_t>(sector.contacts) *
                                static_cast<std::size_t>(batch_size(instructions));
    run_kernel(instructions, SectorKernel{}, sector, forces, options, results,
               workspace.reserve(numbers));
  }

  ThreadLoads sized_buffer(std::size_t solves) {
    buffer.resize(solves, static_cast<std::size_t>(sector.contacts));
    return buffer.view();
  }

  /// Solves all loads in ascending order into the buffer; `order[k]` is the place of the k-th.
  void run_ascending(std::span<const double> forces, const fe::NewtonOptions& options,
                     bool tangent) {
    order.resize(forces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      if (forces[a] < forces[b] || forces[b] < forces[a]) return forces[a] < forces[b];
      // What is no number comes last.
      return std::pair(forces[a] != forces[a], a) < std::pair(forces[b] != forces[b], b);
    });
    ascending.clear();
    for (const std::size_t k : order) ascending.push_back(forces[k]);
    ThreadLoads results = sized_buffer(forces.size());
    if (!tangent) results.tangent_stiffness = {};
    run(set, ascending, options, results);
  }
};

ChainSolver::ChainSolver(const Sector& sector, InstructionSet set)
    : implementation_(std::make_unique<Implementation>(sector, set)) {}
ChainSolver::~ChainSolver() = default;
ChainSolver::ChainSolver(ChainSolver&&) noexcept = default;
ChainSolver& ChainSolver::operator=(ChainSolver&&) noexcept = default;

int ChainSolver::contacts() const { return implementation_->sector.contacts; }

void ChainSolver::solve(double axial_force, LoadDistribution& result) {
  Implementation& s = *implementation_;
  const InstructionSet set = s.set == InstructionSet::best ? InstructionSet::scalar : s.set;
  s.run(set, {&axial_force, 1}, options, s.sized_buffer(1));
  s.buffer.copy(0, s.sector.contacts, options.residual_tolerance, result);
}

LoadDistribution ChainSolver::solve(double axial_force) {
  LoadDistribution result;
  solve(axial_force, result);
  return result;
}

void ChainSolver::solve(std::span<const double> axial_forces, std::span<LoadDistribution> results) {
  assert(results.size() == axial_forces.size());
  Implementation& s = *implementation_;
  s.run_ascending(axial_forces, options, true);
  for (std::size_t k = 0; k < s.order.size(); ++k)
    s.buffer.copy(k, s.sector.contacts, options.residual_tolerance, results[s.order[k]]);
}

void ChainSolver::solve(std::span<const double> axial_forces, const ThreadLoads& results) {
  Implementation& s = *implementation_;
  if (std::is_sorted(axial_forces.begin(), axial_forces.end()))
    return s.run(s.set, axial_forces, options, results);
  s.run_ascending(axial_forces, options, !results.tangent_stiffness.empty());
  for (std::size_t k = 0; k < s.order.size(); ++k)
    s.buffer.copy(k, s.sector.contacts, s.order[k], results);
}

}  // namespace prs
