#include "prs/study/result_number.h"

#include <algorithm>
#include <utility>

#include "prs/life/life_record.h"
#include "prs/loads/contact_record.h"
#include "prs/loads/load_record.h"
#include "prs/losses/heat_record.h"
#include "prs/measures/measures_record.h"
#include "prs/record/record_table.h"

namespace prs {
namespace {

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
