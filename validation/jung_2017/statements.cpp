#include <fmt/ranges.h>

#include "prs/measures/stiffness.h"
#include "prs/slip/slip.h"
#include "validation/jung_2017/tables.h"

namespace prs::jung_2017 {
namespace {

using Numbers = std::vector<double>;

/// A screw of the thesis' sweeps.
struct Design {
  Diameters d;
  Threads t = {};
};

Diameters diameters_in_mm(double nut_outer, double screw, double roller) {
  return {nut_outer / per_si::millimetre, screw / per_si::millimetre, roller / per_si::millimetre};
}

/// Tables 3.6 to 3.9.
const Design kBase{diameters_in_mm(75.0, 37.5, 12.5)};

/// One dimension of tables 3.2 to 3.9, 4.2 to 4.9 with those that follow it.
struct Sweep {
  std::string unit;
  Numbers values;
  Design (*design)(double value);
};
const Sweep kNutOuter{
    "mm", {54, 57, 60, 63, 66, 69, 72, 75}, [](double mm) { return Design{diameters_in_mm(mm, 30, 10)}; }};
const Sweep kNutInner{
    "mm", {50, 55, 60, 65, 70}, [](double mm) { return Design{diameters_in_mm(75, 0.6 * mm, 0.2 * mm)}; }};
const Sweep kScrew{
    "mm", {25, 28, 31, 34, 37, 40, 43}, [](double mm) { return Design{diameters_in_mm(75, mm, mm / 3)}; }};
/// d_n = 62.5 mm as in table 3.6.
const Sweep kScrewInSameNut{
    "mm", {30, 33, 36, 39, 42, 45}, [](double mm) { return Design{diameters_in_mm(75, mm, 31.25 - mm / 2)}; }};
/// d_n = 70 mm; d_s = 15 to 42 mm in table 3.5 would not fit.
const Sweep kRoller{"mm", {5, 8, 10, 12, 14}, [](double mm) { return Design{diameters_in_mm(75, 70 - 2 * mm, mm)}; }};

Design with(double Threads::*member, double value) {
  Design design = kBase;
  design.t.*member = value;
  return design;
}
const Sweep kRollerCounts{"", {5, 7, 9, 11, 13, 15}, [](double n) { return with(&Threads::rollers, n); }};
const Sweep kPitches{"mm", {2, 4, 6, 8, 10, 15}, [](double mm) { return with(&Threads::pitch, mm * 1e-3); }};
const Sweep kStarts{"", {1, 3, 5, 10, 15}, [](double n) { return with(&Threads::starts, n); }};
const Sweep kLengths{"mm", {50, 100, 150, 200}, [](double mm) { return with(&Threads::length, mm * 1e-3); }};
const Sweep kHelixAngles{"deg", {1, 10, 20, 30, 45}, [](double degrees) {
                           Design design = kBase;
                           design.t.helix_angle = degrees / per_si::degree;
                           return design;
                         }};

/// The right formulas, or those with the slips that give tables 7.1 and 7.2.
struct Formulas {
  Measures (*measures)(const Diameters&, const Threads&) = corrected;
  bool lead_for_pitch = false;  ///< Whether bodies stretch over a lead between two threads, as in (4.1).
};

double stiffness(const Formulas& f, const Design& x) { return f.measures(x.d, x.t).stiffness; }
double capacity_of(const Formulas& f, const Design& x) { return f.measures(x.d, x.t).load_capacity; }
double force_density(const Formulas& f, const Design& x) { return f.measures(x.d, x.t).force_density(); }

/// Load of the first of 20 threads over their mean, by (4.1) in its right form, thrust on the same side; the same load
/// on the screw whatever its rollers.
double first_thread(const Formulas& f, const Design& x) {
  constexpr int kThreads = 20;
  constexpr double kModulus = 2.1e11;
  const double roller_force = kThreads * kBase.t.load * kBase.t.rollers / x.t.rollers;
  const double coefficient = right_compliance(x.d, x.t).hertz * std::cbrt(x.t.load);
  const auto area = [](double outer, double inner) { return std::numbers::pi / 4.0 * (outer * outer - inner * inner); };
  const double stretch = (f.lead_for_pitch ? x.t.lead() : x.t.pitch) * x.t.rollers / kModulus;
  const std::vector<ThreadGap> gaps(
      kThreads - 1, {stretch / area(x.d.screw, 0.0), 0.0, stretch / area(x.d.nut_outer, x.d.nut_inner())});
  return kThreads * yang_distribution(roller_force, coefficient, gaps).at(0) / roller_force;
}

using Quantity = double (*)(const Formulas&, const Design&);

Numbers over(const Sweep& sweep, Quantity quantity, const Formulas& f) {
  Numbers numbers;
  for (const double value : sweep.values) numbers.push_back(quantity(f, sweep.design(value)));
  return numbers;
}

/// Greatest over least.
double span(const Numbers& x) { return std::ranges::max(x) / std::ranges::min(x); }

bool grow(const Numbers& x) { return std::ranges::adjacent_find(x, std::greater_equal{}) == x.end(); }
bool shrink(const Numbers& x) { return std::ranges::adjacent_find(x, std::less_equal{}) == x.end(); }

/// `1, 1.2, 1.5 times from 2 to 15 mm`
std::string relative_text(const Sweep& sweep, const Numbers& x) {
  std::vector<std::string> texts;
  for (const double value : x) texts.push_back(fmt::format("{:.3g}", value / x.front()));
  return fmt::format("{} times from {:g} to {:g}{}", fmt::join(texts, ", "), sweep.values.front(), sweep.values.back(),
                     sweep.unit.empty() ? "" : " " + sweep.unit);
}

using Check = std::function<Finding(const Formulas&)>;

Check changes(const Sweep& sweep, Quantity quantity, bool (*as_said)(const Numbers&)) {
  return [=](const Formulas& f) {
    const Numbers x = over(sweep, quantity, f);
    return Finding{as_said(x), relative_text(sweep, x)};
  };
}

/// Whether a sweep changes the quantity less than each of the others does.
Check least_of(const Sweep& sweep, Quantity quantity, const std::vector<Sweep>& others) {
  return [=](const Formulas& f) {
    const double own = span(over(sweep, quantity, f));
    Numbers spans;
    for (const Sweep& other : others) spans.push_back(span(over(other, quantity, f)));
    return Finding{own < std::ranges::min(spans),
                   fmt::format("greatest over least {:.3g}; of the others {:.3g}", own, fmt::join(spans, ", "))};
  };
}

/// Falls first and rises then.
bool has_a_least_value_within(const Numbers& x) {
  const auto least = std::ranges::min_element(x);
  return least != x.begin() && least != x.end() - 1 && shrink({x.begin(), least + 1}) && grow({least, x.end()});
}

bool has_a_greatest_value_within(const Numbers& x) {
  const auto greatest = std::ranges::max_element(x);
  return greatest != x.begin() && greatest != x.end() - 1 && grow({x.begin(), greatest + 1}) &&
         shrink({greatest, x.end()});
}

bool ends_highest(const Numbers& x) { return std::ranges::max_element(x) == x.end() - 1; }

/// Within 2 % of the range from the line between the ends; values must be equidistant.
bool is_straight(const Numbers& x) {
  const double step = (x.back() - x.front()) / static_cast<double>(x.size() - 1);
  for (std::size_t k = 0; k < x.size(); ++k)
    if (std::abs(x[k] - x.front() - static_cast<double>(k) * step) > 0.02 * std::abs(x.back() - x.front()))
      return false;
  return true;
}

/// Rises, with less of the same step; the first five pitches are equidistant.
bool rises_less_and_less(const Numbers& x) {
  for (std::size_t k = 2; k < 5; ++k)
    if (x[k] - x[k - 1] >= x[k - 1] - x[k - 2]) return false;
  return grow(x);
}

/// Stiffness over the rows of table 7.1 or 7.2.
Check softens(std::array<Diameters, 10> (*rows)()) {
  return [=](const Formulas& f) {
    Numbers x;
    for (const Diameters& d : rows()) x.push_back(f.measures(d, {}).stiffness);
    return Finding{shrink(x), fmt::format("{:+.0f} % from D_n = 54 to 81 mm", 100.0 * (x.back() / x.front() - 1.0))};
  };
}

Finding heavier_and_weaker_in_case_2(const Formulas& f) {
  Numbers weight, capacity;
  for (std::size_t k = 1; k < 10; ++k) {
    const Measures one = f.measures(case_1()[k], {}), two = f.measures(case_2()[k], {});
    weight.push_back(two.weight / one.weight);
    capacity.push_back(two.load_capacity / one.load_capacity);
  }
  return {std::ranges::min(weight) > 1.0 && std::ranges::max(capacity) < 1.0,
          fmt::format("weight {:.3f} to {:.3f}, capacity {:.3f} to {:.3f} of case 1", weight.front(), weight.back(),
                      capacity.front(), capacity.back())};
}

// Tables 3.11 and 4.11 but for N_s, which the right formulas know as a helix angle alone; tables 5.4 and 6.3.
const std::vector<Sweep> kPrimary{kNutOuter, kNutInner, kScrew, kRoller, kPitches};
const std::vector<Sweep> kPrimaryOfCapacity{kNutInner, kScrew, kRoller, kPitches, kRollerCounts, kLengths};
const std::vector<Sweep> kPrimaryOfForceDensity{kNutInner, kScrew, kRoller, kPitches, kRollerCounts};

const Checks<Formulas> kFormulaChecks{
    {"stiffness_over_nut_outer", changes(kNutOuter, stiffness, grow)},
    {"stiffness_over_nut_inner", changes(kNutInner, stiffness, shrink)},
    {"stiffness_over_screw", changes(kScrew, stiffness, shrink)},
    {"stiffness_over_roller", changes(kRoller, stiffness, grow)},
    {"stiffness_over_rollers", least_of(kRollerCounts, stiffness, kPrimary)},
    {"stiffness_over_pitch", changes(kPitches, stiffness, grow)},
    {"stiffness_over_starts", changes(kStarts, stiffness, grow)},
    {"stiffness_over_helix_angle", least_of(kHelixAngles, stiffness, kPrimary)},
    {"loads_over_nut_outer", changes(kNutOuter, first_thread, shrink)},
    {"loads_over_nut_inner", changes(kNutInner, first_thread, ends_highest)},
    {"loads_over_screw", changes(kScrew, first_thread, has_a_least_value_within)},
    {"loads_over_roller", changes(kRoller, first_thread, grow)},
    {"loads_over_rollers", least_of(kRollerCounts, first_thread, kPrimary)},
    {"loads_over_pitch", changes(kPitches, first_thread, grow)},
    {"loads_over_starts", changes(kStarts, first_thread, grow)},
    {"loads_over_helix_angle", least_of(kHelixAngles, first_thread, kPrimary)},
    {"capacity_over_nut_inner", changes(kNutInner, capacity_of, grow)},
    {"capacity_over_screw", changes(kScrew, capacity_of, [](const Numbers& x) { return grow(x) && is_straight(x); })},
    {"capacity_over_screw_in_same_nut", changes(kScrewInSameNut, capacity_of, shrink)},
    {"capacity_over_roller", changes(kRoller, capacity_of, grow)},
    {"capacity_over_length", changes(kLengths, capacity_of, grow)},
    {"capacity_straight_over_length", changes(kLengths, capacity_of, is_straight)},
    {"capacity_over_rollers", changes(kRollerCounts, capacity_of, grow)},
    {"capacity_over_pitch", changes(kPitches, capacity_of, rises_less_and_less)},
    {"capacity_over_helix_angle", least_of(kHelixAngles, capacity_of, kPrimaryOfCapacity)},
    {"force_density_over_nut_inner", changes(kNutInner, force_density, grow)},
    {"force_density_over_screw", changes(kScrew, force_density, grow)},
    {"force_density_over_roller", changes(kRoller, force_density, has_a_greatest_value_within)},
    {"force_density_over_length", changes(kLengths, force_density, shrink)},
    {"force_density_over_rollers", changes(kRollerCounts, force_density, grow)},
    {"force_density_over_pitch", changes(kPitches, force_density, rises_less_and_less)},
    {"force_density_over_helix_angle", least_of(kHelixAngles, force_density, kPrimaryOfForceDensity)},
    {"softer_in_case_1", softens(case_1)},
    {"softer_in_case_2", softens(case_2)},
    {"heavier_and_weaker_in_case_2", heavier_and_weaker_in_case_2},
};

// Rules of Ma et al. -------------------------------------------------------------------------------

/// A screw at work.
struct Loaded {
  double normal_load = 0.0;  ///< Normal load of a contact with the screw [N].
  double approach = 0.0;     ///< Axial approach of the contacts, bodies rigid [m].
  double lost_power = 0.0;   ///< [W]
};

Loaded loaded(const Case& c) {
  const Result result = analyze_slip(c);
  const LoadCaseResult& r = result.load_cases.front();
  Loaded l{r.threads->screw.normal_load.front(), 0.0, r.slip->power.total()};
  for (const Interface i : kInterfaces)
    l.approach += (*r.threads)[i].approach.front() / std::cos(result.contacts.interfaces[i].normal_angle());
  return l;
}

Loaded with_force(Case c, double factor) {
  c.load_cases.front().axial_force *= factor;
  return loaded(c);
}
Loaded with_groove_angle(Case c, double degrees) {
  const double flank = degrees / 2.0 / per_si::degree;
  c.mechanism.flank_angle = {flank, flank, flank};
  return loaded(c);
}
Loaded with_threads(Case c, int threads) {
  c.mechanism.contacts_per_roller = threads;
  return loaded(c);
}
Loaded with_helix_angle(Case c, double degrees) {
  c.mechanism.lead = std::numbers::pi * *c.mechanism.pitch_diameter.screw * std::tan(degrees / per_si::degree);
  return loaded(c);
}

Finding stiffness_rises_with_load(const Case& c) {
  const double ratio = 4.0 * with_force(c, 1.0).approach / with_force(c, 4.0).approach;
  return {ratio > 1.0, fmt::format("{:.2f} times at four times the load, contacts alone", ratio)};
}

Finding friction_is_parabolic(const Case& c) {
  const double exponent = std::log(with_force(c, 4.0).lost_power / with_force(c, 1.0).lost_power) / std::log(4.0);
  return {std::abs(exponent - 2.0) < 0.5, fmt::format("lost power goes with load^{:.2f}", exponent)};
}

Finding groove_angle_halves_force_and_approach(const Case& c) {
  const Loaded wide = with_groove_angle(c, 130.0), narrow = with_groove_angle(c, 80.0);
  const double load = wide.normal_load / narrow.normal_load, approach = wide.approach / narrow.approach;
  return {std::lround(load) == 2 && std::lround(approach) == 2,
          fmt::format("contact force {:.2f} times, axial approach {:.2f} times as large at 130 deg (rounded)", load,
                      approach)};
}

Finding groove_angle_counts_threefold_for_friction(const Case& c) {
  const Loaded wide = with_groove_angle(c, 130.0), narrow = with_groove_angle(c, 80.0);
  const double load = wide.normal_load / narrow.normal_load;
  return {std::lround(load) == 3, fmt::format("friction forces {:.2f} times, lost power {:.2f} times as large at 130 "
                                              "deg (rounded)",
                                              load, wide.lost_power / narrow.lost_power)};
}

Finding small_helix_angles_hardly_count(const Case& c) {
  const Loaded none = with_helix_angle(c, 1.0), ten = with_helix_angle(c, 10.0);
  const double friction = ten.normal_load / none.normal_load - 1.0, approach = ten.approach / none.approach - 1.0;
  return {std::max(std::abs(friction), std::abs(approach)) < 0.05,
          fmt::format("from 1 to 10 deg friction forces {:+.1f} %, axial approach {:+.1f} % (compared with 5)",
                      100.0 * friction, 100.0 * approach)};
}

Finding threads_share_the_approach(const Case& c) {
  const Loaded few = with_threads(c, 10), many = with_threads(c, 40);
  const double power = many.lost_power / few.lost_power - 1.0, approach = few.approach / many.approach;
  return {std::abs(power) < 0.05 && std::lround(approach) == 3,
          fmt::format("from 10 to 40 threads lost power {:+.1f} %, axial approach {:.2f} times less, bodies rigid "
                      "(compared with 5 % and 3 rounded)",
                      100.0 * power, approach)};
}

const Checks<Case> kRules{
    {"stiffness_rises_with_load", stiffness_rises_with_load},
    {"friction_is_parabolic", friction_is_parabolic},
    {"groove_angle_halves_force_and_approach", groove_angle_halves_force_and_approach},
    {"groove_angle_counts_threefold_for_friction", groove_angle_counts_threefold_for_friction},
    {"small_helix_angles_hardly_count", small_helix_angles_hardly_count},
    {"threads_share_the_approach", threads_share_the_approach},
};

}  // namespace

std::vector<ComparedStatement> compare_statements(const Case& screw, const Reference& thesis) {
  std::vector<ComparedStatement> all = compare(
      thesis.statements, kFormulaChecks,
      std::vector<Variant<Formulas>>{{"right formulas", {}}, {"the slips of tables 7.1 and 7.2", {as_printed, true}}});
  std::ranges::move(compare(thesis.statements, kRules, std::vector<Variant<Case>>{{"table 3.1", screw}}),
                    std::back_inserter(all));
  return all;
}

}  // namespace prs::jung_2017
