#include "prs/slip/running.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "prs/input/reader.h"
#include "prs/slip/slip.h"

namespace prs {
namespace {

using nlohmann::json;

/// Solved cases of an independent program.
const json& solved_cases() {
  static const json all =
      json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/slip/running_cases.json"));
  return all["cases"];
}

json solved_case(const std::string& name) {
  for (const json& c : solved_cases())
    if (c["name"] == name) return c;
  throw std::invalid_argument(name);
}

/// The case of an input, its bearings' friction of Coulomb included.
Case running(json input) {
  json carrier = input.value("carrier", json::object());
  input.erase("carrier");
  Case c = input::read_case_text(input.dump(), "case", {}, Command::slip);
  c.model.loads = ModelOptions::Loads::running;
  if (carrier.contains("bearing")) {
    c.carrier.bearing = contact::JournalBearing{5e-3, 5e-3, 0.02e-3};
    c.carrier.head_friction = {HeadFriction::Model::coulomb, 0.08};
  }
  return c;
}

json base() { return solved_case("lesson-tension")["input"]; }

LoadCaseResult solved(const Case& c) { return analyze_slip(c).load_cases.at(0); }

double largest(const std::vector<double>& values) { return std::ranges::max(values); }

/// Within a share of the largest expected entry, or of `scale`.
void expect_near(const std::vector<double>& values, const json& expected, double share,
                 const char* what, double scale = 0.0, double unit = 1.0) {
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
      const RunningLoads::Friction& f = r.running->friction[i];
      const double most = largest(t.normal_load);
      expect_near(f.axial, e["friction_force_N"]["axial"], 1e-8, "axial", most);
      expect_near(f.radial, e["friction_force_N"]["radial"], 1e-8, "radial", most);
      expect_near(f.tangential, e["friction_force_N"]["tangential"], 1e-5, "tangential", most);
      EXPECT_NEAR(most / r.running->largest_static_load[i], e["running_over_static"], 1e-8);
      const json& s = expected["slip"][std::string(name(i))];
      expect_near(r.slip->threads[i].power, s["power_W"], 1e-6, "power");
      expect_near(r.slip->threads[i].dynamic_normal_load, s["dynamic_normal_load_N"], 1e-8,
                  "dynamic load");
    }
    const double rest = expected["static"][std::string(name(i))]["largest_normal_load_N"];
    EXPECT_NEAR(r.running->largest_static_load[i], rest, 1e-8 * rest);
  }
  if (expected.contains("axial_displacement_um"))
    EXPECT_NEAR(*r.axial_displacement * 1e6, expected["axial_displacement_um"], 1e-7);
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
    if (slip["heads"].contains("torque_Nmm"))
      near(s.heads.at(0)[h].torque * 1e3, slip["heads"]["torque_Nmm"][h]);
  }
}

INSTANTIATE_TEST_SUITE_P(Running, SolvedCase,
                         testing::Values("lesson-tension", "lesson-load-drives",
                                         "lesson-inverted-heads", "lesson-full"),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace prs
