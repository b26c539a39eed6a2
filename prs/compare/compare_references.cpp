#include "prs/compare/compare_references.h"

#include "prs/indices.h"
#include "prs/input/readings.h"
#include "prs/losses/solve_analysis.h"
#include "prs/record/response_path.h"
#include "prs/reference/referenced_analyses.h"

namespace prs {
namespace {

constexpr double kNoAnswer = std::numeric_limits<double>::quiet_NaN();

const AnyAnalysis& analysis_of(const ReferenceCurve& reference) {
  return *std::ranges::find(referenced_analyses(), reference.command, &AnyAnalysis::command);
}

/// The document that has the reference's response.
Json answers_of(const input::Source& source, Case c, const ReferenceCurve& reference) {
  input::CaseInput in;
  in.values = std::move(c);
  return analysis_of(reference).run(source, in).document({});
}

/// The load case of a name; null where there is none.
const Json* load_case_of(const Json& document, const std::string& name) {
  const auto found = document.find("load_cases");
  for (std::size_t k = 0; found != document.end() && k < found->size(); ++k)
    if ((*found)[k]["name"] == name) return &(*found)[k];
  return nullptr;
}

/// Threads of the most loaded roller of a full mechanism, of a sector those of its roller.
std::vector<double> threads_of(const Json* series, const LoadCaseResult& result, std::string_view response) {
  if (!series || !series->is_array() || series->empty()) return {};
  const Interface i = response.find("nut.") == response.npos ? Interface::screw : Interface::nut;
  const bool in_rows = (*series)[0].is_array() && result.threads && (*result.threads)[i].rollers;
  const Json& row = in_rows ? item_at((*series), (*result.threads)[i].rollers->largest_roller - 1) : *series;
  std::vector<double> values;
  for (const Json& entry : row) values.push_back(entry.is_number() ? entry.get<double>() : kNoAnswer);
  return values;
}

class References {
 public:
  References(const input::Source& source, const Case& c, const ModelComparison& comparison)
      : source_(source), case_(c), comparison_(comparison) {}

  ReferenceAnswer answer(const ReferenceCurve& reference, std::size_t model) {
    ReferenceAnswer answer;
    answer.computed = reference.cases.empty() ? in_load_case(reference, model) : over_input(reference, model);
    const std::vector<double> values = reference.values();
    answer.deviations = curve_deviations(answer.computed, values);
    if (reference.is_over_force()) answer.slope = slope(forces_of(reference), answer.computed);
    if (!reference.tolerance) return answer;
    answer.tolerance_use = answer.deviations ? 0.0 : HUGE_VAL;
    for (std::size_t k = 0; answer.deviations && k < values.size(); ++k)
      answer.tolerance_use =
          std::max(*answer.tolerance_use, std::abs(answer.computed[k] - values[k]) /
                                              reference.tolerance->at(values[k], reference.mean_magnitude()));
    return answer;
  }

  /// Forces of the readings [N], with their signs.
  static std::vector<double> forces_of(const ReferenceCurve& reference) {
    const double newton = input::conversion(reference.along_unit, "N")->factor;
    return each(reference.readings, [newton](const ReferenceReading& r) { return newton * r.along; });
  }

 private:
  std::vector<double> in_load_case(const ReferenceCurve& reference, std::size_t model) {
    const Json& document = document_of_model(reference, model);
    const Json* json = reference.load_case.empty() ? &document : load_case_of(document, reference.load_case);
    std::vector<double> values(reference.readings.size(), kNoAnswer);
    if (!json) return values;
    if (!reference.is_over_threads()) {
      values[0] = number_at(*json, "." + reference.response).value_or(kNoAnswer);
      return values;
    }
    const LoadCaseResult& result = *std::ranges::find(comparison_.models[model].load_cases, reference.load_case,
                                                      [](const LoadCaseResult& r) { return r.load_case.name; });
    const std::vector<double> threads = threads_of(value_at(*json, reference.response), result, reference.response);
    for (const auto r : indices(values))
      if (const auto thread = static_cast<std::size_t>(reference.readings[r].along); thread <= threads.size())
        values[r] = threads[thread - 1];
    return values;
  }

  const Json& document_of_model(const ReferenceCurve& reference, std::size_t model) {
    Json& kept = documents_[{reference.command, model}];
    if (!kept.is_null()) return kept;
    const Result& result = comparison_.models[model];
    if (reference.command == Command::solve) return kept = document_of(solve_analysis(), result, {});
    return kept = answers_of(source_, case_of(case_, result), reference);
  }

  /// Each reading is a case of its own; those that differ in their load case alone are solved as one. Displacements
  /// have the sign of the force.
  std::vector<double> over_input(const ReferenceCurve& reference, std::size_t model) {
    const bool together = !reference.load_case.empty() && analysis_of(reference).takes_load_cases_apart &&
                          reference.along.find_first_of(".[") == std::string::npos;
    std::vector<Case> cases = together ? std::vector{reference.cases[0]} : reference.cases;
    for (std::size_t k = 1; together && k < reference.cases.size(); ++k) {
      cases[0].load_cases.push_back(reference.cases[k].load_cases[0]);
      cases[0].load_cases.back().name += fmt::format("[{}]", k);
    }
    std::vector<double> values;
    const auto take = [&](const Json& json) {
      values.push_back(number_at(json, "." + reference.response).value_or(kNoAnswer));
    };
    for (const Case& c : cases) {
      const Json document = answers_of(source_, case_of(c, comparison_.models[model]), reference);
      if (reference.load_case.empty())
        take(document);
      else
        std::ranges::for_each(document["load_cases"], take);
    }
    for (const auto k : indices(values))
      if (reference.is_over_force() && reference.readings[k].along < 0.0 &&
          reference.response.ends_with("axial_displacement_um"))
        values[k] = -values[k];
    return values;
  }

  const input::Source& source_;
  const Case& case_;
  const ModelComparison& comparison_;
  std::map<std::pair<Command, std::size_t>, Json> documents_;  ///< By commands and models.
};

/// Sum over a complete set of threads; absent for partial sets and for other responses.
void set_sums(const Case& c, ReferenceComparison& compared) {
  const ReferenceCurve& reference = compared.reference;
  const auto threads = static_cast<std::size_t>(c.mechanism.contacts_per_roller);
  if (!reference.is_over_threads() || reference.readings.size() != threads || c.model.all_rollers()) return;
  const std::string_view key = std::string_view(reference.response).substr(reference.response.find('.') + 1);
  const auto load = std::ranges::find(c.load_cases, reference.load_case, &LoadCase::name);
  if (key == "load_rate_percent")
    compared.expected_sum = 100.0;
  else if (key == "axial_load_N")
    compared.expected_sum = std::abs(load->axial_force) / loaded_rollers(c.mechanism);
  else
    return;
  compared.sum = 0.0;
  for (const ReferenceReading& reading : reference.readings) *compared.sum += reading.value;
}

std::optional<Warning> warning_on_absence(const ReferenceComparison& r) {
  const auto has_answer = [](const ReferenceAnswer& answer) {
    return std::ranges::any_of(answer.computed, [](double value) { return std::isfinite(value); });
  };
  if (std::ranges::any_of(r.models, has_answer)) return std::nullopt;
  return Warning{
      r.reference.at + ".file", "reference_absent",
      fmt::format("{}: the case gives no {}{}{}; `prs {}` shows what it has", r.reference.name, r.reference.response,
                  r.reference.load_case.empty() ? "" : " in ", r.reference.load_case, name(r.reference.command))};
}

std::optional<Warning> warning_on_sum(const ReferenceComparison& r) {
  constexpr double kMost = 0.01;
  if (!r.sum || std::abs(*r.sum - *r.expected_sum) <= kMost * std::abs(*r.expected_sum)) return std::nullopt;
  return Warning{r.reference.at + ".file", "reference_sum",
                 fmt::format("{}, {} of {}: the threads sum to {:.6g} {}, the load of a roller is {:.6g} {}; check how "
                             "the reference is normalised",
                             r.reference.name, r.reference.response, r.reference.load_case, *r.sum, r.reference.unit,
                             *r.expected_sum, r.reference.unit)};
}

}  // namespace

void compare_references(const input::Source& source, const Case& c, std::vector<ReferenceCurve> references,
                        ModelComparison& comparison) {
  References all(source, c, comparison);
  std::vector<ReferenceComparison> found;
  for (ReferenceCurve& reference : references) {
    ReferenceComparison compared{std::move(reference), {}, comparison.stated, {}, {}, {}};
    for (const auto m : indices(comparison.models)) compared.models.push_back(all.answer(compared.reference, m));
    if (compared.reference.is_over_force())
      compared.slope = slope(References::forces_of(compared.reference), compared.reference.values());
    set_sums(c, compared);
    for (const auto& warning : {warning_on_sum(compared), warning_on_absence(compared)})
      if (warning) comparison.warnings.push_back(*warning);
    found.push_back(std::move(compared));
  }
  comparison.references = std::move(found);
}

}  // namespace prs
