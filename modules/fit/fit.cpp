#include "modules/fit/fit.h"

#include <filesystem>
#include <map>

#include "modules/fit/fit_evaluation.h"
#include "modules/fit/fit_reader.h"
#include "prs/input/force_history.h"
#include "prs/optimize/optimize_files.h"
#include "prs/record/record_table.h"
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

void warn(FitResult& r, std::string path, std::string code, std::string what, std::string fix) {
  r.warnings.push_back({std::move(path), std::move(code), std::move(what), std::move(fix)});
}

void warn_of_unidentified(FitResult& r) {
  for (const modules::fit::Unidentified& d : r.found.unidentified) {
    const auto names = each(d.unknowns, [&](std::size_t j) { return r.name(j); });
    const bool is_one = names.size() == 1;
    warn(r, "fit", "not_identifiable",
         fmt::format("the data {} {}", is_one ? "do not determine" : "cannot separate", fmt::join(names, ", ")),
         fmt::format("fix {}, give it a `prior`, or measure under other conditions", is_one ? "it" : "one of them"));
  }
  if (!r.found.without_redundancy) return;
  const FitCurve& c = r.input.curves[*r.found.without_redundancy];
  warn(r, c.at, "no_redundancy", fmt::format("the readings of {} do not determine their deviation", c.name),
       c.deviation.empty() ? "state its `deviation`" : "state a larger `deviation`: most of its rows are outliers");
}

/// Parameters whose bounds are wide beside their values.
std::string wide_bounds(const FitResult& r) {
  std::string wide;
  for (std::size_t j = 0; j < r.input.parameters.size(); ++j) {
    const FitParameter& p = r.input.parameters[j];
    const double value = r.found.unknowns[j].value.value_or(0.0);
    if (!p.is_log && p.from >= 0.0 && value > 0.0 && value - p.from < 0.01 * (p.to - p.from))
      wide += fmt::format("{} `scale: log` of {}", wide.empty() ? "" : " and", p.path);
  }
  return wide;
}

void warn_of_search(FitResult& r) {
  const modules::fit::Result& found = r.found;
  const auto place = [&](const modules::fit::Failure& f) { return place_of(r.input, f.curve, f.row); };
  if (found.failure)
    warn(r, "fit", "no_equilibrium", fmt::format("no answer at {}: {}", place(*found.failure), found.failure->reason),
         "start elsewhere, narrow the bounds, or leave the row out");
  warn_of_unidentified(r);
  if (found.held_by) {
    warn(r, "fit", "iteration_limit",
         fmt::format("the search did not converge: it leads to where {} has no answer: {}", place(*found.held_by),
                     found.held_by->reason),
         "narrow the bounds, look for wrong readings, or leave the row out");
  } else if (found.status == Status::iteration_limit) {
    const std::string wide = wide_bounds(r);
    warn(r, "fit", "iteration_limit", "the search did not converge",
         wide.empty() ? "start nearer, or narrow the bounds"
                      : fmt::format("its bounds are wide: narrow them, or write{} with `from` above 0", wide));
  }
}

void warn_of_parameter(FitResult& r, const FitParameter& p, const modules::fit::UnknownResult& u) {
  if (u.at_bound != 0)
    warn(r, p.path, "at_bound", fmt::format("at its bound `{}`", u.at_bound < 0 ? "from" : "to"),
         "widen the bounds where it may be");
  if (u.profile_failed)
    warn(r, p.path, "profile", "an end of its profile was not found", "narrow the bounds, or look at other `starts`");
  if (p.prior && !(p.prior->mean >= p.from && p.prior->mean <= p.to))
    warn(r, p.path, "prior_outside", "the mean of its prior lies outside of its bounds", "check both");
  if (u.prior_decides)
    warn(r, p.path, "prior_decides", "its prior decides its value: the data add little", "measure what depends on it");
  if (u.estimate && u.estimate->low <= p.from && u.estimate->high >= p.to)
    warn(r, p.path, "hardly_told", "the data hardly determine it: its interval covers all from `from` to `to`",
         "measure what depends on it");
}

void warn_of_probability(FitResult& r, const std::string& at, const std::string& code, const std::string& of,
                         double p) {
  if (p < 0.01)
    warn(r, at, code,
         fmt::format("{} has a probability of {:.2g} %: the model leaves something systematic, or deviations are too "
                     "small; intervals are too narrow then",
                     of, 100.0 * p),
         "look at the residuals");
}

void warn_of_curve(FitResult& r, const FitCurve& c, const modules::fit::CurveResult& found) {
  if (found.runs)
    warn_of_probability(r, c.at, "runs", fmt::format("so few sign changes of the residuals of {}", c.name),
                        found.runs->p_value);
  if (found.is_without_noise)
    warn(r, c.at, "without_noise",
         fmt::format("the fit meets the readings of {} without noise, so intervals have no meaning", c.name),
         "state its `deviation`");
  const auto outliers = static_cast<std::size_t>(std::ranges::count_if(found.weight, [](double w) { return w < 0.5; }));
  if (c.loss.is_robust() && 4 * outliers > found.weight.size())
    warn(r, c.at, "outliers",
         fmt::format("{} of {} rows of {} count less than half: its deviation is too small, or the model leaves a "
                     "systematic error",
                     outliers, found.weight.size(), c.name),
         "look at the residuals");
}

void add_warnings(FitResult& r) {
  warn_of_search(r);
  const modules::fit::Result& found = r.found;
  for (std::size_t j = 0; j < r.input.parameters.size() && j < found.unknowns.size(); ++j)
    warn_of_parameter(r, r.input.parameters[j], found.unknowns[j]);
  warn_of_probability(r, "fit", "chi_square", "chi-square", found.p_value.value_or(1.0));
  for (std::size_t c = 0; c < found.curves.size(); ++c) warn_of_curve(r, r.input.curves[c], found.curves[c]);
  if (std::ranges::any_of(found.starts, &modules::fit::StartResult::is_another_minimum))
    warn(r, "fit.starts", "another_minimum", "another start ended at another minimum that is nearly as good",
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

namespace {

/// How well a parameter is known, for the line above it.
std::string remark_on(const FitParameter& p, const modules::fit::UnknownResult& u, double level) {
  std::string remark = u.at_bound != 0 ? "fitted, at its bound" : "fitted";
  if (const auto& e = u.estimate) {
    const std::string unit = p.unit.empty() ? "" : " " + p.unit;
    remark = fmt::format("fitted: standard deviation {:.3g}{}, {:g} % interval {:.5g} to {:.5g}{}", e->deviation, unit,
                         100.0 * level, e->low, e->high, unit);
  }
  return fmt::format("# {}: {}; {}\n", p.path.substr(p.path.rfind('.') + 1), remark,
                     p.stood.empty() ? "the file said nothing" : "was " + p.stood);
}

/// The text with the remark of each parameter above its line; without them where no comment may stand.
std::string with_remarks(const std::string& text, const FitResult& r) {
  const auto document = [&](const std::string& of) {
    const input::Source one{r.input.source.name, of, {}};
    input::ErrorList errors(one);
    return read_document(one, errors);
  };
  try {
    const input::Node root = document(text);
    std::multimap<std::size_t, std::string, std::greater<>> lines;  // The last one first.
    for (std::size_t j = r.input.parameters.size(); j-- > 0;) {
      const FitParameter& p = r.input.parameters[j];
      const input::Node* node = find_path(root, p.path);
      const std::size_t at = (node->key.empty() ? node->place : node->key_place).offset;
      const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
      lines.emplace(line, std::string(text.find_first_not_of(' ', line) - line, ' ') +
                              remark_on(p, r.found.unknowns[j], r.input.level));
    }
    std::string all = text;
    for (const auto& [line, remark] : lines) all.insert(line, remark);
    if (flow_text(document(all)) == flow_text(root)) return all;
  } catch (const input::InputError&) {
  }
  return text;
}

}  // namespace

std::string fitted_case(const FitResult& r) {
  std::vector<std::string> overrides;
  for (std::size_t j = 0; j < r.input.parameters.size(); ++j) {
    const FitParameter& p = r.input.parameters[j];
    const std::string value = fit_text(*r.found.unknowns[j].value, p.unit);
    overrides.push_back(fmt::format("{}={}", p.path, value));
    // A repeated fit then starts at its end.
    if (p.has_start) overrides.push_back(fmt::format("fit.parameters[{}].start={}", j, value));
  }
  const input::Source& source = r.input.source;
  // The readings are copied with the file.
  for (std::size_t c = 0; c < r.input.curves.size(); ++c)
    if (const FitCurve& curve = r.input.curves[c]; curve.use != FitCurve::Use::band)
      if (const std::string name = name_of_copy(r.input, c); name != curve.file)
        overrides.push_back(fmt::format("{}.file=\"{}\"", curve.at, name));
  std::string command = fmt::format("prs fit {}", source.name);
  for (const std::string& one : source.overrides) command += fmt::format(" --set '{}'", one);
  return with_remarks(case_with(source, overrides, fmt::format("Fitted by `{}`", command)), r);
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
