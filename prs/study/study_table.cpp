#include "prs/study/study_table.h"

#include <tuple>

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/record/table_layout.h"
#include "prs/study/study_pictures.h"

namespace prs {
namespace {

constexpr std::size_t kMostRows = 24;  // Rows per factor.
constexpr std::size_t kMostReasons = 8;
constexpr std::size_t kMaxValueWidth = 28;
constexpr std::size_t kMinCell = 9;
constexpr std::string_view kGap = "  ";
constexpr std::string_view kBaseMark = "as in the file";
constexpr std::size_t kMostRanked = 10;  // Factors per response.
constexpr double kLeastShare = 1e-3;     // Smallest share of a factor that is shown.
constexpr std::size_t kMostRankings = 6;
constexpr std::size_t kMaxName = 30;
constexpr TableRows kStatistics{kMaxName, 9, 1};
constexpr TableRows kEnvelope{kMaxName, 9, 2};
constexpr std::size_t kBarCells = 20;

/// A response over two lines, the unit at the end.
struct Heading {
  std::string upper, lower;
};

std::string number(std::optional<double> value, double factor = 1.0) { return digits(scaled(value, factor), 5); }

/// Two lines of about the same width.
Heading broken(const std::string& text) {
  Heading best{text, ""};
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    const Heading h{text.substr(0, at), text.substr(at + 1)};
    if (std::max(width(h.upper), width(h.lower)) < std::max(width(best.upper), width(best.lower))) best = h;
  }
  return best;
}

Heading heading(const ResponseTitle& title) {
  return broken(title.unit.empty() ? title.name : fmt::format("{} {}", title.name, title.unit));
}

struct Columns {
  std::vector<Recorded> responses;  ///< Responses; of an array, the largest entry is shown.
  std::vector<Heading> headings;
  std::vector<double> factors;  ///< Factors from the unit of documents to that of the heading.
  std::vector<std::size_t> widths;
  std::size_t value_width = 0;
};

/// The responses that fit next to the values.
Columns columns_of(const StudyResult& result) {
  Columns columns;
  columns.value_width = width(kBaseMark);
  for (const StudyRow& row : result.rows)
    for (const Setting& setting : row.design.settings)
      columns.value_width = std::max(columns.value_width,
                                     width(level_text(setting.level, result.study.factors[setting.factor].unit)) + 2);
  columns.value_width = std::min(columns.value_width, kMaxValueWidth);
  std::size_t used = columns.value_width;
  for (const Recorded& r : recorded(result.study.responses)) {
    const TableResponse response = table_response(r.is_array() ? r.path + ".max" : r.path);
    const Heading h = heading(response.title);
    const std::size_t w = std::max({kMinCell, width(h.upper), width(h.lower)});
    if (used + kGap.size() + w > kTableWidth) break;
    used += kGap.size() + w;
    columns.responses.push_back(r);
    columns.headings.push_back(h);
    columns.factors.push_back(response.factor);
    columns.widths.push_back(w);
  }
  return columns;
}

/// A number of a row, of an array the largest entry.
std::optional<double> shown_value(const StudyRow& row, const Recorded& response) {
  const auto from = row.responses.begin() + static_cast<std::ptrdiff_t>(response.first);
  return *std::max_element(from, from + static_cast<std::ptrdiff_t>(response.count));
}

std::string row_line(const Columns& columns, const std::string& value, const StudyRow& row) {
  std::string line = fitted(value, columns.value_width, true);
  if (!row.status.converged()) return fmt::format("{}{}{}\n", line, kGap, row.status.name);
  for (const auto c : indices(columns.widths))
    line.append(kGap).append(
        padded(number(shown_value(row, columns.responses[c]), columns.factors[c]), columns.widths[c], false));
  return line + '\n';
}

std::string header_lines(const Columns& columns) {
  std::string upper(columns.value_width, ' '), lower = upper;
  for (const auto c : indices(columns.widths)) {
    upper.append(kGap).append(padded(columns.headings[c].upper, columns.widths[c], false));
    lower.append(kGap).append(padded(columns.headings[c].lower, columns.widths[c], false));
  }
  return upper + '\n' + lower + '\n';
}

/// A row of a factor's table.
struct TableRow {
  const Level* level = nullptr;
  const StudyRow* row = nullptr;
  bool is_base = false;
};

/// The levels of one factor in their order. The base case, unless it is one of them, comes where
/// ascending levels have room for it, else at the end.
std::vector<TableRow> rows_of(const StudyResult& result, std::size_t index) {
  const Factor& factor = result.study.factors[index];
  std::vector<TableRow> rows;
  for (const StudyRow& row : result.rows)
    if (!row.design.settings.empty() && row.design.settings[0].factor == index)
      rows.push_back({&row.design.settings[0].level, &row, is_base(result.study, row.design)});
  if (!factor.base || std::ranges::any_of(rows, &TableRow::is_base)) return rows;
  const auto is_above = [&](const TableRow& row) {
    return factor.base->number && row.level->number && *row.level->number > *factor.base->number;
  };
  rows.insert(std::ranges::find_if(rows, is_above), {&*factor.base, &result.base(), true});
  return rows;
}

std::string factor_table(const StudyResult& result, std::size_t index, const Columns& columns) {
  const Factor& factor = result.study.factors[index];
  const std::vector<TableRow> rows = rows_of(result, index);
  std::string title = printable(factor.label);
  if (factor.label != factor.path) title += fmt::format(" ({})", printable(factor.path));
  for (const Factor& companion : factor.companions)
    title += fmt::format(", {}{}", &companion == &factor.companions[0] ? "with " : "", printable(companion.label));
  std::string text = shortened(title, kTableWidth) + '\n';
  const std::size_t step = (rows.size() + kMostRows - 1) / kMostRows;
  for (const auto k : indices(rows)) {
    const auto& [level, row, base] = rows[k];
    if (k % step != 0 && k + 1 != rows.size() && !base) continue;
    const std::string value = level_text(*level, factor.unit);
    text += row_line(columns, fmt::format("{} {}", base ? '*' : ' ', value), *row);
  }
  if (step > 1) text += fmt::format("  … of {} values; {}\n", factor.levels.size(), all_in("study.csv"));
  return text;
}

std::string settings_text(const Study& study, const Design& design) {
  std::string text;
  for (const std::string& setting : overrides(study, design))
    text += fmt::format("{}{}", text.empty() ? "" : ", ", printable(setting));
  return text.empty() ? std::string(kBaseMark) : text;
}

/// The settings of a design with the labels of the study.
std::string labelled_settings(const Study& study, const Design& design) {
  std::string text;
  for (const Setting& setting : design.settings) {
    const Factor& factor = study.factors[setting.factor];
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", printable(factor.label),
                        level_text(setting.level, factor.unit));
  }
  return text;
}

}  // namespace

std::string study_failures(const StudyResult& result) {
  const std::size_t failed = result.refused + result.failed;
  if (failed == 0) return "";
  const bool drawn = is_sampled(result.study.plan);
  std::string text =
      fmt::format("{} of {} designs, the base case included, without an answer\n", failed, result.designs);
  std::size_t shown = 0;
  for (std::size_t k = 0; k < result.rows.size() && shown < kMostReasons; ++k) {
    const StudyRow& row = result.rows[k];
    if (row.status.converged()) continue;
    ++shown;
    const std::string name = drawn ? fmt::format("design {}", k) : settings_text(result.study, row.design);
    text += wrapped(fmt::format("{} {}: {}", name, row.status.name, printable(row.status.reason)), "  ", kTableWidth);
  }
  if (failed > shown) text += fmt::format("  … and {} more; {}\n", failed - shown, all_in("study.csv"));
  return text;
}

namespace {

/// The rows of a study whose designs differ in one value, one table per factor.
std::string factor_tables(const StudyResult& result) {
  const Columns columns = columns_of(result);
  std::string text = header_lines(columns);
  text += row_line(columns, std::string(kBaseMark), result.base());
  for (const auto k : indices(result.study.factors)) text.append("\n").append(factor_table(result, k, columns));
  text += "\n* as in the file";
  const std::size_t all = recorded(result.study.responses).size();
  if (columns.headings.size() < all)
    text += fmt::format("; {} more responses; {}", all - columns.headings.size(), all_in("study.csv"));
  return text + '\n';
}

/// A bar of full length at a share of 1.
std::string bar(double share) {
  std::string text;
  const double cells = std::round(kBarCells * std::clamp(share, 0.0, 1.0));
  for (int k = 0; k < static_cast<int>(cells); ++k) text += "█";
  return text;
}

/// The first factors, those with a share of at least `least` of the total.
template <class Ranked>
std::string ranking(const Study& study, const std::vector<Ranked>& factors, double least, const auto& share,
                    const auto& numbers) {
  std::string text;
  std::size_t k = 0;
  for (; k < std::min(factors.size(), kMostRanked); ++k) {
    const Ranked& f = factors[k];
    if (k > 0 && share(f) < least) break;
    text += ended(fmt::format("  {:>3}  {}  {}  {}", k + 1,
                              fitted(printable(label_of_block(study, f.factor)), kMaxName, true), numbers(f),
                              bar(share(f) / share(factors[0]))));
  }
  if (k == factors.size()) return text;
  return text + fmt::format("       … {} more; {}\n", factors.size() - k, all_in("study.json"));
}

std::string contributions(const Study& study, std::size_t response, const LinearFit& fit) {
  std::string text = fmt::format("\n{}: contributions to a linear response surface, R² = {:.4f}\n",
                                 table_response(study.responses[response]).text(), fit.r_squared);
  if (fit.r_squared < kLowRSquared)
    text += "  little of it is linear: rank by the shares of variance (plan: sobol_indices)\n";
  return text + ranking(
                    study, fit.effects, 100.0 * kLeastShare,
                    [](const FactorEffect& e) { return e.contribution_percent; },
                    [](const FactorEffect& e) {
                      return fmt::format("{:+7.2f} %", std::copysign(e.contribution_percent, e.coefficient));
                    });
}

std::string estimate_text(const Estimate& estimate) {
  if (!estimate.half_width) return fmt::format("{:7.4f}         ", estimate.value);
  return fmt::format("{:7.4f} ± {:.4f}", estimate.value, *estimate.half_width);
}

std::string variance_shares(const Study& study, std::size_t response, const ResponseIndices& indices) {
  std::string text = fmt::format("\n{}: shares of the variance, {} samples",
                                 table_response(study.responses[response]).text(), indices.samples);
  if (indices.left_out > 0) text += fmt::format(", {} left out", indices.left_out);
  text += fmt::format("\n       {}    alone             with others\n", std::string(kMaxName, ' '));
  return text + ranking(
                    study, indices.factors, kLeastShare, [](const FactorIndices& f) { return f.total.value; },
                    [](const FactorIndices& f) { return estimate_text(f.first) + "  " + estimate_text(f.total); });
}

std::string gains(const Study& study, std::size_t response, const std::vector<ToleranceGain>& gains) {
  const TableResponse shown = table_response(study.responses[response]);
  return fmt::format(
             "\n{}: 95 % of the designs stay below {}; with half the deviation of one "
             "factor\n",
             shown.text(), significant(shown.factor * gains.front().quantile, 4)) +
         ranking(
             study, gains, -1.0, [](const ToleranceGain& g) { return g.gain(); },
             [&](const ToleranceGain& g) {
               return fmt::format("{:>10}  {:+7.2f} %", significant(shown.factor * g.halved, 4), 100.0 * g.gain());
             });
}

/// Most important factors of each response.
std::string rankings(const StudyResult& result) {
  const Study& study = result.study;
  const StudySummary& summary = result.summary;
  std::string text;
  if (summary.surfaces && !summary.surfaces->reason.empty())
    text += fmt::format("\nno response surface: {}\n", printable(summary.surfaces->reason));
  const std::size_t shown = std::min(study.responses.size(), kMostRankings);
  for (const auto k : up_to(shown)) {
    if (!summary.tolerances.empty() && !summary.tolerances[k].empty())
      text += gains(study, k, summary.tolerances[k]);
    else if (!summary.indices.empty() && !summary.indices[k].factors.empty())
      text += variance_shares(study, k, summary.indices[k]);
    else if (summary.surfaces && !summary.surfaces->fits.empty() && summary.surfaces->fits[k])
      text += contributions(study, k, *summary.surfaces->fits[k]);
  }
  if (!text.empty() && shown < study.responses.size())
    text += fmt::format("\n… {} more responses; {}\n", study.responses.size() - shown, all_in("study.json"));
  return text;
}

std::string statistics(const StudyResult& result) {
  std::string text = "\n" + kStatistics("", {"in file", "mean", "std dev", "min", "5 %", "95 %", "max"});
  for (const auto k : indices(result.summary.statistics)) {
    const ResponseStatistics& s = result.summary.statistics[k];
    const TableResponse response = table_response(result.study.responses[k]);
    std::vector<std::optional<double>> values{result.base().responses[k]};
    if (s.count > 0)
      values.insert(values.end(), {s.mean, s.standard_deviation, s.min, s.quantiles[1], s.quantiles[3], s.max});
    std::vector<std::string> cells;
    for (const std::optional<double>& value : values) {
      const double shown = response.factor * value.value_or(0.0);
      const int digits = std::abs(shown) < 1e-4 ? 3 : 4;  // Fewer digits, so that numbers with an exponent fit.
      cells.push_back(value ? significant(shown, digits) : std::string(kAbsent));
    }
    const std::string name = response.text();
    const bool is_long = width(name) > kMaxName;  // Has a line of its own.
    text += (is_long ? name + "\n" : "") + kStatistics(is_long ? "" : name, cells);
  }
  const bool all_kept =
      std::ranges::all_of(result.summary.statistics, [](const auto& s) { return s.values_kept == s.count; });
  if (!all_kept) text += fmt::format("quantiles of {} designs, drawn at random\n", kMostValuesKept);
  return text;
}

/// Designs of a grid with the smallest and the largest response.
std::string extremes(const StudyResult& result) {
  std::string text;
  for (const auto k : up_to(std::min(result.study.responses.size(), kMostRankings))) {
    const ResponseStatistics& s = result.summary.statistics[k];
    if (s.count == 0 || s.min == s.max) continue;
    const TableResponse response = table_response(result.study.responses[k]);
    text += fmt::format("\n{}\n", response.text());
    for (const auto& [word, value, at] : {std::tuple{"min", s.min, s.min_design}, {"max", s.max, s.max_design}})
      text += wrapped(fmt::format("{} {}: {}", word, number(value, response.factor),
                                  labelled_settings(result.study, design(result.study, at))),
                      "  ", kTableWidth);
  }
  return text;
}

std::string envelope_row(const std::string& label, std::vector<std::string> cells) {
  for (std::string& cell : cells) cell = shortened(cell, kEnvelope.cell_width);
  return kEnvelope(shortened(label, kMaxName), cells);
}

/// Measures of the envelope: `stiffness (N/µm)   weight 3   rms 412.3`.
std::string envelope_measures(const StudyResult& result) {
  const EnvelopeResult& envelope = *result.summary.envelope;
  const bool product = result.study.envelope->combine == Envelope::Combine::product;
  std::string text =
      fmt::format("\nEnvelope, {} of the normalised measures\n", product ? "product of powers" : "weighted sum");
  text += envelope_row("", {product ? "exponent" : "factor", "divided by", "rms"});
  for (const MeasureMap& measure : envelope.measures) {
    const TableResponse response = table_response(result.study.responses[measure.response]);
    text += envelope_row(response.text(),
                         {fmt::format("{:g}", measure.weight), number(measure.normalised_by, response.factor),
                          number(measure.rms, response.factor)});
  }
  text += envelope_row("envelope", {"", "", number(envelope.rms)});
  if (envelope.without > 0)
    text += fmt::format("{} of {} designs have no envelope\n", envelope.without, envelope.values.size());
  return text;
}

/// The designs that were read off, a column each: inputs, responses, envelope.
std::string envelope_points(const StudyResult& result) {
  const Study& study = result.study;
  std::vector<const EnvelopePoint*> found;
  std::string reasons;
  for (const EnvelopePoint& point : result.summary.envelope->points)
    if (point.reason.empty())
      found.push_back(&point);
    else
      reasons += wrapped(fmt::format("{}: {}", printable(point.name), printable(point.reason)), "  ", kTableWidth);
  if (!reasons.empty()) reasons = "\nPoints that the grid does not have\n" + reasons;
  if (found.empty()) return reasons;
  const std::size_t shown = std::min(found.size(), (kTableWidth - kMaxName) / (kEnvelope.cell_width + kEnvelope.gap));
  const auto row = [&](const std::string& label, auto cell) {
    std::vector<std::string> cells;
    for (const auto k : up_to(shown)) cells.push_back(cell(*found[k]));
    return envelope_row(label, cells);
  };
  std::string text = "\n" + row("point", [](const EnvelopePoint& p) { return printable(p.name); });
  text += row("design", [](const EnvelopePoint& p) { return p.design ? fmt::format("{}", *p.design) : "between"; });
  const std::vector<DrawnInput> inputs = drawn_inputs(study);
  for (const auto k : indices(inputs))
    text += row(factor_title(*inputs[k].input), [&](const EnvelopePoint& p) {
      const Level& level = p.inputs[k];
      const std::string& unit = inputs[k].input->unit;
      if (!level.number || level.text.starts_with('{')) return printable(level.text);
      return fmt::format("{:.5g}{}{}", *level.number, unit.empty() ? "" : " ", printable(unit));
    });
  for (const auto k : indices(study.responses)) {
    const TableResponse response = table_response(study.responses[k]);
    text += row(response.text(), [&](const EnvelopePoint& p) { return number(p.responses[k], response.factor); });
  }
  text += row("envelope", [](const EnvelopePoint& p) { return number(p.envelope); });
  if (shown < found.size()) text += fmt::format("… {} more points; {}\n", found.size() - shown, all_in("study.json"));
  if (std::ranges::any_of(found, [](const EnvelopePoint* p) { return !p->design; }))
    text += "between: interpolated between four designs of the grid\n";
  return text + reasons;
}

std::string envelope_text(const StudyResult& result) {
  if (!result.summary.envelope) return "";
  return envelope_measures(result) + envelope_points(result);
}

std::string head(const StudyResult& result) {
  const Study& study = result.study;
  std::string text = fmt::format("{}: {} designs", name(study.plan), result.designs - 1);
  if (is_sampled(study.plan)) text += fmt::format(", seed {}", study.seed);
  return text + '\n';
}

}  // namespace

std::string study_table(const StudyResult& result) {
  const Study& study = result.study;
  std::string end = study_failures(result);
  if (!end.empty()) end.insert(0, "\n");
  end += warning_section(result.warnings);
  if (varies_one_at_a_time(study)) return factor_tables(result) + end;
  return head(result) + rankings(result) + statistics(result) + (study.plan == Plan::grid ? extremes(result) : "") +
         envelope_text(result) + end;
}

std::string progress_line(std::size_t done, std::size_t total, double seconds, std::size_t found) {
  const double rate = seconds > 0.0 ? static_cast<double>(done - found) / seconds : 0.0;
  std::string text = fmt::format("{} of {} designs", done, total);
  if (found > 0) text += fmt::format(" ({} from the journal)", found);
  if (!(rate > 0.0)) return text;
  text += rate < 10.0 ? fmt::format(", {:.1f} a second", rate) : fmt::format(", {:.0f} a second", rate);
  const long left = std::lround(std::ceil(static_cast<double>(total - done) / rate));
  if (left >= 3600) return text + fmt::format(", {}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
  return text + fmt::format(", {}:{:02} left", left / 60, left % 60);
}

}  // namespace prs
