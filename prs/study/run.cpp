#include "prs/study/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <string_view>

#include "prs/analyze.h"
#include "prs/case_error.h"
#include "prs/input/did_you_mean.h"
#include "prs/output/json.h"
#include "prs/output/slip_quantities.h"
#include "prs/slip.h"
#include "prs/study/response.h"

namespace prs {
namespace {

Result analyze_for(Command command, const Case& c) {
  if (command == Command::contact) return analyze_contacts(c);
  return command == Command::slip ? analyze_slip(c) : analyze(c);
}

/// That of the first load case which did not converge.
DesignStatus status_of(const Result& result) {
  for (const LoadCaseResult& load_case : result.load_cases) {
    const bool slips = load_case.slip.has_value();
    if (load_case.converged() && (!slips || load_case.slip->converged())) continue;
    const std::string name(slips ? slip_status_name(load_case) : status_name(load_case));
    return {name, fmt::format("load case {} did not converge", load_case.load_case.name)};
  }
  return {};
}

/// Without what only a single result shows.
std::optional<SlipResult> summary_of(const Result& result) {
  if (result.load_cases.empty() || !result.load_cases[0].slip) return std::nullopt;
  SlipResult slip = *result.load_cases[0].slip;
  slip.threads = {};
  return slip;
}

/// The study's responses as far as the document has them, or those of its command.
std::vector<std::string> recorded(const Study& study, const nlohmann::ordered_json& document) {
  if (study.responses.empty()) {
    std::vector<std::string> paths = default_responses(study.command);
    if (!document.is_null())
      std::erase_if(paths, [&](const std::string& path) { return !response(document, path); });
    return paths;
  }
  if (document.is_null()) return study.responses;
  for (std::size_t k = 0; k < study.responses.size(); ++k) {
    const std::string& path = study.responses[k];
    if (response(document, path)) continue;
    const std::vector<std::string> known = response_paths(document);
    const std::string nearest = input::did_you_mean(path, {known.begin(), known.end()});
    throw UnknownResponse(
        k, fmt::format("got {}; expected the path of a number in the first load case, or in the "
                       "document, that the command prints with --json; {}",
                       input::shown(path),
                       nearest.empty() ? "write for example `" + known.front() + "`" : nearest));
  }
  return study.responses;
}

StudyRow row_of(Design design, Answer answer, const std::vector<std::string>& responses) {
  StudyRow row{std::move(design), std::move(answer.status), {}, std::move(answer.slip)};
  for (const std::string& path : responses)
    row.responses.push_back(row.status.converged() ? response(answer.document, path)
                                                   : std::nullopt);
  return row;
}

}  // namespace

Answer solve_design(const input::StudyInput& input, const std::vector<std::string>& overrides) {
  try {
    const Result result = analyze_for(input.study.command, input::read_design(input, overrides));
    return {status_of(result), to_json(result, {}), summary_of(result)};
  } catch (const input::InputError& error) {
    return {{"refused", error.what()}};
  } catch (const CaseError& error) {
    return {{"refused", fmt::format("{}: {}", error.path(), error.what())}};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {{"failed", error.what()}};
  }
}

StudyResult run_study(const Study& study, const Solve& solve, const Progress& progress) {
  StudyResult result{study, {}};
  const std::size_t count = design_count(study);
  result.rows.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const Design d = design(study, k);
    Answer answer = solve(overrides(study, d));
    if (k == 0)
      result.study.responses =
          recorded(study, answer.status.converged() ? answer.document : nullptr);
    result.rows.push_back(row_of(d, std::move(answer), result.study.responses));
    if (progress) progress(k + 1, count);
  }
  return result;
}

}  // namespace prs
