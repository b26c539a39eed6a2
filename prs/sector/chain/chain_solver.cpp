#include "prs/sector/chain/chain_solver.h"

#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/design_solvers.h"
#include "prs/sector/chain/nut_condensation.h"
#include "prs/sector/chain/sector_solve.h"
#include "simd/dispatch.h"

namespace prs {
namespace {

/// Number of values per contact in the kernel's workspace.
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

/// Instruction set: stations with two roller nodes per tooth are compiled for the baseline only.
InstructionSet instructions_for(ChainSector::Kind kind) {
  using enum ChainSector::Kind;
  return kind == bars || kind == shell ? InstructionSet::scalar : InstructionSet::baseline;
}

/// The nut's shells or bars, condensed to the contacts.
void set_nut(const SectorModel& s, ChainSector& c) {
  const NutLine line = nut_line(s);
  std::vector<fe::ShellBlocks<double>> shells;
  std::vector<int> same;
  for (std::size_t k = 0; k < line.outer_radius.size(); ++k) {
    if (s.nut_shell)
      shells.push_back(fe::to_blocks(s.nut_shell->segments[k]));
    else
      shells.push_back({.uu = line.axial_rigidity[k] / line.length(k)});
    const auto known = std::ranges::find(shells, shells.back());
    same.push_back(static_cast<int>(known - shells.begin()));
  }
  const NutShape shape{line.contacts, line.thrust, same, false, {}};
  const bool is_shell = s.nut_shell.has_value();
  const NutHolds holds{line.thrust, !is_shell || s.nut_shell->radially_rigid, !is_shell,
                       is_shell && s.nut_shell->straight_thrust_section};
  set_segments_of(shape, c.segment_of);
  c.supports.resize(line.contacts.size());
  c.segments.resize(line.contacts.size());
  NutCondensation<double>(shape, holds, shells.data(), s.roller_radius)
      .set(c.segment_of, c.segments.data(), c.supports.data());
}

void set_bars(const SectorModel& s, ChainSector& c) {
  c.nut.resize(s.gaps.nut.size());
  c.ground.resize(s.gaps.nut.size());
  const auto flange = [&](std::size_t i) -> const SectorModel::Flange& { return s.flanges[i]; };
  NutOfBars<double, decltype(flange)>(s, s.flanges.size(), flange).set(c.contacts, c.nut.data(), c.ground.data());
}

}  // namespace

ChainSolver::ChainSolver(const SectorModel& model) : sector_(condense(model)) {
  const auto contacts = static_cast<std::size_t>(sector_.contacts);
  workspace_.reserve(station_numbers(sector_.kind) * contacts);
  loads_.resize(1, contacts);
}

void ChainSolver::solve(double axial_force, LoadDistribution& result) {
  simd::run_kernel(instructions_for(sector_.kind), SectorKernel{}, false, sector_, axial_force, options, loads_,
                   workspace_.reserve(0));
  loads_.copy(0, options.residual_tolerance, result);
}

LoadDistribution ChainSolver::solve(double axial_force) {
  LoadDistribution result;
  solve(axial_force, result);
  return result;
}

ChainSector condense(const SectorModel& s) {
  using Kind = ChainSector::Kind;
  ChainSector c;
  c.contacts = s.contacts();
  c.numbers = s;
  c.roller = roller_chain<double>(s);
  c.gaps = s.gaps;
  const bool bars = !s.contacts_apart() && !s.nut_shell;
  if (!bars || s.has_compliance())
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < s.gaps[i].size(); ++k) c.compliance[i].push_back(s.contact_compliance(i, k));
  if (bars) {
    set_bars(s, c);
    return c;
  }
  c.kind = !s.contacts_apart() ? Kind::shell : s.sense < 0.0 ? Kind::apart_nut_first : Kind::apart_screw_first;
  if (s.contacts_apart())
    c.roller.tooth = roller_beam<double>(s.thread, 2.0 * s.contact_half_distance, s.roller_radius);
  if (s.nut_shell) c.nut_rotation_part = s.sense * s.cosine.nut * s.nut_shell->contact_arm / s.roller_radius;
  set_nut(s, c);
  return c;
}

}  // namespace prs
