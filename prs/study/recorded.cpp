#include "prs/study/recorded.h"

#include <fmt/ranges.h>

#include "prs/indices.h"
#include "prs/input/did_you_mean.h"
#include "prs/study/response.h"

namespace prs {
namespace {

constexpr std::size_t kShortestArray = 3;

std::string entry(std::string_view path, std::size_t k) { return fmt::format("{}[{}]", path, k); }

/// Most threads of a roller of any design.
std::size_t most_threads(const Study& study, std::size_t threads) {
  double most = static_cast<double>(threads);
  for (const DrawnInput& drawn : drawn_inputs(study)) {
    if (drawn.input->path != "mechanism.contacts_per_roller") continue;
    most = std::max(most, drawn.input->distribution.second);
    for (const Level& level : drawn.input->levels) most = std::max(most, level.number.value_or(0.0));
  }
  return static_cast<std::size_t>(most);
}

/// Reason why the base case has no number at a path.
std::string unknown(const std::string& path, const Json& document) {
  const std::string got = fmt::format("got {}", input::shown(path));
  if (response(document, entry(path, 0) + "[0]"))
    return fmt::format("{}, a row for each roller; expected a number or one row; write for example `{}`", got,
                       entry(path, 0));
  if (path.starts_with("references["))
    return fmt::format(
        "{}; expected a number of a model, as `prs compare FILE --json` shows them, of a case with "
        "`references` that `solve` or `slip` answers; write for example "
        "`references[0].models[0].rms_deviation`",
        got);
  if (const std::size_t end = path.rfind('['); path.ends_with(']') && end != path.npos)
    if (const std::size_t count = entries(document, path.substr(0, end)))
      return fmt::format("{}; expected an entry of an array of {}; write `{}` to `{}`", got, count,
                         entry(path.substr(0, end), 0), entry(path.substr(0, end), count - 1));
  const std::vector<std::string> known = response_paths(document);
  const std::vector<std::string_view> near = input::near_words(path, {known.begin(), known.end()});
  return fmt::format(
      "{}; expected a number of the first load case or of the document, as `prs list responses FILE` shows them; {}",
      got,
      near.empty() ? "write for example `" + known.front() + "`"
                   : fmt::format("did you mean `{}`?", fmt::join(near, "`, `")));
}

}  // namespace

std::optional<std::string> place_in_envelope(const Study& study, const std::string& response) {
  if (!study.envelope) return std::nullopt;
  const auto index_in = [&](const auto& items) -> std::optional<std::size_t> {
    const auto at = std::ranges::find(
        items, response, [](const auto& item) -> auto& { return item.response; });
    return at == items.end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - items.begin()));
  };
  const auto& [combine, normalise, measures, points] = *study.envelope;
  if (const auto k = index_in(measures)) return fmt::format("study.envelope.measures[{}].response", *k);
  for (const auto point : indices(points))
    if (const auto k = index_in(points[point].reach))
      return fmt::format("study.envelope.points[{}].reach[{}].response", point, *k);
  return std::nullopt;
}

std::vector<std::string> recorded_columns(const Study& study, const Json& document, std::size_t threads,
                                          Arrays arrays) {
  std::vector<std::string> columns;
  if (study.responses.empty()) {
    columns = default_responses(study.command);
    if (!document.is_null()) std::erase_if(columns, [&](const std::string& path) { return !response(document, path); });
    return columns;
  }
  for (const auto k : indices(study.responses)) {
    const std::string& path = study.responses[k];
    const auto add = [&](const std::string& column) {
      if (contains(columns, column))
        throw UnknownResponse(k, fmt::format("got {} a second time, with its array; expected each number once; delete "
                                             "one of them",
                                             column));
      columns.push_back(column);
    };
    if (document.is_null() ? result_number(path) || !result_number(entry(path, 0))
                           : response(document, path).has_value()) {
      add(path);
      continue;
    }
    if (document.is_null())
      throw UnknownResponse(k, fmt::format("got {}, an array; expected a file whose own design has an answer, which "
                                           "says how long it is; write for example `{}.max`, or fix the file",
                                           path, path));
    std::size_t count = entries(document, path);
    if (count == 0) throw UnknownResponse(k, unknown(path, document));
    if (arrays == Arrays::refused || place_in_envelope(study, path))
      throw UnknownResponse(
          k, fmt::format("got {}, an array of {} numbers; expected one number; write for example `{}.max` or `{}`",
                         path, count, path, entry(path, 0)));
    if (count == threads) count = most_threads(study, threads);
    for (const auto e : up_to(count)) add(entry(path, e));
  }
  return columns;
}

std::vector<Recorded> recorded(const std::vector<std::string>& columns) {
  std::vector<Recorded> all;
  for (std::size_t k = 0; k < columns.size();) {
    const std::string path = columns[k].substr(0, columns[k].rfind('['));
    std::size_t count = 0;
    while (k + count < columns.size() && columns[k + count] == entry(path, count)) ++count;
    all.push_back(count >= kShortestArray ? Recorded{path, k, count} : Recorded{columns[k], k});
    k += all.back().count;
  }
  return all;
}

bool are_columns_of(const std::vector<std::string>& responses, const std::vector<std::string>& columns) {
  std::size_t next = 0;
  for (const std::string& path : responses) {
    const std::size_t first = next;
    if (next < columns.size() && columns[next] == path)
      ++next;
    else
      while (next < columns.size() && columns[next] == entry(path, next - first)) ++next;
    if (next == first) return false;
  }
  return next == columns.size();
}

}  // namespace prs
