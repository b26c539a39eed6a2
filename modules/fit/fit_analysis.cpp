#include "modules/fit/fit_analysis.h"

#include <map>
#include <set>

#include "prs/indices.h"
#include "prs/input/force_history.h"
#include "prs/loads/case_table.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/text.h"

namespace prs {

namespace estimation = modules::fit;
using estimation::CurveResult;
using estimation::Runs;
using estimation::StartResult;
using estimation::Unidentified;
using estimation::UnknownResult;

// A part of a result for documents, by its index.
struct FittedUnknown {
  const FitResult* r = nullptr;
  std::size_t j = 0;

  const FitParameter* parameter() const { return r->parameter(j); }
  const UnknownResult& found() const { return r->found.unknowns[j]; }
  const std::optional<estimation::Estimate>& estimate() const { return found().estimate; }
  std::string name() const { return r->name(j); }
  std::string label() const { return parameter() ? parameter()->label : name(); }
  std::string unit() const { return r->unit(j); }
  double bound(double sense) const {
    if (const FitParameter* p = parameter()) return sense < 0.0 ? p->from : p->to;
    const auto [least, greatest] = std::ranges::minmax(r->curve_of_offset(j).measured);
    return sense * (greatest - least);
  }
  std::string setting() const { return fmt::format("{}={}", name(), fit_text(*found().value, unit())); }
};
struct FittedCurve {
  const FitResult* r = nullptr;
  std::size_t c = 0;

  const FitCurve& curve() const { return r->input.curves[c]; }
  const CurveResult& found() const { return r->found.curves[c]; }
  bool is_fitted() const { return curve().use == FitCurve::Use::fit; }
};
struct FitDirection {
  const FitResult* r = nullptr;
  std::size_t k = 0;

  const Unidentified& found() const { return r->found.unidentified[k]; }
  const std::optional<estimation::Estimate>& combination() const { return found().combination; }
  bool has_spread() const { return combination() && combination()->deviation > 0.0; }
  std::vector<std::string> names() const {
    return each(found().unknowns, [&](std::size_t j) { return r->name(j); });
  }
  bool is_product() const { return r->parameter(found().unknowns[0]) && r->parameter(found().unknowns[0])->is_log; }
  std::string text() const {
    return fmt::format(fmt::runtime(is_product() ? "{0} x ({1})^{2:.4g} = {3:.6g}" : "{0} + {2:.4g} x {1} = {3:.6g}"),
                       names()[0], names()[1], found().factor, combination()->value);
  }
};
struct FitProfile : FittedUnknown {};
struct FitCombination : FitDirection {};
struct FittedBand : FittedCurve {};
struct FitMatrix {
  const FitResult* r = nullptr;
  const std::vector<std::vector<double>>* matrix = nullptr;
};

Record<FitParameter::Prior> record_of(Type<FitParameter::Prior>);
Record<FitProfile> record_of(Type<FitProfile>);
Record<FittedUnknown> record_of(Type<FittedUnknown>);
Record<FitMatrix> record_of(Type<FitMatrix>);
Record<FitCombination> record_of(Type<FitCombination>);
Record<FitDirection> record_of(Type<FitDirection>);
Record<Runs> record_of(Type<Runs>);
Record<FittedCurve> record_of(Type<FittedCurve>);
Record<FitCondition> record_of(Type<FitCondition>);
Record<FittedBand> record_of(Type<FittedBand>);
Record<StartResult> record_of(Type<StartResult>);

namespace {

std::vector<std::string> names_with_deviation(const FitResult& r) {
  return each(r.found.with_deviation, [&](std::size_t j) { return r.name(j); });
}

constexpr auto has_estimate = [](const FittedUnknown& p) { return p.estimate().has_value(); };
constexpr auto has_profile = [](const FittedUnknown& p) {
  return p.estimate() && std::ranges::find(p.r->input.profile, p.j) != p.r->input.profile.end();
};
template <auto member>
constexpr auto in_found = [](auto& part) { return part.found().*member; };
template <auto member>
constexpr auto of_estimate = of<[](const FittedUnknown& p) { return (*p.estimate()).*member; }, has_estimate>;

constexpr Quantity<FitParameter::Prior> kPrior[] = {
    {"mean", always<&FitParameter::Prior::mean>, "what is believed before the curves"},
    {"deviation", always<&FitParameter::Prior::deviation>, "standard deviation of that belief"},
};

constexpr Quantity<FitProfile> kProfile[] = {
    {"low", of<in_found<&UnknownResult::profile_low>>, "absent beyond a bound"},
    {"high", of<in_found<&UnknownResult::profile_high>>, "absent beyond a bound"},
};

constexpr Quantity<FittedUnknown> kUnknown[] = {
    {"name", always<&FittedUnknown::name>, "path, or `offset of CURVE`"},
    {"label", of<&FittedUnknown::label, &FittedUnknown::parameter>, "name for people"},
    {"unit", always<&FittedUnknown::unit>, "that of `from`; of an offset that of the response"},
    {"scale", always<[](auto& p) { return p.parameter() && p.parameter()->is_log ? "log" : "linear"; }>,
     "linear | log"},
    {"start", always<[](auto& p) { return p.parameter() ? p.parameter()->start : 0.0; }>, "where the search began"},
    {"from", always<[](auto& p) { return p.bound(-1.0); }>, "lower bound"},
    {"to", always<[](auto& p) { return p.bound(1.0); }>, "upper bound"},
    {"prior", of<[](auto& p) { return p.parameter()->prior; }, &FittedUnknown::parameter>, "as the file has it"},
    {"identified", always<in_found<&UnknownResult::is_identified>>, "whether the data determine it"},
    {"value", of<in_found<&UnknownResult::value>>, "at the least objective"},
    {"standard_deviation", of_estimate<&estimation::Estimate::deviation>, "with `log` times the value"},
    {"low", of_estimate<&estimation::Estimate::low>, "end of the interval"},
    {"high", of_estimate<&estimation::Estimate::high>, "end of the interval"},
    {"degrees_of_freedom", of_estimate<&estimation::Estimate::degrees_of_freedom>,
     "of Student's quantile; absent: the normal one", "Satterthwaite 1946"},
    {"at_bound",
     of<[](auto& p) { return p.found().at_bound < 0 ? "from" : "to"; },
        [](auto& p) { return p.found().at_bound != 0; }>,
     "from | to"},
    {"profile", of<[](auto& p) { return FitProfile{p}; }, has_profile>, "interval of the profile likelihood"},
    {"set", of<&FittedUnknown::setting, [](auto& p) { return p.parameter() && p.found().value; }>,
     "what `--set` takes for it"},
};

constexpr Quantity<FitMatrix> kMatrix[] = {
    {"names", always<[](auto& m) { return names_with_deviation(*m.r); }>, "parameters with a deviation"},
    {"matrix", always<[](auto& m) { return *m.matrix; }>, "rows and columns as `names`"},
};

constexpr Quantity<FitCombination> kCombination[] = {
    {"kind", always<[](auto& d) { return d.is_product() ? "product" : "sum"; }>, "sum | product"},
    {"names", always<&FitDirection::names>, "of both parameters, a and b"},
    {"factor", always<in_found<&Unidentified::factor>>, "a + factor b, or a b^factor"},
    {"value", always<[](auto& d) { return d.combination()->value; }>, "of the combination, which the data determine"},
    {"standard_deviation", of<[](auto& d) { return d.combination()->deviation; }, &FitDirection::has_spread>,
     "of a product times its value"},
    {"low", of<[](auto& d) { return d.combination()->low; }, &FitDirection::has_spread>, "end of the interval"},
    {"high", of<[](auto& d) { return d.combination()->high; }, &FitDirection::has_spread>, "end of the interval"},
    {"text", always<&FitDirection::text>, "with its numbers, for people"},
};

constexpr Quantity<FitDirection> kDirection[] = {
    {"names", always<&FitDirection::names>, "parameters that the data cannot separate"},
    {"direction", always<in_found<&Unidentified::direction>>, "of the scaled parameters"},
    {"ratio", always<in_found<&Unidentified::ratio>>, "singular value over the largest"},
    {"combination", of<[](auto& d) { return FitCombination{d}; }, [](auto& d) { return d.combination().has_value(); }>,
     "what counts of two"},
};

constexpr Quantity<Runs> kRuns[] = {
    {"count", always<&Runs::count>, "of equal signs in a row"},
    {"expected", always<&Runs::expected>, "of signs without a pattern"},
    {"p_value", always<&Runs::p_value>, "of so few", "Wald and Wolfowitz 1940"},
};

constexpr auto is_computed = [](const FittedCurve& c) { return !c.found().residual.empty(); };
template <auto member>
const auto& curve_of(const FittedCurve& c) {
  return c.curve().*member;
}
template <auto member>
constexpr auto of_curve = always<curve_of<member>>;
template <auto member>
const auto& found_of(const FittedCurve& c) {
  return c.found().*member;
}
template <auto member>
constexpr auto of_found = of<found_of<member>>;
constexpr auto command_of_curve = always<[](const FittedCurve& c) { return name(c.curve().command); }>;

constexpr std::string_view kLossNames[] = {"squares", "huber", "cauchy"};

constexpr Quantity<FittedCurve> kCurve[] = {
    {"name", of_curve<&FitCurve::name>, "as the file has it"},
    {"file", of_curve<&FitCurve::file>, "CSV of the readings"},
    {"response", of_curve<&FitCurve::response>, "path in the document of `command`"},
    {"unit", of_curve<&FitCurve::unit>, "of the response, in which all of these are"},
    {"command", command_of_curve, "that computes the response"},
    {"rows", of_curve<&FitCurve::rows>, "readings"},
    {"use", always<[](auto& c) { return c.is_fitted() ? "fit" : "compare"; }>, "fit | compare"},
    {"loss", always<[](auto& c) { return kLossNames[static_cast<std::size_t>(c.curve().loss.kind)]; }>,
     "squares | huber | cauchy"},
    {"estimated", always<[](auto& c) { return c.is_fitted() && c.curve().deviation.empty(); }>,
     "whether the deviation of its readings was"},
    {"redundancy", of_found<&CurveResult::redundancy>, "rows less what they determine"},
    {"rms", of<[](auto& c) { return c.found().rms; }, is_computed>, "root of the mean square of the residuals"},
    {"r_squared", of_found<&CurveResult::r_squared>, "1 - residual over total sum of squares"},
    {"chi_square", of_found<&CurveResult::chi_square>, "sum of the squares over the deviations"},
    {"runs", of_found<&CurveResult::runs>, "of sign of the residuals"},
    {"line", of_curve<&FitCurve::lines>, "of the file"},
    {"measured", of_curve<&FitCurve::measured>, "readings"},
    {"fitted", of_found<&CurveResult::fitted>, "with the offset"},
    {"residual", of_found<&CurveResult::residual>, "measured less fitted"},
    {"standard_deviation", of_found<&CurveResult::deviation>, "of a reading"},
    {"weight", of_found<&CurveResult::weight>, "of a reading under the loss"},
    {"low", of_found<&CurveResult::low>, "band of the response"},
    {"high", of_found<&CurveResult::high>, "band of the response"},
};

constexpr Quantity<FitCondition> kBandCondition[] = {
    {"path", always<&FitCondition::path>, "input that is set"},
    {"values", always<&FitCondition::texts>, "one for each row, or one for all"},
};

constexpr Quantity<FittedBand> kBand[] = {
    {"name", of_curve<&FitCurve::name>, "as the file has it"},
    {"response", of_curve<&FitCurve::response>, "path in the document of `command`"},
    {"unit", of_curve<&FitCurve::unit>, "of the response"},
    {"command", command_of_curve, "that computes the response"},
    {"conditions", always<[](auto& c) {
       std::vector<FitCondition> all = c.curve().conditions;
       for (const auto& [path, value] : c.curve().constants) all.push_back({path, "", {value}});
       return all;
     }>,
     "what is set"},
    {"value", of_found<&CurveResult::fitted>, "response at the fitted values, one for each row"},
    {"standard_deviation", of_found<&CurveResult::band_deviation>, "by the covariance of the values"},
    {"low", of_found<&CurveResult::low>, "end of the band"},
    {"high", of_found<&CurveResult::high>, "end of the band"},
};

constexpr Quantity<StartResult> kStart[] = {
    {"objective", of<&StartResult::objective>, "S + 2 sum of rows x ln(estimated deviation)"},
    {"values", filled<&StartResult::values>, "of the parameters, where it ended"},
    {"status", always<[](auto& s) { return name(s.status); }>, "how the search ended"},
    {"best", always<&StartResult::is_best>, "whether the fit is this one"},
};

/// Parts of a kind, by their indices 0 to n - 1.
template <class T>
std::vector<T> all_of(const FitResult& r, std::size_t n) {
  std::vector<T> all;
  for (std::size_t k = 0; k < n; ++k) all.push_back({&r, k});
  return all;
}
std::vector<FittedUnknown> unknowns_of(const FitResult& r) { return all_of<FittedUnknown>(r, r.found.unknowns.size()); }
std::vector<FittedCurve> curves_of(const FitResult& r) {
  std::vector<FittedCurve> all = all_of<FittedCurve>(r, r.input.curves.size());
  std::erase_if(all, [](const FittedCurve& c) { return c.curve().use == FitCurve::Use::band; });
  return all;
}
std::vector<FittedBand> bands_of(const FitResult& r) {
  std::vector<FittedBand> all;
  for (const FittedCurve& c : all_of<FittedCurve>(r, r.input.curves.size()))
    if (c.curve().use == FitCurve::Use::band && !c.found().low.empty()) all.push_back({c});
  return all;
}

template <auto member>
constexpr auto of_fit = always<[](const FitResult& r) { return r.found.*member; }>;

constexpr Quantity<FitResult> kFit[] = {
    {"converged", always<&FitResult::converged>, "whether the status is `converged`"},
    {"status", always<[](auto& r) { return name(r.found.status); }>,
     "converged | not_identifiable | no_redundancy | iteration_limit | no_equilibrium"},
    {"objective", of<[](auto& r) { return r.found.objective; }, &FitResult::has_values>, "S"},
    {"level_percent", always<[](auto& r) { return r.input.level; }>, "of all intervals"},
    {"degrees_of_freedom", of_fit<&estimation::Result::degrees_of_freedom>, "sum of the redundancies"},
    {"chi_square", of<[](auto& r) { return r.found.chi_square; }>, "of the curves with stated deviations and squares"},
    {"reduced_chi_square", of<[](auto& r) { return r.found.reduced_chi_square; }>,
     "over the sum of their redundancies"},
    {"p_value", of<[](auto& r) { return r.found.p_value; }>, "probability of more"},
    {"evaluations", always<&FitResult::evaluations>, "rows that were computed"},
    {"iterations", of_fit<&estimation::Result::iterations>, "of all searches"},
    {"parameters", always<unknowns_of>, "inputs, then offsets of curves"},
    {"correlation", always<[](auto& r) {
       return FitMatrix{&r, &r.found.correlation};
     }>,
     "of the values"},
    {"covariance", always<[](auto& r) {
       return FitMatrix{&r, &r.found.covariance};
     }>,
     "in the units of the values"},
    {"singular_value_ratios", of_fit<&estimation::Result::singular_value_ratios>, "falling"},
    {"unidentified", always<[](auto& r) { return all_of<FitDirection>(r, r.found.unidentified.size()); }>,
     "groups of parameters that the data cannot separate"},
    {"curves", always<curves_of>, "readings and fit, curve by curve"},
    {"bands", always<bands_of>, "requested responses, with their uncertainty"},
    {"starts", of_fit<&estimation::Result::starts>, "searches, the file's first"},
};

// Files

std::string conditions_text(const FitCurve& c, std::size_t row) {
  std::vector<std::string> texts;
  if (!c.series.empty()) texts.push_back(fmt::format("{}={:.10g}", c.series, c.places[row]));
  for (const FitCondition& condition : c.conditions)
    texts.push_back(fmt::format("{}={}{}{}", condition.path, condition.texts[row], condition.unit.empty() ? "" : " ",
                                condition.unit));
  for (const auto& [path, value] : c.constants) texts.push_back(fmt::format("{}={}", path, value));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string parameters_csv(const FitResult& r, const CsvStyle& style) {
  CsvRows csv(style);
  for (const FittedUnknown& p : unknowns_of(r)) {
    csv.record("", p);
    csv.record("profile_", FitProfile{p});
    csv.end_row();
  }
  return csv.take();
}

/// A row for each of the curves, a column for each of their series.
template <class Curve>
std::string rows_csv(const std::vector<Curve>& curves, std::string_view curve, std::string_view row,
                     const CsvStyle& style) {
  CsvRows csv(style);
  for (const Curve& c : curves)
    for (const auto i : up_to(c.curve().rows)) {
      csv(curve, c.curve().name);
      csv(row, c.curve().lines.empty() ? i + 1 : c.curve().lines[i]);
      csv("conditions", conditions_text(c.curve(), i));
      csv("unit", c.curve().unit);
      csv.series("", c, i);
      csv.end_row();
    }
  return csv.take();
}

std::vector<OutputFile> fit_files(const FitResult& r, const CsvStyle& style) {
  std::vector<OutputFile> files{{"fit_parameters.csv", parameters_csv(r, style)},
                                {"residuals.csv", rows_csv(curves_of(r), "curve", "line", style)}};
  if (const auto bands = bands_of(r); !bands.empty())
    files.push_back({"fit_bands.csv", rows_csv(bands, "band", "row", style)});
  if (!r.converged()) return files;
  files.push_back({"fitted.yaml", fitted_case(r)});
  // The readings are copied beside it, to make it a complete case.
  std::set<std::string> copied;
  for (std::size_t c = 0; c < r.input.curves.size(); ++c) {
    const FitCurve& curve = r.input.curves[c];
    if (curve.use == FitCurve::Use::band) continue;
    const std::string name = name_of_copy(r.input, c);
    if (!copied.insert(name).second) continue;
    files.push_back({name, input::named_file_text(curve.file, curve.at + ".file", r.input.source, true),
                     input::place_of_file(curve.file, r.input.source)});
  }
  return files;
}

// For people

/// Text that distinguishes a row of a band from the others.
std::string row_text(const FitCurve& c, std::size_t row) {
  std::string text = " ";
  for (const FitCondition& condition : c.conditions)
    text += fmt::format(" {} {}", words_of(condition.path.substr(condition.path.rfind('.') + 1)), condition.texts[row]);
  return text;
}

/// Standard deviation of a reading; the range of the readings' deviations if they differ.
std::string deviation_text(const FittedCurve& c) {
  const std::vector<double>& all = c.found().deviation;
  if (all.empty()) return std::string(kAbsent);
  const auto [least, greatest] = std::ranges::minmax(all);
  return least == greatest ? digits(least, 3) : fmt::format("{} to {}", digits(least, 2), digits(greatest, 2));
}

using Cells = std::vector<std::string>;

std::string cell(std::optional<double> v) { return digits(v, 5); }

/// Label, value, deviation, ends of the interval, unit.
Cells cells_of(const FittedUnknown& p) {
  const auto end = [&](double estimation::Estimate::*which) {
    return cell(p.estimate() ? std::optional((*p.estimate()).*which) : std::nullopt);
  };
  return {p.label(),
          p.found().value ? cell(p.found().value) : "unidentified",
          end(&estimation::Estimate::deviation),
          end(&estimation::Estimate::low),
          end(&estimation::Estimate::high),
          p.unit()};
}

/// Name, rows, deviation, rms, R², probability of the runs, unit.
Cells cells_of(const FittedCurve& c) {
  const CurveResult& f = c.found();
  return {c.curve().name + (c.is_fitted() ? "" : " (compared)"),
          std::to_string(c.curve().rows),
          deviation_text(c),
          is_computed(c) ? digits(f.rms, 4) : std::string(kAbsent),
          f.r_squared && *f.r_squared < -10.0 ? digits(f.r_squared, 4) : fixed(f.r_squared, 1.0, 5),
          fixed(f.runs ? std::optional(f.runs->p_value) : std::nullopt, 100.0, 1),
          c.curve().unit};
}

/// Conditions, value, deviation, ends of the band, unit: the first rows.
std::vector<Cells> cells_of(const FittedBand& c, std::size_t most) {
  const CurveResult& f = c.found();
  std::vector<Cells> rows;
  for (std::size_t i = 0; i < std::min(f.low.size(), most); ++i)
    rows.push_back({row_text(c.curve(), i), cell(f.fitted[i]), cell(f.band_deviation[i]), cell(f.low[i]),
                    cell(f.high[i]), c.curve().unit});
  return rows;
}

/// The row of a table on a terminal, with the unit as its remark.
std::string text_row(const TableRows& layout, Cells cells, const std::string& remark = {}) {
  const std::string label = cells.front(), unit = cells.back();
  return layout(fitted(printable(label), layout.label_width, true), {cells.begin() + 1, cells.end() - 1},
                " " + unit + remark);
}

/// Identified combinations of parameters that are not identified one by one.
std::vector<FitDirection> combinations_of(const FitResult& r) {
  std::vector<FitDirection> all = all_of<FitDirection>(r, r.found.unidentified.size());
  std::erase_if(all, [](const FitDirection& d) { return !d.combination(); });
  return all;
}

/// The three strongest correlations, a line each.
std::string strong_correlations(const FitResult& r) {
  std::vector<std::pair<double, std::string>> strong;
  const std::vector<std::string> names = names_with_deviation(r);
  const auto& m = r.found.correlation;
  for (std::size_t a = 0; a < names.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (std::abs(m[a][b]) > 0.9)
        strong.emplace_back(-std::abs(m[a][b]),
                            fmt::format("correlation {:+.3f} of {} and {}", m[a][b], names[b], names[a]));
  std::ranges::sort(strong);
  std::string text;
  for (const auto& [size, line] : std::span(strong).first(std::min<std::size_t>(3, strong.size())))
    text += wrapped(line, "  ", kTableWidth);
  return text;
}

std::string level_text(const FitResult& r) { return fmt::format("{:g} % from", 100.0 * r.input.level); }

std::string fit_table(const FitResult& r) {
  std::size_t readings = 0;
  for (const FittedCurve& c : curves_of(r)) readings += c.is_fitted() ? c.curve().rows : 0;
  std::string text = fmt::format("{}: {} unknowns, {} readings, {} rows computed\n",
                                 words_of_text(name(r.found.status)), r.found.unknowns.size(), readings, r.evaluations);
  if (!r.has_values()) return text + warning_section(r.warnings);
  constexpr TableRows values{44, 13}, curves{36, 12};
  text += "\n" + text_row(values, {"", "value", "deviation", level_text(r), "to", "unit"});
  for (const FittedUnknown& p : unknowns_of(r)) {
    const int at = p.found().at_bound;
    text += text_row(values, cells_of(p), at == 0 ? "" : at < 0 ? ", at `from`" : ", at `to`");
  }
  for (const FitDirection& d : combinations_of(r))
    text += wrapped("identified: " + d.text() +
                        (d.has_spread() ? fmt::format(", {} {:.6g} to {:.6g}", level_text(r), d.combination()->low,
                                                      d.combination()->high)
                                        : ""),
                    "  ", kTableWidth);
  text += strong_correlations(r);
  text += "\n" + text_row(curves, {"curve", "rows", "deviation", "rms", "R²", "runs p, %", "unit"});
  for (const FittedCurve& c : curves_of(r)) text += text_row(curves, cells_of(c));
  for (const FittedBand& c : bands_of(r)) {
    text += "\n" + text_row(values, {c.curve().name, "value", "deviation", "from", "to", c.curve().unit});
    for (Cells& row : cells_of(c, 12)) {
      row.back().clear();
      text += text_row(values, row);
    }
  }
  if (r.found.p_value)
    text += fmt::format("\nchi-square {:.4g}, reduced {:.4g}, probability of more {:.3g} %\n", *r.found.chi_square,
                        *r.found.reduced_chi_square, 100.0 * *r.found.p_value);
  return text + warning_section(r.warnings);
}

/// The table as rows for the page.
PageSection fit_section(const FitResult& r) {
  PageTable values{"Values", {"", "Value", "Deviation", level_text(r), "To", "Unit"}, {}};
  for (const FittedUnknown& p : unknowns_of(r)) values.rows.push_back(cells_of(p));
  PageTable curves{"Curves", {"", "Rows", "Deviation of a reading", "Rms", "R²", "Runs, p in %", "Unit"}, {}};
  for (const FittedCurve& c : curves_of(r)) curves.rows.push_back(cells_of(c));
  PageTable told{"Identified combinations", {"", "Deviation"}, {}};
  for (const FitDirection& d : combinations_of(r))
    told.rows.push_back({d.text(), d.has_spread() ? cell(d.combination()->deviation) : std::string(kAbsent)});
  PageSection page;
  page.tables = {std::move(values), std::move(curves)};
  if (!told.rows.empty()) page.tables.push_back(std::move(told));
  for (const FittedBand& c : bands_of(r))
    page.tables.push_back({c.curve().name, {"", "Value", "Deviation", "From", "To", "Unit"}, cells_of(c, 50)});
  return page;
}

// Pictures

/// Abscissa of the rows of a curve: a column of numbers, else their order.
std::pair<Axis, std::vector<double>> course_of(const FitCurve& c) {
  if (!c.series.empty()) {
    const bool force = c.series.ends_with("_N");
    return {{force ? "Axial force" : "Time", force ? "N" : "s"}, c.places};
  }
  for (const FitCondition& condition : c.conditions) {
    std::vector<double> x;
    for (const std::string& text : condition.texts)
      if (const auto number = input::split_unit(text)) x.push_back(number->number);
    if (x.size() == c.rows && std::ranges::max(x) > std::ranges::min(x)) {
      const std::string unit =
          condition.unit.empty() ? std::string(input::split_unit(condition.texts[0])->unit) : condition.unit;
      return {{capitalised(words_of(condition.path.substr(condition.path.rfind('.') + 1))), unit}, x};
    }
  }
  std::vector<double> x;
  for (std::size_t i = 0; i < c.rows; ++i) x.push_back(static_cast<double>(i + 1));
  return {{"Row", ""}, x};
}

Figures curve_figures(const FitResult& r) {
  Figure figure{"fit", "Readings and fit"};
  const std::size_t band = figure.add("band", line_of(Colour::sky, Dash::dashed, Weight::thin));
  const std::size_t line = figure.add("fit", line_of(Colour::blue));
  const std::size_t points = figure.add("readings", points_of(Colour::vermillion, Mark::circle));
  for (const FittedCurve& c : all_of<FittedCurve>(r, r.input.curves.size())) {
    const CurveResult& f = c.found();
    if (f.fitted.empty()) continue;
    const std::pair<Axis, std::vector<double>> course = course_of(c.curve());
    const std::vector<double>& x = course.second;
    std::vector<std::size_t> order(x.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return x[i]; });
    // Thinned if there are more rows than a picture shows.
    if (const std::size_t stride = (order.size() + 1999) / 2000; stride > 1) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < order.size(); i += stride) order[kept++] = order[i];
      order.resize(kept);
    }
    Panel panel{shown_name(c.curve().name)};
    const auto add = [&](std::size_t style, const std::vector<double>& y, const std::vector<std::size_t>& rows_of) {
      if (y.empty()) return;
      Series series{style};
      for (const std::size_t i : rows_of) series.add(x[i], y[i]);
      panel.series.push_back(std::move(series));
    };
    // One line for all rows that differ in their abscissa only.
    std::map<std::vector<std::string>, std::vector<std::size_t>> lines;
    for (const std::size_t i : order) {
      std::vector<std::string> others;
      for (const FitCondition& condition : c.curve().conditions)
        if (const auto number = input::split_unit(condition.texts[i]); !number || number->number != x[i])
          others.push_back(condition.texts[i]);
      lines[others].push_back(i);
    }
    for (const auto& [others, rows_of] : lines) {
      add(band, f.low, rows_of);
      add(band, f.high, rows_of);
      add(line, f.fitted, rows_of);
    }
    add(points, c.curve().measured, order);
    panel.x = course.first;
    const std::string& response = c.curve().response;
    const std::size_t series = response.find("[].");
    const ResponseTitle title = response_title(series == response.npos ? response : response.substr(series + 3));
    panel.y = fitted({capitalised(title.name), c.curve().unit}, range_of_y(panel.series));
    figure.panels.push_back(std::move(panel));
  }
  figure.columns = std::clamp<std::size_t>(figure.panels.size(), 1, 2);
  return {std::move(figure)};
}

Figures residual_figures(const FitResult& r) {
  Figure figure{"residuals", "Residuals over the rows"};
  const std::size_t zero = figure.add(kZeroStyle), points = figure.add(points_of(Colour::blue, Mark::circle));
  figure.x = {"Row"};
  for (const FittedCurve& c : curves_of(r)) {
    Panel panel{shown_name(c.curve().name)};
    Series series{points};
    const std::size_t stride = std::max<std::size_t>(1, (c.found().residual.size() + 1999) / 2000);
    for (std::size_t i = 0; i < c.found().residual.size(); i += stride)
      series.add(static_cast<double>(i + 1), c.found().residual[i]);
    panel.series.push_back(std::move(series));
    panel.references.push_back({zero, 0.0});
    panel.y = fitted({"Measured less fitted", c.curve().unit}, range_of_y(panel.series));
    figure.panels.push_back(std::move(panel));
  }
  figure.columns = std::clamp<std::size_t>(figure.panels.size(), 1, 2);
  return {std::move(figure)};
}

Figures correlation_figures(const FitResult& r) {
  const std::vector<std::string> names = names_with_deviation(r);
  if (names.size() < 2) return {};
  Figure figure{"correlation", "Correlation of the values"};
  Panel panel;
  for (std::size_t a = 0; a < names.size(); ++a) {
    const std::vector<double>& row = r.found.correlation[a];
    panel.map.grid.x.push_back(static_cast<double>(a + 1));
    figure.x.ticks.push_back({static_cast<double>(a + 1), std::to_string(a + 1)});
    const FittedUnknown its{&r, r.found.with_deviation[a]};
    figure.y.ticks.push_back({static_cast<double>(a + 1), fmt::format("{} {}", shown_name(its.label()), a + 1)});
    panel.map.grid.values.insert(panel.map.grid.values.end(), row.begin(), row.end());
  }
  panel.map.grid.y = panel.map.grid.x;
  panel.map.cells = true;
  for (Axis* const axis : {&figure.x, &figure.y}) {  // Whole cells at the ends.
    axis->from = 0.5;
    axis->to = static_cast<double>(names.size()) + 0.5;
  }
  figure.colours = ColourScale{.label = "Correlation", .from = -1.0, .to = 1.0};
  figure.panels.push_back(std::move(panel));
  return {std::move(figure)};
}

}  // namespace

PRS_RECORD(FitParameter::Prior, "FitPrior", "What was known before.", kPrior);
PRS_RECORD(FitProfile, "FitProfile", "Interval of the profile likelihood.", kProfile);
PRS_RECORD(FittedUnknown, "FittedParameter", "An input that was fitted, or the offset of a curve.", kUnknown);
PRS_RECORD(FitMatrix, "FitMatrix", "Of the values with a deviation.", kMatrix);
PRS_RECORD(FitCombination, "FitCombination",
           "Combination that the data determine of two parameters that they cannot separate.", kCombination);
PRS_RECORD(FitDirection, "FitDirection", "Parameters that the data cannot separate.", kDirection);
PRS_RECORD(Runs, "FitRuns", "Runs of sign of the residuals.", kRuns);
PRS_RECORD(FittedCurve, "FittedCurve", "A curve with its fit.", kCurve);
PRS_RECORD(FitCondition, "FitCondition", "What a band sets.", kBandCondition);
PRS_RECORD(FittedBand, "FitBand", "A response with its uncertainty.", kBand);
PRS_RECORD(StartResult, "FitStart", "A search.", kStart);
PRS_RECORD(FitResult, "Fit", "Unknown inputs from measured curves.", kFit);

const Analysis<FitResult>& fit_analysis() {
  static const Place places[] = {{"fit", describe<FitResult>}};
  static const Analysis<FitResult> analysis{
      .command = Command::fit,
      .help = "Unknown inputs from measured curves, with their uncertainty",
      .file = "fit.json",
      .run = [](const input::Source& source, const input::CaseInput&) { return fit_case(source); },
      .places = places,
      .put = [](Json& document, const FitResult& r) { document["fit"] = object_of(r); },
      .table = fit_table,
      .files = fit_files,
      .pictures = [](const FitResult& r, const Case&) -> Pictures {
        return {{"fit", "values of the parameters", of_result(r, curve_figures)},
                {"residuals", "values of the parameters", of_result(r, residual_figures)},
                {"correlation", "two parameters with deviations", of_result(r, correlation_figures)}};
      },
      .converged = [](const FitResult& r) { return r.converged(); },
      .place = {"Fit", 12},
      .section = fit_section};
  return analysis;
}

}  // namespace prs
