#include "prs/mechanism/full_influence.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>

#include "prs/mechanism/full_structure.h"
#include "prs/sector/sector_model.h"
#include "support/coarse_bodies.h"
#include "support/sanitized.h"
#include "support/sectors.h"

namespace prs {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// All rollers of a screw under one load.
struct FullScrew {
  test::SectorCase parts;
  LoadCase load;

  explicit FullScrew(test::SectorCase c) : parts(std::move(c)) {
    parts.mechanism.centre_distance =
        0.5 * (*parts.mechanism.pitch_diameter.screw + *parts.mechanism.pitch_diameter.roller);
    parts.options.mechanism = ModelOptions::Mechanism::full;
    parts.structure.roller.rings.carrier = Rings::Carrier::housing;
    load.axial_force = 45e3;
    load.direction = parts.direction;
    load.position = parts.position;
  }
  FullModel model() const {
    return full_model(parts.mechanism, parts.structure, parts.materials, parts.options, parts.laws, load,
                      parts.deviations);
  }
};

/// Flexibilities of the beams of a model with all rollers and rings on the housing; stations of the screw are nodes,
/// without supports.
class BeamBodies {
 public:
  explicit BeamBodies(FullModel f) : f_(std::move(f)), s_(full_structure(alone(f_))) {
    fe::Model model = s_.model;
    const SpatialNode& end = s_.screw[static_cast<std::size_t>(s_.loaded)];
    for (const int node : {end.y_plane, end.z_plane})
      for (const fe::Dof dof : {fe::Dof::u, fe::Dof::v, fe::Dof::theta}) model.fixed_supports.push_back({node, dof});
    for (const FullStructure::Roller& r : s_.rollers)
      model.fixed_supports.push_back({r.contacts.screw.front(), fe::Dof::u});
    const fe::Equations equations(model);
    const fe::SparseSymmetric& k = equations.linear_stiffness();
    MatrixXd dense = MatrixXd::Zero(k.size(), k.size());
    for (int j = 0; j < k.size(); ++j)
      for (int e = k.column_start[static_cast<std::size_t>(j)]; e < k.column_start[static_cast<std::size_t>(j + 1)];
           ++e) {
        const int i = k.row[static_cast<std::size_t>(e)];
        dense(i, j) = dense(j, i) = k.value[static_cast<std::size_t>(e)];
      }
    compliance_ = dense.llt();
    const std::vector<double> stations = screw_stations(f_);
    stations_ = MatrixXd::Zero(k.size(), 2 * static_cast<Index>(stations.size()));
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const SpatialNode& node = *std::ranges::min_element(
          s_.screw, {}, [&](const SpatialNode& n) { return std::abs(n.x - f_.loaded_section - stations[i]); });
      for (const fe::Dof dof : {fe::Dof::v, fe::Dof::theta})
        if (const int e = equations.number(node.y_plane, dof); e >= 0 && e < equations.size())
          stations_(e, 2 * static_cast<Index>(i) + (dof == fe::Dof::v ? 0 : 1)) = 1.0;
    }
    screw_ = rows_of(equations, s_.screw);
    nut_ = rows_of(equations, s_.nut);
    springs_ = MatrixXd::Zero(k.size(), static_cast<Index>(equations.springs().size()));
    for (std::size_t c = 0; c < equations.springs().size(); ++c) {
      const fe::Equations::Spring& spring = equations.springs()[c];
      for (std::size_t t = 0; t < spring.count; ++t)
        springs_(spring.equation[t], static_cast<Index>(c)) = spring.coefficient[t];
    }
  }

  FullBodies bodies() const {
    FullBodies b;
    b.screw = around(screw_, Interface::screw);
    // Contacts push against their approach.
    const MatrixXd by_stations = compliance_.solve(stations_);
    b.screw.coupling = -springs_.leftCols(f_.threads()).transpose() * by_stations;
    b.screw.sections = stations_.transpose() * by_stations;
    b.nut = around(nut_, Interface::nut);
    const Index threads = f_.threads();
    const MatrixXd of_roller = (1.0 - (screw_ + nut_).array()).matrix().asDiagonal() * springs_.leftCols(2 * threads);
    b.roller = of_roller.transpose() * compliance_.solve(of_roller);
    return b;
  }

 private:
  /// Model without bearings, the first roller on the y axis.
  static FullModel alone(FullModel f) {
    for (Bearing& b : f.bearings) b.lateral = b.tilt = 0.0;
    for (FullModel::Roller& r : f.present) r.azimuth -= f.load.carrier_angle;
    return f;
  }
  static Eigen::VectorXd rows_of(const fe::Equations& equations, const std::vector<SpatialNode>& nodes) {
    Eigen::VectorXd rows = Eigen::VectorXd::Zero(equations.size());
    for (const SpatialNode& n : nodes)
      for (const int node : {n.y_plane, n.z_plane})
        for (const fe::Dof dof : {fe::Dof::u, fe::Dof::v, fe::Dof::theta})
          if (const int e = equations.number(node, dof); e >= 0 && e < equations.size()) rows[e] = 1.0;
    return rows;
  }

  /// Fourier sums over the rollers from the effect of the first one's contacts.
  FlexibilityAround around(const Eigen::VectorXd& rows, Interface i) const {
    const MatrixXd of_body = rows.asDiagonal() * springs_;
    const Index threads = f_.threads();
    const auto contacts = [&](std::size_t roller) {
      return of_body.middleCols(s_.rollers[roller].spring(i, 0), threads);
    };
    const MatrixXd by_first = compliance_.solve(MatrixXd(contacts(0)));
    FlexibilityAround f;
    for (int m = 0; m <= f_.rollers / 2; ++m) {
      MatrixXd mode = MatrixXd::Zero(threads, threads);
      for (int d = 0; d < f_.rollers; ++d)
        mode += std::cos(2.0 * std::numbers::pi * m * d / f_.rollers) *
                contacts(static_cast<std::size_t>(d)).transpose() * by_first;
      f.modes.push_back(mode);
    }
    return f;
  }

  FullModel f_;
  FullStructure s_;
  Eigen::LLT<MatrixXd> compliance_;
  Eigen::VectorXd screw_, nut_;
  MatrixXd springs_;   ///< Approaches, one column for each contact.
  MatrixXd stations_;  ///< Displacement and slope of each station of the screw.
};

double largest_of(const RollerThreads& loads) {
  double value = 0.0;
  for (const std::vector<double>& roller : loads) value = std::max(value, *std::ranges::max_element(roller));
  return value;
}

void expect_same(const FullDistribution& a, const FullDistribution& b, double share) {
  for (const FullDistribution* d : {&a, &b})
    ASSERT_TRUE(d->solve.converged()) << fe::name(d->solve.status) << ", residual " << d->solve.relative_residual
                                      << (d == &a ? "" : ", beams");
  for (const Interface i : kInterfaces)
    for (std::size_t j = 0; j < a.normal_load[i].size(); ++j)
      for (std::size_t k = 0; k < a.normal_load[i][j].size(); ++k)
        EXPECT_NEAR(a.normal_load[i][j][k], b.normal_load[i][j][k], share * largest_of(b.normal_load[i]));
  EXPECT_NEAR(a.axial_displacement, b.axial_displacement, share * b.axial_displacement);
  EXPECT_LT((a.screw_end.displacement - b.screw_end.displacement).norm(), share * b.screw_end.displacement.norm());
  EXPECT_LT((a.nut.force - b.nut.force).norm(), share * 45e3);
  EXPECT_NEAR(a.nut.moment.y, b.nut.moment.y, share * 45.0);
  EXPECT_NEAR(a.nut.moment.z, b.nut.moment.z, share * 45.0);
  for (std::size_t ring = 0; ring < 2; ++ring)
    for (std::size_t j = 0; j < a.rings[ring].rollers.size(); ++j)
      EXPECT_NEAR(a.rings[ring].rollers[j], b.rings[ring].rollers[j], 1e-6 * 45e3);
  ASSERT_EQ(a.bearings.size(), b.bearings.size());
  for (std::size_t k = 0; k < a.bearings.size(); ++k) {
    EXPECT_EQ(a.bearings[k].position, b.bearings[k].position);
    EXPECT_LT((a.bearings[k].force - b.bearings[k].force).norm(), 10.0 * share * 45e3);
    EXPECT_NEAR(a.bearings[k].moment.y, b.bearings[k].moment.y, share * 450.0);
    EXPECT_NEAR(a.bearings[k].moment.z, b.bearings[k].moment.z, share * 450.0);
  }
}

void expect_same_stiffness(const FullDistribution& a, const FullDistribution& b) {
  ASSERT_EQ(a.screw_end.freedoms, b.screw_end.freedoms);
  EXPECT_NEAR(*a.tangent_stiffness, *b.tangent_stiffness, 1e-9 * *b.tangent_stiffness);
  const Eigen::VectorXd size = b.screw_end.compliance.diagonal().cwiseSqrt();
  for (Index i = 0; i < size.size(); ++i)
    for (Index j = 0; j < size.size(); ++j)
      EXPECT_NEAR(a.screw_end.compliance(i, j), b.screw_end.compliance(i, j), 1e-9 * size[i] * size[j]);
}

/// Rings on the housing at the outer nodes guide rollers as lines, so that nothing is neglected.
TEST(FullInfluence, BeamsFlexibilitiesGiveTheBeamModel) {
  FullScrew screw(test::abevi());
  screw.parts.structure.roller.guidance.kind = Guidance::Kind::outer_node;
  const FullModel all = screw.model();
  const FullBodies beams = BeamBodies(all).bodies();
  const auto agrees = [&](const char* what) {
    SCOPED_TRACE(what);
    const FullModel f = screw.model();
    const FullDistribution bars = solve(f), dense = solve(f, beams);
    expect_same(dense, bars, 1e-10);
    ASSERT_EQ(dense.screw_end.compliance.rows(), 5);
    expect_same_stiffness(dense, bars);
  };
  agrees("equal rollers");
  screw.load.spatial.side_force.value = {1e3, -500.0};
  screw.load.spatial.moment.value = {20.0, 40.0};
  screw.load.spatial.eccentricity = {0.5e-3, 0.2e-3};
  agrees("side loads");
  screw.parts.deviations.missing_rollers = {3, 4};
  screw.parts.deviations.roller_diameters = {2e-6, 0, 0, 0, 1e-6, 0, 0, 3e-6, 0, 0, 0};
  screw.parts.deviations.index_error.screw = {1e-6, 0.0, -1e-6};
  agrees("unequal rollers");
  screw.parts.deviations.roller_position.near.assign(11, 2e-6);
  screw.parts.deviations.roller_position.far.assign(11, -1e-6);
  screw.parts.deviations.roller_position.far[5] = 4e-6;
  agrees("rollers out of place");
  screw.parts.structure.nut.housing = {5e8, 3e8, 2e5};
  screw.load.spatial.nut_tilt = {2e-4, 1e-4};
  screw.load.spatial.nut_offset = {1e-5, 0.0};
  agrees("elastic housing, displaced seat");
  screw.parts.structure.roller.rings.stiffness = 2e6;
  agrees("floating rings");
}

/// Rings of 10 N/m move a hundred times as far as contacts approach.
TEST(FullInfluence, SoftRingsConvergeToTheBeamModel) {
  FullScrew screw(test::abevi());
  screw.parts.structure.roller.guidance.kind = Guidance::Kind::outer_node;
  const FullBodies beams = BeamBodies(screw.model()).bodies();
  screw.load.spatial.side_force.value = {1e3, -500.0};
  screw.load.spatial.moment.value = {20.0, 40.0};
  for (const double stiffness : {2e5, 2e4, 1e3, 10.0}) {
    SCOPED_TRACE(stiffness);
    screw.parts.structure.roller.rings.stiffness = stiffness;
    const FullModel f = screw.model();
    expect_same(solve(f, beams), solve(f), 1e-8);
  }
}

/// Bearings and places of loads, also with few rollers, two of which lie on one line.
TEST(FullInfluence, BearingsAndPlacesOfLoadsAreThoseOfTheBeamModel) {
  FullScrew screw(test::abevi());
  screw.parts.structure.roller.guidance.kind = Guidance::Kind::outer_node;
  screw.parts.structure.screw.far_length = 60e-3;
  screw.parts.structure.screw.free_length = 40e-3;
  const auto agrees = [&](const char* what) {
    SCOPED_TRACE(what);
    FullScrew all = screw;
    all.parts.deviations = {};
    const FullModel f = screw.model();
    const FullDistribution bars = solve(f), dense = solve(f, BeamBodies(all.model()).bodies());
    expect_same(dense, bars, 1e-10);
    expect_same_stiffness(dense, bars);
  };
  const double first = screw.parts.position, last = first + 19.0 * axial_pitch(screw.parts.mechanism);
  SpatialLoad& load = screw.load.spatial;
  load.side_force = {{800.0, -300.0}, first - 12e-3};
  load.moment = {{20.0, 10.0}, last + 40e-3};
  agrees("loads at places of their own");
  screw.parts.structure.screw.bearings = {{first - 25e-3, 2e8, 0.0, {2e-5, -1e-5}, {}},
                                          {last + 30e-3, kRigid, 3e4, {}, {1e-4, 2e-4}}};
  agrees("elastic and rigid bearings, displaced and tilted");
  load.carrier_angle = 0.3;
  load.nut_tilt = {2e-4, 1e-4};
  load.nut_offset = {1e-5, 0.0};
  agrees("a displaced seat, the carrier turned");
  screw.parts.structure.screw.bearings[0] = {first - 40e-3, kRigid, kRigid, {}, {}};
  agrees("the loaded section held");
  screw.parts.mechanism.rollers = 2;
  agrees("two rollers");
  screw.parts.mechanism.rollers = 4;
  screw.parts.deviations.missing_rollers = {2};
  agrees("three of four rollers");
}

TEST(FullInfluence, ALoadThatNothingHoldsHasNoEquilibrium) {
  FullScrew screw(test::abevi());
  const FullBodies beams = BeamBodies(screw.model()).bodies();
  screw.load.spatial.side_force.value = {60e3, 0.0};
  const FullDistribution d = solve(screw.model(), beams);
  EXPECT_EQ(d.solve.status, fe::NewtonStatus::no_equilibrium);
  screw.load.spatial.side_force.value = {};
  screw.parts.deviations.missing_rollers = {2, 3, 4, 5, 6, 8, 9, 10, 11};
  EXPECT_EQ(solve(screw.model(), beams).solve.status, fe::NewtonStatus::mechanism);
}

/// Load at which the pressure of a thin ring, of a disc and of the face of a flange is zero at the edge.
TEST(FullInfluence, AShoulderLiftsOffWhereItsPressureEnds) {
  Structure::Nut nut;
  nut.length = 90e-3;
  nut.outer_diameter = 46e-3;
  nut.flanges = {{0.0, 10e-3, 62e-3}};
  const SupportForce seat{10e-3, {-1000.0, 300.0, 0.0}, {}};
  nut.shoulder = Structure::Shoulder{60e-3, 60e-3};
  EXPECT_NEAR(lifting_moment(nut, seat), 1000.0 * 30e-3 / 2.0, 1e-9);
  nut.shoulder = Structure::Shoulder{0.0, 60e-3};
  EXPECT_NEAR(lifting_moment(nut, seat), 1000.0 * 30e-3 / 4.0, 1e-9);
  nut.shoulder.reset();
  const double area = ring_area(62e-3, 46e-3);
  const double second = std::numbers::pi / 64.0 * (std::pow(62e-3, 4) - std::pow(46e-3, 4));
  EXPECT_NEAR(1000.0 / area, lifting_moment(nut, seat) * 31e-3 / second, 1e-6 * 1000.0 / area);
}

/// Coarse finite elements of a short screw.
struct CoarseBodies {
  FullScrew screw{test::short_screw()};
  BodyGeometry geometry;
  MatrixCache cache;

  CoarseBodies() {
    const PerInterface<HertzPatch> patches{{0.227e-3, 0.178e-3}, {0.198e-3, 0.242e-3}};
    geometry = body_geometry(screw.parts.mechanism, screw.parts.structure, screw.parts.materials, screw.parts.laws,
                             patches, screw.parts.direction, screw.parts.options);
  }
  BodyFlexibilities alike() {
    return body_flexibilities(geometry, screw.parts.direction, screw.parts.position, test::coarse_bodies(), cache);
  }
  FullBodies full(const std::vector<double>& on_screw, const std::vector<double>& on_nut) {
    const BodyFlexibilities sector = alike();
    return {screw_around(geometry, screw.parts.direction, on_screw, test::coarse_bodies(), cache),
            nut_around(geometry, screw.parts.direction, screw.parts.position, on_nut, test::coarse_bodies(), cache),
            sector.roller.matrix, sector.nut.face};
  }
};

TEST(FullInfluence, IsTheInfluenceModelWhereAllRollersAreAlike) {
  SKIP_UNDER_SANITIZERS();
  CoarseBodies bodies;
  FullScrew& screw = bodies.screw;
  screw.parts.structure.roller.rings.carrier = Rings::Carrier::nut;
  const FullModel f = screw.model();
  const std::array<double, 2> at = guide_places(f);
  const FullDistribution full = solve(f, bodies.full({}, {std::max(at[0], 0.0), std::min(at[1], f.sector.nut_length)}));
  const LoadDistribution one =
      InfluenceSolver(bodies.alike(), f.rollers, screw.parts.laws, f.present[0].gaps).solve(f.axial_force);
  ASSERT_TRUE(full.solve.converged() && one.solve.converged());
  EXPECT_NEAR(full.axial_displacement, one.axial_displacement, 1e-10 * one.axial_displacement);
  EXPECT_NEAR(*full.tangent_stiffness, *one.tangent_stiffness, 1e-9 * *one.tangent_stiffness);
  for (const Interface i : kInterfaces)
    for (const std::vector<double>& roller : full.normal_load[i])
      for (std::size_t k = 0; k < roller.size(); ++k)
        EXPECT_NEAR(roller[k], one.normal_load[i][k], 1e-10 * largest_of(full.normal_load[i]));
}

/// G between rollers that are `spacings` apart, for N rollers.
Eigen::MatrixXd between(const FlexibilityAround& around, int spacings, int rollers) {
  Eigen::MatrixXd g = around.modes.front();
  for (std::size_t m = 1; m < around.modes.size(); ++m) {
    const auto order = static_cast<double>(m);
    const double weight = 2 * static_cast<int>(m) == rollers ? 1.0 : 2.0;
    g += weight * std::cos(2.0 * std::numbers::pi * order * spacings / rollers) * around.modes[m];
  }
  return g / rollers;
}

/// The effect of a load does not depend on the number of rollers counted between.
TEST(FlexibilityAround, IsTheSameForTwiceAsManyRollers) {
  SKIP_UNDER_SANITIZERS();
  CoarseBodies bodies;
  BodyGeometry& g = bodies.geometry;
  const test::SectorCase& c = bodies.screw.parts;
  for (const Part part : {Part::screw, Part::nut}) {
    const auto at = [&](int rollers) {
      g.rollers = rollers;
      return part == Part::screw ? screw_around(g, c.direction, {}, test::coarse_bodies(), bodies.cache)
                                 : nut_around(g, c.direction, c.position, {}, test::coarse_bodies(), bodies.cache);
    };
    const FlexibilityAround seven = at(7), fourteen = at(14);
    const double own = between(seven, 0, 7).diagonal().cwiseAbs().maxCoeff();
    for (int d = 0; d <= 3; ++d)
      EXPECT_LT((between(seven, d, 7) - between(fourteen, 2 * d, 14)).cwiseAbs().maxCoeff(), 0.01 * own)
          << name(part) << d;
  }
}

/// A clamped beam with a section between core and pitch diameter, with and without shear, under its contacts: the
/// flank's normal points inwards.
TEST(FlexibilityAround, TheScrewBendsAsABeam) {
  SKIP_UNDER_SANITIZERS();
  const test::SectorCase c = test::abevi();
  const PerInterface<HertzPatch> patches{{0.227e-3, 0.178e-3}, {0.198e-3, 0.242e-3}};
  const BodyGeometry g = body_geometry(c.mechanism, c.structure, c.materials, c.laws, patches, c.direction, c.options);
  const double end = 41e-3;
  const FlexibilityAround f = screw_around(g, c.direction, {end}, test::coarse_bodies());
  const Groove& groove = g.grooves.screw;
  const auto beam = [&](double radius) {
    return ring_rigidity(c.materials.screw, 2.0 * radius, c.structure.screw.bore, true);
  };
  const RollerSection<double> pitch = beam(groove.pitch_radius);
  const RollerSection<double> core = beam(groove.radius(-groove.dedendum));
  EXPECT_GT(f.sections(0, 0), end * end * end / (3.0 * pitch.bending) + end / pitch.shear);
  EXPECT_LT(f.sections(0, 0), end * end * end / (3.0 * core.bending) + 2.0 * end / core.shear);
  const Index last = f.coupling.rows() - 1;
  const double x = c.structure.screw.free_length + static_cast<double>(last) * g.pitch();
  // A moment's displacement is a force's slope; a unit force moves the threads x (2 l - x)/2.
  EXPECT_NEAR(f.sections(0, 1), f.sections(1, 0), 1e-9 * f.sections(0, 1));
  EXPECT_GT(f.sections(0, 1), end * end / (2.0 * pitch.bending));
  EXPECT_LT(f.sections(0, 1), end * end / (2.0 * core.bending));
  EXPECT_GT(f.sections(1, 1), end / pitch.bending);
  EXPECT_LT(f.sections(1, 1), end / core.bending);
  const double v = x * x * (3.0 * end - x) / 6.0, slope = x * (2.0 * end - x) / 2.0;
  const double cosine = std::cos(c.laws.screw.normal_angle), sense = -1.0;
  const double sine = std::sin(c.laws.screw.normal_angle);
  const double normal = -(sine * v - sense * cosine * groove.pitch_radius * slope);
  EXPECT_LT(f.coupling(last, 0), normal / pitch.bending);
  EXPECT_GT(f.coupling(last, 0), 1.15 * normal / core.bending);
}

/// Behind the body the screw is a beam: a force there acts as a force and a moment at the body's end.
TEST(FlexibilityAround, TheScrewGoesOnBehindItsThread) {
  CoarseBodies bodies;
  const test::SectorCase& c = bodies.screw.parts;
  const double end = c.structure.screw.free_length + 5.0 * bodies.geometry.pitch() + 3.0 * bodies.geometry.pitch();
  const double length = 50e-3;
  const FlexibilityAround f =
      screw_around(bodies.geometry, c.direction, {end, end + length}, test::coarse_bodies(), bodies.cache);
  const RollerSection<double> beam =
      ring_rigidity(c.materials.screw, *c.mechanism.pitch_diameter.screw, c.structure.screw.bore, true);
  EXPECT_LT((f.coupling.col(2) - f.coupling.col(0) - length * f.coupling.col(1)).norm(),
            1e-12 * f.coupling.col(2).norm());
  const Eigen::Matrix2d at_end = f.sections.topLeftCorner(2, 2), behind = f.sections.bottomRightCorner(2, 2);
  EXPECT_NEAR(behind(1, 1), at_end(1, 1) + length / beam.bending, 1e-12 * behind(1, 1));
  EXPECT_NEAR(behind(0, 0),
              at_end(0, 0) + 2.0 * length * at_end(0, 1) + length * length * at_end(1, 1) +
                  length * length * length / (3.0 * beam.bending) + length / beam.shear,
              1e-12 * behind(0, 0));
  EXPECT_NEAR(f.sections(0, 2), at_end(0, 0) + length * at_end(0, 1), 1e-12 * behind(0, 0));
}

}  // namespace
}  // namespace prs
