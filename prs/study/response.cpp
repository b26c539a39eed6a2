#include "prs/study/response.h"

#include "prs/life/life_record.h"
#include "prs/loads/contact_record.h"
#include "prs/loads/heat_record.h"
#include "prs/loads/load_analysis.h"
#include "prs/loads/load_record.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/measures/measures_record.h"
#include "prs/record/record_table.h"

namespace prs {
namespace {

/// Numbers, or rows of numbers.
bool is_series(const Json& json) {
  return json.is_array() && !json.empty() && std::ranges::all_of(json, [](const Json& entry) {
           return entry.is_number() || is_series(entry);
         });
}

void collect(const Json& series, std::vector<double>& values) {
  for (const Json& entry : series)
    if (entry.is_array())
      collect(entry, values);
    else
      values.push_back(entry.get<double>());
}

/// The path begins with `.KEY` or `[k]`.
std::optional<double> number_at(const Json& json, std::string_view path) {
  if (path.empty()) return json.is_number() ? std::optional(json.get<double>()) : std::nullopt;
  if (path.starts_with('[')) {
    const std::optional<std::size_t> index = take_index(path);
    const bool there = index && json.is_array() && *index < json.size();
    return there ? number_at(json[*index], path) : std::nullopt;
  }
  if (const SeriesReader summary = summary_named(path, 1.0); summary && is_series(json)) {
    std::vector<double> values;
    collect(json, values);
    return summary(values);
  }
  if (!path.starts_with('.') || !json.is_object()) return std::nullopt;
  path.remove_prefix(1);
  const std::size_t length = std::min(path.find_first_of(".["), path.size());
  const auto found = json.find(std::string(path.substr(0, length)));
  return found == json.end() ? std::nullopt : number_at(*found, path.substr(length));
}

const Json* first_load_case(const Json& document) {
  const auto cases = document.is_object() ? document.find("load_cases") : document.end();
  if (cases == document.end() || !cases->is_array() || cases->empty()) return nullptr;
  return &(*cases)[0];
}

void list_paths(const Json& json, const std::string& path, std::vector<std::string>& paths) {
  if (json.is_number()) paths.push_back(path);
  if (is_series(json)) paths.push_back(path + ".max");
  if (!json.is_object()) return;
  for (const auto& [key, value] : json.items())
    list_paths(value, path.empty() ? key : path + "." + key, paths);
}

/// A number of what `part` finds in an answer or not.
template <class Owner>
std::optional<ResultNumber> number_of(std::string_view path, std::optional<std::size_t> load_case,
                                      const Owner* (*part)(const Answer&)) {
  std::optional<Reader<Owner>> reader = reader_of<Owner>(path);
  if (!reader || reader->delivery == Reach::document) return std::nullopt;
  return ResultNumber{load_case, reader->delivery == Reach::complete, false, OnDemand::nothing,
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

/// A number of the threads of one interface, which most responses are, read without detours.
std::optional<ResultNumber> number_of_threads(std::string_view path, Interface i,
                                              std::size_t load_case) {
  std::optional<Reader<InterfaceLoads>> reader = reader_of<InterfaceLoads>(path);
  if (!reader || reader->delivery != Reach::numbers) return std::nullopt;
  return ResultNumber{load_case, false, false, OnDemand::nothing,
                      [i, read = std::move(reader->read)](const Answer& answer) {
                        const LoadCaseResult* result = answer.load_case;
                        const bool known = result && result->converged() && result->threads;
                        return known ? read((*result->threads)[i]) : std::nullopt;
                      }};
}

constexpr std::pair<std::string_view, OnDemand> kOnDemand[] = {
    {"axial_load_N", OnDemand::axial_load},
    {"load_rate_percent", OnDemand::load_rate},
    {"semi_major_mm", OnDemand::ellipses},
    {"semi_minor_mm", OnDemand::ellipses},
    {"peak_pressure_MPa", OnDemand::ellipses},
    {"tangent_stiffness_N_per_um", OnDemand::tangent_stiffness},
    {"film_thickness_nm", OnDemand::films},
    {"central_film_nm", OnDemand::films},
    {"film_factor", OnDemand::films},
    {"film_ratio", OnDemand::films},
    {"boundary_share", OnDemand::films}};

/// What the number at a path of a load case needs.
OnDemand on_demand(std::string_view path) {
  const bool of_slip = take(path, "slip.");
  const bool of_threads = take(path, "screw.") || take(path, "nut.");
  take(path, "symmetric.");
  const std::string_view key = path.substr(0, path.find_first_of(".["));
  const auto found = std::ranges::find(kOnDemand, key, [](const auto& row) { return row.first; });
  if (found != std::end(kOnDemand)) return found->second;
  return of_slip && (of_threads || key == "hottest_thread") ? OnDemand::slip_of_threads
                                                            : OnDemand::nothing;
}

}  // namespace

std::optional<double> response(const Json& document, std::string_view path) {
  const std::string below = "." + std::string(path);
  if (const Json* load_case = first_load_case(document))
    if (const std::optional<double> value = number_at(*load_case, below)) return value;
  return number_at(document, below);
}

std::vector<std::string> response_paths(const Json& document) {
  std::vector<std::string> paths;
  if (const Json* load_case = first_load_case(document)) list_paths(*load_case, "", paths);
  list_paths(document, "", paths);
  return paths;
}

std::vector<std::string> default_responses(Command command) {
  for (const AnyAnalysis& analysis :
       {any(contact_analysis()), any(solve_analysis()), any(slip_analysis()), any(life_analysis()),
        any(measures_analysis())})
    if (analysis.command == command) return {analysis.responses.begin(), analysis.responses.end()};
  return {};
}

NumberDetail number_detail(std::span<const ResultNumber> numbers) {
  const auto any = [&](OnDemand part) {
    return std::ranges::count(numbers, part, &ResultNumber::on_demand) > 0;
  };
  return {{any(OnDemand::axial_load), any(OnDemand::load_rate), any(OnDemand::ellipses),
           any(OnDemand::tangent_stiffness)},
          {any(OnDemand::slip_of_threads), any(OnDemand::films)}};
}

std::optional<ResultNumber> result_number(std::string_view path) {
  std::string_view rest = path;
  if (take(rest, "measures."))
    if (auto number = number_of<Measures>(rest, {}, [](const Answer& a) { return a.measures; }))
      return number;
  rest = path;
  if (take(rest, "contact."))
    return number_of<Contacts>(rest, {}, [](const Answer& a) { return &a.contacts; });
  if (take(rest, "threads."))
    return number_of<contact::MechanismGeometry>(
        rest, {}, [](const Answer& a) { return &a.contacts.threads; });
  if (take(rest, "life."))
    return number_of<LifeResult>(rest, {}, [](const Answer& a) { return a.life; });
  if (take(rest, "heat_cycle.")) {
    auto number = number_of<HeatCycle>(rest, {}, [](const Answer& a) { return a.cycle; });
    if (number) number->needs_duty = true;
    return number;
  }
  const std::optional<std::size_t> load_case = take_load_case(rest);
  if (!load_case) return std::nullopt;
  if (take(rest, "measures."))
    return number_of<LoadMeasures>(rest, load_case,
                                   [](const Answer& a) { return a.load_measures; });
  std::optional<ResultNumber> number;
  for (const Interface i : kInterfaces)
    if (std::string_view key = rest; !number && take(key, name(i)) && take(key, "."))
      number = number_of_threads(key, i, *load_case);
  if (std::string_view key = rest; !number && take(key, "slip."))
    number = number_of<SlipResult>(key, load_case, [](const Answer& a) {
      return a.load_case && a.load_case->slip ? &*a.load_case->slip : nullptr;
    });
  if (std::string_view key = rest; !number && take(key, "heat."))
    number = number_of<HeatResult>(key, load_case, [](const Answer& a) {
      return a.load_case && a.load_case->heat ? &*a.load_case->heat : nullptr;
    });
  if (!number)
    number =
        number_of<LoadCaseResult>(rest, load_case, [](const Answer& a) { return a.load_case; });
  if (number) number->on_demand = on_demand(rest);
  return number;
}

}  // namespace prs
