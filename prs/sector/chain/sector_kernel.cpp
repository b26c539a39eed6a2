#include "prs/sector/chain/sector_kernel.h"

#include "fe/chain_hertz.h"
#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/sector_solve.h"
#include "prs/sector/chain/shell_station.h"
#include "simd/inlined.h"

namespace prs {
namespace {

/// Batch of two numbers, for the two halves of a sector. Its type differs between the instruction sets that this file
/// is compiled for, whose multiply-add it uses: templates instantiated here must stay apart.
#if defined(__AVX512F__)
using Half = xsimd::batch<double, xsimd::sse4_2>;
#elif defined(__FMA__)
using Half = xsimd::batch<double, xsimd::sse4_1>;
#else
using Half = xsimd::batch<double, simd::Baseline>;
#endif

PRS_INLINED inline Half both(double first, double second) {
  const double lanes[] = {first, second};
  return from_lanes<Half>(lanes);
}

// Types in the anonymous namespace, so that instances for one instruction set stay apart from those for another.
template <class Real>
struct Bars : BarStation<Real> {};
struct FoldedBars : BarStation<Half> {
  static constexpr bool kFolded = true;
  PRS_INLINED static Half first_lane(const Half& x) { return both(lane(x, 0), 0.0); }
  PRS_INLINED static Half mirrored(const Half& x) { return both(lane(x, 1), lane(x, 0)); }
};
template <class Real, ChainSector::Kind kKind>
struct Shell : ShellStation<Real, kKind> {};
template <class Real>
struct Hertz : fe::ChainHertz<Real> {};
template <class Real>
struct HertzInSeries : fe::ChainHertzInSeries<Real> {};
template <class Real>
struct Numbers : SectorNumbers<Real> {};

/// A batch of chains in the workspace.
template <class Real, class Station>
struct Batch {
  fe::ChainRecord<Real, Station>* records;
  Real* nut;
  Real* ground;
  Real* compliance[2];
  Numbers<Real> numbers;
  Station station;
  bool compliant;

  Batch(double* memory, int contacts) {
    records = reinterpret_cast<fe::ChainRecord<Real, Station>*>(memory);
    nut = reinterpret_cast<Real*>(records + contacts);
    ground = nut + contacts;
    compliance[0] = ground + contacts;
    compliance[1] = compliance[0] + contacts;
  }

  /// Sets the members that stations of bars take from the numbers.
  void set_bars(int stations) {
    station.stations = stations;
    station.screw = numbers.screw_rigidity / numbers.pitch;
    for (const Interface i : kInterfaces) {
      station.axial_part[static_cast<int>(i)] = numbers.sense * numbers.cosine[i];
      station.radial_part[static_cast<int>(i)] = numbers.sine[i];
    }
    station.nut = nut;
    station.ground = ground;
  }

  /// gap(i, k): initial gaps.
  template <class Gap>
  void solve(int contacts, const Gap& gap, std::span<const double> forces, const LaneRange& range,
             const fe::NewtonOptions& options, ThreadLoads& results) {
    const Real force = range.load<Real>(forces);
    const Real stiffness[2] = {numbers.hertz_constant.screw, numbers.hertz_constant.nut};
    const auto under = [&](const auto& law) {
      solve_sectors<Real>(numbers, contacts, station, law, records, force, gap, options, range, results);
    };
    if constexpr (Station::kFreedoms == Bars<Real>::kFreedoms)
      if (!compliant) return under(Hertz<Real>{{{stiffness[0], stiffness[1]}}});
    if constexpr (!fe::kFolded<Station>)
      under(HertzInSeries<Real>{{{stiffness[0], stiffness[1]}, {compliance[0], compliance[1]}}});
  }
};

template <class Real>
void solve_designs(const BarDesigns& designs, const fe::NewtonOptions& options, ThreadLoads& results,
                   double* workspace) {
  const int n = designs.contacts;
  Batch<Real, Bars<Real>> batch(workspace, n);
  for (std::size_t first = 0; first < designs.size(); first += kLanes<Real>) {
    const LaneRange range{first, designs.size()};
    for_each_number([&](Real& number, const std::vector<double>& column)
                        PRS_INLINED { number = range.load<Real>(column); },
                    batch.numbers, designs);
    batch.set_bars(n);
    batch.station.roller = roller_chain<Real>(batch.numbers);
    const auto flange = [&](std::size_t i) {
      struct Flange {
        Real from, to, axial_rigidity;
      };
      const BarDesigns::Flange& f = designs.flanges[i];
      return Flange{range.load<Real>(f.from), range.load<Real>(f.to), range.load<Real>(f.axial_rigidity)};
    };
    NutOfBars<Real, decltype(flange)>(batch.numbers, designs.flange_count, flange).set(n, batch.nut, batch.ground);
    batch.compliant = !designs.compliance.screw.empty() || !designs.compliance.nut.empty();
    if (batch.compliant)
      for (const Interface i : kInterfaces)
        for (int k = 0; k < n; ++k) batch.compliance[static_cast<int>(i)][k] = batch.numbers.compliance[i];
    const auto gap = [&](int i, int k) {
      return range.load<Real>(designs.gaps[kInterfaces[i]], static_cast<std::size_t>(n), static_cast<std::size_t>(k));
    };
    batch.solve(n, gap, designs.axial_force, range, options, results);
  }
}

template <class Real>
RollerBeam<Real> to_all(const RollerBeam<double>& b) {
  return {Real(b.axial), Real(b.near), Real(b.far), Real(b.slope)};
}

template <class Real>
RollerEnd<Real> to_all(const RollerEnd<double>& e) {
  return {Real(e.vv), Real(e.vt), Real(e.tt)};
}

/// A sector's chain with the same numbers in all lanes.
template <class Real, class Station>
void set_all(Batch<Real, Station>& batch, const ChainSector& sector) {
  for_each_number([](Real& number, const double& of_sector) { number = Real(of_sector); }, batch.numbers,
                  sector.numbers);
  const RollerChain<double>& roller = sector.roller;
  batch.station.roller = {to_all<Real>(roller.thread),
                          to_all<Real>(roller.tooth),
                          {to_all<Real>(roller.ends[0]), to_all<Real>(roller.ends[1])},
                          Real(roller.bending_support)};
  batch.compliant = !sector.compliance.screw.empty();
}

void set_station(Batch<double, Bars<double>>& batch, const ChainSector& sector) {
  batch.set_bars(sector.contacts);
  batch.station.nut = sector.nut.data();
  batch.station.ground = sector.ground.data();
}

template <ChainSector::Kind kKind>
void set_station(Batch<double, Shell<double, kKind>>& batch, const ChainSector& sector) {
  Shell<double, kKind>& s = batch.station;
  s.stations = sector.contacts;
  s.set_parts(sector.numbers, sector.nut_rotation_part);
  s.segments = sector.segments.data();
  s.segment_of = sector.segment_of.data();
  s.supports = sector.supports.data();
}

template <class Station>
void solve_one(const ChainSector& sector, std::span<const double> axial_force, const fe::NewtonOptions& options,
               ThreadLoads& results, double* workspace) {
  Batch<double, Station> batch(workspace, sector.contacts);
  set_all(batch, sector);
  set_station(batch, sector);
  for (std::size_t k = 0; k < sector.compliance.screw.size(); ++k)
    for (int i = 0; i < 2; ++i) batch.compliance[i][k] = sector.compliance[kInterfaces[i]][k];
  const auto gap = [&](int i, int k) { return sector.gaps[kInterfaces[i]][static_cast<std::size_t>(k)]; };
  batch.solve(sector.contacts, gap, axial_force, {0, 1}, options, results);
}

/// One load on a sector of bars with an even number of threads.
[[maybe_unused]] void solve_folded(const ChainSector& sector, std::span<const double> axial_force,
                                   const fe::NewtonOptions& options, ThreadLoads& results, double* workspace) {
  const int n = sector.contacts;
  const auto at = [](const std::vector<double>& values, int first, int second) {
    return both(values[static_cast<std::size_t>(first)], values[static_cast<std::size_t>(second)]);
  };
  Batch<Half, FoldedBars> batch(workspace, n / 2);
  set_all(batch, sector);
  batch.set_bars(n / 2);
  RollerChain<Half>& roller = batch.station.roller;
  roller.thread.slope = both(sector.roller.thread.slope, -sector.roller.thread.slope);
  roller.ends[0].vt = both(sector.roller.ends[0].vt, sector.roller.ends[1].vt);
  roller.ends[1] = {Half(0.0), Half(0.0), Half(0.0)};  // no end in the middle
  for (int k = 0; k < n / 2; ++k) {
    batch.nut[k] = at(sector.nut, k, n - 2 - k);
    batch.ground[k] = at(sector.ground, k, n - 1 - k);
  }
  const auto gap = [&](int i, int k) { return at(sector.gaps[kInterfaces[i]], k, n - 1 - k); };
  batch.solve(n, gap, axial_force, {0, 1}, options, results);
}

}  // namespace

template <class Arch>
void SectorKernel::operator()(Arch, bool scalar, const BarDesigns& designs, const fe::NewtonOptions& options,
                              ThreadLoads& results, double* workspace) const {
  if (scalar)
    solve_designs<double>(designs, options, results, workspace);
  else
    solve_designs<xsimd::batch<double, Arch>>(designs, options, results, workspace);
}

/// Stations with two roller nodes per tooth are compiled only once, as it takes long.
template <class Arch>
void SectorKernel::operator()(Arch, bool, const ChainSector& sector, double axial_force,
                              const fe::NewtonOptions& options, ThreadLoads& results, double* workspace) const {
  using enum ChainSector::Kind;
  const auto solve = [&](auto function) { function(sector, {&axial_force, 1}, options, results, workspace); };
  if constexpr (!std::is_same_v<Arch, simd::Baseline>)
    if (sector.kind == bars && sector.compliance.screw.empty() && sector.contacts % 2 == 0) return solve(solve_folded);
  if (sector.kind == bars) return solve(solve_one<Bars<double>>);
  if (sector.kind == shell) return solve(solve_one<Shell<double, shell>>);
  if constexpr (std::is_same_v<Arch, simd::Baseline>) {
    if (sector.kind == apart_nut_first) return solve(solve_one<Shell<double, apart_nut_first>>);
    solve(solve_one<Shell<double, apart_screw_first>>);
  }
}

template void SectorKernel::operator()(PRS_SIMD_ARCHITECTURE, bool, const BarDesigns&, const fe::NewtonOptions&,
                                       ThreadLoads&, double*) const;
template void SectorKernel::operator()(PRS_SIMD_ARCHITECTURE, bool, const ChainSector&, double,
                                       const fe::NewtonOptions&, ThreadLoads&, double*) const;

}  // namespace prs
