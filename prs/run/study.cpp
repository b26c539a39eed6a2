#include "prs/run/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "prs/input/compute_from.h"
#include "prs/input/fail_at.h"
#include "prs/input/force_history.h"
#include "prs/study/journal.h"
#include "prs/version.h"

namespace prs {
namespace {

/// Where a response stands in the file: in the list, or in the envelope that needs it.
std::string place_of(const input::StudyInput& in, std::size_t response) {
  if (in.study.envelope) {
    const Envelope& envelope = *in.study.envelope;
    const auto is_it = [&](const auto& item) {
      return item.response == in.study.responses[response];
    };
    const auto index_in = [&](const auto& items) -> std::optional<std::size_t> {
      const auto at = std::ranges::find_if(items, is_it);
      if (at == items.end()) return std::nullopt;
      return static_cast<std::size_t>(at - items.begin());
    };
    if (const auto k = index_in(envelope.measures))
      return fmt::format("study.envelope.measures[{}].response", *k);
    for (std::size_t point = 0; point < envelope.points.size(); ++point)
      if (const auto k = index_in(envelope.points[point].reach))
        return fmt::format("study.envelope.points[{}].reach[{}].response", point, *k);
  }
  return fmt::format("study.responses[{}]", response);
}

/// Reports a response that the base case does not have where it stands in the file.
template <class Compute>
auto with_responses_of(const input::StudyInput& in, Compute compute) {
  try {
    return compute(in);
  } catch (const UnknownResponse& error) {
    input::fail_at(in.source, place_of(in, error.index()), error.what());
  }
}

}  // namespace

DesignEngine study_engine(const input::StudyInput& in) {
  return with_responses_of(in, [](const input::StudyInput& i) { return DesignEngine(i); });
}

CaseDerivatives run_derivatives(const input::StudyInput& in) {
  return input::compute_from(in.source, [&] { return with_responses_of(in, case_derivatives); });
}

Evaluate evaluate_with(const DesignEngine& engine) {
  return [&](std::size_t first, std::size_t count) { return engine.evaluate(first, count); };
}

std::string key_of(const input::StudyInput& in, Command command) {
  std::vector<std::string> referred;
  if (command == Command::life)
    if (const Case base = input::read_design(in, {}); base.life->history)
      referred.push_back(input::force_history_text(*base.life->history, in.source));
  return study_key(kVersion, in.source, referred);
}

}  // namespace prs
