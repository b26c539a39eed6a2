#include "prs/model/check_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "tests/prs/input/abevi.h"

namespace prs {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;
using Texts = std::vector<std::string>;

const std::string kHertzGiven = "contact.hertz_constant={screw: 3.6062e5 N/mm^1.5, nut: 4.2140e5 N/mm^1.5}";
const std::string kAnglesGiven = "contact.normal_angle={screw: 45.0288 deg, nut: 45.0803 deg}";

Case abevi_case(Texts overrides) {
  overrides.push_back("load_cases=[{name: a, axial_force: 45 kN, direction: tension, position: 4 mm}]");
  return input::read_case_text(input::kAbevi, "test.yaml", overrides, Command::solve);
}

Texts void_paths(const Texts& overrides) {
  Texts paths;
  for (const VoidInput& input : void_inputs(abevi_case(overrides))) paths.push_back(input.path);
  return paths;
}

/// Loads, displacement and stiffness of a case.
std::vector<double> distribution(const Texts& overrides) {
  const LoadCaseResult r = analyze(abevi_case(overrides)).load_cases.at(0);
  EXPECT_TRUE(r.converged());
  std::vector<double> numbers{*r.axial_displacement, *r.axial_stiffness};
  for (const Interface i : kInterfaces)
    for (const double load : (*r.threads)[i].normal_load) numbers.push_back(load);
  return numbers;
}

/// A different value of an input that is void for some overrides.
Texts with_another(Texts overrides, const std::string& path) {
  const std::string value = path.starts_with("mechanism.flank_angle")     ? "44 deg"
                            : path.starts_with("mechanism.profile_plane") ? "axial"
                            : path == "mechanism.profile"
                                ? "{screw: {convex: 60 mm}, roller: {convex: 4.5 mm}, nut: straight}"
                            : path == "mechanism.profile.roller"    ? "{convex: 4.5 mm}"
                            : path.starts_with("mechanism.profile") ? "{convex: 60 mm}"
                            : path == "mechanism.centre_distance"   ? "14.005 mm"
                            : path == "mechanism.type"              ? "standard"
                            : path == "mechanism.starts.roller"     ? "2"
                                                                    : "0.2";
  overrides.push_back(path + "=" + value);
  return overrides;
}

TEST(VoidInputs, AreNoneWithoutOverrides) {
  EXPECT_THAT(void_paths({}), IsEmpty());
  EXPECT_THAT(void_paths({kAnglesGiven}), IsEmpty());  // The profile still gives k_0.
}

TEST(VoidInputs, OfBothConstantsAreWhatActsThroughTheContactAlone) {
  EXPECT_THAT(void_paths({kHertzGiven, kAnglesGiven}),
              UnorderedElementsAre("mechanism.flank_angle", "mechanism.profile", "mechanism.profile_plane",
                                   "mechanism.centre_distance", "mechanism.type", "mechanism.starts.roller",
                                   "materials.poisson_ratio"));
  EXPECT_THAT(void_paths({kHertzGiven}), ElementsAre("materials.poisson_ratio"));
  EXPECT_THAT(void_paths({kHertzGiven, "model.roller_shear=true"}), IsEmpty());
}

TEST(VoidInputs, OfOneInterfaceAreThoseOfItsBody) {
  EXPECT_THAT(
      void_paths({"contact.hertz_constant.nut=4.2e5 N/mm^1.5", "contact.normal_angle.nut=45 deg"}),
      UnorderedElementsAre("mechanism.flank_angle.nut", "mechanism.profile.nut", "materials.nut.poisson_ratio"));
}

/// Equal bit by bit: the same model of numbers is solved.
TEST(VoidInputs, MoveNoLoadAndNoStiffness) {
  for (const Texts& base : {Texts{kHertzGiven, kAnglesGiven}, Texts{kHertzGiven, kAnglesGiven, "model.bodies=refined"},
                            Texts{"contact.hertz_constant.screw=3.6e5 N/mm^1.5", "contact.normal_angle.screw=45 deg",
                                  "materials={screw: {youngs_modulus: 209 GPa, poisson_ratio: 0.3}, roller: "
                                  "{youngs_modulus: 209 GPa, poisson_ratio: 0.3}, nut: {youngs_modulus: 209 GPa, "
                                  "poisson_ratio: 0.3}}",
                                  "mechanism.flank_angle={screw: 45 deg, roller: 45 deg, nut: 45 deg}"}}) {
    const Texts paths = void_paths(base);
    EXPECT_GE(paths.size(), 3u);
    for (const std::string& path : paths) EXPECT_EQ(distribution(with_another(base, path)), distribution(base)) << path;
  }
}

TEST(VoidInputs, AreOnlyThose) {
  const Texts overridden{kHertzGiven, kAnglesGiven};
  for (const char* path :
       {"mechanism.flank_angle", "mechanism.profile", "mechanism.profile_plane", "mechanism.centre_distance",
        "mechanism.type", "mechanism.starts.roller", "materials.poisson_ratio"})
    EXPECT_NE(distribution(with_another({}, path)), distribution({})) << path;
  const Texts refined{kHertzGiven, kAnglesGiven, "model.bodies=refined"};
  EXPECT_NE(distribution(with_another(refined, "materials.poisson_ratio")), distribution(refined));
  const Texts teeth{kHertzGiven, kAnglesGiven, "model.tooth_compliance={yamamoto: 2 mm}"};
  EXPECT_THAT(void_paths(teeth),
              UnorderedElementsAre("mechanism.profile", "mechanism.profile_plane", "mechanism.centre_distance",
                                   "mechanism.type", "mechanism.starts.roller"));
  EXPECT_NE(distribution(with_another(teeth, "mechanism.flank_angle")), distribution(teeth));
}

TEST(VoidInputs, AreFoundByWhatLeadsIntoThem) {
  const std::vector<VoidInput> inputs{{"mechanism.profile", ""}, {"mechanism.flank_angle.nut", ""}};
  EXPECT_TRUE(find_void(inputs, "mechanism.profile"));
  EXPECT_TRUE(find_void(inputs, "mechanism.profile.roller.convex"));
  EXPECT_TRUE(find_void(inputs, "mechanism.flank_angle.nut"));
  EXPECT_FALSE(find_void(inputs, "mechanism.profile_plane"));
  EXPECT_FALSE(find_void(inputs, "mechanism.flank_angle"));
}

}  // namespace
}  // namespace prs
