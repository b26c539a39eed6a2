#include "validation/yao_2023/sensitivity.h"

#include <fmt/ranges.h>

#include "prs/indices.h"
#include "prs/loads/analyze.h"
#include "prs/study/sensitivity.h"
#include "validation/extensions.h"

namespace prs::yao_2023 {
namespace {

constexpr std::size_t kSamples = 2000;
constexpr double kRange = 0.03;

/// A varied input of tables A1 and A2; pitches, moduli and ratios are those of S, R, N.
struct Input {
  std::string_view name;
  void (*scale)(Case&, double);
};

template <Part part>
void scale_flank_angle(Case& c, double by) {
  c.mechanism.flank_angle[part] *= by;
}
template <Part part>
void scale_pitch(Case& c, double by) {
  c.mechanism.pitch[part] = by * axial_pitch(c.mechanism);
}
template <Part part>
void scale_modulus(Case& c, double by) {
  (*c.materials)[part].youngs_modulus *= by;
}
template <Part part>
void scale_ratio(Case& c, double by) {
  (*c.materials)[part].poisson_ratio *= by;
}

constexpr Input kInputs[] = {
    {"d_R0", [](Case& c, double by) { *c.mechanism.pitch_diameter.roller *= by; }},
    {"beta_S", scale_flank_angle<Part::screw>},
    {"beta_R", scale_flank_angle<Part::roller>},
    {"beta_N", scale_flank_angle<Part::nut>},
    {"P_S", scale_pitch<Part::screw>},
    {"P_R", scale_pitch<Part::roller>},
    {"P_N", scale_pitch<Part::nut>},
    {"E_S", scale_modulus<Part::screw>},
    {"E_R", scale_modulus<Part::roller>},
    {"E_N", scale_modulus<Part::nut>},
    {"nu_S", scale_ratio<Part::screw>},
    {"nu_R", scale_ratio<Part::roller>},
    {"nu_N", scale_ratio<Part::nut>},
    {"F", [](Case& c, double by) { c.load_cases[0].axial_force *= by; }},
};
constexpr std::size_t kInputCount = std::size(kInputs);

enum Response : std::size_t {
  kScrewStress,
  kNutStress,
  kScrewCurvature,
  kNutCurvature,
  kScrewRadius,
  kRollerRadiusAtScrew,
  kNutRadius,
  kRollerRadiusAtNut,
  kScrewAngle,
  kRollerAngleAtScrew,
  kNutAngle,
  kRollerAngleAtNut,
  kResponseCount
};

/// Normal load over axial load by (27) and (28), from the roller's nominal angle and radius.
double printed_load_ratio(const Mechanism& m) {
  const double helix =
      std::atan(m.pitch.roller.value_or(axial_pitch(m)) / (std::numbers::pi * *m.pitch_diameter.roller));
  return 1.0 / (std::cos(std::atan(std::tan(m.flank_angle.roller) * std::cos(helix))) * std::cos(helix));
}

/// Peak pressure, which grows with the cube root of the normal load.
double stress(const Case& c, const Result& result, Interface i, bool printed_load) {
  const double peak = (*result.load_cases[0].threads)[i].peak_pressure[0];
  if (!printed_load) return peak;
  const double right = 1.0 / std::cos(result.contacts.interfaces[i].normal_angle());
  return peak * std::cbrt(printed_load_ratio(c.mechanism) / right);
}

std::array<double, kResponseCount> responses(const Case& c, const Result& result, bool printed_load) {
  const auto& screw = result.contacts.interfaces.screw.geometry;
  const auto& nut = result.contacts.interfaces.nut.geometry;
  return {stress(c, result, Interface::screw, printed_load),
          stress(c, result, Interface::nut, printed_load),
          screw.relative.first + screw.relative.second,
          nut.relative.first + nut.relative.second,
          screw.point.radius_on_body,
          screw.point.radius_on_roller,
          nut.point.radius_on_body,
          nut.point.radius_on_roller,
          screw.point.angle_on_body,
          std::remainder(screw.point.angle_on_roller, 2.0 * std::numbers::pi),
          nut.point.angle_on_body,
          nut.point.angle_on_roller};
}

/// Contributions of the inputs to each response.
class Ranking {
 public:
  explicit Ranking(const LinearRegression& regression) : fits_(regression.fits()) {}

  /// Contribution [%], with the sign of the effect.
  double of(std::string_view input, Response response) const {
    const auto found = std::ranges::find(kInputs, input, &Input::name);
    const FactorEffect& e = item_at(fits_[response]->effects, found - std::begin(kInputs));
    return std::copysign(e.contribution_percent, e.coefficient);
  }
  std::vector<std::string> ranked(Response response) const {
    std::vector<std::string> names;
    for (const Input& input : kInputs) names.emplace_back(input.name);
    std::ranges::stable_sort(names, std::greater{},
                             [&](const std::string& name) { return std::abs(of(name, response)); });
    return names;
  }
  /// The first `count` contributions: `d_R0 -22.0, beta_R +17.3`.
  std::string listed(Response response, std::size_t count) const {
    std::vector<std::string> texts;
    for (const std::string& name : ranked(response))
      if (texts.size() < count) texts.push_back(fmt::format("{} {:+.2f}", name, of(name, response)));
    return fmt::format("{} %", fmt::join(texts, ", "));
  }

 private:
  std::vector<std::optional<LinearFit>> fits_;
};

/// Rankings with the normal load of equilibrium, and with that of (27).
struct Rankings {
  Ranking equilibrium, printed;
};

/// Rankings; samples whose threads do not touch within their heights are left out.
Rankings rankings(const Case& initial) {
  LinearRegression equilibrium(kInputCount, kResponseCount), printed(kInputCount, kResponseCount);
  Case middle = initial;
  middle.mechanism.profile.roller = {Profile::Shape::centred};
  std::array<double, kInputCount> x{};
  for (const auto k : up_to(kSamples)) {
    Case c = middle;
    for (const auto i : up_to(kInputCount)) {
      x[i] = 2.0 * latin_hypercube_number(1, i, k, kSamples) - 1.0;
      kInputs[i].scale(c, 1.0 + kRange * x[i]);
    }
    try {
      const Result result = analyze_contacts(c, Detail::numbers);
      equilibrium.add(x, responses(c, result, false));
      printed.add(x, responses(c, result, true));
    } catch (const CaseError&) {
      continue;
    }
  }
  return {Ranking(equilibrium), Ranking(printed)};
}

using Names = std::vector<std::string>;

/// Whether these inputs are the first ones, in any order.
bool leads(const Ranking& r, Response response, Names names) {
  Names first = r.ranked(response);
  first.resize(names.size());
  std::ranges::sort(first);
  std::ranges::sort(names);
  return first == names;
}

bool have_signs(const Ranking& r, Response response, const Names& positive, const Names& negative) {
  return std::ranges::all_of(positive, [&](const auto& n) { return r.of(n, response) > 0.0; }) &&
         std::ranges::all_of(negative, [&](const auto& n) { return r.of(n, response) < 0.0; });
}

/// Sum of the contributions of these inputs [%].
double together(const Ranking& r, Response response, const Names& names) {
  double sum = 0.0;
  for (const std::string& name : names) sum += std::abs(r.of(name, response));
  return sum;
}

Finding screw_angle_leads(const Ranking& r) {
  return {r.ranked(kScrewAngle)[0] == "beta_S" && r.ranked(kRollerAngleAtScrew)[0] == "beta_S" &&
              r.of("beta_S", kScrewAngle) > 0.0 && r.of("beta_S", kRollerAngleAtScrew) < 0.0,
          "screw: " + r.listed(kScrewAngle, 2) + "; roller: " + r.listed(kRollerAngleAtScrew, 2)};
}

Finding screw_angles_follow(const Ranking& r) {
  const Names five{"beta_S", "d_R0", "beta_R", "P_S", "P_R"};
  return {leads(r, kScrewAngle, five) && leads(r, kRollerAngleAtScrew, five),
          "screw: " + r.listed(kScrewAngle, 6) + "; roller: " + r.listed(kRollerAngleAtScrew, 6)};
}

constexpr double kLittle = 5.0;  // [%]

Finding screw_radii(const Ranking& r) {
  const Names three{"d_R0", "beta_R", "beta_S"};
  const double screw = together(r, kScrewRadius, three);
  const double roller = together(r, kRollerRadiusAtScrew, three);
  return {std::min(screw, roller) > 100.0 - kLittle,
          fmt::format("{:.1f} % on the screw, {:.1f} % on the roller (judged against 95)", screw, roller)};
}

Finding screw_radii_signs(const Ranking& r) {
  return {have_signs(r, kScrewRadius, {"beta_R"}, {"d_R0", "beta_S"}) &&
              have_signs(r, kRollerRadiusAtScrew, {"d_R0", "beta_S"}, {"beta_R"}),
          "screw: " + r.listed(kScrewRadius, 3) + "; roller: " + r.listed(kRollerRadiusAtScrew, 3)};
}

constexpr double kPoint = 1.0;  // Tolerance of a printed percentage.

Finding screw_curvature(const Ranking& r) {
  return {std::abs(r.of("d_R0", kScrewCurvature) + 50.08) < kPoint &&
              std::abs(r.of("beta_R", kScrewCurvature) - 39.23) < kPoint &&
              std::abs(r.of("beta_S", kScrewCurvature) - 9.00) < kPoint,
          r.listed(kScrewCurvature, 3) + " (judged to a point)"};
}

Finding nut_curvature(const Ranking& r) {
  return {std::abs(r.of("d_R0", kNutCurvature) + 53.13) < kPoint &&
              std::abs(r.of("beta_R", kNutCurvature) + 41.72) < kPoint &&
              std::abs(r.of("beta_N", kNutCurvature) - 4.07) < kPoint,
          r.listed(kNutCurvature, 3) + " (judged to a point)"};
}

Finding screw_stress_leaders(const Ranking& r) {
  const Names first = r.ranked(kScrewStress);
  return {first[0] == "beta_R" && first[1] == "d_R0" && have_signs(r, kScrewStress, {"beta_R"}, {"d_R0"}),
          r.listed(kScrewStress, 3)};
}

Finding load_as_moduli(const Ranking& r) {
  const double f = r.of("F", kScrewStress);
  double difference = 0.0;
  for (const char* modulus : {"E_S", "E_R"})
    difference = std::max(difference, std::abs(r.of(modulus, kScrewStress) - f));
  return {f > 0.0 && difference < 0.02 * f, fmt::format("F {:+.2f}, E_S {:+.2f}, E_R {:+.2f} % (judged to 2 % of them)",
                                                        f, r.of("E_S", kScrewStress), r.of("E_R", kScrewStress))};
}

Finding ratios_after_flank_angle(const Ranking& r) {
  const Names order = r.ranked(kScrewStress);
  const auto at = std::ranges::find(order, "beta_S") - order.begin();
  const Names ratios{"nu_S", "nu_R"};
  const bool follow = contains(ratios, order.at(static_cast<std::size_t>(at) + 1)) &&
                      contains(ratios, order.at(static_cast<std::size_t>(at) + 2));
  return {follow && have_signs(r, kScrewStress, ratios, {}), r.listed(kScrewStress, 8)};
}

Finding nut_angles(const Ranking& r) {
  const Names sequence{"P_N", "P_R", "d_R0", "beta_R", "beta_N"};
  bool holds = true;
  for (const Response response : {kNutAngle, kRollerAngleAtNut}) {
    holds =
        holds && leads(r, response, sequence) && have_signs(r, response, {"P_N", "d_R0", "beta_N"}, {"P_R", "beta_R"});
    for (std::size_t k = 1; k < sequence.size(); ++k)
      holds = holds && std::abs(r.of(sequence[k], response)) < std::abs(r.of(sequence[k - 1], response)) + 0.5;
  }
  return {holds, "nut: " + r.listed(kNutAngle, 5) + "; roller: " + r.listed(kRollerAngleAtNut, 5) +
                     " (judged to half a point)"};
}

Finding nut_radii(const Ranking& r) {
  bool holds = true;
  for (const Response response : {kNutRadius, kRollerRadiusAtNut})
    holds = holds && leads(r, response, {"d_R0", "beta_N", "beta_R"}) &&
            have_signs(r, response, {"d_R0", "beta_N", "P_N"}, {"beta_R", "P_R"});
  return {holds, "nut: " + r.listed(kNutRadius, 5) + "; roller: " + r.listed(kRollerRadiusAtNut, 5)};
}

Finding stresses_alike(const Ranking& r) {
  const Names first{"d_R0", "beta_R"};
  bool holds = leads(r, kScrewStress, first) && leads(r, kNutStress, first);
  for (const char* name : {"d_R0", "beta_R", "F", "E_R", "nu_R"})
    holds = holds && r.of(name, kScrewStress) * r.of(name, kNutStress) > 0.0;
  return {holds, "screw: " + r.listed(kScrewStress, 7) + "; nut: " + r.listed(kNutStress, 7)};
}

const Checks<Ranking> kChecks{
    {"screw_angle_leads", screw_angle_leads},
    {"screw_angles_follow", screw_angles_follow},
    {"screw_radii", screw_radii},
    {"screw_radii_signs", screw_radii_signs},
    {"screw_curvature", screw_curvature},
    {"screw_stress_leaders", screw_stress_leaders},
    {"load_as_moduli", load_as_moduli},
    {"ratios_after_flank_angle", ratios_after_flank_angle},
    {"nut_angles", nut_angles},
    {"nut_radii", nut_radii},
    {"nut_curvature", nut_curvature},
    {"stresses_alike", stresses_alike},
};

ValidationTable curvature_table(const Ranking& r) {
  ValidationTable table{"Figures 8(e), 9(e): contributions to the curvature sum, in %",
                        {"input", "screw, printed", "screw", "nut, printed", "nut"},
                        {},
                        2};
  const auto row = [&](std::string label, std::string_view screw, std::string_view nut, double printed_screw,
                       double printed_nut) {
    table.rows.push_back(
        {std::move(label),
         {printed_screw, std::abs(r.of(screw, kScrewCurvature)), printed_nut, std::abs(r.of(nut, kNutCurvature))}});
  };
  row("d_R0", "d_R0", "d_R0", 50.08, 53.13);
  row("beta_R", "beta_R", "beta_R", 39.23, 41.72);
  row("beta_S or beta_N", "beta_S", "beta_N", 9.00, 4.07);
  return table;
}

ValidationTable stress_table(const Rankings& r) {
  ValidationTable table{
      "Figures 8(f), 9(f): contributions to the contact stress with Q = F/|n_z| at the contact "
      "point and with Q of (27), in %",
      {"input", "screw", "screw, (27)", "nut", "nut, (27)"},
      {},
      2};
  for (const std::string& name : r.equilibrium.ranked(kScrewStress))
    table.rows.push_back({name,
                          {r.equilibrium.of(name, kScrewStress), r.printed.of(name, kScrewStress),
                           r.equilibrium.of(name, kNutStress), r.printed.of(name, kNutStress)}});
  return table;
}

using Json = nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180.0;

Json ellipse(const InterfaceContact& contact) {
  const double k = contact.hertz.ellipticity;
  return {{"eccentricity", std::sqrt((1.0 - k) * (1.0 + k))}};
}

/// Yao counts the roller's deflection at the screw from the line to the screw: pi - theta (25).
double deflection_at_screw(const contact::ContactPoint& point) {
  return std::remainder(std::numbers::pi - point.angle_on_roller, 2.0 * std::numbers::pi);
}

Json derived(const Result& result) {
  const PerInterface<InterfaceContact>& interfaces = result.contacts.interfaces;
  const contact::ContactPoint& at_screw = interfaces.screw.geometry.point;
  const double roller = deflection_at_screw(at_screw) * "deg"_per_si;
  const double body = at_screw.angle_on_body * "deg"_per_si;
  return {{"screw", ellipse(interfaces.screw)},
          {"nut", ellipse(interfaces.nut)},
          {"roller_deflection_at_screw_deg", roller},
          {"unsigned_at_screw_deg", {{"body", std::abs(body)}, {"roller", std::abs(roller)}}}};  // Table A4
}

/// A contact point as tables 2, A3 and A4 print it: radius [mm] and deflection [deg] on body and roller.
struct PrintedPoint {
  const char* label;
  double centre_distance;  ///< [mm]
  double side;             ///< Side of the roller's axis with the point: -1 at the screw, +1 at the nut.
  double body_radius, body_angle, roller_radius, roller_angle;
};

/// Components of the gap between the two printed points, (25) and (26), lines 3 and 4 [mm].
ValidationTable::Row closure(const PrintedPoint& p) {
  const double across =
      p.body_radius * std::sin(p.body_angle * kDegree) - p.roller_radius * std::sin(p.roller_angle * kDegree);
  const double along = p.body_radius * std::cos(p.body_angle * kDegree) -
                       p.side * p.roller_radius * std::cos(p.roller_angle * kDegree) - p.centre_distance;
  return {p.label, {across, along, std::hypot(across, along)}};
}

ValidationTable closure_of_printed_points() {
  ValidationTable table{
      "Tables 1, 2, A3 and A4: gap between the two printed contact points, which should be one, in mm",
      {"point", "across centres", "along centres", "distance"},
      {}};
  for (const PrintedPoint& p : {PrintedPoint{"initial, screw-roller", 32, -1, 24.1710, -3.6995, 8.0336, -11.2727},
                                PrintedPoint{"initial, nut-roller", 32, 1, 40, 0, 8, 0},
                                PrintedPoint{"optimum, screw-roller", 32, -1, 23.8722, -4.1559, 8.3843, -11.8005},
                                PrintedPoint{"optimum, nut-roller", 32, 1, 39.9948, -0.0090, 7.9434, -0.0242},
                                PrintedPoint{"A3, screw-roller", 32, -1, 24.0040, -4.0247, 8.2301, -11.6859},
                                PrintedPoint{"A3, screw-roller, FE", 32, -1, 24.0208, -4.0408, 8.2359, -11.6373},
                                PrintedPoint{"A3, nut-roller", 32, 1, 40.0840, -0.0121, 8.0871, 0.0242},
                                PrintedPoint{"A3, nut-roller, FE", 32, 1, 40.0897, -0.0139, 8.0774, 0.0299},
                                PrintedPoint{"A4, screw-roller", 13, -1, 9.8118, 3.6588, 3.2598, 11.6010},
                                PrintedPoint{"A4, screw-roller, [21]", 13, -1, 9.8173, 3.6605, 3.2635, 11.7030},
                                PrintedPoint{"A4, the same with 11.0730", 13, -1, 9.8173, 3.6605, 3.2635, 11.0730}})
    table.rows.push_back(closure(p));
  return table;
}

}  // namespace

Supplement sensitivity(const Case& initial, const Reference& paper) {
  const Rankings r = rankings(initial);
  const std::vector<Variant<Ranking>> variants{{"Q = F/|n_z|", r.equilibrium}, {"Q of (27)", r.printed}};
  return {.statements = compare(paper.statements, kChecks, variants),
          .tables = {curvature_table(r.equilibrium), stress_table(r)}};
}

SourceExtension extension() {
  return {.folder = "yao_2023",
          .derived = derived,
          .tables = [](auto&) { return std::vector{closure_of_printed_points()}; },
          .supplement = sensitivity};
}

}  // namespace prs::yao_2023
