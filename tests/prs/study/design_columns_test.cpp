#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/model/problems.h"
#include "prs/study/design_engine.h"
#include "prs/study/design_reader.h"
#include "prs/study/response.h"
#include "support/count.h"
#include "support/sanitized.h"
#include "tests/contact/mechanisms.h"
#include "tests/prs/input/abevi.h"
#include "tests/prs/study/memory_of_designs.h"

// Designs side by side, compared with the same designs one after the other.
namespace prs {
namespace {

constexpr int kDesigns = 64;  ///< Designs of a study, the base case included.

const char* const kResponses[] = {"axial_displacement_um",
                                  "axial_stiffness_N_per_um",
                                  "tangent_stiffness_N_per_um",
                                  "screw.load_rate_percent.max",
                                  "nut.load_rate_percent.max",
                                  "nut.load_rate_percent[0]",
                                  "screw.peak_pressure_MPa.max",
                                  "load_cases[1].nut.peak_pressure_MPa.max",
                                  "load_cases[1].screw.approach_um.mean",
                                  "contact.screw.radius_on_body_mm",
                                  "contact.nut.curvature_sum_per_mm",
                                  "contact.screw.first_directions_angle_deg",
                                  "contact.nut.ellipticity"};

/// Studies of standard and inverted screws of either hand, straight, convex and concave profiles in
/// both planes, by their radii or by their backlash, of bars and of refined bodies, with and
/// without heights, deviations and springs of teeth. Not all designs have contacts on their flanks,
/// nor a wall around the nut.
class RandomStudies {
 public:
  explicit RandomStudies(std::uint64_t seed)
      : usual_(seed), others_(seed + 1, contact::test::RandomMechanisms::Rollers::straight_or_concave) {}

  std::string next() {
    const int kind = next_++;
    const contact::MechanismGeometry m = kind % 3 == 2 ? others_.next() : usual_.next();
    const bool designed = kind % 4 == 3, standard = m.type == contact::MechanismType::standard;
    const double pitch = m.screw.pitch, c = m.centre_distance;
    const int threads = usual_.integer(1, 24);
    const int fit = static_cast<int>(std::numbers::pi / std::asin(m.roller.pitch_radius / c));
    std::string text = fmt::format(
        "mechanism:\n  type: {}\n  profile_plane: {}\n  lead: {}\n  starts: {{screw: {:.0f}, "
        "roller: {:.0f}}}\n  flank_angle: {{screw: {} rad, roller: {} rad, nut: {} rad}}\n",
        standard ? "standard" : "inverted", m.screw.plane == contact::ProfilePlane::normal ? "normal" : "axial",
        metres(m.screw.lead), std::round(std::abs(m.screw.lead) / pitch), std::round(std::abs(m.roller.lead) / pitch),
        m.screw.flank_angle, m.roller.flank_angle, m.nut.flank_angle);
    const double d = 2.0;
    if (designed)
      text += fmt::format(
          "  geometry: design\n  pitch_diameter: {{screw: {}}}\n  backlash: {{screw: {}, nut: "
          "{}}}\n",
          metres(d * m.screw.pitch_radius), metres(usual_.uniform(0.0, 0.01) * pitch),
          metres(usual_.uniform(0.0, 0.01) * pitch));
    else
      text += fmt::format("  pitch_diameter: {{screw: {}, roller: {}, nut: {}}}\n  centre_distance: {}\n",
                          metres(d * m.screw.pitch_radius), metres(d * m.roller.pitch_radius),
                          metres(d * m.nut.pitch_radius), metres(c));
    text += fmt::format("  profile: {{screw: {}, roller: {}, nut: {}}}\n", profile(m.screw), profile(m.roller),
                        profile(m.nut));
    const bool refined = kind % 16 >= 8;
    if (kind % 6 == 5 && !refined)  // thicknesses are of bars alone
      for (const char* part : {"screw", "roller", "nut"})
        text += fmt::format("{}    {}: {{addendum: {}, dedendum: {}, thickness: {}}}\n",
                            part[0] == 's' ? "  thread:\n" : "", part, metres(0.2 * pitch),
                            metres(usual_.uniform(0.25, 0.3) * pitch), metres(usual_.uniform(0.45, 0.5) * pitch));
    text += fmt::format("  rollers: {}\n  contacts_per_roller: {}\n", std::max(1, fit - 1), threads);
    const double length = (threads + 8) * pitch, outer = 2.4 * (c + m.roller.pitch_radius);
    text += fmt::format(
        "structure:\n  screw: {{free_length: {}, bore: {}}}\n  roller: {{end_length: {}, "
        "end_diameter: {}}}\n  nut:\n    length: {}\n    outer_diameter: {}\n    flanges: [{{from: "
        "{}, to: {}, outer_diameter: {}}}]\n    thrust: {{tension: {}, compression: {}}}\n",
        metres(pitch), metres(0.3 * m.screw.pitch_radius), metres(2 * pitch), metres(m.roller.pitch_radius),
        metres(length), metres(outer), metres(pitch), metres(3 * pitch), metres(1.2 * outer), metres(3 * pitch),
        metres(pitch));
    text += "materials: {youngs_modulus: 209 GPa, poisson_ratio: 0.3}\n";
    if (kind % 7 == 3)
      text += fmt::format("deviations: {{crowning: {}, pitch_error: {{screw: {{linear: {}}}}}}}\n",
                          metres(5e-4 * pitch), metres(5e-4 * pitch));
    if (refined || kind % 8 == 1)
      text += fmt::format("model: {{bodies: {}{}}}\n", refined ? "refined" : "bars",
                          kind % 8 == 1 ? fmt::format(", tooth_compliance: {{yamamoto: {}}}", metres(pitch)) : "");
    text += fmt::format(
        "load_cases:\n  - {{name: pull, axial_force: 9 kN, direction: tension, position: {0}}}\n"
        "  - {{name: push, axial_force: 5 kN, direction: compression, position: {0}}}\n",
        metres(4 * pitch));
    text += fmt::format(
        "study: {{command: solve, plan: monte_carlo, samples: {}, seed: {}, factors: [{{path: "
        "mechanism.flank_angle.roller, within: 2 %}}, {{path: mechanism.pitch_diameter.{}, within: "
        "{} %}}, {{path: structure.nut.outer_diameter, within: 20 %}}, {{path: "
        "materials.youngs_modulus, within: 3 %}}, {{path: 'load_cases[0].axial_force', "
        "log_uniform: {{from: 0.1 kN, to: 60 kN}}}}], responses: [",
        kDesigns - 1, kind, designed ? "screw" : "roller", designed ? 3.0 : 0.3);
    // Without responses of the contact fewer of its numbers are needed.
    const std::size_t count = std::size(kResponses) - (kind % 2 == 0 ? 4 : 0);
    for (std::size_t k = 0; k < count; ++k) {
      // Without this response no stiffness at the load is computed.
      if (kind % 3 == 0 && kResponses[k] == std::string_view("tangent_stiffness_N_per_um")) continue;
      text += fmt::format("{}'{}'", k == 0 ? "" : ", ", kResponses[k]);
    }
    return text + "]}\n";
  }

 private:
  static std::string metres(double x) { return fmt::format("{} m", x); }
  static std::string profile(const contact::Thread& t) {
    if (t.profile_curvature == 0.0) return "straight";
    return fmt::format("{{{}: {}}}", t.profile_curvature > 0.0 ? "convex" : "concave",
                       metres(std::abs(1.0 / t.profile_curvature)));
  }

  contact::test::RandomMechanisms usual_, others_;
  int next_ = 0;
};

/// Results of the scalar chain for one design.
struct Expected {
  DesignStatus status;
  std::vector<double> row;
};

Expected expected(const input::StudyInput& in, std::size_t design, const std::vector<ResultNumber>& numbers) {
  Expected e;
  try {
    const Case c = DesignReader(in).read(design);
    const Result result = analyze(c, kManyDesigns);
    for (const ResultNumber& number : numbers)
      e.row.push_back(*number.value({result.contacts, &result.load_cases[number.load_case.value_or(0)]}));
    for (const LoadCaseResult& load : result.load_cases)
      if (!load.converged()) e.status = {"not converged", ""};
  } catch (const input::InputError& error) {
    e.status = {"refused", error.what()};
  } catch (const CaseError& error) {
    e.status = {"refused", fmt::format("{}: {}", error.path(), error.what())};
  }
  return e;
}

TEST(DesignColumns, GiveTheRowsOfTheScalarChain) {
  SKIP_UNDER_SANITIZERS();
  using enum simd::InstructionSet;
  RandomStudies studies(11);
  double worst = 0.0;
  std::size_t converged = 0, refused = 0;
  std::set<std::vector<bool>> kinds;  // designs with a contact
  const int count = test::samples(96, 100'000 / kDesigns);
  for (int s = 0; s < count; ++s) {
    const std::string text = studies.next();
    SCOPED_TRACE(text);
    const input::StudyInput in = input::read_study_input({"case.yaml", text, {}});
    std::vector<ResultNumber> numbers;
    for (const std::string& path : in.study.responses) numbers.push_back(*result_number(path));
    std::vector<Expected> rows;
    for (std::size_t k = 0; k < kDesigns; ++k) rows.push_back(expected(in, k, numbers));
    for (const simd::InstructionSet set : {scalar, baseline, avx2, avx512}) {
      if (!simd::available(set)) continue;
      const RowBlock block = DesignEngine(in, set).evaluate(0, kDesigns);
      auto failure = block.failures.begin();
      for (std::size_t k = 0; k < kDesigns; ++k) {
        const bool failed = failure != block.failures.end() && failure->row == k;
        ASSERT_EQ(failed, !rows[k].status.converged()) << k << " " << rows[k].status.reason;
        if (failed) {
          EXPECT_EQ(failure->status.reason, rows[k].status.reason) << k;
          ++failure;
          ++refused;
          continue;
        }
        ++converged;
        const auto has = [&](const char* words) { return text.find(words) != std::string::npos; };
        kinds.insert({has("standard"), has("plane: normal"), has("design"), has("roller: {convex")});
        for (std::size_t i = 0; i < numbers.size(); ++i) {
          const double value = block.responses[k * numbers.size() + i];
          const double wanted = rows[k].row[i];
          // A thread that is nearly open carries the rounding of the others.
          const bool of_one_thread = in.study.responses[i].back() == ']';
          const double scale = of_one_thread ? rows[k].row[i - 1] : wanted;
          const double difference = std::abs((value - wanted) / scale);
          worst = std::max(worst, difference);
          EXPECT_LE(difference, 1e-11) << simd::name(set) << ", design " << k << ", " << in.study.responses[i];
        }
      }
    }
    if (HasFailure()) return;
  }
  RecordProperty("largest_relative_difference", fmt::format("{:.1e}", worst));
  EXPECT_EQ(kinds.size(), 16U);
  EXPECT_GT(converged, refused);
  EXPECT_GT(refused, converged / 100);
}

void expect_no_memory_per_design(const std::string& model) {
  const input::StudyInput in = input::read_study_input(
      {"case.yaml",
       input::kAbevi + model +
           "study: {command: solve, plan: monte_carlo, samples: 2000, factors: [{path: "
           "mechanism.flank_angle, within: 3 %}, {path: structure.nut.outer_diameter, within: 3 "
           "%}, {path: 'load_cases[0].axial_force', log_uniform: {from: 0.45 kN, to: 45 kN}}], "
           "responses: [axial_displacement_um, nut.peak_pressure_MPa.max]}\n",
       {}});
  SCOPED_TRACE(model);
  test::expect_no_memory_per_design(DesignEngine(in));
}

TEST(DesignColumns, ADesignTakesNoMemory) {
  expect_no_memory_per_design("");
  expect_no_memory_per_design("model: {bodies: refined}\n");
}

}  // namespace
}  // namespace prs
