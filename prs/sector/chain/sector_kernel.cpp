#include "prs/sector/chain/sector_kernel.h"

#include <type_traits>

#include "fe/chain_laws.h"
#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/lane_access.h"
#include "prs/sector/chain/shell_station.h"
#include "prs/sector/chain/sweep.h"

namespace prs {
namespace {

/// Batches of the two halves of a sector, with whatever multiply-add this file is compiled for.
struct Halves : simd::Baseline {};

}  // namespace
}  // namespace prs

namespace xsimd {
namespace types {
XSIMD_DECLARE_SIMD_REGISTER_ALIAS(prs::Halves, simd::Baseline);
}
}  // namespace xsimd

namespace prs {
namespace {

using Half = xsimd::batch<double, Halves>;

[[gnu::always_inline]] inline Half both(double first, double second) {
  const double lanes[] = {first, second};
  return from_lanes<Half>(lanes);
}
[[gnu::always_inline]] inline Half mirrored(const Half& x) { return both(lane(x, 1), lane(x, 0)); }
[[gnu::always_inline]] inline Half first_lane(const Half& x) { return both(lane(x, 0), 0.0); }

// Types of this file's own, so that what is instantiated for one instruction set stays apart from
// the same for another.
template <class Real>
struct Bars : BarStation<Real> {};
template <class Real, ChainSector::Kind kKind>
struct Shell : ShellStation<Real, kKind> {};
template <class Real>
struct Hertz : fe::ChainHertz<Real> {};
template <class Real>
struct HertzInSeries : fe::ChainHertzInSeries<Real> {};

template <class Real>
RollerBeam<Real> to_all(const RollerBeam<double>& b) {
  return {Real(b.axial), Real(b.near), Real(b.far), Real(b.slope)};
}

template <class Real>
RollerEnd<Real> to_all(const RollerEnd<double>& e) {
  return {Real(e.vv), Real(e.vt), Real(e.tt)};
}

/// What both kinds of stations share.
template <class Real, class Station>
Station common_station(const ChainSector& sector) {
  Station s;
  s.stations = sector.contacts;
  s.screw = Real(sector.screw);
  for (int i = 0; i < 2; ++i) s.ends[i] = to_all<Real>(sector.ends[i]);
  s.bending_support = Real(sector.bending_support);
  return s;
}

template <class Real>
Bars<Real> make_station(const ChainSector& sector, Real* memory, Bars<Real>*) {
  auto s = common_station<Real, Bars<Real>>(sector);
  for (const Interface i : kInterfaces) {
    s.axial_part[static_cast<int>(i)] = Real(sector.axial_part[i]);
    s.radial_part[static_cast<int>(i)] = Real(sector.radial_part[i]);
  }
  s.roller = to_all<Real>(sector.thread);
  Real* const nut = memory;
  Real* const ground = memory + sector.contacts;
  for (int k = 0; k < sector.contacts; ++k) {
    nut[k] = Real(k + 1 < sector.contacts ? sector.nut[static_cast<std::size_t>(k)] : 0.0);
    ground[k] = Real(sector.ground[static_cast<std::size_t>(k)]);
  }
  s.nut = nut;
  s.ground = ground;
  return s;
}

template <class Real, ChainSector::Kind kKind>
Shell<Real, kKind> make_station(const ChainSector& sector, Real*, Shell<Real, kKind>*) {
  auto s = common_station<Real, Shell<Real, kKind>>(sector);
  for (const Interface i : kInterfaces) {
    Real* const part = s.part[static_cast<int>(i)];
    part[0] = Real(sector.axial_part[i]);
    part[1] = Real(sector.radial_part[i]);
    part[2] = Real(sector.nut_rotation_part);
  }
  s.thread = to_all<Real>(sector.thread);
  s.tooth = to_all<Real>(sector.tooth);
  s.segments = sector.segments.data();
  s.supports = sector.supports.data();
  return s;
}

template <class Real>
SweptSector<Real> swept_sector(const ChainSector& sector) {
  SweptSector<Real> s{.contacts = sector.contacts,
                      .stations = sector.contacts,
                      .rollers = Real(sector.rollers),
                      .sense = Real(sector.sense),
                      .cosine = {},
                      .hertz_constant = {},
                      .free_compliance = Real(sector.free_compliance),
                      .offset_compliance = Real(sector.offset_compliance)};
  for (const Interface i : kInterfaces) {
    s.cosine[static_cast<int>(i)] = Real(sector.sense * sector.axial_part[i]);
    s.hertz_constant[static_cast<int>(i)] = Real(sector.hertz_constant[i]);
  }
  return s;
}

template <class Real, class Station>
void solve_sector(const ChainSector& sector, std::span<const double> axial_forces,
                  const fe::NewtonOptions& options, const ThreadLoads& results, double* workspace) {
  using Record = fe::ChainRecord<Real, Station>;
  const int n = sector.contacts;
  auto* const records = reinterpret_cast<Record*>(workspace);
  auto* const arrays = reinterpret_cast<Real*>(records + n);
  Real* const history = arrays + 4 * n;
  const auto station = make_station(sector, arrays, static_cast<Station*>(nullptr));
  const Real stiffness[2] = {Real(sector.hertz_constant.screw), Real(sector.hertz_constant.nut)};
  const SweptSector<Real> swept = swept_sector<Real>(sector);
  const auto gap = [&](int i, int k) {
    return Real(sector.gaps[kInterfaces[i]][static_cast<std::size_t>(k)]);
  };
  const auto solve = [&](const auto& law) {
    Sweep<Real, Station, std::remove_cvref_t<decltype(law)>> sweep(swept, station, law, records,
                                                                   history);
    const std::size_t size = axial_forces.size();
    const std::size_t batches = (size + kLanes<Real> - 1) / kLanes<Real>;
    for (std::size_t batch = 0; batch < batches; ++batch) {
      const LaneRange range{batch, batches, size};
      sweep.solve(range.load<Real>(axial_forces), gap, batch + 1 < batches, options, range,
                  results);
    }
  };
  if constexpr (std::is_same_v<Station, Bars<Real>>)
    if (sector.compliance.screw.empty()) return solve(Hertz<Real>{{{stiffness[0], stiffness[1]}}});
  Real* const compliance[2] = {arrays + 2 * n, arrays + 3 * n};
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < 2; ++i)
      compliance[i][k] = Real(sector.compliance[kInterfaces[i]][static_cast<std::size_t>(k)]);
  solve(HertzInSeries<Real>{{{stiffness[0], stiffness[1]}, {compliance[0], compliance[1]}}});
}

struct FoldedBars : BarStation<Half> {
  static constexpr bool kFolded = true;
};

/// One load on a sector of bars with an even number of threads.
void solve_folded(const ChainSector& sector, double axial_force, const fe::NewtonOptions& options,
                  const ThreadLoads& results, double* workspace) {
  const int n = sector.contacts;
  const auto at = [&](const std::vector<double>& values, int first, int second) {
    return both(values[static_cast<std::size_t>(first)], values[static_cast<std::size_t>(second)]);
  };
  auto* const records = reinterpret_cast<fe::ChainRecord<Half, FoldedBars>*>(workspace);
  Half* const nut = reinterpret_cast<Half*>(records + n / 2);
  Half* const ground = nut + n / 2;
  auto station = common_station<Half, FoldedBars>(sector);
  for (const Interface i : kInterfaces) {
    station.axial_part[static_cast<int>(i)] = Half(sector.axial_part[i]);
    station.radial_part[static_cast<int>(i)] = Half(sector.radial_part[i]);
  }
  station.roller = to_all<Half>(sector.thread);
  station.roller.slope = both(sector.thread.slope, -sector.thread.slope);
  station.ends[0] = {both(sector.ends[0].vv, sector.ends[1].vv),
                     both(sector.ends[0].vt, sector.ends[1].vt),
                     both(sector.ends[0].tt, sector.ends[1].tt)};
  for (int k = 0; k < n / 2; ++k) {
    nut[k] = at(sector.nut, k, n - 2 - k);
    ground[k] = at(sector.ground, k, n - 1 - k);
  }
  station.nut = nut;
  station.ground = ground;
  const Hertz<Half> law{{{Half(sector.hertz_constant.screw), Half(sector.hertz_constant.nut)}}};
  SweptSector<Half> swept = swept_sector<Half>(sector);
  swept.stations = n / 2;
  const auto gap = [&](int i, int k) { return at(sector.gaps[kInterfaces[i]], k, n - 1 - k); };
  Sweep<Half, FoldedBars, Hertz<Half>>(swept, station, law, records, nullptr)
      .solve(Half(axial_force), gap, false, options, {0, 1, 1}, results);
}

/// Stations with two roller nodes a tooth go load by load and without the wider instruction sets,
/// in lanes they take minutes to compile.
template <class Real, bool kBaseline>
void solve_sector(const ChainSector& sector, std::span<const double> axial_forces,
                  const fe::NewtonOptions& options, const ThreadLoads& results, double* workspace) {
  const auto solve = [&]<class Station>(Station*, auto number) {
    solve_sector<decltype(number), Station>(sector, axial_forces, options, results, workspace);
  };
  using enum ChainSector::Kind;
  if constexpr (std::is_same_v<Real, double> && !kBaseline)
    if (sector.kind == bars && sector.compliance.screw.empty() && axial_forces.size() == 1 &&
        sector.contacts % 2 == 0)
      return solve_folded(sector, axial_forces[0], options, results, workspace);
  if (sector.kind == bars) return solve(static_cast<Bars<Real>*>(nullptr), Real());
  if (sector.kind == shell) return solve(static_cast<Shell<Real, shell>*>(nullptr), Real());
  if constexpr (kBaseline) {
    if (sector.kind == apart_nut_first)
      return solve(static_cast<Shell<double, apart_nut_first>*>(nullptr), double());
    solve(static_cast<Shell<double, apart_screw_first>*>(nullptr), double());
  }
}

}  // namespace

template <class Arch>
void SectorKernel::operator()(Arch, bool scalar, const ChainSector& sector,
                              std::span<const double> axial_forces,
                              const fe::NewtonOptions& options, const ThreadLoads& results,
                              double* workspace) const {
  constexpr bool kBaseline = std::is_same_v<Arch, simd::Baseline>;
  if (scalar)
    solve_sector<double, kBaseline>(sector, axial_forces, options, results, workspace);
  else
    solve_sector<xsimd::batch<double, Arch>, kBaseline>(sector, axial_forces, options, results,
                                                        workspace);
}

template void SectorKernel::operator()(PRS_SIMD_ARCHITECTURE, bool, const ChainSector&,
                                       std::span<const double>, const fe::NewtonOptions&,
                                       const ThreadLoads&, double*) const;

}  // namespace prs
