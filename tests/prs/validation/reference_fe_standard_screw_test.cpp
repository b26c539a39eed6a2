#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "tests/support/count.h"
#include "tests/support/sanitized.h"

namespace prs::reference_fe {
namespace {

using nlohmann::json;

/// The screw of lesson 5 in tension with ring-shaped teeth, as in the finite elements.
LoadCaseResult computed(const std::string& bodies, bool flange_at_end) {
  std::vector<std::string> overrides{"model.bodies=" + bodies, "model.roller_contacts=half_pitch_apart",
                                     "load_cases=[{name: tension, axial_force: 60 kN, direction: tension, "
                                     "position: 16 mm}]"};
  if (flange_at_end) {
    overrides.push_back("structure.nut.flanges=[{from: 0 mm, to: 20 mm, outer_diameter: 98 mm}]");
    overrides.push_back("structure.nut.thrust={tension: 0 mm, compression: 20 mm}");
    overrides.push_back("structure.nut.shoulder={inner_diameter: 66 mm, outer_diameter: 98 mm}");
  }
  const Case c = input::read_case(PRS_SOURCE_DIR "/configs/05_standard_screw.yaml", overrides, Command::solve);
  return analyze(c).load_cases.at(0);
}

/// Limits are the differences found: they describe the gap and are not a tolerance. The elements' own meshes leave 0.1
/// % of the displacement and 0.002 percentage points of any load.
TEST(StandardScrewReference, ModelsAreThisFarFromFiniteElements) {
  SKIP_UNDER_SANITIZERS();
  const json reference = json::parse(std::ifstream(PRS_SOURCE_DIR "/validation/reference_fe/data/lesson_5.json"));
  struct Gap {
    const char* bodies;
    bool flange_at_end;
    double displacement;  ///< Displacement over that of the finite elements.
    double load;          ///< Largest difference of a thread's load, in percent of a roller's.
  };
  const Gap gaps[] = {{"bars", false, 0.7905, 0.700},      {"bars", true, 0.7836, 0.446},
                      {"refined", false, 0.9693, 0.315},   {"refined", true, 0.9742, 0.446},
                      {"influence", false, 0.9934, 0.047}, {"influence", true, 0.9937, 0.045}};
  for (const Gap& gap : gaps) {
    // This case takes seconds.
    if (gap.flange_at_end && std::string(gap.bodies) == "influence" && !test::thorough()) continue;
    SCOPED_TRACE(std::string(gap.bodies) + (gap.flange_at_end ? ", flange at the end" : ", flange in the middle"));
    const json& wanted = reference[gap.flange_at_end ? "flange at the end" : "flange in the middle"]["limit"];
    const LoadCaseResult got = computed(gap.bodies, gap.flange_at_end);
    EXPECT_NEAR(*got.axial_displacement * 1e6 / wanted["axial_displacement_um"].get<double>(), gap.displacement,
                0.0005);
    double largest = 0.0;
    for (const Interface i : kInterfaces) {
      const json& loads = wanted[i == Interface::screw ? "screw_load_rate_percent" : "nut_load_rate_percent"];
      for (std::size_t k = 0; k < loads.size(); ++k)
        largest = std::max(largest, std::abs(100.0 * (*got.threads)[i].load_rate[k] - loads[k].get<double>()));
    }
    EXPECT_NEAR(largest, gap.load, 0.001);
  }
}

}  // namespace
}  // namespace prs::reference_fe
