#include "prs/study/result_number.h"

#include <algorithm>
#include <initializer_list>
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

/// A number of the threads of one interface, which most responses are, read without detours.
std::optional<ResultNumber> number_of_threads(std::string_view path, Interface i,
                                              std::size_t load_case) {
  std::optional<Reader<InterfaceLoads>> reader = reader_of<InterfaceLoads>(path);
  if (!reader || reader->delivery != Reach::numbers) return std::nullopt;
  return ResultNumber{load_case, false, false,
                      [i, read = std::move(reader->read)](const Answer& answer) {
                        const LoadCaseResult* result = answer.load_case;
                        const bool known = result && result->converged() && result->threads;
                        return known ? read((*result->threads)[i]) : std::nullopt;
                      }};
}

}  // namespace

NumberDetail number_detail(std::span<const ResultNumber> numbers) {
  // Numbers that are there no more without an array need it, and so may those that are not there in
  // an example at all.
  LoadCaseResult whole;
  whole.axial_displacement = whole.axial_stiffness = whole.tangent_stiffness = 1.0;
  InterfaceLoads threads;
  using Array = std::vector<double> InterfaceLoads::*;
  for (const Array array :
       {&InterfaceLoads::axial_load, &InterfaceLoads::normal_load, &InterfaceLoads::load_rate,
        &InterfaceLoads::approach, &InterfaceLoads::semi_major, &InterfaceLoads::semi_minor,
        &InterfaceLoads::peak_pressure})
    threads.*array = {1.0};
  whole.threads = {threads, threads};
  const std::vector<std::vector<double> InterfaceSlip::*> of_friction = {
      &InterfaceSlip::power,         &InterfaceSlip::power_density,
      &InterfaceSlip::spin_torque,   &InterfaceSlip::friction_coefficient,
      &InterfaceSlip::sliding_speed, &InterfaceSlip::max_sliding_speed,
      &InterfaceSlip::wear,          &InterfaceSlip::dynamic_normal_load};
  const std::vector<std::vector<double> InterfaceSlip::*> of_films = {
      &InterfaceSlip::film_thickness, &InterfaceSlip::central_film, &InterfaceSlip::film_ratio,
      &InterfaceSlip::boundary_share};
  InterfaceSlip slips;
  for (const auto& arrays : {of_friction, of_films})
    for (const auto array : arrays) slips.*array = {1.0};
  whole.slip.emplace();
  whole.slip->status = SlipStatus::converged;
  whole.slip->threads = {slips, slips};
  whole.slip->power.screw = whole.slip->forces.centrifugal = 1.0;
  whole.slip->efficiency = whole.slip->efficiency_fit = whole.slip->holding_torque =
      whole.slip->viscosity = whole.slip->bearing_eccentricity = whole.slip->estimates.jones = 1.0;
  whole.slip->self_locking = true;
  const Contacts contacts;
  const auto need_after = [&](const auto& change) {
    LoadCaseResult part = whole;
    change(part);
    return std::ranges::any_of(numbers, [&](const ResultNumber& n) {
      return !n.value({contacts, &part});
    });
  };
  const auto need = [&](std::initializer_list<Array> arrays) {
    return need_after([&](LoadCaseResult& part) {
      for (const Interface i : kInterfaces)
        for (const Array array : arrays) ((*part.threads)[i].*array).clear();
    });
  };
  const auto need_slip = [&](const auto& arrays) {
    return need_after([&](LoadCaseResult& part) {
      for (const Interface i : kInterfaces)
        for (const auto array : arrays) (part.slip->threads[i].*array).clear();
    });
  };
  return {{need({&InterfaceLoads::axial_load}), need({&InterfaceLoads::load_rate}),
           need({&InterfaceLoads::semi_major, &InterfaceLoads::semi_minor,
                 &InterfaceLoads::peak_pressure}),
           need_after([](LoadCaseResult& part) { part.tangent_stiffness.reset(); })},
          {need_slip(of_friction), need_slip(of_films)}};
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
  if (std::string_view key = rest; take(key, "slip."))
    return number_of<SlipResult>(key, load_case, [](const Answer& a) {
      return a.load_case && a.load_case->slip ? &*a.load_case->slip : nullptr;
    });
  if (std::string_view key = rest; take(key, "heat."))
    return number_of<HeatResult>(key, load_case, [](const Answer& a) {
      return a.load_case && a.load_case->heat ? &*a.load_case->heat : nullptr;
    });
  if (std::string_view key = rest; take(key, "screw."))
    if (auto number = number_of_threads(key, Interface::screw, *load_case)) return number;
  if (std::string_view key = rest; take(key, "nut."))
    if (auto number = number_of_threads(key, Interface::nut, *load_case)) return number;
  return number_of<LoadCaseResult>(rest, load_case, [](const Answer& a) { return a.load_case; });
}

}  // namespace prs
