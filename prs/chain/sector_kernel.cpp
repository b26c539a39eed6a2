#include "prs/chain/sector_kernel.h"

#include <type_traits>

#include "fe/chain_laws.h"
#include "prs/chain/bar_station.h"
#include "prs/chain/deliver.h"
#include "prs/chain/lane_access.h"
#include "prs/chain/shell_station.h"

namespace prs {
namespace {

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

/// Loads on one sector, batch after batch.
template <class Real, class Station, class Law>
class SectorSweep {
 public:
  using Record = fe::ChainRecord<Real, Station>;
  static constexpr int M = Station::kFreedoms;

  /// `history` has room for 3 (M + 4) numbers a station.
  SectorSweep(const ChainSector& sector, const Station& station, const Law& law, Record* records,
              Real* history)
      : sector_(sector),
        law_(law),
        records_(records),
        chain_(station, law, sector.contacts, records) {
    for (int age = 0; age < 3; ++age) ages_[age] = history + age * sector.contacts * kKept;
  }

  void solve(std::span<const double> axial_forces, const fe::NewtonOptions& options,
             const ThreadLoads& results) {
    const std::size_t size = axial_forces.size();
    const std::size_t batches = (size + kLanes<Real> - 1) / kLanes<Real>;
    for (std::size_t batch = 0; batch < batches; ++batch) {
      const LaneRange range{batch, batches, size};
      const Real force = range.load<Real>(axial_forces) / sector_.rollers;
      fe::ChainSummary<Real> summary = solve(force, options);
      summary.energy -= 0.5 * sector_.free_compliance * force * force;
      if (any(!summary.converged))
        known_ = 0;
      else if (batch + 1 < batches)
        remember(force);
      deliver(summary, law_, sector_.contacts, records_, range, results);
      const auto& loaded = records_[0].state;
      const double flexibility = sector_.free_compliance + sector_.offset_compliance;
      range.store(sector_.sense * (loaded.head[0] + loaded.tail[0]) + flexibility * force,
                  results.axial_displacement);
      if (!results.tangent_stiffness.empty())
        range.store(sector_.rollers / (chain_.flexibility() + flexibility),
                    results.tangent_stiffness);
    }
  }

 private:
  fe::ChainSummary<Real> solve(const Real& force, const fe::NewtonOptions& options) {
    const Real load = sector_.sense * force;
    if (known_ < 2) {
      const Real push = start_from_rest(force);
      return chain_.solve_from_rest(load, force, push, options);
    }
    const Real balanced = sector_.sense * extrapolate(force);
    return chain_.solve_from_balance(load, force, balanced, options);
  }

  double gap(int i, int k) const {
    return sector_.gaps[kInterfaces[i]][static_cast<std::size_t>(k)];
  }

  /// As BarBatch::start.
  Real start_from_rest(const Real& force) {
    Real shift[2];
    for (int i = 0; i < 2; ++i) {
      const Interface interface = kInterfaces[i];
      const double cosine = sector_.sense * sector_.axial_part[interface];
      const Real root =
          cbrt(force / (sector_.contacts * cosine * sector_.hertz_constant[interface]));
      double widest = gap(i, 0);
      for (int k = 1; k < sector_.contacts; ++k) widest = fe::largest(widest, gap(i, k));
      for (int k = 0; k < sector_.contacts; ++k)
        records_[k].contact[i].closure = root * root + (widest - gap(i, k));
      shift[i] = sector_.sense * (root * root + widest) / cosine;
    }
    for (int k = 0; k < sector_.contacts; ++k) {
      auto& state = records_[k].state;
      for (int i = 0; i < M; ++i) state.head[i] = state.tail[i] = Real(0.0);
      state.head[Station::S] = shift[0] + shift[1];
      for (int i = Station::U; i < M; i += 3) state.head[i] = shift[1];
    }
    return shift[0] + shift[1];
  }

  /// What is kept of a station: displacements, closures, contact forces.
  static constexpr int kKept = M + 4;

  /// The state reached becomes the youngest of the history.
  void remember(const Real& force) {
    known_ = known_ < 3 ? known_ + 1 : 3;
    for (int age = 2; age > 0; --age) force_[age] = force_[age - 1];
    force_[0] = force;
    Real* const oldest = ages_[2];
    ages_[2] = ages_[1];
    ages_[1] = ages_[0];
    ages_[0] = oldest;
    for (int k = 0; k < sector_.contacts; ++k) {
      Real* kept = ages_[0] + k * kKept;
      for (int i = 0; i < M; ++i) *kept++ = records_[k].state.head[i];
      for (const auto& c : records_[k].contact) {
        *kept++ = c.closure;
        *kept++ = c.force;
      }
    }
  }

  /// The quadratic, else the line, through the solutions of the last loads; the last one where
  /// loads repeat. Returns the force on the sector that its linear elements balance.
  Real extrapolate(const Real& force) {
    const Real &f0 = force_[0], &f1 = force_[1], &f2 = force_[2];
    const fe::Lanes<Real> ascending = (force > f0) & (f0 > f1);
    const Real slope = (force - f0) / (f0 - f1);
    Real weight[3] = {1.0 + slope, -slope, Real(0.0)};
    if (known_ == 3) {
      const fe::Lanes<Real> three = ascending & (f1 > f2);
      const Real w[3] = {(force - f1) * (force - f2) / ((f0 - f1) * (f0 - f2)),
                         (force - f0) * (force - f2) / ((f1 - f0) * (f1 - f2)),
                         (force - f0) * (force - f1) / ((f2 - f0) * (f2 - f1))};
      for (int age = 0; age < 3; ++age) weight[age] = select(three, w[age], weight[age]);
    }
    const Real last[3] = {Real(1.0), Real(0.0), Real(0.0)};
    for (int age = 0; age < 3; ++age) weight[age] = select(ascending, weight[age], last[age]);
    const int ages = known_ == 3 ? 3 : 2;
    for (int k = 0; k < sector_.contacts; ++k) {
      Real kept[kKept];
      for (int i = 0; i < kKept; ++i) {
        kept[i] = weight[0] * ages_[0][k * kKept + i];
        for (int age = 1; age < ages; ++age) kept[i] += weight[age] * ages_[age][k * kKept + i];
      }
      Record& record = records_[k];
      for (int i = 0; i < M; ++i) {
        record.state.head[i] = kept[i];
        record.state.tail[i] = Real(0.0);
      }
      for (int i = 0; i < 2; ++i) {
        record.contact[i].closure = kept[M + 2 * i];
        record.contact[i].remainder = kept[M + 2 * i + 1];
      }
    }
    Real balanced = weight[0] * f0 + weight[1] * f1;
    if (ages == 3) balanced += weight[2] * f2;
    return balanced;
  }

  const ChainSector& sector_;
  const Law& law_;
  Record* records_;
  Real* ages_[3];  ///< Of the history, the youngest first.
  fe::Chain<Real, Station, Law> chain_;
  Real force_[3];
  int known_ = 0;  ///< States in the history that belong to the loads just before.
};

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
  const auto solve = [&](const auto& law) {
    SectorSweep<Real, Station, std::remove_cvref_t<decltype(law)>>(sector, station, law, records,
                                                                   history)
        .solve(axial_forces, options, results);
  };
  if constexpr (std::is_same_v<Station, Bars<Real>>)
    if (sector.compliance.screw.empty()) return solve(Hertz<Real>{{{stiffness[0], stiffness[1]}}});
  Real* const compliance[2] = {arrays + 2 * n, arrays + 3 * n};
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < 2; ++i)
      compliance[i][k] = Real(sector.compliance[kInterfaces[i]][static_cast<std::size_t>(k)]);
  solve(HertzInSeries<Real>{{{stiffness[0], stiffness[1]}, {compliance[0], compliance[1]}}});
}

/// Stations with two roller nodes a tooth go load by load and without the wider instruction sets,
/// in lanes they take minutes to compile.
template <class Real, bool kWithApart>
void solve_sector(const ChainSector& sector, std::span<const double> axial_forces,
                  const fe::NewtonOptions& options, const ThreadLoads& results, double* workspace) {
  const auto solve = [&]<class Station>(Station*, auto number) {
    solve_sector<decltype(number), Station>(sector, axial_forces, options, results, workspace);
  };
  using enum ChainSector::Kind;
  if (sector.kind == bars) return solve(static_cast<Bars<Real>*>(nullptr), Real());
  if (sector.kind == shell) return solve(static_cast<Shell<Real, shell>*>(nullptr), Real());
  if constexpr (kWithApart) {
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
  constexpr bool kWithApart = std::is_same_v<Arch, simd::Baseline>;
  if (scalar)
    solve_sector<double, kWithApart>(sector, axial_forces, options, results, workspace);
  else
    solve_sector<xsimd::batch<double, Arch>, kWithApart>(sector, axial_forces, options, results,
                                                         workspace);
}

template void SectorKernel::operator()(PRS_SIMD_ARCHITECTURE, bool, const ChainSector&,
                                       std::span<const double>, const fe::NewtonOptions&,
                                       const ThreadLoads&, double*) const;

}  // namespace prs
