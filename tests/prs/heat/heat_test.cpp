#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "prs/heat/analyze_heat.h"
#include "prs/heat/thermal_network.h"
#include "prs/slip/slip_model.h"
#include "tests/support/count.h"
#include "tests/support/sanitized.h"
#include "tests/support/slips.h"

namespace prs {
namespace {

constexpr double kCelsius = 273.15;

Heat some_heat() {
  Heat heat;
  heat.ambient = 25.0 + kCelsius;
  heat.conductance = {
      .screw_ambient = 4.0, .nut_ambient = 8.0, .rollers_ambient = 0.5, .screw_rollers = 20.0, .rollers_nut = 30.0};
  return heat;
}

/// Sandu's example in ISO VG 220, without a stated temperature.
Case warm_reference() {
  Case c = test::sandu_reference();
  c.lubricant = Lubricant{};
  c.lubricant->density = 890.0;
  c.lubricant->viscosity_at = {{313.15, {}, 220e-6}, {373.15, {}, 19e-6}};
  c.lubricant->pressure_viscosity = 24e-9;
  c.lubricant->eyring_stress = 8e6;
  c.heat = some_heat();
  return c;
}

/// The inverted screw of Abevi 2015, its shares solved.
Case warm_solved() {
  Case c = test::inverted(warm_reference());
  Mechanism& m = c.mechanism;
  m.geometry = Mechanism::Geometry::simulation;
  m.lead = 5e-3;
  m.starts = {3, 1};
  m.pitch_diameter = {21e-3, 7e-3, 35e-3};
  m.centre_distance = 14e-3;
  m.profile.roller.radius = 4.949747468e-3;
  m.rollers = 11;
  m.contacts_per_roller = 20;
  Structure s;
  s.screw.bore = 6e-3;
  s.screw.free_length = 10e-3;
  s.roller.end_length = s.roller.end_diameter = 5e-3;
  s.nut.length = 90e-3;
  s.nut.outer_diameter = 46e-3;
  s.nut.thrust = {10e-3, 80e-3};
  c.structure = s;
  for (const Part p : kParts) {
    (*c.materials)[p] = {209e9, 0.3, 7810.0, 11.5e-6};
  }
  c.materials->nut.thermal_expansion = 17e-6;
  LoadCase& load = c.load_cases[0];
  load.name = "pull";
  load.axial_force = 20e3;
  load.share = LoadCase::Share::solved;
  load.direction = Direction::tension;
  load.position = 29.1666667e-3;
  c.operation->speed = 600 * std::numbers::pi / 30;
  c.heat->conductance.screw_ambient = 2.0;
  return c;
}

/// Heat into screw, rollers and nut [W] at these temperatures, without the functions of `heat`.
Eigen::Vector3d plain_heat(const Case& c, const Contacts& contacts, const Eigen::Vector3d& t, std::size_t k = 0) {
  const LoadCase& load = c.load_cases[k];
  Oils oils;
  if (c.lubricant) {
    oils.threads.screw = at_temperature(*c.lubricant, (t[0] + t[1]) / 2);
    oils.threads.nut = at_temperature(*c.lubricant, (t[1] + t[2]) / 2);
    oils.carrier = at_temperature(*c.lubricant, (t[0] + 2 * t[1] + t[2]) / 4);
  }
  Case at = c;
  at.load_cases = {load};
  at.heat.reset();
  at.deviations.temperature = PerPart<double>{t[0], t[1], t[2]};
  const SlipModels models(at, contacts, oils);
  SlipModel model;
  if (load.share == LoadCase::Share::equal)
    model = models.equal_shares(load);
  else
    model = models.of(analyze(at, contacts).load_cases[0]);
  const SlipEquilibrium found = find_slip_equilibrium(model);
  if (!found.ok()) throw std::runtime_error("no slip");
  const PowerBySource p = lost_power(model, found.balance);
  return {p.screw / 2 + p.carrier_screw, p.screw / 2 + p.nut / 2 + p.carrier_roller, p.nut / 2 + p.carrier_nut};
}

/// Heat flow from each part, link by link [W].
Eigen::Vector3d plain_flow(const Heat& h, const Eigen::Vector3d& t) {
  const Heat::Conductance& k = h.conductance;
  const double a = h.ambient;
  return {k.screw_ambient * (t[0] - a) + k.screw_rollers * (t[0] - t[1]),
          k.rollers_ambient * (t[1] - a) + k.screw_rollers * (t[1] - t[0]) + k.rollers_nut * (t[1] - t[2]),
          k.nut_ambient * (t[2] - a) + k.rollers_nut * (t[2] - t[1])};
}

/// Simple and slow: small steps towards the balance, part by part.
Eigen::Vector3d plain_steady(const Case& c, const Contacts& contacts) {
  const Heat::Conductance& k = c.heat->conductance;
  const Eigen::Vector3d own(k.screw_ambient + k.screw_rollers, k.rollers_ambient + k.screw_rollers + k.rollers_nut,
                            k.nut_ambient + k.rollers_nut);
  Eigen::Vector3d t = Eigen::Vector3d::Constant(c.heat->ambient);
  for (int round = 0; round < 400; ++round) {
    const Eigen::Vector3d heat = plain_heat(c, contacts, t), before = t;
    Eigen::Vector3d target = t;
    for (int sweep = 0; sweep < 4000; ++sweep) {
      const Eigen::Vector3d off = (heat - plain_flow(*c.heat, target)).cwiseQuotient(own);
      target += 0.9 * off;
      if (off.cwiseAbs().maxCoeff() < 1e-12) break;
    }
    t += 0.6 * (target - t);
    if ((t - before).cwiseAbs().maxCoeff() < 1e-9) return t;
  }
  throw std::runtime_error("plain iteration does not converge");
}

Eigen::Vector3d kelvin(const PerPart<double>& t) { return {t.screw, t.roller, t.nut}; }

TEST(Heat, TemperaturesOfRandomMechanismsAreThoseOfAPlainIteration) {
  std::mt19937_64 random(21);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  int seen = 0;
  for (int i = 0; i < 200 && seen < test::samples(20, 60); ++i) {
    Case c = test::random_slip(random);
    if (c.operation->slip_ratio) continue;
    if (i % 3 == 0) {
      c.friction = friction_by(contact::Mixed<PerInterface<double>>{at_both(0.12)});
      c.roughness = PerPart<double>{0.2e-6, 0.2e-6, 0.2e-6};
    }
    Lubricant& oil = *c.lubricant;
    oil.viscosity.reset();
    oil.density = 880.0;
    const double thick = std::exp(uniform(std::log(30e-6), std::log(500e-6)));
    oil.viscosity_at = {{313.15, {}, thick}, {373.15, {}, 0.5 * std::pow(thick * 1e6, 0.65) * 1e-6}};
    Heat heat;
    heat.ambient = uniform(-20.0, 40.0) + kCelsius;
    Heat::Conductance& k = heat.conductance;
    k = {1.0, 1.0, 0.0, 1.0, 1.0};
    c.heat = heat;
    const Contacts contacts = checked_contacts(c, Detail::numbers);
    // Losses warm the parts by some ten kelvin.
    const double loss = plain_heat(c, contacts, Eigen::Vector3d::Constant(330.0)).sum();
    const double unit = loss / uniform(10.0, 80.0);
    k = {unit * uniform(0.0, 1.0), unit * uniform(0.1, 1.0), unit * uniform(0.0, 0.2), unit * uniform(0.5, 5.0),
         unit * uniform(0.5, 5.0)};
    c.heat = heat;
    const LoadCaseResult found = analyze_heat(c).load_cases[0];
    ASSERT_TRUE(found.heat->converged()) << i << found.heat->reason;
    const Eigen::Vector3d plain = plain_steady(c, contacts);
    EXPECT_LT((kelvin(found.heat->temperature) - plain).cwiseAbs().maxCoeff(), 1e-6) << i;
    ++seen;
  }
  EXPECT_GE(seen, test::samples(20, 60));
}

TEST(Heat, SolvedSharesFollowTheTemperaturesOfTheParts) {
  Case c = warm_solved();
  c.model.loads = ModelOptions::Loads::at_rest;
  const LoadCaseResult found = analyze_heat(c).load_cases[0];
  ASSERT_TRUE(found.heat->converged());
  const Eigen::Vector3d plain = plain_steady(c, checked_contacts(c, Detail::numbers));
  EXPECT_LT((kelvin(found.heat->temperature) - plain).cwiseAbs().maxCoeff(), 1e-6);
  // Loads are those that `solve` finds at these temperatures.
  Case at = c;
  at.deviations.temperature = found.heat->temperature;
  const LoadCaseResult solved = analyze(at).load_cases[0];
  for (const Interface i : kInterfaces)
    for (std::size_t k = 0; k < 20; ++k)
      EXPECT_NEAR((*found.threads)[i].axial_load[k], (*solved.threads)[i].axial_load[k], 1e-6);
}

TEST(Heat, WhatGoesInComesOutOrFlowsToTheSurroundings) {
  for (Case c : {warm_reference(), test::inverted(warm_reference()), warm_solved()}) {
    c.carrier.screw_torque = 0.05;
    c.carrier.nut_torque = 0.03;
    c.carrier.roller_torque = 0.002;
    const LoadCaseResult found = analyze_heat(c).load_cases[0];
    ASSERT_TRUE(found.heat->converged());
    const PerPart<double>& t = found.heat->temperature;
    const Heat::Conductance& k = c.heat->conductance;
    const double a = c.heat->ambient;
    const double to_ambient =
        k.screw_ambient * (t.screw - a) + k.nut_ambient * (t.nut - a) + k.rollers_ambient * (t.roller - a);
    EXPECT_NEAR(to_ambient / found.slip->power_loss_input_output, 1.0, 1e-8);
    EXPECT_NEAR(to_ambient / found.slip->power.total(), 1.0, 1e-8);
    const PerPart<double>& q = found.heat->heat;
    EXPECT_NEAR(q.screw, found.slip->power.screw / 2 + found.slip->power.carrier_screw, 1e-8 * to_ambient);
    EXPECT_NEAR(q.nut, found.slip->power.nut / 2 + found.slip->power.carrier_nut, 1e-8 * to_ambient);
    EXPECT_NEAR(found.heat->oil->screw, (t.screw + t.roller) / 2, 1e-9);
    EXPECT_NEAR(found.heat->oil->nut, (t.nut + t.roller) / 2, 1e-9);
  }
}

TEST(Heat, WithoutHeatNothingChanges) {
  Case c = warm_reference();
  c.heat.reset();
  c.lubricant->temperature = 333.15;
  const Result a = analyze_heat(c), b = analyze_slip(c);
  EXPECT_EQ(a.load_cases[0].slip->power.total(), b.load_cases[0].slip->power.total());
  EXPECT_FALSE(a.load_cases[0].heat);
}

TEST(Heat, PartsThatCannotCoolHaveNoSteadyState) {
  Case c = test::with_coulomb(warm_reference(), 0.1);
  c.heat->conductance = {.screw_ambient = 0.0, .nut_ambient = 1e-3, .screw_rollers = 20.0, .rollers_nut = 30.0};
  const LoadCaseResult found = analyze_heat(c).load_cases[0];
  EXPECT_EQ(found.heat->status, HeatStatus::no_steady_state);
  EXPECT_THAT(found.heat->reason,
              ::testing::MatchesRegex(".*they take up [0-9.e+]+ W, which need [0-9.e+-]+ W/K to the "
                                      "surroundings; give them more conductance.*"));
  EXPECT_FALSE(found.slip);
}

TEST(Heat, SaysWhyAllRollersDoNotHoldTheLoad) {
  Case c = warm_solved();
  c.model.mechanism = ModelOptions::Mechanism::full;
  c.load_cases[0].spatial.side_force.value.y = 10.0 * c.load_cases[0].axial_force;
  const LoadCaseResult found = analyze_heat(c).load_cases[0];
  EXPECT_FALSE(found.heat->converged());
  EXPECT_THAT(found.heat->reason, ::testing::HasSubstr("flanks that only push"));
}

/// Heat source of one temperature: in halves to screw and nut by way of their oils.
HeatSource lumped(double (*power)(double)) {
  const auto at = [power](const PerInterface<double>& oil) -> std::optional<OfParts> {
    const double screw = power(oil.screw), nut = power(oil.nut);
    return OfParts(screw / 2, (screw + nut) / 2, nut / 2);
  };
  return {[at](const OfParts& t) { return at(oil_temperatures(t)); }, [] { return std::string(); }, at, at};
}

/// All parts nearly at one temperature: 20 W/K in all.
ThermalNetwork tight_network() {
  Heat heat;
  heat.ambient = 300.0;
  heat.conductance = {10.0, 10.0, 0.0, 1e7, 1e7};
  return thermal_network(heat);
}

TEST(SteadyHeat, TheStateReachedFromAmbientIsTheCoolest) {
  // 200 W and from about 350 K on 2000 W: 20 (T - 300) = P(T) near 310, between, and 400 K.
  const auto power = [](double t) { return 100.0 + 900.0 / (1.0 + std::exp((350.0 - t) / 3.0)); };
  const SteadyHeat found = find_steady_heat(tight_network(), lumped(+power));
  ASSERT_TRUE(found.converged());
  EXPECT_NEAR(found.temperature[1], 310.0, 0.1);
  EXPECT_TRUE(found.others);
  // A start from above reaches the other one.
  const SteadyHeat hot = find_steady_heat(tight_network(), lumped(+power), OfParts::Constant(420.0));
  ASSERT_TRUE(hot.converged());
  EXPECT_NEAR(hot.temperature[1], 400.0, 0.1);
}

TEST(SteadyHeat, WhereTheCoolStateIsGoneTheHotOneIsFound) {
  const auto power = [](double t) { return 400.0 + 600.0 / (1.0 + std::exp((335.0 - t) / 3.0)); };
  const SteadyHeat found = find_steady_heat(tight_network(), lumped(+power));
  ASSERT_TRUE(found.converged());
  EXPECT_NEAR(found.temperature[1], 400.0, 0.1);
  EXPECT_FALSE(found.others);
}

TEST(SteadyHeat, HeatThatGrowsFasterThanItFlowsOffRunsAway) {
  const auto power = [](double t) { return 100.0 * std::exp((t - 300.0) / 10.0); };
  const SteadyHeat found = find_steady_heat(tight_network(), lumped(+power));
  EXPECT_EQ(found.status, HeatStatus::no_steady_state);
  EXPECT_THAT(found.reason, ::testing::HasSubstr("heat up beyond"));
}

TEST(SteadyHeat, FollowsLossesThatTheEstimateDoesNotFeel) {
  // A preload that is lost with the temperatures: 20 (T - 300) = 1000 exp((300 - T)/10).
  HeatSource source = lumped(+[](double) { return 100.0; });
  source.exact = [](const OfParts& t) -> std::optional<OfParts> {
    const double all = 1000.0 * std::exp((300.0 - t[1]) / 10.0);
    return OfParts(all / 4, all / 2, all / 4);
  };
  const SteadyHeat found = find_steady_heat(tight_network(), source);
  ASSERT_TRUE(found.converged()) << found.reason;
  const double rise = found.temperature[1] - 300.0;
  EXPECT_NEAR(2.0 * rise, 100.0 * std::exp(-rise / 10.0), 1e-4);
  EXPECT_LT(found.evaluations, 15);
}

TEST(SteadyHeat, LossesThatJumpAcrossTheBalanceAreReported) {
  HeatSource source = lumped(+[](double) { return 100.0; });
  source.exact = [](const OfParts& t) -> std::optional<OfParts> {
    const double all = t[1] < 310.0 ? 400.0 : 0.0;
    return OfParts(all / 4, all / 2, all / 4);
  };
  const SteadyHeat found = find_steady_heat(tight_network(), source);
  EXPECT_EQ(found.status, HeatStatus::iteration_limit);
  EXPECT_THAT(found.reason, ::testing::HasSubstr("400 W, the other 0 W"));
}

// Duty cycles -------------------------------------------------------------------------------------

Case with_duty(Case c, std::vector<Heat::DutyStep> steps) {
  c.heat->duty = std::move(steps);
  c.heat->capacity = Heat::Capacity{350.0, 120.0, 700.0};
  return c;
}

Heat::DutyStep acting(const char* name, double duration) { return {name, duration, {}}; }
Heat::DutyStep rest(double duration) { return {{}, {}, duration}; }

HeatCycle cycle_of(const Case& c) {
  const Result result = analyze_heat(c);
  EXPECT_TRUE(result.heat_cycle->converged()) << result.heat_cycle->reason;
  return *result.heat_cycle;
}

TEST(HeatCycle, ADutyOfOneLoadCaseEndsAtItsSteadyState) {
  for (Case c : {warm_reference(), warm_solved()}) {
    c = with_duty(c, {acting(c.load_cases[0].name.c_str(), 1e5)});
    const Result result = analyze_heat(c);
    const HeatCycle& cycle = *result.heat_cycle;
    ASSERT_TRUE(cycle.converged()) << cycle.reason;
    const HeatResult& steady = *result.load_cases[0].heat;
    for (const Part p : kParts) {
      EXPECT_NEAR(cycle.temperature[p].back(), steady.temperature[p], 1e-6);
      EXPECT_NEAR(cycle.peak[p], steady.temperature[p], 1e-6);
      EXPECT_NEAR(cycle.mean[p], steady.temperature[p], 1e-6);
    }
    const SlipResult& slip = *result.load_cases[0].slip;
    EXPECT_NEAR(*cycle.efficiency, *slip.efficiency, 1e-7);
    EXPECT_NEAR(cycle.energy_lost / (slip.power.total() * 1e5), 1.0, 1e-7);
  }
}

/// One load case of 35 kN, and one of 10 kN in the other direction at twice the speed.
Case two_loads(Case c) {
  c.load_cases[0].name = "pull";
  LoadCase back = c.load_cases[0];
  back.name = "return";
  back.speed = -2.0 * c.operation->speed;
  if (back.direction)
    back.direction = Direction::compression, back.axial_force *= 0.3;
  else
    back.axial_force *= -0.3;
  c.load_cases.push_back(back);
  return c;
}

/// The linear network of a case whose losses do not follow the temperature: T_inf + exp(-C^-1 K t) (T - T_inf).
struct ClosedForm {
  explicit ClosedForm(const Case& c)
      : heat(plain_heat(c, checked_contacts(c, Detail::numbers), Eigen::Vector3d::Constant(300.0))),
        ambient(Eigen::Vector3d::Constant(c.heat->ambient)),
        root(Eigen::Vector3d(350.0, 120.0, 700.0).cwiseSqrt()) {
    Eigen::Matrix3d conductance;
    for (int i = 0; i < 3; ++i) conductance.col(i) = plain_flow(*c.heat, ambient + Eigen::Vector3d::Unit(i));
    modes.compute(root.cwiseInverse().asDiagonal() * conductance * root.cwiseInverse().asDiagonal());
    steady = ambient + conductance.ldlt().solve(heat);
  }

  Eigen::Matrix3d decay(double time) const {
    return root.cwiseInverse().asDiagonal() * modes.eigenvectors() *
           (-modes.eigenvalues() * time).array().exp().matrix().asDiagonal() * modes.eigenvectors().transpose() *
           root.asDiagonal();
  }
  Eigen::Vector3d after(const Eigen::Vector3d& from, double time, bool acts) const {
    const Eigen::Vector3d& to = acts ? steady : ambient;
    return to + decay(time) * (from - to);
  }
  /// Temperatures at a time of steps that act and rest in turn.
  Eigen::Vector3d course(Eigen::Vector3d t, const std::vector<double>& steps, double time) const {
    for (std::size_t k = 0; k < steps.size() && time > 0.0; time -= steps[k++])
      t = after(t, std::min(time, steps[k]), k % 2 == 0);
    return t;
  }

  Eigen::Vector3d heat, ambient, root, steady;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes;
};

void expect_course(const HeatCycle& cycle, const ClosedForm& exact, const Eigen::Vector3d& start,
                   const std::vector<double>& steps) {
  for (std::size_t i = 0; i < cycle.time.size(); ++i) {
    const Eigen::Vector3d t = exact.course(start, steps, cycle.time[i]);
    EXPECT_NEAR(cycle.temperature.screw[i], t[0], 1e-6) << cycle.time[i];
    EXPECT_NEAR(cycle.temperature.roller[i], t[1], 1e-6) << cycle.time[i];
    EXPECT_NEAR(cycle.temperature.nut[i], t[2], 1e-6) << cycle.time[i];
  }
}

/// Without an oil Coulomb's losses do not follow the temperature.
Case with_constant_losses() {
  Case c = with_duty(test::with_coulomb(warm_reference(), 0.08),
                     {acting("reference", 40.0), rest(25.0), acting("reference", 10.0), rest(90.0)});
  c.lubricant.reset();
  return c;
}
const std::vector<double> kSteps{40.0, 25.0, 10.0, 90.0};

TEST(HeatCycle, ConstantLossesGiveTheClosedFormOfALinearNetwork) {
  const Case c = with_constant_losses();
  const HeatCycle cycle = cycle_of(c);
  const ClosedForm exact(c);
  // Periodic start of the linear map.
  const Eigen::Vector3d start =
      (Eigen::Matrix3d::Identity() - exact.decay(165.0))
          .partialPivLu()
          .solve(exact.course(exact.ambient, kSteps, 165.0) - exact.decay(165.0) * exact.ambient);
  ASSERT_EQ(cycle.time.front(), 0.0);
  ASSERT_NEAR(cycle.time.back(), 165.0, 1e-9);
  expect_course(cycle, exact, start, kSteps);
  EXPECT_NEAR(cycle.energy_lost / (50.0 * exact.heat.sum()), 1.0, 1e-10);
  EXPECT_FALSE(cycle.is_mission());
}

// The check of the definition: conductances screw-ambient 2, screw-rollers 20, rollers-nut 30, nut-ambient 8 W/K.
TEST(Mission, ConstantLossesGiveTheDigitsOfTheSolvedCase) {
  Heat heat;
  heat.ambient = 25.0 + kCelsius;
  heat.conductance = {.screw_ambient = 2.0, .nut_ambient = 8.0, .screw_rollers = 20.0, .rollers_nut = 30.0};
  const ThermalNetwork network = thermal_network(heat);
  const OfParts capacity(400.0, 250.0, 700.0), losses(300.0, 250.0, 150.0), start = OfParts::Constant(heat.ambient);
  const std::vector<LossTable> tables{LossTable(Losses{losses, losses.sum(), 0.0})};
  const auto after = [&](double time) {
    const DutySegment segments[] = {{0, time}};
    return warming(network, capacity, segments, tables, start, 60.0 + kCelsius);
  };
  const std::pair<double, OfParts> solved[] = {{30.0, {44.372970, 41.743625, 35.376104}},
                                               {120.0, {76.273929, 71.293154, 61.585512}},
                                               {600.0, {109.210063, 102.786722, 90.233191}},
                                               {1e5, {110.294118, 103.823529, 91.176471}}};
  for (const auto& [time, celsius] : solved) {
    const HeatCycle mission = after(time);
    ASSERT_TRUE(mission.converged());
    EXPECT_LT((kelvin(*mission.end) - celsius - OfParts::Constant(kCelsius)).cwiseAbs().maxCoeff(), 6e-7) << time;
    EXPECT_LT((kelvin(mission.peak) - kelvin(*mission.end)).cwiseAbs().maxCoeff(), 1e-7) << time;
  }
  EXPECT_FALSE(after(30.0).time_to_limit.screw);
  EXPECT_NEAR(*after(600.0).time_to_limit.screw, 65.913007, 6e-7);
  EXPECT_EQ(kelvin(*after(30.0).start), start);
}

TEST(Mission, RunsThroughItsCyclesFromTheStart) {
  Case c = with_constant_losses();
  c.heat->cycles = 3;
  c.heat->start = PerPart<double>{300.0, 290.0, 280.0};
  const ClosedForm exact(c);
  const Eigen::Vector3d start(300.0, 290.0, 280.0);
  std::vector<double> steps;
  for (int cycle = 0; cycle < 3; ++cycle) steps.insert(steps.end(), kSteps.begin(), kSteps.end());
  // The rollers reach this limit within the first step.
  const double limit = exact.after(start, 25.0, true)[1];
  AnalysisOptions options;
  options.temperature_limit = limit;
  const HeatCycle mission = *analyze_heat(c, options).heat_cycle;
  ASSERT_TRUE(mission.converged()) << mission.reason;
  EXPECT_EQ(mission.cycles, 3);
  EXPECT_NEAR(mission.period, 165.0, 1e-9);
  EXPECT_NEAR(mission.time.back(), 495.0, 1e-9);
  expect_course(mission, exact, start, steps);
  EXPECT_EQ(kelvin(*mission.start), start);
  EXPECT_LT((kelvin(*mission.end) - exact.course(start, steps, 495.0)).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_NEAR(*mission.time_to_limit.roller, 25.0, 1e-6);
  EXPECT_NEAR(mission.energy_lost / (150.0 * exact.heat.sum()), 1.0, 1e-10);
  // The mean follows from the balance of energy: what is lost warms the parts or flows to the surroundings.
  const Eigen::Vector3d capacity(350.0, 120.0, 700.0);
  const Eigen::Vector3d flow = plain_flow(*c.heat, kelvin(mission.mean));
  EXPECT_NEAR(495.0 * flow.sum() + capacity.dot(kelvin(*mission.end) - start), mission.energy_lost, 1e-3);
}

TEST(Mission, FromThePeriodicStateIsThatState) {
  SKIP_UNDER_SANITIZERS();
  Case c = with_duty(two_loads(warm_solved()), {acting("pull", 60.0), rest(30.0), acting("return", 45.0)});
  c.model.loads = ModelOptions::Loads::at_rest;  // `plain_heat` has loads at rest.
  const HeatCycle periodic = cycle_of(c);
  c.heat->cycles = 2;
  const auto at = [&](std::size_t k) {
    return PerPart<double>{periodic.temperature.screw[k], periodic.temperature.roller[k], periodic.temperature.nut[k]};
  };
  c.heat->start = at(0);
  const Result result = analyze_heat(c);
  const HeatCycle& mission = *result.heat_cycle;
  ASSERT_TRUE(mission.converged()) << mission.reason;
  for (const Part p : kParts) {
    EXPECT_NEAR((*mission.end)[p], periodic.temperature[p].back(), 1e-3);
    EXPECT_NEAR(mission.peak[p], periodic.peak[p], 1e-3);
    EXPECT_NEAR(mission.mean[p], periodic.mean[p], 1e-3);
  }
  EXPECT_NEAR(mission.energy_lost / (2.0 * periodic.energy_lost), 1.0, 1e-5);
  // Load cases stand at the mean temperatures of the mission, not at steady ones.
  for (const LoadCaseResult& r : result.load_cases) EXPECT_EQ(kelvin(r.heat->temperature), kelvin(mission.mean));
  const LoadCaseResult& pull = result.load_cases[0];
  const Eigen::Vector3d heat = plain_heat(c, result.contacts, kelvin(mission.mean));
  EXPECT_NEAR(pull.slip->power.total() / heat.sum(), 1.0, 1e-6);
}

TEST(Mission, EndsWhereSteelDoes) {
  Case c = with_constant_losses();
  c.heat->duty = {acting("reference", 1e7)};
  c.heat->conductance = {.nut_ambient = 0.01, .screw_rollers = 20.0, .rollers_nut = 30.0};
  c.heat->cycles = 1;
  AnalysisOptions options;
  options.temperature_limit = 400.0;
  const HeatCycle mission = *analyze_heat(c, options).heat_cycle;
  EXPECT_EQ(mission.status, HeatStatus::no_steady_state);
  EXPECT_THAT(mission.reason, ::testing::HasSubstr("the parts pass 726.85 degC"));
  EXPECT_TRUE(mission.time_to_limit.screw);
}

/// One load in two load cases, the second of a hundredth of the time, whose table may have a larger error.
TEST(HeatCycle, ARareLoadCaseWeighsAsItsShareOfThePower) {
  SKIP_UNDER_SANITIZERS();
  for (const Case& base : {warm_reference(), warm_solved()}) {
    Case c = two_loads(base);
    c.load_cases[1] = c.load_cases[0];
    c.load_cases[1].name = "again";
    const std::string first = c.load_cases[0].name;
    const HeatCycle whole = cycle_of(with_duty(c, {acting(first.c_str(), 60.0), rest(30.0)}));
    const HeatCycle parted = cycle_of(with_duty(c, {acting(first.c_str(), 59.4), acting("again", 0.6), rest(30.0)}));
    EXPECT_NEAR(parted.mean.screw, whole.mean.screw, 1e-6);
    EXPECT_NEAR(parted.peak.roller, whole.peak.roller, 1e-6);
    EXPECT_NEAR(parted.energy_lost / whole.energy_lost, 1.0, 1e-8);
  }
}

TEST(HeatCycle, EnergyThatIsLostFlowsToTheSurroundings) {
  SKIP_UNDER_SANITIZERS();
  for (const Case& base : {warm_reference(), warm_solved()}) {
    const Case c = with_duty(two_loads(base), {acting("pull", 60.0), rest(30.0), acting("return", 45.0)});
    const HeatCycle cycle = cycle_of(c);
    const Heat::Conductance& k = c.heat->conductance;
    const double a = c.heat->ambient;
    const double to_ambient =
        cycle.period * (k.screw_ambient * (cycle.mean.screw - a) + k.nut_ambient * (cycle.mean.nut - a) +
                        k.rollers_ambient * (cycle.mean.roller - a));
    EXPECT_NEAR(to_ambient / cycle.energy_lost, 1.0, 1e-8);
    EXPECT_NEAR(cycle.period, 135.0, 1e-9);
    EXPECT_GT(*cycle.efficiency, 0.4);
    EXPECT_LT(*cycle.efficiency, 1.0);
    for (const Part p : kParts) {
      EXPECT_NEAR(cycle.temperature[p].front(), cycle.temperature[p].back(), 1e-6);
      EXPECT_GE(cycle.peak[p], cycle.mean[p]);
      EXPECT_EQ(cycle.time.size(), cycle.temperature[p].size());
    }
  }
}

TEST(HeatCycle, IsTheEndOfManyCyclesOfAPlainIntegration) {
  SKIP_UNDER_SANITIZERS();
  // Small capacities: the parts forget their start within few cycles.
  Case c = with_duty(two_loads(warm_reference()), {acting("pull", 20.0), acting("return", 12.0)});
  c.heat->capacity = Heat::Capacity{70.0, 25.0, 90.0};
  const HeatCycle cycle = cycle_of(c);
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  const Eigen::Vector3d capacity(70.0, 25.0, 90.0);
  const auto rate = [&](const Eigen::Vector3d& t, std::size_t k) -> Eigen::Vector3d {
    return (plain_heat(c, contacts, t, k) - plain_flow(*c.heat, t)).cwiseQuotient(capacity);
  };
  // Runge and Kutta, from ambient temperature.
  Eigen::Vector3d t = Eigen::Vector3d::Constant(c.heat->ambient);
  const double h = 0.25;
  for (int turn = 0; turn < 8; ++turn)
    for (const auto& [k, steps] : {std::pair<std::size_t, int>{0, 80}, {1, 48}})
      for (int i = 0; i < steps; ++i) {
        const Eigen::Vector3d a = rate(t, k), b = rate(t + h / 2 * a, k), d = rate(t + h / 2 * b, k),
                              e = rate(t + h * d, k);
        t += h / 6 * (a + 2 * b + 2 * d + e);
      }
  EXPECT_NEAR(cycle.temperature.screw.back(), t[0], 1e-4);
  EXPECT_NEAR(cycle.temperature.roller.back(), t[1], 1e-4);
  EXPECT_NEAR(cycle.temperature.nut.back(), t[2], 1e-4);
}

TEST(HeatCycle, MassesAreThoseOfTheParts) {
  Case c = warm_solved();
  c.heat->specific_heat = 460.0;
  const OfParts capacity = heat_capacities(c, c.mechanism);
  const double steel = 460.0 * 7810.0 * std::numbers::pi / 4.0;
  EXPECT_NEAR(capacity[0], steel * (21e-3 * 21e-3 - 6e-3 * 6e-3) * 90e-3, 1e-9);
  EXPECT_NEAR(capacity[2], steel * (46e-3 * 46e-3 - 35e-3 * 35e-3) * 90e-3, 1e-9);
  EXPECT_NEAR(capacity[1], steel * 11.0 * (49e-6 * 20.0 * 5e-3 / 3.0 + 25e-6 * 10e-3), 1e-9);
}

Case with_thin_films(const Case& c) {
  Case mixed = test::with_mixed_friction(c, 0.12, 1.0);
  mixed.roughness = PerPart<double>{0.2e-6, 0.2e-6, 0.2e-6};
  return mixed;
}

TEST(HeatCycle, EndsOfLongStepsAreSteadyStatesInTheColdToo) {
  SKIP_UNDER_SANITIZERS();
  // Losses are many times larger at the start of the step than at its end.
  for (const double ambient : {25.0, -10.0, -40.0})
    for (Case c : {warm_reference(), warm_solved()}) {
      c = with_duty(with_thin_films(c), {acting(c.load_cases[0].name.c_str(), 6e3), rest(6e3)});
      c.heat->ambient = ambient + kCelsius;
      const Result result = analyze_heat(c);
      const HeatCycle& cycle = *result.heat_cycle;
      ASSERT_TRUE(cycle.converged()) << cycle.reason;
      for (const Part p : kParts)
        EXPECT_NEAR(cycle.peak[p], result.load_cases[0].heat->temperature[p], 1e-6) << name(p) << " at " << ambient;
    }
}

TEST(HeatCycle, ShortCyclesInTheColdConverge) {
  SKIP_UNDER_SANITIZERS();
  Case c = with_duty(with_thin_films(warm_solved()), {acting("pull", 60.0), rest(540.0)});
  c.heat->ambient = -40.0 + kCelsius;
  const Result result = analyze_heat(c);
  EXPECT_TRUE(result.heat_cycle->converged()) << result.heat_cycle->reason;
  EXPECT_THAT(sentences(result.warnings), ::testing::Not(::testing::Contains(::testing::HasSubstr("duty"))));
}

TEST(HeatCycle, NeitherLongStepsNorLightPartsEndIt) {
  SKIP_UNDER_SANITIZERS();
  for (const auto& [duration, capacity] : {std::pair{1e9, 300.0}, {4.0, 1e-9}}) {
    Case c = with_duty(warm_reference(), {acting("reference", duration), rest(duration)});
    c.heat->capacity = Heat::Capacity{capacity, capacity, capacity};
    const Result result = analyze_heat(c);
    const HeatCycle& cycle = *result.heat_cycle;
    ASSERT_TRUE(cycle.converged()) << cycle.reason;
    const PerPart<double>& steady = result.load_cases[0].heat->temperature;
    for (const Part p : kParts) {
      EXPECT_NEAR(cycle.peak[p], steady[p], 1e-6);
      EXPECT_NEAR(cycle.mean[p], 0.5 * (steady[p] + c.heat->ambient), 1e-3);
    }
  }
}

TEST(HeatCycle, PeaksBetweenTheStepsCount) {
  // At the start of the rest the rollers are hotter than the screw and warm it for a while.
  Case c = with_duty(test::with_coulomb(two_loads(warm_reference()), 0.08),
                     {acting("pull", 30.0), acting("return", 20.0), rest(300.0)});
  c.lubricant.reset();
  const Eigen::Vector3d capacity(300.0, 300.0, 900.0);
  c.heat->capacity = Heat::Capacity{300.0, 300.0, 900.0};
  c.heat->conductance.screw_ambient = 0.5;
  c.heat->conductance.nut_ambient = 20.0;
  const HeatCycle cycle = cycle_of(c);
  // Losses are constant: small steps of Runge and Kutta from the start of the cycle.
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  const Eigen::Vector3d some = Eigen::Vector3d::Constant(300.0);
  Eigen::Vector3d t(cycle.temperature.screw[0], cycle.temperature.roller[0], cycle.temperature.nut[0]);
  Eigen::Vector3d peak = t;
  const double h = 0.02;
  const std::pair<Eigen::Vector3d, int> acts[] = {{plain_heat(c, contacts, some, 0), 1500},
                                                  {plain_heat(c, contacts, some, 1), 1000},
                                                  {Eigen::Vector3d::Zero(), 15000}};
  for (const auto& act : acts)
    for (int i = 0; i < act.second; ++i) {
      const auto rate = [&](const Eigen::Vector3d& at) -> Eigen::Vector3d {
        return (act.first - plain_flow(*c.heat, at)).cwiseQuotient(capacity);
      };
      const Eigen::Vector3d k1 = rate(t), k2 = rate(t + h / 2 * k1), k3 = rate(t + h / 2 * k2), k4 = rate(t + h * k3);
      t += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      peak = peak.cwiseMax(t);
    }
  EXPECT_LT((kelvin(cycle.peak) - peak).cwiseAbs().maxCoeff(), 1e-6);
  // One of them lies within a step.
  double between = 0.0;
  for (const Part p : kParts) between = std::max(between, cycle.peak[p] - std::ranges::max(cycle.temperature[p]));
  EXPECT_GT(between, 1e-5);
}

TEST(HeatCycle, EfficiencyIsWhatComesOutOverWhatGoesIn) {
  SKIP_UNDER_SANITIZERS();
  // A load that drives a screw with much friction: all input is lost.
  Case locking = test::left_handed(test::with_coulomb(warm_reference(), 0.5));
  locking.mechanism.lead = -2e-3;
  locking = with_duty(locking, {acting("reference", 50.0), rest(50.0)});
  const HeatCycle held = cycle_of(locking);
  EXPECT_FALSE(held.efficiency);
  EXPECT_GT(held.energy_in, 0.0);
  // With an imposed slip ratio more is lost than the powers of shaft and load show.
  Case imposed = test::with_coulomb(warm_reference(), 0.08);
  imposed = with_duty(imposed, {acting("reference", 50.0), rest(50.0)});
  const Result free = analyze_heat(imposed);
  imposed.operation->slip_ratio = 0.98 * free.load_cases[0].slip->slip_ratio;
  const Result result = analyze_heat(imposed);
  EXPECT_NEAR(*result.heat_cycle->efficiency, *result.load_cases[0].slip->efficiency, 1e-9);
}

TEST(LossTable, InterpolatesASmoothFunctionAndItsDerivatives) {
  SKIP_UNDER_SANITIZERS();
  const auto at = [](const OfParts& t) -> std::optional<Losses> {
    const double a = 1e3 * std::exp(-0.02 * (t[0] - 300.0)) / (1.0 + 0.01 * (t[2] - 300.0));
    return Losses{OfParts(a, 2.0 * t[1], 5.0), a + t[1], t[1]};
  };
  const TemperatureBox box{OfParts(300.0, -4.0, -2.0), OfParts(330.0, 3.0, 2.0)};
  const std::optional<LossTable> table = LossTable::over(box, at, true, {1e-9, 10000}, {});
  ASSERT_TRUE(table);
  EXPECT_LE(table->error(), 3e-9);
  const OfParts t(314.0, 312.5, 313.0);
  const LossTable::Value v = table->at(t);
  const Losses exact = *at(t);
  EXPECT_NEAR(v.value[0] / exact.heat[0], 1.0, 1e-8);
  EXPECT_NEAR(v.value[3] / exact.input, 1.0, 1e-8);
  EXPECT_NEAR(v.value[4] / exact.output, 1.0, 1e-8);
  EXPECT_LT((v.value - table->value_at(t)).norm(), 1e-9);
  EXPECT_NEAR(v.by_temperature(0, 0), -0.02 * exact.heat[0], 1e-3);
  EXPECT_NEAR(v.by_temperature(1, 1), 2.0, 1e-5);
}

TEST(LossTable, HalvesPanelsAtAKinkAndTellsWhatIsLeft) {
  // Even about the middle of the box in one coordinate, with a kink in the other.
  const auto at = [](const OfParts& t) -> std::optional<Losses> {
    const OfParts c = table_coordinates(t);
    const double a = 1e3 + std::abs(c[0] - 311.0) + std::cos(c[1]);
    return Losses{OfParts(a, 0.0, 0.0), a, 0.0};
  };
  const TemperatureBox box{OfParts(300.0, -4.0, 0.0), OfParts(330.0, 4.0, 0.0)};
  const std::optional<LossTable> table = LossTable::over(box, at, false, {1e-9, 5000}, {});
  ASSERT_TRUE(table);
  double worst = 0.0;
  for (double mean = 300.0; mean < 330.0; mean += 0.0917)
    for (double difference = -4.0; difference < 4.0; difference += 0.37) {
      const double screw_oil = mean + 0.5 * difference, nut_oil = mean - 0.5 * difference;
      const OfParts t(2.0 * screw_oil - mean, mean, 2.0 * nut_oil - mean);
      worst = std::max(worst, std::abs(table->value_at(t)[0] / at(t)->heat[0] - 1.0));
    }
  EXPECT_LT(worst, 1e-5);
  EXPECT_LE(worst, std::max(2.0 * table->error(), 1e-9));
}

TEST(LossTable, CorrectsARoughTableAlongAPath) {
  const auto at = [](const OfParts& t) -> std::optional<Losses> {
    const OfParts c = table_coordinates(t);
    const double a = 1e3 * std::exp(-0.02 * (c[0] - 300.0) - 0.01 * c[1]) + std::pow(std::max(c[2] - 1.0, 0.0), 1.5);
    return Losses{OfParts(a, 2.0 * t[1], 5.0), a + t[1], t[1]};
  };
  // The rollers overtake the oil, and the difference of the oils rises and falls.
  std::vector<OfParts> path;
  for (int i = 0; i <= 2000; ++i) {
    const double s = i / 2000.0;
    path.emplace_back(300.0 + 20.0 * (1.0 - std::exp(-2.0 * s)), 3.0 * s * (1.0 - s), -3.0 + 6.0 * s);
  }
  int evaluations = 0;
  const auto counted = [&](const OfParts& t) { return ++evaluations, at(t); };
  const std::optional<LossTable> rough = LossTable::over(around(path), at, true, {1e-2, 30}, {});
  ASSERT_TRUE(rough);
  const std::optional<LossTable> table = LossTable::along(path, counted, {1e-8, 400}, *rough);
  ASSERT_TRUE(table);
  EXPECT_LT(evaluations, 430);
  double worst = 0.0, worst_rough = 0.0;
  for (const OfParts& c : path) {
    const OfParts t = temperatures_of(c);
    worst = std::max(worst, table->distance(t, *at(t)));
    worst_rough = std::max(worst_rough, rough->distance(t, *at(t)));
  }
  EXPECT_LT(worst, 3e-8);
  EXPECT_GT(worst_rough, 100.0 * worst);

  // A path that comes back in every coordinate has none to go by.
  std::ranges::copy(std::vector(path.rbegin(), path.rend()), std::back_inserter(path));
  EXPECT_FALSE(LossTable::along(path, at, {1e-8, 400}, *rough));
}

}  // namespace
}  // namespace prs
