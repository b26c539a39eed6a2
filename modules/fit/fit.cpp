#include "modules/fit/fit.h"

#include <filesystem>

#include "prs/input/force_history.h"
#include "prs/optimize/optimize_files.h"
#include "prs/study/study_run.h"

namespace prs {
namespace {

using modules::fit::Curve, modules::fit::Problem, modules::fit::Status, modules::fit::Unknown;

Problem problem_of(const FitInput& input, FitEvaluation& evaluation) {
  Problem problem;
  for (const FitParameter& p : input.parameters) {
    problem.unknowns.push_back({.from = p.from, .to = p.to, .start = p.start, .is_log = p.is_log});
    if (p.prior) problem.unknowns.back().prior = {p.prior->mean, p.prior->deviation};
  }
  for (const FitCurve& c : input.curves) {
    Curve curve{.use = c.use, .rows = c.rows, .measured = c.measured, .deviation = c.deviation, .loss = c.loss};
    if (c.has_offset && c.use == FitCurve::Use::fit) {
      const auto [least, greatest] = std::ranges::minmax(c.measured);
      curve.offset = problem.unknowns.size();
      problem.unknowns.push_back(
          {.from = least - greatest, .to = greatest - least, .is_bounded = false, .is_offset = true});
    }
    curve.has_free_mean = c.has_offset && c.use == FitCurve::Use::compare;
    problem.curves.push_back(std::move(curve));
  }
  problem.evaluate = [&evaluation](const std::vector<modules::fit::Request>& r) { return evaluation(r); };
  problem.level = input.level;
  problem.starts = input.starts;
  problem.profile = input.profile;
  return problem;
}

void add_warnings(FitResult& r) {
  using fmt::format;
  const modules::fit::Result& found = r.found;
  const auto warn = [&](std::string path, std::string code, std::string what, std::string fix) {
    r.warnings.push_back({std::move(path), std::move(code), std::move(what), std::move(fix)});
  };
  if (found.failure)
    warn("fit", "no_equilibrium",
         format("no answer at {}: {}", place_of(r.input, found.failure->curve, found.failure->row),
                found.failure->reason),
         "start elsewhere, narrow the bounds, or leave the row out");
  if (!found.unidentified.empty())
    for (const modules::fit::Unidentified& d : found.unidentified) {
      std::vector<std::string> names;
      for (const std::size_t j : d.unknowns) names.push_back(r.name(j));
      if (names.size() == 1)
        warn("fit", "not_identifiable", format("the data do not tell {}", names[0]),
             "fix it, give it a `prior`, or measure under other conditions");
      else
        warn("fit", "not_identifiable", format("the data cannot tell apart {}", fmt::join(names, ", ")),
             "fix one of them, give it a `prior`, or measure under other conditions");
    }
  if (found.without_redundancy) {
    const FitCurve& c = r.input.curves[*found.without_redundancy];
    warn(c.at, "no_redundancy", format("the readings of {} do not tell their deviation", c.name),
         c.deviation.empty() ? "state its `deviation`" : "state a larger `deviation`: most of its rows are outliers");
  }
  if (found.held_by) {
    warn("fit", "iteration_limit",
         format("the search did not come to rest: it is drawn to where {} has no answer: {}",
                place_of(r.input, found.held_by->curve, found.held_by->row), found.held_by->reason),
         "narrow the bounds, look for wrong readings, or leave the row out");
  } else if (found.status == Status::iteration_limit) {
    std::string wide;
    for (std::size_t j = 0; j < r.input.parameters.size(); ++j) {
      const FitParameter& p = r.input.parameters[j];
      const std::optional<double>& value = found.unknowns[j].value;
      if (!p.is_log && p.from >= 0.0 && value && *value > 0.0 && *value - p.from < 0.01 * (p.to - p.from))
        wide += format("{} `scale: log` of {}", wide.empty() ? "" : " and", p.path);
    }
    warn("fit", "iteration_limit", "the search did not come to rest",
         wide.empty() ? "start nearer, or narrow the bounds"
                      : format("its bounds are wide: narrow them, or write{} with `from` above 0", wide));
  }
  for (std::size_t j = 0; j < r.input.parameters.size() && j < found.unknowns.size(); ++j) {
    const modules::fit::UnknownResult& u = found.unknowns[j];
    const std::string& path = r.input.parameters[j].path;
    if (u.at_bound != 0)
      warn(path, "at_bound", format("at its bound `{}`", u.at_bound < 0 ? "from" : "to"),
           "widen the bounds where it may be");
    if (u.profile_failed)
      warn(path, "profile", "an end of its profile was not found", "narrow the bounds, or look at other `starts`");
    if (const auto& prior = r.input.parameters[j].prior;
        prior && !(prior->mean >= r.input.parameters[j].from && prior->mean <= r.input.parameters[j].to))
      warn(path, "prior_outside", "the mean of its prior lies outside of its bounds", "check both");
    if (u.prior_decides)
      warn(path, "prior_decides", "its prior decides: the data hardly add to it", "measure what depends on it");
    if (u.estimate && u.estimate->low <= r.input.parameters[j].from && u.estimate->high >= r.input.parameters[j].to)
      warn(path, "hardly_told", "the data hardly tell it: its interval covers all from `from` to `to`",
           "measure what depends on it");
  }
  const auto systematic = [&](const std::string& at, const std::string& code, const std::string& which, double p) {
    warn(at, code,
         format("{} has a probability of {:.2g} %: the model leaves something systematic, or deviations are too small; "
                "intervals are too narrow then",
                which, 100.0 * p),
         "look at the residuals");
  };
  if (found.p_value && *found.p_value < 0.01) systematic("fit", "chi_square", "chi-square", *found.p_value);
  for (std::size_t c = 0; c < found.curves.size(); ++c) {
    const modules::fit::CurveResult& curve = found.curves[c];
    const FitCurve& its = r.input.curves[c];
    if (curve.runs && curve.runs->p_value < 0.01)
      systematic(its.at, "runs", format("so few runs of sign of {}", its.name), curve.runs->p_value);
    if (curve.is_without_noise)
      warn(its.at, "without_noise", format("the readings of {} are met without noise, intervals say nothing", its.name),
           "state its `deviation`");
    const auto outliers =
        static_cast<std::size_t>(std::ranges::count_if(curve.weight, [](double w) { return w < 0.5; }));
    if (its.loss.is_robust() && 4 * outliers > curve.weight.size())
      warn(its.at, "outliers",
           format("{} of {} rows of {} count less than half: its deviation is too small, or the model leaves something",
                  outliers, curve.weight.size(), its.name),
           "look at the residuals");
  }
  if (std::ranges::any_of(found.starts, &modules::fit::StartResult::is_another_minimum))
    warn("fit.starts", "another_minimum", "another start ended at another minimum that is nearly as good",
         "compare `starts`");
}

}  // namespace

constexpr std::string_view kTables[] = {"fit_parameters.csv", "residuals.csv", "fit_bands.csv"};

std::string_view name(Status status) {
  constexpr std::string_view kNames[] = {"no_equilibrium", "not_identifiable", "no_redundancy", "iteration_limit",
                                         "converged"};
  return kNames[static_cast<std::size_t>(status)];
}

std::string place_of(const FitInput& input, std::size_t curve, std::size_t row) {
  const FitCurve& c = input.curves[curve];
  if (c.use == FitCurve::Use::band) return fmt::format("band {}, row {}", c.name, row + 1);
  return fmt::format("{}, {}:{}", c.name, name_in_messages(c.file, input.source), c.lines[row]);
}

const FitCurve& FitResult::curve_of_offset(std::size_t unknown) const {
  std::size_t at = input.parameters.size();
  for (const FitCurve& c : input.curves)
    if (c.has_offset && c.use == FitCurve::Use::fit && at++ == unknown) return c;
  throw std::logic_error("no such offset");
}

std::string FitResult::name(std::size_t unknown) const {
  const FitParameter* p = parameter(unknown);
  return p ? p->path : "offset of " + curve_of_offset(unknown).name;
}

std::string FitResult::unit(std::size_t unknown) const {
  const FitParameter* p = parameter(unknown);
  return p ? p->unit : curve_of_offset(unknown).unit;
}

std::string fit_text(double value, std::string_view unit) {
  return fmt::format("{:.10g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string name_of_copy(const FitInput& input, std::size_t curve) {
  const auto plain = [&](std::size_t c) { return std::filesystem::path(input.curves[c].file).filename().string(); };
  const auto clashes = [&](std::size_t c) {
    return plain(c) == plain(curve) && input.curves[c].file != input.curves[curve].file;
  };
  bool taken = std::ranges::find(kTables, plain(curve)) != std::end(kTables);
  for (std::size_t c = 0; c < input.curves.size(); ++c)
    taken = taken || (input.curves[c].use != FitCurve::Use::band && clashes(c));
  return taken ? fmt::format("{}_{}", curve + 1, plain(curve)) : plain(curve);
}

std::string fitted_case(const FitResult& r) {
  std::vector<std::string> overrides;
  std::vector<std::pair<std::string, std::string>> remarks;
  for (std::size_t j = 0; j < r.input.parameters.size(); ++j) {
    const FitParameter& p = r.input.parameters[j];
    const modules::fit::UnknownResult& u = r.found.unknowns[j];
    const std::string value = fit_text(*u.value, p.unit);
    overrides.push_back(fmt::format("{}={}", p.path, value));
    // A repeated fit then starts at its end.
    if (p.has_start) overrides.push_back(fmt::format("fit.parameters[{}].start={}", j, value));
    std::string remark = u.at_bound != 0 ? "fitted, at its bound" : "fitted";
    if (u.estimate) {
      const auto text = [&](double x) { return fmt::format("{:.5g}", x); };
      remark = fmt::format("fitted: standard deviation {}, {:g} % interval {} to {}",
                           fmt::format("{:.3g}{}{}", u.estimate->deviation, p.unit.empty() ? "" : " ", p.unit),
                           100.0 * r.input.level, text(u.estimate->low),
                           fmt::format("{}{}{}", text(u.estimate->high), p.unit.empty() ? "" : " ", p.unit));
    }
    remarks.emplace_back(p.path, remark + (p.stood.empty() ? "; the file said nothing" : "; was " + p.stood));
  }
  const input::Source& source = r.input.source;
  // The readings are copied with the file.
  for (std::size_t c = 0; c < r.input.curves.size(); ++c)
    if (const FitCurve& curve = r.input.curves[c]; curve.use != FitCurve::Use::band)
      if (const std::string name = name_of_copy(r.input, c); name != curve.file)
        overrides.push_back(fmt::format("{}.file=\"{}\"", curve.at, name));
  std::string command = fmt::format("prs fit {}", source.name);
  for (const std::string& one : source.overrides) command += fmt::format(" --set '{}'", one);
  const std::string plain = case_with(source, overrides, fmt::format("Fitted by `{}`", command));
  const auto document = [&](const std::string& text) {
    const input::Source one{source.name, text, {}};
    input::ErrorList errors(one);
    return read_document(one, errors);
  };
  try {
    const input::Node root = document(plain);
    std::string text = plain;
    std::vector<std::pair<std::size_t, std::string>> lines;
    for (const auto& [path, remark] : remarks) {
      const input::Node* node = find_path(root, path);
      const std::size_t at = (node->key.empty() ? node->place : node->key_place).offset;
      const std::size_t line = at == 0 ? 0 : plain.rfind('\n', at - 1) + 1;
      lines.emplace_back(line, std::string(plain.find_first_not_of(' ', line) - line, ' ') + "# " +
                                   path.substr(path.rfind('.') + 1) + ": " + remark + "\n");
    }
    std::ranges::stable_sort(lines, {}, [](const auto& l) { return l.first; });
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) text.insert(line->first, line->second);
    if (flow_text(document(text)) == flow_text(root)) return text;
  } catch (const input::InputError&) {  // Where no comment is allowed there are none.
  }
  return plain;
}

FitResult fit_case(const input::Source& source, const FitOptions& options) {
  const auto& module = modules::loaded<modules::fit::FitModule>();
  FitResult result{.input = read_fit_input(source), .found = {}, .warnings = {}};
  FitEvaluation evaluation(result.input, options.threads == 0 ? default_threads() : options.threads);
  result.found = module.solve(problem_of(result.input, evaluation));
  result.evaluations = evaluation.rows();
  const modules::fit::Result& found = result.found;
  if (found.without_influence)
    input::fail_at(source, fmt::format("fit.parameters[{}].path", *found.without_influence),
                   "got {}, on which no curve depends at the start; expected one that moves a response; measure what "
                   "depends on it, or delete it",
                   result.name(*found.without_influence));
  if (found.failed_at_start && found.failure && found.failure->is_refused)
    input::fail_at(source, result.input.curves[found.failure->curve].at,
                   "got a case that its command refuses at {}: {}",
                   place_of(result.input, found.failure->curve, found.failure->row), found.failure->reason);
  add_warnings(result);
  return result;
}

}  // namespace prs
