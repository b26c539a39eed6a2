#include "prs/study/result_number.h"

#include <utility>

#include "prs/quantities/contact_quantities.h"
#include "prs/quantities/heat_quantities.h"
#include "prs/quantities/life_quantities.h"
#include "prs/quantities/measure_quantities.h"
#include "prs/quantities/quantities.h"
#include "prs/quantities/record_table.h"

namespace prs {
namespace {

/// A number of what `part` finds in an answer or not.
template <class Owner>
std::optional<ResultNumber> number_of(std::string_view path, std::optional<std::size_t> load_case,
                                      const Owner* (*part)(const Answer&)) {
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
  return number_of<LoadCaseResult>(rest, load_case, [](const Answer& a) { return a.load_case; });
}

}  // namespace prs
