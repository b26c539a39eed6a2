#include "prs/sector/chain/chain_solver.h"

#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/condense.h"
#include "prs/sector/chain/instruction_set.h"
#include "prs/sector/chain/sector_kernel.h"
#include "prs/sector/chain/sector_solve.h"
#include "prs/sector/chain/shell_station.h"
#include "simd/dispatch.h"

namespace prs {
namespace {

/// Numbers that the kernel's workspace holds for a contact.
std::size_t station_numbers(ChainSector::Kind kind) {
  using enum ChainSector::Kind;
  switch (kind) {
    case bars:
      return kStationNumbers<BarStation<double>>;
    case shell:
      return kStationNumbers<ShellStation<double, shell>>;
    case apart_nut_first:
    case apart_screw_first:
      return kStationNumbers<ShellStation<double, apart_nut_first>>;
  }
  return 0;
}

/// Stations with two roller nodes a tooth are compiled for the baseline alone.
InstructionSet instructions_for(ChainSector::Kind kind) {
  using enum ChainSector::Kind;
  return kind == bars || kind == shell ? InstructionSet::scalar : InstructionSet::baseline;
}

}  // namespace

ChainSolver::ChainSolver(const SectorModel& model) : sector_(condense(model)) {
  const auto contacts = static_cast<std::size_t>(sector_.contacts);
  workspace_.reserve(station_numbers(sector_.kind) * contacts);
  loads_.resize(1, contacts);
}

void ChainSolver::solve(double axial_force, LoadDistribution& result) {
  simd::run_kernel(instructions_for(sector_.kind), SectorKernel{}, false, sector_, axial_force,
                   options, loads_, workspace_.reserve(0));
  loads_.copy(0, options.residual_tolerance, result);
}

LoadDistribution ChainSolver::solve(double axial_force) {
  LoadDistribution result;
  solve(axial_force, result);
  return result;
}

}  // namespace prs
