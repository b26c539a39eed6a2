#include <iterator>

#include "prs/report/findings.h"
#include "prs/report/svg.h"
#include "prs/report/tables.h"
#include "prs/run/results_schema.h"
#include "prs/text.h"

namespace prs {
namespace {

using ThreadRows = std::vector<std::vector<std::string>>;

/// The entries of an array, those of arrays in it one after the other: roller after roller.
std::vector<Json> flat(const Json& array) {
  std::vector<Json> all;
  if (!array.is_array()) return all;
  for (const Json& entry : array)
    if (entry.is_array())
      std::ranges::copy(flat(entry), std::back_inserter(all));
    else
      all.push_back(entry);
  return all;
}

/// What a record has of one thread at both interfaces: the entries of series as long as that of
/// the loads.
void add_thread_rows(const RecordInfo& info, const Json& json, std::size_t thread,
                     std::size_t threads, ThreadRows& rows) {
  const Json& screw = under(json, "screw");
  const Json& nut = under(json, "nut");
  const RecordInfo* side = record_in(info, "screw");
  if (side && screw.is_object() && nut.is_object()) {
    for (const QuantityInfo& q : side->quantities) {
      const auto value = [&](const Json& body) {
        const std::vector<Json> values = flat(under(body, std::string(q.key)));
        return values.size() == threads ? values[thread] : Json();
      };
      const Json screw_value = value(screw), nut_value = value(nut);
      double largest = 0.0;
      for (const Json* one : {&screw_value, &nut_value})
        if (one->is_number()) largest = std::max(largest, std::abs(one->get<double>()));
      const ReportUnit unit = report_unit(q.key, q.unit, largest);
      const std::string at_screw = report_value(screw_value, unit),
                        at_nut = report_value(nut_value, unit);
      if (at_screw.empty() && at_nut.empty()) continue;
      rows.push_back({html(capitalised(q.title)), at_screw, at_nut, html(unit.text)});
    }
  }
  for (const QuantityInfo& q : info.quantities) {
    const Json& inner = under(json, std::string(q.key));
    if (q.kind == Kind::record && inner.is_object() && q.key != "screw" && q.key != "nut")
      add_thread_rows(q.record(), inner, thread, threads, rows);
  }
}

}  // namespace

std::string thread_html(Findings& all, const ThreadChoice& choice) {
  const CommandAnswer* slip = all.answer(Command::slip);
  const CommandAnswer* loads = all.most_complete();
  const CommandAnswer* numbers = slip ? slip : loads;
  if (!numbers) return {};
  const Result& result = *numbers->delivery.result<Result>();
  if (choice.load_case >= result.load_cases.size()) return "<p>There is no such load case.</p>\n";
  const auto& known = result.load_cases[choice.load_case].threads;
  const std::size_t threads = known ? known->screw.normal_load.size() : 0;
  if (threads == 0) return "<p>The loads of this case are not known.</p>\n";
  if (choice.thread >= threads) return "<p>There is no such thread.</p>\n";
  ThreadRows rows;
  add_thread_rows(*record_at("load_cases[]"), numbers->document["load_cases"][choice.load_case],
                  choice.thread, threads, rows);
  std::string text;
  const FigureOptions options{.load_case = choice.load_case, .thread = choice.thread};
  const auto add = [&](const CommandAnswer* answer, const char* name) {
    if (!answer) return;
    const auto picture = std::ranges::find(answer->pictures, name, &Picture::name);
    if (picture == answer->pictures.end()) return;
    for (const Figure& figure : picture->make(options)) text += figure_html(all, figure);
  };
  add(loads, "thread_pressure");
  add(loads, "thread_stress");
  add(slip, "thread_friction");
  return text + plain_table({"", "Roller-screw", "Roller-nut", "Unit"}, rows, true);
}

Json thread_choices(const Findings& all) {
  const CommandAnswer* loads = all.most_complete();
  if (!loads) return nullptr;
  Json choices{{"cases", Json::array()}};
  double most = -1.0;
  for (const LoadCaseResult& load_case : loads->delivery.result<Result>()->load_cases) {
    const std::size_t place = choices["cases"].size();
    choices["cases"].push_back(printable(load_case.load_case.name));
    if (!load_case.threads || load_case.threads->screw.normal_load.empty()) continue;
    const InterfaceLoads& screw = load_case.threads->screw;
    const std::size_t count = screw.normal_load.size();
    const auto row =
        screw.threads_per_roller > 0 ? static_cast<std::size_t>(screw.threads_per_roller) : count;
    const auto largest = std::ranges::max_element(screw.normal_load);
    if (*largest <= most) continue;
    most = *largest;
    choices["rollers"] = count / row;
    choices["threads"] = row;
    choices["load_case"] = place;
    choices["thread"] = largest - screw.normal_load.begin();
  }
  return choices.contains("threads") ? choices : Json();
}

}  // namespace prs
