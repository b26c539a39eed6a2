#include "prs/study/derivatives_files.h"

#include <fmt/ranges.h>

#include "prs/loads/case_table.h"
#include "prs/loads/warnings.h"
#include "prs/record/table_units.h"
#include "prs/study/study_parts.h"

namespace prs {
namespace {

constexpr std::size_t kFactorWidth = 40;

/// Factors that have an elasticity of a response, the strongest first, then those that are 0.
std::vector<std::size_t> ranked(const CaseDerivatives& result, std::size_t response) {
  std::vector<std::size_t> order;
  const auto strength = [&](std::size_t factor) {
    const auto& elasticity = result.factors[factor].responses[response]->elasticity;
    return elasticity ? std::abs(*elasticity) : -1.0;
  };
  for (std::size_t k = 0; k < result.factors.size(); ++k) {
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
  const std::optional<Derivative>& found() const {
    return result->factors[factor].responses[response];
  }
  std::vector<DerivativeOf> by_factors() const {
    std::vector<DerivativeOf> all;
    for (std::size_t k = 0; k < result->factors.size(); ++k) all.push_back({result, response, k});
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
    {"at", of<[](auto& d) { return d.input().base ? d.input().base->number : std::nullopt; }>,
     "in this unit"},
    {"reason",
     of<[](auto& d) { return d.result->factors[d.factor].reason; },
        [](auto& d) { return !d.found().has_value(); }>,
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
                                   for (std::size_t k = 0; k < result.values.size(); ++k)
                                     all.push_back({&result, k});
                                   return all;
                                 }>},
};

/// The responses that have no derivative by a factor, by name.
std::string without_derivative(const CaseDerivatives& result, std::size_t factor) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < result.study.responses.size(); ++k)
    if (!result.factors[factor].responses[k])
      names.push_back(response_title(result.study.responses[k]).name);
  if (names.size() > 1 && names.size() == result.study.responses.size()) return "any response";
  return fmt::format("{}", fmt::join(names, ", "));
}

/// What 1 % of each factor does to the responses, the factors that matter most.
Figures elasticities(const CaseDerivatives& result, const FigureOptions& options) {
  constexpr std::size_t kMostBars = 14;
  return figures_of(
      result.study.responses, options, [&](std::size_t response) -> std::optional<Figure> {
        std::vector<std::pair<double, std::string>> bars;
        for (std::size_t f = 0; f < result.factors.size(); ++f)
          if (const auto& d = result.factors[f].responses[response]; d && d->elasticity)
            bars.emplace_back(*d->elasticity, factor_name(result.study.factors[f]));
        if (bars.empty()) return std::nullopt;
        std::ranges::stable_sort(bars, std::greater{},
                                 [](const auto& b) { return std::abs(b.first); });
        bars.resize(std::min(bars.size(), kMostBars));
        Figure figure = response_figure(result.study.responses, response);
        figure.name = "derivatives_" + figure.name;
        figure.title += ": change by 1 % of each factor";
        figure.x = {"Change of the response", "%"};
        using Bar = std::pair<double, std::string>;
        return ranked_bars(std::move(figure), each(bars, &Bar::second), each(bars, &Bar::first));
      });
}

}  // namespace

Record<CaseDerivatives> record_of(Type<CaseDerivatives>) {
  return {"Derivatives", "What each factor does to each response.", kDerivatives};
}

Json derivatives_json(const CaseDerivatives& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  put_object(document, result);
  return document;
}

std::string derivatives_csv(const CaseDerivatives& result, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("response", "value", "factor", "label", "at", "unit", "derivative", "percent_per_percent",
          "error", "reason");
  for (std::size_t k = 0; k < result.values.size(); ++k)
    for (std::size_t f = 0; f < result.factors.size(); ++f) {
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
  for (std::size_t k = 0; k < result.values.size(); ++k) {
    const auto& [title, shown] = table_response(result.study.responses[k]);
    text +=
        fmt::format("{}{}: {}{}\n", k > 0 ? "\n" : "", title.name,
                    result.values[k] ? fmt::format("{:.6g}", shown * *result.values[k]) : "absent",
                    title.unit.empty() ? "" : " " + title.unit);
    text += fmt::format("  {:<{}}  {:>16}  {:>16}  {}\n", "factor", kFactorWidth, "% per 1 %",
                        "derivative", "per");
    for (const std::size_t f : ranked(result, k)) {
      const Factor& factor = result.study.factors[f];
      const Derivative& d = *result.factors[f].responses[k];
      text += fmt::format(
          "  {}  {}  {:>16.7g}  {}\n", fitted(printable(factor.label), kFactorWidth, true),
          padded(d.elasticity ? fmt::format("{:.5f}", *d.elasticity) : std::string(kAbsent), 16,
                 false),
          shown * d.value, factor.unit.empty() ? "1" : printable(factor.unit));
    }
  }
  for (std::size_t f = 0; f < result.factors.size(); ++f)
    if (!result.factors[f].reason.empty())
      text += "\n" + wrapped(fmt::format("{}: no derivative of {}: {}",
                                         printable(result.study.factors[f].label),
                                         without_derivative(result, f),
                                         printable(result.factors[f].reason)),
                             "  ", kTableWidth);
  return text + warning_section(result.warnings);
}

Pictures derivatives_pictures(const CaseDerivatives& r) {
  return {{"elasticities", "factors and responses other than 0 in the file",
           of_result(r, elasticities)}};
}

}  // namespace prs
