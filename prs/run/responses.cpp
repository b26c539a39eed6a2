#include "prs/run/responses.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "prs/quantities/contact_quantities.h"
#include "prs/quantities/life_quantities.h"
#include "prs/quantities/measure_quantities.h"
#include "prs/quantities/quantities.h"
#include "prs/quantities/record_table.h"
#include "prs/run/commands.h"
#include "prs/study/response.h"

namespace prs {
namespace {

void add_numbers(const RecordInfo& record, const std::string& before,
                 std::vector<std::string>& paths) {
  for (const QuantityInfo& q : record.quantities) {
    const std::string path = before + std::string(q.key);
    if (q.kind == Kind::number || q.kind == Kind::count) paths.push_back(path);
    if (q.kind == Kind::series) paths.push_back(path + ".max");
    if (q.kind == Kind::record) add_numbers(q.record(), path + ".", paths);
  }
}

constexpr Command kOfStudies[] = {Command::contact, Command::solve, Command::slip, Command::life,
                                  Command::measures};

}  // namespace

std::vector<std::string> known_responses() {
  std::vector<std::string> paths;
  add_numbers(describe<LoadCaseResult>(), "", paths);
  add_numbers(describe<Contacts>(), "contact.", paths);
  add_numbers(describe<contact::MechanismGeometry>(), "threads.", paths);
  add_numbers(describe<Measures>(), "measures.", paths);
  add_numbers(describe<LifeResult>(), "life.", paths);
  return paths;
}

std::vector<std::string> responses_of(const input::Source& source) {
  const input::CaseInput in = input::read_case_input(source, Command::check);
  std::vector<std::string> paths;
  for (const Command command : kOfStudies) {
    if (in.study ? *in.study != command : !input::missing(in, command).empty()) continue;
    const nlohmann::ordered_json document = run(row_of(command), source).document({});
    for (std::string& path : response_paths(document))
      if (std::ranges::find(paths, path) == paths.end()) paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace prs
