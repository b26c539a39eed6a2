#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "prs/bodies/body_models.h"
#include "prs/input/reader.h"
#include "prs/input/source.h"
#include "prs/loads/analyze.h"
#include "prs/loads/full_result.h"
#include "prs/loads/load_analysis.h"
#include "prs/mechanism/full_structure.h"
#include "prs/mechanism/linearised.h"
#include "prs/mechanism/modes.h"
#include "support/count.h"
#include "support/full_mechanism.h"

namespace prs {
namespace {

using nlohmann::json;
using std::numbers::pi;
using testing::Contains;
using testing::HasSubstr;

/// Solved cases of an independent program, 12 digits.
const json& motion_cases() {
  static const json cases = json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/mechanism/motion_cases.json"));
  return cases;
}
json input_of(std::size_t k) { return motion_cases().at("cases").at(k).at("input"); }

Case motion_case(const json& input) { return input::read_case_text(input.dump(), "case", {}, Command::solve); }

/// Five rollers of a standard and of an inverted screw, nothing fixed in space except the axial force.
Case screw(Mechanism::Type type) {
  const bool standard = type == Mechanism::Type::standard;
  Case c = motion_case(input_of(standard ? 1 : 0));
  c.structure->screw.bearings.clear();
  c.load_cases[0].spatial = {};
  c.load_cases[0].modes.reset();
  c.load_cases[0].travel = Travel{};
  c.load_cases[0].travel->steps = 12;
  c.deviations.turning = {};
  return c;
}
constexpr Mechanism::Type kTypes[] = {Mechanism::Type::standard, Mechanism::Type::inverted};

LoadCaseResult first_result(const Case& c) { return analyze(c).load_cases.at(0); }

TravelResult travel_of(const Case& c) {
  const LoadCaseResult result = first_result(c);
  EXPECT_TRUE(result.full && result.full->travel && result.full->travel->converged());
  return result.full && result.full->travel ? *result.full->travel : TravelResult{};
}
ModesResult modes_of(const Case& c) {
  const LoadCaseResult result = first_result(c);
  EXPECT_TRUE(result.full && result.full->modes);
  return result.full && result.full->modes ? *result.full->modes : ModesResult{};
}

void expect_same(const std::vector<double>& a, const std::vector<double>& b, double error) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], error) << k;
}

void expect_same(const TravelResult& a, const TravelResult& b) {
  expect_same(a.displacement, b.displacement, 1e-14);
  expect_same(a.tangent_stiffness, b.tangent_stiffness, 1e-6 * a.tangent_stiffness[0]);
  for (const Interface i : kInterfaces) EXPECT_LT(test::largest_difference(a.loads[i].mean, b.loads[i].mean), 1e-6);
}

/// Errors of every kind.
void add_errors(Case& c, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto angle = [&] { return pi * any(random); };
  for (const Interface i : kInterfaces) {
    TurningThread& t = c.deviations.turning.thread[i];
    t.eccentricity = {4e-6 * any(random), angle()};
    t.wobble = {1e-4 * any(random), angle()};
    t.harmonics = {{1, 2e-6 * any(random), angle()}, {3, 1e-6 * any(random), angle()}};
  }
  TurningRollers& r = c.deviations.turning.rollers;
  for (int j = 0; j < c.mechanism.rollers; ++j) {
    r.eccentricity.amount.many.push_back(2e-6 * any(random));
    r.eccentricity.angle.many.push_back(angle());
    r.wobble.amount.many.push_back(1e-4 * any(random));
    r.wobble.angle.many.push_back(angle());
  }
  r.harmonics = {{2, {1e-6, {}}, {angle(), {}}}};
}

/// Calls `visit(path, number, other)` for every number of `wanted`; paths have no indices.
void for_each_number(const json& wanted, const json& got, const std::string& path,
                     const std::function<void(const std::string&, double, double)>& visit) {
  if (wanted.is_object()) {
    for (const auto& [key, value] : wanted.items()) {
      ASSERT_TRUE(got.contains(key)) << path << "." << key;
      for_each_number(value, got.at(key), path + "." + key, visit);
    }
  } else if (wanted.is_array()) {
    ASSERT_EQ(wanted.size(), got.size()) << path;
    for (std::size_t i = 0; i < wanted.size(); ++i) for_each_number(wanted[i], got[i], path + "[]", visit);
  } else if (wanted.is_number_float()) {
    visit(path, wanted.get<double>(), got.get<double>());
  } else {
    EXPECT_EQ(wanted, got) << path;
  }
}

/// Compares within a share of the largest number under the same path.
void expect_agreement(const json& wanted, const json& got, double share) {
  std::map<std::string, double> largest;
  for_each_number(wanted, got, "", [&](const std::string& path, double value, double) {
    largest[path] = std::max(largest[path], std::abs(value));
  });
  for_each_number(wanted, got, "", [&](const std::string& path, double value, double other) {
    EXPECT_NEAR(other, value, share * largest[path] + 1e-8) << path;
  });
}

TEST(Motion, AgreesWithAnIndependentProgram) {
  for (const json& one : motion_cases().at("cases")) {
    SCOPED_TRACE(one.at("name").get<std::string>());
    const Result result = analyze(motion_case(one.at("input")));
    const json document = json::parse(load_case_json(result, 0)->dump());
    expect_agreement(one.at("result"), document, 1e-8);
  }
}

TEST(Motion, WrongInputIsRefusedAndAPositionWithoutEquilibriumTold) {
  for (const json& one : motion_cases().at("errors")) {
    SCOPED_TRACE(one.at("name").get<std::string>());
    if (one.at("status") == 2) {
      EXPECT_THROW(motion_case(one.at("input")), input::InputError);
      continue;
    }
    const Result result = analyze(motion_case(one.at("input")));
    EXPECT_FALSE(all_converged(result));
    const LoadCaseResult& r = result.load_cases[0];
    EXPECT_TRUE(r.converged());
    EXPECT_NEAR(r.full->travel->failure->angle, pi / 4.0, 1e-12);
    EXPECT_EQ(r.full->travel->failure->status, fe::NewtonStatus::no_equilibrium);
    EXPECT_THAT(sentences(r.warnings), Contains(HasSubstr("the travel ends at 45 deg")));
  }
}

TEST(Motion, WrongInputIsTold) {
  const auto message = [](const std::function<void(json&)>& change) {
    json input = input_of(5);
    change(input);
    try {
      motion_case(input);
    } catch (const input::InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  const auto screw_of = [](json& in) -> json& { return in["deviations"]["turning"]["screw"]; };
  EXPECT_THAT(message([](json& in) { in["load_cases"][0]["travel"]["slip_ratio"] = 1.5; }),
              HasSubstr("travel.slip_ratio"));
  EXPECT_THAT(message([](json& in) { in["load_cases"][0]["travel"]["slip_ratio"] = "solved"; }),
              HasSubstr("law of friction"));
  EXPECT_THAT(message([](json& in) { in["load_cases"][0]["travel"]["turning_part"] = "roller"; }),
              HasSubstr("turning_part"));
  EXPECT_THAT(message([&](json& in) { screw_of(in)["eccentricity"]["amount"] = 5; }), HasSubstr("a length"));
  EXPECT_THAT(message([&](json& in) {
                screw_of(in)["lead"]["waves"] = {{{"length", "0 mm"}}};
              }),
              HasSubstr("lead.waves[0].length"));
  EXPECT_THAT(message([&](json& in) {
                screw_of(in)["lead"]["harmonics"] = {{{"order", 0}, {"amplitude", "1 um"}}};
              }),
              HasSubstr("lead.harmonics[0].order"));
  const auto measured = [&](json at, json deviation) {
    return message([&](json& in) {
      screw_of(in)["lead"]["measured"] = {{"at", std::move(at)}, {"deviation", std::move(deviation)}};
    });
  };
  EXPECT_THAT(measured({"-90 mm", "90 mm"}, {"1 um"}), HasSubstr("measured.deviation"));
  EXPECT_THAT(measured({"-90 mm"}, {"1 um"}), HasSubstr("measured.at"));
  EXPECT_THAT(measured({"90 mm", "-90 mm"}, {"1 um", "0 um"}), HasSubstr("places that rise"));
  EXPECT_THAT(measured({"-1 mm", "90 mm"}, {"1 um", "0 um"}),
              HasSubstr("the whole thread that comes into contact, -10 mm to "));
  EXPECT_THAT(message([](json& in) {
                in["deviations"]["turning"]["roller"]["eccentricity"]["amount"] = {"1 um", "2 um"};
              }),
              HasSubstr("one for each roller"));
  EXPECT_THAT(message([](json& in) { in["materials"].erase("density"); }), HasSubstr("density"));
  EXPECT_THAT(message([](json& in) { in["load_cases"][0]["modes"]["count"] = 0; }), HasSubstr("modes.count"));
  EXPECT_THAT(message([](json& in) { in["load_cases"][0]["modes"]["positions"] = 13; }), HasSubstr("modes.positions"));
  EXPECT_THAT(message([](json& in) { in["load_cases"][0].erase("travel"); }), HasSubstr("modes.positions"));
  EXPECT_THAT(message([](json& in) { in["structure"]["masses"][0]["mass"] = "0 kg"; }), HasSubstr("no inertia"));
  EXPECT_THAT(message([](json& in) { in["structure"]["masses"][0]["position"] = "41 mm"; }),
              HasSubstr("a place on the nut"));
  EXPECT_THAT(message([](json& in) { in["structure"]["screw"]["drive"]["position"] = "-1 m"; }),
              HasSubstr("a place on the screw"));
  EXPECT_THAT(message([](json& in) { in["structure"]["screw"]["drive"]["stiffness"] = "0 N m/rad"; }),
              HasSubstr("drive.stiffness"));
  EXPECT_THAT(message([](json& in) {
                in["load_cases"][0]["modes"]["axial_support"] = {{"screw", "0 N/mm"}};
              }),
              HasSubstr("axial_support.screw"));
  EXPECT_THAT(message([](json& in) { in["model"]["bodies"] = "refined"; }), HasSubstr("modes"));
}

TEST(Motion, WithoutErrorsAllPositionsAreAlike) {
  for (const Mechanism::Type type : kTypes) {
    const TravelResult t = travel_of(screw(type));
    for (const double d : t.deviation()) EXPECT_NEAR(d, 0.0, 1e-15);
    for (const Interface i : kInterfaces)
      for (const std::vector<double>& roller : t.loads[i].ripple)
        for (const double ripple : roller) EXPECT_LT(ripple, 1e-8 * t.loads[i].largest);
  }
}

TEST(Motion, FullTurnsOfAnglesAndPhasesChangeNothing) {
  for (const Mechanism::Type type : kTypes) {
    Case c = screw(type);
    add_errors(c, 1);
    const TravelResult before = travel_of(c);
    for (const Interface i : kInterfaces) {
      TurningThread& t = c.deviations.turning.thread[i];
      t.eccentricity.angle += 2.0 * pi;
      t.wobble.angle -= 2.0 * pi;
      for (LeadHarmonic& h : t.harmonics) h.phase += 2.0 * pi;
    }
    for (double& angle : c.deviations.turning.rollers.eccentricity.angle.many) angle += 2.0 * pi;
    c.load_cases[0].spatial.carrier_angle += 2.0 * pi * c.mechanism.starts.roller;
    expect_same(before, travel_of(c));
  }
}

TEST(Motion, ATurningNutIsATurningScrewWhereNothingIsFixedInSpace) {
  for (const Mechanism::Type type : kTypes) {
    Case c = screw(type);
    add_errors(c, 2);
    c.load_cases[0].travel->turns = -2;
    const TravelResult screw_turns = travel_of(c);
    c.load_cases[0].travel->part = Travel::Part::nut;
    expect_same(screw_turns, travel_of(c));
  }
}

TEST(Motion, TurnsWithEverything) {
  constexpr double kAngle = 0.7;
  for (const Mechanism::Type type : kTypes) {
    Case c = screw(type);
    add_errors(c, 3);
    c.load_cases[0].spatial.eccentricity = {0.3e-3, -0.1e-3};
    c.load_cases[0].spatial.moment.value = {0.5, 1.0};
    const TravelResult before = travel_of(c);
    SpatialLoad& load = c.load_cases[0].spatial;
    load.carrier_angle += kAngle;
    load.eccentricity = test::turned(load.eccentricity, kAngle);
    load.moment.value = test::turned(load.moment.value, kAngle);
    for (const Interface i : kInterfaces) {
      TurningThread& t = c.deviations.turning.thread[i];
      t.eccentricity.angle += kAngle;
      t.wobble.angle += kAngle;
      for (LeadHarmonic& h : t.harmonics) h.phase -= h.order * kAngle;
    }
    const double spin = (type == Mechanism::Type::standard ? -1.0 : 1.0) * c.mechanism.starts.screw /
                        c.mechanism.starts.roller * kAngle;
    TurningRollers& r = c.deviations.turning.rollers;
    for (double& angle : r.eccentricity.angle.many) angle -= spin;
    for (double& angle : r.wobble.angle.many) angle -= spin;
    for (TurningRollers::Harmonic& h : r.harmonics) h.phase.one += h.order * spin;
    const TravelResult after = travel_of(c);
    expect_same(before, after);
    for (std::size_t k = 0; k < before.end_rotation.size(); ++k) {
      const Lateral wanted = test::turned(before.end_rotation[k], kAngle);
      EXPECT_NEAR(after.end_rotation[k].y, wanted.y, 1e-11);
      EXPECT_NEAR(after.end_rotation[k].z, wanted.z, 1e-11);
    }
  }
}

TEST(Motion, TwoTinyErrorsAddUp) {
  Case c = screw(Mechanism::Type::standard);
  c.deviations.missing_rollers = {2};
  const auto with = [&](double eccentricity, double harmonic) {
    c.deviations.turning.thread.screw.eccentricity = {eccentricity, 0.4};
    c.deviations.turning.thread.nut.harmonics = {{2, harmonic, 0.1}};
    return travel_of(c).displacement;
  };
  const std::vector<double> none = with(0.0, 0.0), first = with(1e-10, 0.0), second = with(0.0, 1e-10),
                            both = with(1e-10, 1e-10);
  for (std::size_t k = 0; k < none.size(); ++k)
    EXPECT_NEAR(both[k] - none[k], first[k] + second[k] - 2.0 * none[k], 1e-14);
}

void expect_positions_to_be_static_cases(const Case& c) {
  const TravelResult t = travel_of(c);
  for (const int position : {1, 7}) {
    Case there = c;
    there.load_cases[0].travel->from = t.travel.angle(position);
    const LoadCaseResult r = first_result(there);
    const auto at = static_cast<std::size_t>(position);
    EXPECT_NEAR(t.tangent_stiffness[at], *r.tangent_stiffness, 1e-7 * *r.tangent_stiffness);
    EXPECT_NEAR((t.nut.force[at] - r.full->nut.force).norm(), 0.0, 1e-5);
    EXPECT_NEAR(t.end_rotation[at].y, r.full->screw_end.displacement[3], 1e-11);
    EXPECT_NEAR(t.displacement[at], r.full->travel->displacement[0], 1e-13);
  }
}

TEST(Motion, APositionIsTheStaticCaseThere) {
  for (const std::size_t k : {0, 3}) expect_positions_to_be_static_cases(motion_case(input_of(k)));
}

TEST(Motion, APositionIsTheStaticCaseThereOnOtherBodies) {
  for (const auto bodies : {&kRefined, &kInfluence}) {
    if (bodies == &kInfluence && !test::thorough()) continue;
    Case c = screw(Mechanism::Type::standard);
    c.model.bodies = bodies;
    add_errors(c, 5);
    expect_positions_to_be_static_cases(c);
  }
}

TEST(Motion, ALeadErrorRisesWithTheTravelAndDoesNotVary) {
  for (const Mechanism::Type type : kTypes)
    for (const int turns : {2, -2}) {
      Case c = screw(type);
      c.load_cases[0].travel->turns = turns;
      // The rollers stay in place on the other part.
      const Interface i = type == Mechanism::Type::standard ? Interface::screw : Interface::nut;
      c.deviations.turning.thread[i].per_300_mm = 30e-6;
      const TravelResult t = travel_of(c);
      const double travel = std::abs(turns * c.mechanism.lead);
      EXPECT_NEAR(t.bands.mean, 1e-4 * travel, 1e-13);
      EXPECT_NEAR(t.bands.variation, 0.0, 1e-13);
      EXPECT_NEAR(t.bands.variation_one_turn, 0.0, 1e-13);
    }
}

/// Makes all parts so stiff that only contacts deform.
void make_rigid(Case& c) {
  for (const Part p : kParts) (*c.materials)[p].youngs_modulus = 2e16;
}

TEST(Motion, RigidPartsWithOneEccentricityHaveAClosedForm) {
  Case c = screw(Mechanism::Type::inverted);
  make_rigid(c);
  c.structure->roller.rings = {Rings::Carrier::housing, kRigid};
  c.structure->screw.bearings = {{.position = 5e-3, .tilt = kRigid, .offset = {}, .angle = {}}};
  c.structure->screw.free_length = 40e-3;
  const TurningError error{8e-6, 0.3};
  c.deviations.turning.thread.screw.eccentricity = error;
  const TravelResult t = travel_of(c);
  const double threads = c.mechanism.contacts_per_roller;
  double compliance = 0.0;
  for (const Interface i : kInterfaces) {
    const double cosine = std::cos(*c.contact.normal_angle[i]);
    compliance += std::pow(threads * cosine * *c.contact.hertz_constant[i], -2.0 / 3.0) / cosine;
  }
  const double epsilon = slip_ratio(c.mechanism, t.travel);
  const double s = -1.0;  // Tension.
  for (std::size_t k = 0; k < t.angle.size(); ++k) {
    const auto force = [&](double u) {
      double sum = 0.0;
      for (int j = 0; j < c.mechanism.rollers; ++j) {
        const double on_screw = 2.0 * pi * j / c.mechanism.rollers + (epsilon - 1.0) * t.angle[k];
        const double h = -std::tan(*c.contact.normal_angle.screw) * error.amount * std::cos(on_screw - error.angle);
        sum += std::pow(std::max(u - h, 0.0) / compliance, 1.5);
      }
      return sum;
    };
    double low = 0.0, high = 1e-3;
    for (int halving = 0; halving < 100; ++halving) {
      const double middle = 0.5 * (low + high);
      (force(middle) < c.load_cases[0].axial_force ? low : high) = middle;
    }
    EXPECT_NEAR(s * t.displacement[k], low, 2e-4 * low) << k;
  }
}

TEST(Motion, AFreeScrewTakesEccentricityAndWobbleWithoutEffect) {
  Case c = screw(Mechanism::Type::standard);
  c.deviations.turning.thread.screw.eccentricity = {5e-6, 0.3};
  c.deviations.turning.thread.screw.wobble = {1e-4, 1.3};
  for (const double d : travel_of(c).deviation()) EXPECT_NEAR(d, 0.0, 1e-13);
}

TEST(Motion, EqualRollersLetMultiplesOfTheirNumberThroughAtFullHeight) {
  Case c = screw(Mechanism::Type::standard);
  c.load_cases[0].travel->turns = 8;
  c.load_cases[0].travel->steps = 24;
  c.deviations.turning.thread.screw.harmonics = {{5, 1e-9, 0.2}, {2, 1e-9, 0.1}};
  const TravelResult t = travel_of(c);
  const double order = 5.0 * (1.0 - t.slip_ratio);
  for (const OrderAmplitude& o : t.spectrum)
    EXPECT_NEAR(o.amplitude, std::abs(o.order - order) < 1e-9 ? 1e-9 : 0.0, 2e-12) << o.order;
}

TEST(Motion, RepeatsAfterTheTurnsOfItsGears) {
  Mechanism m = screw(Mechanism::Type::standard).mechanism;
  for (const int starts : {3, 4, 5, 6}) {
    m.starts.screw = starts;
    m.type = Mechanism::Type::standard;
    EXPECT_EQ(turns_until_repeat(m, (starts - 2.0) / (2.0 * starts - 2.0)),
              (2 * starts - 2) / std::gcd(2 * starts - 2, starts - 2));
    m.type = Mechanism::Type::inverted;
    EXPECT_EQ(turns_until_repeat(m, starts / (2.0 * starts + 2.0)),
              (2 * starts + 2) / std::gcd(2 * starts + 2, starts));
  }
  EXPECT_EQ(turns_until_repeat(m, 1.0 / pi), std::nullopt);
}

TEST(Motion, BandsAreThoseOfEveryWindow) {
  std::mt19937 random(4);
  std::normal_distribution<double> any;
  for (int sample = 0; sample < test::samples(20, 400); ++sample) {
    std::vector<double> d(50);
    for (std::size_t k = 0; k < d.size(); ++k) d[k] = any(random) + 0.3 * static_cast<double>(k);
    const TravelBands bands = travel_bands(d, -1.0, 7, 12);
    const auto widest = [&](std::size_t steps) {
      double width = 0.0;
      for (std::size_t from = 0; from + steps < d.size(); ++from)
        for (std::size_t a = from; a <= from + steps; ++a)
          for (std::size_t b = from; b <= from + steps; ++b)
            width = std::max(width, (d[a] - bands.line[a]) - (d[b] - bands.line[b]));
      return width;
    };
    EXPECT_NEAR(bands.variation, widest(49), 1e-12);
    EXPECT_NEAR(bands.variation_one_turn, widest(7), 1e-12);
    EXPECT_NEAR(*bands.variation_300_mm, widest(12), 1e-12);
    EXPECT_NEAR(bands.mean, -(bands.line.back() - bands.line.front()), 1e-12);
  }
}

/// The screw of the case with masses, loaded centrally and without soft supports.
Case vibrating(Mechanism::Type type) {
  Case c = screw(type);
  c.load_cases[0].travel.reset();
  c.load_cases[0].modes = Modes{};
  c.structure->screw.free_length = 30e-3;
  return c;
}
void make_light(Case& c) {
  for (const Part p : kParts) (*c.materials)[p].density = 1e-3;
}
ExtraMass heavy(ExtraMass::Carrier carrier, double position) {
  ExtraMass m;
  m.carrier = carrier;
  m.position = position;
  m.mass = 1e6;
  return m;
}
double loaded_section(const Case& c) { return *c.load_cases[0].position - c.structure->screw.free_length; }

TEST(Motion, AHeavyMassSwingsOnTheTangentStiffness) {
  for (const Mechanism::Type type : kTypes) {
    Case c = vibrating(type);
    c.structure->screw.bearings = {{.position = loaded_section(c), .tilt = kRigid, .offset = {}, .angle = {}}};
    c.structure->masses = {heavy(ExtraMass::Carrier::screw, loaded_section(c))};
    const LoadCaseResult r = first_result(c);
    const double wanted = std::sqrt(*r.tangent_stiffness / 1e6) / (2.0 * pi);
    EXPECT_NEAR(r.full->modes->modes[0].frequency, wanted, 1e-6 * wanted);

    c.structure->masses = {heavy(ExtraMass::Carrier::nut, *c.structure->nut.thrust.tension)};
    c.load_cases[0].modes->axial_support.at = AxialSupport::At::screw;
    EXPECT_NEAR(modes_of(c).modes[0].frequency, wanted, 1e-6 * wanted);

    Drive drive;
    drive.position = loaded_section(c);
    drive.stiffness = 50.0;
    c.structure->screw.drive = drive;
    c.materials->screw.density = c.materials->roller.density = 1e-3;
    const double advance = c.mechanism.lead / (2.0 * pi);
    const double torsion = 2.0 * modes_of(c).modes[0].frequency * pi;
    c.structure->screw.drive->stiffness = kRigid;
    const double rigid = 2.0 * modes_of(c).modes[0].frequency * pi;
    EXPECT_NEAR(1.0 / (1e6 * torsion * torsion) - 1.0 / (1e6 * rigid * rigid), advance * advance / drive.stiffness,
                1e-5 * advance * advance / drive.stiffness);
  }
}

TEST(Motion, HeadlinesAreOfTheLowestModeAndTheFastestOrder) {
  Case c = vibrating(Mechanism::Type::standard);
  c.structure->masses = {heavy(ExtraMass::Carrier::screw, loaded_section(c))};
  const Result result = analyze(c);
  const Mode& lowest = result.load_cases.at(0).full->modes->modes.at(0);
  const std::vector<Headline> headlines = frequencies(result);
  ASSERT_EQ(headlines.size(), 2u);
  EXPECT_EQ(headlines[0].value, lowest.frequency);
  double most = 0.0;
  for (const MotionOrder& o : result.load_cases[0].full->modes->orders) most = std::max(most, o.order);
  EXPECT_DOUBLE_EQ(headlines[1].value * most, 2.0 * pi * lowest.frequency);  // [rad/s]
}

TEST(Motion, HeavyRollersTurnWithTheDrive) {
  for (const Mechanism::Type type : kTypes) {
    const bool standard = type == Mechanism::Type::standard;
    Case c = vibrating(type);
    make_light(c);
    c.materials->roller.density = 7.8e3;
    c.structure->screw.bearings = {{.position = loaded_section(c), .tilt = kRigid, .offset = {}, .angle = {}}};
    Drive drive;
    drive.position = loaded_section(c);
    drive.inertia = 1e-6;
    drive.stiffness = 1e-2;
    c.structure->screw.drive = drive;
    c.load_cases[0].modes->axial_support.at = AxialSupport::At::screw;
    const auto& d = c.mechanism.pitch_diameter;
    const double p = axial_pitch(c.mechanism);
    const auto cylinder = [&](double diameter, double length) {
      return 7.8e3 * pi / 4.0 * diameter * diameter * length;
    };
    const double threads = p * c.mechanism.contacts_per_roller;
    const Structure::Roller& roller = c.structure->roller;
    const double m_thread = cylinder(*d.roller, threads);
    const double m_ends = cylinder(roller.end_diameter, 2.0 * roller.end_length);
    const double mass = m_thread + m_ends;
    const double inertia =
        (m_thread * *d.roller * *d.roller + m_ends * roller.end_diameter * roller.end_diameter) / 8.0;
    const double epsilon = *d.screw / (*d.screw + *d.nut);
    const double gear = c.mechanism.starts.screw / c.mechanism.starts.roller;
    const double w = standard ? epsilon - gear * epsilon : epsilon + gear * (epsilon - 1.0);
    const double advance = c.mechanism.lead / (2.0 * pi);
    const double a = *c.mechanism.centre_distance;
    const double all = drive.inertia + c.mechanism.rollers * (mass * std::pow(epsilon * a, 2) + inertia * w * w +
                                                              (standard ? mass * advance * advance : 0.0));
    const double wanted = std::sqrt(drive.stiffness / all) / (2.0 * pi);
    EXPECT_NEAR(modes_of(c).modes[0].frequency, wanted, 1e-4 * wanted);
  }
}

TEST(Motion, MassesStandStillWhileTheCarrierTurns) {
  Case c = motion_case(input_of(4));
  c.load_cases[0].travel = Travel{};
  c.load_cases[0].travel->from = 0.9;
  const ModesResult turned = modes_of(c);
  c.load_cases[0].spatial.carrier_angle = 0.9 * slip_ratio(c.mechanism, Travel{});
  c.load_cases[0].travel.reset();
  const ModesResult stands = modes_of(c);
  for (std::size_t k = 0; k < stands.modes.size(); ++k)
    EXPECT_NEAR(turned.modes[k].frequency, stands.modes[k].frequency, 1e-8 * stands.modes[k].frequency);
}

TEST(Motion, ContactsAloneHaveFrequenciesLikeTheSixthRootOfTheForce) {
  Case c = vibrating(Mechanism::Type::inverted);
  make_rigid(c);
  c.structure->screw.bearings = {{.position = loaded_section(c), .tilt = kRigid, .offset = {}, .angle = {}}};
  const double before = modes_of(c).modes[0].frequency;
  c.load_cases[0].axial_force *= 64.0;
  EXPECT_NEAR(modes_of(c).modes[0].frequency, 2.0 * before, 1e-4 * before);
}

TEST(Motion, AllModesTogetherHaveTheMassAndEnergiesAddUp) {
  Case c = motion_case(input_of(4));
  c.structure->nut.housing = {1e7, 1e7, 1e4};
  c.structure->screw.bearings.clear();
  c.load_cases[0].modes->count = 10'000;
  c.mechanism.rollers = 4;
  c.mechanism.contacts_per_roller = 4;
  const ModesResult all = modes_of(c);
  ASSERT_GE(static_cast<int>(all.modes.size()), all.freedoms - 1);
  Eigen::Vector3d mass = Eigen::Vector3d::Zero();
  for (const Mode& m : all.modes) mass += m.effective_mass;
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(mass[i], all.mass[i], 1e-6 * all.mass[i]);
  for (std::size_t k = 0; k < 20; ++k) {
    const Mode& m = all.modes[k];
    EXPECT_NEAR(m.kinetic.screw + m.kinetic.nut + m.kinetic.roller + m.kinetic_of_masses, 1.0, 1e-12);
    EXPECT_NEAR(m.strain.screw + m.strain.nut + m.strain.roller + m.contact_strain.screw + m.contact_strain.nut +
                    m.support_strain + m.prestress,
                1.0, 1e-12);
  }
}

/// A long screw pinned at both ends, its nut on springs that do not matter.
Case long_screw(double length) {
  Case c = vibrating(Mechanism::Type::inverted);
  c.structure->screw.free_length = length;
  c.structure->screw.far_length = 5e-3;
  const double first = *c.load_cases[0].position;
  c.structure->screw.bearings = {{.position = first - length, .offset = {}, .angle = {}},
                                 {.position = first, .offset = {}, .angle = {}}};
  for (const Interface i : kInterfaces) c.contact.hertz_constant[i] = 1e4;  // [N/m^1.5]
  c.load_cases[0].modes->count = 4;
  return c;
}

TEST(Motion, APinnedScrewUnderAxialForceIsABeam) {
  constexpr double kLength = 1.5;
  Case c = long_screw(kLength);
  const Material& steel = c.materials->screw;
  const double outer = *c.mechanism.pitch_diameter.screw, inner = c.structure->screw.bore;
  const double area = pi / 4.0 * (outer * outer - inner * inner);
  const double inertia = pi / 64.0 * (std::pow(outer, 4) - std::pow(inner, 4));
  const double stiffness = steel.youngs_modulus * inertia * std::pow(pi / kLength, 2);
  for (const Direction direction : kDirections) {
    c.load_cases[0].direction = direction;
    c.load_cases[0].axial_force = 0.2 * stiffness;
    c.load_cases[0].modes->prestress = true;
    const double tension = (direction == Direction::tension ? 1.0 : -1.0) * 0.2;
    const double wanted = pi / (2.0 * kLength * kLength) *
                          std::sqrt(steel.youngs_modulus * inertia / (*steel.density * area)) *
                          std::sqrt(1.0 + tension);
    const std::vector<Mode> modes = modes_of(c).modes;
    const auto first =
        std::ranges::find_if(modes, [](const Mode& m) { return m.effective_mass[0] < 1e-3 && m.kinetic.screw > 0.9; });
    ASSERT_NE(first, modes.end());
    EXPECT_NEAR(first->frequency, wanted, 0.01 * wanted);
  }
  c.load_cases[0].direction = Direction::compression;
  c.load_cases[0].axial_force = 1.3 * stiffness;
  EXPECT_THAT(sentences(first_result(c).warnings), Contains(HasSubstr("the screw buckles")));
}

TEST(Motion, AFreeScrewIsAFreeBarAndBeam) {
  Case c = long_screw(1.5);
  const double threads = (c.mechanism.contacts_per_roller - 1) * c.mechanism.lead / c.mechanism.starts.screw;
  const double length = 1.5 + threads + c.structure->screw.far_length;
  c.structure->screw.bearings.clear();
  c.load_cases[0].axial_force = 1e-9;  // Contacts with almost no stiffness.
  c.load_cases[0].modes->count = 40;
  const Material& steel = c.materials->screw;
  const double outer = *c.mechanism.pitch_diameter.screw, inner = c.structure->screw.bore;
  const double radius_of_gyration = 0.25 * std::hypot(outer, inner);
  const double sound = std::sqrt(steel.youngs_modulus / *steel.density);
  const std::vector<Mode> modes = modes_of(c).modes;
  const auto nearest = [&](double wanted) {
    double found = 0.0;
    for (const Mode& m : modes)
      if (m.kinetic.screw > 0.9 && std::abs(m.frequency - wanted) < std::abs(found - wanted)) found = m.frequency;
    return found;
  };
  const double bar = sound / (2.0 * length);
  EXPECT_NEAR(nearest(bar), bar, 2e-4 * bar);
  // With rotary inertia, by the slope of the first mode: sigma k (sigma k + 6) = 49.481, k = 4.73004, sigma = 0.982502.
  const double slender = std::pow(radius_of_gyration / length, 2);
  const double beam =
      22.3733 / (2.0 * pi * length * length) * sound * radius_of_gyration / std::sqrt(1.0 + 49.481 * slender);
  EXPECT_NEAR(nearest(beam), beam, 2e-5 * beam);
}

TEST(Motion, NodesThatLieCloseAreExact) {
  for (const double distance : {1.1e-4, 1e-5}) {
    Case c = vibrating(Mechanism::Type::standard);
    c.structure->screw.bearings = {
        {.position = *c.load_cases[0].position + distance, .lateral = 1e7, .tilt = 1e4, .offset = {}, .angle = {}}};
    const Contacts contacts = find_contacts(c.mechanism, c.materials);
    const FullModel f = full_model(contacts.mechanism, *c.structure, *c.materials, c.model, contact_laws(c, contacts),
                                   c.load_cases[0], c.deviations);
    const FullDistribution d = solve(f);
    const auto compliance = [&](const FullStructure& s) {
      const fe::Equations equations(s.model);
      fe::NewtonSolver solver(equations, 0.0);
      const SpatialNode& end = s.screw[static_cast<std::size_t>(s.loaded)];
      const std::vector<Eigen::VectorXd> loads{equations.load_vector({{end.y_plane, fe::Dof::v, 1.0}})};
      std::vector<Eigen::VectorXd> rates;
      EXPECT_TRUE(solver.solve_linear(linearised(f, d).tangent, loads, rates));
      return loads[0].dot(rates[0]);
    };
    const double exact = compliance(full_structure(f));
    EXPECT_NEAR(compliance(full_structure(f, FullMesh{{}, {}, std::numeric_limits<double>::infinity()})), exact,
                1e-9 * exact);
  }
}

TEST(Motion, IdleRollersHaveNoPartInTheModes) {
  Case c = motion_case(input_of(4));
  c.load_cases[0].modes->count = 3;
  c.deviations.roller_diameters.assign(7, 0.0);
  c.deviations.roller_diameters[2] = -1e-4;
  c.load_cases[0].axial_force = 1e3;
  const LoadCaseResult r = first_result(c);
  EXPECT_EQ(r.full->modes->idle_rollers, std::vector<int>{3});
  EXPECT_EQ(r.full->modes->modes[0].axial[2], 0.0);
  EXPECT_THAT(sentences(r.warnings), Contains(HasSubstr("has no part in the modes")));
}

}  // namespace
}  // namespace prs
