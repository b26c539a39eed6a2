#include "prs/preload/preload_solver.h"

#include <boost/math/tools/toms748_solve.hpp>

#include "prs/indices.h"
#include "prs/sector/roller_guides.h"

namespace prs {
namespace {

using Eigen::VectorXd;
using fe::NodalLoad;
using fe::State;

using fe::Dof;

fe::SpringElement& spring_of(PreloadSector& s, int k) { return s.model.springs[static_cast<std::size_t>(k)]; }

/// Support of a nut: the section, and the sense of the external load that rests on it.
struct Held {
  Direction sense;
  double section;
};

/// The sector whose contacts lie on the flanks of one direction, with its nut supported as given.
Sector sector_of(const PreloadParts& p, Structure structure, Direction flanks, const Held& held, double position) {
  const auto built = [&](Direction direction) {
    (direction == Direction::tension ? structure.nut.thrust.tension : structure.nut.thrust.compression) = held.section;
    return build_sector(p.mechanism, structure, p.materials, p.options, p.laws, direction, position, p.deviations);
  };
  Sector sector = built(held.sense);
  if (flanks == held.sense) return sector;
  Sector other = built(flanks);
  assert(sector.model.nodes == other.model.nodes && sector.screw_nodes == other.screw_nodes &&
         sector.roller_nodes == other.roller_nodes && sector.nut_nodes == other.nut_nodes);
  // The radius of the nut's nodes depends on its support.
  for (int k = 0; k < other.contacts(); ++k) {
    const auto spring = static_cast<std::size_t>(other.spring(Interface::nut, k));
    other.model.springs[spring].to = sector.model.springs[spring].to;
  }
  other.model.bars = sector.model.bars;
  other.model.shells = sector.model.shells;
  return other;
}

std::vector<int> screw_nodes(const Sector& s) {
  std::vector<int> nodes = s.screw_nodes;
  nodes.push_back(s.loaded_node);
  return nodes;
}

/// Side of a sector whose springs start at `first_spring` in the joint model.
Side side_of(const Sector& s, int first_spring) {
  Side side;
  for (const Interface i : kInterfaces)
    for (int k = 0; k < s.contacts(); ++k) side.springs[i].push_back(first_spring + s.spring(i, k));
  side.roller_nodes = s.roller_nodes;
  side.roller_nodes.insert(side.roller_nodes.end(), s.roller_end_nodes.begin(), s.roller_end_nodes.end());
  return side;
}

/// A flank whose nodes `number` maps to those of the joint model.
template <class Number>
PreloadSector::Flank flank_of(const Sector& s, Number number) {
  PreloadSector::Flank flank{std::make_shared<const Sector>(s), {}};
  for (int node = 0; node < s.model.nodes; ++node) flank.node.push_back(number(node));
  return flank;
}

PreloadSector single_nut(const PreloadParts& p, const Held& held) {
  Sector pulled = sector_of(p, p.structure, Direction::tension, held, p.preload.position);
  const Sector pushed = sector_of(p, p.structure, Direction::compression, held, p.preload.position);

  PreloadSector s;
  s.flanks = {flank_of(pulled, std::identity{}), flank_of(pushed, std::identity{})};
  s.sides.tension = side_of(pulled, 0);
  s.sides.compression = side_of(pushed, static_cast<int>(pulled.model.springs.size()));
  s.screw_nodes = screw_nodes(pulled);
  s.loaded_node = pulled.loaded_node;
  s.model = std::move(pulled.model);
  s.model.springs.insert(s.model.springs.end(), pushed.model.springs.begin(), pushed.model.springs.end());
  return s;
}

/// The node at an end of the nut, reached over its bars or shells from a contact.
int nut_end(const Sector& s, int node, bool far) {
  const auto next = [&](const auto& elements, int from) {
    for (const auto& e : elements)
      if ((far ? e.first : e.second) == from) return far ? e.second : e.first;
    return -1;
  };
  for (int reached = node; reached >= 0;) {
    node = reached;
    reached = std::max(next(s.model.bars, node), next(s.model.shells, node));
  }
  return node;
}

/// Adds a model whose nodes `number` maps to those of the joint model.
template <class Number>
void append(fe::Model& whole, const fe::Model& part, Number number) {
  for (const fe::BarElement& e : part.bars) whole.bars.push_back({number(e.first), number(e.second), e.bar});
  for (const fe::BeamElement& e : part.beams) whole.beams.push_back({number(e.first), number(e.second), e.beam});
  for (const fe::ShellElement& e : part.shells)
    whole.shells.push_back({number(e.first), number(e.second), e.stiffness});
  for (fe::SpringElement e : part.springs) {
    e.from.node = number(e.from.node);
    e.to.node = number(e.to.node);
    whole.springs.push_back(e);
  }
  for (fe::FormSpring s : part.form_springs) {
    for (fe::Term& term : s.approach) term.node = number(term.node);
    whole.form_springs.push_back(std::move(s));
  }
  for (const fe::ElasticSupport& s : part.elastic_supports)
    whole.elastic_supports.push_back({number(s.node), s.dof, s.stiffness});
  for (const fe::FixedSupport& s : part.fixed_supports) whole.fixed_supports.push_back({number(s.node), s.dof});
}

/// The second nut, without support, on a screw that starts at the last contact of the first.
Sector free_second_nut(const PreloadParts& p) {
  Structure structure = p.structure;
  structure.screw.free_length = *p.preload.distance;
  structure.nut.flanges.clear();
  structure.nut.shoulder.reset();
  Sector second = sector_of(p, structure, Direction::tension, {Direction::tension, 0.0},
                            second_position(p.mechanism, p.structure.nut, p.preload));
  const int near = nut_end(second, second.nut_nodes.front(), false);
  std::erase_if(second.model.fixed_supports,
                [&](const fe::FixedSupport& support) { return support.node == near && support.dof == Dof::u; });
  return second;
}

PreloadSector double_nut(const PreloadParts& p, const Held& held) {
  Sector first = sector_of(p, p.structure, Direction::compression, held, p.preload.position);
  const Sector second = free_second_nut(p);
  const int first_node = first.model.nodes;
  const auto number = [&](int node) {
    return node == second.loaded_node ? first.screw_nodes.back() : first_node + node;
  };
  const auto numbered = [&](std::vector<int> nodes) {
    std::ranges::transform(nodes, nodes.begin(), number);
    return nodes;
  };

  PreloadSector s;
  s.arrangement = Preload::Arrangement::double_nut;
  s.flanks = {flank_of(second, number), flank_of(first, std::identity{})};
  s.sides.compression = side_of(first, 0);
  s.sides.tension = side_of(second, static_cast<int>(first.model.springs.size()));
  s.sides.tension.roller_nodes = numbered(s.sides.tension.roller_nodes);
  s.screw_nodes = screw_nodes(first);
  for (const int node : numbered(second.screw_nodes)) s.screw_nodes.push_back(node);
  s.loaded_node = first.loaded_node;

  const Spacer& spacer = *p.preload.spacer;
  const double rigidity = p.materials.nut.youngs_modulus * ring_area(spacer.outer_diameter, spacer.inner_diameter) /
                          loaded_rollers(p.mechanism);
  const int from = nut_end(first, first.nut_nodes.back(), true);
  const int to = number(nut_end(second, second.nut_nodes.front(), false));
  s.model = std::move(first.model);
  s.model.nodes += second.model.nodes;
  append(s.model, second.model, number);
  s.model.bars.push_back({from, to, {rigidity, spacer.length}});
  return s;
}

/// See `build_preload_sector`.
void add_expansion(PreloadSector& s, const PreloadParts& p) {
  const Deviations& d = p.deviations;
  const auto strain = [&](Part part) {
    const double rise = (*d.temperature)[part] - d.reference_temperature;
    return p.materials[part].thermal_expansion.value_or(0.0) * rise;
  };
  const auto growth = [&](Part part) { return strain(part) * 0.5 * p.mechanism.pitch_diameter[part].value(); };
  const double pitch = axial_pitch(p.mechanism);
  const double middle = 0.5 * (p.mechanism.contacts_per_roller - 1) * pitch;
  const bool shared = p.preload.arrangement == Preload::Arrangement::single_nut;
  for (const Direction side : kDirections)
    for (const Interface i : kInterfaces) {
      const bool screw = i == Interface::screw;
      const double ahead = screw ? 1.0 : -1.0, psi = p.laws[i].normal_angle;
      const double stretch = ahead * (strain(body_of(i)) - strain(Part::roller));
      const double closing = growth(Part::roller) + ahead * growth(body_of(i));
      // The second nut follows the first one.
      const double first =
          !shared && side == Direction::tension ? 2.0 * middle + *p.preload.distance - middle : -middle;
      for (const auto k : indices(s.sides[side].springs[i]))
        spring_of(s, s.sides[side].springs[i][k]).law.gap +=
            -sense(side) * std::cos(psi) * stretch * (first + static_cast<double>(k) * pitch) - std::sin(psi) * closing;
      if (shared && side == Direction::tension) s.expansion += closing;
      if (!shared) s.expansion += std::tan(psi) * closing + sense(side) * stretch * (first + middle);
    }
}

constexpr int kRootBits = 44;
constexpr boost::uintmax_t kMostEvaluations = 100;
constexpr double kStep = 1.5;  ///< Factor of the search for a bracket.

/// Largest load, over half the preload, at which the opening of a side is searched.
constexpr double kMostOpening = 2000.0;
/// Largest interference of deformable bodies, as a multiple of that of rigid bodies.
constexpr double kMostInterference = 1e12;

/// Root of an increasing function between two places with f(low) <= 0 <= f(high).
template <class F>
double root_between(const F& f, double low, double high) {
  const double at_low = f(low), at_high = f(high);
  if (at_low >= 0.0) return low;
  if (at_high <= 0.0) return high;
  boost::uintmax_t evaluations = kMostEvaluations;
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(kRootBits), evaluations);
  return 0.5 * (a + b);
}

/// The first root between `low` > 0, a place below the root, and `times` times `low`. NaN if there is none.
template <class F>
double root_above(const F& f, double low, double times) {
  const double most = low * times;
  for (double high = kStep * low; low < most; low = high, high *= kStep)
    if (f(high) >= 0.0) return root_between(f, low, high);
  return std::numeric_limits<double>::quiet_NaN();
}

/// Hertz approach of each thread if all share an axial load of the whole mechanism [m].
double equal_approach(const PreloadSector& s, Interface i, double axial_load) {
  const double threads = s.rollers * static_cast<double>(s.sides.tension.springs[i].size());
  const double cosine = std::cos(s.laws[i].normal_angle);
  return std::pow(axial_load / (threads * cosine * s.laws[i].hertz_constant), 2.0 / 3.0);
}

/// Interference that gives the axial load if nothing but the contacts deforms [m].
double rigid_interference(const PreloadSector& s, double axial_load) {
  double sum = 0.0;
  for (const Interface i : kInterfaces) {
    const double psi = s.laws[i].normal_angle;
    // A wedged roller floats: its radial loads are in balance, not its axial ones.
    const double load =
        s.rollers_are_shared() ? axial_load * std::tan(s.laws.screw.normal_angle) / std::tan(psi) : axial_load;
    const double along = s.rollers_are_shared() ? std::sin(psi) : 0.5 * std::cos(psi);
    sum += equal_approach(s, i, load) / along;
  }
  return sum;
}

/// A single nut's fit for the whole interference, with floating rollers between screw and nut.
Fit afloat(const PreloadSector& s, double interference) {
  const auto fit = [&](double screw) { return Fit{{screw, interference - screw}, 0.0}; };
  const auto imbalance = [&](double screw) {
    const PreloadSolver solver(fitted(s, fit(screw)));
    PerInterface<double> radial;
    for (const Interface i : kInterfaces)
      for (const Direction d : kDirections)
        radial[i] += solver.at_rest().sides[d].axial_load[i] * std::tan(s.laws[i].normal_angle);
    return std::cbrt(radial.screw * radial.screw) - std::cbrt(radial.nut * radial.nut);
  };
  // Interference from which expansion alone, which opens or closes an interface, leaves none of its overlap.
  const auto closed = [&](Interface i) {
    double most = -std::numeric_limits<double>::infinity();
    for (const Direction d : kDirections)
      for (const int k : s.sides[d].springs[i])
        most = std::max(most, -s.model.springs[static_cast<std::size_t>(k)].law.gap);
    return most / std::sin(s.laws[i].normal_angle);
  };
  return fit(root_between(imbalance, -closed(Interface::screw), interference + closed(Interface::nut)));
}

Fit fit_of(const PreloadSector& s, double interference) {
  return s.rollers_are_shared() ? afloat(s, interference) : Fit{{}, interference};
}

Fit play(const PreloadSector& s, double backlash) {
  if (!s.rollers_are_shared()) return {{}, -backlash};
  Fit fit;
  for (const Interface i : kInterfaces) fit.radial[i] = -0.25 * backlash / std::tan(s.laws[i].normal_angle);
  return fit;
}

}  // namespace

PreloadSector build_preload_sector(const PreloadParts& given, Direction sense, double section, Play play) {
  const Held held{sense, section};
  Deviations cold = given.deviations;
  const bool expands = cold.temperature && play == Play::of_cold_parts;
  if (expands) cold.temperature.reset();
  const PreloadParts parts{given.mechanism, given.structure, given.materials, given.options, given.laws, cold,
                           given.preload};
  PreloadSector s =
      parts.preload.arrangement == Preload::Arrangement::single_nut ? single_nut(parts, held) : double_nut(parts, held);
  if (expands) add_expansion(s, given);
  s.laws = parts.laws;
  s.rollers = loaded_rollers(parts.mechanism);
  s.roller_radius = 0.5 * *parts.mechanism.pitch_diameter.roller;
  return s;
}

PreloadSector fitted(PreloadSector s, const Fit& fit) {
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces) {
      const double psi = s.laws[i].normal_angle;
      const bool at_spacer = !s.rollers_are_shared() && d == Direction::tension && i == Interface::nut;
      const double overlap = s.rollers_are_shared() ? fit.radial[i] * std::sin(psi)
                             : at_spacer            ? fit.axial * std::cos(psi)
                                                    : 0.0;
      for (const int k : s.sides[d].springs[i]) spring_of(s, k).law.gap -= overlap;
    }
  s.fit = fit;
  return s;
}

std::vector<NodalLoad> push_loads(const PreloadSector& s, const PerDirection<RollerPush>& push) {
  std::vector<NodalLoad> loads;
  for (const Direction d : kDirections)
    for (NodalLoad load : push_loads(*s.flanks[d].sector, push[d])) {
      load.node = s.flanks[d].node[static_cast<std::size_t>(load.node)];
      loads.push_back(load);
    }
  return loads;
}

PreloadSector one_sided(PreloadSector s, Direction carrying) {
  const Side& open = s.sides[opposite(carrying)];
  for (const Interface i : kInterfaces)
    for (const int k : open.springs[i]) spring_of(s, k).law.stiffness = 0.0;
  if (!s.rollers_are_shared()) s.model.fixed_supports.push_back({open.roller_nodes.front(), Dof::u});
  return s;
}

/// One set of equations: with both sides loaded, or one of them alone.
class PreloadSolver::Branch {
 public:
  explicit Branch(PreloadSector sector)
      : sector_(std::move(sector)),
        equations_(sector_.model),
        newton_(equations_),
        pull_(equations_.load_vector({{sector_.loaded_node, Dof::u, sense(Direction::tension)}})) {}

  fe::NewtonSummary solve(double axial_force, double force_scale, State& q,
                          const std::vector<NodalLoad>& further = {}) {
    fe::NewtonOptions options;
    options.force_scale = force_scale / sector_.rollers;
    options.length_scale = sector_.roller_radius;
    return newton_.solve(axial_force / sector_.rollers * pull_ + equations_.load_vector(further), options, q);
  }

  /// State of rigid bodies, each side compressed equally.
  State rest_start() const {
    VectorXd q = VectorXd::Zero(equations_.size());
    const double quarter = 0.25 * sector_.fit.axial;
    set(q, sector_.screw_nodes, 2.0 * quarter);
    set(q, sector_.sides.tension.roller_nodes, 3.0 * quarter);
    set(q, sector_.sides.compression.roller_nodes, quarter);
    return State(std::move(q));
  }

  /// State of rigid bodies with the load shared equally by the threads of one side.
  State start(double axial_force, Direction carrying) const {
    const auto shift = [&](Interface i) {
      double widest = -std::numeric_limits<double>::infinity();
      for (const int k : sector_.sides[carrying].springs[i]) widest = std::max(widest, law(k).gap);
      return sense(carrying) * (equal_approach(sector_, i, std::abs(axial_force)) + widest) /
             std::cos(sector_.laws[i].normal_angle);
    };
    const double roller = shift(Interface::nut);
    VectorXd q = VectorXd::Zero(equations_.size());
    set(q, sector_.sides[carrying].roller_nodes, roller);
    set(q, sector_.screw_nodes, roller + shift(Interface::screw));
    return State(std::move(q));
  }

  /// Displacement of the loaded section, > 0 in tension [m].
  double displacement(const State& q) const { return pull_.dot(q.head) + pull_.dot(q.tail); }

  std::optional<double> tangent_stiffness(const State& q) {
    VectorXd rate(equations_.size());
    if (!newton_.solve_tangent(q, pull_, rate)) return std::nullopt;
    return sector_.rollers / pull_.dot(rate);
  }

  SideLoads loads(const State& q, Direction side) const {
    SideLoads loads;
    for (const Interface i : kInterfaces) {
      double sum = 0.0;
      for (const int k : sector_.sides[side].springs[i]) {
        const double normal = equations_.response(q, k).force;
        sum += normal;
        loads.normal_load[i].push_back(normal);
        loads.max_normal_load[i] = std::max(loads.max_normal_load[i], normal);
      }
      loads.axial_load[i] = sector_.rollers * std::cos(sector_.laws[i].normal_angle) * sum;
    }
    return loads;
  }

  std::vector<GuideLoads> guides(const State& q) const {
    std::vector<GuideLoads> all;
    for (const Direction d : kDirections) {
      const PreloadSector::Flank& flank = sector_.flanks[d];
      if (!flank.sector->has_loose_guides() || (sector_.rollers_are_shared() && !all.empty())) continue;
      const auto node = [&](int of_sector) { return flank.node[static_cast<std::size_t>(of_sector)]; };
      all.push_back(guide_loads(*flank.sector, equations_, q, node));
    }
    return all;
  }

  /// Overlap of a side at its closest threads [m]; the side is open if < 0. The rollers of a double nut carry the load
  /// from the screw to the nut: there the overlaps of both interfaces add.
  double overlap(const State& q, Direction side) const {
    PerInterface<double> closest;
    for (const Interface i : kInterfaces) {
      closest[i] = -std::numeric_limits<double>::infinity();
      for (const int k : sector_.sides[side].springs[i])
        closest[i] = std::max(closest[i], equations_.net_approach(q, k));
      closest[i] /= std::cos(sector_.laws[i].normal_angle);
    }
    return sector_.rollers_are_shared() ? std::max(closest.screw, closest.nut) : closest.screw + closest.nut;
  }

 private:
  const fe::PowerLawSpring& law(int k) const { return sector_.model.springs[static_cast<std::size_t>(k)].law; }
  void set(VectorXd& q, const std::vector<int>& nodes, double u) const {
    for (const int node : nodes)
      if (const int n = equations_.number(node, Dof::u); n >= 0) q[n] = u;
  }

  PreloadSector sector_;
  fe::Equations equations_;
  fe::NewtonSolver newton_;
  VectorXd pull_;
};

PreloadSolver::PreloadSolver(PreloadSector sector) : sector_(std::move(sector)) {
  const double overlap = interference(sector_, sector_.fit) + sector_.expansion;
  preloaded_ = overlap > 0.0;
  rest_.solve.status = fe::NewtonStatus::converged;
  if (!preloaded_) return;
  // Interference of rigid bodies, as a scale.
  const double unit = rigid_interference(sector_, 1.0);
  rest_state_ = both().rest_start();
  rest_.solve = both().solve(0.0, std::pow(overlap / unit, 1.5), rest_state_);
  for (const Direction d : kDirections) rest_.sides[d] = both().loads(rest_state_, d);
  rest_.guides = both().guides(rest_state_);
  if (rest_.solve.converged()) rest_.tangent_stiffness = both().tangent_stiffness(rest_state_);
}

PreloadSolver::PreloadSolver(PreloadSolver&&) noexcept = default;
PreloadSolver::~PreloadSolver() = default;

PreloadSolver::Branch& PreloadSolver::both() {
  if (!both_) both_ = std::make_unique<Branch>(sector_);
  return *both_;
}

PreloadSolver::Branch& PreloadSolver::branch(Direction carrying) {
  if (!one_[carrying]) one_[carrying] = std::make_unique<Branch>(one_sided(sector_, carrying));
  return *one_[carrying];
}

double PreloadSolver::force_scale(double axial_force) const {
  return std::max(std::abs(axial_force), rest_.sides.tension.axial_load.screw);
}

void PreloadSolver::set_point(Branch& at_work, PreloadPoint& point) {
  if (!point.solve.converged()) return;
  point.axial_displacement = at_work.displacement(last_state_) - (preloaded_ ? both().displacement(rest_state_) : 0.0);
  point.tangent_stiffness = at_work.tangent_stiffness(last_state_);
  for (const Direction d : kDirections) point.sides[d] = at_work.loads(last_state_, d);
  point.guides = at_work.guides(last_state_);
}

PreloadPoint PreloadSolver::solve(double axial_force) {
  if (axial_force == 0.0 || !rest_.solve.converged()) {
    last_ = preloaded_ ? &both() : nullptr;
    last_state_ = rest_state_;
    return rest_;
  }
  const Direction sense = axial_force > 0.0 ? Direction::tension : Direction::compression;
  const double scale = force_scale(axial_force);
  PreloadPoint point;
  point.axial_force = axial_force;
  last_ = &branch(sense);
  last_state_ = last_->start(axial_force, sense);
  point.solve = last_->solve(axial_force, scale, last_state_);
  // Even without preload a bent roller may touch the flanks behind it.
  if (!point.solve.converged() || last_->overlap(last_state_, opposite(sense)) > 0.0) {
    last_ = &both();
    last_state_ = preloaded_ ? rest_state_ : last_->start(axial_force, sense);
    point.solve = last_->solve(axial_force, scale, last_state_);
  }
  set_point(*last_, point);
  return point;
}

PreloadPoint PreloadSolver::go_on(double axial_force, const std::vector<NodalLoad>& further) {
  // Friction may close the other flank of a roller; a loose second roller has no defined position.
  if (sector_.rollers_are_shared()) last_ = &both();
  PreloadPoint point;
  point.axial_force = axial_force;
  point.solve = last_->solve(axial_force, force_scale(axial_force), last_state_, further);
  set_point(*last_, point);
  return point;
}

std::optional<double> PreloadSolver::opening_force(Direction sense) {
  if (!preloaded_ || !rest_.solve.converged()) return std::nullopt;
  if (opening_[sense]) return opening_[sense];
  Branch& b = branch(sense);
  bool solved = true;
  const auto clearance = [&](double force) {
    State q = b.start(force, sense);
    const double signed_force = sense == Direction::tension ? force : -force;
    solved = b.solve(signed_force, force_scale(force), q).converged() && solved;
    return -b.overlap(q, opposite(sense));
  };
  // The loaded side carries at least the preload that it held against the other side.
  const double opening = root_above(clearance, 0.5 * rest_.sides[sense].axial_load.screw, kMostOpening);
  if (solved && std::isfinite(opening)) opening_[sense] = opening;
  return opening_[sense];
}

Fit find_fit(const PreloadSector& sector, const Preload& preload) {
  if (preload.backlash) return play(sector, *preload.backlash);
  if (preload.interference) return fit_of(sector, *preload.interference);
  const double wanted = std::cbrt(*preload.force * *preload.force);
  const auto surplus = [&](double interference) {
    const PreloadSolver solver(fitted(sector, fit_of(sector, interference)));
    const double load = solver.at_rest().sides.tension.axial_load.screw;
    return std::cbrt(load * load) - wanted;
  };
  const double rigid = rigid_interference(sector, *preload.force);
  return fit_of(sector, root_above(surplus, 0.5 * rigid, kMostInterference));
}

Fit at_temperature(const PreloadSector& s, const Fit& fit) {
  const double cold = interference(s, fit);
  return s.rollers_are_shared() && cold + s.expansion > 0.0 ? afloat(s, cold) : fit;
}

double interference(const PreloadSector& sector, const Fit& fit) {
  return sector.rollers_are_shared() ? fit.radial.screw + fit.radial.nut : fit.axial;
}

}  // namespace prs
