#include "validation/jung_2017/statements.h"

#include <fmt/ranges.h>

#include <sstream>

#include "prs/indices.h"
#include "prs/measures/stiffness.h"
#include "prs/slip/slip.h"

namespace prs::jung_2017 {
namespace {

using Numbers = std::vector<double>;

/// A screw of the thesis' sweeps; by default of tables 3.6 to 3.9. Diameters in mm.
struct Design {
  double nut_outer = 75.0, screw = 37.5, roller = 12.5;
  Threads threads = {};

  Diameters diameters() const { return {nut_outer / "mm"_per_si, screw / "mm"_per_si, roller / "mm"_per_si}; }
};

/// One dimension of tables 3.2 to 3.9 and 4.2 to 4.9, or the rows of table 7.1 or 7.2, with dependent dimensions.
struct Sweep {
  std::string unit;
  Numbers values;
  Design (*design)(double value);
};

const std::map<std::string, Sweep> kSweeps{
    {"nut_outer",
     {" mm",
      {54, 57, 60, 63, 66, 69, 72, 75},
      [](double mm) {
        return Design{mm, 30, 10};
      }}},
    {"nut_inner",
     {" mm",
      {50, 55, 60, 65, 70},
      [](double mm) {
        return Design{75, 0.6 * mm, 0.2 * mm};
      }}},
    {"screw",
     {" mm",
      {25, 28, 31, 34, 37, 40, 43},
      [](double mm) {
        return Design{75, mm, mm / 3};
      }}},
    {"screw_in_same_nut",
     {" mm",
      {30, 35, 40, 45},
      [](double mm) {
        return Design{75, mm, 31.25 - mm / 2};
      }}},
    // d_n = 70 mm; d_s = 15 to 42 mm in table 3.5 would not fit.
    {"roller",
     {" mm",
      {5, 8, 10, 12, 14},
      [](double mm) {
        return Design{75, 70 - 2 * mm, mm};
      }}},
    {"rollers", {"", {5, 7, 9, 11, 13, 15}, [](double n) { return Design{.threads = {.rollers = n}}; }}},
    {"pitch", {" mm", {2, 4, 6, 8, 10, 15}, [](double mm) { return Design{.threads = {.pitch = mm * 1e-3}}; }}},
    {"starts", {"", {1, 3, 5, 10, 15}, [](double n) { return Design{.threads = {.starts = n}}; }}},
    {"length", {" mm", {50, 100, 150, 200}, [](double mm) { return Design{.threads = {.length = mm * 1e-3}}; }}},
    {"helix_angle",
     {" deg",
      {1, 10, 20, 30, 45},
      [](double degrees) { return Design{.threads = {.helix_angle = degrees / "deg"_per_si}}; }}},
    {"case_1",
     {" mm",
      {54, 60, 66, 72, 78},
      [](double mm) {
        return Design{mm, mm / 2, mm / 3 - 9};
      }}},
    {"case_2",
     {" mm",
      {54, 60, 66, 72, 78},
      [](double mm) {
        return Design{mm, mm / 2, mm / 6};
      }}},
};

/// The right formulas, or those with the slips that give tables 7.1 and 7.2.
struct Formulas {
  Measures (*measures)(const Diameters&, const Threads&) = corrected;
  bool lead_for_pitch = false;  ///< Whether bodies stretch over a lead between two threads, as in (4.1).

  Measures of(const Design& x) const { return measures(x.diameters(), x.threads); }
};

/// Load of the first of 20 threads over their mean, by (4.1) corrected, thrust on the same side; the same load on the
/// screw for any rollers.
double first_thread(const Formulas& f, const Design& x) {
  constexpr int kCount = 20;
  const Threads& t = x.threads;
  const Diameters d = x.diameters();
  const double roller_force = kCount * t.load * kRollers / t.rollers;
  const double coefficient = right_compliance(d, t).hertz * std::cbrt(t.load);
  const auto stretch = [&](double outer, double inner) {
    return (f.lead_for_pitch ? t.lead() : t.pitch) * t.rollers /
           (2.1e11 * std::numbers::pi / 4.0 * (outer * outer - inner * inner));
  };
  const std::vector<ThreadGap> gaps(kCount - 1, {stretch(d.screw, 0.0), 0.0, stretch(d.nut_outer, d.nut_inner())});
  return kCount * yang_distribution(roller_force, coefficient, gaps).at(0) / roller_force;
}

const std::map<std::string, double (*)(const Formulas&, const Design&)> kQuantities{
    {"stiffness", [](const Formulas& f, const Design& x) { return f.of(x).stiffness; }},
    {"first_thread", first_thread},
    {"capacity", [](const Formulas& f, const Design& x) { return f.of(x).load_capacity; }},
    {"force_density", [](const Formulas& f, const Design& x) { return f.of(x).force_density(); }},
    {"weight_to_case_1",
     [](const Formulas& f, const Design& x) {
       return f.of(x).weight / f.of(kSweeps.at("case_1").design(x.nut_outer)).weight;
     }},
};

/// Tables 3.11, 4.11, 5.4 and 6.3: primary parameters of a quantity; without N_s, which enters the right formulas only
/// as a helix angle.
const std::map<std::string, std::vector<std::string>> kPrimary{
    {"stiffness", {"nut_outer", "nut_inner", "screw", "roller", "pitch"}},
    {"first_thread", {"nut_outer", "nut_inner", "screw", "roller", "pitch"}},
    {"capacity", {"nut_inner", "screw", "roller", "pitch", "rollers", "length"}},
    {"force_density", {"nut_inner", "screw", "roller", "pitch", "rollers"}}};

bool grows(const Numbers& x) { return std::ranges::adjacent_find(x, std::greater_equal{}) == x.end(); }
bool falls(const Numbers& x) { return grows({x.rbegin(), x.rend()}); }

/// Whether values fall, then grow.
bool dips(const Numbers& x) {
  const auto least = std::ranges::min_element(x);
  return least != x.begin() && least != x.end() - 1 && falls({x.begin(), least + 1}) && grows({least, x.end()});
}

const std::map<std::string, bool (*)(const Numbers&)> kShapes{
    {"grows", grows},
    {"falls", falls},
    {"dips", dips},
    {"peaks",
     [](const Numbers& x) {
       Numbers negative;
       for (const double value : x) negative.push_back(-value);
       return dips(negative);
     }},
    {"ends_highest", [](const Numbers& x) { return std::ranges::max_element(x) == x.end() - 1; }},
    // Steps must be equal within 2 % of the range.
    {"grows_straight",
     [](const Numbers& x) {
       for (const auto k : indices(x)) {
         const double part = static_cast<double>(k) / static_cast<double>(x.size() - 1);
         if (std::abs((x[k] - x.front()) / (x.back() - x.front()) - part) > 0.02) return false;
       }
       return grows(x);
     }},
    // The first five pitches have equal steps.
    {"levels_off",
     [](const Numbers& x) {
       Numbers steps;
       for (std::size_t k = 1; k < 5; ++k) steps.push_back(x[k] - x[k - 1]);
       return grows(x) && falls(steps);
     }},
};

/// A check of the form `stiffness grows over pitch`, or `stiffness least over rollers`: less than over any primary
/// parameter, by the ratio of the largest to the smallest value.
struct FormulaCheck {
  std::string quantity, shape, over, sweep;

  Numbers numbers(const std::string& name, const Formulas& f) const {
    Numbers x;
    for (const double value : kSweeps.at(name).values)
      x.push_back(kQuantities.at(quantity)(f, kSweeps.at(name).design(value)));
    return x;
  }
  double span(const std::string& name, const Formulas& f) const {
    const Numbers x = numbers(name, f);
    return std::ranges::max(x) / std::ranges::min(x);
  }
  Finding operator()(const Formulas& f) const {
    if (shape == "least") {
      Numbers spans;
      for (const std::string& primary : kPrimary.at(quantity)) spans.push_back(span(primary, f));
      return {span(sweep, f) < std::ranges::min(spans),
              fmt::format("greatest over least {:.3g}; of the others {:.3g}", span(sweep, f), fmt::join(spans, ", "))};
    }
    const Numbers x = numbers(sweep, f);
    std::vector<std::string> texts;
    for (const double value : x) texts.push_back(fmt::format("{:.3g}", value / x.front()));
    const Sweep& s = kSweeps.at(sweep);
    return {kShapes.at(shape)(x), fmt::format("{} times from {:g} to {:g}{}", fmt::join(texts, ", "), s.values.front(),
                                              s.values.back(), s.unit)};
  }
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
  const double flank = degrees / 2.0 / "deg"_per_si;
  c.mechanism.flank_angle = {flank, flank, flank};
  return loaded(c);
}
Loaded with_threads(Case c, int threads) {
  c.mechanism.contacts_per_roller = threads;
  return loaded(c);
}
Loaded with_helix_angle(Case c, double degrees) {
  c.mechanism.lead = std::numbers::pi * *c.mechanism.pitch_diameter.screw * std::tan(degrees / "deg"_per_si);
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
  const std::vector<Variant<Formulas>> variants{{"right formulas", {}},
                                                {"the slips of tables 7.1 and 7.2", {as_printed, true}}};
  std::vector<ComparedStatement> all =
      compare(thesis.statements, kRules, std::vector<Variant<Case>>{{"table 3.1", screw}});
  for (const PrintedStatement& s : thesis.statements) {
    FormulaCheck check;
    if (std::istringstream(s.check) >> check.quantity >> check.shape >> check.over >> check.sweep)
      all.push_back({s.section, s.text, compare<Formulas>(check, s.why, variants), s.expected});
  }
  return all;
}

}  // namespace prs::jung_2017
