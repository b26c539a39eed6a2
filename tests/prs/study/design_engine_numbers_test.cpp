#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <regex>
#include <string>
#include <vector>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/study/design_engine.h"
#include "prs/study/design_reader.h"
#include "prs/study/designs.h"
#include "prs/study/response.h"
#include "support/count.h"
#include "support/program.h"
#include "support/random_screws.h"
#include "support/sanitized.h"

// Random screws through the engine of studies, checked by laws of mechanics.
namespace prs {
namespace {

using test::RandomScrews;
using test::Screw;

constexpr int kDrawn = 499;  ///< Designs drawn by a study, which has the base case too.

const char* const kLoadResponses[] = {
    "axial_displacement_um",       "axial_stiffness_N_per_um",    "tangent_stiffness_N_per_um",
    "screw.load_rate_percent.min", "screw.load_rate_percent.max", "screw.load_rate_percent.mean",
    "nut.load_rate_percent.min",   "nut.load_rate_percent.max",   "nut.load_rate_percent.mean"};
enum LoadNumber {
  kDisplacement,
  kSecant,
  kTangent,
  kScrewLeast,
  kScrewMost,
  kScrewMean,
  kNutLeast,
  kNutMost,
  kNutMean,
  kLoadNumbers
};

std::vector<std::string> load_responses() {
  std::vector<std::string> all;
  for (const char* load : {"load_cases[0].", "load_cases[1]."})
    for (const char* path : kLoadResponses) all.push_back(std::string(load) + path);
  return all;
}

/// The designs of one screw, evaluated.
struct Evaluated {
  explicit Evaluated(const std::string& text)
      : input(input::read_study_input({"case.yaml", text, {}})),
        block(DesignEngine(input).evaluate(0, design_count(input.study))) {}

  const double* of(std::size_t design) const { return &block.responses[design * input.study.responses.size()]; }

  input::StudyInput input;
  RowBlock block;
};

/// Outcomes of designs, as the program's messages without their numbers.
class Verdicts {
 public:
  void add(const RowBlock& block) {
    designs_ += block.rows;
    for (const RowBlock::Failure& failure : block.failures) {
      static const std::regex number(R"([-+]?[0-9][0-9.]*(e[-+]?[0-9]+)?)");
      ++failed_[failure.status.name + ": " + std::regex_replace(failure.status.reason, number, "#")];
    }
  }
  void print(const std::string& title) const {
    std::size_t failed = 0;
    for (const auto& [reason, count] : failed_) failed += count;
    std::printf("%s: %zu designs, %zu converged\n", title.c_str(), designs_, designs_ - failed);
    for (const auto& [reason, count] : failed_) std::printf("  %7zu %s\n", count, reason.c_str());
  }
  bool all_converged() const { return failed_.empty(); }

 private:
  std::size_t designs_ = 0;
  std::map<std::string, std::size_t> failed_;
};

/// Largest of some differences, and its limit.
struct Worst {
  const char* what;
  double bound;
  double value = 0.0;

  void take(double difference, const std::string& text) {
    if (!(difference <= value)) value = difference;
    if (difference <= bound) return;
    ADD_FAILURE() << what << ": " << difference << " > " << bound << '\n' << text;
  }
};

/// 0 also if neither has a result.
double relative(double a, double b) { return std::isnan(a) && std::isnan(b) ? 0.0 : std::abs(a / b - 1.0); }

struct LoadOracles {
  Worst balance{"threads carry the force", 1e-10};
  Worst sign{"no thread pulls", 0.0};
  Worst tangent{"tangent over secant stiffness within its bounds", 1e-9};
  Worst hand{"left as right", 1e-9};
  Worst swap{"screw and nut exchanged", 1e-9};
  Worst direction{"tension as compression", 1e-9};

  void print() const {
    for (const Worst& w : {balance, sign, tangent, hand, swap, direction})
      std::printf("  %-50s %.1e\n", w.what, w.value);
  }

  /// Checks each load by itself. Without gaps, forces grow with displacements at least in proportion, and in bars are
  /// homogeneous, of degree 1 in the bodies and 3/2 in the contacts: the stiffness at the load is 1 to 3/2 of the
  /// secant.
  void see(const double* numbers, const Screw& s, const std::string& text) {
    for (const LoadNumber mean : {kScrewMean, kNutMean})
      balance.take(std::abs(numbers[mean] * s.threads / 100.0 - 1.0), text);
    sign.take(-std::min({numbers[kScrewLeast], numbers[kNutLeast], numbers[kDisplacement]}), text);
    const double ratio = numbers[kTangent] / numbers[kSecant];
    if (s.has_gaps()) return;
    tangent.take(1.0 - ratio, text);
    if (s.model.find("bodies: refined") == std::string::npos) tangent.take(ratio - 1.5, text);
  }

  /// Difference of results, with the interfaces exchanged or not.
  static double difference(const double* a, const double* b, bool exchanged = false) {
    double worst = 0.0;
    for (const LoadNumber k : {kDisplacement, kSecant, kTangent}) worst = std::max(worst, relative(a[k], b[k]));
    const int to_nut = exchanged ? kNutLeast - kScrewLeast : 0;
    for (const int k : {kScrewLeast, kScrewMost, kNutLeast, kNutMost}) {
      const int other = k < kNutLeast ? k + to_nut : k - to_nut;
      worst = std::max(worst, std::abs(a[k] - b[other]) / 100.0);
    }
    return worst;
  }
};

template <class Compare>
void for_each_load(const Evaluated& a, const Evaluated& b, Compare compare) {
  ASSERT_EQ(a.block.failures.size(), b.block.failures.size());
  for (std::size_t k = 0; k < a.block.rows; ++k)
    for (const int load : {0, int{kLoadNumbers}})
      if (!std::isnan(a.of(k)[0])) compare(a.of(k) + load, b.of(k) + load);
}

/// Screws with every option of bars or refined bodies, and those that can be exchanged.
Screw realistic(RandomScrews& screws, int k, const char* bodies) {
  const bool bars = std::string(bodies) == "bars";
  Screw s = screws.next(bars && k % 3 == 1 ? RandomScrews::Kind::swappable : RandomScrews::Kind::any);
  const bool rigid = k % 4 == 1;
  if (k % 12 == 1 && bars) s.guidance = "both_end_nodes";
  s.model = fmt::format("bodies: {}, roller: {}", bodies, rigid ? "rigid_bending" : "flexible");
  if (k % 5 == 2)
    s.deviations =
        fmt::format("{{crowning: {} m, pitch_error: {{nut: {{linear: {} m}}}}}}", 3e-4 * s.pitch, 2e-5 * s.pitch);
  return s;
}

void expect_mechanics(const char* bodies, int families, std::uint64_t seed) {
  RandomScrews screws(seed);
  Verdicts verdicts;
  LoadOracles oracles;
  for (int k = 0; k < families && !testing::Test::HasFailure(); ++k) {
    const Screw s = realistic(screws, k, bodies);
    const auto evaluated = [&](const Screw& screw) {
      return Evaluated(screw.text("solve", kDrawn, seed + k, load_responses()));
    };
    const std::string text = s.text("solve", kDrawn, seed + k, load_responses());
    const Evaluated designs(text);
    verdicts.add(designs.block);
    for (std::size_t d = 0; d < designs.block.rows; ++d)
      for (const int load : {0, int{kLoadNumbers}})
        if (!std::isnan(designs.of(d)[0])) oracles.see(designs.of(d) + load, s, text);
    for_each_load(designs, evaluated(left_handed(s)),
                  [&](const double* a, const double* b) { oracles.hand.take(LoadOracles::difference(a, b), text); });
    if (!s.overridden || !s.deviations.empty()) continue;
    for_each_load(designs, evaluated(swapped(s)), [&](const double* a, const double* b) {
      oracles.swap.take(LoadOracles::difference(a, b, true), text);
    });
    // Only the bending of the rollers depends on the direction.
    if (k % 12 != 1) continue;
    Screw turned = s;
    turned.exchanged = true;
    for_each_load(designs, evaluated(turned), [&](const double* a, const double* b) {
      oracles.direction.take(LoadOracles::difference(a, b), text);
    });
  }
  verdicts.print(std::string("realistic, ") + bodies);
  oracles.print();
  EXPECT_TRUE(verdicts.all_converged());
}

TEST(DesignEngineNumbers, RealisticBarsAllConvergeAndObeyMechanics) {
  expect_mechanics("bars", test::samples(24, 1840), 2026);
}

TEST(DesignEngineNumbers, RealisticRefinedScrewsAllConvergeAndObeyMechanics) {
  expect_mechanics("refined", test::samples(2, 160), 2027);
}

/// Inputs across all decades that the program takes, a few of them at once.
Screw extreme(RandomScrews& random) {
  Screw s = random.next();
  s.threads = random.chance() ? s.threads : random.whole(1, 300);
  s.nut_length = std::max(s.nut_length, (s.threads + 12) * s.pitch);
  s.thrust_compression = s.nut_length - s.thrust_tension;
  s.position = 0.5 * (s.nut_length - (s.threads - 1) * s.pitch);
  const char* models[] = {"bodies: bars", "bodies: bars, roller_shear: true", "bodies: refined"};
  s.model = fmt::format("{}, roller: {}", models[random.whole(0, 2)], random.chance() ? "flexible" : "rigid_bending");
  const auto about = [](const char* path, const char* unit, double value, double range) {
    return Screw::Drawn{path, unit, value * (1.0 - range), value * (1.0 + range)};
  };
  const double d = 2.0 * s.radius.screw;
  std::vector<Screw::Drawn> all = {
      {"materials.screw.youngs_modulus", "Pa", 1e6, 1e16, true},
      {"materials.roller.youngs_modulus", "Pa", 1e6, 1e16, true},
      {"materials.nut.youngs_modulus", "Pa", 1e6, 1e16, true},
      {"materials.screw.poisson_ratio", "", 0.0, 0.4999},
      {"materials.nut.poisson_ratio", "", 0.0, 0.4999},
      {"mechanism.flank_angle", "rad", 0.02, 1.55},
      about("mechanism.pitch_diameter.screw", "m", d, s.designed ? 0.7 : 0.01),
      {"mechanism.lead", "m", s.hand * s.starts * s.pitch * 0.2, s.hand * s.starts * s.pitch * 5.0},
      {"structure.screw.bore", "m", 0.0, 1.1 * d},
      {"structure.screw.free_length", "m", 1e-12, 1e3, true},
      {"structure.roller.end_length", "m", 1e-9, 1e2, true},
      {"structure.roller.end_diameter", "m", 1e-7, 1e2, true},
      {"structure.nut.outer_diameter", "m", 1.9 * s.radius.nut, 1e3, true},
      {"structure.nut.length", "m", 1e-6, 1e3, true},
      {"structure.nut.thrust.tension", "m", -0.2 * s.nut_length, 1.2 * s.nut_length},
      {"load_cases[0].position", "m", -0.2 * s.nut_length, 1.2 * s.nut_length},
      {"load_cases[0].axial_force", "N", 1e-3, 1e15, true},
      {"load_cases[1].axial_force", "N", 1e-3, 1e15, true},
      {"deviations.crowning", "m", 1e-12, 1.0, true},
      {"deviations.pitch_error.nut.linear", "m", -0.1 * s.pitch, 0.1 * s.pitch}};
  if (!s.designed) all.push_back(about("mechanism.centre_distance", "m", 0.5 * d + s.radius.roller, 0.02));
  if (s.guidance.starts_with("{")) all.push_back({"structure.roller.guidance.ring", "N/m", 1.0, 1e20, true});
  s.drawn.clear();
  for (int n = random.whole(1, 4); n > 0; --n) {
    const auto at = static_cast<std::size_t>(random.whole(0, static_cast<int>(all.size()) - 1));
    s.drawn.push_back(all[at]);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return s;
}

TEST(DesignEngineNumbers, ExtremeScrewsConvergeOrSayWhyNot) {
  RandomScrews random(2028);
  Verdicts verdicts;
  LoadOracles oracles;
  int without_stiffness = 0;
  for (int k = 0; k < test::samples(20, 1000) && !HasFailure(); ++k) {
    const Screw s = extreme(random);
    const std::string text = s.text("solve", 99, k, load_responses());
    const Evaluated designs(text);
    verdicts.add(designs.block);
    // The program refuses invalid inputs with the key at fault; valid ones converge.
    static const std::regex at_fault(R"((mechanism|structure|deviations|load_cases\[.\])\.[a-z_.0-9\[\]]*: .*)");
    for (const RowBlock::Failure& failure : designs.block.failures)
      EXPECT_TRUE(failure.status.name == "refused" && std::regex_match(failure.status.reason, at_fault))
          << failure.status.name << ": " << failure.status.reason << '\n'
          << text << testing::PrintToString(overrides(designs.input.study, design(designs.input.study, failure.row)));
    for (std::size_t d = 0; d < designs.block.rows; ++d)
      for (const int load : {0, int{kLoadNumbers}}) {
        const double* numbers = designs.of(d) + load;
        if (std::isnan(numbers[kScrewMean])) continue;
        if (!std::isnan(numbers[kTangent]))
          oracles.see(numbers, s, text);
        else
          ++without_stiffness;
      }
  }
  verdicts.print("extreme");
  oracles.print();
  std::printf("  %d loads of screws too soft for the effect of Poisson's ratio\n", without_stiffness);
}

/// Each thread of each roller, a force off the axis in its plane of symmetry.
TEST(DesignEngineNumbers, RealisticFullMechanismsAllConvergeAndObeyMechanics) {
  SKIP_UNDER_SANITIZERS();
  RandomScrews random(2029);
  Verdicts verdicts;
  LoadOracles oracles;
  for (int k = 0; k < test::samples(2, 400) && !HasFailure(); ++k) {
    Screw s = random.next();
    s.threads = std::min(s.threads, 24);
    s.rollers = std::max(s.rollers, 3);
    s.model = "mechanism: full";
    s.rings = "nut";
    s.bearings = fmt::format("[{{position: {} m, lateral: rigid, tilt: rigid}}]", s.position - s.free_length);
    s.force = RandomScrews::load_at(1.5e9, s);
    std::erase_if(
        s.drawn, [](const Screw::Drawn& d) { return d.path.ends_with("position") || d.path.ends_with("free_length"); });
    for (Screw::Drawn& d : s.drawn)
      if (d.path.ends_with("axial_force")) d.from = 0.1 * s.force, d.to = 4.0 * s.force;
    s.drawn.push_back({"load_cases[0].eccentricity.y", "m", 0.0, 0.3 * s.radius.screw});
    const std::string text = s.text("solve", 19, k, load_responses());
    const Evaluated designs(text);
    verdicts.add(designs.block);
    for (std::size_t d = 0; d < designs.block.rows; ++d)
      for (const int load : {0, int{kLoadNumbers}})
        if (!std::isnan(designs.of(d)[0])) oracles.see(designs.of(d) + load, s, text);
    const Evaluated mirrored(left_handed(s).text("solve", 19, k, load_responses()));
    for_each_load(designs, mirrored,
                  [&](const double* a, const double* b) { oracles.hand.take(LoadOracles::difference(a, b), text); });
  }
  verdicts.print("realistic, full mechanism");
  oracles.print();
  EXPECT_TRUE(verdicts.all_converged());
}

TEST(DesignEngineNumbers, RealisticBodiesOfRevolutionAllConvergeAndObeyMechanics) {
  if (std::getenv("PRS_THOROUGH") == nullptr) GTEST_SKIP() << "seconds a mesh";
  RandomScrews random(2030);
  Verdicts verdicts;
  LoadOracles oracles;
  for (int k = 0; k < 3 && !HasFailure(); ++k) {
    Screw s = random.next();
    s.threads = std::min(s.threads, 12);
    s.guidance = "both_end_nodes";
    s.model = "bodies: influence";
    std::erase_if(s.drawn, [](const Screw::Drawn& d) { return !d.path.ends_with("axial_force"); });
    const std::string text = s.text("solve", 199, k, load_responses());
    const Evaluated designs(text);
    verdicts.add(designs.block);
    for (std::size_t d = 0; d < designs.block.rows; ++d)
      for (const int load : {0, int{kLoadNumbers}})
        if (!std::isnan(designs.of(d)[0])) oracles.see(designs.of(d) + load, s, text);
  }
  verdicts.print("realistic, influence");
  oracles.print();
  EXPECT_TRUE(verdicts.all_converged());
}

/// The motor's input comes out at the load or is lost, at the friction of every thread: the loss from the shafts is
/// that of the contacts.
TEST(DesignEngineNumbers, RealisticScrewsLoseWhatTheyAreGiven) {
  RandomScrews random(2031);
  Verdicts verdicts;
  Worst balance{"input is output and losses", 1e-8}, shafts{"losses from shafts and contacts", 1e-8},
      torques{"torques of screw and nut", 1e-9}, hand{"left as right", 1e-9};
  enum { kScrewTorque, kNutTorque, kLoss, kFromShafts, kSlipRatio, kForce, kSpeed };
  std::vector<std::string> responses;
  for (const char* load : {"load_cases[0].", "load_cases[1]."})
    for (const char* path : {"slip.torque_screw_Nm", "slip.torque_nut_Nm", "slip.power_loss_W",
                             "slip.power_loss_input_output_W", "slip.slip_ratio", "axial_force_N", "slip.speed_rpm"})
      responses.push_back(std::string(load) + path);
  for (int k = 0; k < test::samples(4, 400) && !HasFailure(); ++k) {
    Screw s = random.next();
    s.threads = std::min(s.threads, 20);
    s.designed = true;
    const double speed = random.log(1.0, 200.0);
    const auto with_friction = [&](Screw screw) {
      const char* frictions[] = {"{coulomb: 0.08}", "{model: jacod}", "{mixed: {boundary: 0.12}}"};
      screw.more = fmt::format(
          "operation: {{speed: {} rad/s}}\nfriction: {}\n"
          "lubricant: {{name: iso-vg-100, temperature: 60 degC}}\nroughness: 0.2 um\n",
          screw.hand * speed, frictions[k % 3]);
      return screw.text("slip", 49, k, responses);
    };
    const std::string text = with_friction(s);
    const Evaluated designs(text), mirrored(with_friction(left_handed(s)));
    verdicts.add(designs.block);
    ASSERT_EQ(designs.block.failures.size(), mirrored.block.failures.size()) << text;
    for (std::size_t d = 0; d < designs.block.rows; ++d) {
      if (std::isnan(designs.of(d)[0])) continue;
      for (const int load : {0, 7}) {
        const double* a = designs.of(d) + load;
        const double* b = mirrored.of(d) + load;
        const double turn = a[kSpeed] * std::numbers::pi / 30.0;
        const double out =
            (load == 0 ? 1.0 : -1.0) * a[kForce] * s.hand * s.starts * s.pitch * turn / (2.0 * std::numbers::pi);
        const double scale = std::abs(out) + a[kLoss];
        balance.take(std::abs(a[kScrewTorque] * turn - out - a[kLoss]) / scale, text);
        shafts.take(std::abs(a[kFromShafts] - a[kLoss]) / scale, text);
        torques.take(relative(a[kScrewTorque], -a[kNutTorque]), text);
        EXPECT_GT(a[kLoss], 0.0) << text;
        for (const int same : {kLoss, kSlipRatio}) hand.take(relative(a[same], b[same]), text);
      }
    }
  }
  verdicts.print("realistic, slip");
  for (const Worst& w : {balance, shafts, torques, hand}) std::printf("  %-50s %.1e\n", w.what, w.value);
  EXPECT_TRUE(verdicts.all_converged());
}

/// Verdict and results of one design, by the solver of single cases.
struct Solved {
  Solved(const input::StudyInput& input, std::size_t design) {
    try {
      const Result result = analyze(Case(DesignReader(input).read(design)));
      for (const LoadCaseResult& load : result.load_cases) converged &= load.converged();
      for (const std::string& path : input.study.responses) {
        const ResultNumber number = *result_number(path);
        numbers.push_back(
            number.value({result.contacts, &result.load_cases[number.load_case.value_or(0)]}).value_or(kNoResponse));
      }
    } catch (const std::exception&) {
      converged = false;
    }
  }
  bool converged = true;
  std::vector<double> numbers;
};

TEST(DesignEngineNumbers, SingleCasesSayTheSame) {
  RandomScrews random(2032);
  Worst worst{"solve as study", 1e-9}, program{"prs solve as study", 1e-9};
  int compared = 0, refused = 0;
  const int count = test::samples(60, 3000);
  for (int k = 0; k < count && !HasFailure(); ++k) {
    const bool wild = k % 3 == 2;
    const Screw s = wild ? extreme(random) : realistic(random, k, k % 7 == 0 ? "refined" : "bars");
    const std::string text = s.text("solve", 9, k, load_responses());
    const Evaluated designs(text);
    for (std::size_t d = 0; d < designs.block.rows; ++d) {
      const Solved solved(designs.input, d);
      const bool answered = !std::isnan(designs.of(d)[kScrewMean]);
      ASSERT_EQ(solved.converged, answered) << text << "design " << d;
      refused += answered ? 0 : 1;
      if (!answered) continue;
      ++compared;
      for (const int load : {0, int{kLoadNumbers}})
        worst.take(LoadOracles::difference(&solved.numbers[load], designs.of(d) + load), text);
    }
    if (k % 10 != 0) continue;
    const test::TemporaryDirectory folder;
    std::ofstream(folder.path() / "case.yaml") << text;
    const std::size_t last = designs.block.rows - 1;
    std::string arguments = "solve case.yaml --json --quiet";
    for (const std::string& set : overrides(designs.input.study, design(designs.input.study, last)))
      arguments += " --set '" + set + "'";
    const test::Outcome run = test::run_prs(arguments, folder.path());
    const bool answered = !std::isnan(designs.of(last)[kScrewMean]);
    ASSERT_EQ(run.status, answered ? 0 : 2) << run.err << text;
    if (!answered) continue;
    const auto document = nlohmann::ordered_json::parse(run.out);
    std::vector<double> numbers;
    for (const std::string& path : designs.input.study.responses)
      numbers.push_back(response(document, path).value_or(kNoResponse));
    for (const int load : {0, int{kLoadNumbers}})
      program.take(LoadOracles::difference(&numbers[load], designs.of(last) + load), text);
  }
  std::printf("%d designs, %d refused; %.1e, through the program %.1e\n", compared, refused, worst.value,
              program.value);
  EXPECT_GT(compared, count);
}

/// Threads, shards and continued runs take designs in other batches.
TEST(DesignEngineNumbers, ADesignHasTheSameBitsInAnyBatch) {
  RandomScrews random(2033);
  std::size_t compared = 0;
  for (int k = 0; k < test::samples(10, 200); ++k) {
    const char* bodies[] = {"bars", "bars", "refined", "bars"};
    Screw s = realistic(random, k, bodies[k % 4]);
    if (k % 10 == 7) s = extreme(random);
    std::string text = s.text("solve", 70, k, load_responses());
    if (k % 4 == 3) {
      s.designed = true;
      s.more = "operation: {speed: 300 rpm}\nfriction: {coulomb: 0.08}\n";
      text = s.text("slip", 20, k, {"slip.power_loss_W", "slip.efficiency", "slip.slip_ratio"});
    }
    const Evaluated whole(text);
    const DesignEngine engine(whole.input);
    const std::size_t responses = whole.input.study.responses.size();
    for (const std::size_t batch : {1, 3, 13})
      for (std::size_t last = whole.block.rows; last > 0;) {  // In reverse order.
        const std::size_t first = last > batch ? last - batch : 0;
        const RowBlock part = engine.evaluate(first, last - first);
        ASSERT_EQ(std::memcmp(part.responses.data(), whole.of(first), (last - first) * responses * sizeof(double)), 0)
            << text << "designs " << first << " to " << last;
        compared += last - first;
        last = first;
      }
  }
  std::printf("%zu designs\n", compared);
}

}  // namespace
}  // namespace prs
