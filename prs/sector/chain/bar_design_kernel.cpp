#include "prs/sector/chain/bar_design_kernel.h"

#include "fe/chain_laws.h"
#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/lane_access.h"
#include "prs/sector/chain/sweep.h"
#include "prs/model/structure.h"

namespace prs {
namespace {

// Types of this file's own, so that what is instantiated for one instruction set stays apart from
// the same for another.
template <class Real>
struct Bars : BarStation<Real> {};
template <class Real>
struct Hertz : fe::ChainHertz<Real> {};
template <class Real>
struct HertzInSeries : fe::ChainHertzInSeries<Real> {};

template <class Real>
using BarRecord = fe::ChainRecord<Real, Bars<Real>>;

constexpr double kInfinity = __builtin_inf();

/// Arrays of a batch of designs in the workspace.
template <class Real>
struct BarWorkspace {
  BarRecord<Real>* records;
  Real* nut;
  Real* ground;
  Real* compliance[2];
  Real* history;

  BarWorkspace(double* memory, int contacts) {
    records = reinterpret_cast<BarRecord<Real>*>(memory);
    nut = reinterpret_cast<Real*>(records + contacts);
    ground = nut + contacts;
    compliance[0] = ground + contacts;
    compliance[1] = compliance[0] + contacts;
    history = compliance[1] + contacts;
  }
};

/// Reads and sets up one batch of designs.
template <class Real>
struct BarBatch {
  const BarDesigns& designs;
  LaneRange range;

  [[gnu::always_inline]] Real load(BarDesigns::Values values) const {
    return range.load<Real>(values);
  }

  RollerLength<Real> roller_length(const BarDesigns::Section& section, const Real& length) const {
    const Real shear = load(section.shear);
    return {length, 1.0 / load(section.bending), select(shear <= 0.0, Real(0.0), 1.0 / shear)};
  }

  void set_up_roller(Bars<Real>& station) const {
    const Real pitch = load(designs.pitch), radius = load(designs.roller_radius);
    const Real bending = load(designs.thread.bending), shear = load(designs.thread.shear);
    const Real phi = select(shear <= 0.0, Real(0.0), 12.0 * bending / (shear * pitch * pitch));
    const Real b = bending / (pitch * (1.0 + phi) * radius * radius);
    station.roller = {load(designs.thread.axial) / pitch, (4.0 + phi) * b, (2.0 - phi) * b,
                      radius / pitch};
    const RollerLength<Real> run_out = roller_length(designs.thread, 0.5 * pitch);
    const RollerLength<Real> end = roller_length(designs.end, load(designs.end_length));
    const Real outer = load(designs.outer_guide), inner = load(designs.inner_guide);
    station.ends[0] = roller_end(run_out, end, outer, inner, Real(-1.0), radius);
    station.ends[1] = station.ends[0];
    station.ends[1].vt = -station.ends[0].vt;
    station.bending_support = select(load(designs.rigid_bending) > 0.0, Real(kInfinity), Real(0.0));
  }

  /// Compliance of the nut between two sections, int dx/(E A) [m/N].
  struct NutCompliance {
    static constexpr std::size_t kKept = 4;  ///< Flanges that are read once.
    struct Flange {
      Real from, to, less;
    };
    const BarBatch& batch;
    Real plain;
    Flange kept[kKept];

    explicit NutCompliance(const BarBatch& b)
        : batch(b), plain(1.0 / b.load(b.designs.nut_rigidity)) {
      for (std::size_t i = 0; i < kKept && i < b.designs.flanges.size(); ++i) kept[i] = read(i);
    }

    Flange read(std::size_t i) const {
      const BarDesigns::Flange& f = batch.designs.flanges[i];
      return {batch.load(f.from), batch.load(f.to), 1.0 / batch.load(f.axial_rigidity) - plain};
    }

    Real operator()(const Real& from, const Real& to) const {
      Real compliance = (to - from) * plain;
      for (std::size_t i = 0; i < batch.designs.flanges.size(); ++i) {
        const Flange f = i < kKept ? kept[i] : read(i);
        const Real covered = min(f.to, to) - max(f.from, from);
        compliance += select(covered <= 0.0, Real(0.0), covered * f.less);
      }
      return compliance;
    }
  };

  void set_up_nut(Bars<Real>& station, BarWorkspace<Real>& w) const {
    const NutCompliance compliance(*this);
    const Real same = kSamePlace * load(designs.nut_length);
    const Real thrust = load(designs.thrust), pitch = load(designs.pitch);
    const Real none = thrust - thrust;  // not a number where the thrust section is none
    const auto support = [&](const fe::Lanes<Real>& where, const Real& from, const Real& to) {
      return any(where) ? select(where, 1.0 / compliance(from, to), none) : none;
    };
    Real x = load(designs.position);
    w.ground[0] = support(thrust <= x - same, thrust, x);
    for (int k = 0; k < designs.contacts; ++k) {
      const fe::Lanes<Real> held = abs(x - thrust) < same;
      w.ground[k] = select(held, Real(kInfinity), w.ground[k]);
      if (k + 1 == designs.contacts) {
        w.ground[k] += support(thrust >= x + same, x, thrust);
        break;
      }
      const Real next = load(designs.position) + (k + 1) * pitch;
      const fe::Lanes<Real> inside = (thrust >= x + same) & (thrust <= next - same);
      w.ground[k] += support(inside, x, thrust);
      w.ground[k + 1] = support(inside, thrust, next);
      w.nut[k] = select(inside, none, 1.0 / compliance(x, next));
      x = next;
    }
    station.nut = w.nut;
    station.ground = w.ground;
  }

  Bars<Real> station(BarWorkspace<Real>& w) const {
    Bars<Real> s;
    s.stations = designs.contacts;
    const Real sense = load(designs.sense);
    for (const Interface i : kInterfaces) {
      s.axial_part[static_cast<int>(i)] = sense * load(designs.cosine[i]);
      s.radial_part[static_cast<int>(i)] = load(designs.sine[i]);
    }
    s.screw = load(designs.screw_rigidity) / load(designs.pitch);
    set_up_roller(s);
    set_up_nut(s, w);
    return s;
  }

  SweptSector<Real> swept_sector() const {
    SweptSector<Real> s{.contacts = designs.contacts,
                        .stations = designs.contacts,
                        .rollers = load(designs.rollers),
                        .sense = load(designs.sense),
                        .cosine = {},
                        .hertz_constant = {},
                        .free_compliance = load(designs.free_length) / load(designs.screw_rigidity),
                        .offset_compliance = Real(0.0)};
    for (const Interface i : kInterfaces) {
      s.cosine[static_cast<int>(i)] = load(designs.cosine[i]);
      s.hertz_constant[static_cast<int>(i)] = load(designs.hertz_constant[i]);
    }
    return s;
  }

  Real gap(Interface i, int k) const {
    return range.load<Real>(designs.gaps[i], static_cast<std::size_t>(designs.contacts),
                            static_cast<std::size_t>(k));
  }
};

template <class Real, class Law>
void solve_batch(const BarBatch<Real>& batch, const Law& law, const Bars<Real>& station,
                 const BarWorkspace<Real>& w, const fe::NewtonOptions& options,
                 const ThreadLoads& results) {
  const BarDesigns& designs = batch.designs;
  const SweptSector<Real> swept = batch.swept_sector();
  Sweep<Real, Bars<Real>, Law> sweep(swept, station, law, w.records, w.history);
  const auto gap = [&](int i, int k) { return batch.gap(kInterfaces[i], k); };
  const std::size_t loads = designs.loads;
  for (std::size_t k = 0; k < loads; ++k) {
    const LaneRange range{batch.range.first * loads + k, loads, batch.range.size * loads};
    sweep.solve(range.load<Real>(designs.axial_force), gap, k + 1 < loads, options, range, results);
  }
}

template <class Real>
void solve_designs(const BarDesigns& designs, const fe::NewtonOptions& options,
                   const ThreadLoads& results, double* workspace) {
  BarWorkspace<Real> w(workspace, designs.contacts);
  const std::size_t size = designs.axial_force.size() / designs.loads;
  for (std::size_t first = 0; first < size; first += kLanes<Real>) {
    const BarBatch<Real> batch{designs, {first, 1, size}};
    const Bars<Real> station = batch.station(w);
    const Real stiffness[2] = {batch.load(designs.hertz_constant.screw),
                               batch.load(designs.hertz_constant.nut)};
    if (designs.compliance.screw.empty() && designs.compliance.nut.empty()) {
      const Hertz<Real> law{{{stiffness[0], stiffness[1]}}};
      solve_batch(batch, law, station, w, options, results);
    } else {
      for (const Interface i : kInterfaces)
        for (int k = 0; k < designs.contacts; ++k)
          w.compliance[static_cast<int>(i)][k] = batch.load(designs.compliance[i]);
      const HertzInSeries<Real> law{
          {{stiffness[0], stiffness[1]}, {w.compliance[0], w.compliance[1]}}};
      solve_batch(batch, law, station, w, options, results);
    }
  }
}

}  // namespace

template <class Arch>
void BarDesignKernel::operator()(Arch, bool scalar, const BarDesigns& designs,
                                 const fe::NewtonOptions& options, const ThreadLoads& results,
                                 double* workspace) const {
  if (scalar)
    solve_designs<double>(designs, options, results, workspace);
  else
    solve_designs<xsimd::batch<double, Arch>>(designs, options, results, workspace);
}

template void BarDesignKernel::operator()(PRS_SIMD_ARCHITECTURE, bool, const BarDesigns&,
                                          const fe::NewtonOptions&, const ThreadLoads&,
                                          double*) const;

}  // namespace prs
