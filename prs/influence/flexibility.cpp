#include "prs/influence/flexibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace prs {
namespace {

using Eigen::Index;
using fe::Component;

fe::Isotropic isotropic(const Material& m) { return {m.youngs_modulus, m.poisson_ratio}; }

/// The flank of each part that is loaded: the screw pushes the roller along the load, the roller
/// the nut.
FlankSide pushing_flank(Direction d) {
  return d == Direction::tension ? FlankSide::backward : FlankSide::forward;
}
FlankSide pushed_flank(Direction d) {
  return d == Direction::tension ? FlankSide::forward : FlankSide::backward;
}

void require(fe::FactorizationStatus status) {
  if (status != fe::FactorizationStatus::ok)
    throw std::runtime_error("the stiffness of a grooved body could not be factorized");
}

Eigen::MatrixXd flexibility_of(fe::HarmonicBody& solver, int harmonic,
                               const Eigen::MatrixXd& loads) {
  require(solver.factorize(harmonic));
  return loads.transpose() * solver.solve(loads);
}

/// Loaded flanks whose pitch points lie at `first`, `first` + pitch, ..
std::vector<LoadedFlank> loaded_flanks(const Groove& g, double first, int contacts, FlankSide side,
                                       const HertzPatch& patch, int cells) {
  std::vector<LoadedFlank> flanks;
  for (int k = 0; k < contacts; ++k)
    flanks.push_back({first + k * g.pitch - g.position(side, 0.0), side, patch, cells});
  return flanks;
}

/// All that a matrix depends on, written out exactly.
class Key {
 public:
  explicit Key(std::string_view what) { text_ = fmt::format("flexibility 1 {}", what); }

  Key& add(double value) {
    text_ += fmt::format(" {:a}", value);
    return *this;
  }
  Key& add(const Groove& g) {
    return add(g.internal)
        .add(g.pitch)
        .add(g.pitch_radius)
        .add(g.addendum)
        .add(g.dedendum)
        .add(g.backward_angle)
        .add(g.forward_angle);
  }
  Key& add(const Material& m) { return add(m.youngs_modulus).add(m.poisson_ratio); }
  Key& add(const HertzPatch& p) { return add(p.along_profile).add(p.along_circumference); }
  Key& add(Direction d) { return add(sense(d)); }
  Key& add(const MeshDensity& m) {
    return add(m.patch_cells)
        .add(m.growth)
        .add(m.largest_cell)
        .add(m.step_cell)
        .add(m.plain_flank_cells)
        .add(m.split)
        .add(m.ridge_depth);
  }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// What the harmonics that die out along a body add to its flexibility, the same at all threads.
struct TeethFlexibility {
  int harmonics = 0;
  int last_harmonic = 0;
  double half_space = 0.0;
  double closed_remainder = 0.0;
  Eigen::VectorXd diagonal;  ///< Of each type of contact: remainder less half-space part.
  BlockResponse response;    ///< Sum of the harmonics, rows and columns are types of contacts.
};

MatrixCache::Matrices packed(const TeethFlexibility& t) {
  MatrixCache::Matrices m{
      Eigen::Vector4d(t.harmonics, t.last_harmonic, t.half_space, t.closed_remainder), t.diagonal};
  m.insert(m.end(), t.response.kernel.begin(), t.response.kernel.end());
  return m;
}

TeethFlexibility unpacked(const MatrixCache::Matrices& m) {
  TeethFlexibility t;
  t.harmonics = static_cast<int>(m[0](0));
  t.last_harmonic = static_cast<int>(m[0](1));
  t.half_space = m[0](2);
  t.closed_remainder = m[0](3);
  t.diagonal = m[1];
  t.response.kernel.assign(m.begin() + 2, m.end());
  t.response.reach = (static_cast<int>(t.response.kernel.size()) - 1) / 2;
  return t;
}

/// The teeth of one body: types of contacts on each ridge, whether they lie at theta = pi, and the
/// harmonics step, 2 step, .. from `first` on.
struct Teeth {
  Groove groove;
  double far_radius = 0.0;
  Material material;
  std::vector<LoadedFlank> types;
  std::vector<bool> opposite;
  int first = 0;
  int step = 1;
  int contacts = 1;
};

TeethFlexibility compute(const Teeth& t, const FlexibilityOptions& options) {
  BlockSolver block(t.groove, t.far_radius, t.material, t.types, options);
  const double radius = t.groove.pitch_radius;
  double widest = 0.0;
  for (const LoadedFlank& flank : t.types)
    widest = std::max(widest, flank.patch.along_circumference);
  const double last = options.largest_wave * radius / widest;
  const auto count = static_cast<Index>(t.types.size());

  TeethFlexibility f;
  int n = t.first;
  f.response.reach = block.reach(n, t.contacts - 1);
  f.response.kernel.assign(static_cast<std::size_t>(2 * f.response.reach + 1),
                           Eigen::MatrixXd::Zero(count, count));
  for (; n <= last; n += t.step) {
    const BlockResponse r = block.solve(n, block.reach(n, t.contacts - 1));
    for (int d = -r.reach; d <= r.reach; ++d)
      for (Index a = 0; a < count; ++a)
        for (Index b = 0; b < count; ++b) {
          const bool turned =
              t.opposite[static_cast<std::size_t>(a)] != t.opposite[static_cast<std::size_t>(b)];
          f.response.kernel[static_cast<std::size_t>(d + f.response.reach)](a, b) +=
              (turned && n % 2 == 1 ? -t.step : t.step) *
              r.kernel[static_cast<std::size_t>(d + r.reach)](a, b);
        }
    f.last_harmonic = n;
    ++f.harmonics;
  }
  f.diagonal.resize(count);
  for (Index a = 0; a < count; ++a) {
    const HertzPatch& patch = t.types[static_cast<std::size_t>(a)].patch;
    const double half_space = half_space_compliance(patch, t.material);
    const double rest = half_space_remainder(patch, t.material, (n - 0.5 * t.step) / radius);
    f.diagonal[a] = rest - half_space;
    if (a == 0) {
      f.half_space = half_space;
      f.closed_remainder = rest;
    }
  }
  return f;
}

/// Adds the teeth to a body's matrix, whose rows and columns are the types in blocks of `contacts`.
/// With `centred`, contacts of different types lie at the same axial position, and not half a pitch
/// apart as on the ridge.
void add_teeth(Flexibility& f, const Teeth& t, bool centred, const FlexibilityOptions& options,
               MatrixCache& cache) {
  Key key("teeth");
  key.add(t.groove).add(t.far_radius).add(t.material).add(t.first).add(t.step).add(t.contacts);
  for (std::size_t i = 0; i < t.types.size(); ++i)
    key.add(sign(t.types[i].side)).add(t.types[i].patch).add(t.opposite[i]);
  key.add(options.mesh)
      .add(options.largest_wave)
      .add(options.block_tolerance)
      .add(options.neighbour_patch_cells);
  const TeethFlexibility teeth =
      unpacked(*cache.get(key.text(), [&] { return packed(compute(t, options)); }));

  const int reach = teeth.response.reach, contacts = t.contacts;
  const auto kernel = [&](int d, Index a, Index b) {
    return std::abs(d) > reach ? 0.0
                               : teeth.response.kernel[static_cast<std::size_t>(d + reach)](a, b);
  };
  const auto count = static_cast<Index>(t.types.size());
  for (Index a = 0; a < count; ++a)
    for (Index b = 0; b < count; ++b) {
      const double ahead = 0.5 * (sign(t.types[static_cast<std::size_t>(a)].side) -
                                  sign(t.types[static_cast<std::size_t>(b)].side));
      const int other = centred ? -static_cast<int>(ahead) : 0;
      for (int d = -reach - 1; d <= reach + 1; ++d) {
        const double value = 0.5 * (kernel(d, a, b) + kernel(d + other, a, b));
        for (int j = std::max(0, -d); j < std::min(contacts, contacts - d); ++j)
          f.matrix(a * contacts + j + d, b * contacts + j) += value;
      }
    }
  for (Index a = 0; a < count; ++a)
    f.matrix.diagonal().segment(a * contacts, contacts).array() += teeth.diagonal[a];
  f.harmonics += teeth.harmonics;
  f.last_harmonic = teeth.last_harmonic;
  f.half_space = teeth.half_space;
  f.closed_remainder = teeth.closed_remainder;
  f.matrix = 0.5 * (f.matrix + f.matrix.transpose()).eval();
}

/// Nodes of some edges, each once.
std::vector<int> nodes_of(const std::vector<fe::MeridianEdge>& edges) {
  std::vector<int> nodes;
  for (const fe::MeridianEdge& e : edges) nodes.insert(nodes.end(), e.begin(), e.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// The innermost first.
std::vector<int> by_radius(const GroovedBody& body, std::vector<int> nodes) {
  const auto radius = [&](int node) { return body.mesh.nodes[static_cast<std::size_t>(node)].x(); };
  std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return radius(a) < radius(b); });
  return nodes;
}

std::vector<fe::HarmonicSupport> axial_supports(const std::vector<int>& nodes) {
  std::vector<fe::HarmonicSupport> supports;
  for (const int node : nodes) supports.push_back({node, Component::axial});
  return supports;
}

/// Axial force of each load [N].
Eigen::RowVectorXd axial_resultants(const Eigen::MatrixXd& loads) {
  Eigen::RowVectorXd force = Eigen::RowVectorXd::Zero(loads.cols());
  for (Index row = static_cast<Index>(Component::axial); row < loads.rows(); row += fe::kComponents)
    force += loads.row(row);
  return force;
}

/// A body, harmonic 0, that rests with `nodes` on a shoulder.
ThrustFace thrust_face(const GroovedBody& body, const Material& material,
                       const std::vector<int>& nodes) {
  fe::HarmonicBody solver(body.mesh, isotropic(material), 0, axial_supports({nodes.front()}));
  const Eigen::MatrixXd loads = patch_loads(body, 0);
  const auto count = static_cast<Index>(nodes.size()), ends = loads.cols();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(loads.rows(), count + ends);
  for (Index k = 1; k < count; ++k)
    all(fe::row_of(nodes[static_cast<std::size_t>(k)], Component::axial), k) = 1.0;
  all.rightCols(ends) = loads;
  const Eigen::MatrixXd g = flexibility_of(solver, 0, all);
  return {g.topLeftCorner(count, count), g.topRightCorner(count, ends),
          g.bottomRightCorner(ends, ends), axial_resultants(loads).transpose()};
}

/// Edges of a section up to a radius.
std::vector<fe::MeridianEdge> within(const GroovedBody& body,
                                     const std::vector<fe::MeridianEdge>& edges, double radius) {
  std::vector<fe::MeridianEdge> inner;
  for (const fe::MeridianEdge& e : edges)
    if (body.mesh.nodes[static_cast<std::size_t>(e[2])].x() < radius) inner.push_back(e);
  return inner;
}

/// Loads of harmonic 1 that push sideways with 1 N, spread evenly over a section; also the weights
/// of its mean sideways displacement, 1/2 (U - V).
Eigen::VectorXd transverse_force(const GroovedBody& body,
                                 const std::vector<fe::MeridianEdge>& section) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(fe::kComponents * body.mesh.size());
  for (const fe::MeridianEdge& e : section)
    fe::add_edge_load(
        body.mesh, e, 1, [](double, double) { return Eigen::Vector3d(1.0, -1.0, 0.0); }, load);
  return load / load.cwiseAbs().sum();
}

/// A spring on the mean sideways displacement of a section.
fe::HarmonicSpring sideways_spring(const GroovedBody& body,
                                   const std::vector<fe::MeridianEdge>& section, double stiffness) {
  const Eigen::VectorXd weight = transverse_force(body, section);
  fe::HarmonicSpring spring;
  spring.stiffness = stiffness;
  for (const int node : nodes_of(section))
    for (const Component c : {Component::radial, Component::circumferential})
      spring.terms.push_back({node, c, weight[fe::row_of(node, c)]});
  return spring;
}

/// What holds the roller sideways, on whole sections that stay round.
void add_guidance(const GroovedBody& body, const Structure::Roller& roller,
                  std::vector<fe::HarmonicSupport>& supports,
                  std::vector<fe::HarmonicSpring>& springs) {
  const GroovedShape& s = body.shape;
  const double l = s.plain_end->length;
  std::vector<double> sections{s.start - l, s.end + l};
  if (roller.guidance.kind != Guidance::Kind::outer_node) {
    sections.push_back(s.start);
    sections.push_back(s.end);
  }
  for (const double z : sections) {
    const std::vector<fe::MeridianEdge> edges = within(body, body.section(z), s.plain_end->radius);
    if (roller.guidance.kind == Guidance::Kind::ring) {
      springs.push_back(sideways_spring(body, edges, roller.guidance.ring_stiffness));
      continue;
    }
    for (const fe::MeridianEdge& e : edges) {
      fe::add_support(supports, e, Component::radial);
      fe::add_support(supports, e, Component::circumferential);
    }
  }
}

}  // namespace

BodyGeometry body_geometry(const Mechanism& m, const Structure& structure,
                           const Materials& materials, const PerInterface<ContactLaw>& laws,
                           const PerInterface<HertzPatch>& patches, Direction direction,
                           const ModelOptions& model) {
  BodyGeometry b;
  b.roller_contacts = roller_contacts(model, m.starts.roller);
  b.endless_screw = m.type == Mechanism::Type::standard;
  b.materials = materials;
  b.structure = structure;
  b.rollers = m.rollers;
  b.contacts = m.contacts_per_roller;
  for (const Part p : kParts) {
    const double at_screw = laws.screw.normal_angle, at_nut = laws.nut.normal_angle;
    const bool screw_forward = pushed_flank(direction) == FlankSide::forward;
    const double backward = p == Part::screw ? at_screw
                            : p == Part::nut ? at_nut
                                             : (screw_forward ? at_nut : at_screw);
    const double forward = p == Part::screw ? at_screw
                           : p == Part::nut ? at_nut
                                            : (screw_forward ? at_screw : at_nut);
    b.grooves[p] = default_groove(p == Part::nut, axial_pitch(m), 0.5 * *m.pitch_diameter[p],
                                  backward, forward);
    if (m.thread[p]) {
      b.grooves[p].addendum = m.thread[p]->addendum;
      b.grooves[p].dedendum = m.thread[p]->dedendum;
    }
  }
  b.patches.screw = fitted(fitted(patches.screw, b.grooves.screw), b.grooves.roller);
  b.patches.nut = fitted(fitted(patches.nut, b.grooves.nut), b.grooves.roller);
  return b;
}

FlexibilityOptions flexibility_options(ModelOptions::Accuracy accuracy) {
  FlexibilityOptions options;
  if (accuracy == ModelOptions::Accuracy::reference) {
    options.mesh.patch_cells = 4;
    options.mesh.split = 2;
  }
  return options;
}

Flexibility screw_flexibility(const BodyGeometry& b, Direction direction,
                              const FlexibilityOptions& options, MatrixCache& cache) {
  const Groove& g = b.grooves.screw;
  const Structure::Screw& screw = b.structure.screw;
  const FlankSide side = pushing_flank(direction);
  const auto whole = [&]() -> MatrixCache::Matrices {
    const double first = screw.free_length;
    GroovedShape shape;
    shape.groove = g;
    shape.ridge = first - g.position(side, 0.0);
    const double last = shape.ridge + (b.contacts - 1) * g.pitch;
    // The first ridge must be whole: a shorter free length is lengthened to half a pitch before it.
    shape.start = std::min(0.0, shape.ridge - 0.5 * g.pitch);
    if (b.endless_screw) {
      shape.end = first + (b.contacts + 2) * g.pitch;
    } else {
      shape.ridges = {shape.ridge, last};
      shape.end = last + 0.5 * g.pitch;
    }
    shape.far_radius = 0.5 * screw.bore;
    const GroovedBody body = mesh_grooved_body(
        shape, loaded_flanks(g, first, b.contacts, side, b.patches.screw, options.mesh.patch_cells),
        options.mesh);
    fe::HarmonicBody solver(body.mesh, isotropic(b.materials.screw), 0,
                            axial_supports(nodes_of(body.section(shape.start))));
    return {flexibility_of(solver, 0, patch_loads(body, 0))};
  };
  Key key("screw");
  key.add(g).add(screw.free_length).add(screw.bore).add(b.materials.screw).add(b.patches.screw);
  key.add(direction).add(b.contacts).add(options.mesh).add(b.endless_screw);
  Flexibility f;
  f.matrix = b.rollers * cache.get(key.text(), whole)->front();
  f.harmonics = 1;
  const Teeth teeth{g,
                    0.5 * screw.bore,
                    b.materials.screw,
                    {{0.0, side, b.patches.screw, options.mesh.patch_cells}},
                    {false},
                    b.rollers,
                    b.rollers,
                    b.contacts};
  add_teeth(f, teeth, false, options, cache);
  return f;
}

namespace {

/// The whole nut under harmonic 0 on its shoulder; `on_face` says whether that is a free face,
/// which can lift off, or a section inside, which is held both ways.
ThrustFace nut_on_shoulder(const BodyGeometry& b, FlankSide side, double thrust, double position,
                           const FlexibilityOptions& options, bool& on_face) {
  const Groove& g = b.grooves.nut;
  const Structure::Nut& nut = b.structure.nut;
  GroovedShape shape;
  shape.groove = g;
  shape.ridge = position - g.position(side, 0.0);
  // Contacts at the very ends of the nut get the thread they need.
  shape.start = std::min(0.0, position - 0.3 * g.pitch);
  shape.end = std::max(nut.length, position + (b.contacts - 1 + 0.3) * g.pitch);
  shape.far_radius = 0.5 * nut.outer_diameter;
  for (const Structure::Flange& flange : nut.flanges)
    shape.collars.push_back({flange.from, flange.to, 0.5 * flange.outer_diameter});
  shape.sections.push_back(thrust);
  if (nut.shoulder)
    shape.radii = {0.5 * nut.shoulder->inner_diameter, 0.5 * nut.shoulder->outer_diameter};
  const GroovedBody body = mesh_grooved_body(
      shape, loaded_flanks(g, position, b.contacts, side, b.patches.nut, options.mesh.patch_cells),
      options.mesh);
  const std::vector<fe::MeridianEdge>& face = body.free_face(thrust);
  on_face = !face.empty();
  std::vector<int> held = by_radius(body, nodes_of(on_face ? face : body.section(thrust)));
  if (nut.shoulder && on_face) {
    const double same = 1e-6 * g.pitch;
    std::erase_if(held, [&](int node) {
      const double r = body.mesh.nodes[static_cast<std::size_t>(node)].x();
      return r < shape.radii[0] - same || r > shape.radii[1] + same;
    });
    if (held.empty()) throw std::invalid_argument("the shoulder does not reach the flange's face");
  }
  return thrust_face(body, b.materials.nut, held);
}

}  // namespace

Flexibility nut_flexibility(const BodyGeometry& b, Direction direction, double position,
                            const FlexibilityOptions& options, MatrixCache& cache) {
  const Groove& g = b.grooves.nut;
  const Structure::Nut& nut = b.structure.nut;
  const FlankSide side = pushed_flank(direction);
  const double thrust =
      direction == Direction::tension ? *nut.thrust.tension : *nut.thrust.compression;
  Key key("nut");
  key.add(g).add(nut.length).add(nut.outer_diameter).add(b.materials.nut).add(b.patches.nut);
  for (const Structure::Flange& f : nut.flanges) key.add(f.from).add(f.to).add(f.outer_diameter);
  if (nut.shoulder) key.add(nut.shoulder->inner_diameter).add(nut.shoulder->outer_diameter);
  key.add(thrust).add(direction).add(position).add(b.contacts).add(options.mesh);
  const auto whole = cache.get(key.text(), [&]() -> MatrixCache::Matrices {
    bool on_face = false;
    const ThrustFace t = nut_on_shoulder(b, side, thrust, position, options, on_face);
    return {t.nodes, t.coupling, t.loads, t.resultants, Eigen::MatrixXd::Constant(1, 1, on_face)};
  });
  const ThrustFace face{(*whole)[0], (*whole)[1], (*whole)[2], (*whole)[3]};
  const bool unilateral = options.unilateral_thrust && (*whole)[4](0) != 0.0;
  const ThrustFace::Touching touching =
      unilateral ? face.touching_under(Eigen::VectorXd::Ones(b.contacts), face.all()) : face.all();

  Flexibility f;
  f.matrix = b.rollers * face.flexibility(touching);
  f.harmonics = 1;
  if (unilateral) f.face = face;
  const Teeth teeth{g,
                    0.5 * nut.outer_diameter,
                    b.materials.nut,
                    {{0.0, side, b.patches.nut, options.mesh.patch_cells}},
                    {false},
                    b.rollers,
                    b.rollers,
                    b.contacts};
  add_teeth(f, teeth, false, options, cache);
  return f;
}

namespace {

/// Moves the radial forces of harmonic 1 from the contacts to the middle of their ridges, a quarter
/// of a pitch, by pairs of transverse forces on the sections in the grooves beside: contacts on
/// both flanks of a ridge bend the roller less than opposite ones. Near the contacts nothing
/// changes.
void move_to_middle(Eigen::MatrixXd& loads, const GroovedBody& body,
                    const std::vector<LoadedFlank>& flanks) {
  const auto radial =
      Eigen::seq(static_cast<Index>(Component::radial), Eigen::last, Index{fe::kComponents});
  const double half = 0.5 * body.shape.groove.pitch;
  for (Index k = 0; k < loads.cols(); ++k) {
    const LoadedFlank& flank = flanks[static_cast<std::size_t>(k)];
    const double force = 0.25 * sign(flank.side) * loads(radial, k).sum();
    loads.col(k) += force * (transverse_force(body, body.section(flank.ridge - half)) -
                             transverse_force(body, body.section(flank.ridge + half)));
  }
}

}  // namespace

Flexibility roller_flexibility(const BodyGeometry& b, Direction direction,
                               const FlexibilityOptions& options, MatrixCache& cache) {
  const Groove& g = b.grooves.roller;
  const Structure::Roller& roller = b.structure.roller;
  const FlankSide screw_side = pushed_flank(direction), nut_side = pushing_flank(direction);
  const bool centred = b.roller_contacts == ModelOptions::RollerContacts::opposite;
  std::vector<LoadedFlank> flanks;
  for (int k = 0; k < b.contacts; ++k)
    flanks.push_back({k * g.pitch, screw_side, b.patches.screw, options.mesh.patch_cells});
  for (int k = 0; k < b.contacts; ++k)
    flanks.push_back({k * g.pitch, nut_side, b.patches.nut, options.mesh.patch_cells});
  const auto meshed = [&] {
    GroovedShape shape;
    shape.groove = g;
    shape.start = -0.5 * g.pitch;
    shape.end = (b.contacts - 0.5) * g.pitch;
    shape.plain_end = PlainEnd{roller.end_length, 0.5 * roller.end_diameter};
    for (int k = 1; k < b.contacts; ++k) shape.sections.push_back((k - 0.5) * g.pitch);
    return mesh_grooved_body(shape, flanks, options.mesh);
  };
  const auto stretched = [&]() -> MatrixCache::Matrices {
    const GroovedBody body = meshed();
    const int on_axis = by_radius(body, nodes_of(body.section(body.shape.end))).front();
    fe::HarmonicBody solver(body.mesh, isotropic(b.materials.roller), 0, axial_supports({on_axis}));
    return {flexibility_of(solver, 0, patch_loads(body, 0))};
  };
  const auto bent = [&]() -> MatrixCache::Matrices {
    const GroovedBody body = meshed();
    std::vector<fe::HarmonicSupport> supports;
    std::vector<fe::HarmonicSpring> springs;
    add_guidance(body, roller, supports, springs);
    fe::HarmonicBody solver(body.mesh, isotropic(b.materials.roller), 1, supports, springs);
    Eigen::MatrixXd loads = patch_loads(body, 1);
    if (centred) move_to_middle(loads, body, flanks);
    loads.leftCols(b.contacts) *= -1.0;  // cos(theta) at theta = pi
    return {flexibility_of(solver, 1, loads)};
  };
  const auto key = [&](std::string_view what) {
    Key k(what);
    k.add(g).add(roller.end_length).add(roller.end_diameter).add(b.materials.roller);
    k.add(b.patches.screw).add(b.patches.nut).add(direction).add(b.contacts);
    return k.add(options.mesh);
  };
  Key guided = key("bent roller");
  guided.add(centred)
      .add(static_cast<int>(roller.guidance.kind))
      .add(roller.guidance.ring_stiffness);

  Flexibility f;
  f.matrix = cache.get(key("stretched roller").text(), stretched)->front() +
             cache.get(guided.text(), bent)->front();
  f.harmonics = 2;
  const Teeth teeth{g,
                    0.0,
                    b.materials.roller,
                    {{0.0, screw_side, b.patches.screw, options.mesh.patch_cells},
                     {0.0, nut_side, b.patches.nut, options.mesh.patch_cells}},
                    {true, false},
                    2,
                    1,
                    b.contacts};
  add_teeth(f, teeth, centred, options, cache);
  return f;
}

BlockSolver::BlockSolver(const Groove& groove, double far_radius, const Material& material,
                         const std::vector<LoadedFlank>& flanks, const FlexibilityOptions& options)
    : groove_(groove),
      far_radius_(far_radius),
      material_(isotropic(material)),
      flanks_(flanks),
      options_(options) {}

int BlockSolver::reach(int harmonic, int largest) const {
  // Harmonic n decays as exp(-n x/r) or faster along a body of outer radius r.
  const double radius = std::max(far_radius_, groove_.pitch_radius);
  const double length = -std::log(options_.block_tolerance) * radius / harmonic;
  return std::min(largest, static_cast<int>(std::ceil(length / groove_.pitch)));
}

BlockResponse BlockSolver::solve(int harmonic, int reach) {
  const auto types = static_cast<Index>(flanks_.size());
  if (reach != reach_) {
    GroovedShape shape;
    shape.groove = groove_;
    shape.far_radius = far_radius_;
    shape.start = -(reach + 0.5) * groove_.pitch;
    shape.end = (reach + 0.5) * groove_.pitch;
    std::vector<LoadedFlank> flanks;
    for (int d = -reach; d <= reach; ++d)
      for (LoadedFlank f : flanks_) {
        f.ridge = d * groove_.pitch;
        if (d != 0) f.patch_cells = options_.neighbour_patch_cells;
        flanks.push_back(f);
      }
    body_ = mesh_grooved_body(shape, flanks, options_.mesh);
    solver_ = std::make_unique<fe::HarmonicBody>(body_.mesh, material_, harmonic);
    reach_ = reach;
  }
  require(solver_->factorize(harmonic));
  const Eigen::MatrixXd loads = patch_loads(body_, harmonic);
  const Eigen::MatrixXd displacement = solver_->solve(loads.middleCols(reach * types, types));
  BlockResponse r;
  r.reach = reach;
  for (int d = 0; d <= 2 * reach; ++d)
    r.kernel.push_back(loads.middleCols(d * types, types).transpose() * displacement);
  return r;
}

}  // namespace prs
