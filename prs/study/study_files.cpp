#include "prs/study/study_files.h"

#include <fmt/ranges.h>

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/output/files.h"
#include "prs/record/table_layout.h"
#include "prs/study/study_pictures.h"

namespace prs {
namespace {

constexpr std::size_t kUsualField = 13;  ///< Characters of a number and its separator.

/// Fields of a design that differs from the base case in one value.
void setting_fields(CsvWriter& csv, const Study& study, const Design& design) {
  const Setting* setting = design.settings.empty() ? nullptr : &design.settings.front();
  const Factor* factor = setting ? &study.factors[setting->factor] : nullptr;
  const Level level = setting ? setting->level : Level{};
  if (factor)
    csv.fields(factor->path, factor->label);
  else
    csv.fields("", "");
  csv.fields(level.text, level.number, level.number ? factor->unit : "", is_base(study, design));
}

void factor_field(CsvWriter& csv, const FactorColumn& column, double value) {
  if (column.is_numeric())
    csv.number(value);
  else
    csv.text(value >= 0.0 ? item_at(column.words, value) : "");
}

void input_fields(CsvWriter& csv, const std::vector<FactorColumn>& columns, const std::vector<Level>& inputs) {
  for (const auto k : indices(columns))
    if (columns[k].is_numeric())
      csv.number(inputs[k].number);
    else
      csv.text(inputs[k].text);
}

}  // namespace

void write_rows(const StoredRows& rows, const Study& study, const std::filesystem::path* folder, std::size_t threads,
                const TakeRows& add, const CsvStyle& style) {
  const std::vector<FactorColumn> columns = factor_columns(study);
  const StudyCsv csv(study, columns, style);
  std::optional<StagedFile> file;
  if (folder) file.emplace(*folder / "study.csv").append(csv.header());
  run_in_order(rows.block_count(), threads, [&](std::size_t k) -> std::function<void()> {
    struct Prepared {
      RowBlock block;
      std::vector<double> inputs;
      std::string text = {};
    };
    auto prepared = std::make_shared<Prepared>(Prepared{rows.block(k), {}});
    const RowBlock& block = prepared->block;
    prepared->inputs = factor_values(study, columns, block.first, block.rows);
    if (file) prepared->text = csv.rows(block, prepared->inputs);
    return [&add, &file, prepared] {
      if (file) file->append(prepared->text);
      add(prepared->block, prepared->inputs);
    };
  });
  if (!file) return;
  file->sync();
  file->publish();
  record_written(*folder / "study.csv");
}

std::string StudyCsv::header() const {
  CsvWriter csv(style_);
  csv.text("design");
  if (study_.plan == Plan::one_at_a_time)
    csv.fields("factor", "label", "value", "number", "unit", "base");
  else
    for (const FactorColumn& column : columns_) csv.text(column.name);
  csv.row("status", "reason", study_.responses);
  return csv.take();
}

std::string StudyCsv::rows(const RowBlock& block, const std::vector<double>& factors) const {
  CsvWriter csv(style_, CsvWriter::Part::rows);
  const std::size_t width = study_.responses.size();
  csv.reserve(block.rows * (kUsualField * (columns_.size() + width) + kUsualField));
  for (const auto row : up_to(block.rows)) {
    csv.integer(block.first + row);
    if (study_.plan == Plan::one_at_a_time)
      setting_fields(csv, study_, design(study_, block.first + row));
    else
      for (const auto f : indices(columns_)) factor_field(csv, columns_[f], factors[row * columns_.size() + f]);
    const DesignStatus status = block.status(row);
    csv.fields(status.name, status.reason);
    for (const auto k : up_to(width)) csv.number(block.responses[row * width + k]);
    csv.end_row();
  }
  return csv.take();
}

std::string envelope_csv(const Study& study, const GridMaps& maps, const EnvelopeResult& envelope,
                         const CsvStyle& style) {
  const std::vector<FactorColumn> columns = factor_columns(study);
  CsvWriter csv(style);
  csv.fields("point", "design");
  for (const FactorColumn& column : columns) csv.text(column.name);
  csv.fields(study.responses);
  for (const MeasureMap& measure : envelope.measures) csv.text("normalised." + study.responses[measure.response]);
  csv.row("envelope");

  const std::size_t row = maps.axes[1].nodes();
  for (const auto k : up_to(maps.nodes())) {
    csv.fields("", maps.design(k));
    input_fields(csv, columns, inputs_at(study, maps, {static_cast<double>(k / row), static_cast<double>(k % row)}));
    for (const GridMap& map : maps.responses) csv.number(map[k]);
    for (const MeasureMap& measure : envelope.measures)
      csv.number(maps.responses[measure.response][k] / measure.normalised_by);
    csv.row(envelope.values[k]);
  }
  for (const EnvelopePoint& point : envelope.points) {
    if (!point.reason.empty()) continue;
    csv.fields(point.name, point.design);
    input_fields(csv, columns, point.inputs);
    csv.row(point.responses, point.normalised, point.envelope);
  }
  return csv.take();
}

namespace {

constexpr std::size_t kFactorWidth = 40;

/// Factors that have an elasticity of a response, the strongest first, then those that are 0.
std::vector<std::size_t> ranked(const CaseDerivatives& result, std::size_t response) {
  std::vector<std::size_t> order;
  const auto strength = [&](std::size_t factor) {
    const auto& elasticity = result.factors[factor].responses[response]->elasticity;
    return elasticity ? std::abs(*elasticity) : -1.0;
  };
  for (const auto k : indices(result.factors)) {
    const std::optional<Derivative>& d = result.factors[k].responses[response];
    const std::optional<Level>& base = result.study.factors[k].base;
    if (d && (d->elasticity || (base && base->number == 0.0))) order.push_back(k);
  }
  std::ranges::stable_sort(order, std::greater{}, strength);
  return order;
}

/// A response of a case; or its derivative by a factor.
struct DerivativeOf {
  const CaseDerivatives* result = nullptr;
  std::size_t response = 0;
  std::size_t factor = 0;

  const Factor& input() const { return result->study.factors[factor]; }
  const std::string& path() const { return input().path; }
  const std::string& unit() const { return input().unit; }
  const std::optional<Derivative>& found() const { return result->factors[factor].responses[response]; }
  std::vector<DerivativeOf> by_factors() const {
    std::vector<DerivativeOf> all;
    for (const auto k : indices(result->factors)) all.push_back({result, response, k});
    return all;
  }
};

template <auto get>
constexpr auto of_derivative =
    of<[](const DerivativeOf& d) { return std::optional<double>(std::invoke(get, *d.found())); },
       [](const DerivativeOf& d) { return d.found().has_value(); }>;

constexpr Quantity<DerivativeOf> kByFactor[] = {
    {"path", always<&DerivativeOf::path>},
    {"unit", filled<&DerivativeOf::unit>},
    {"at", of<[](auto& d) { return d.input().base ? d.input().base->number : std::nullopt; }>, "in this unit"},
    {"reason",
     of<[](auto& d) { return d.result->factors[d.factor].reason; }, [](auto& d) { return !d.found().has_value(); }>,
     "why there is none"},
    {"derivative", of_derivative<&Derivative::value>},
    as_shown<DerivativeOf>({"percent_per_percent", of_derivative<&Derivative::elasticity>}),
    {"error", of_derivative<&Derivative::error>, "of the derivative, estimated"},
};

constexpr Quantity<DerivativeOf> kOfResponse[] = {
    {"response", always<[](auto& d) { return d.result->study.responses[d.response]; }>},
    {"value", of<[](auto& d) { return d.result->values[d.response]; }>},
    {"by", always_table<kByFactor, &DerivativeOf::by_factors>},
};

constexpr Quantity<CaseDerivatives> kDerivatives[] = {
    {"derivatives", always_table<kOfResponse,
                                 [](auto& result) {
                                   std::vector<DerivativeOf> all;
                                   for (const auto k : indices(result.values)) all.push_back({&result, k});
                                   return all;
                                 }>},
};

/// The responses that have no derivative by a factor, by name.
std::string without_derivative(const CaseDerivatives& result, std::size_t factor) {
  std::vector<std::string> names;
  for (const auto k : indices(result.study.responses))
    if (!result.factors[factor].responses[k]) names.push_back(response_title(result.study.responses[k]).name);
  if (names.size() > 1 && names.size() == result.study.responses.size()) return "any response";
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Effects of 1 % of each factor on the responses, for the most important factors.
Figures elasticities(const CaseDerivatives& result, const FigureOptions& options) {
  constexpr std::size_t kMostDrawn = 14;
  return figures_of(result.study.responses, options, [&](std::size_t response) -> std::optional<Figure> {
    std::vector<std::pair<double, std::string>> bars;
    for (const auto f : indices(result.factors))
      if (const auto& d = result.factors[f].responses[response]; d && d->elasticity)
        bars.emplace_back(*d->elasticity, factor_name(result.study.factors[f]));
    if (bars.empty()) return std::nullopt;
    std::ranges::stable_sort(bars, std::greater{}, [](const auto& b) { return std::abs(b.first); });
    bars.resize(std::min(bars.size(), kMostDrawn));
    Figure figure = response_figure(result.study.responses, response);
    figure.name = "derivatives_" + figure.name;
    figure.title += ": change by 1 % of each factor";
    figure.x = {"Change of the response", "%"};
    using Bar = std::pair<double, std::string>;
    return ranked_bars(std::move(figure), each(bars, &Bar::second), each(bars, &Bar::first));
  });
}

}  // namespace

PRS_RECORD(CaseDerivatives, "Derivatives", "What each factor does to each response.", kDerivatives);

Json derivatives_json(const CaseDerivatives& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  put_object(document, result);
  return document;
}

std::string derivatives_csv(const CaseDerivatives& result, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("response", "value", "factor", "label", "at", "unit", "derivative", "percent_per_percent", "error", "reason");
  for (const auto k : indices(result.values))
    for (const auto f : indices(result.factors)) {
      const Factor& factor = result.study.factors[f];
      const std::optional<Derivative>& d = result.factors[f].responses[k];
      csv.fields(result.study.responses[k], result.values[k], factor.path, factor.label,
                 factor.base ? factor.base->number : std::nullopt, factor.unit);
      if (d)
        csv.row(d->value, d->elasticity, d->error, "");
      else
        csv.row("", "", "", result.factors[f].reason);
    }
  return csv.take();
}

std::string derivatives_table(const CaseDerivatives& result) {
  std::string text;
  for (const auto k : indices(result.values)) {
    const auto& [title, shown] = table_response(result.study.responses[k]);
    text += fmt::format("{}{}: {}{}\n", k > 0 ? "\n" : "", title.name,
                        result.values[k] ? fmt::format("{:.6g}", shown * *result.values[k]) : "absent",
                        title.unit.empty() ? "" : " " + title.unit);
    text += fmt::format("  {:<{}}  {:>16}  {:>16}  {}\n", "factor", kFactorWidth, "% per 1 %", "derivative", "per");
    for (const std::size_t f : ranked(result, k)) {
      const Factor& factor = result.study.factors[f];
      const Derivative& d = *result.factors[f].responses[k];
      text += fmt::format("  {}  {}  {:>16.7g}  {}\n", fitted(printable(factor.label), kFactorWidth, true),
                          padded(d.elasticity ? fmt::format("{:.5f}", *d.elasticity) : std::string(kAbsent), 16, false),
                          shown * d.value, factor.unit.empty() ? "1" : printable(factor.unit));
    }
  }
  for (const auto f : indices(result.factors))
    if (!result.factors[f].reason.empty())
      text += "\n" + wrapped(fmt::format("{}: no derivative of {}: {}", printable(result.study.factors[f].label),
                                         without_derivative(result, f), printable(result.factors[f].reason)),
                             "  ", kTableWidth);
  return text + warning_section(result.warnings);
}

Pictures derivatives_pictures(const CaseDerivatives& r) {
  return {{"elasticities", "factors and responses other than 0 in the file", of_result(r, elasticities)}};
}

}  // namespace prs
