#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "prs/report/findings.h"
#include "prs/report/svg.h"
#include "prs/report/tables.h"
#include "prs/run/results_schema.h"
#include "prs/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;
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
  const Json& cases = under(numbers->document, "load_cases");
  if (choice.load_case >= cases.size()) return "<p>There is no such load case.</p>\n";
  const Json& load_case = cases[choice.load_case];
  const std::vector<Json> known = flat(under(under(load_case, "screw"), "normal_load_N"));
  if (known.empty()) return "<p>The loads of this case are not known.</p>\n";
  if (choice.thread >= known.size()) return "<p>There is no such thread.</p>\n";
  ThreadRows rows;
  add_thread_rows(*record_at("load_cases[]"), load_case, choice.thread, known.size(), rows);
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
  for (const Json& load_case : under(loads->document, "load_cases")) {
    const std::size_t place = choices["cases"].size();
    choices["cases"].push_back(printable(load_case.value("name", "")));
    const Json& known = under(under(load_case, "screw"), "normal_load_N");
    if (!known.is_array() || known.empty()) continue;
    std::vector<double> loaded;
    for (const Json& load : flat(known))
      loaded.push_back(load.is_number() ? load.get<double>() : 0.0);
    const std::size_t rollers = known.front().is_array() ? known.size() : 1;
    const auto largest = std::ranges::max_element(loaded);
    if (*largest <= most) continue;
    most = *largest;
    choices["rollers"] = rollers;
    choices["threads"] = loaded.size() / rollers;
    choices["load_case"] = place;
    choices["thread"] = largest - loaded.begin();
  }
  return choices.contains("threads") ? choices : Json();
}

}  // namespace prs
