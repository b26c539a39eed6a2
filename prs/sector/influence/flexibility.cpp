#include "prs/sector/influence/flexibility.h"

#include "fe/lu.h"
#include "prs/indices.h"
#include "prs/sector/influence/teeth.h"

namespace prs {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using fe::MeridianEdge;

using Eigen::Index;
using fe::Component;

/// Loaded flank of each part: the screw pushes the roller along the load, the roller the nut.
FlankSide pushing_flank(Direction d) { return d == Direction::tension ? FlankSide::backward : FlankSide::forward; }
FlankSide pushed_flank(Direction d) { return d == Direction::tension ? FlankSide::forward : FlankSide::backward; }

/// Loaded flanks whose pitch points lie at `first`, `first` + pitch, ..
std::vector<LoadedFlank> loaded_flanks(const Groove& g, double first, int contacts, FlankSide side,
                                       const HertzPatch& patch, int cells) {
  std::vector<LoadedFlank> flanks;
  for (int k = 0; k < contacts; ++k)
    flanks.push_back({first + k * g.pitch - g.position(side, 0.0), side, patch, cells});
  return flanks;
}

/// The flanks; with friction once more with loads along them.
std::vector<LoadedFlank> with_friction(const BodyGeometry& b, std::vector<LoadedFlank> flanks) {
  const std::size_t normal = flanks.size();
  for (std::size_t k = 0; b.friction && k < normal; ++k) flanks.emplace_back(flanks[k]).tangential = true;
  return flanks;
}

/// Nodes sorted by radius, innermost first.
std::vector<int> by_radius(const GroovedBody& body, std::vector<int> nodes) {
  const auto radius = [&](int node) { return item_at(body.mesh.nodes, node).x(); };
  std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return radius(a) < radius(b); });
  return nodes;
}

std::vector<fe::HarmonicSupport> axial_supports(const std::vector<int>& nodes) {
  std::vector<fe::HarmonicSupport> supports;
  for (const int node : nodes) supports.push_back({node, Component::axial});
  return supports;
}

/// Elastic constants of a material, on which alone the flexibilities depend.
Material elastic(const Material& m) { return {m.youngs_modulus, m.poisson_ratio, {}, {}}; }

/// Axial force of each load [N].
Eigen::RowVectorXd axial_resultants(const MatrixXd& loads) {
  Eigen::RowVectorXd force = Eigen::RowVectorXd::Zero(loads.cols());
  for (Index row = static_cast<Index>(Component::axial); row < loads.rows(); row += fe::kComponents)
    force += loads.row(row);
  return force;
}

/// Thrust face of a body, harmonic 0, that rests with `nodes` on a shoulder.
ThrustFace thrust_face(const GroovedBody& body, const Material& material, const std::vector<int>& nodes) {
  fe::HarmonicBody solver(body.mesh, isotropic(material), 0, axial_supports({nodes.front()}));
  const MatrixXd loads = patch_loads(body, 0);
  const auto count = static_cast<Index>(nodes.size()), ends = loads.cols();
  MatrixXd all = MatrixXd::Zero(loads.rows(), count + ends);
  for (Index k = 1; k < count; ++k) all(fe::row_of(item_at(nodes, k), Component::axial), k) = 1.0;
  all.rightCols(ends) = loads;
  const MatrixXd g = flexibility_of(solver, 0, all);
  return {g.topLeftCorner(count, count), g.topRightCorner(count, ends), g.bottomRightCorner(ends, ends),
          axial_resultants(loads).transpose()};
}

/// Edges of a section up to a radius.
std::vector<MeridianEdge> within(const GroovedBody& body, const std::vector<MeridianEdge>& edges, double radius) {
  std::vector<MeridianEdge> inner;
  for (const MeridianEdge& e : edges)
    if (item_at(body.mesh.nodes, e[2]).x() < radius) inner.push_back(e);
  return inner;
}

/// A spring on the mean sideways displacement of a section.
fe::HarmonicSpring sideways_spring(const GroovedBody& body, const std::vector<MeridianEdge>& section,
                                   double stiffness) {
  const VectorXd weight = transverse_force(body, section);
  fe::HarmonicSpring spring;
  spring.stiffness = stiffness;
  for (const int node : nodes_of(section))
    for (const Component c : {Component::radial, Component::circumferential})
      spring.terms.push_back({node, c, weight[fe::row_of(node, c)]});
  return spring;
}

/// Sections of the plain ends: outer and inner of the first, inner and outer of the last.
std::vector<std::vector<MeridianEdge>> end_sections(const GroovedBody& body) {
  const GroovedShape& s = body.shape;
  const double l = s.plain_end->length;
  std::vector<std::vector<MeridianEdge>> sections;
  for (const double z : {s.start - l, s.start, s.end, s.end + l})
    sections.push_back(within(body, body.section(z), s.plain_end->radius));
  return sections;
}

/// Adds lateral supports of the roller, on whole sections that stay round.
void add_guidance(const GroovedBody& body, const Guidance& guidance, std::vector<fe::HarmonicSupport>& supports,
                  std::vector<fe::HarmonicSpring>& springs) {
  const auto sections = end_sections(body);
  std::vector<std::size_t> guided{0, 3};
  if (guidance.kind != Guidance::Kind::outer_node) guided.insert(guided.end(), {1, 2});
  for (const std::size_t k : guided) {
    const std::vector<MeridianEdge>& edges = sections[k];
    if (guidance.kind == Guidance::Kind::ring) {
      springs.push_back(sideways_spring(body, edges, guidance.ring_stiffness));
      continue;
    }
    for (const MeridianEdge& e : edges) {
      fe::add_support(supports, e, Component::radial);
      fe::add_support(supports, e, Component::circumferential);
    }
  }
}

/// Whether the matrix has one entry per pair of flanks.
bool is_square(const LoadedBody& b, const MatrixCache::Matrices& m) {
  const auto flanks = static_cast<Index>(b.flanks.size());
  return have_sizes(m, {{flanks, flanks}});
}

/// Flexibility of a body that is held at its start.
MatrixCache::Matrices held_at_start(const LoadedBody& b) {
  const GroovedBody body = b.meshed();
  fe::HarmonicBody solver(body.mesh, isotropic(b.material), 0, axial_supports(nodes_of(body.section(b.shape.start))));
  return {flexibility_of(solver, 0, patch_loads(body, 0))};
}

}  // namespace

BodyGeometry body_geometry(const Mechanism& m, const Structure& structure, const Materials& materials,
                           const PerInterface<ContactLaw>& laws, const PerInterface<HertzPatch>& patches,
                           Direction direction, const ModelOptions& model) {
  BodyGeometry b;
  b.roller_contacts = roller_contacts(model, m.starts.roller);
  b.endless_screw = carrier_part(m.type) == Part::nut;
  b.materials = materials;
  b.structure = structure;
  b.rollers = loaded_rollers(m);
  b.contacts = m.contacts_per_roller;
  for (const Part p : kParts) {
    const auto angle = [&](FlankSide side) {
      const bool at_screw = p == Part::roller ? pushed_flank(direction) == side : p == Part::screw;
      return (at_screw ? laws.screw : laws.nut).normal_angle;
    };
    b.grooves[p] = default_groove(p == Part::nut, axial_pitch(m), 0.5 * *m.pitch_diameter[p],
                                  angle(FlankSide::backward), angle(FlankSide::forward));
    if (m.thread[p]) {
      b.grooves[p].addendum = m.thread[p]->addendum;
      b.grooves[p].dedendum = m.thread[p]->dedendum;
    }
  }
  b.patches.screw = fitted(fitted(patches.screw, b.grooves.screw), b.grooves.roller);
  b.patches.nut = fitted(fitted(patches.nut, b.grooves.nut), b.grooves.roller);
  return b;
}

std::vector<int> nodes_of(const std::vector<MeridianEdge>& edges) {
  std::vector<int> nodes;
  for (const MeridianEdge& e : edges) append(nodes, e);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Nodal loads of a traction on a section, in harmonic 1.
template <class Traction>
VectorXd section_load(const GroovedBody& body, const std::vector<MeridianEdge>& section, Traction traction) {
  VectorXd load = VectorXd::Zero(fe::kComponents * body.mesh.size());
  for (const MeridianEdge& e : section) fe::add_edge_load(body.mesh, e, 1, traction, load);
  return load;
}

VectorXd transverse_force(const GroovedBody& body, const std::vector<MeridianEdge>& section) {
  const VectorXd load = section_load(body, section, [](double, double) { return Eigen::Vector3d(1.0, -1.0, 0.0); });
  return load / load.cwiseAbs().sum();
}

VectorXd turning_moment(const GroovedBody& body, const std::vector<MeridianEdge>& section) {
  const VectorXd load = section_load(body, section, [](double r, double) { return Eigen::Vector3d(0.0, 0.0, -r); });
  double turned = 0.0;
  for (const int node : nodes_of(section))
    turned -= load[fe::row_of(node, Component::axial)] * item_at(body.mesh.nodes, node).x();
  return load / turned;
}

Teeth teeth_of(const BodyGeometry& b, Part part, Direction direction, const FlexibilityOptions& options) {
  const bool screw = part == Part::screw;
  const LoadedFlank flank{0.0, screw ? pushing_flank(direction) : pushed_flank(direction),
                          screw ? b.patches.screw : b.patches.nut, options.mesh.patch_cells};
  const double far = 0.5 * (screw ? b.structure.screw.bore : b.structure.nut.outer_diameter);
  return {b.grooves[part],
          far,
          elastic(b.materials[part]),
          with_friction(b, {flank}),
          std::vector<bool>(b.friction ? 2 : 1, false),
          b.rollers,
          b.rollers,
          b.contacts,
          options};
}

LoadedBody loaded_screw(const BodyGeometry& b, Direction direction, const FlexibilityOptions& options) {
  const Groove& g = b.grooves.screw;
  const Structure::Screw& screw = b.structure.screw;
  const FlankSide side = pushing_flank(direction);
  const double first = screw.free_length;
  GroovedShape shape;
  shape.groove = g;
  shape.ridge = first - g.position(side, 0.0);
  const double last = shape.ridge + (b.contacts - 1) * g.pitch;
  // The first ridge must be whole: before it the body has at least half a pitch of length.
  shape.start = std::min(0.0, shape.ridge - 0.5 * g.pitch);
  if (b.endless_screw) {
    shape.end = first + (b.contacts + 2) * g.pitch;
  } else {
    shape.ridges = {shape.ridge, last};
    shape.end = last + 0.5 * g.pitch;
  }
  shape.far_radius = 0.5 * screw.bore;
  return {shape, with_friction(b, loaded_flanks(g, first, b.contacts, side, b.patches.screw, options.mesh.patch_cells)),
          elastic(b.materials.screw), options.mesh};
}

Flexibility screw_flexibility(const BodyGeometry& b, Direction direction, const FlexibilityOptions& options,
                              MatrixCache& cache) {
  Flexibility f;
  f.matrix = b.rollers * cached(cache, "screw", loaded_screw(b, direction, options), held_at_start, is_square)->front();
  add_teeth(f, teeth_of(b, Part::screw, direction, options), false, cache);
  return f;
}

std::vector<int> held_nodes(const GroovedBody& body, const HeldNut& nut) {
  const std::vector<MeridianEdge>& face = body.free_face(nut.thrust);
  const bool on_face = !face.empty();
  std::vector<int> held = by_radius(body, nodes_of(on_face ? face : body.section(nut.thrust)));
  if (nut.shoulder && on_face) {
    const GroovedShape& shape = nut.body.shape;
    const double same = 1e-6 * shape.groove.pitch;
    std::erase_if(held, [&](int node) {
      const double r = item_at(body.mesh.nodes, node).x();
      return r < shape.radii[0] - same || r > shape.radii[1] + same;
    });
    if (held.empty()) throw std::invalid_argument("the shoulder does not reach the flange's face");
  }
  return held;
}

namespace {

/// Flexibilities of harmonic 0; the last matrix says whether the section is a free face, which can lift off, or one
/// inside, which is held both ways.
MatrixCache::Matrices on_shoulder(const HeldNut& nut) {
  const GroovedBody body = nut.body.meshed();
  const bool on_face = !body.free_face(nut.thrust).empty();
  const ThrustFace t = thrust_face(body, nut.body.material, held_nodes(body, nut));
  return {t.nodes, t.coupling, t.loads, t.resultants, MatrixXd::Constant(1, 1, on_face)};
}

bool is_on_shoulder(const HeldNut& nut, const MatrixCache::Matrices& m) {
  const auto flanks = static_cast<Index>(nut.body.flanks.size());
  const Index nodes = m.empty() ? 0 : m.front().rows();
  return nodes > 0 && have_sizes(m, {{nodes, nodes}, {nodes, flanks}, {flanks, flanks}, {flanks, 1}, {1, 1}});
}

}  // namespace

HeldNut held_nut(const BodyGeometry& b, Direction direction, double position, const FlexibilityOptions& options) {
  const Groove& g = b.grooves.nut;
  const Structure::Nut& nut = b.structure.nut;
  const FlankSide side = pushed_flank(direction);
  const double thrust = direction == Direction::tension ? *nut.thrust.tension : *nut.thrust.compression;
  GroovedShape shape;
  shape.groove = g;
  shape.ridge = position - g.position(side, 0.0);
  // Contacts at the very ends of the nut get 0.3 p of thread beyond them.
  shape.start = std::min(0.0, position - 0.3 * g.pitch);
  shape.end = std::max(nut.length, position + (b.contacts - 1 + 0.3) * g.pitch);
  shape.far_radius = 0.5 * nut.outer_diameter;
  for (const Structure::Flange& flange : nut.flanges)
    shape.collars.push_back({flange.from, flange.to, 0.5 * flange.outer_diameter});
  shape.sections.push_back(thrust);
  if (nut.shoulder) shape.radii = {0.5 * nut.shoulder->inner_diameter, 0.5 * nut.shoulder->outer_diameter};
  return {
      {shape, with_friction(b, loaded_flanks(g, position, b.contacts, side, b.patches.nut, options.mesh.patch_cells)),
       elastic(b.materials.nut), options.mesh},
      thrust,
      nut.shoulder.has_value()};
}

Flexibility nut_flexibility(const BodyGeometry& b, Direction direction, double position,
                            const FlexibilityOptions& options, MatrixCache& cache) {
  const HeldNut held = held_nut(b, direction, position, options);
  const auto whole = cached(cache, "nut", held, on_shoulder, is_on_shoulder);
  const ThrustFace face{(*whole)[0], (*whole)[1], (*whole)[2], (*whole)[3]};
  const bool unilateral = options.unilateral_thrust && (*whole)[4](0) != 0.0;
  const ThrustFace::Touching touching =
      unilateral ? face.touching_under(face.equal_loads(b.contacts), face.all()).value_or(face.all()) : face.all();

  Flexibility f;
  f.matrix = b.rollers * face.flexibility(touching);
  if (unilateral) f.face = face;
  add_teeth(f, teeth_of(b, Part::nut, direction, options), false, cache);
  return f;
}

namespace {

/// Moves the radial forces of harmonic 1 from the contacts to the middle of their ridges, a quarter
/// of a pitch, by pairs of transverse forces on the sections in the grooves on both sides: contacts
/// on both flanks of a ridge bend the roller less than opposite ones. Near the contacts nothing
/// changes.
void move_to_middle(MatrixXd& loads, const GroovedBody& body, const std::vector<LoadedFlank>& flanks) {
  const auto radial = Eigen::seq(static_cast<Index>(Component::radial), Eigen::last, Index{fe::kComponents});
  const double half = 0.5 * body.shape.groove.pitch;
  for (Index k = 0; k < loads.cols(); ++k) {
    const LoadedFlank& flank = item_at(flanks, k);
    const double force = 0.25 * sign(flank.side) * loads(radial, k).sum();
    loads.col(k) += force * (transverse_force(body, body.section(flank.ridge - half)) -
                             transverse_force(body, body.section(flank.ridge + half)));
  }
}

MatrixCache::Matrices stretched(const LoadedBody& roller) {
  const GroovedBody body = roller.meshed();
  const int on_axis = by_radius(body, nodes_of(body.section(body.shape.end))).front();
  fe::HarmonicBody solver(body.mesh, isotropic(roller.material), 0, axial_supports({on_axis}));
  return {flexibility_of(solver, 0, patch_loads(body, 0))};
}

struct GuidedRoller {
  LoadedBody body;
  Guidance guidance;
  bool centred = false;
};
PRS_MEMBERS(GuidedRoller, body, guidance, centred)

bool is_square_of(const GuidedRoller& roller, const MatrixCache::Matrices& m) { return is_square(roller.body, m); }

/// Flexibility at the contacts, and after them at `guides` of the end sections.
MatrixCache::Matrices bent_with(const GuidedRoller& roller, Index guides) {
  const GroovedBody body = roller.body.meshed();
  std::vector<fe::HarmonicSupport> supports;
  std::vector<fe::HarmonicSpring> springs;
  add_guidance(body, roller.guidance, supports, springs);
  fe::HarmonicBody solver(body.mesh, isotropic(roller.body.material), 1, supports, springs);
  MatrixXd loads = patch_loads(body, 1);
  if (roller.centred) move_to_middle(loads, body, roller.body.flanks);
  const Index contacts = loads.cols();
  loads.leftCols(contacts / 2) *= -1.0;  // cos(theta) at theta = pi
  loads.conservativeResize(Eigen::NoChange, contacts + guides);
  for (Index k = 0; k < guides; ++k) loads.col(contacts + k) = transverse_force(body, item_at(end_sections(body), k));
  return {flexibility_of(solver, 1, loads)};
}
MatrixCache::Matrices bent(const GuidedRoller& roller) { return bent_with(roller, 0); }

constexpr Index kGuides = 4;
MatrixCache::Matrices bent_with_guides(const GuidedRoller& roller) { return bent_with(roller, kGuides); }
bool has_guides(const GuidedRoller& roller, const MatrixCache::Matrices& m) {
  const auto size = static_cast<Index>(roller.body.flanks.size()) + kGuides;
  return have_sizes(m, {{size, size}});
}

/// Sets guides with a clearance: springs of the stiffness E d of an end hold the roller in their place.
void set_loose_guides(Flexibility& f, const Structure::Roller& roller, const LoadedBody& body, bool centred,
                      MatrixCache& cache) {
  const RingGuide ring{roller.guidance.ring_stiffness, roller.guidance.clearance};
  const double held_by = body.material.youngs_modulus * roller.end_diameter;
  const MatrixXd all =
      cached(cache, "bent roller with guides", GuidedRoller{body, {Guidance::Kind::ring, held_by, 0.0}, centred},
             bent_with_guides, has_guides)
          ->front();
  const auto contacts = all.rows() - kGuides;
  f.bent = all.topLeftCorner(contacts, contacts);
  f.guides = {ring, held_by, roller.end_length, all.topRightCorner(contacts, kGuides),
              all.bottomRightCorner(kGuides, kGuides)};
}

}  // namespace

Flexibility roller_flexibility(const BodyGeometry& b, Direction direction, const FlexibilityOptions& options,
                               MatrixCache& cache) {
  const Groove& g = b.grooves.roller;
  const Structure::Roller& roller = b.structure.roller;
  const FlankSide screw_side = pushed_flank(direction), nut_side = pushing_flank(direction);
  const bool centred = b.roller_contacts == ModelOptions::RollerContacts::opposite;
  LoadedBody body{{}, {}, elastic(b.materials.roller), options.mesh};
  // Types for a ridge at 0; those of the screw first.
  const auto types_at = [&](Interface i) {
    return with_friction(
        b, {{0.0, i == Interface::screw ? screw_side : nut_side, b.patches[i], options.mesh.patch_cells}});
  };
  std::vector<LoadedFlank> types = types_at(Interface::screw);
  std::vector<bool> opposite(types.size(), true);
  for (const LoadedFlank& type : types_at(Interface::nut)) {
    types.push_back(type);
    opposite.push_back(false);
  }
  for (LoadedFlank flank : types)
    for (int k = 0; k < b.contacts; ++k) {
      flank.ridge = k * g.pitch;
      body.flanks.push_back(flank);
    }
  GroovedShape& shape = body.shape;
  shape.groove = g;
  shape.start = -0.5 * g.pitch;
  shape.end = (b.contacts - 0.5) * g.pitch;
  shape.plain_end = PlainEnd{roller.end_length, 0.5 * roller.end_diameter};
  for (int k = 1; k < b.contacts; ++k) shape.sections.push_back((k - 0.5) * g.pitch);

  Flexibility f;
  if (roller.guidance.clearance > 0.0)
    set_loose_guides(f, roller, body, centred, cache);
  else
    f.bent = cached(cache, "bent roller", GuidedRoller{body, roller.guidance, centred}, bent, is_square_of)->front();
  f.matrix = cached(cache, "stretched roller", body, stretched, is_square)->front() + f.bent;
  const Teeth teeth{g, 0.0, body.material, types, opposite, 2, 1, b.contacts, options};
  add_teeth(f, teeth, centred, cache);
  return f;
}

}  // namespace prs
