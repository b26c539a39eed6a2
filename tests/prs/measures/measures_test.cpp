#include "prs/measures/measures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "prs/input/reader.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_case_result.h"
#include "prs/measures/measures_record.h"
#include "prs/record/record_table.h"
#include "support/plain_contact.h"
#include "tests/prs/input/abevi.h"

namespace prs {
namespace {

using std::numbers::pi;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double kForce = 45e3;
constexpr int kContacts = 220;

/// The screw of Abevi 2015 of steel with a density, and all inputs of measures.
Case abevi(const std::vector<std::string>& overrides = {}) {
  Case c = input::read_case_text(input::abevi_with("poisson_ratio: 0.3", "poisson_ratio: 0.3\n  density: 7810 kg/m^3"),
                                 "test.yaml", overrides, Command::solve);
  c.load_cases.resize(2);  // pull, push under 1 kN
  c.measures = MeasureOptions{.loaded_width = 2e-3,
                              .friction_coefficient = 0.01,
                              .yield_strength = 800e6,
                              .shaft = MeasureOptions::Shaft{.length = 0.6},
                              .system = {}};
  return c;
}

Measures measures(const Case& c) { return measures_of(c, find_contacts(c.mechanism, c.materials, Detail::numbers)); }

LoadMeasures load_measures(const Case& c, std::size_t load_case) {
  const Result r = analyze(c);
  return load_measures_of(c, r.contacts, measures_of(c, r.contacts), r.load_cases[load_case]);
}

/// Warnings about equal thread loads.
std::vector<std::string> load_warnings(const Case& c, double force) {
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  const Measures m = measures_of(c, contacts);
  LoadCaseResult result;
  result.load_case.axial_force = force;
  result = equal_share_result(result.load_case, contacts);
  return sentences(unusual_load_measures(c, contacts, m, load_measures_of(c, contacts, m, result), result));
}

std::size_t defined(const Measures& m) { return object_of(m).size(); }

TEST(Measures, AreAllThereForACompleteCase) {
  // The screw of an inverted mechanism does not turn and has no critical speed.
  EXPECT_EQ(defined(measures(abevi())), record_of<Measures>().quantities.size() - 1);
  Case standard = abevi();
  standard.mechanism.type = Mechanism::Type::standard;
  standard.mechanism.starts.screw = 5;
  EXPECT_EQ(defined(measures(standard)), record_of<Measures>().quantities.size());
  const LoadMeasures pull = load_measures(abevi(), 0);
  const std::set<std::string_view> lacking = {"l10_hours",
                                              "buckling_safety",
                                              "speed_safety",
                                              "back_driving_efficiency_by_slip",
                                              "solved_static_safety",
                                              "solved_static_safety_limit",
                                              "flank_edge_margin",
                                              "system_stiffness",
                                              "lowest_frequency_Hz",
                                              "speeds_to_avoid_rpm"};
  const auto json = object_of(pull);
  for (const Quantity<LoadMeasures>& q : record_of<LoadMeasures>().quantities)
    EXPECT_EQ(json.contains(q.key), !lacking.contains(q.key)) << q.key;
}

TEST(Measures, AreAbsentWithoutWhatTheyNeed) {
  Case c = abevi();
  c.measures.reset();
  const Measures plain = measures(c);
  EXPECT_FALSE(plain.efficiency || plain.back_driving_efficiency);
  EXPECT_FALSE(plain.tooth_stiffness.screw || plain.buckling_load || plain.critical_speed);
  EXPECT_FALSE(plain.screw_inertia || plain.equivalent_inertia);
  EXPECT_TRUE(plain.weight && plain.nut_inertia && plain.roller_inertia);

  c = abevi();
  c.materials->nut.density.reset();
  const Measures light = measures(c);
  EXPECT_TRUE(light.roller_weight && light.material_volume && light.buckling_load);
  EXPECT_FALSE(light.nut_weight || light.weight || light.force_density);
  EXPECT_FALSE(light.nut_inertia || light.equivalent_inertia);

  c = abevi();
  c.structure.reset();
  const Measures bare = measures(c);
  EXPECT_TRUE(bare.dynamic_capacity && bare.deformation_capacity.nut && bare.velocity_ratio);
  EXPECT_FALSE(bare.material_volume || bare.envelope_volume || bare.section_stiffness.screw);

  c.materials.reset();
  const Measures geometric = measures(c);
  EXPECT_TRUE(geometric.dynamic_capacity);
  EXPECT_FALSE(geometric.deformation_capacity.screw || geometric.pressure_capacity.screw);

  c = abevi();
  c.mechanism.profile.roller = {Profile::Shape::straight, 0.0};
  const Measures straight = measures(c);
  EXPECT_FALSE(straight.deformation_capacity.screw || straight.pressure_capacity.screw);
  EXPECT_TRUE(straight.weight);
}

TEST(Measures, CapacitiesAreThoseOfLife) {
  Case c = abevi();
  const Measures m = measures(c);
  c.life.emplace();
  c.life->share = LoadCase::Share::equal;
  SpectrumLoad load;
  load.force = kForce;
  load.revolutions = 1e3;
  c.life->spectrum = {load};
  const LifeResult life = analyze_life(c);
  EXPECT_NEAR(*m.dynamic_capacity / life.dynamic_capacity, 1.0, 1e-13);
  EXPECT_NEAR(*m.dynamic_capacity_low / life.dynamic_capacity_range.least, 1.0, 1e-13);
  EXPECT_NEAR(*m.dynamic_capacity_high / life.dynamic_capacity_range.greatest, 1.0, 1e-13);
  EXPECT_NEAR(std::min(*m.pressure_capacity.screw, *m.pressure_capacity.nut) / *life.equal_shares_static_capacity, 1.0,
              1e-13);
  const LoadMeasures pull = load_measures(abevi(), 0);
  EXPECT_NEAR(*pull.life / life.catalogue_life, 1.0, 1e-12);
  EXPECT_NEAR(*pull.life_travel, *pull.life * 5e-3, 1e-9 * *pull.life_travel);

  c.life->dynamic_capacity = 60e3;
  EXPECT_EQ(*measures(c).dynamic_capacity, 60e3);
  EXPECT_EQ(*measures(c).geometry_factor, *m.geometry_factor);
}

TEST(Measures, PeakPressureAtThePressureCapacityIsTheLimit) {
  Case c = abevi();
  const Measures m = measures(c);
  for (const Interface i : kInterfaces) {
    c.load_cases[0].axial_force = *m.pressure_capacity[i];
    EXPECT_NEAR(*load_measures(c, 0).mean_peak_pressure[i] / kStaticPressureLimit, 1.0, 1e-12);
  }
}

TEST(Measures, DeformationCapacityIsPalmgrensForTheFlankAsABall) {
  // N = D sqrt(1e-4/(1.3e-7 kappa_1 kappa_2)) [mm, N], D twice the radius of the roller's profile.
  const Measures m = measures(abevi());
  for (const Interface i : kInterfaces) {
    const plain::Touch touch = plain::abevi_touch(i == Interface::screw);
    const auto product = static_cast<double>(touch.smaller * touch.larger) * 1e-6;
    const double normal = 2 * 4.949747468 * std::sqrt(1e-4 / (1.3e-7 * product));
    const double axial = kContacts * normal * std::cos(static_cast<double>(touch.normal_angle));
    EXPECT_NEAR(*m.deformation_capacity[i] / axial, 1.0, 1e-12);
    EXPECT_LT(*m.pressure_capacity[i], *m.deformation_capacity[i]);  // Pressure is decisive.
  }
  // The convex screw is the weaker part.
  EXPECT_LT(*m.deformation_capacity.screw, *m.deformation_capacity.nut);
}

TEST(Measures, WeightAddsUpAndForceDensityIsItsRatio) {
  const Measures m = measures(abevi());
  EXPECT_NEAR(*m.weight, 7810.0 * *m.material_volume, 1e-12);
  EXPECT_NEAR(*m.force_density * *m.weight / *m.dynamic_capacity, 1.0, 1e-13);
  EXPECT_LT(*m.material_volume, *m.envelope_volume);
}

TEST(Measures, EquivalentInertiaIsThatOfItsParts) {
  // Energies of all parts of the inverted screw: the nut turns, the screw travels.
  Case c = abevi();
  const Measures m = measures(c);
  const double speed = 30.0, velocity = speed * 5e-3 / (2.0 * pi);
  const double screw = *m.screw_weight_per_length * c.measures->shaft->length;
  EXPECT_NEAR(*m.travel_inertia * speed * speed, (*m.roller_weight + screw) * velocity * velocity, 1e-12);
  EXPECT_NEAR(*m.equivalent_inertia, *m.nut_inertia + *m.roller_inertia + *m.travel_inertia, 1e-18);
  // Rollers: their axes at r_N/2 times the speed of the nut, c = 14 mm, omega_R = r_N/(2 r_R).
  const double mass = *m.roller_weight / 11.0, axis = 0.5 * 17.5e-3 * speed;
  const double orbit = 11.0 * mass * axis * axis;
  EXPECT_GT(*m.roller_inertia * speed * speed, orbit);
  const double spin = *m.roller_inertia * speed * speed - orbit;
  // Solid cylinders have at most 1/2 M r^2, thinner ends less.
  const double whole = 11.0 * 0.5 * mass * std::pow(3.5e-3 * 2.5 * speed, 2);
  EXPECT_LT(spin, whole);
  EXPECT_GT(spin, 0.8 * whole);

  // For a standard mechanism the screw turns and the nut travels.
  c = abevi();
  c.mechanism.type = Mechanism::Type::standard;
  c.mechanism.starts.screw = 5;
  c.mechanism.pitch_diameter.screw = 21e-3;
  const Measures standard = measures(c);
  EXPECT_NEAR(*standard.travel_inertia * speed * speed, *standard.weight * velocity * velocity, 1e-12);
  EXPECT_NEAR(*standard.equivalent_inertia,
              *standard.screw_inertia + *standard.roller_inertia + *standard.travel_inertia, 1e-18);
}

TEST(Measures, FrictionOfAContactIsNotThatOfTheMechanism) {
  Case c = abevi();
  EXPECT_TRUE(measures(c).efficiency);
  c.measures->friction_coefficient.reset();
  c.friction = friction_by(contact::Coulomb{at_both(0.01)});
  EXPECT_FALSE(measures(c).efficiency);
}

TEST(Measures, StatedCapacityComesBeforeTheLeastOfTheOthers) {
  Case c = abevi();
  const Measures m = measures(c);
  EXPECT_EQ(*m.static_capacity, std::min({*m.deformation_capacity.screw, *m.deformation_capacity.nut,
                                          *m.pressure_capacity.screw, *m.pressure_capacity.nut}));
  EXPECT_NEAR(*load_measures(c, 0).static_safety, std::min(*m.pressure_capacity.screw, *m.pressure_capacity.nut) / 45e3,
              1e-12);
  c.life = Life{};
  c.life->static_capacity = 90e3;
  EXPECT_EQ(*measures(c).static_capacity, 90e3);
  const LoadMeasures stated = load_measures(c, 0);
  EXPECT_NEAR(*stated.static_safety, 2.0, 1e-12);
  EXPECT_NEAR(*stated.thread_static_safety, 2.0, 1e-12);
}

/// The screw of lesson 18 with a pitch of 1 mm: ellipses of 0.37 mm on flanks of 0.23 mm.
Case fine_pitch() {
  return input::read_case_text(R"(mechanism:
  type: standard
  lead: 5 mm
  starts: {screw: 5, roller: 1}
  flank_angle: 45 deg
  pitch_diameter: {screw: 30 mm, roller: 10 mm, nut: 50 mm}
  centre_distance: 20 mm
  profile: {screw: straight, roller: centred, nut: straight}
  rollers: 10
  contacts_per_roller: 40
materials: {youngs_modulus: 210 GPa, poisson_ratio: 0.3}
load_cases: [{name: pull, axial_force: 30 kN, share: equal}]
)",
                               "fine.yaml", {}, Command::contact);
}

/// Warnings of equal thread loads that an ellipse leaves a flank.
std::size_t ellipses_beyond_flanks(const Case& c, double force) {
  Case loaded = c;
  loaded.load_cases[0].axial_force = force;
  const Result r = analyze_contacts(loaded);
  return static_cast<std::size_t>(std::ranges::count_if(sentences(r.load_cases[0].warnings), [](const std::string& w) {
    return w.find("ellipse reaches") != std::string::npos;
  }));
}

TEST(Measures, AtTheFlankEdgeLoadTheFirstEllipseReachesTheEndOfAFlank) {
  for (Case c : {abevi(), fine_pitch()}) {
    c.load_cases[0].share = LoadCase::Share::equal;
    const double edge = *measures(c).flank_edge_load;
    EXPECT_EQ(ellipses_beyond_flanks(c, edge * (1.0 - 1e-9)), 0U);
    EXPECT_GT(ellipses_beyond_flanks(c, edge * (1.0 + 3e-3)), 0U);  // A warning is given from 0.1 um on.
  }
}

TEST(Measures, TheEndOfAFlankIsWarnedOfAndLeavesTheStaticSafety) {
  const Case c = fine_pitch();
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  const Measures m = measures_of(c, contacts);
  EXPECT_NEAR(*m.static_capacity, 261548.0, 1.0);  // The load at 4.0 GPa does not change.
  EXPECT_LT(*m.flank_edge_load, *m.static_capacity);
  const LoadCaseResult result = equal_share_result(c.load_cases[0], contacts);
  const LoadMeasures pull = load_measures_of(c, contacts, m, result);
  EXPECT_NEAR(*pull.static_safety, *m.static_capacity / 30e3, 1e-12 * *pull.static_safety);
  EXPECT_EQ(pull.static_safety_limit, StaticLimit::pressure);
  EXPECT_EQ(pull.thread_static_safety_limit, StaticLimit::pressure);
  const auto near = Contains(HasSubstr("ellipse reaches the edge of a flank"));
  EXPECT_THAT(load_warnings(c, 1.01 * *m.flank_edge_load), near);
  EXPECT_THAT(load_warnings(c, 0.99 * *m.flank_edge_load), near);
  EXPECT_THAT(load_warnings(c, 1.01 * *m.flank_edge_load / kUsualStaticSafety), near);
  EXPECT_THAT(load_warnings(c, 0.99 * *m.flank_edge_load / kUsualStaticSafety), Not(near));
}

TEST(Measures, StaticSafetyIsThatOfLifeWithEqualShares) {
  for (Case c : {abevi(), fine_pitch()}) {
    c.load_cases[0].share = LoadCase::Share::equal;
    const LoadMeasures m = load_measures(c, 0);
    c.life.emplace();
    c.life->share = LoadCase::Share::equal;
    SpectrumLoad load;
    load.force = c.load_cases[0].axial_force;
    load.revolutions = 1e3;
    c.life->spectrum = {load};
    const LifeResult life = analyze_life(c);
    EXPECT_NEAR(*m.static_safety / *life.static_safety(), 1.0, 1e-9);
    EXPECT_EQ(m.static_safety_limit, life.static_safety_limit());
    EXPECT_NEAR(*measures(c).flank_edge_load / *life.equal_shares_flank_edge_load, 1.0, 1e-13);
  }
}

/// For any force of one sense: the load of a thread at its limit does not depend on it.
TEST(Measures, StaticSafetyOfALoadCaseIsThatOfLifeUnderItsForce) {
  Case c = abevi();
  for (const std::size_t k : {0u, 1u}) {
    const LoadCase& load = c.load_cases[k];
    c.life.emplace().position = load.position;
    SpectrumLoad& step = c.life->spectrum.emplace_back();
    step.force = 20.0 * load.axial_force;
    step.direction = *load.direction;
    step.share = 1.0;
    const LifeResult life = analyze_life(c);
    const LoadMeasures m = *analyze_measures(c).load_measures[k];
    EXPECT_NEAR(*m.solved_static_safety, 20.0 * *life.static_safety(), 1e-8 * *m.solved_static_safety);
    EXPECT_EQ(m.solved_static_safety_limit, life.static_safety_limit());
    EXPECT_NEAR(*m.flank_edge_margin / (20.0 * *life.flanks[*load.direction]->flank_edge_margin()), 1.0, 1e-8);
    EXPECT_LT(*m.solved_static_safety, *m.static_safety);  // Threads share unevenly.
  }
}

TEST(Measures, OnlyAScrewThatTurnsIsToldOfItsPressure) {
  Case c = abevi();
  const Measures m = measures(c);
  const double at_3_GPa = std::min(*m.pressure_capacity.screw, *m.pressure_capacity.nut) * std::pow(0.75, 3.0);
  EXPECT_THAT(load_warnings(c, at_3_GPa), Not(Contains(HasSubstr("flanks that run"))));
  c.operation = Operation{};
  c.operation->speed = -10.0;
  EXPECT_THAT(load_warnings(c, at_3_GPa), Contains(HasSubstr("flanks that run")));
  EXPECT_THAT(load_warnings(c, at_3_GPa * std::pow(2.4 / 3.0, 3.0)), Not(Contains(HasSubstr("flanks that run"))));
}

/// Hertz contacts in series with bodies are softer than alone; only additional teeth can reverse that.
TEST(Measures, ThreadsAreStifferThanTheWholeScrewUnlessTeethCount) {
  Case c = abevi();
  const auto pull = [&] {
    const Result r = analyze(c);
    const Measures m = measures_of(c, r.contacts);
    const LoadMeasures l = load_measures_of(c, r.contacts, m, r.load_cases[0]);
    const auto notes = unusual_load_measures(c, r.contacts, m, l, r.load_cases[0]);
    const bool softer = *l.thread_stiffness < *r.load_cases[0].axial_stiffness;
    const bool told = std::ranges::any_of(notes, [](const Warning& warning) { return warning.code == "soft_threads"; });
    EXPECT_EQ(softer, told);
    return softer;
  };
  c.measures->loaded_width = 0.1e-3;
  EXPECT_TRUE(pull());
  c.measures->loaded_width.reset();
  EXPECT_FALSE(pull());
}

TEST(Measures, SayWhatTheFormulasWereNotMadeFor) {
  Case c = abevi();
  const auto warnings = [](const Case& of) {
    const Contacts contacts = find_contacts(of.mechanism, of.materials);
    return unusual_measures(of, contacts, measures_of(of, contacts)).size();
  };
  EXPECT_EQ(warnings(c), 0U);
  c.structure->screw.bore = 0.0205;
  EXPECT_EQ(warnings(c), 1U);
  c = abevi();
  c.contact.normal_angle = {0.6, 0.6};
  EXPECT_EQ(warnings(c), 1U);
  const double capacity = *measures(abevi()).dynamic_capacity;
  EXPECT_THAT(load_warnings(abevi(), 0.49 * capacity), IsEmpty());
  EXPECT_THAT(load_warnings(abevi(), -0.51 * capacity), ElementsAre(HasSubstr("life formula")));
}

TEST(LoadMeasures, ThreadsAreSofterThanEitherInterface) {
  Case c = abevi();
  const LoadMeasures with_teeth = load_measures(c, 0);
  c.measures->loaded_width.reset();
  const LoadMeasures m = load_measures(c, 0);
  EXPECT_NEAR(1.0 / *m.thread_stiffness, 1.0 / *m.hertz_stiffness.screw + 1.0 / *m.hertz_stiffness.nut,
              1e-13 / *m.thread_stiffness);
  EXPECT_LT(*with_teeth.thread_stiffness, *m.thread_stiffness);
  EXPECT_FALSE(m.root_shear_stress.screw);
}

TEST(LoadMeasures, HertzStiffnessIsThatOfTheModelWithEqualShares) {
  Case c = abevi();
  c.load_cases[0].share = LoadCase::Share::equal;
  const Result r = analyze(c);
  const LoadMeasures m = load_measures_of(c, r.contacts, measures_of(c, r.contacts), r.load_cases[0]);
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& loads = (*r.load_cases[0].threads)[i];
    const double axial = loads.approach[0] / std::cos(loads.normal_angle);
    EXPECT_NEAR(*m.hertz_stiffness[i] * axial / kForce, 1.0, 1e-12);
    EXPECT_NEAR(*m.largest_peak_pressure[i] / *m.mean_peak_pressure[i], 1.0, 1e-12);
    EXPECT_FALSE(m.largest_load_rate[i]);
  }
  EXPECT_NEAR(*m.static_safety / *m.thread_static_safety, 1.0, 1e-12);
}

TEST(LoadMeasures, YangIsTheModelWhoseRollerTeethAreBalls) {
  Case c = abevi({"model.roller=rigid_bending"});
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  for (const Interface i : kInterfaces) {
    c.contact.hertz_constant[i] = contacts.interfaces[i].hertz.hertz_constant;
    c.contact.normal_angle[i] = contacts.interfaces[i].normal_angle();
  }
  const auto largest_difference = [&] {
    const Result r = analyze(c);
    const LoadMeasures m = load_measures_of(c, r.contacts, measures_of(c, r.contacts), r.load_cases[0]);
    EXPECT_EQ(m.yang_load_rate.size(), 20U);
    double difference = 0.0;
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < m.yang_load_rate.size(); ++k)
        difference = std::max(difference, std::abs((*r.load_cases[0].threads)[i].load_rate[k] - m.yang_load_rate[k]));
    return difference;
  };
  // A real roller evens out what differs between both interfaces.
  EXPECT_GT(largest_difference(), 1e-3);
  c.materials->roller.youngs_modulus *= 1e-9;
  EXPECT_LT(largest_difference(), 1e-7);
}

TEST(LoadMeasures, MostLoadedThreadRulesStressAndSafety) {
  const Case c = abevi();
  const Result r = analyze(c);
  const LoadMeasures m = load_measures_of(c, r.contacts, measures_of(c, r.contacts), r.load_cases[0]);
  EXPECT_LT(*m.thread_static_safety, *m.static_safety);
  EXPECT_GT(*m.largest_peak_pressure.screw, *m.mean_peak_pressure.screw);
  for (const Interface i : kInterfaces) {
    const auto& rates = (*r.load_cases[0].threads)[i].load_rate;
    EXPECT_EQ(*m.largest_load_rate[i], *std::ranges::max_element(rates));
  }
  // The roller's teeth, as wide at the root, take the larger load of both interfaces.
  EXPECT_NEAR(*m.root_shear_stress.roller, std::max(*m.root_shear_stress.screw, *m.root_shear_stress.nut), 1.0);
  EXPECT_NEAR(*m.root_shear_stress.screw / *m.root_shear_stress.nut,
              *m.largest_load_rate.screw / *m.largest_load_rate.nut, 1e-12);
}

TEST(LoadMeasures, OnlyCompressionBuckles) {
  const Case c = abevi();
  EXPECT_FALSE(load_measures(c, 0).buckling_safety);
  EXPECT_NEAR(*load_measures(c, 1).buckling_safety, *measures(c).buckling_load / 1e3, 1e-9);
  Case equal = abevi();
  equal.load_cases[0].share = LoadCase::Share::equal;
  equal.load_cases[0].direction.reset();
  equal.load_cases[0].axial_force = -2e3;
  EXPECT_NEAR(*load_measures(equal, 0).buckling_safety, *measures(equal).buckling_load / 2e3, 1e-9);
}

TEST(LoadMeasures, SpeedGivesHoursAndAStandardScrewItsMargin) {
  Case c = abevi();
  c.operation = Operation{};
  c.operation->speed = -40.0;
  LoadMeasures m = load_measures(c, 0);
  EXPECT_NEAR(*m.life_hours * 3600.0 * 40.0 / (2.0 * pi) / *m.life, 1.0, 1e-12);
  EXPECT_FALSE(m.speed_safety);  // The screw of an inverted mechanism does not turn.
  c.load_cases[0].speed = 80.0;
  EXPECT_NEAR(*load_measures(c, 0).life_hours / *m.life_hours, 0.5, 1e-12);

  c.mechanism.type = Mechanism::Type::standard;
  c.mechanism.starts.screw = 5;
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  LoadCaseResult result;
  result.load_case = c.load_cases[0];
  const Measures design = measures_of(c, contacts);
  EXPECT_NEAR(*load_measures_of(c, contacts, design, result).speed_safety, *design.critical_speed / 80.0, 1e-9);
}

TEST(LoadMeasures, ACaseThatDidNotConvergeKeepsItsMeanValues) {
  const Case c = abevi();
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  LoadCaseResult failed;
  failed.load_case = c.load_cases[0];
  failed.solve.emplace();
  const LoadMeasures m = load_measures_of(c, contacts, measures_of(c, contacts), failed);
  EXPECT_TRUE(m.mean_peak_pressure.screw && m.life && m.static_safety && !m.yang_load_rate.empty());
  EXPECT_FALSE(m.largest_peak_pressure.screw || m.largest_load_rate.nut || m.thread_static_safety);
}

TEST(MeasureQuantities, EveryMeasureHasOneKey) {
  // Measures and the scalars of LoadMeasures are optional numbers, except the static limits and the load rates of the
  // threads; one key is of two numbers.
  using Number = std::optional<double>;
  const auto design = record_of<Measures>().quantities;
  const auto load = record_of<LoadMeasures>().quantities;
  const auto count = [&](Kind kind) {
    return static_cast<std::size_t>(
        std::ranges::count_if(load, [&](const Quantity<LoadMeasures>& q) { return q.value.kind == kind; }));
  };
  EXPECT_EQ(sizeof(Measures), design.size() * sizeof(Number));
  EXPECT_EQ(sizeof(LoadMeasures),
            (count(Kind::number) - 1) * sizeof(Number) + count(Kind::text) * sizeof(std::optional<StaticLimit>) +
                count(Kind::series) * sizeof(std::vector<double>) + sizeof(LoadMeasures::system_stiffness));
  std::set<std::string_view> keys;
  for (const Quantity<Measures>& q : design) keys.insert(q.key);
  for (const Quantity<LoadMeasures>& q : load) keys.insert(q.key);
  EXPECT_EQ(keys.size(), design.size() + load.size());

  // No two keys show the same number.
  Measures m;
  auto* const numbers = reinterpret_cast<Number*>(&m);
  for (std::size_t i = 0; i < design.size(); ++i) numbers[i] = static_cast<double>(i + 1);
  std::set<double> shown;
  for (const Quantity<Measures>& q : design) shown.insert(*q.value.number(m));
  EXPECT_EQ(shown.size(), design.size());
}

TEST(MeasureQuantities, EstimatesAreKeysOfMeasures) {
  std::set<std::string_view> keys;
  for (const auto& q : record_of<Measures>().quantities) keys.insert(q.key);
  for (const auto& q : record_of<LoadMeasures>().quantities) keys.insert(q.key);
  for (const std::string& estimate : estimates_beside({true, true, true, true}))
    EXPECT_TRUE(keys.contains(estimate)) << estimate;
  EXPECT_THAT(estimates_beside({}), IsEmpty());
}

TEST(MeasureQuantities, SayWhatTheyAre) {
  const auto complete = [](const auto& q) {
    return !q.title.empty() && !q.group.empty() && !q.meaning.empty() && !q.validity.empty() && !q.source.empty();
  };
  EXPECT_TRUE(std::ranges::all_of(record_of<Measures>().quantities, complete));
  EXPECT_TRUE(std::ranges::all_of(record_of<LoadMeasures>().quantities, complete));
}

}  // namespace
}  // namespace prs
