#include "prs/loads/analyze.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "prs/input/reader.h"
#include "prs/loads/load_record.h"
#include "prs/model/problems.h"
#include "prs/record/record_table.h"
#include "prs/run/commands.h"
#include "support/plain_contact.h"
#include "support/slips.h"
#include "support/sum.h"

namespace prs {
namespace {

using test::sum;

const std::filesystem::path kConfigs = PRS_SOURCE_DIR "/configs";

Case lesson(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return input::read_case((kConfigs / name).string(), overrides, Command::solve);
}

TEST(Analyze, EveryLessonConverges) {
  for (const auto& entry : std::filesystem::directory_iterator(kConfigs)) {
    if (entry.path().extension() != ".yaml" || other_file(input::load_source(entry.path().string(), {}))) continue;
    const Result result = analyze(lesson(entry.path().filename().string()));
    EXPECT_FALSE(result.load_cases.empty()) << entry.path();
    for (const LoadCaseResult& r : result.load_cases)
      EXPECT_TRUE(r.converged()) << entry.path() << ' ' << r.load_case.name;
  }
}

TEST(Analyze, BothSolversGiveTheSameEnergy) {
  const Case c = lesson("13_three_models.yaml", {"model.bodies=refined"});
  const Result sparse = analyze(c, {.solver = Solver::sparse});
  const Result chain = analyze(c, {.detail = Detail::numbers, .solver = Solver::chain});
  for (std::size_t k = 0; k < sparse.load_cases.size(); ++k) {
    const double energy = sparse.load_cases[k].solve->history.back().energy;
    EXPECT_NEAR(chain.load_cases[k].solve->energy / energy, 1.0, 1e-9);
    EXPECT_EQ(sparse.load_cases[k].solve->energy, energy);
  }
}

TEST(Analyze, LoadRatesAreAxialLoadsOverForcePerRollerAndSumToOne) {
  const Case c = lesson("03_load_sweep.yaml");
  for (const LoadCaseResult& r : analyze(c).load_cases)
    for (const Interface i : kInterfaces) {
      const InterfaceLoads& loads = (*r.threads)[i];
      EXPECT_NEAR(sum(loads.load_rate), 1.0, 1e-10);
      for (std::size_t k = 0; k < loads.axial_load.size(); ++k) {
        EXPECT_NEAR(loads.axial_load[k] / (loads.normal_load[k] * std::cos(loads.normal_angle)), 1.0, 1e-14);
        EXPECT_NEAR(loads.normal_load[k] / (*loads.hertz_constant * std::pow(loads.approach[k], 1.5)), 1.0, 1e-13);
      }
    }
}

TEST(Analyze, PressuresFollowFromGeometryAlsoWithOverrides) {
  // Table 2's constants replace k_0 in the load distribution only.
  const Result with = analyze(lesson("01_config_1_to_3.yaml"));
  const Result without = analyze(lesson("04_contacts_from_geometry.yaml"));
  for (const Interface i : kInterfaces) {
    const auto pressure_per_cbrt = [&](const Result& r) {
      const InterfaceLoads& loads = (*r.load_cases[0].threads)[i];
      return loads.peak_pressure[0] / std::cbrt(loads.normal_load[0]);
    };
    EXPECT_NEAR(pressure_per_cbrt(with) / pressure_per_cbrt(without), 1.0, 1e-14);
    EXPECT_EQ((*with.load_cases[0].threads).screw.hertz_constant, 3.6062e5 * std::pow(1e3, 1.5));
    EXPECT_EQ((*without.load_cases[0].threads)[i].hertz_constant, without.contacts.interfaces[i].hertz.hertz_constant);
  }
}

TEST(Analyze, PressureTimesEllipseIsTheNormalLoad) {
  const Result result = analyze(lesson("05_standard_screw.yaml"));
  for (const LoadCaseResult& r : result.load_cases)
    for (const Interface i : kInterfaces) {
      const InterfaceLoads& l = (*r.threads)[i];
      for (std::size_t k = 0; k < l.normal_load.size(); ++k)
        EXPECT_NEAR(2.0 / 3.0 * M_PI * l.semi_major[k] * l.semi_minor[k] * l.peak_pressure[k] / l.normal_load[k], 1.0,
                    1e-13);
    }
}

TEST(Analyze, ACaseDoesNotDependOnItsNeighbours) {
  const Result all = analyze(lesson("03_load_sweep.yaml"));
  Case alone = lesson("03_load_sweep.yaml");
  const LoadCase last = alone.load_cases.back();
  alone.load_cases = {last};
  const LoadCaseResult a = all.load_cases.back(), b = analyze(alone).load_cases.front();
  EXPECT_EQ(a.load_case.name, b.load_case.name);
  EXPECT_EQ(a.axial_displacement, b.axial_displacement);
  EXPECT_EQ(a.threads->screw.normal_load, b.threads->screw.normal_load);
  EXPECT_EQ(a.solve->iterations(), b.solve->iterations());
}

TEST(Analyze, EqualSharesAreForceOverRollersAndContacts) {
  Case c = lesson("04_contacts_from_geometry.yaml");
  LoadCase equal;
  equal.name = "equal";
  equal.axial_force = -33e3;
  equal.share = LoadCase::Share::equal;
  c.load_cases = {equal};
  c.structure.reset();
  const LoadCaseResult r = analyze(c).load_cases.front();
  EXPECT_TRUE(r.converged());
  EXPECT_FALSE(r.axial_displacement);
  for (const Interface i : kInterfaces) {
    ASSERT_EQ((*r.threads)[i].axial_load.size(), 20u);
    for (const double load : (*r.threads)[i].axial_load) EXPECT_NEAR(load, 33e3 / 220, 1e-10);
  }
}

TEST(Analyze, DesignedMechanismIsSolvedAsTheSameOneGivenByItsRadii) {
  const std::vector<std::string> design{"mechanism.geometry=design", "mechanism.backlash={}"};
  Case c = lesson("04_contacts_from_geometry.yaml");
  c.mechanism.geometry = Mechanism::Geometry::design;
  c.mechanism.pitch_diameter.roller.reset();
  c.mechanism.pitch_diameter.nut.reset();
  c.mechanism.centre_distance.reset();
  c.mechanism.backlash = {20e-6, 30e-6};
  const Result designed = analyze(c);
  for (const Interface i : kInterfaces)
    EXPECT_NEAR(designed.contacts.interfaces[i].geometry.point.backlash, c.mechanism.backlash[i], 1e-12);

  Case given = c;
  given.mechanism = designed.contacts.mechanism;
  given.mechanism.geometry = Mechanism::Geometry::simulation;
  const Result simulated = analyze(given);
  EXPECT_EQ(designed.load_cases[0].axial_displacement, simulated.load_cases[0].axial_displacement);
}

TEST(Analyze, DesignThatDoesNotFitTheNutIsAnErrorOfTheCase) {
  Case c = lesson("04_contacts_from_geometry.yaml");
  c.mechanism.geometry = Mechanism::Geometry::design;
  c.mechanism.pitch_diameter = {40e-3, {}, {}};
  c.mechanism.centre_distance.reset();
  EXPECT_THROW(analyze(c), CaseError);
}

/// Sandu 2018, (1.47): with crests where the flanks meet 11 rollers, with crests of 5.15 mm, below 20 mm sin(15
/// deg), 12.
TEST(Analyze, RollersThatOverlapAtTheirCrestsAreAnErrorOfTheCase) {
  Case c = test::sandu_reference();
  c.mechanism.rollers = 11;
  EXPECT_NO_THROW(checked_contacts(c, Detail::numbers));
  c.mechanism.rollers = 12;
  try {
    checked_contacts(c, Detail::numbers);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.path(), "mechanism.rollers");
    EXPECT_THAT(error.what(), ::testing::HasSubstr("got 12; expected at most 11"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("mechanism.thread.roller"));
  }
  EXPECT_THROW(checked_mechanism(c), CaseError);  // Function used for studies.
  c.mechanism.thread.roller = ThreadHeight{0.15e-3, 0.4e-3};
  EXPECT_NO_THROW(checked_contacts(c, Detail::numbers));
  EXPECT_NO_THROW(checked_mechanism(c));
}

/// Contact points, surface origins (1.41) to (1.44) and ellipses: z of a point on both surfaces, and t_1 in the
/// tangent plane, between the first directions at the screw (1.62).
TEST(Analyze, PlacesAndDirectionsOfContactsFitTogether) {
  for (const Case& c : {test::sandu_reference(), test::inverted(test::sandu_reference())}) {
    const Contacts contacts = find_contacts(c.mechanism, c.materials);
    for (const Interface i : kInterfaces) {
      const auto json = object_of(ContactAt{&contacts, i});
      const contact::InterfaceGeometry& g = contacts.interfaces[i].geometry;
      const contact::ThreadSurface body = pair_of(contacts.threads, i).body;
      // Screw bottom and nut top, which is the bottom of the air in the nut.
      const double on_body = body.profile(g.point.radius_on_body).height + body.reduced_lead * g.point.angle_on_body;
      const std::vector<double> position = json.at("position_mm");
      EXPECT_NEAR(position[2], on_body * 1e3 + json.at("origin_height_tension_mm").get<double>(), 1e-9);
      EXPECT_NEAR(std::hypot(position[0], position[1]), json.at("radius_on_body_mm"), 1e-12);
      const double play =
          i == Interface::screw ? json.at("backlash_mm").get<double>() : -json.at("backlash_mm").get<double>();
      EXPECT_NEAR(
          json.at("origin_height_compression_mm").get<double>() - json.at("origin_height_tension_mm").get<double>(),
          play, 1e-12);
      const std::vector<double> axis = json.at("major_axis"), normal = json.at("normal");
      EXPECT_NEAR(axis[0] * normal[0] + axis[1] * normal[1] + axis[2] * normal[2], 0.0, 1e-14);
      EXPECT_NEAR(std::hypot(axis[0], axis[1], axis[2]), 1.0, 1e-14);
      if (i == Interface::screw) {
        EXPECT_NEAR(
            json.at("major_axis_from_body_deg").get<double>() + json.at("major_axis_from_roller_deg").get<double>(),
            json.at("first_directions_angle_deg"), 1e-9);
      }
    }
  }
}

TEST(Analyze, ThreadsWithoutPointContactNeedBothOverrides) {
  Case c = lesson("01_config_1_to_3.yaml");
  c.mechanism.profile.roller = {};
  const Result result = analyze(c);
  EXPECT_EQ(result.warnings.size(), 2u);
  EXPECT_TRUE(result.load_cases[0].threads->screw.peak_pressure.empty());
  EXPECT_FALSE(result.contacts.interfaces.screw.has_hertz());

  c.contact.normal_angle.nut.reset();
  try {
    analyze(c);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.path(), "mechanism.profile");
    EXPECT_NE(std::string(error.what()).find("roller-nut"), std::string::npos) << error.what();
  }
}

TEST(Analyze, ContactBeyondATruncatedFlankNamesPartEndAndDistance) {
  Case c = lesson("04_contacts_from_geometry.yaml");
  c.mechanism.thread.nut = ThreadHeight{0.02e-3, 0.2e-3};  // the contact lies at 17.4615 mm
  try {
    analyze_contacts(c);
    FAIL();
  } catch (const CaseError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("roller-nut"), std::string::npos) << message;
    EXPECT_NE(message.find("0.0185 mm beyond the crest of the nut"), std::string::npos) << message;
  }
}

TEST(Analyze, ImpossibleThreadsAreAnErrorUnlessTheContactIsGiven) {
  Case c = lesson("01_config_1_to_3.yaml");
  c.mechanism.thread.roller = ThreadHeight{0.5e-3, 6e-3};  // deeper than the roller's radius
  const Result result = analyze(c);
  EXPECT_TRUE(result.load_cases[0].converged());
  EXPECT_TRUE(result.load_cases[0].threads->nut.peak_pressure.empty());
  c.contact = {};
  try {
    analyze(c);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.path(), "mechanism.thread.roller");
    EXPECT_NE(std::string(error.what()).find("from -2.5000 to 4.0000 mm"), std::string::npos) << error.what();
  }
}

TEST(Analyze, FlanksThatNeverMeetSayHowFarTheyAre) {
  Case c = lesson("04_contacts_from_geometry.yaml");
  c.mechanism.thread.nut = ThreadHeight{0.2e-3, 0.2e-3};
  c.mechanism.thread.roller = ThreadHeight{0.05e-3, 0.3e-3};
  c.mechanism.pitch_diameter.nut = 35.6e-3;
  try {
    analyze_contacts(c);
    FAIL();
  } catch (const CaseError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("miss each other by 0.0500 mm"), std::string::npos) << message;
  }
}

TEST(Analyze, EllipsesThatPassTheFlankAreWarnedOf) {
  Case c = lesson("04_contacts_from_geometry.yaml");
  EXPECT_TRUE(analyze(c).load_cases[0].warnings.empty());
  c.mechanism.thread.roller = ThreadHeight{0.12e-3, 0.3e-3};
  const std::vector<std::string> warnings = sentences(analyze(c).load_cases[0].warnings);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("ellipse reaches"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("crest of the roller"), std::string::npos) << warnings[0];
}

TEST(Analyze, AbeviContactsAreThoseOfASecondComputation) {
  const PerInterface<InterfaceContact> contacts = analyze(lesson("04_contacts_from_geometry.yaml")).contacts.interfaces;
  const double per_m = std::pow(1e3, 1.5), degree = M_PI / 180;
  const PerInterface<std::pair<double, double>> printed = {{318655, 45.1636}, {361611, 45.0592}};
  for (const Interface i : kInterfaces) {
    const bool screw = i == Interface::screw;
    const auto k = static_cast<double>(plain::abevi_hertz_constant(screw));
    const auto angle = static_cast<double>(plain::abevi_touch(screw).normal_angle);
    EXPECT_NEAR(contacts[i].hertz.hertz_constant / k, 1.0, 1e-12);
    EXPECT_NEAR(contacts[i].normal_angle() / angle, 1.0, 1e-13);
    // Numbers quoted by validation, lesson 4 and the documents.
    EXPECT_EQ(std::round(k / per_m), printed[i].first);
    EXPECT_NEAR(angle / degree, printed[i].second, 5e-5);
  }
  EXPECT_NEAR(contacts.nut.geometry.point.backlash, -0.064e-3, 5e-7);
}

TEST(Analyze, ContactNeedsNoMaterialsAndThenHasNoHertz) {
  Case c = lesson("04_contacts_from_geometry.yaml");
  c.materials.reset();
  LoadCase equal;
  equal.name = "equal";
  equal.axial_force = 11e3;
  equal.share = LoadCase::Share::equal;
  c.load_cases.push_back(equal);
  const Result result = analyze_contacts(c);
  ASSERT_EQ(result.load_cases.size(), 1u);  // those to be solved are left out
  const InterfaceLoads& screw = result.load_cases[0].threads->screw;
  EXPECT_NEAR(screw.axial_load[7], 50.0, 1e-12);
  EXPECT_TRUE(screw.peak_pressure.empty());
  EXPECT_TRUE(screw.approach.empty());
  EXPECT_FALSE(screw.hertz_constant);
  EXPECT_FALSE(result.contacts.interfaces.nut.has_hertz());
}

TEST(Analyze, WarnsOfPressuresBeyondTheStaticLimit) {
  const Result result = analyze(lesson("01_config_1_to_3.yaml"));
  EXPECT_TRUE(result.load_cases[0].warnings.empty());
  ASSERT_EQ(result.load_cases[3].warnings.size(), 1u);
  EXPECT_THAT(sentence(result.load_cases[3].warnings[0]), ::testing::HasSubstr("4.04 GPa"));
}

/// A body yields when pushed.
TEST(Analyze, ScrewsTooSoftForTheEffectOfPoissonsRatioHaveNoStiffness) {
  const auto pushed = [](const char* modulus, const char* poisson) {
    return analyze(lesson("01_config_1_to_3.yaml",
                          {"model={bodies: refined, refined: {poisson: " + std::string(poisson) + "}}",
                           "materials={screw: {youngs_modulus: " + std::string(modulus) +
                               ", poisson_ratio: 0.4}, roller: {youngs_modulus: 209 GPa, "
                               "poisson_ratio: 0.3}, nut: {youngs_modulus: 209 GPa, "
                               "poisson_ratio: 0.3}}",
                           "structure.screw.free_length=0 mm", "load_cases[5].axial_force=1 kN"}))
        .load_cases[5];
  };
  const LoadCaseResult steel = pushed("209 GPa", "true"), soft = pushed("1 MPa", "true"),
                       without = pushed("1 MPa", "false");
  EXPECT_GT(*steel.axial_displacement, 0.0);
  EXPECT_GT(*without.axial_displacement, 0.0);
  EXPECT_THAT(sentences(steel.warnings), ::testing::IsEmpty());
  ASSERT_TRUE(soft.converged());
  EXPECT_FALSE(soft.axial_displacement || soft.axial_stiffness || soft.tangent_stiffness);
  EXPECT_THAT(sentences(soft.warnings), ::testing::Contains(::testing::StartsWith("model.refined.poisson: ")));
}

/// 1e-5 mm of interference is more than rounding and reads as a number: with flanks of 45 deg in
/// the normal plane the play falls by 2/cos(beta) times the centre distance, beta 4.33 deg.
TEST(Contacts, ASmallInterferenceIsToldInItsOwnDigits) {
  Case c = lesson("01_config_1_to_3.yaml");
  c.mechanism.centre_distance = *c.mechanism.centre_distance - 0.5e-8;
  const auto contacts = find_contacts(c.mechanism, c.materials);
  EXPECT_THAT(sentences(contacts.warnings), ::testing::Contains(::testing::HasSubstr("backlash -1e-05 mm")));
}

}  // namespace
}  // namespace prs
