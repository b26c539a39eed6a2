#include "prs/mechanism/full_distribution.h"

#include <fmt/format.h>

#include <Eigen/LU>

#include "prs/indices.h"
#include "prs/mechanism/full_structure.h"
#include "prs/mechanism/linearised.h"

namespace prs {
namespace {

using Eigen::VectorXd;
using fe::Equations;
using fe::State;

using fe::Dof;

/// Approach of a spring, in centre distances, beyond which nothing holds the load.
constexpr double kRunaway = 100.0;

/// Remaining shares of the axial force: a load is held below the first of them, up to rounding, and surely is not
/// beyond the second.
constexpr double kSurelyHeld = 1e-9, kSurelyNotHeld = 1e-6;

/// Most linear solves for a load that may have no equilibrium.
constexpr int kMostOfTrial = 30;

/// Smallest tangent used, as a share of that of equal shares.
constexpr double kLeastTangent = 1e-7;

/// Change of a contact's tangent up to which the last factorization still gives the stiffness of the next position, in
/// three refinements.
constexpr double kNearTangent = 1e-3;

/// Share of the mean load below which a thread or a roller carries nothing.
constexpr double kUnloaded = 1e-6;

/// k_0^(2/3) N^(1/3) with equal shares [N/m].
PerInterface<double> equal_share_secant(const FullModel& f) {
  const double threads = static_cast<double>(f.present.size()) * f.threads();
  PerInterface<double> secant;
  for (const Interface i : kInterfaces) {
    const double k = f.sector.hertz_constant[i];
    secant[i] = std::cbrt(k * k * f.axial_force / (threads * f.sector.cosine[i]));
  }
  return secant;
}

/// Number of both stops of each guide, numbered after the springs of the contacts.
std::size_t stops(const FullModel& f) { return f.sector.has_loose_guides() ? 8 * f.present.size() : 0; }

/// A value for each spring. Both stops of a guide act as one spring without a clearance.
std::vector<double> for_each_spring(const FullModel& f, const PerInterface<double>& value) {
  std::vector<double> values;
  for (std::size_t r = 0; r < f.present.size(); ++r)
    for (const Interface i : kInterfaces) values.insert(values.end(), static_cast<std::size_t>(f.threads()), value[i]);
  values.insert(values.end(), stops(f), 0.5 * f.sector.ring_guide().stiffness);
  return values;
}

fe::NewtonOptions newton_options(const FullModel& f) {
  fe::NewtonOptions options;
  options.force_scale = f.axial_force;
  options.length_scale = f.sector.roller_radius;
  options.largest_approach = kRunaway * f.centre_distance;
  const PerInterface<double> secant = equal_share_secant(f);
  options.least_tangent = kLeastTangent * 1.5 * std::min(secant.screw, secant.nut);
  return options;
}

/// A solved state and all results derived from it.
class Solution {
 public:
  Solution(const FullModel& f, const FullStructure& s, const Equations& equations, const State& q)
      : f_(f), s_(s), equations_(equations), q_(q) {
    const std::vector<double> elastic = equations.nodal_forces(q);
    needed_.assign(static_cast<std::size_t>(s.model.nodes) * fe::kDofsPerNode, 0.0);
    for (int node = 0; node < s.model.nodes; ++node)
      for (const Dof dof : {Dof::u, Dof::v, Dof::theta})
        if (const int n = equations.number(node, dof); n >= 0) needed(node, dof) = item_at(elastic, n);
    for (const auto k : indices(s.model.form_springs)) {
      const double force = equations.response(q, static_cast<int>(k)).force;
      for (const fe::Term& t : s.model.form_springs[k].approach) needed(t.node, t.dof) += t.coefficient * force;
    }
    for (const fe::NodalLoad& load : s.loads) needed(load.node, load.dof) -= load.value;
  }

  void read(FullDistribution& d) {
    read_loads(d);
    read_rings(d);
    read_supports(d);
    const SpatialNode& end = item_at(s_.screw, s_.loaded);
    const auto at = [&](int node, Dof dof) { return equations_.displacement(q_, node, dof); };
    const Lateral offset = rigid_offset(f_, end.x), slope = rigid_slope(f_);
    d.screw_end.displacement << at(end.y_plane, Dof::u), at(end.y_plane, Dof::v) + offset.y,
        at(end.z_plane, Dof::v) + offset.z, -(at(end.z_plane, Dof::theta) + slope.z),
        at(end.y_plane, Dof::theta) + slope.y;
    d.screw_end.displacement[0] += f_.sense() * f_.offset_compliance() * f_.axial_force;
    d.axial_displacement = f_.sense() * d.screw_end.displacement[0];
  }

 private:
  double& needed(int node, Dof dof) { return item_at(needed_, fe::kDofsPerNode * node + static_cast<int>(dof)); }

  void read_loads(FullDistribution& d) {
    const auto threads = static_cast<std::size_t>(f_.threads());
    for (const Interface i : kInterfaces)
      d.normal_load[i] = d.approach[i] =
          RollerThreads(static_cast<std::size_t>(f_.rollers), std::vector<double>(threads, 0.0));
    const double share = f_.axial_force / static_cast<double>(f_.present.size());
    for (const auto r : indices(s_.rollers)) {
      const auto number = static_cast<std::size_t>(f_.present[r].number);
      double carried = 0.0;
      for (const Interface i : kInterfaces)
        for (const auto k : up_to(threads)) {
          const int spring = s_.rollers[r].spring(i, k);
          const double force = equations_.response(q_, spring).force;
          d.normal_load[i][number][k] = force;
          d.approach[i][number][k] = equations_.law_approach(q_, spring);
          d.largest_opening[i] = std::max(d.largest_opening[i], -equations_.net_approach(q_, spring));
          if (i == Interface::screw) carried += force * f_.sector.cosine[i];
        }
      if (carried <= kUnloaded * share) d.idle_rollers.push_back(f_.present[r].number);
    }
  }

  /// Adds the forces of the guides on the rollers, and the reactions on their seats.
  void read_rings(FullDistribution& d) {
    for (const auto k : indices(d.rings)) {
      d.rings[k].position = outer_face(k);
      d.rings[k].rollers.assign(static_cast<std::size_t>(f_.rollers), 0.0);
    }
    if (f_.sector.has_loose_guides()) d.guides.resize(static_cast<std::size_t>(f_.rollers));
    std::size_t place = 0;  // Index among the four guides of a roller.
    for (const FullStructure::Guide& guide : s_.guides) {
      const FullModel::Roller& roller = f_.present[guide.roller];
      double force = 0.0;  // Force on the roller, outwards.
      if (guide.link >= 0) {
        force = -equations_.link_force(q_, guide.link);
        for (const fe::Term& t : item_at(s_.model.elastic_links, guide.link).form)
          needed(t.node, t.dof) -= t.coefficient * force;
      } else if (guide.constraint >= 0) {
        const fe::Constraint& c = item_at(s_.model.constraints, guide.constraint);
        force = needed(c.node, c.dof);
        for (const fe::Term& t : c.form) needed(t.node, t.dof) += t.coefficient * force;
      } else if (guide.stop >= 0) {
        const RingGuide ring = f_.sector.ring_guide();
        const double v = equations_.net_approach(q_, guide.stop) + ring.clearance;
        force = ring.force(v);
        GuideLoads& of = item_at(d.guides, roller.number);
        of.displacement[place % 4] = v;
        of.force[place++ % 4] = force;
      }
      add(d.rings[guide.ring], roller, force, guide.x - outer_face(guide.ring));
    }
    if (!f_.sector.bends()) read_straight_rollers(d);
  }

  /// Adds the transverse forces of straight rollers to the middles of both rings.
  void read_straight_rollers(FullDistribution& d) {
    const double near = f_.roller_ends.first + 0.5 * f_.sector.end_length;
    const double far = f_.roller_ends.last - 0.5 * f_.sector.end_length;
    for (const auto r : indices(s_.rollers)) {
      double force = 0.0, moment = 0.0;
      for (const auto k : indices(s_.rollers[r].nodes)) {
        const int node = s_.rollers[r].nodes[k];
        force += needed(node, Dof::v);
        moment += needed(node, Dof::v) * (s_.rollers[r].x[k] - near) + needed(node, Dof::theta);
      }
      const double at_far = moment / (far - near);
      add(d.rings[0], f_.present[r], force - at_far, near - outer_face(0));
      add(d.rings[1], f_.present[r], at_far, far - outer_face(1));
    }
  }

  double outer_face(std::size_t ring) const { return ring == 0 ? f_.roller_ends.first : f_.roller_ends.last; }
  /// Adds a force; `arm` is the arm of the force along x.
  static void add(RingForce& ring, const FullModel::Roller& roller, double force, double arm) {
    const double y = force * std::cos(roller.azimuth), z = force * std::sin(roller.azimuth);
    item_at(ring.rollers, roller.number) += force;
    ring.force.y += y;
    ring.force.z += z;
    ring.moment.y -= arm * z;
    ring.moment.z += arm * y;
  }

  /// Reads the springs first: they contribute to the force that a rigid support of their freedom must provide.
  void read_supports(FullDistribution& d) {
    const auto add_springs = [&](const FullStructure::Support& s) {
      for (const FullStructure::Held* held : {&s.u, &s.y, &s.z, &s.y_slope, &s.z_slope})
        if (held->link >= 0) needed(held->node, held->dof) += equations_.link_force(q_, held->link);
    };
    add_springs(s_.housing);
    for (const FullStructure::Support& bearing : s_.bearings) add_springs(bearing);
    d.nut = support(s_.housing);
    for (const FullStructure::Support& bearing : s_.bearings) d.bearings.push_back(support(bearing));
  }
  SupportForce support(const FullStructure::Support& s) {
    const auto force = [&](const FullStructure::Held& held) {
      if (held.link >= 0) return -equations_.link_force(q_, held.link);
      return held.constraint >= 0 ? needed(held.node, held.dof) : 0.0;
    };
    return {s.x, {force(s.u), force(s.y), force(s.z)}, {-force(s.z_slope), force(s.y_slope)}};
  }

  const FullModel& f_;
  const FullStructure& s_;
  const Equations& equations_;
  const State& q_;
  std::vector<double> needed_;  ///< External force that each freedom needs for equilibrium.
};

/// Condenses K and B'tB to the freedoms of the loaded section; false if K is singular to rounding.
bool condense(const FullModel& f, const FullStructure& s, const Equations& equations, fe::NewtonSolver& solver,
              const Linearised& linear, double near, FullDistribution& d) {
  const SpatialNode& end = item_at(s.screw, s.loaded);
  const std::array<fe::NodalLoad, 5> units{{{end.y_plane, Dof::u, 1.0},
                                            {end.y_plane, Dof::v, 1.0},
                                            {end.z_plane, Dof::v, 1.0},
                                            {end.z_plane, Dof::theta, -1.0},
                                            {end.y_plane, Dof::theta, 1.0}}};
  std::vector<VectorXd> loads;
  for (int k = 0; k < 5; ++k) {
    const fe::NodalLoad& unit = item_at(units, k);
    const int n = equations.number(unit.node, unit.dof);
    if (n < 0 || n >= equations.size()) continue;
    d.screw_end.freedoms.push_back(k);
    loads.push_back(equations.load_vector({unit}));
  }
  std::vector<VectorXd> rates;
  if (!solver.solve_linear(linear.tangent, loads, rates, near)) {
    d.screw_end.freedoms.clear();
    return false;
  }
  const auto count = static_cast<Eigen::Index>(loads.size());
  d.screw_end.compliance.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j) d.screw_end.compliance(i, j) = item_at(loads, i).dot(item_at(rates, j));
  d.screw_end.compliance(0, 0) += f.offset_compliance();
  d.screw_end.stiffness = d.screw_end.compliance.inverse();
  d.tangent_stiffness = 1.0 / axial_compliance(d.screw_end, f.load.eccentricity);
  return true;
}

std::string why_left_out(const FreeMotions& free) {
  return fmt::format("with the loaded threads alone a motion of {} meets no resistance", free.parts.front());
}

/// The structure with idle rollers pinned along the axis, where nothing holds them; they still bend between the rings.
FullStructure with_pinned(const FullModel& f, const std::vector<int>& idle_rollers,
                          const std::optional<FullMesh>& mesh = {}) {
  FullStructure s = full_structure(f, mesh);
  for (const auto r : indices(s.rollers))
    if (contains(idle_rollers, f.present[r].number))
      s.model.constraints.push_back({s.rollers[r].nodes.front(), Dof::u, {}, 0.0});
  return s;
}

/// Equations and their solver, for one model after the other.
struct Assembled {
  explicit Assembled(const fe::Model& model) : equations(model), newton(equations, 0.0) {}

  Equations equations;
  fe::NewtonSolver newton;
};

/// Takes a model; keeps numbering, pattern and symbolic factorization if only numbers differ.
Assembled& take(const fe::Model& model, std::unique_ptr<Assembled>& kept) {
  if (kept && kept->equations.take(model))
    kept->newton.equations_changed();
  else
    kept = std::make_unique<Assembled>(model);
  return *kept;
}

/// Adds the compliance, unless the loaded threads alone leave a motion free.
void add_compliance(const FullModel& f, const FullStructure& s, const Equations& equations, fe::NewtonSolver& solver,
                    std::unique_ptr<Assembled>& kept_pinned, double near, FullDistribution& d) {
  const Linearised linear = linearised(f, d);
  const auto with_near_nodes_joined = [&] {
    const FullStructure joined =
        with_pinned(f, d.idle_rollers, FullMesh{{}, {}, std::numeric_limits<double>::infinity()});
    Assembled of_joined(joined.model);
    if (!condense(f, joined, of_joined.equations, of_joined.newton, linear, near, d))
      d.screw_end.left_out = "the tangent is singular to rounding";
  };
  if (linear.all_closed()) {
    if (!condense(f, s, equations, solver, linear, near, d)) with_near_nodes_joined();
    return;
  }
  const FullStructure pinned = with_pinned(f, d.idle_rollers);
  if (const FreeMotions free = free_motions(f, pinned, linear.closed); free.count > 0) {
    d.screw_end.left_out = why_left_out(free);
    return;
  }
  Assembled* of_pinned = d.idle_rollers.empty() ? nullptr : &take(pinned.model, kept_pinned);
  const bool done = of_pinned ? condense(f, pinned, of_pinned->equations, of_pinned->newton, linear, near, d)
                              : condense(f, s, equations, solver, linear, near, d);
  if (!done) with_near_nodes_joined();
}

}  // namespace

Linearised linearised(const FullModel& f, const FullDistribution& d) {
  const double share = kUnloaded * f.axial_force / (static_cast<double>(f.rollers) * f.threads());
  Linearised l;
  for (const FullModel::Roller& r : f.present) {
    const bool idle = contains(d.idle_rollers, r.number);
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < static_cast<std::size_t>(f.threads()); ++k) {
        const auto j = static_cast<std::size_t>(r.number);
        const fe::PowerLawSpring law{f.sector.hertz_constant[i], 0.0, f.sector.contact_compliance(i, k)};
        const double approach = std::min(d.approach[i][j][k], fe::largest_deflection(law));
        l.tangent.push_back(idle ? 0.0 : fe::response_in_series(law, approach).tangent);
        l.closed.push_back(!idle && d.normal_load[i][j][k] * f.sector.cosine[i] > share);
      }
  }
  if (stops(f) == 0) return l;
  for (const FullModel::Roller& r : f.present)
    for (const double force : item_at(d.guides, r.number).force)
      for (const bool pushes : {force<0.0, force> 0.0}) {
        l.tangent.push_back(pushes ? f.sector.ring_guide().stiffness : 0.0);
        l.closed.push_back(pushes);
      }
  return l;
}

double axial_compliance(const ScrewEnd& end, const Lateral& eccentricity) {
  const std::array<double, 5> load{1.0, 0.0, 0.0, eccentricity.z, -eccentricity.y};
  double compliance = 0.0;
  for (const auto k : indices(end.freedoms))
    compliance += end.compliance(0, static_cast<Eigen::Index>(k)) * item_at(load, end.freedoms[k]);
  return compliance;
}

std::optional<FullDistribution> mechanism(const FullModel& f, const FullStructure& s) {
  const FreeMotions free = free_motions(f, s);
  if (free.count == 0) return std::nullopt;
  FullDistribution d;
  d.solve.status = fe::NewtonStatus::mechanism;
  d.reason = why_free(free);
  return d;
}

struct FullSolver::Parts {
  struct Solved {
    double force;  ///< Force along the axis, tension < 0 [N].
    State state;
  };

  std::unique_ptr<Assembled> assembled = {};
  std::unique_ptr<Assembled> pinned = {};  ///< Equations with idle rollers pinned, for the last load.
  std::vector<Solved> last = {};           ///< Earlier solutions, the latest at the end.

  /// State with the smallest residual.
  State best(std::vector<State> candidates, const VectorXd& load) const {
    const Equations& equations = assembled->equations;
    VectorXd residual(equations.size());
    const auto left = [&](const State& state) {
      equations.energy_and_residual(state, load, residual);
      return residual.cwiseAbs().maxCoeff();
    };
    return std::move(*std::ranges::min_element(candidates, {}, left));
  }
  /// State with the smallest residual among the latest one, those with the next forces below and above, and
  /// interpolations between them. None if there is no state.
  std::optional<State> nearest(double force, const VectorXd& load) const {
    if (last.empty()) return std::nullopt;
    const Solved *below = nullptr, *above = nullptr;
    for (const Solved& s : last) {
      if (s.force <= force && (!below || s.force > below->force)) below = &s;
      if (s.force > force && (!above || s.force < above->force)) above = &s;
    }
    std::vector<State> candidates{last.back().state};
    for (const Solved* s : {below, above})
      if (s) candidates.push_back(s->state);
    if (below && above) {
      const double share = (force - below->force) / (above->force - below->force);
      candidates.push_back(below->state);
      candidates.back().set_to_step(below->state, share, below->state.head - above->state.head);
    }
    return best(std::move(candidates), load);
  }
  /// The last state, or an extrapolation by a line or a parabola through the last ones, whichever has the smallest
  /// residual.
  std::optional<State> onwards(const VectorXd& load) const {
    const std::size_t n = last.size();
    if (n == 0) return std::nullopt;
    std::vector<State> candidates{last[n - 1].state};
    const auto ahead = [&](const VectorXd& step) {
      candidates.push_back(last[n - 1].state);
      candidates.back().set_to_step(last[n - 1].state, -1.0, step);
    };
    const auto change = [&](std::size_t k) -> VectorXd {
      return (last[n - k].state.head - last[n - k - 1].state.head) +
             (last[n - k].state.tail - last[n - k - 1].state.tail);
    };
    if (n > 1) ahead(change(1));
    if (n > 2) ahead(2.0 * change(1) - change(2));
    if (n > 3) ahead(3.0 * (change(1) - change(2)) + change(3));
    return best(std::move(candidates), load);
  }
  void keep(double force, const State& state) {
    constexpr std::size_t kFewest = 8, kNumbers = 4'000'000;
    const auto size = static_cast<std::size_t>(std::max(1, assembled->equations.size()));
    if (last.size() >= std::max(kFewest, kNumbers / size)) last.erase(last.begin());
    last.push_back({force, state});
  }
};

FullSolver::FullSolver(FullStart start) : start_(start) {}
FullSolver::~FullSolver() = default;
FullSolver::FullSolver(FullSolver&&) noexcept = default;
FullSolver& FullSolver::operator=(FullSolver&&) noexcept = default;

FullDistribution solve(const FullModel& f, Detail detail) { return FullSolver().solve(f, detail); }

FullDistribution FullSolver::solve(const FullModel& f, Detail detail) {
  FullStructure s = full_structure(f);
  const bool goes_on = start_ == FullStart::onwards && parts_;
  if (!goes_on)  // Supports and contacts stay unchanged.
    if (std::optional<FullDistribution> d = mechanism(f, s)) return *d;
  FullDistribution d;
  if (!parts_) parts_ = std::make_unique<Parts>();
  const Assembled* before = parts_->assembled.get();
  take(s.model, parts_->assembled);
  if (parts_->assembled.get() != before) parts_->last.clear();
  const Equations& equations = parts_->assembled->equations;
  fe::NewtonSolver& solver = parts_->assembled->newton;
  d.freedoms = equations.size();
  State q;
  const VectorXd load = equations.load_vector(s.loads);
  const double force = f.sense() * f.axial_force;
  const auto from_linear = [&] {
    if (!solver.start(load, for_each_spring(f, equal_share_secant(f)), q))
      q = State(VectorXd::Zero(equations.size()));  // The solver has more digits than this start.
  };
  if (std::optional<State> near = goes_on ? parts_->onwards(load) : parts_->nearest(force, load))
    q = std::move(*near);
  else
    from_linear();
  fe::NewtonOptions options = newton_options(f);
  if (!s.per_force.empty()) {
    q = parts_->last.back().state;
    if (!solver.follow({equations, load, s.per_force}, options, q)) return d;
    d.solve.status = fe::NewtonStatus::converged;
    parts_->keep(force, q);
    for (const auto k : indices(s.per_force))
      for (const fe::NodalLoad& of : s.per_force[k])
        s.loads.push_back({of.node, of.dof, equations.response(q, static_cast<int>(k)).force * of.value});
    Solution(f, s, equations, q).read(d);
    return d;
  }
  const bool is_trial = !f.push.empty() && f.push.front().is_trial;
  if (is_trial) options.max_iterations = kMostOfTrial;
  d.solve = solver.solve(load, options, q, [&] { return !is_trial && load_left(f, s) <= kSurelyNotHeld; });
  if (is_trial && !d.solve.converged()) return d;
  if (goes_on && !d.solve.converged() && !parts_->last.empty()) {
    parts_->last.clear();
    from_linear();
    d.solve = solver.solve(load, options, q, [&] { return load_left(f, s) <= kSurelyNotHeld; });
  }
  if (d.solve.status == fe::NewtonStatus::no_equilibrium && load_left(f, s) < kSurelyHeld) {
    // The supports are so soft that displacements are large.
    options.largest_approach = std::numeric_limits<double>::infinity();
    const fe::NewtonSummary near = std::move(d.solve);
    d.solve = solver.solve(load, options, q);
    d.solve.history.insert(d.solve.history.begin(), near.history.begin(), near.history.end());
    if (!d.solve.converged()) d.solve.status = fe::NewtonStatus::no_equilibrium;
  }
  d.solve.history.insert(d.solve.history.begin(), {d.solve.energy, 1.0, 1.0, 0.0});
  add_offset_energy(d.solve, f.offset_compliance(), f.axial_force);
  if (d.solve.status == fe::NewtonStatus::no_equilibrium) d.reason = why_not_held(f, s);
  if (!d.solve.converged()) return d;
  if (start_ != FullStart::linear) parts_->keep(force, q);
  Solution(f, s, equations, q).read(d);
  if (detail == Detail::complete)
    add_compliance(f, s, equations, solver, parts_->pinned, start_ == FullStart::onwards ? kNearTangent : 0.0, d);
  return d;
}

SymmetricLoads symmetric_loads(const FullModel& f) {
  SectorSolver solver(build_sector(f.sector));
  return symmetric_loads(f, solver.solve(f.axial_force));
}

SymmetricLoads symmetric_loads(const FullModel& f, const LoadDistribution& d) {
  SymmetricLoads s{d.axial_displacement, d.tangent_stiffness, {}};
  if (f.housing.axial < kRigid) {
    s.axial_displacement += f.axial_force / f.housing.axial;
    if (s.tangent_stiffness) s.tangent_stiffness = 1.0 / (1.0 / *s.tangent_stiffness + 1.0 / f.housing.axial);
  }
  for (const Interface i : kInterfaces) s.largest_normal_load[i] = std::ranges::max(d.normal_load[i]);
  return s;
}

namespace {

/// Difference of loads, relative, that is only rounding.
constexpr double kSameLoad = 1e-9;

class Collector {
 public:
  Collector(const FullModel& f, const SpatialLoad::Orbit& wanted) : f_(f) {
    orbit_.steps = wanted.steps;
    orbit_.positions = wanted.steps * f.rollers;
    orbit_.exponent = wanted.exponent;
    for (const Interface i : kInterfaces) {
      orbit_.loads[i].equivalent = orbit_.loads[i].peak = RollerThreads(
          static_cast<std::size_t>(f.rollers), std::vector<double>(static_cast<std::size_t>(f.threads()), 0.0));
      orbit_.loads[i].least = std::numeric_limits<double>::infinity();
    }
  }

  /// Adds the distribution, in which roller j has the load of roller j + shift.
  void add(const FullDistribution& d, int shift, double carrier_angle) {
    const double share = 1.0 / orbit_.positions;
    orbit_.carrier_angle.push_back(carrier_angle);
    for (const Interface i : kInterfaces) {
      OrbitLoads& loads = orbit_.loads[i];
      const int first = (f_.present.front().number + shift) % f_.rollers;
      loads.first_roller.push_back(std::ranges::max(item_at(d.normal_load[i], first)));
      for (const FullModel::Roller& r : f_.present) {
        const auto j = static_cast<std::size_t>(r.number);
        const auto from = static_cast<std::size_t>((r.number + shift) % f_.rollers);
        for (const auto k : indices(loads.equivalent[j])) {
          const double load = d.normal_load[i][from][k];
          loads.equivalent[j][k] += share * std::pow(load, orbit_.exponent);
          loads.peak[j][k] = std::max(loads.peak[j][k], load);
          loads.least = std::min(loads.least, load);
          if (load <= loads.largest * (1.0 + kSameLoad)) continue;
          loads.largest = load;
          loads.carrier_angle = carrier_angle;
          loads.roller = r.number + 1;
          loads.thread = static_cast<int>(k) + 1;
        }
      }
    }
  }

  Orbit finished(std::vector<double> displacement) && {
    for (const Interface i : kInterfaces)
      for (std::vector<double>& roller : orbit_.loads[i].equivalent)
        for (double& load : roller) {
          load = std::pow(load, 1.0 / orbit_.exponent);
          orbit_.loads[i].largest_equivalent = std::max(orbit_.loads[i].largest_equivalent, load);
        }
    const auto [least, largest] = std::ranges::minmax(displacement);
    orbit_.axial_error = largest - least;
    orbit_.axial_displacement = std::move(displacement);
    return std::move(orbit_);
  }

 private:
  const FullModel& f_;
  Orbit orbit_;
};

}  // namespace

Orbit orbit(const std::function<FullModel(double)>& model,
            const std::function<FullDistribution(const FullModel&)>& solver, const SpatialLoad::Orbit& wanted,
            double carrier_angle, OrbitSymmetry symmetry) {
  const FullModel first = model(carrier_angle);
  const int positions = wanted.steps * first.rollers;
  const auto angle = [&](int m) { return carrier_angle + 2.0 * std::numbers::pi * m / positions; };
  const int different = symmetry.alike ? wanted.steps : positions;
  const auto solved_at = [&](int m) { return static_cast<std::size_t>(symmetry.round ? 0 : m % different); };
  std::vector<FullDistribution> solved;
  std::vector<double> displacement;
  for (int m = 0; m < different; ++m) {
    if (solved_at(m) == solved.size()) solved.push_back(solver(model(angle(m))));
    if (const FullDistribution& d = solved.back(); !d.solve.converged()) {
      Orbit failed;
      failed.failure = {angle(m), d.reason.empty() ? std::string(fe::name(d.solve.status)) : d.reason};
      return failed;
    }
    displacement.push_back(solved[solved_at(m)].axial_displacement);
  }
  Collector collector(first, wanted);
  for (int m = 0; m < positions; ++m) collector.add(solved[solved_at(m)], symmetry.round ? 0 : m / different, angle(m));
  return std::move(collector).finished(std::move(displacement));
}

}  // namespace prs
