#include "prs/sector/chain/bar_designs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "fe/chain_laws.h"
#include "prs/sector/chain/bar_design_kernel.h"
#include "prs/sector/chain/bar_station.h"
#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/chain/dispatch.h"
#include "prs/sector/chain/distribution.h"
#include "prs/sector/chain/sweep.h"
#include "prs/sector/chain/workspace.h"
#include "prs/sector/section_properties.h"

namespace prs {
namespace {

BarSector::Section disc(const Material& material, double diameter, bool shear) {
  const DiscRigidity r = disc_rigidity(material, diameter, shear);
  return {r.axial, r.bending, r.shear};
}

/// A number of `BarSector` and where the column of it belongs.
struct Field {
  BarDesigns::Values& (*column)(BarDesigns&);
  double (*value)(const BarSector&);
};

using D = BarDesigns;
using S = const BarSector;
using V = BarDesigns::Values;

constexpr Field kFields[] = {
    {[](D& d) -> V& { return d.rollers; }, [](S& s) { return double(s.rollers); }},
    {[](D& d) -> V& { return d.sense; }, [](S& s) { return sense(s.direction); }},
    {[](D& d) -> V& { return d.pitch; }, [](S& s) { return s.pitch; }},
    {[](D& d) -> V& { return d.screw_rigidity; }, [](S& s) { return s.screw_rigidity; }},
    {[](D& d) -> V& { return d.free_length; }, [](S& s) { return s.free_length; }},
    {[](D& d) -> V& { return d.thread.axial; }, [](S& s) { return s.thread.axial; }},
    {[](D& d) -> V& { return d.thread.bending; }, [](S& s) { return s.thread.bending; }},
    {[](D& d) -> V& { return d.thread.shear; }, [](S& s) { return s.thread.shear; }},
    {[](D& d) -> V& { return d.end.axial; }, [](S& s) { return s.end.axial; }},
    {[](D& d) -> V& { return d.end.bending; }, [](S& s) { return s.end.bending; }},
    {[](D& d) -> V& { return d.end.shear; }, [](S& s) { return s.end.shear; }},
    {[](D& d) -> V& { return d.end_length; }, [](S& s) { return s.end_length; }},
    {[](D& d) -> V& { return d.outer_guide; }, [](S& s) { return s.outer_guide; }},
    {[](D& d) -> V& { return d.inner_guide; }, [](S& s) { return s.inner_guide; }},
    {[](D& d) -> V& { return d.rigid_bending; }, [](S& s) { return s.rigid_bending ? 1.0 : 0.0; }},
    {[](D& d) -> V& { return d.roller_radius; }, [](S& s) { return s.roller_radius; }},
    {[](D& d) -> V& { return d.nut_rigidity; }, [](S& s) { return s.nut_rigidity; }},
    {[](D& d) -> V& { return d.nut_length; }, [](S& s) { return s.nut_length; }},
    {[](D& d) -> V& { return d.thrust; }, [](S& s) { return s.thrust; }},
    {[](D& d) -> V& { return d.position; }, [](S& s) { return s.position; }},
    {[](D& d) -> V& { return d.hertz_constant.screw; },
     [](S& s) { return s.laws.screw.hertz_constant; }},
    {[](D& d) -> V& { return d.hertz_constant.nut; },
     [](S& s) { return s.laws.nut.hertz_constant; }},
    {[](D& d) -> V& { return d.cosine.screw; },
     [](S& s) { return std::cos(s.laws.screw.normal_angle); }},
    {[](D& d) -> V& { return d.cosine.nut; },
     [](S& s) { return std::cos(s.laws.nut.normal_angle); }},
    {[](D& d) -> V& { return d.sine.screw; },
     [](S& s) { return std::sin(s.laws.screw.normal_angle); }},
    {[](D& d) -> V& { return d.sine.nut; }, [](S& s) { return std::sin(s.laws.nut.normal_angle); }},
    {[](D& d) -> V& { return d.compliance.screw; }, [](S& s) { return s.laws.screw.compliance; }},
    {[](D& d) -> V& { return d.compliance.nut; }, [](S& s) { return s.laws.nut.compliance; }},
};

bool compliant(const BarSector& s) {
  return s.laws.screw.compliance != 0.0 || s.laws.nut.compliance != 0.0;
}

/// Numbers that the kernel's workspace holds.
std::size_t workspace_size(int contacts, int width, bool several_loads) {
  using OneSweep = Sweep<double, BarStation<double>, fe::ChainHertz<double>>;
  constexpr std::size_t kArrays = 4;  // nut, ground and two compliances
  constexpr std::size_t kHistory = OneSweep::kAges * OneSweep::M;
  return static_cast<std::size_t>(contacts) * static_cast<std::size_t>(width) *
         (sizeof(OneSweep::Record) / sizeof(double) + kArrays + (several_loads ? kHistory : 0));
}

/// Sectors of as many contacts, all with compliances or all without, as columns.
class Columns {
 public:
  void clear() {
    for (std::vector<double>& column : values_) column.clear();
    force_.clear();
    for (FlangeColumns& f : flanges_)
      for (auto* values : {&f.from, &f.to, &f.rigidity}) values->clear();
    flange_count_ = 0;
    for (const Interface i : kInterfaces) gaps_[i].clear();
    gapped_ = {};
  }

  std::size_t size() const { return values_[0].size(); }

  void add(const BarSector& s, std::span<const double> forces) {
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i].push_back(kFields[i].value(s));
    force_.insert(force_.end(), forces.begin(), forces.end());
    flange_count_ = std::max(flange_count_, s.flanges.size());
    if (flange_count_ > flanges_.size()) flanges_.resize(flange_count_);
    for (std::size_t i = 0; i < flange_count_; ++i) {
      FlangeColumns& column = flanges_[i];
      const BarSector::Flange flange = i < s.flanges.size() ? s.flanges[i] : BarSector::Flange{};
      for (auto* values : {&column.from, &column.to, &column.rigidity}) values->resize(size());
      column.from.back() = flange.from;
      column.to.back() = flange.to;
      column.rigidity.back() = flange.axial_rigidity;
    }
    const auto contacts = static_cast<std::size_t>(s.contacts);
    for (const Interface i : kInterfaces) {
      gapped_[i] = gapped_[i] || !s.gaps[i].empty();
      gaps_[i].resize(gaps_[i].size() + contacts, 0.0);
      assert(s.gaps[i].empty() || s.gaps[i].size() == contacts);
      std::copy(s.gaps[i].begin(), s.gaps[i].end(),
                gaps_[i].end() - static_cast<std::ptrdiff_t>(contacts));
    }
  }

  /// Valid until the next change.
  BarDesigns view(int contacts, bool with_compliance) {
    BarDesigns d;
    d.contacts = contacts;
    d.loads = force_.size() / size();
    d.axial_force = force_;
    for (std::size_t i = 0; i < values_.size(); ++i) kFields[i].column(d) = values_[i];
    if (!with_compliance) d.compliance = {};
    flange_views_.clear();
    for (std::size_t i = 0; i < flange_count_; ++i)
      flange_views_.push_back({flanges_[i].from, flanges_[i].to, flanges_[i].rigidity});
    d.flanges = flange_views_;
    for (const Interface i : kInterfaces)
      if (gapped_[i]) d.gaps[i] = gaps_[i];
    return d;
  }

 private:
  struct FlangeColumns {
    std::vector<double> from, to, rigidity;
  };
  std::array<std::vector<double>, std::size(kFields)> values_;
  std::vector<double> force_;
  std::vector<FlangeColumns> flanges_;  ///< The first `flange_count_` are in use.
  std::size_t flange_count_ = 0;
  std::vector<BarDesigns::Flange> flange_views_;
  PerInterface<std::vector<double>> gaps_;
  PerInterface<bool> gapped_;
};

}  // namespace

BarSector bar_sector(const Mechanism& m, const Structure& structure, const Materials& materials,
                     const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                     Direction direction, double position, const Deviations& deviations) {
  BarSector s;
  s.contacts = m.contacts_per_roller;
  s.rollers = m.rollers;
  s.direction = direction;
  s.pitch = axial_pitch(m);

  const double screw = *m.pitch_diameter.screw, roller = *m.pitch_diameter.roller;
  s.screw_rigidity =
      materials.screw.youngs_modulus * ring_area(screw, structure.screw.bore) / m.rollers;
  s.free_length = free_length(structure);

  s.thread = disc(materials.roller, roller, options.roller_shear);
  s.end = disc(materials.roller, structure.roller.end_diameter, options.roller_shear);
  s.end_length = structure.roller.end_length;
  switch (const Guidance& guidance = structure.roller.guidance; guidance.kind) {
    case Guidance::Kind::both_end_nodes:
      s.outer_guide = s.inner_guide = kHeld;
      break;
    case Guidance::Kind::outer_node:
      s.outer_guide = kHeld;
      break;
    case Guidance::Kind::ring:
      s.outer_guide = s.inner_guide = guidance.ring_stiffness;
      break;
  }
  s.rigid_bending = options.roller == ModelOptions::Roller::rigid_bending;
  s.roller_radius = 0.5 * roller;

  const Structure::Nut& nut = structure.nut;
  const auto nut_rigidity = [&](double outer) {
    return materials.nut.youngs_modulus * ring_area(outer, *m.pitch_diameter.nut) / m.rollers;
  };
  s.nut_rigidity = nut_rigidity(nut.outer_diameter);
  s.nut_length = nut.length;
  s.thrust = direction == Direction::tension ? *nut.thrust.tension : *nut.thrust.compression;
  s.position = position;
  for (const Structure::Flange& f : nut.flanges)
    s.flanges.push_back({f.from, f.to, nut_rigidity(f.outer_diameter)});

  s.laws = laws;
  s.gaps = initial_gaps(m, deviations, materials, {laws.screw.normal_angle, laws.nut.normal_angle},
                        direction);
  for (const Interface i : kInterfaces)
    if (std::all_of(s.gaps[i].begin(), s.gaps[i].end(), [](double gap) { return gap == 0.0; }))
      s.gaps[i].clear();
  return s;
}

struct BarDesignSolver::Implementation {
  /// Columns that are filled before a call of the kernel.
  static constexpr std::size_t kChunk = 256;

  InstructionSet set;
  Workspace workspace;
  Columns columns;
  std::vector<std::size_t> order;
  ThreadLoadBuffer buffer;

  void run(const BarDesigns& designs, const fe::NewtonOptions& options,
           const ThreadLoads& results) {
    double* const memory =
        workspace.reserve(workspace_size(designs.contacts, batch_size(set), designs.loads > 1));
    run_kernel(set, BarDesignKernel{}, designs, options, results, memory);
  }

  /// Calls done(from, contacts, to) for every load, its results being those of solve `from` in
  /// `buffer`.
  template <class Done>
  void run(std::span<const BarSector> sectors, std::span<const double> forces,
           const fe::NewtonOptions& options, Done done) {
    if (sectors.empty()) return;
    assert(forces.size() % sectors.size() == 0);
    const std::size_t loads = forces.size() / sectors.size();
    const auto kind = [&](std::size_t k) {
      return std::pair(sectors[k].contacts, compliant(sectors[k]));
    };
    order.resize(sectors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto ahead = [&](std::size_t a, std::size_t b) { return kind(a) < kind(b); };
    if (!std::is_sorted(order.begin(), order.end(), ahead))
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(kind(a), a) < std::pair(kind(b), b);
      });
    for (std::size_t first = 0; first < order.size();) {
      const auto [contacts, with_compliance] = kind(order[first]);
      columns.clear();
      std::size_t end = first;
      for (; end < order.size() && columns.size() < kChunk; ++end) {
        if (kind(order[end]) != kind(order[first])) break;
        columns.add(sectors[order[end]], forces.subspan(order[end] * loads, loads));
      }
      buffer.resize(columns.size() * loads, static_cast<std::size_t>(contacts));
      run(columns.view(contacts, with_compliance), options, buffer.view());
      for (std::size_t k = 0; k < columns.size() * loads; ++k)
        done(k, contacts, order[first + k / loads] * loads + k % loads);
      first = end;
    }
  }
};

BarDesignSolver::BarDesignSolver(InstructionSet set)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->set = set;
}
BarDesignSolver::~BarDesignSolver() = default;
BarDesignSolver::BarDesignSolver(BarDesignSolver&&) noexcept = default;
BarDesignSolver& BarDesignSolver::operator=(BarDesignSolver&&) noexcept = default;

void BarDesignSolver::solve(std::span<const BarSector> sectors, std::span<const double> forces,
                            std::span<LoadDistribution> results) {
  assert(results.size() == forces.size());
  Implementation& s = *implementation_;
  s.run(sectors, forces, options, [&](std::size_t from, int contacts, std::size_t to) {
    s.buffer.copy(from, contacts, options.residual_tolerance, results[to]);
  });
}

void BarDesignSolver::solve(std::span<const BarSector> sectors, std::span<const double> forces,
                            const ThreadLoads& results) {
  Implementation& s = *implementation_;
  s.run(sectors, forces, options, [&](std::size_t from, int contacts, std::size_t to) {
    s.buffer.copy(from, contacts, to, results);
  });
}

void BarDesignSolver::solve(const BarDesigns& designs, const ThreadLoads& results) {
  implementation_->run(designs, options, results);
}

}  // namespace prs
