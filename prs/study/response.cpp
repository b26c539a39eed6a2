#include "prs/study/response.h"

#include "modules/response/response_analysis.h"
#include "prs/life/life_record.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/record/response_path.h"

namespace prs {
namespace {

const Json* first_load_case(const Json& document) {
  const auto cases = document.is_object() ? document.find("load_cases") : document.end();
  if (cases == document.end() || !cases->is_array() || cases->empty()) return nullptr;
  return &(*cases)[0];
}

void list_paths(const Json& json, const std::string& path, std::vector<std::string>& paths) {
  if (json.is_number()) paths.push_back(path);
  if (is_series(json)) paths.push_back(path + ".max");
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items()) list_paths(value, path.empty() ? key : path + "." + key, paths);
}

/// Whether `part` finds a number in an answer.
template <class Owner, class Part>
std::optional<ResultNumber> number_of(std::string_view path, std::optional<std::size_t> load_case, Part part) {
  std::optional<Reader<Owner>> reader = reader_of<Owner>(path);
  if (!reader || reader->delivery == Reach::document) return std::nullopt;
  return ResultNumber{load_case, reader->delivery == Reach::complete, false,
                      [part, read = std::move(reader->read)](const Answer& answer) {
                        const Owner* owner = part(answer);
                        return owner ? read(*owner) : std::nullopt;
                      }};
}

/// Takes a word from the head of a path.
bool take(std::string_view& path, std::string_view word) {
  if (!path.starts_with(word)) return false;
  path.remove_prefix(word.size());
  return true;
}

/// Takes `load_cases[k].` from the head of a path; the first load case where it has none.
std::optional<std::size_t> take_load_case(std::string_view& path) {
  if (!take(path, "load_cases")) return 0;
  const std::optional<std::size_t> index = take_index(path);
  return take(path, ".") ? index : std::nullopt;
}

}  // namespace

std::optional<double> response(const Json& document, std::string_view path) {
  const std::string below = "." + std::string(path);
  if (const Json* load_case = first_load_case(document))
    if (const std::optional<double> value = number_at(*load_case, below)) return value;
  return number_at(document, below);
}

std::size_t entries(const Json& document, std::string_view path) {
  std::size_t count = 0;
  if (response(document, fmt::format("{}.max", path)))
    while (response(document, fmt::format("{}[{}]", path, count))) ++count;
  return count;
}

std::vector<std::string> response_paths(const Json& document) {
  std::vector<std::string> paths;
  if (const Json* load_case = first_load_case(document)) list_paths(*load_case, "", paths);
  list_paths(document, "", paths);
  return paths;
}

std::vector<std::string> default_responses(Command command) {
  for (const AnyAnalysis& analysis : {any(contact_analysis()), any(solve_analysis()), any(slip_analysis()),
                                      any(life_analysis()), any(measures_analysis()), any(response_analysis())})
    if (analysis.command == command) return {analysis.responses.begin(), analysis.responses.end()};
  return {};
}

std::optional<ResultNumber> result_number(std::string_view path) {
  std::string_view rest = path;
  if (take(rest, "measures."))
    if (auto number = number_of<Measures>(rest, {}, [](const Answer& a) { return a.measures; })) return number;
  rest = path;
  if (take(rest, "contact.")) return number_of<Contacts>(rest, {}, [](const Answer& a) { return &a.contacts; });
  if (take(rest, "threads."))
    return number_of<contact::MechanismGeometry>(rest, {}, [](const Answer& a) { return &a.contacts.threads; });
  if (take(rest, "life.")) return number_of<LifeResult>(rest, {}, [](const Answer& a) { return a.life; });
  if (take(rest, "heat_cycle.")) {
    auto number = number_of<HeatCycle>(rest, {}, [](const Answer& a) { return a.cycle; });
    if (number) number->needs_duty = true;
    return number;
  }
  const std::optional<std::size_t> load_case = take_load_case(rest);
  if (!load_case) return std::nullopt;
  std::optional<ResultNumber> number;
  if (take(rest, "measures."))
    number = number_of<LoadMeasures>(rest, load_case, [](const Answer& a) { return a.load_measures; });
  for (const Interface i : kInterfaces)
    if (std::string_view key = rest; !number && take(key, name(i)) && take(key, "."))
      number = number_of<InterfaceLoads>(key, load_case, [i](const Answer& a) {
        const bool known = a.load_case && a.load_case->converged() && a.load_case->threads;
        return known ? &(*a.load_case->threads)[i] : nullptr;
      });
  if (std::string_view key = rest; !number && take(key, "slip."))
    number = number_of<SlipResult>(key, load_case, [](const Answer& a) {
      return a.load_case && a.load_case->slip ? &*a.load_case->slip : nullptr;
    });
  if (std::string_view key = rest; !number && take(key, "heat."))
    number = number_of<HeatResult>(key, load_case, [](const Answer& a) {
      return a.load_case && a.load_case->heat ? &*a.load_case->heat : nullptr;
    });
  if (!number) number = number_of<LoadCaseResult>(rest, load_case, [](const Answer& a) { return a.load_case; });
  return number;
}

}  // namespace prs
