#include "prs/compare/compare_models.h"
#include "prs/input/document.h"
#include "prs/loads/analyze.h"
#include "prs/losses/slip_analysis.h"
#include "prs/model/check_case.h"
#include "prs/record/response_path.h"

namespace prs {
namespace {

constexpr double kNoAnswer = std::numeric_limits<double>::quiet_NaN();

/// Documents of the load cases of a case, as `solve` or `slip` has them.
struct Answers {
  Result result;
  std::vector<Json> load_cases;
};

Answers answers_of(Result result, bool with_slip) {
  Answers answers{std::move(result), {}};
  const auto load_case = with_slip ? slip_analysis().load_case : load_case_json;
  for (std::size_t k = 0; auto json = load_case(answers.result, k); ++k) answers.load_cases.push_back(*std::move(json));
  return answers;
}

Answers computed(const input::Source& source, const Case& c, bool with_slip) {
  if (!with_slip) return answers_of(analyze(c), false);
  input::CaseInput in;
  in.values = c;
  return answers_of(slip_analysis().run(source, in), true);
}

/// Threads of the most loaded roller of a full mechanism, of a sector those of its roller.
std::vector<double> threads_of(const Json* series, const LoadCaseResult& result, std::string_view response) {
  if (!series || !series->is_array() || series->empty()) return {};
  const Interface i = response.find("nut.") == response.npos ? Interface::screw : Interface::nut;
  const bool in_rows = (*series)[0].is_array() && result.threads && (*result.threads)[i].rollers;
  const Json& row =
      in_rows ? (*series)[static_cast<std::size_t>((*result.threads)[i].rollers->largest_roller - 1)] : *series;
  std::vector<double> values;
  for (const Json& entry : row) values.push_back(entry.is_number() ? entry.get<double>() : kNoAnswer);
  return values;
}

class References {
 public:
  References(const input::Source& source, const Case& c, const ModelComparison& comparison)
      : source_(source), case_(c), comparison_(comparison), solved_(comparison.models.size()), slip_(solved_.size()) {}

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

  /// Forces of the readings [N].
  static std::vector<double> forces_of(const ReferenceCurve& reference) {
    return each(reference.cases, [](const Case& c) { return c.load_cases.front().axial_force; });
  }

 private:
  std::vector<double> in_load_case(const ReferenceCurve& reference, std::size_t model) {
    const Answers& answers = answers_of_model(reference, model);
    const auto found = std::ranges::find(answers.result.load_cases, reference.load_case,
                                         [](const LoadCaseResult& r) { return r.load_case.name; });
    std::vector<double> values(reference.readings.size(), kNoAnswer);
    const auto k = static_cast<std::size_t>(found - answers.result.load_cases.begin());
    if (k >= answers.load_cases.size()) return values;
    const Json& json = answers.load_cases[k];
    if (!reference.is_over_threads()) {
      values[0] = number_at(json, "." + reference.response).value_or(kNoAnswer);
      return values;
    }
    const std::vector<double> threads = threads_of(value_at(json, reference.response), *found, reference.response);
    for (std::size_t r = 0; r < values.size(); ++r)
      if (const auto thread = static_cast<std::size_t>(reference.readings[r].along); thread <= threads.size())
        values[r] = threads[thread - 1];
    return values;
  }

  const Answers& answers_of_model(const ReferenceCurve& reference, std::size_t model) {
    std::optional<Answers>& kept = (is_of_slip(reference.response) ? slip_ : solved_)[model];
    if (kept) return *kept;
    const Result& result = comparison_.models[model];
    if (!is_of_slip(reference.response)) return kept.emplace(answers_of(result, false));
    if (const std::vector<Problem> lacks = missing(case_, Command::slip); !lacks.empty())
      input::fail_at(source_, reference.at + ".file", "got {} of a case that `prs slip` cannot run: {}: {}",
                     reference.response, lacks[0].path, lacks[0].message);
    return kept.emplace(computed(source_, case_of(case_, result), true));
  }

  /// Each reading is a case of its own; those that differ in their load case alone are solved as one.
  std::vector<double> over_input(const ReferenceCurve& reference, std::size_t model) {
    const bool of_load = reference.along.find_first_of(".[") == std::string::npos;
    std::vector<Case> cases = of_load ? std::vector{reference.cases[0]} : reference.cases;
    for (std::size_t k = 1; of_load && k < reference.cases.size(); ++k)
      cases[0].load_cases.push_back(reference.cases[k].load_cases[0]);
    std::vector<double> values;
    for (const Case& c : cases) {
      const Answers answers = computed(source_, case_of(c, comparison_.models[model]), is_of_slip(reference.response));
      for (const Json& json : answers.load_cases)
        values.push_back(number_at(json, "." + reference.response).value_or(kNoAnswer));
    }
    return values;
  }

  const input::Source& source_;
  const Case& case_;
  const ModelComparison& comparison_;
  std::vector<std::optional<Answers>> solved_, slip_;
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
    compared.expected_sum = std::abs(load->axial_force) / c.mechanism.rollers;
  else
    return;
  compared.sum = 0.0;
  for (const ReferenceReading& reading : reference.readings) *compared.sum += reading.value;
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
    for (std::size_t m = 0; m < comparison.models.size(); ++m)
      compared.models.push_back(all.answer(compared.reference, m));
    if (compared.reference.is_over_force())
      compared.slope = slope(References::forces_of(compared.reference), compared.reference.values());
    set_sums(c, compared);
    if (auto warning = warning_on_sum(compared)) comparison.warnings.push_back(*std::move(warning));
    found.push_back(std::move(compared));
  }
  comparison.references = std::move(found);
}

}  // namespace prs
