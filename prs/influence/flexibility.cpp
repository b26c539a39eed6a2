#include "prs/influence/flexibility.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

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

/// Adds to `total` what the harmonics step, 2 step, .. from `first` on leave, and settles the
/// diagonal with the half-space: rows and columns are contact types in blocks of `contacts`.
void add_higher_harmonics(Flexibility& f, BlockSolver& block, const std::vector<LoadedFlank>& types,
                          const std::vector<bool>& opposite, double radius,
                          const Material& material, int first, int step, int contacts,
                          const FlexibilityOptions& options) {
  double widest = 0.0;
  for (const LoadedFlank& t : types) widest = std::max(widest, t.patch.along_circumference);
  const double last = options.largest_wave * radius / widest;
  const int count = static_cast<int>(types.size());
  int n = first;
  for (; n <= last; n += step) {
    const BlockResponse r = block.solve(n, block.reach(n, contacts - 1));
    for (int d = -r.reach; d <= r.reach; ++d) {
      const Eigen::MatrixXd& kernel = r.kernel[static_cast<std::size_t>(d + r.reach)];
      for (int a = 0; a < count; ++a)
        for (int b = 0; b < count; ++b) {
          const bool turned =
              opposite[static_cast<std::size_t>(a)] != opposite[static_cast<std::size_t>(b)];
          const double value = (turned && n % 2 == 1 ? -step : step) * kernel(a, b);
          for (int j = std::max(0, -d); j < std::min(contacts, contacts - d); ++j)
            f.matrix(a * contacts + j + d, b * contacts + j) += value;
        }
    }
    f.last_harmonic = n;
    ++f.harmonics;
  }
  for (int a = 0; a < count; ++a) {
    const HertzPatch& patch = types[static_cast<std::size_t>(a)].patch;
    const double half_space = half_space_compliance(patch, material);
    const double rest = half_space_remainder(patch, material, (n - 0.5 * step) / radius);
    f.matrix.diagonal().segment(a * contacts, contacts).array() += rest - half_space;
    if (a == 0) {
      f.half_space = half_space;
      f.closed_remainder = rest;
    }
  }
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

/// Flexibility of a body, harmonic 0, under `loads`, held axially on `nodes`, which form a thrust
/// face. Solved with only the first of them held; the reactions R of the others follow from
///
///     u_nodes = G_nn R + G_nl P = 0,   u_loads = G_ln R + G_ll P.
///
/// With `unilateral`, nodes that would pull while all contacts carry alike are let go, until none
/// does; the first node must push then.
Eigen::MatrixXd flexibility_on_face(const GroovedBody& body, const Material& material,
                                    const std::vector<int>& nodes, const Eigen::MatrixXd& loads,
                                    bool unilateral, int& unknowns) {
  fe::HarmonicBody solver(body.mesh, isotropic(material), 0, axial_supports({nodes.front()}));
  unknowns = solver.unknowns();
  const auto others = static_cast<Index>(nodes.size()) - 1;
  Eigen::MatrixXd all(loads.rows(), others + loads.cols());
  all.leftCols(others).setZero();
  for (Index k = 0; k < others; ++k)
    all(fe::row_of(nodes[static_cast<std::size_t>(k + 1)], Component::axial), k) = 1.0;
  all.rightCols(loads.cols()) = loads;
  const Eigen::MatrixXd g = flexibility_of(solver, 0, all);

  std::vector<Index> held(static_cast<std::size_t>(others));
  std::iota(held.begin(), held.end(), Index{0});
  std::vector<Index> ends(static_cast<std::size_t>(loads.cols()));
  std::iota(ends.begin(), ends.end(), others);
  const auto reactions = [&]() -> Eigen::MatrixXd {
    return -g(held, held).ldlt().solve(g(held, ends));
  };
  const Eigen::RowVectorXd force = axial_resultants(loads);
  for (bool pulls = unilateral; pulls;) {
    const Eigen::VectorXd together = reactions().rowwise().sum();
    const double total = -force.sum();
    std::vector<Index> pushing;
    for (std::size_t k = 0; k < held.size(); ++k)
      if (together[static_cast<Index>(k)] * total > 0.0) pushing.push_back(held[k]);
    pulls = pushing.size() < held.size();
    held = std::move(pushing);
  }
  return g(ends, ends) + g(ends, held) * reactions();
}

/// Edges of a section up to a radius.
std::vector<fe::MeridianEdge> within(const GroovedBody& body,
                                     const std::vector<fe::MeridianEdge>& edges, double radius) {
  std::vector<fe::MeridianEdge> inner;
  for (const fe::MeridianEdge& e : edges)
    if (body.mesh.nodes[static_cast<std::size_t>(e[2])].x() < radius) inner.push_back(e);
  return inner;
}

/// A spring on the mean sideways displacement of a section, 1/2 (U - V) weighted by the area.
fe::HarmonicSpring sideways_spring(const GroovedBody& body,
                                   const std::vector<fe::MeridianEdge>& edges, double stiffness) {
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(fe::kComponents * body.mesh.size());
  for (const fe::MeridianEdge& e : edges)
    fe::add_edge_load(
        body.mesh, e, 1, [](double, double) { return Eigen::Vector3d(1.0, -1.0, 0.0); }, weight);
  const double area = weight.cwiseAbs().sum();
  fe::HarmonicSpring spring;
  spring.stiffness = stiffness;
  for (const int node : nodes_of(edges))
    for (const Component c : {Component::radial, Component::circumferential})
      spring.terms.push_back({node, c, weight[fe::row_of(node, c)] / area});
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
                           const PerInterface<HertzPatch>& patches, Direction direction) {
  BodyGeometry b;
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

Flexibility screw_flexibility(const BodyGeometry& b, Direction direction,
                              const FlexibilityOptions& options) {
  const Groove& g = b.grooves.screw;
  const FlankSide side = pushing_flank(direction);
  const double first = b.structure.screw.free_length;
  GroovedShape shape;
  shape.groove = g;
  shape.ridge = first - g.position(side, 0.0);
  // The first ridge must be whole: a shorter free length is lengthened to half a pitch before it.
  shape.start = std::min(0.0, shape.ridge - 0.5 * g.pitch);
  shape.end = first + (b.contacts - 1 + options.screw_overhang) * g.pitch;
  shape.far_radius = 0.5 * b.structure.screw.bore;
  const GroovedBody body = mesh_grooved_body(
      shape, loaded_flanks(g, first, b.contacts, side, b.patches.screw, options.mesh.patch_cells),
      options.mesh);
  fe::HarmonicBody solver(body.mesh, isotropic(b.materials.screw), 0,
                          axial_supports(nodes_of(body.section(shape.start))));
  Flexibility f;
  f.unknowns = solver.unknowns();
  f.matrix = b.rollers * flexibility_of(solver, 0, patch_loads(body, 0));
  f.harmonics = 1;

  const std::vector<LoadedFlank> type{{0.0, side, b.patches.screw, options.mesh.patch_cells}};
  BlockSolver block(g, shape.far_radius, b.materials.screw, type, options);
  add_higher_harmonics(f, block, type, {false}, g.pitch_radius, b.materials.screw, b.rollers,
                       b.rollers, b.contacts, options);
  return f;
}

Flexibility nut_flexibility(const BodyGeometry& b, Direction direction, double position,
                            const FlexibilityOptions& options) {
  const Groove& g = b.grooves.nut;
  const Structure::Nut& nut = b.structure.nut;
  const FlankSide side = pushed_flank(direction);
  const double thrust =
      direction == Direction::tension ? *nut.thrust.tension : *nut.thrust.compression;
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
  const GroovedBody body = mesh_grooved_body(
      shape, loaded_flanks(g, position, b.contacts, side, b.patches.nut, options.mesh.patch_cells),
      options.mesh);
  const Eigen::MatrixXd loads = patch_loads(body, 0);
  const std::vector<fe::MeridianEdge>& face = body.free_face(thrust);
  const std::vector<int> held =
      by_radius(body, nodes_of(face.empty() ? body.section(thrust) : face));
  Flexibility f;
  f.matrix = b.rollers * flexibility_on_face(body, b.materials.nut, held, loads,
                                             options.unilateral_thrust, f.unknowns);
  f.harmonics = 1;

  const std::vector<LoadedFlank> type{{0.0, side, b.patches.nut, options.mesh.patch_cells}};
  BlockSolver block(g, shape.far_radius, b.materials.nut, type, options);
  add_higher_harmonics(f, block, type, {false}, g.pitch_radius, b.materials.nut, b.rollers,
                       b.rollers, b.contacts, options);
  return f;
}

Flexibility roller_flexibility(const BodyGeometry& b, Direction direction,
                               const FlexibilityOptions& options) {
  const Groove& g = b.grooves.roller;
  const FlankSide screw_side = pushed_flank(direction), nut_side = pushing_flank(direction);
  GroovedShape shape;
  shape.groove = g;
  shape.start = -0.5 * g.pitch;
  shape.end = (b.contacts - 0.5) * g.pitch;
  shape.plain_end = PlainEnd{b.structure.roller.end_length, 0.5 * b.structure.roller.end_diameter};
  std::vector<LoadedFlank> flanks;
  for (int k = 0; k < b.contacts; ++k)
    flanks.push_back({k * g.pitch, screw_side, b.patches.screw, options.mesh.patch_cells});
  for (int k = 0; k < b.contacts; ++k)
    flanks.push_back({k * g.pitch, nut_side, b.patches.nut, options.mesh.patch_cells});
  const GroovedBody body = mesh_grooved_body(shape, flanks, options.mesh);
  const fe::Isotropic material = isotropic(b.materials.roller);

  Flexibility f;
  {
    const int on_axis = by_radius(body, nodes_of(body.section(shape.end))).front();
    fe::HarmonicBody solver(body.mesh, material, 0, axial_supports({on_axis}));
    f.unknowns = solver.unknowns();
    f.matrix = flexibility_of(solver, 0, patch_loads(body, 0));
  }
  {
    std::vector<fe::HarmonicSupport> supports;
    std::vector<fe::HarmonicSpring> springs;
    add_guidance(body, b.structure.roller, supports, springs);
    fe::HarmonicBody solver(body.mesh, material, 1, supports, springs);
    Eigen::MatrixXd loads = patch_loads(body, 1);
    loads.leftCols(b.contacts) *= -1.0;  // cos(theta) at theta = pi
    f.matrix += flexibility_of(solver, 1, loads);
  }
  f.harmonics = 2;
  const std::vector<LoadedFlank> types{{0.0, screw_side, b.patches.screw, options.mesh.patch_cells},
                                       {0.0, nut_side, b.patches.nut, options.mesh.patch_cells}};
  BlockSolver block(g, 0.0, b.materials.roller, types, options);
  add_higher_harmonics(f, block, types, {true, false}, g.pitch_radius, b.materials.roller, 2, 1,
                       b.contacts, options);
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
