#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/loads/full_result.h"
#include "prs/losses/solve_analysis.h"
#include "prs/mechanism/full_distribution.h"
#include "prs/mechanism/full_structure.h"
#include "prs/sector/sector.h"
#include "prs/threads/contacts.h"
#include "support/count.h"
#include "support/full_mechanism.h"
#include "support/sanitized.h"
#include "support/sectors.h"

namespace prs {
namespace {

using nlohmann::json;
using test::largest;
using test::largest_difference;
using testing::HasSubstr;

/// Solved cases of an independent program, 12 digits.
const json& reference() {
  static const json cases = json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/mechanism/reference_cases.json"));
  return cases;
}

Case case_of(const json& reference_case) {
  return input::read_case_text(reference_case.at("input").dump(), "case", {}, Command::solve);
}

/// Compares every number of the reference with that of the document, within a share of the largest number in its array:
/// components that are zero by symmetry are rounding.
void expect_near(const json& wanted, const json& got, double share, const std::string& path, double scale = 0.0) {
  if (wanted.is_object()) {
    for (const auto& [key, value] : wanted.items()) {
      if (key == "dofs") continue;  // Additional nodes change nothing.
      ASSERT_TRUE(got.contains(key)) << path << "." << key;
      expect_near(value, got.at(key), share, path + "." + key);
    }
  } else if (wanted.is_array()) {
    ASSERT_EQ(wanted.size(), got.size()) << path;
    std::function<void(const json&)> enlarge = [&](const json& item) {
      if (item.is_array()) std::ranges::for_each(item, enlarge);
      if (item.is_number()) scale = std::max(scale, std::abs(item.get<double>()));
    };
    enlarge(wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i)
      expect_near(wanted[i], got[i], share, path + "[" + std::to_string(i) + "]", scale);
  } else if (wanted.is_number_float()) {
    const double value = wanted.get<double>();
    EXPECT_NEAR(got.get<double>(), value, share * std::max(std::abs(value), scale) + 1e-9) << path;
  } else {
    EXPECT_EQ(wanted, got) << path;
  }
}

TEST(FullMechanism, AgreesWithAnIndependentProgram) {
  for (const json& reference_case : reference().at("cases")) {
    SCOPED_TRACE(reference_case.at("name").get<std::string>());
    const Case c = case_of(reference_case);
    json wanted = reference_case.at("result");
    // The other program keeps the moment of an eccentric force constant: 1/C_xx. Its own compliance contains the rest.
    if (const Lateral& e = c.load_cases[0].spatial.eccentricity; e.y != 0.0 || e.z != 0.0) {
      const json& row = wanted.at("screw_end").at("compliance_SI").at(0);
      ASSERT_EQ(row.size(), 5u);
      wanted["tangent_stiffness_N_per_um"] =
          1e-6 / (row[0].get<double>() + e.z * row[3].get<double>() - e.y * row[4].get<double>());
    }
    const json document = json::parse(document_of(solve_analysis(), analyze(c), {}).dump());
    expect_near(wanted, document.at("load_cases").at(0), 1e-8, "");
  }
}

TEST(FullMechanism, TwoRollersCannotHoldTheScrew) {
  const Result result = analyze(case_of(reference().at("errors").at(0)));
  EXPECT_EQ(result.load_cases[0].solve->status, fe::NewtonStatus::mechanism);
  EXPECT_THAT(sentences(result.load_cases[0].warnings),
              testing::Contains("mechanism: 2 motions of screw meet no resistance"));
}

TEST(FullMechanism, RollersOnOneSideCannotHoldTheLoad) {
  const Result result = analyze(case_of(reference().at("errors").at(1)));
  EXPECT_EQ(result.load_cases[0].solve->status, fe::NewtonStatus::no_equilibrium);
  EXPECT_THAT(sentences(result.load_cases[0].warnings),
              testing::Contains(HasSubstr("flanks that only push cannot hold this load")));
}

FullModel model_of(const Case& c, const LoadCase& load) {
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  return full_model(contacts.mechanism, *c.structure, *c.materials, c.model, contact_laws(c, contacts), load,
                    c.deviations);
}
FullModel model_of(const Case& c) { return model_of(c, c.load_cases[0]); }

Case symmetric_case() { return case_of(reference().at("cases").at(0)); }

Case side_loaded() {
  Case c = symmetric_case();
  c.load_cases[0].spatial.side_force.value = {1e3, -500.0};
  c.load_cases[0].spatial.moment.value = {20.0, 40.0};
  c.load_cases[0].spatial.eccentricity = {0.5e-3, 0.2e-3};
  return c;
}

TEST(FullMechanism, IsTheSectorWhereAllRollersAreAlike) {
  Case c = symmetric_case();
  c.deviations.crowning = 3e-6;
  c.deviations.pitch_error.screw.linear = 2e-6;
  c.structure->roller.guidance.ring_stiffness = 2e7;
  for (const auto kind : {Guidance::Kind::both_end_nodes, Guidance::Kind::outer_node, Guidance::Kind::ring})
    for (const auto carrier : {Rings::Carrier::housing, Rings::Carrier::nut, Rings::Carrier::screw})
      for (const double stiffness : {kRigid, 1e6})
        for (const Direction direction : {Direction::tension, Direction::compression}) {
          c.structure->roller.guidance.kind = kind;
          c.structure->roller.rings = {carrier, stiffness};
          c.load_cases[0].direction = direction;
          test::expect_the_sector(model_of(c));
        }
}

/// x of the middle of the first guide ring, limited to the nut.
double first_ring(const Case& c) {
  const FullModel f = model_of(c);
  return std::clamp(f.roller_ends.first + 0.5 * f.sector.end_length, 0.0, c.structure->nut.length);
}

/// Screws of all kinds that are difficult for the solver.
Case random_case(std::mt19937_64& random) {
  const auto between = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const auto one_of = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  const auto magnitude = [&](double a, double b) { return std::pow(10.0, between(a, b)); };
  Case c = symmetric_case();
  Mechanism& m = c.mechanism;
  Structure& s = *c.structure;
  Deviations& d = c.deviations;
  LoadCase& load = c.load_cases[0];
  m.rollers = 2 + one_of(11);
  m.contacts_per_roller = 1 + one_of(22);
  m.lead = one_of(2) ? 5e-3 : -5e-3;
  load.direction = one_of(2) ? Direction::tension : Direction::compression;
  load.axial_force = magnitude(2.5, 5.0);
  const double span = (m.contacts_per_roller - 1) * axial_pitch(m);
  load.position = between(0.0, s.nut.length - span);
  if (one_of(4) == 0) c.model.contact_phase = ModelOptions::ContactPhase::helical;
  c.model.shear = one_of(2) == 0;
  s.screw.free_length = one_of(4) ? between(0.0, 60e-3) : 0.0;
  s.screw.far_length = one_of(2) ? between(0.0, 40e-3) : 0.0;
  s.roller.rings.carrier = static_cast<Rings::Carrier>(one_of(3));
  if (one_of(4) == 0) s.roller.rings.stiffness = magnitude(0.0, 9.0);
  s.roller.guidance = {static_cast<Guidance::Kind>(one_of(3)), magnitude(5.0, 8.0)};
  if (one_of(3) == 0)
    s.nut.housing = {one_of(2) ? kRigid : magnitude(7.0, 10.0), magnitude(6.0, 10.0), magnitude(3.0, 7.0)};
  const double first = *load.position - s.screw.free_length;
  const double last = *load.position + span + s.screw.far_length;
  for (int b = first < last ? one_of(3) : 1; b > 0; --b) {
    const double tilts[] = {0.0, kRigid, magnitude(2.0, 6.0)};
    s.screw.bearings.push_back({between(first, last),
                                one_of(2) ? kRigid : magnitude(6.0, 9.0),
                                tilts[one_of(3)],
                                {between(-2e-5, 2e-5), between(-2e-5, 2e-5)},
                                {}});
  }
  for (int j = 0; j < m.rollers && one_of(2); ++j) d.roller_diameters.push_back(between(-5e-6, 5e-6));
  d.roller_diameters.resize(d.roller_diameters.empty() ? 0 : static_cast<std::size_t>(m.rollers));
  for (int j = 1; j < m.rollers; ++j)
    if (one_of(12) == 0) d.missing_rollers.push_back(j);
  if (one_of(3) == 0)
    for (const Interface i : kInterfaces)
      for (int k = 0; k < 3; ++k) d.index_error[i].push_back(between(-5e-6, 5e-6));
  if (one_of(3) == 0) d.thread_eccentricity.nut = {between(-5e-6, 5e-6), between(-5e-6, 5e-6)};
  SpatialLoad& spatial = load.spatial;
  spatial.carrier_angle = between(0.0, 6.28);
  if (one_of(2)) spatial.eccentricity = {between(-3e-3, 3e-3), between(-3e-3, 3e-3)};
  if (one_of(2))
    spatial.side_force = {{between(-0.6, 0.6) * load.axial_force, 0.1 * load.axial_force}, between(first, last)};
  if (one_of(3) == 0) spatial.moment = {{between(-0.01, 0.01) * load.axial_force, 1.0}, {}};
  if (one_of(3) == 0) spatial.nut_tilt = {between(-2e-3, 2e-3), between(-2e-3, 2e-3)};
  if (one_of(4) == 0) s.nut.thrust.tension = s.nut.thrust.compression = first_ring(c);
  return c;
}

/// Forces and moments about the nut's near end on the whole mechanism, over the largest of the forces: two bearings
/// that are close together can push against each other with any force.
double imbalance(const FullModel& f, const FullDistribution& d) {
  const SpatialLoad& load = f.load;
  double fx = f.sense() * f.axial_force + d.nut.force[0];
  Eigen::Vector2d force{load.side_force.value.y + d.nut.force[1], load.side_force.value.z + d.nut.force[2]};
  // M_z and -M_y, in the planes x-y and x-z.
  const auto arm = [](double x, double y, double z) { return Eigen::Vector2d(x * y, x * z); };
  const double at = load.side_force.at.value_or(f.loaded_section);
  Eigen::Vector2d moment =
      arm(at, load.side_force.value.y, load.side_force.value.z) + arm(d.nut.position, d.nut.force[1], d.nut.force[2]) +
      Eigen::Vector2d(load.moment.value.z, -load.moment.value.y) + Eigen::Vector2d(d.nut.moment.z, -d.nut.moment.y) -
      f.sense() * f.axial_force * Eigen::Vector2d(load.eccentricity.y, load.eccentricity.z);
  for (const SupportForce& b : d.bearings) {
    force += b.force.tail<2>();
    moment += arm(b.position, b.force[1], b.force[2]) + Eigen::Vector2d(b.moment.z, -b.moment.y);
  }
  if (f.carrier == Rings::Carrier::housing) {
    for (std::size_t r = 0; r < d.rings.size(); ++r) {
      const Lateral& ring = d.rings[r].force;
      force += Eigen::Vector2d(ring.y, ring.z);
      moment += arm(d.rings[r].position, ring.y, ring.z) + Eigen::Vector2d(d.rings[r].moment.z, -d.rings[r].moment.y);
    }
  }
  double largest = f.axial_force;
  for (const SupportForce& b : d.bearings) largest = std::max(largest, b.force.norm());
  return std::max({std::abs(fx), force.norm(), moment.norm() / f.centre_distance}) / largest;
}

/// Forces and moments about the origin of a document's load case, over the largest force.
double imbalance_of(const json& load_case, double force, const Case& c) {
  Eigen::Vector3d sum{force, 0.0, 0.0}, moment = Eigen::Vector3d::Zero();
  double largest = std::abs(force);
  const auto add = [&](const json& support, bool along) {
    const json& f = support.at("force_N");
    const std::size_t first = along ? 1 : 0;
    const Eigen::Vector3d pull{along ? f[0].get<double>() : 0.0, f[first].get<double>(), f[first + 1].get<double>()};
    const Eigen::Vector3d at{1e-3 * support.at("at_mm").get<double>(), 0.0, 0.0};
    sum += pull;
    moment += at.cross(pull) +
              Eigen::Vector3d(0.0, support.at("moment_Nm")[0].get<double>(), support.at("moment_Nm")[1].get<double>());
    largest = std::max(largest, pull.norm());
  };
  const json& reactions = load_case.at("reactions");
  add(reactions.at("nut"), true);
  for (const json& bearing : reactions.at("bearings")) add(bearing, false);
  if (c.structure->roller.rings.carrier == Rings::Carrier::housing)
    for (const json& ring : reactions.at("rings")) add(ring, false);
  return std::max(sum.norm(), moment.norm() / *c.mechanism.centre_distance) / largest;
}

TEST(FullMechanism, ADocumentClosesItsBalance) {
  for (const char* rings : {"nut", "housing"}) {
    const Case c = input::read_case(PRS_SOURCE_DIR "/configs/24_misalignment.yaml",
                                    {std::string("structure.roller.rings=") + rings,
                                     "structure.roller.guidance=outer_node", "load_cases[0].carrier_angle=20 deg"},
                                    Command::solve);
    const json document = json::parse(document_of(solve_analysis(), analyze(c), {}).dump());
    for (const json& load_case : document.at("load_cases")) EXPECT_LT(imbalance_of(load_case, -45e3, c), 1e-9) << rings;
  }
}

/// A ring then follows a node of nut or screw, which follows its seat.
TEST(FullMechanism, ARingMayStandWhereItsCarrierIsHeld) {
  const auto expect_limit_of_stiff_seats = [](const Case& rigid, const Case& stiff) {
    const FullModel f = model_of(rigid);
    const FullDistribution held = solve(f), nearly = solve(model_of(stiff));
    ASSERT_TRUE(held.solve.converged());
    ASSERT_TRUE(nearly.solve.converged());
    EXPECT_LT(imbalance(f, held), 1e-9);
    for (const Interface i : kInterfaces)
      EXPECT_LT(largest_difference(held.normal_load[i], nearly.normal_load[i]), 1e-6 * largest(held.normal_load[i]));
  };
  const double ring = first_ring(side_loaded());
  Case c = side_loaded();
  c.structure->nut.thrust.tension = ring;
  Case stiff = c;
  stiff.structure->nut.housing = {1e18, 1e18, 1e14};
  expect_limit_of_stiff_seats(c, stiff);

  c = side_loaded();
  c.structure->roller.rings.carrier = Rings::Carrier::screw;
  c.structure->screw.bearings = {{ring, kRigid, kRigid, {1e-5, 0.0}, {}}};
  stiff = c;
  stiff.structure->screw.bearings[0].lateral = 1e18;
  stiff.structure->screw.bearings[0].tilt = 1e14;
  expect_limit_of_stiff_seats(c, stiff);
}

/// Each case converges, or has a free motion, or has no equilibrium, for which a linear programme is the certificate:
/// least squares over pushing contacts leave some of the load.
TEST(FullMechanism, RandomCasesConvergeOrHaveNoEquilibrium) {
  std::mt19937_64 random(20261122);
  int converged = 0;
  const int count = test::samples(60, 3000);
  for (int k = 0; k < count; ++k) {
    SCOPED_TRACE(k);
    const Case c = random_case(random);
    const FullModel f = model_of(c);
    const FullDistribution d = solve(f);
    const FullStructure s = full_structure(f);
    if (d.solve.converged()) {
      ++converged;
      EXPECT_LT(imbalance(f, d), 1e-9);
      EXPECT_LT(load_left(f, s), 1e-9);
    } else if (d.solve.status == fe::NewtonStatus::mechanism) {
      EXPECT_GT(free_motions(f, s).count, 0);
    } else {
      EXPECT_EQ(d.solve.status, fe::NewtonStatus::no_equilibrium)
          << d.solve.iterations() << " steps, residual " << d.solve.relative_residual;
      EXPECT_GT(load_left(f, s), 1e-6);
    }
  }
  EXPECT_GT(converged, count / 2);
}

TEST(FullMechanism, TurnsWithItsLoads) {
  const double angle = 0.7;
  Case c = side_loaded();
  const FullDistribution before = solve(model_of(c));
  SpatialLoad& load = c.load_cases[0].spatial;
  load.carrier_angle += angle;
  for (Lateral* l : {&load.side_force.value, &load.moment.value, &load.eccentricity}) *l = test::turned(*l, angle);
  const FullDistribution after = solve(model_of(c));
  for (const Interface i : kInterfaces)
    EXPECT_LT(largest_difference(before.normal_load[i], after.normal_load[i]), 1e-10 * largest(before.normal_load[i]));
  EXPECT_NEAR(before.axial_displacement, after.axial_displacement, 1e-10 * before.axial_displacement);
}

TEST(FullMechanism, ASpacingOfTheCarrierRenumbersTheRollers) {
  Case c = side_loaded();
  const FullDistribution before = solve(model_of(c));
  c.load_cases[0].spatial.carrier_angle = 2.0 * std::numbers::pi / 11.0;
  FullDistribution after = solve(model_of(c));
  for (const Interface i : kInterfaces) {
    std::rotate(after.normal_load[i].begin(), after.normal_load[i].end() - 1, after.normal_load[i].end());
    EXPECT_LT(largest_difference(before.normal_load[i], after.normal_load[i]), 1e-10 * largest(before.normal_load[i]));
  }
}

TEST(FullMechanism, LoadsInAPlaneOfSymmetryLoadBothSidesAlike) {
  Case c = symmetric_case();
  c.load_cases[0].spatial.side_force.value = {2e3, 0.0};
  const FullDistribution d = solve(model_of(c));
  for (const Interface i : kInterfaces)
    for (std::size_t j = 1; j < 11; ++j)
      for (std::size_t k = 0; k < 20; ++k)
        EXPECT_NEAR(d.normal_load[i][j][k], d.normal_load[i][11 - j][k], 1e-10 * largest(d.normal_load[i]));
}

/// Central differences of the displacement by each load, relative to the compliances themselves.
void expect_derivatives(const Case& c, const FullDistribution& d, double share) {
  ASSERT_EQ(d.screw_end.freedoms, (std::vector{0, 1, 2, 3, 4}));
  const Eigen::MatrixXd& compliance = d.screw_end.compliance;
  EXPECT_LT((compliance - compliance.transpose()).norm(), 1e-11 * compliance.norm());
  const double steps[] = {40.0, 40.0, 40.0, 0.2, 0.2};
  for (int k = 0; k < 5; ++k) {
    const auto moved = [&](double step) {
      LoadCase load = c.load_cases[0];
      // At the loaded section an axial force shifts the moment of the eccentricity too.
      SpatialLoad& s = load.spatial;
      s.moment.value.z -= sense(*load.direction) * load.axial_force * s.eccentricity.y;
      s.moment.value.y += sense(*load.direction) * load.axial_force * s.eccentricity.z;
      s.eccentricity = {};
      double* const loads[] = {&load.axial_force, &s.side_force.value.y, &s.side_force.value.z, &s.moment.value.y,
                               &s.moment.value.z};
      *loads[k] += k == 0 ? sense(*load.direction) * step : step;
      return Eigen::VectorXd(solve(model_of(c, load)).screw_end.displacement);
    };
    const Eigen::VectorXd slope = (moved(steps[k]) - moved(-steps[k])) / (2.0 * steps[k]);
    for (Eigen::Index i = 0; i < 5; ++i)
      EXPECT_NEAR(slope[i], compliance(i, k), share * std::sqrt(compliance(i, i) * compliance(k, k)));
  }
}

TEST(FullMechanism, TheComplianceOfTheScrewsEndIsTheDerivative) {
  const Case c = side_loaded();
  expect_derivatives(c, solve(model_of(c)), 1e-5);
}

/// An idle roller connects the rings, here on the screw: without it, the screw tilts by 0.3 % more.
TEST(FullMechanism, AnIdleRollerStillHoldsTheRingsTogether) {
  Case c = symmetric_case();
  c.structure->roller.rings.carrier = Rings::Carrier::screw;
  c.deviations.roller_diameters.assign(11, 0.0);
  c.deviations.roller_diameters[0] = -50e-6;
  const FullDistribution d = solve(model_of(c));
  ASSERT_EQ(d.idle_rollers, std::vector{0});
  expect_derivatives(c, d, 1e-5);
}

/// The moments of a force off the axis grow with it.
TEST(FullMechanism, TheTangentStiffnessUnderAnEccentricForceIsTheDerivative) {
  Case c = side_loaded();
  c.load_cases[0].spatial.eccentricity = {3e-3, -2e-3};
  c.load_cases[0].spatial.carrier_angle = 0.4;
  for (const Direction direction : kDirections) {
    LoadCase load = c.load_cases[0];
    load.direction = direction;
    const auto moved = [&](double step) {
      LoadCase other = load;
      other.axial_force += step;
      return solve(model_of(c, other)).axial_displacement;
    };
    const double tangent = *solve(model_of(c, load)).tangent_stiffness;
    EXPECT_NEAR(80.0 / (moved(40.0) - moved(-40.0)) / tangent, 1.0, 1e-6);
  }
}

/// A bearing at the loaded section takes the moment of an eccentric force.
TEST(FullMechanism, AHeldSlopeLeavesTheEccentricityOutOfTheTangentStiffness) {
  Case c = symmetric_case();
  const double end = model_of(c).loaded_section;
  c.structure->screw.bearings = {{end, kRigid, kRigid, {}, {}}};
  const double along_axis = *solve(model_of(c)).tangent_stiffness;
  c.load_cases[0].spatial.eccentricity = {3e-3, 0.0};
  EXPECT_NEAR(*solve(model_of(c)).tangent_stiffness / along_axis, 1.0, 1e-10);
}

TEST(FullMechanism, AnOrbitOfUnlikeRollersIsSolvedThroughout) {
  Case c = side_loaded();
  const auto at = [&](double angle) {
    LoadCase load = c.load_cases[0];
    load.spatial.carrier_angle = angle;
    return model_of(c, load);
  };
  const SpatialLoad::Orbit wanted{2, 3.0};
  FullSolver solver;
  const auto loads = [&](const FullModel& f) { return solver.solve(f, Detail::numbers); };
  const Orbit permuted = orbit(at, loads, wanted, 0.3, {.alike = true});
  const Orbit solved = orbit(at, loads, wanted, 0.3, {});
  EXPECT_EQ(permuted.axial_displacement.size(), 2);
  EXPECT_EQ(solved.axial_displacement.size(), 22);
  for (const Interface i : kInterfaces) {
    EXPECT_LT(largest_difference(permuted.loads[i].equivalent, solved.loads[i].equivalent),
              1e-9 * solved.loads[i].largest);
    EXPECT_NEAR(permuted.loads[i].largest, solved.loads[i].largest, 1e-9 * solved.loads[i].largest);
    EXPECT_EQ(permuted.loads[i].roller, solved.loads[i].roller);
  }
}

Case with_a_thick_roller(double by) {
  Case c = symmetric_case();
  c.deviations.roller_diameters.assign(11, 0.0);
  c.deviations.roller_diameters[2] = by;
  return c;
}

TEST(FullMechanism, UnderAnAxialForceATurnIsOnePosition) {
  const Case c = with_a_thick_roller(20e-6);
  const auto at = [&](double angle) {
    LoadCase load = c.load_cases[0];
    load.spatial.carrier_angle = angle;
    return model_of(c, load);
  };
  FullSolver solver;
  int solves = 0;
  const auto loads = [&](const FullModel& f) {
    ++solves;
    return solver.solve(f, Detail::numbers);
  };
  const Orbit one = orbit(at, loads, {2, 3.0}, 0.3, {.round = true});
  EXPECT_EQ(solves, 1);
  const Orbit all = orbit(at, loads, {2, 3.0}, 0.3, {});
  EXPECT_EQ(solves, 23);
  EXPECT_EQ(one.axial_displacement.size(), all.axial_displacement.size());
  for (const Interface i : kInterfaces) {
    EXPECT_LT(largest_difference(one.loads[i].equivalent, all.loads[i].equivalent), 1e-9 * all.loads[i].largest);
    EXPECT_EQ(one.loads[i].roller, all.loads[i].roller);
    EXPECT_EQ(one.loads[i].carrier_angle, all.loads[i].carrier_angle);
  }
}

TEST(FullMechanism, ANeighbourToStartFromSavesIterationsAndChangesNothing) {
  const Case c = with_a_thick_roller(20e-6);
  FullSolver near(FullStart::neighbour), far;
  std::size_t iterations_near = 0, iterations_far = 0;
  LoadCase load = c.load_cases[0];
  for (int k = 0; k < 8; ++k) {
    load.axial_force = c.load_cases[0].axial_force * (1.0 - 0.02 * k);
    load.spatial.nut_tilt.z = 1e-5 * k;
    const FullModel f = model_of(c, load);
    const FullDistribution a = near.solve(f), b = far.solve(f);
    ASSERT_TRUE(a.solve.converged() && b.solve.converged());
    iterations_near += a.solve.history.size();
    iterations_far += b.solve.history.size();
    EXPECT_NEAR(a.axial_displacement, b.axial_displacement, 1e-10 * b.axial_displacement);
    for (const Interface i : kInterfaces)
      EXPECT_LT(largest_difference(a.normal_load[i], b.normal_load[i]), 1e-9 * load.axial_force);
  }
  EXPECT_LT(iterations_near, iterations_far);
}

/// Errors with an azimuth, and the same with a side force too small to count.
TEST(FullMechanism, ATurnIsOnePositionWhereNothingElseHasAnAzimuth) {
  Case c = with_a_thick_roller(5e-6);
  c.mechanism.rollers = 5;
  c.mechanism.contacts_per_roller = 4;
  c.deviations.roller_diameters.resize(5);
  const auto turned = [](const Case& of, double force) {
    Case with = of;
    with.load_cases[0].spatial.side_force.value.y = force;
    with.load_cases[0].spatial.orbit = SpatialLoad::Orbit{2, 3.0};
    return analyze(with).load_cases[0].full->orbit->loads;
  };
  std::vector<Case> cases(7, c);
  SpatialLoad* loads[7];
  for (std::size_t k = 0; k < 7; ++k) loads[k] = &cases[k].load_cases[0].spatial;
  loads[1]->eccentricity.y = 0.3e-3;
  loads[2]->moment.value.z = 10.0;
  loads[3]->nut_tilt.y = 1e-4;
  cases[4].deviations.index_error.screw = {2e-6, 0.0, -2e-6};
  cases[5].deviations.thread_eccentricity.nut.z = 3e-6;
  cases[6].model.contact_phase = ModelOptions::ContactPhase::helical;
  for (const Case& one : cases) {
    const PerInterface<OrbitLoads> exact = turned(one, 0.0), slow = turned(one, 1e-5);
    for (const Interface i : kInterfaces)
      EXPECT_LT(largest_difference(exact[i].equivalent, slow[i].equivalent), 1e-7 * exact[i].largest);
  }
}

/// One contact per roller, and the load on its section: no beam of the screw is left. The contacts of one section hold
/// either its lateral motion or its tilt; a bearing holds the other.
TEST(FullMechanism, OneContactOfEachRollerHoldsTheScrewWithABearing) {
  Case c = symmetric_case();
  c.mechanism.contacts_per_roller = 1;
  c.structure->screw.free_length = 0.0;
  EXPECT_EQ(solve(model_of(c)).solve.status, fe::NewtonStatus::mechanism);
  c.structure->screw.bearings.push_back({.position = *c.load_cases[0].position, .offset = {}, .angle = {}});
  const FullModel f = model_of(c);
  const FullDistribution d = solve(f);
  ASSERT_TRUE(d.solve.converged()) << fe::name(d.solve.status);
  for (const Interface i : kInterfaces)
    for (const auto& roller : d.normal_load[i])
      EXPECT_NEAR(roller[0] * f.sector.cosine[i] * c.mechanism.rollers / f.axial_force, 1.0, 1e-10);
}

/// By bisection on the force, a thread is at the point of closing.
TEST(FullMechanism, ThreadsThatJustCloseNeedNoWiderNumbers) {
  SKIP_UNDER_SANITIZERS();
  Case c = with_a_thick_roller(20e-6);
  const auto closed = [&](double force) {
    c.load_cases[0].axial_force = force;
    const FullDistribution d = solve(model_of(c));
    EXPECT_TRUE(d.solve.converged());
    EXPECT_FALSE(d.solve.wide);
    EXPECT_LT(d.solve.iterations(), 30);
    int count = 0;
    for (const auto& roller : d.normal_load.screw)
      count += static_cast<int>(std::ranges::count_if(roller, [](double n) { return n > 0.0; }));
    return count;
  };
  double below = 1e3, above = 3e3;
  const int open = closed(below);
  EXPECT_GT(closed(above), open);
  while (above - below > 1e-15 * above) {
    const double middle = 0.5 * (below + above);
    if (middle == below || middle == above) break;
    (closed(middle) > open ? above : below) = middle;
  }
}

/// A side force near the limit wedges the screw out against the axial force.
TEST(FullMechanism, AMotionAgainstTheForceIsToldOf) {
  const auto told = testing::Contains(HasSubstr("`axial_stiffness` is negative"));
  Case c = symmetric_case();
  SpatialLoad& load = c.load_cases[0].spatial;
  load.side_force.value.y = c.load_cases[0].axial_force / 45.0;
  EXPECT_THAT(sentences(analyze(c).load_cases[0].warnings), testing::Not(told));
  load.side_force.value.y = 0.4 * c.load_cases[0].axial_force;
  const LoadCaseResult wedged = analyze(c).load_cases[0];
  ASSERT_TRUE(wedged.converged());
  EXPECT_LT(*wedged.axial_displacement, 0.0);
  EXPECT_THAT(sentences(wedged.warnings), told);
}

TEST(FullMechanism, SaysWhatLeavesTheStiffnessOut) {
  Case c = symmetric_case();
  c.mechanism.rollers = 4;
  c.deviations.roller_diameters = {30e-6, 0.0, 30e-6, 0.0};
  c.load_cases[0].axial_force = 100.0;
  const LoadCaseResult r = analyze(c).load_cases[0];
  ASSERT_TRUE(r.converged());
  EXPECT_EQ(r.full->idle_rollers, (std::vector{2, 4}));
  EXPECT_EQ(r.full->screw_end.stiffness.size(), 0);
  EXPECT_THAT(sentences(r.warnings), testing::Contains(HasSubstr("a motion of screw meets no resistance")));
}

TEST(FullMechanism, OneSolverForManyModelsGivesTheSameBits) {
  FullSolver solver;
  std::mt19937_64 random(7);
  Case c = side_loaded();
  const auto compare = [&](const FullModel& f) {
    const FullDistribution many = solver.solve(f), one = solve(f);
    EXPECT_EQ(many.axial_displacement, one.axial_displacement);
    EXPECT_EQ(many.screw_end.compliance, one.screw_end.compliance);
    for (const Interface i : kInterfaces) EXPECT_EQ(many.normal_load[i], one.normal_load[i]);
  };
  for (int k = 0; k < 3; ++k) {
    c.deviations.roller_diameters.resize(11);
    for (double& d : c.deviations.roller_diameters) d = std::normal_distribution<double>(0.0, 2e-6)(random);
    compare(model_of(c));
  }
  c.structure->nut.housing.tilt = 1e5;  // Another shape, another number of equations.
  compare(model_of(c));
  c.load_cases[0].spatial.carrier_angle = 0.1;
  c.structure->roller.rings.stiffness = 1e6;
  compare(model_of(c));
  c.load_cases[0].axial_force *= 0.5;
  compare(model_of(c));
}

TEST(FullMechanism, BearingsAtOnePlaceShareByTheirStiffness) {
  Case c = side_loaded();
  const auto bearing = [&](double lateral, double tilt) {
    return Bearing{*c.load_cases[0].position, lateral, tilt, {}, {}};
  };
  std::vector<Bearing>& bearings = c.structure->screw.bearings;
  bearings = {bearing(3e8, 3e4)};
  const FullDistribution alone = solve(model_of(c));
  ASSERT_TRUE(alone.solve.converged());
  const SupportForce& one = alone.bearings[0];
  bearings = {bearing(1e8, 1e4), bearing(2e8, 2e4)};
  const FullDistribution two = solve(model_of(c));
  ASSERT_TRUE(two.solve.converged());
  for (const int k : {0, 1}) {
    const SupportForce& part = two.bearings[static_cast<std::size_t>(k)];
    EXPECT_LT((part.force - (k + 1) / 3.0 * one.force).norm(), 1e-9 * one.force.norm());
    EXPECT_NEAR(part.moment.y / ((k + 1) / 3.0 * one.moment.y), 1.0, 1e-9);
    EXPECT_NEAR(part.moment.z / ((k + 1) / 3.0 * one.moment.z), 1.0, 1e-9);
  }
  // The spring of one pulls against the support of the other.
  bearings = {bearing(kRigid, 0.0), bearing(2e8, 0.0)};
  bearings[1].offset = {1e-5, -2e-5};
  const FullModel f = model_of(c);
  const FullDistribution held = solve(f);
  ASSERT_TRUE(held.solve.converged());
  EXPECT_NEAR(held.bearings[1].force[1], 2e8 * 1e-5, 1e-6);
  EXPECT_NEAR(held.bearings[1].force[2], 2e8 * -2e-5, 1e-6);
  EXPECT_LT(imbalance(f, held), 1e-9);
}

TEST(FullMechanism, BearingsThatPushAgainstEachOtherAreToldOf) {
  Case c = symmetric_case();
  const double first = *c.load_cases[0].position - c.structure->screw.free_length;
  c.structure->screw.bearings = {{first, kRigid, 0.0, {0.0, 0.0}, {}},
                                 {first + 1e-4, kRigid, 0.0, {1e-6, 0.0}, {}},
                                 {first + 2e-4, kRigid, 0.0, {0.0, 0.0}, {}}};
  EXPECT_THAT(sentences(analyze(c).load_cases[0].warnings), testing::Contains(HasSubstr("push against each other")));
  c.structure->screw.bearings[1].offset = {};
  EXPECT_THAT(sentences(analyze(c).load_cases[0].warnings),
              testing::Not(testing::Contains(HasSubstr("push against each other"))));
}

TEST(FullMechanism, WhatAFreeBearingDoesNotHoldIsToldOf) {
  Case c = symmetric_case();
  const double first = *c.load_cases[0].position - c.structure->screw.free_length;
  c.structure->screw.bearings = {{first, kRigid, 0.0, {1e-6, 0.0}, {0.0, 1e-3}}};
  EXPECT_THAT(sentences(analyze(c).warnings),
              testing::Contains(HasSubstr("bearings[0].angle: has no effect with `tilt: free`")));
  c.structure->screw.bearings = {{first, 0.0, kRigid, {1e-6, 0.0}, {0.0, 1e-3}}};
  const std::vector<std::string> warnings = sentences(analyze(c).warnings);
  EXPECT_THAT(warnings, testing::Contains(HasSubstr("bearings[0].offset: has no effect")));
  EXPECT_THAT(warnings, testing::Not(testing::Contains(HasSubstr("bearings[0].angle"))));
}

TEST(FullMechanism, MoreAxialForceHoldsASideForce) {
  Case c = symmetric_case();
  c.load_cases[0].spatial.side_force.value = {60e3, 0.0};
  const Result result = analyze(c);
  ASSERT_EQ(result.load_cases[0].solve->status, fe::NewtonStatus::no_equilibrium);
  EXPECT_THAT(sentences(result.load_cases[0].warnings), testing::Contains(HasSubstr("or raise the axial force to ")));
  const std::optional<double> force = holding_force(model_of(c));
  ASSERT_TRUE(force);
  c.load_cases[0].axial_force = 1.02 * *force;
  EXPECT_TRUE(analyze(c).load_cases[0].converged());
  c.load_cases[0].axial_force = 0.95 * *force;
  EXPECT_FALSE(analyze(c).load_cases[0].converged());
}

}  // namespace
}  // namespace prs
