#include "prs/slip/running.h"
#include "prs/bodies/body_models.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/sector/roller_guides.h"
#include "prs/slip/slip.h"
#include "support/sanitized.h"

namespace prs {
namespace {

using nlohmann::json;

/// Solved cases of an independent program.
const json& solved_cases() {
  static const json all = json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/slip/running_cases.json"));
  return all["cases"];
}

json solved_case(const std::string& name) {
  for (const json& c : solved_cases())
    if (c["name"] == name) return c;
  throw std::invalid_argument(name);
}

Case running(const json& input) { return input::read_case_text(input.dump(), "case", {}, Command::slip); }

json base() { return solved_case("lesson-tension")["input"]; }

LoadCaseResult solved(const Case& c) { return analyze_slip(c).load_cases.at(0); }

double largest(const std::vector<double>& values) { return std::ranges::max(values); }

/// Checks values within a share of the largest expected entry, or of `scale`.
void expect_near(const std::vector<double>& values, const json& expected, double share, const char* what,
                 double scale = 0.0, double unit = 1.0) {
  std::vector<double> numbers;
  for (const json& e : expected)
    if (e.is_array())
      numbers.insert(numbers.end(), e.begin(), e.end());
    else
      numbers.push_back(e);
  ASSERT_EQ(values.size(), numbers.size()) << what;
  if (scale == 0.0)
    for (const double e : numbers) scale = std::max(scale, std::abs(e));
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_NEAR(values[k] * unit, numbers[k], share * scale) << what << ' ' << k;
}

class SolvedCase : public testing::TestWithParam<const char*> {};

TEST_P(SolvedCase, Agrees) {
  const json given = solved_case(GetParam());
  const json& expected = given["result"]["load_cases"][0];
  const LoadCaseResult r = solved(running(given["input"]));
  ASSERT_TRUE(r.running && r.running->converged()) << name(r.running->status);
  ASSERT_TRUE(r.threads);
  for (const Interface i : kInterfaces) {
    const json& e = expected[std::string(name(i))];
    const InterfaceLoads& t = (*r.threads)[i];
    expect_near(t.normal_load, e["normal_load_N"], 1e-8, "normal load");
    if (e.contains("axial_load_N")) {
      expect_near(t.axial_load, e["axial_load_N"], 1e-8, "axial load");
      expect_near(t.peak_pressure, e["peak_pressure_MPa"], 1e-8, "pressure", 0.0, 1e-6);
      expect_near(t.load_rate, e["load_rate_percent"], 1e-8, "load rate", 0.0, 100.0);
      const FrictionForces& f = *t.friction;
      const double most = largest(t.normal_load);
      expect_near(f.axial, e["friction_force_N"]["axial"], 1e-8, "axial", most);
      expect_near(f.radial, e["friction_force_N"]["radial"], 1e-8, "radial", most);
      expect_near(f.tangential, e["friction_force_N"]["tangential"], 1e-5, "tangential", most);
      EXPECT_NEAR(most / r.running->at_rest.largest_normal_load[i], e["running_over_static"], 1e-8);
      const json& s = expected["slip"][std::string(name(i))];
      expect_near(r.slip->threads[i].power, s["power_W"], 1e-6, "power");
      expect_near(r.slip->threads[i].dynamic_normal_load, s["dynamic_normal_load_N"], 1e-8, "dynamic load");
    }
    const double rest = expected["static"][std::string(name(i))]["largest_normal_load_N"];
    EXPECT_NEAR(r.running->at_rest.largest_normal_load[i], rest, 1e-8 * rest);
  }
  if (expected.contains("axial_displacement_um")) {
    EXPECT_NEAR(*r.axial_displacement * 1e6, expected["axial_displacement_um"], 1e-7);
  }
  const json& slip = expected["slip"];
  const SlipResult& s = *r.slip;
  const auto near = [](double value, const json& e, double tolerance = 1e-6) {
    EXPECT_NEAR(value, e.get<double>(), tolerance * std::abs(e.get<double>()));
  };
  near(s.slip_ratio, slip["slip_ratio"], 1e-10);
  near(s.power.total(), slip["power_loss_W"]);
  near(s.power_loss_input_output, slip["power_loss_input_output_W"]);
  near(s.torque_screw, slip["torque_screw_Nm"]);
  near(s.torque_nut, slip["torque_nut_Nm"]);
  near(*s.efficiency, slip["efficiency"]);
  if (!slip.contains("heads")) return;
  const json& forces = slip["roller_forces_N"];
  near(s.forces.contacts_x, forces["contacts_x"]);
  near(s.forces.gears_x, forces["gears_x"]);
  near(s.forces.gears_y, forces["gears_y"]);
  near(s.forces.carrier_x, forces["carrier_x"]);
  for (std::size_t h = 0; h < 2; ++h) {
    near(s.heads.at(0)[h].guide_force, slip["heads"]["guide_force_N"][h]);
    near(s.heads.at(0)[h].bearing_force, slip["heads"]["bearing_force_N"][h]);
    if (slip["heads"].contains("torque_Nmm")) near(*s.heads.at(0)[h].torque * 1e3, slip["heads"]["torque_Nmm"][h]);
  }
}

INSTANTIATE_TEST_SUITE_P(Running, SolvedCase,
                         testing::Values("lesson-tension", "lesson-load-drives", "lesson-inverted-heads",
                                         "lesson-full"),
                         [](const auto& solved) {
                           std::string name = solved.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

Case with(const Case& given, double friction, double speed_factor = 1.0) {
  Case c = given;
  c.friction->coefficient = at_both(friction);
  c.operation->speed *= speed_factor;
  return c;
}

TEST(RunningLoads, TendToThoseAtRestInProportionToFriction) {
  const Case c = running(base());
  const auto growth = [&](double friction) {
    const LoadCaseResult r = solved(with(c, friction));
    return largest(r.threads->screw.normal_load) / r.running->at_rest.largest_normal_load.screw - 1.0;
  };
  EXPECT_NEAR(growth(1e-9), 0.0, 1e-8);
  EXPECT_NEAR(growth(2e-4) / growth(1e-4), 2.0, 1e-3);
}

/// Checks axial and lateral forces, power and torques, all of the same state.
void expect_balance(const LoadCaseResult& r, int rollers) {
  ASSERT_TRUE(r.running && r.running->converged() && r.slip);
  const double force = r.load_case.axial_force / rollers;
  for (const Interface i : kInterfaces) {
    double sum = 0.0;
    for (const double load : (*r.threads)[i].axial_load) sum += load;
    EXPECT_NEAR(sum, force, 1e-10 * force);
  }
  const SlipResult& s = *r.slip;
  ASSERT_EQ(s.heads.size(), 1u);
  double outwards = s.forces.centrifugal;
  for (const Interface i : kInterfaces)
    for (std::size_t k = 0; k < (*r.threads)[i].normal_load.size(); ++k)
      outwards += (i == Interface::screw ? 1.0 : -1.0) * (*r.threads)[i].normal_load[k] *
                      std::sin((*r.threads)[i].normal_angle) +
                  (*r.threads)[i].friction->radial[k];
  EXPECT_NEAR(s.heads[0][0].guide_force + s.heads[0][1].guide_force, -outwards, 1e-10 * force);
  EXPECT_NEAR(s.power.total(), s.power_loss_input_output, 1e-8 * s.power.total());
  EXPECT_NEAR(s.torque_screw, -s.torque_nut, 1e-9 * std::abs(s.torque_screw));
}

TEST(RunningLoads, AreInBalance) {
  for (const auto bodies : {&kBars, &kRefined})
    for (const Direction d : {Direction::tension, Direction::compression})
      for (const double sense : {1.0, -1.0}) {
        Case c = with(running(base()), 0.1, 5.0 * sense);
        c.model.bodies = bodies;
        c.load_cases[0].direction = d;
        for (const Part p : kParts) (*c.materials)[p].density = 7800.0;
        expect_balance(solved(c), c.mechanism.rollers);
      }
  expect_balance(solved(running(solved_case("lesson-inverted-heads")["input"])), 11);
}

/// Three threads, whose bodies are meshed once for all checks here.
TEST(RunningLoads, OfMeshedBodiesAreThoseOfAnyOther) {
  SKIP_UNDER_SANITIZERS();
  json input = base();
  input["mechanism"]["contacts_per_roller"] = 3;
  input["model"]["bodies"] = "influence";
  const Case c = running(input);
  const auto growth = [&](double friction, ModelOptions::Bodies bodies, double sense) {
    Case at = with(c, friction, sense);
    at.model.bodies = bodies;
    return solved(at).threads->screw.running_over_static.value() - 1.0;
  };
  EXPECT_NEAR(growth(1e-9, &kInfluence, 1.0), 0.0, 1e-8);
  EXPECT_NEAR(growth(2e-4, &kInfluence, 1.0) / growth(1e-4, &kInfluence, 1.0), 2.0, 1e-3);
  for (const double sense : {1.0, -1.0}) {
    EXPECT_NEAR(growth(0.1, &kInfluence, sense) / growth(0.1, &kRefined, sense), 1.0, 0.2);
    Case heavy = with(c, 0.1, 5.0 * sense);
    for (const Part p : kParts) (*heavy.materials)[p].density = 7800.0;
    expect_balance(solved(heavy), 11);
  }
  EXPECT_EQ(solved(with(c, 1.3, 1.0)).running->status, RunningStatus::jammed);
  EXPECT_TRUE(solved(with(c, 1.3, -1.0)).running->converged());
}

TEST(RunningLoads, AreThoseOfTheMirrorImage) {
  const Case c = running(base());
  Case mirrored = with(c, 0.1, -1.0);
  mirrored.mechanism.lead = -c.mechanism.lead;
  const LoadCaseResult a = solved(c), b = solved(mirrored);
  for (std::size_t k = 0; k < a.threads->screw.normal_load.size(); ++k) {
    EXPECT_NEAR(a.threads->screw.normal_load[k], b.threads->screw.normal_load[k], 1e-8);
    EXPECT_NEAR(a.threads->screw.friction->radial[k], b.threads->screw.friction->radial[k], 1e-8);
    EXPECT_NEAR(a.threads->screw.friction->tangential[k], -b.threads->screw.friction->tangential[k], 1e-8);
  }
}

TEST(RunningLoads, OfEqualRollersAreThoseOfOneSector) {
  json input = solved_case("lesson-full")["input"];
  input.erase("deviations");
  const LoadCaseResult all = solved(running(input));
  input["model"].erase("mechanism");
  input["structure"]["roller"].erase("rings");
  const LoadCaseResult one = solved(running(input));
  for (const Interface i : kInterfaces) {
    const std::vector<double>& loads = (*one.threads)[i].normal_load;
    const double most = largest(loads);
    for (std::size_t k = 0; k < (*all.threads)[i].normal_load.size(); ++k)
      EXPECT_NEAR((*all.threads)[i].normal_load[k], loads[k % loads.size()], 1e-10 * most);
  }
  EXPECT_NEAR(all.slip->power.total(), one.slip->power.total(), 1e-9 * one.slip->power.total());
  const std::vector<double>& shares = all.threads->nut.rollers->share;
  for (const double share : shares) EXPECT_NEAR(share * static_cast<double>(shares.size()), 1.0, 1e-9);
  for (std::size_t h = 0; h < 2; ++h)
    EXPECT_NEAR(all.slip->heads[3][h].bearing_force, one.slip->heads[0][h].bearing_force, 1e-7);
}

/// The screw of 25 mm x 5 mm that `prs new` designs for 20 kN.
TEST(RunningLoads, GrowWhereTheScrewDrivesAndShrinkWhereTheLoadDoes) {
  json input = base();
  input["mechanism"]["contacts_per_roller"] = 50;
  input["structure"]["nut"]["length"] = "73 mm";
  input["structure"]["nut"]["thrust"]["compression"] = "73 mm";
  input["load_cases"][0]["axial_force"] = "20 kN";
  const auto of = [&](Direction d, double sense) {
    Case c = with(running(input), 0.1, 3.0 * sense);
    c.load_cases[0].direction = d;
    return solved(c);
  };
  const auto percent = [](const LoadCaseResult& r, Interface i) {
    return 100.0 * (largest((*r.threads)[i].normal_load) / r.running->at_rest.largest_normal_load[i] - 1.0);
  };
  const LoadCaseResult drives = of(Direction::tension, 1.0), driven = of(Direction::tension, -1.0);
  EXPECT_NEAR(percent(drives, Interface::screw), 29.6, 0.05);
  EXPECT_NEAR(percent(driven, Interface::screw), -22.9, 0.05);
  EXPECT_NEAR(percent(drives, Interface::nut), -10.4, 0.05);
  EXPECT_NEAR(percent(driven, Interface::nut), 9.2, 0.05);
  EXPECT_NEAR(percent(of(Direction::compression, -1.0), Interface::screw), 17.8, 0.05);
  EXPECT_NEAR(percent(of(Direction::compression, 1.0), Interface::screw), -14.7, 0.05);
  const auto guide = [](const LoadCaseResult& r, std::size_t h) { return r.slip->heads[0][h].guide_force; };
  EXPECT_NEAR(guide(drives, 0), -592.0, 0.5);
  EXPECT_NEAR(guide(drives, 1), 182.0, 0.5);
  EXPECT_NEAR(guide(driven, 0), -173.0, 0.5);
  EXPECT_NEAR(guide(driven, 1), 500.0, 0.5);
}

/// Slip from the loads at rest, and heads under guides that hold a couple without friction.
TEST(RunningLoads, StaticOnesStayOnRequest) {
  Case c = running(base());
  c.model.loads = ModelOptions::Loads::at_rest;
  const LoadCaseResult r = solved(c);
  EXPECT_EQ(r.loads, ModelOptions::Loads::at_rest);
  EXPECT_FALSE(r.running);
  const LoadCaseResult at_rest = analyze(c).load_cases.at(0);
  EXPECT_EQ(r.threads->screw.normal_load, at_rest.threads->screw.normal_load);
  ASSERT_EQ(r.slip->heads.size(), 1u);
  double outwards = 0.0;
  for (const Interface i : kInterfaces)
    for (const double load : (*r.threads)[i].normal_load)
      outwards += (i == Interface::screw ? 1.0 : -1.0) * load * std::sin((*r.threads)[i].normal_angle);
  EXPECT_NEAR(r.slip->heads[0][0].guide_force + r.slip->heads[0][1].guide_force, -outwards, 1e-9);
  EXPECT_LT(r.slip->heads[0][0].guide_force, -300.0);
  EXPECT_GT(r.slip->heads[0][1].guide_force, 300.0);
}

/// Friction takes all of a contact's axial force if the screw drives. If the load does, friction adds to it: loads in
/// balance exist, although their fixed-point iteration does not contract.
TEST(RunningLoads, FrictionJamsTheScrewThatDrivesAlone) {
  json full = solved_case("lesson-full")["input"];
  full["load_cases"][0]["speed"] = "400 rpm";
  for (const double friction : {1.02, 1.3, 2.0})
    for (const json& input : {base(), full}) {
      const Case c = running(input);
      const LoadCaseResult drives = solved(with(c, friction));
      EXPECT_EQ(drives.running->status, RunningStatus::jammed);
      EXPECT_FALSE(drives.threads);
      Case back = with(c, friction, -1.0);
      if (back.load_cases[0].speed) *back.load_cases[0].speed *= -1.0;
      const LoadCaseResult driven = solved(back);
      EXPECT_TRUE(driven.running->converged()) << name(driven.running->status);
      EXPECT_NEAR(driven.slip->power.total(), driven.slip->power_loss_input_output, 1e-8 * driven.slip->power.total());
    }
}

/// Steep flanks amplify a small change of friction to a large one of the loads.
TEST(RunningLoads, AreFoundShortOfTheJam) {
  json input = base();
  input["mechanism"]["flank_angle"] = "58 deg";
  for (const double sense : {1.0, -1.0}) {
    const LoadCaseResult r = solved(with(running(input), 0.61, sense));
    EXPECT_TRUE(r.running->converged()) << name(r.running->status);
    EXPECT_LT(r.running->rounds, 20);
  }
}

/// High speed and low load.
TEST(RunningLoads, RollersThatLeaveTheScrewAreTold) {
  const auto told = [](const std::string& speed) {
    const Case c =
        input::read_case_input(input::load_source(PRS_SOURCE_DIR "/configs/31_running_screw.yaml",
                                                  {"load_cases[0].axial_force=50 N", "operation.speed=" + speed,
                                                   "materials.density=7800 kg/m^3"}),
                               Command::slip)
            .values;
    const std::vector<Warning> warnings = analyze_slip(c).load_cases[0].warnings;
    return std::ranges::count(warnings, "lifted_rollers", &Warning::code);
  };
  EXPECT_EQ(told("20000 rpm"), 1);
  EXPECT_EQ(told("10 rpm"), 0);
}

/// Newton's method on K q + sum (B + (tau_x X + tau_y Y))' N = f, dense and unsymmetric.
void expect_turned(const Case& c) {
  const LoadCaseResult r = solved(c);
  ASSERT_TRUE(r.threads) << name(r.running->status);
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  SectorSolver solver(
      build_sector(sector_model(contacts.mechanism, *c.structure, *c.materials, c.model, contact_laws(c, contacts),
                                Direction::tension, *c.load_cases[0].position, c.deviations)));
  const Sector& sector = solver.sector();
  const fe::Equations& equations = solver.equations();
  solver.solve(c.load_cases[0].axial_force);
  fe::State q = solver.state();
  const Eigen::VectorXd load = c.load_cases[0].axial_force / sector.rollers * solver.unit_load();
  const auto size = static_cast<Eigen::Index>(equations.size());
  const std::vector<double> none(static_cast<std::size_t>(sector.contacts()), 0.0);
  const auto turned = [&](Interface i, int k) {
    RollerPush push{{none, none}, {none, none}};
    const auto at = static_cast<std::size_t>(k);
    const double normal = (*r.threads)[i].normal_load[at];
    push.axial[i][at] = (*r.threads)[i].friction->axial[at] / normal;
    push.radial[i][at] = (*r.threads)[i].friction->radial[at] / normal;
    return equations.load_vector(push_loads(sector, push));
  };
  for (int round = 0; round < 20; ++round) {
    Eigen::VectorXd residual(size);
    equations.energy_and_residual(q, load, residual);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(size, j);
      Eigen::VectorXd column(size);
      equations.tangent_residual(q, fe::State(unit), Eigen::VectorXd::Zero(size), column);
      matrix.col(j) = -column;
    }
    for (const Interface i : kInterfaces)
      for (int k = 0; k < sector.contacts(); ++k) {
        const int spring = sector.spring(i, k);
        const fe::SpringResponse n = equations.response(q, spring);
        const Eigen::VectorXd push = turned(i, k);
        residual -= n.force * push;
        const auto& s = equations.springs()[static_cast<std::size_t>(spring)];
        for (std::size_t t = 0; t < s.count; ++t) matrix.col(s.equation[t]) -= n.tangent * s.coefficient[t] * push;
      }
    q.set_to_step(fe::State(q), 1.0, matrix.partialPivLu().solve(residual));
  }
  for (const Interface i : kInterfaces)
    for (int k = 0; k < sector.contacts(); ++k)
      EXPECT_NEAR(equations.response(q, sector.spring(i, k)).force,
                  (*r.threads)[i].normal_load[static_cast<std::size_t>(k)],
                  1e-10 * largest((*r.threads)[i].normal_load));
}

TEST(RunningLoads, AreThoseOfTheTurnedForces) {
  const Case c = running(base());
  expect_turned(c);
  expect_turned(with(c, 1.3, -1.0));
  json steep = base();
  steep["mechanism"]["flank_angle"] = "58 deg";
  for (const double sense : {1.0, -1.0}) expect_turned(with(running(steep), 0.6, sense));
}

}  // namespace
}  // namespace prs
