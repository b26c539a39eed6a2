#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/model/warning.h"
#include "prs/sector/influence/influence_solver.h"
#include "prs/slip/slip.h"
#include "support/coarse_bodies.h"
#include "support/sectors.h"
#include "support/sum.h"

namespace prs {
namespace {

using nlohmann::json;
using test::SectorCase;
using test::sum;

/// Solved cases of an independent program.
const json& guided_cases() {
  static const json all = json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/sector/guides_cases.json"));
  return all;
}

/// The screw of the cases with nominal normals, or with different normals, which load the guides more.
json guided(const char* clearance, bool skew = false, const char* stiffness = "2e7 N/m") {
  json c = guided_cases()[skew ? 3 : 1]["case"];
  json& guidance = c["structure"]["roller"]["guidance"];
  guidance = {{"ring", stiffness}};
  if (*clearance) guidance["clearance"] = clearance;
  return c;
}

LoadCaseResult solved(const json& c, Solver solver = Solver::sparse) {
  LoadCaseResult r =
      analyze(input::read_case_text(c.dump(), "case", {}, Command::solve), {.solver = solver}).load_cases.at(0);
  EXPECT_TRUE(r.converged());
  return r;
}

double largest(const std::vector<double>& values) { return std::ranges::max(values); }

template <class Values>
void expect_near(const Values& values, const std::vector<double>& expected, double tolerance, double unit = 1.0) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(values[k] * unit, expected[k], tolerance) << k;
}

void expect_same_loads(const LoadCaseResult& a, const LoadCaseResult& b, double share) {
  for (const Interface i : kInterfaces)
    expect_near((*a.threads)[i].normal_load, (*b.threads)[i].normal_load, share * largest((*b.threads)[i].normal_load));
  EXPECT_NEAR(*a.axial_displacement, *b.axial_displacement, share * *b.axial_displacement);
  EXPECT_NEAR(*a.tangent_stiffness, *b.tangent_stiffness, 100.0 * share * *b.tangent_stiffness);
}

class SolvedGuides : public testing::TestWithParam<std::size_t> {};

TEST_P(SolvedGuides, Agree) {
  const json& given = guided_cases()[GetParam()];
  const json& e = given["expect"];
  for (const Solver solver : {Solver::chain, Solver::sparse}) {
    const LoadCaseResult r = solved(given["case"], solver);
    for (const Interface i : kInterfaces) {
      const std::vector<double> expected = e[std::string(name(i)) + "_normal_load_N"];
      expect_near((*r.threads)[i].normal_load, expected, 1e-8 * largest(expected));
    }
    EXPECT_NEAR(*r.axial_displacement * 1e6, e["axial_displacement_um"],
                1e-8 * e["axial_displacement_um"].get<double>());
  }
  const Case c = input::read_case_text(given["case"].dump(), "case", {}, Command::solve);
  const LoadCase& load = c.load_cases.at(0);
  const Contacts contacts = checked_contacts(c, Detail::numbers);
  SectorSolver solver(build_sector(contacts.mechanism, *c.structure, *c.materials, c.model, contact_laws(c, contacts),
                                   *load.direction, *load.position, c.deviations));
  solver.solve(load.axial_force);
  const GuideLoads guides = guide_loads(solver.sector(), solver.equations(), solver.state());
  expect_near(guides.displacement, e["guide_displacement_um"], 1e-7, 1e6);
  expect_near(guides.force, e["guide_force_N"], 1e-8 * 2e4);
  const LoadCaseResult r = solved(given["case"]);
  ASSERT_EQ(r.guides.size(), c.structure->roller.guidance.clearance > 0.0 ? 1u : 0u);
  if (!r.guides.empty()) expect_near(r.guides[0].force, e["guide_force_N"], 1e-8 * 2e4);
}

INSTANTIATE_TEST_SUITE_P(OfAnIndependentProgram, SolvedGuides, testing::Range(std::size_t{0}, std::size_t{4}));

/// Bodies and mechanisms that take a clearance in the same equations.
std::vector<json> models() {
  return {{{"bodies", "bars"}},
          {{"bodies", "refined"}},
          {{"bodies", "bars"}, {"mechanism", "full"}},
          {{"bodies", "refined"}, {"mechanism", "full"}}};
}

TEST(Guides, WithoutClearanceAreTheRing) {
  for (const bool skew : {false, true})
    for (const json& model : models()) {
      json absent = guided("", skew), zero = guided("0 um", skew), small = guided("1e-9 um", skew);
      for (json* c : {&absent, &zero, &small}) (*c)["model"] = model;
      const LoadCaseResult ring = solved(absent);
      expect_same_loads(solved(zero), ring, 1e-12);
      EXPECT_TRUE(ring.guides.empty());
      const LoadCaseResult nearly = solved(small);
      expect_same_loads(nearly, ring, 2e-9);
      EXPECT_FALSE(nearly.guides.empty());
    }
}

/// With equal normals the contacts alone hold the rollers across the axis.
TEST(Guides, BeyondEveryDisplacementAreNone) {
  SectorCase c = test::abevi();
  c.laws.screw.normal_angle = c.laws.nut.normal_angle = 45.0 * test::kDegree;
  for (const auto bodies : {&kBars, &kRefined}) {
    c.options.bodies = bodies;
    c.structure.roller.guidance = {Guidance::Kind::ring, 2e7, 1e-3};
    SectorSolver loose(c.build());
    c.structure.roller.guidance = {Guidance::Kind::ring, 1e-3, 0.0};
    SectorSolver free(c.build());
    const LoadDistribution a = loose.solve(45e3), b = free.solve(45e3);
    ASSERT_TRUE(a.solve.converged() && b.solve.converged());
    for (const Interface i : kInterfaces) expect_near(a.normal_load[i], b.normal_load[i], 1e-8 * 1e3);
    for (const double force : a.guides.at(0).force) EXPECT_EQ(force, 0.0);
  }
}

/// Checks the law at each guide, and the lateral forces of each roller.
void expect_balance(const std::vector<GuideLoads>& guides, RingGuide ring, double outwards, double tolerance) {
  double force = 0.0;
  for (const GuideLoads& g : guides)
    for (std::size_t k = 0; k < 4; ++k) {
      const double v = g.displacement[k], beyond = std::max(std::abs(v) - ring.clearance, 0.0);
      EXPECT_NEAR(g.force[k], v > 0.0 ? -ring.stiffness * beyond : ring.stiffness * beyond, 1e-9);
      force += g.force[k];
    }
  EXPECT_NEAR(force, -outwards, tolerance);
}

double outwards(const LoadCaseResult& r) {
  double force = 0.0;
  for (const Interface i : kInterfaces) {
    const InterfaceLoads& t = (*r.threads)[i];
    force += (i == Interface::screw ? 1.0 : -1.0) * std::sin(t.normal_angle) * sum(t.normal_load);
    if (t.friction) force += sum(t.friction->radial);
  }
  return force;
}

TEST(Guides, HoldTheRollersInBalance) {
  for (const char* clearance : {"0.1 um", "2 um", "4 um"})
    for (const json& model : models()) {
      json c = guided(clearance, true, "2e8 N/m");
      c["model"] = model;
      const LoadCaseResult r = solved(c);
      const std::size_t rollers = model.contains("mechanism") ? 11 : 1;
      ASSERT_EQ(r.guides.size(), rollers);
      const RingGuide ring = {2e8, std::stod(clearance) * 1e-6};
      expect_balance(r.guides, ring, outwards(r), 1e-6 * static_cast<double>(rollers));
    }
}

TEST(Guides, OfAllRollersAreThoseOfTheSector) {
  for (const char* bodies : {"bars", "refined"}) {
    json sector = guided("2 um", true, "2e8 N/m");
    sector["model"]["bodies"] = bodies;
    json full = sector;
    full["model"]["mechanism"] = "full";
    const LoadCaseResult one = solved(sector), all = solved(full);
    EXPECT_NEAR(*all.axial_displacement, *one.axial_displacement, 1e-9 * *one.axial_displacement);
    EXPECT_NEAR(*all.tangent_stiffness, *one.tangent_stiffness, 1e-8 * *one.tangent_stiffness);
    for (const GuideLoads& roller : all.guides)
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(roller.force[k], one.guides[0].force[k], 1e-5);
        EXPECT_NEAR(roller.displacement[k], one.guides[0].displacement[k], 1e-14);
      }
  }
}

TEST(Guides, TangentStiffnessIsTheSlopeOfTheLoad) {
  const auto displacement = [](double force) {
    json c = guided("1 um");
    c["load_cases"][0]["axial_force"] = fmt::format("{} N", force);
    return solved(c);
  };
  const double h = 10.0;
  const double slope =
      2.0 * h / (*displacement(45e3 + h).axial_displacement - *displacement(45e3 - h).axial_displacement);
  EXPECT_NEAR(*displacement(45e3).tangent_stiffness / slope, 1.0, 1e-7);
}

// Influence ----------------------------------------------------------------------------------

BodyFlexibilities coarse_bodies(const SectorCase& c, bool friction = false) {
  static MatrixCache cache;
  PerInterface<HertzPatch> patches;
  for (const Interface i : kInterfaces)
    patches[i] = nominal_patch({}, c.laws[i], c.materials[body_of(i)], c.materials.roller);
  BodyGeometry geometry = body_geometry(c.mechanism, c.structure, c.materials, c.laws, patches, c.direction, c.options);
  geometry.friction = friction;
  return body_flexibilities(geometry, c.direction, c.position, test::coarse_bodies(), cache);
}

InfluenceSolver influence(const SectorCase& c, bool friction = false) {
  return {coarse_bodies(c, friction), c.mechanism.rollers, c.laws, c.build().gaps};
}

SectorCase short_guided(double stiffness, double clearance) {
  SectorCase c = test::short_screw();
  c.structure.roller.guidance = {Guidance::Kind::ring, stiffness, clearance};
  c.laws.screw.normal_angle = 44.0 * test::kDegree;
  c.laws.nut.normal_angle = 46.0 * test::kDegree;
  return c;
}

/// Error of forces on patches of some width around the axis, which are not quite parallel [N].
constexpr double kPatches = 1.0;

TEST(Guides, OfMeshedBodiesTendToTheRing) {
  for (const double stiffness : {1e6, 2e7, 1e9}) {
    const LoadDistribution ring = influence(short_guided(stiffness, 0.0)).solve(12e3);
    const LoadDistribution loose = influence(short_guided(stiffness, 1e-15)).solve(12e3);
    ASSERT_TRUE(ring.solve.converged() && loose.solve.converged());
    for (const Interface i : kInterfaces)
      expect_near(loose.normal_load[i], ring.normal_load[i], 2e-8 * largest(ring.normal_load[i]));
    EXPECT_NEAR(*loose.tangent_stiffness, *ring.tangent_stiffness, 1e-7 * *ring.tangent_stiffness);
  }
}

TEST(Guides, OfMeshedBodiesHoldTheRollersInBalance) {
  for (const double stiffness : {2e7, 2e8})
    for (double clearance = 1e-8; clearance < 1e-4; clearance *= 1.2) {
      const SectorCase c = short_guided(stiffness, clearance);
      const LoadDistribution d = influence(c).solve(12e3);
      ASSERT_TRUE(d.solve.converged()) << clearance;
      const double out = std::sin(c.laws.screw.normal_angle) * sum(d.normal_load.screw) -
                         std::sin(c.laws.nut.normal_angle) * sum(d.normal_load.nut);
      expect_balance(d.guides, {stiffness, clearance}, out, kPatches);
    }
}

TEST(Guides, OfMeshedBodiesTakeFriction) {
  const SectorCase c = short_guided(2e7, 1e-6);
  const std::size_t threads = 6;
  RollerPush push{{std::vector(threads, 0.02), std::vector(threads, 0.01)},
                  {std::vector(threads, -0.05), std::vector(threads, 0.03)}};
  push.of_thread = 500.0;
  push.of_heads = 300.0;
  const double pitch = axial_pitch(c.mechanism);
  const LoadDistribution d = influence(c, true).solve(12e3, push, sense(c.direction), pitch);
  ASSERT_TRUE(d.solve.converged());
  const double out = (std::sin(c.laws.screw.normal_angle) - 0.05) * sum(d.normal_load.screw) -
                     (std::sin(c.laws.nut.normal_angle) - 0.03) * sum(d.normal_load.nut) + 500.0 * 6 * pitch +
                     300.0 * 2 * c.structure.roller.end_length;
  expect_balance(d.guides, {2e7, 1e-6}, out, kPatches);
}

// Running ------------------------------------------------------------------------------------

json running(const char* clearance, const json& model = {{"bodies", "bars"}}) {
  json all = json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/slip/running_cases.json"));
  json c = all["cases"][0]["input"];
  json& guidance = c["structure"]["roller"]["guidance"];
  guidance = {{"ring", "2e8 N/m"}};
  if (*clearance) guidance["clearance"] = clearance;
  c["model"].update(model);
  return c;
}

LoadCaseResult slipped(const json& c) {
  LoadCaseResult r = analyze_slip(input::read_case_text(c.dump(), "case", {}, Command::slip)).load_cases.at(0);
  EXPECT_TRUE(r.running && r.running->converged() && r.slip && r.slip->converged());
  return r;
}

TEST(Guides, OfARunningScrewHoldTheRollersInBalance) {
  for (const char* clearance : {"0.5 um", "3 um", "20 um"}) {
    const LoadCaseResult r = slipped(running(clearance));
    const double c = std::stod(clearance) * 1e-6;
    expect_balance(r.guides, {2e8, c}, outwards(r) + r.slip->forces.centrifugal, 1e-6);
    const auto ends = r.guides.at(0).of_ends();
    for (std::size_t h = 0; h < 2; ++h) EXPECT_NEAR(r.slip->heads[0][h].guide_force, ends[h], 1e-6);
  }
}

TEST(Guides, OfARunningScrewTendToTheRing) {
  const LoadCaseResult ring = slipped(running("")), loose = slipped(running("1e-9 um"));
  for (const Interface i : kInterfaces)
    expect_near((*loose.threads)[i].normal_load, (*ring.threads)[i].normal_load,
                1e-8 * largest((*ring.threads)[i].normal_load));
  for (std::size_t h = 0; h < 2; ++h)
    EXPECT_NEAR(loose.slip->heads[0][h].guide_force, ring.slip->heads[0][h].guide_force, 1e-4);
}

TEST(Guides, OfAllRunningRollersAreThoseOfTheSector) {
  const LoadCaseResult one = slipped(running("3 um")), all = slipped(running("3 um", {{"mechanism", "full"}}));
  ASSERT_GT(all.guides.size(), 1u);
  for (const GuideLoads& roller : all.guides)
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(roller.force[k], one.guides[0].force[k], 1e-4);
}

/// Both flanks of a single nut push one roller, those of a double nut two.
TEST(Guides, UnderPreloadHoldTheRollersInBalance) {
  json all = json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/slip/running_cases.json"));
  for (const char* loads : {"static", "running"})
    for (const bool two_nuts : {false, true}) {
      json c = all["cases"][3]["input"];
      c.erase("deviations");
      c["friction"] = {{"model", {{"coulomb", 0.1}}}};
      c["operation"] = {{"speed", "300 rpm"}};
      c["load_cases"][0]["axial_force"] = "1.5 kN";
      c["structure"]["roller"]["guidance"] = {{"ring", "2e8 N/m"}, {"clearance", "0.1 um"}};
      c["model"]["loads"] = loads;
      if (two_nuts)
        c["preload"].update(
            {{"arrangement", "double_nut"},
             {"distance", "60 mm"},
             {"spacer", {{"length", "20 mm"}, {"inner_diameter", "36 mm"}, {"outer_diameter", "46 mm"}}}});
      const LoadCaseResult r =
          analyze_slip(input::read_case_text(c.dump(), "case", {}, Command::slip)).load_cases.at(0);
      ASSERT_TRUE(r.converged() && r.other_flank);
      ASSERT_EQ(r.guides.size(), two_nuts ? 2u : 1u);
      double other = 0.0;
      for (const Interface i : kInterfaces)
        other += (i == Interface::screw ? 1.0 : -1.0) * std::sin((*r.threads)[i].normal_angle) *
                 sum(r.other_flank->threads[i].normal_load);
      if (r.running) continue;
      if (two_nuts) {
        expect_balance({r.guides[0]}, {2e8, 1e-7}, outwards(r), 1e-6);
        expect_balance({r.guides[1]}, {2e8, 1e-7}, other, 1e-6);
      } else {
        expect_balance(r.guides, {2e8, 1e-7}, outwards(r) + other, 1e-6);
      }
    }
}

/// The common part of N = F/(cos psi - mu sin psi) follows from the axial balance alone.
TEST(Guides, AreBlamedForWhatNormalLoadsHaveNotInCommon) {
  json c = running("0.1 um");
  c["friction"] = {{"model", {{"coulomb", 0.3}}}};
  const LoadCaseResult r = slipped(c);
  const InterfaceLoads& t = r.threads->screw;
  const double all = std::cos(t.normal_angle) * sum(t.normal_load) / sum(t.axial_load);
  const auto warning = std::ranges::find(r.warnings, "guides_with_clearance", &Warning::code);
  ASSERT_NE(warning, r.warnings.end());
  EXPECT_THAT(warning->what, testing::HasSubstr(fmt::format("by {:+.1f} %, which takes {:.0f} % of its life",
                                                            100.0 * (all - 1.0), 100.0 * (1.0 - std::pow(all, -3.0)))));
  EXPECT_THAT(sentence(*warning), testing::HasSubstr("ring with a clearance of 0.1 um"));
}

// Input --------------------------------------------------------------------------------------

std::string error_with(const json& c) {
  try {
    input::read_case_text(c.dump(), "case", {}, Command::solve);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "";
}

TEST(Guides, RefuseWhatIsNoClearance) {
  using testing::HasSubstr;
  EXPECT_THAT(error_with(guided("-1 um")), HasSubstr("structure.roller.guidance.clearance"));
  EXPECT_THAT(error_with(guided(".inf um")), HasSubstr("structure.roller.guidance.clearance"));
  json c = guided("");
  c["structure"]["roller"]["guidance"]["clearanc"] = "1 um";
  EXPECT_THAT(error_with(c), HasSubstr("clearance"));
  c["structure"]["roller"]["guidance"] = {{"clearance", "1 um"}};
  EXPECT_THAT(error_with(c), HasSubstr("structure.roller.guidance"));
  c = guided("1 um");
  c["model"] = {{"bodies", "influence"}, {"mechanism", "full"}};
  EXPECT_THAT(error_with(c), HasSubstr("expected 0; take `bodies: bars` or `refined`"));
}

}  // namespace
}  // namespace prs
