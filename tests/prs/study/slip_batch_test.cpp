#include "prs/study/design_batches.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "prs/input/study_reader.h"
#include "prs/model/problems.h"
#include "prs/study/design_engine.h"
#include "prs/study/design_reader.h"
#include "tests/prs/input/abevi.h"
#include "tests/prs/study/memory_of_designs.h"
#include "tests/support/count.h"
#include "tests/support/slips.h"

// Slip of designs side by side, compared with the same designs one after the other.
namespace prs {
namespace {

/// Case of `test::random_slip`, some with mixed friction, plain bearings, wear, imposed slip ratios.
Case random_design(std::mt19937_64& random, int patch_points) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  Case c = test::random_slip(random);
  c.model.patch_points = patch_points;
  if (uniform(0.0, 1.0) < 0.3) c = test::with_mixed_friction(c, uniform(0.0, 0.2), 2.0);
  if (uniform(0.0, 1.0) < 0.3) c.roughness = PerPart<double>{0.3e-6, 0.4e-6, 0.2e-6};
  if (uniform(0.0, 1.0) < 0.3) {
    const double d = uniform(0.1, 0.3) * *c.mechanism.pitch_diameter.screw;
    c.carrier.bearing = HeadBearing{{uniform(0.3, 1.0) * d, d, 2e-3 * d}};
  }
  if (uniform(0.0, 1.0) < 0.3) c.lubricant->film.direction = contact::FilmDirection::rolling;
  if (uniform(0.0, 1.0) < 0.2) c.wear = Wear{1e-17};
  if (uniform(0.0, 1.0) < 0.1) c.operation->slip_ratio = uniform(0.3, 0.5);
  if (uniform(0.0, 1.0) < 0.05)
    c.friction->coefficient = at_both(100.0 * c.friction->coefficient.screw);  // jams with Coulomb friction
  if (uniform(0.0, 1.0) < 0.05) c.carrier.nut_torque = 1e5;                    // no equilibrium
  return c;
}

/// Largest relative difference, for vectors relative to their length.
class Difference {
 public:
  void of(double value, double expected, double scale) {
    if (value == expected) return;
    const double relative = std::abs(value - expected) / scale;
    worst_ = relative <= worst_ ? worst_ : relative;  // NaN stays
  }
  void of(double value, double expected) { of(value, expected, std::abs(expected)); }
  void of(const std::vector<double>& values, const std::vector<double>& expected) {
    EXPECT_EQ(values.size(), expected.size());
    for (std::size_t k = 0; k < values.size() && k < expected.size(); ++k) of(values[k], expected[k]);
  }
  void of(const std::optional<double>& value, const std::optional<double>& expected) {
    EXPECT_EQ(value.has_value(), expected.has_value());
    if (value && expected) of(*value, *expected);
  }
  double worst() const { return worst_; }

 private:
  double worst_ = 0.0;
};

double difference(const LoadCaseResult& value, const LoadCaseResult& expected, const Case& c) {
  Difference d;
  const SlipResult &s = *value.slip, &t = *expected.slip;
  EXPECT_EQ(s.status, t.status);
  d.of(s.speed, t.speed);
  d.of(s.slip_ratio, t.slip_ratio);
  d.of(s.ideal_slip_ratio, t.ideal_slip_ratio);
  d.of(s.optimality, t.optimality);
  d.of(s.efficiency, t.efficiency);
  d.of(s.efficiency_fit, t.efficiency_fit);
  d.of(s.viscosity, t.viscosity);
  d.of(s.bearing_eccentricity, t.bearing_eccentricity);
  EXPECT_EQ(s.driven_by, t.driven_by);
  EXPECT_EQ(s.self_locking, t.self_locking);
  const double power = t.power.total();
  d.of(s.power.total(), power);
  for (const auto source :
       {&PowerBySource::screw, &PowerBySource::nut, &PowerBySource::carrier_roller, &PowerBySource::carrier_screw})
    d.of(s.power.*source, t.power.*source, power);
  const double shaft = std::abs(t.torque_screw) + power / std::abs(t.speed);
  d.of(s.torque_screw, t.torque_screw, shaft);
  d.of(s.torque_nut, t.torque_nut, shaft);
  const double force = std::abs(c.load_cases[0].axial_force) / c.mechanism.rollers;
  d.of(s.forces.contacts_y, t.forces.contacts_y, force);
  d.of(s.forces.carrier_x, t.forces.carrier_x, force + t.forces.centrifugal);
  d.of(s.forces.gears_y, t.forces.gears_y, force + std::abs(t.forces.gears_y));
  const double arm = force * 0.5 * *c.mechanism.pitch_diameter.screw;
  d.of(s.moments.spin, t.moments.spin, arm);
  d.of(s.moments.contacts, t.moments.contacts, arm);
  for (const Interface i : kInterfaces) {
    const InterfaceSlip &a = s.threads[i], &b = t.threads[i];
    const double speed = b.max_sliding_speed.front();
    d.of(a.power, b.power);
    d.of(a.power_density, b.power_density);
    d.of(a.friction_coefficient, b.friction_coefficient);
    d.of(a.dynamic_normal_load, b.dynamic_normal_load);
    d.of(a.max_sliding_speed, b.max_sliding_speed);
    d.of(a.sliding_speed.back(), b.sliding_speed.back(),
         speed + 1e-4 * std::abs(t.speed) * *c.mechanism.pitch_diameter.screw);
    d.of(a.film_thickness, b.film_thickness);
    d.of(a.central_film, b.central_film);
    d.of(a.film_ratio, b.film_ratio);
    d.of(a.boundary_share, b.boundary_share);
    d.of(a.wear, b.wear);
    const InterfaceLoads &l = (*value.threads)[i], &m = (*expected.threads)[i];
    d.of(l.axial_load, m.axial_load);
    d.of(l.peak_pressure, m.peak_pressure);
    d.of(l.approach, m.approach);
  }
  return d.worst();
}

TEST(SlipBatch, GivesTheResultsOfTheScalarChain) {
  using enum simd::InstructionSet;
  constexpr std::size_t kDesigns = 64, kOnly[] = {0};
  std::mt19937_64 random(5);
  double worst = 0.0;
  std::map<std::string, int> ends;
  for (int n = test::samples(20, 1600); n > 0; --n) {
    const int patch_points = std::uniform_int_distribution<int>(5, 24)(random);
    std::vector<Case> designs;
    std::vector<std::optional<LoadCaseResult>> expected;
    for (std::size_t k = 0; k < kDesigns; ++k) {
      designs.push_back(random_design(random, patch_points));
      expected.emplace_back();
      try {
        expected.back() = analyze_slip(designs.back(), kManyDesigns).load_cases[0];
        ++ends[std::string(name(expected.back()->slip->status))];
        if (!expected.back()->slip->converged()) expected.back().reset();
      } catch (const CaseError&) {
        ++ends["refused"];
      }
    }
    for (const simd::InstructionSet set : {baseline, avx2, avx512}) {
      if (!simd::available(set)) continue;
      SlipBatch batch(set);
      for (std::size_t k = 0; k < kDesigns; ++k) {
        ASSERT_TRUE(batch.takes(designs[k], kOnly));
        try {
          batch.add(k, designs[k], checked_mechanism(designs[k]), kOnly);
        } catch (const CaseError&) {
          EXPECT_FALSE(expected[k]);
        }
      }
      batch.solve(
          {}, {},
          [&](std::size_t k, const std::vector<LoadCaseResult>& results, const Contacts&) {
            ASSERT_TRUE(expected[k]) << k;
            const double found = difference(results[0], *expected[k], designs[k]);
            EXPECT_LE(found, 1e-11) << simd::name(set) << ", design " << k;
            worst = std::max(worst, found);
          },
          [&](std::size_t k) { EXPECT_FALSE(expected[k]) << k; });
      if (HasFailure()) return;
    }
  }
  RecordProperty("largest_relative_difference", fmt::format("{:.1e}", worst));
  EXPECT_EQ(ends.size(), 5U);  // converged, imposed, no_equilibrium, jammed, refused
  EXPECT_GT(ends["converged"], 3 * ends["refused"]);
}

const std::string kStudy = input::kAbeviThreads + R"(  rollers: 11
  contacts_per_roller: 20
materials: {youngs_modulus: 209 GPa, poisson_ratio: 0.3, density: 7810 kg/m^3}
load_cases:
  - {name: pull, axial_force: 20 kN, share: equal}
  - {name: push, axial_force: -20 kN, share: equal, speed: -600 rpm}
operation: {speed: 600 rpm}
friction: {model: jacod}
lubricant: {name: iso-vg-100, temperature: 60 degC}
carrier: {bearing: {length: 5 mm, diameter: 5 mm, radial_clearance: 0.1 mm}}
)";

input::StudyInput study(const std::string& rest) {
  return input::read_study_input({"case.yaml",
                                  kStudy +
                                      ("study: {command: slip, plan: monte_carlo, samples: 2000, factors: [{path: "
                                       "mechanism.flank_angle, within: 3 %}, {path: operation.speed, log_uniform: "
                                       "{from: 6 rpm, to: 1200 rpm}}, ") +
                                      rest + "}\n",
                                  {}});
}

TEST(SlipBatch, ADesignTakesNoMemory) {
  const input::StudyInput in = study(
      "{path: 'load_cases[0].axial_force', log_uniform: {from: 1 kN, to: 40 kN}}], responses: "
      "[slip.efficiency, 'load_cases[1].slip.power_loss_W', slip.screw.film_thickness_nm.max, "
      "slip.hottest_thread.power_W, nut.peak_pressure_MPa.max]");
  test::expect_no_memory_per_design(DesignEngine(in));
}

/// Rows of a study, refusals with their words.
TEST(SlipBatch, AnswersDesignsAsTheScalarChainDoes) {
  const input::StudyInput in = study(
      "{path: carrier.nut_torque, values: [0 N m, 1e5 N m]}, {path: "
      "mechanism.pitch.roller, values: [1.6666666667 mm, 1.75 mm]}], responses: [slip.efficiency, "
      "slip.screw.central_film_nm.max]");
  constexpr std::size_t kDesigns = 100;
  const RowBlock block = DesignEngine(in).evaluate(1, kDesigns);
  DesignReader reader(in);
  std::map<std::string, int> reasons;
  auto failure = block.failures.begin();
  for (std::size_t k = 0; k < kDesigns; ++k) {
    DesignStatus status;
    try {
      const Result result = analyze_slip(reader.read(1 + k), kManyDesigns);
      const SlipResult& slip = *result.load_cases[0].slip;
      if (!slip.converged()) status.name = name(slip.status);
      if (slip.converged()) {
        EXPECT_NEAR(block.responses[2 * k] / *slip.efficiency, 1.0, 1e-12);
        EXPECT_NEAR(block.responses[2 * k + 1] / (slip.threads.screw.central_film[0] * 1e9), 1.0, 1e-12);
      }
    } catch (const CaseError& error) {
      status = {"refused", std::string(error.path()) + ": " + error.what()};
    }
    ++reasons[status.name];
    if (status.converged()) continue;
    ASSERT_TRUE(failure != block.failures.end() && failure->row == k) << k;
    EXPECT_EQ(failure->status.name, status.name);
    if (status.name == "refused") {
      EXPECT_EQ(failure->status.reason, status.reason);
    }
    ++failure;
  }
  EXPECT_TRUE(failure == block.failures.end());
  EXPECT_EQ(reasons.size(), 3U);
}

}  // namespace
}  // namespace prs
