// Grooved bodies, harmonic 0 and single harmonics, compared with CalculiX for the same bodies
// (validation/reference_fe/SOURCE.md): same teeth, loads, supports; another program, other meshes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <tuple>

#include "prs/sector/influence/teeth.h"
#include "prs/validation/validate.h"
#include "support/count.h"
#include "support/sanitized.h"

namespace prs {
namespace {

using std::numbers::pi;

constexpr int kTeeth = 20, kRollers = 11;
constexpr double kPitch = 5e-3 / 3;
const fe::Isotropic kElasticSteel{209e9, 0.3};
const HertzPatch kScrewPatch{0.22077e-3, 0.22077e-3}, kNutPatch{0.20285e-3, 0.20285e-3};

/// Rows of numbers [m/N]; the file has mm/N.
Eigen::MatrixXd reference(const std::string& name) {
  std::ifstream in(PRS_SOURCE_DIR "/validation/reference_fe/data/" + name);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    std::vector<double>& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
  }
  Eigen::MatrixXd m(rows.size(), rows.empty() ? 0 : rows.front().size());
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j)
      m(i, j) = 1e-3 * rows[static_cast<std::size_t>(i)].at(static_cast<std::size_t>(j));
  return m;
}

Groove groove(bool internal, double pitch_radius) {
  return {internal, kPitch, pitch_radius, 0.25e-3, 0.30e-3, pi / 4.0, pi / 4.0};
}

MeshDensity density(int split) {
  MeshDensity d;
  d.growth = 1.4;
  d.step_cell = 0.02;
  d.plain_flank_cells = 3;
  d.split = split;
  return d;
}

std::vector<LoadedFlank> flanks(double first, FlankSide side, const HertzPatch& patch) {
  std::vector<LoadedFlank> f;
  for (int k = 0; k < kTeeth; ++k) f.push_back({first + k * kPitch, side, patch, 4});
  return f;
}

std::vector<int> nodes_of(const std::vector<fe::MeridianEdge>& edges) {
  std::vector<int> nodes;
  for (const fe::MeridianEdge& e : edges) nodes.insert(nodes.end(), e.begin(), e.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

double radius(const GroovedBody& body, int node) { return body.mesh.nodes[static_cast<std::size_t>(node)].x(); }

Eigen::MatrixXd held_axially(const GroovedBody& body, const std::vector<int>& nodes) {
  std::vector<fe::HarmonicSupport> supports;
  for (const int node : nodes) supports.push_back({node, fe::Component::axial});
  fe::HarmonicBody solver(body.mesh, kElasticSteel, 0, supports);
  EXPECT_EQ(solver.factorize(0), fe::FactorizationStatus::ok);
  const Eigen::MatrixXd loads = patch_loads(body, 0);
  return loads.transpose() * solver.solve(loads);
}

Eigen::MatrixXd screw(FlankSide side, int split) {
  const double first = 10e-3 + (side == FlankSide::backward ? 0.25 : -0.25) * kPitch;
  GroovedShape s;
  s.groove = groove(false, 10.5e-3);
  s.ridge = first;
  s.ridges = {first, first + (kTeeth - 1) * kPitch};
  s.end = s.ridges->second + 0.5 * kPitch;
  s.far_radius = 3e-3;
  const GroovedBody body = mesh_grooved_body(s, flanks(first, side, kScrewPatch), density(split));
  return kRollers * held_axially(body, nodes_of(body.section(0.0)));
}

/// `shoulder`: radius up to which the face presses in the reference.
Eigen::MatrixXd nut(double position, double shoulder, int split) {
  const double first = position - 0.25 * kPitch;
  GroovedShape s;
  s.groove = groove(true, 17.5e-3);
  s.ridge = first;
  s.ridges = {first, first + (kTeeth - 1) * kPitch};
  s.end = 90e-3;
  s.far_radius = 23e-3;
  s.collars = {{0.0, 10e-3, 31e-3}, {80e-3, 90e-3, 31e-3}};
  s.radii = {shoulder};
  const GroovedBody body = mesh_grooved_body(s, flanks(first, FlankSide::forward, kNutPatch), density(split));
  std::vector<int> held = nodes_of(body.free_face(10e-3));
  std::erase_if(held, [&](int node) { return radius(body, node) > shoulder + 1e-9; });
  return kRollers * held_axially(body, held);
}

/// Response to forces in balance, which does not depend on where the roller is held axially.
Eigen::MatrixXd balanced(const Eigen::MatrixXd& roller) {
  Eigen::VectorXd axial(2 * kTeeth);
  axial << Eigen::VectorXd::Ones(kTeeth), -Eigen::VectorXd::Ones(kTeeth);
  axial.normalize();
  const Eigen::MatrixXd p = Eigen::MatrixXd::Identity(2 * kTeeth, 2 * kTeeth) - axial * axial.transpose();
  return p * roller * p;
}

Eigen::MatrixXd roller(int split) {
  GroovedShape s;
  s.groove = groove(false, 3.5e-3);
  s.start = -0.5 * kPitch;
  s.end = (kTeeth - 0.5) * kPitch;
  s.plain_end = PlainEnd{5e-3, 2.5e-3};
  std::vector<LoadedFlank> loaded = flanks(0.0, FlankSide::forward, kScrewPatch);
  for (const LoadedFlank& f : flanks(0.0, FlankSide::backward, kNutPatch)) loaded.push_back(f);
  const GroovedBody body = mesh_grooved_body(s, loaded, density(split));
  std::vector<int> axis = nodes_of(body.section(s.end));
  std::erase_if(axis, [&](int node) { return radius(body, node) > 1e-9; });
  return balanced(held_axially(body, axis));
}

double largest_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

TEST(CalculixBodies, AgreeOnOneMesh) {
  SKIP_UNDER_SANITIZERS();
  EXPECT_LT(largest_difference(screw(FlankSide::backward, 1), reference("screw_tension.csv")), 2e-3);
  EXPECT_LT(largest_difference(screw(FlankSide::forward, 1), reference("screw_compression.csv")), 2e-3);
  EXPECT_LT(largest_difference(nut(175e-3 / 6, 25.03e-3, 1), reference("nut_config2.csv")), 5e-3);
  EXPECT_LT(largest_difference(roller(1), balanced(reference("roller_tension.csv"))), 4e-3);
}

/// Three meshes, cells halved twice, extrapolated with the ratio of their changes.
template <class Body>
Eigen::MatrixXd limit(Body body) {
  const Eigen::MatrixXd coarse = body(1), middle = body(2), fine = body(4);
  const double ratio = (middle - coarse).norm() / (fine - middle).norm();
  return fine + (fine - middle) / (ratio - 1.0);
}

TEST(CalculixBodies, AgreeInTheLimit) {
  if (test::count(0, 1) == 0) GTEST_SKIP() << "only in the thorough run";
  // The reference's own error bars are 2e-5 for the screw, 3e-4 for the roller.
  EXPECT_LT(
      largest_difference(limit([](int n) { return screw(FlankSide::backward, n); }), reference("screw_tension.csv")),
      3e-5);
  EXPECT_LT(
      largest_difference(limit([](int n) { return screw(FlankSide::forward, n); }), reference("screw_compression.csv")),
      3e-5);
  // The ends of the shoulder, where the support stops, slow the convergence of both: order 0.7 to 0.9.
  EXPECT_LT(largest_difference(limit([](int n) { return nut(175e-3 / 6, 25.03e-3, n); }), reference("nut_config2.csv")),
            3e-4);
  EXPECT_LT(largest_difference(limit([](int n) { return roller(n); }), balanced(reference("roller_tension.csv"))),
            5e-4);
}

/// One body of the single harmonics: its teeth and the loads on each.
struct Block {
  Groove groove;
  double far_radius = 0.0;
  std::vector<LoadedFlank> flanks;
};

/// A line load without the Bessel factor of an ellipse: as narrow around the axis as possible.
LoadedFlank line(FlankSide side, double along_profile) { return {0.0, side, {along_profile, 1e-9}, 12}; }

Block block(const std::string& body) {
  const LoadedFlank at_nut = line(FlankSide::backward, 0.2028526e-3);
  if (body == "screw") return {groove(false, 10.5e-3), 3e-3, {line(FlankSide::backward, 0.2207669e-3)}};
  if (body == "nut") return {groove(true, 17.5e-3), 23e-3, {line(FlankSide::forward, 0.2028526e-3)}};
  return {groove(false, 3.5e-3), 0.0, {line(FlankSide::forward, 0.2207669e-3), at_nut}};
}

TEST(CalculixHarmonics, AgreeToATenthOfAPercent) {
  SKIP_UNDER_SANITIZERS();
  const CsvTable table(PRS_SOURCE_DIR "/validation/reference_fe/data/single_harmonics.csv");
  FlexibilityOptions options;
  options.mesh.patch_cells = 12;
  options.mesh.growth = 1.2;
  options.neighbour_patch_cells = 12;
  const Material steel{209e9, 0.3, {}};
  std::map<std::tuple<std::string, int, int>, BlockResponse> responses;
  std::map<std::tuple<std::string, int>, double> largest;
  const auto at = [&](std::size_t row, const char* name) { return table.text(row, table.column(name)); };
  const auto number = [&](std::size_t row, const char* name) { return table.number(row, table.column(name)); };
  for (std::size_t row = 0; row < table.rows(); ++row) {
    double& most = largest[{at(row, "body"), static_cast<int>(number(row, "harmonic"))}];
    most = std::max(most, std::abs(number(row, "value_mm_per_N")));
  }
  ASSERT_GE(table.rows(), 40u);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string body = at(row, "body");
    const int n = static_cast<int>(number(row, "harmonic"));
    const int teeth = static_cast<int>(number(row, "teeth"));
    const Block b = block(body);
    auto found = responses.find({body, n, teeth});
    if (found == responses.end()) {
      BlockSolver solver({b.groove, b.far_radius, steel, b.flanks, {}, 0, 1, 1, options});
      found = responses.emplace(std::tuple(body, n, teeth), solver.solve(n, (teeth - 1) / 2)).first;
    }
    const auto index = [&](const char* column) {
      const bool forward = at(row, column) == "forward";
      return b.flanks.size() == 1 || forward ? 0 : 1;
    };
    const int distance = static_cast<int>(number(row, "distance"));
    const BlockResponse& r = found->second;
    const double computed =
        r.kernel[static_cast<std::size_t>(distance + r.reach)](index("flank_to"), index("flank_from"));
    const double most = largest.at({body, n});
    EXPECT_NEAR(1e3 * computed, number(row, "value_mm_per_N"), 1e-3 * most) << body << " " << n << " " << distance;
  }
}

}  // namespace
}  // namespace prs
