#include "prs/run/analyses.h"

#include <optional>
#include <utility>

#include "prs/input/compute_from.h"
#include "prs/input/force_history.h"
#include "prs/input/optimize_reader.h"
#include "prs/input/study_reader.h"
#include "prs/loads/analyze.h"
#include "prs/model/void_inputs.h"
#include "prs/sha256.h"
#include "prs/slip/slip.h"
#include "prs/threads/geometry_warnings.h"
#include "prs/version.h"

namespace prs {
namespace {

/// Load cases are solved one by one, each on the contacts that it closes.
void warn_of_preload(const Case& c, Result& result) {
  if (c.preload)
    result.warnings.push_back(
        "the load cases are solved without preload; `prs preload` takes the block `preload`");
}

}  // namespace

CheckResult run_check(const input::Source& source, const input::CaseInput& in) {
  if (in.study) input::read_study_input(source);
  if (in.optimize) input::read_optimize_input(source);
  CheckResult result{
      in.fields,
      input::compute_from(source,
                          [&] { return find_contacts(in.values.mechanism, in.values.materials); }),
      {}};
  result.warnings = geometry_warnings(in.values, result.contacts, in.values.load_cases);
  for (std::string& note : void_input_notes(in.values)) result.warnings.push_back(std::move(note));
  return result;
}

Result run_contact(const input::Source& source, const Case& c) {
  return input::compute_from(source, [&] { return analyze_contacts(c); });
}

Result run_solve(const input::Source& source, const Case& c) {
  Result result = input::compute_from(source, [&] { return analyze(c); });
  warn_of_preload(c, result);
  return result;
}

Result run_slip(const input::Source& source, const Case& c) {
  Result result = input::compute_from(source, [&] { return analyze_slip(c); });
  warn_of_preload(c, result);
  return result;
}

PreloadResult run_preload(const input::Source& source, const Case& c) {
  return input::compute_from(source, [&] { return analyze_preload(c); });
}

LifeResult run_life(const input::Source& source, const Case& c) {
  std::optional<LoadHistory> history;
  if (c.life->history) history = input::read_force_history(*c.life->history, source);
  LifeResult result =
      input::compute_from(source, [&] { return analyze_life(c, std::move(history)); });
  if (c.preload)
    result.warnings.push_back("lives are those without preload, whose loads come on top");
  return result;
}

MeasuresResult run_measures(const input::Source& source, const Case& c) {
  MeasuresResult result = input::compute_from(source, [&] { return analyze_measures(c); });
  warn_of_preload(c, result.analysis);
  return result;
}

DocumentInfo document_info(const input::Source& source) {
  return {kVersion, kSchemaVersion, sha256(source.text), source.overrides};
}

}  // namespace prs
