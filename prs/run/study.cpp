#include "prs/run/study.h"

#include <chrono>
#include <iterator>
#include <map>

#include "prs/indices.h"
#include "prs/input/force_history.h"
#include "prs/model/check_case.h"
#include "prs/optimize/optimize_files.h"
#include "prs/sha256.h"
#include "prs/version.h"

namespace prs {
namespace {

/// Time after which results go into the journal, as soon as the current design is done.
constexpr std::chrono::seconds kLongestBlock{1};

/// Reports a response that the base case does not have where it stands in the file.
template <class Compute>
auto with_responses_of(const input::StudyInput& in, Compute compute) {
  try {
    return compute(in);
  } catch (const UnknownResponse& error) {
    const std::size_t k = error.index();
    const auto in_envelope = place_in_envelope(in.study, in.study.responses[k]);
    input::fail_at(in.source, in_envelope.value_or(fmt::format("study.responses[{}]", k)), error.what());
  }
}

/// Numbers that the load distribution alone decides, and nothing of the geometry besides.
bool is_of_load_distribution(std::string_view response) {
  if (response.starts_with("load_cases[")) response.remove_prefix(std::min(response.find('.') + 1, response.size()));
  static constexpr std::string_view kOfCase[] = {"axial_displacement_um", "axial_stiffness_N_per_um",
                                                 "tangent_stiffness_N_per_um"};
  if (contains(kOfCase, response)) return true;
  static constexpr std::string_view kOfThreads[] = {"axial_load_N", "normal_load_N",    "load_rate_percent",
                                                    "approach_um",  "normal_angle_deg", "hertz_constant_N_per_mm1_5"};
  for (const std::string_view interface : {"screw.", "nut."})
    if (response.starts_with(interface)) {
      response.remove_prefix(interface.size());
      return std::ranges::find(kOfThreads, response.substr(0, response.find_first_of(".["))) != std::end(kOfThreads);
    }
  return false;
}

bool is_of_geometry(std::string_view response) {
  return response.starts_with("contact.") || response.starts_with("threads.");
}

/// `still`: the responses that do not follow the factor.
Warning void_warning(const std::string& path, const std::vector<std::string>& still, std::string_view overrides) {
  std::string named;
  if (!still.empty())
    named = still.size() == 1 ? fmt::format(" ({})", still[0])
                              : fmt::format(" ({} and {} more)", still[0], still.size() - 1);
  return {path, "void_factor", fmt::format("moves no load or stiffness{}: overridden by {}", named, overrides),
          std::string(kDeleteOverrides)};
}

/// Void input of a factor or one of its companions.
const VoidInput* void_factor(const std::vector<VoidInput>& inputs, const Factor& factor) {
  const auto is_void = [&](const Factor& companion) { return find_void(inputs, companion.path); };
  return std::ranges::all_of(factor.companions, is_void) ? find_void(inputs, factor.path) : nullptr;
}

Warning idle_warning(const Factor& factor) {
  return {factor.path, "idle_factor", "moved no response: all stay the same to the last digit",
          "add a response that follows it, or delete the factor"};
}

/// Factors by which no response has a derivative other than 0.
std::vector<Warning> idle_warnings(const CaseDerivatives& result) {
  std::vector<Warning> warnings;
  for (const auto f : indices(result.factors)) {
    const auto is_zero = [](const std::optional<Derivative>& d) { return d && d->value == 0.0; };
    const auto& responses = result.factors[f].responses;
    if (!responses.empty() && std::ranges::all_of(responses, is_zero))
      warnings.push_back(idle_warning(result.study.factors[f]));
  }
  return warnings;
}

/// Settings by which a case reads the same force history in any folder: the place of its file, and its hash.
std::vector<std::string> place_of_history(const input::Source& source) try {
  input::ErrorList errors(source);
  const input::Node root = input::read_document(source, errors);
  const std::string file_key = "life.history.file", hash_key = "life.history.sha256";
  const input::Node* file = find_path(root, file_key);
  if (!file) return {};
  const std::string text = input::named_file_text(file->text, file_key, source, find_path(root, hash_key));
  return {fmt::format("{}=\"{}\"", file_key, input::place_of_file(file->text, source).string()),
          fmt::format("{}={}", hash_key, sha256(text))};
} catch (const input::InputError&) {  // The search does not read it.
  return {};
}

DesignEngine engine_of(const input::OptimizeInput& in) {
  try {
    return DesignEngine(in.start, simd::InstructionSet::best, Arrays::refused);
  } catch (const UnknownResponse& error) {
    const std::string& at = in.asked_at[error.index()];
    if (at != "optimize.thread_constraints") input::fail_at(in.start.source, at, error.what());
    input::fail_at(in.start.source, at,
                   fmt::format("needs {}, which this mechanism does not have; expected threads "
                               "with heights and a contact at both interfaces; give "
                               "`mechanism.thread` of screw, roller and nut",
                               in.optimization.study.responses[error.index()]));
  }
}

std::string remark(const OptimizationResult& result, const std::string& file) {
  const std::size_t chosen = result.compromise.value_or(result.nearest.value_or(0));
  return fmt::format(
      "{} of `prs optimize {}`, {} with seed {}: design {} of {}", result.compromise ? "Compromise" : "Nearest design",
      file, name(result.search_of(chosen).algorithm), result.optimization.seed, chosen + 1, result.design_count());
}

}  // namespace

DesignEngine study_engine(const input::StudyInput& in) {
  return with_responses_of(in, [](const input::StudyInput& i) { return DesignEngine(i); });
}

CaseDerivatives run_derivatives(const input::StudyInput& in) {
  CaseDerivatives result = input::compute_from(in.source, [&] { return with_responses_of(in, case_derivatives); });
  result.warnings = void_factor_warnings(in, result.study.responses);
  for (Warning& warning : idle_warnings(result)) result.warnings.push_back(std::move(warning));
  return result;
}

std::vector<Warning> void_factor_warnings(const input::StudyInput& in, const std::vector<std::string>& responses) {
  std::vector<Warning> warnings;
  if (in.study.command == Command::contact || std::ranges::all_of(responses, is_of_geometry)) return warnings;
  // The model of the bodies determines which inputs are void.
  const auto changes_model = [](const DrawnInput& drawn) { return drawn.input->path.starts_with("model"); };
  if (std::ranges::any_of(drawn_inputs(in.study), changes_model)) return warnings;
  const std::vector<VoidInput> inputs = void_inputs(input::read_design(in, {}));
  if (inputs.empty()) return warnings;
  std::vector<std::string> still;
  std::ranges::copy_if(responses, std::back_inserter(still), is_of_load_distribution);
  for (const Factor& factor : in.study.factors)
    if (const VoidInput* input = void_factor(inputs, factor))
      warnings.push_back(void_warning(factor.path, still, input->overrides));
  return warnings;
}

namespace {

/// Warnings for assumed values of the file that do not follow the factors and refuse designs, one each.
std::vector<Warning> assumed_value_warnings(const input::StudyInput& in, const StudyResult& result) {
  std::map<std::string, std::size_t> refusals;
  constexpr std::string_view kPlaced = ": error: ";  // Text after file, line and column, if they are known.
  for (const StudyRow& row : result.rows) {
    if (row.status.name != "refused") continue;
    const std::string& reason = row.status.reason;
    const std::size_t at = reason.find(kPlaced), path = at == reason.npos ? 0 : at + kPlaced.size();
    ++refusals[reason.substr(path, reason.find(':', path) - path)];
  }
  if (refusals.empty()) return {};
  input::DesignFile base = input::read_design_file(in, {});
  const auto assumed = input::assumptions(input::echo(std::move(base.file), base.root), in.source);
  std::vector<Warning> warnings;
  for (const auto& [path, count] : refusals)
    if (assumed.contains(path))
      warnings.push_back(
          {path, "assumed_value",
           fmt::format("assumed for the values of the file, it does not follow the factors, and refuses {} "
                       "design{}",
                       count, count == 1 ? "" : "s"),
           "change it `with` the factor, or write each design by `prs new`"});
  return warnings;
}

}  // namespace

std::vector<Warning> study_warnings(const input::StudyInput& in, const StudyResult& result,
                                    const std::function<const DesignEngine&()>& engine) {
  const Study& study = result.study;
  std::vector<Warning> warnings = void_factor_warnings(in, study.responses);
  std::vector<std::size_t> idle = result.summary.idle_factors;
  if (is_sampled(study.plan) && study.plan != Plan::sobol_indices) {
    if (engine)
      idle =
          idle_drawn_factors(study, result.summary.surfaces ? &*result.summary.surfaces : nullptr,
                             [&](const std::vector<std::vector<Draw>>& designs) { return engine().evaluate(designs); });
    else
      warnings.push_back({"study", "idle_factors_unknown",
                          "whether each factor moves a response was not looked at, which "
                          "takes the force history",
                          "run the study in one piece for that"});
  }
  for (const std::size_t f : idle) warnings.push_back(idle_warning(study.factors[f]));
  append(warnings, assumed_value_warnings(in, result));
  return warnings;
}

Evaluate evaluate_with(const DesignEngine& engine, const std::function<bool()>& interrupted) {
  return [&, interrupted](std::size_t first, std::size_t count) {
    if (interrupted && interrupted()) return RowBlock{first, 0, {}, {}};
    const auto end = std::chrono::steady_clock::now() + kLongestBlock;
    return engine.evaluate(first, count,
                           [&] { return (interrupted && interrupted()) || std::chrono::steady_clock::now() > end; });
  };
}

std::string key_of(const input::StudyInput& in, Command command) {
  std::vector<std::string> referred;
  if (command == Command::life)
    if (const Case base = input::read_design(in, {}); base.life->history)
      referred.push_back(sha256(input::force_history_text(*base.life->history, in.source)));
  return study_key(kVersion, in.source, referred);
}

void check_initial(const input::OptimizeInput& input, const EvaluatedDesign& initial) {
  for (const Constraint& constraint : input.optimization.constraints) {
    if (constraint.limit.kind != Limit::Kind::initial) continue;
    if (std::isfinite(initial.responses[constraint.response])) continue;
    const std::string reason = initial.status.reason.empty()
                                   ? "it has no " + input.optimization.study.responses[constraint.response]
                                   : initial.status.reason;
    input::fail_at(input.start.source, input.asked_at[constraint.response],
                   fmt::format("got a limit relative to the file's own design, which has no answer ({}); "
                               "expected a design that has one; fix the file, or write the limit as a "
                               "number",
                               reason));
  }
}

std::optional<OptimizationResult> run_optimization(const input::OptimizeInput& in, std::size_t threads,
                                                   const std::function<Journal(const JournalHeader&)>& open,
                                                   const OptimizeOptions& options) {
  const DesignEngine engine = engine_of(in);
  const Optimization& optimization = in.optimization;
  const EvaluateDesigns evaluate = evaluate_in_parallel(engine, threads);
  const std::vector<Draw> as_in_file(optimization.study.factors.size());
  const RowBlock base = evaluate({as_in_file});
  check_initial(in,
                {as_in_file, base.responses, base.failures.empty() ? DesignStatus{} : base.failures[0].status, 0.0});

  Journal journal = open({key_of(in.start, optimization.study.command), in.start.source, optimization.study.responses,
                          design_count(optimization), Shard{}});
  return optimize(optimization, evaluate, journal, options);
}

std::optional<std::string> chosen_case(const OptimizationResult& result, const input::Source& source) {
  const EvaluatedDesign* chosen = result.chosen();
  if (chosen == nullptr) return std::nullopt;
  std::vector<std::string> settings = settings_of(result.optimization, *chosen);
  append(settings, place_of_history(source));
  return case_with(source, settings, remark(result, source.name));
}

}  // namespace prs
