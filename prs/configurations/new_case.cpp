#include "prs/configurations/new_case.h"

#include <fmt/ranges.h>

#include "prs/configurations/configurations_files.h"
#include "prs/configurations/screw_case.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/units.h"
#include "prs/model/quantity_text.h"
#include "prs/record/record_table.h"
#include "prs/text.h"

namespace prs {
namespace {

/// An option that gives a quantity of the screw.
struct QuantityOption {
  const char* name;
  std::optional<std::string> NewOptions::*text;
  std::optional<double> ScrewData::*value;
  const input::Dimension& dimension;
  const char* meaning;  ///< Text in the list of given values.
};

const QuantityOption kQuantities[] = {
    {"--nut-diameter", &NewOptions::nut_diameter, &ScrewData::nut_diameter, input::unit::length, "nut diameter"},
    {"--nut-length", &NewOptions::nut_length, &ScrewData::nut_length, input::unit::length, "nut length"},
    {"--roller-diameter", &NewOptions::roller_diameter, &ScrewData::roller_diameter, input::unit::length,
     "roller diameter"},
    {"--roller-profile-radius", &NewOptions::roller_profile_radius, &ScrewData::roller_profile_radius,
     input::unit::length, "profile radius"},
    {"--load", &NewOptions::load, &ScrewData::load, input::unit::force, "load"},
    {"--speed", &NewOptions::speed, &ScrewData::speed, input::unit::rotational_speed, "speed"},
};

/// Screws of the examples that the command writes without options.
ScrewData example(Mechanism::Type type) {
  if (contact::is_grooved(type)) return {.type = type, .screw_diameter = 20e-3, .lead = 2e-3};
  if (type == Mechanism::Type::standard)
    return {
        .type = type, .screw_diameter = 30e-3, .lead = 10e-3, .starts = 5, .nut_diameter = 64e-3, .nut_length = 85e-3};
  return {.type = type, .screw_diameter = 21e-3, .lead = 5e-3, .starts = 3, .nut_diameter = 46e-3, .nut_length = 90e-3};
}

/// `nut_diameter` -> `--nut-diameter`
std::string option_of(std::string member) {
  std::ranges::replace(member, '_', '-');
  return "--" + member;
}

/// Member of an option: `--nut-diameter` -> `nut_diameter`.
std::string member_of(std::string option) {
  std::ranges::replace(option, '-', '_');
  return option.substr(2);
}

/// Quantity as written in a case: `+30mm` -> `30 mm`.
std::string spaced(std::string_view quantity) {
  if (quantity.starts_with('+')) quantity.remove_prefix(1);
  const std::string_view unit = input::split_unit(quantity)->unit;
  quantity.remove_suffix(unit.size());
  return fmt::format("{} {}", quantity.substr(0, quantity.find_last_not_of(' ') + 1), unit);
}

ScrewData data_of(const NewOptions& o, Mechanism::Type type, std::vector<std::string>& given) {
  using namespace input;
  for (const auto& [option, text] : {std::pair{"--screw-diameter", &o.screw_diameter}, std::pair{"--lead", &o.lead}})
    if (!*text)
      throw CaseError(option, fmt::format("missing; expected diameter and lead with the other options; add "
                                          "`{} \"{}\"`, for example",
                                          option, option == std::string_view("--lead") ? "10 mm" : "30 mm"));
  ScrewData d;
  d.type = type;
  d.screw_diameter = quantity_of_option("--screw-diameter", *o.screw_diameter, unit::length, {1e-3, 1.0},
                                        "1 mm to 1 m; check the unit");
  d.lead = quantity_of_option("--lead", *o.lead, unit::length, {}, "");
  given = {fmt::format("screw diameter {}", shown(*o.screw_diameter)), fmt::format("lead {}", shown(*o.lead))};
  d.as_written = {{"screw_diameter", spaced(*o.screw_diameter)}, {"lead", spaced(*o.lead)}};
  d.starts = o.starts;
  d.rollers = o.rollers;
  if (o.starts) given.push_back(fmt::format("{} starts", *o.starts));
  if (o.rollers) given.push_back(fmt::format("{} rollers", *o.rollers));
  for (const QuantityOption& q : kQuantities)
    if (const std::optional<std::string>& text = o.*q.text) {
      const bool travels = q.dimension.by_lead && is_travel_speed(*text);
      const double value =
          quantity_of_option(q.name, *text, travels ? unit::travel_speed : q.dimension, positive, "more than 0");
      d.*q.value = travels ? std::abs(rotation(value, d.lead)) : value;
      d.as_written[member_of(q.name)] = spaced(*text);
      given.push_back(fmt::format("{} {}", q.meaning, shown(*text)));
    }
  return d;
}

CaseLubricant lubricant_of(const NewOptions& o, std::vector<std::string>& given) {
  CaseLubricant l;
  l.assumed = !o.lubricant;
  if (o.lubricant) {
    l.name = *o.lubricant;
    const auto names = each(named_lubricants(), &NamedLubricant::name);
    if (std::ranges::find(names, l.name) == names.end()) {
      const std::string hint = input::did_you_mean(l.name, names);
      throw CaseError("--lubricant", fmt::format("got {}; expected a name of `prs list lubricants`{}{}",
                                                 input::shown(l.name), hint.empty() ? "" : "; ", hint));
    }
    given.push_back("lubricant " + l.name);
  }
  if (o.temperature) {
    l.temperature = quantity_of_option("--temperature", *o.temperature, input::unit::temperature, {230.0, 500.0},
                                       "an oil's temperature, -43 to 226 degC");
    l.temperature_as_written = spaced(*o.temperature);
    given.push_back("its temperature " + *o.temperature);
  }
  return l;
}

ModelOptions::Mechanism mechanism_of(const NewOptions& o, Mechanism::Type type) {
  if (o.mechanism && *o.mechanism != "sector" && *o.mechanism != "full")
    throw CaseError("--mechanism", fmt::format("got {}; expected sector or full", input::shown(*o.mechanism)));
  if (o.mechanism == "full" && contact::is_grooved(type))
    throw CaseError("--mechanism", fmt::format("got full; expected sector of a {} screw, all rollers of which are not "
                                               "modelled; leave it out",
                                               contact::facts_of(type).name));
  return o.mechanism == "full" ? ModelOptions::Mechanism::full : ModelOptions::Mechanism::sector;
}

Mechanism::Type type_of(const NewOptions& o) {
  if (o.type.empty()) return Mechanism::Type::inverted;
  const std::optional<Mechanism::Type> type = contact::type_named(o.type);
  if (!type)
    throw CaseError("--type",
                    fmt::format("got {}; expected standard, inverted or recirculating", input::shown(o.type)));
  return *type;
}

/// Whether the screw is described; otherwise an example is used.
bool has_screw(NewOptions o) {
  o.mechanism.reset();
  return !first_given(o).empty();
}

}  // namespace

double quantity_of_option(std::string_view option, const std::string& text, const input::Dimension& dimension,
                          const input::Bounds& bounds, std::string_view expected) {
  const input::ParsedQuantity parsed = input::parse_quantity(text, dimension);
  if (!parsed.value)
    throw CaseError(std::string(option),
                    fmt::format("got {}; expected {} with its unit, for example `{}`{}{}", input::shown(text),
                                dimension.name, dimension.example, parsed.hint.empty() ? "" : "; ", parsed.hint));
  if (!bounds.contain(*parsed.value))
    throw CaseError(std::string(option), fmt::format("got {}; expected {}", input::shown(text), expected));
  return *parsed.value;
}

std::string first_given(const NewOptions& o) {
  if (o.screw_diameter) return "--screw-diameter";
  if (o.lead) return "--lead";
  if (o.starts) return "--starts";
  if (o.rollers) return "--rollers";
  if (o.lubricant) return "--lubricant";
  if (o.temperature) return "--temperature";
  if (o.mechanism) return "--mechanism";
  for (const QuantityOption& q : kQuantities)
    if (o.*q.text) return q.name;
  return {};
}

std::string assumptions(const NewOptions& o) {
  if (!has_screw(o)) {
    const ScrewData d = example(type_of(o));
    return fmt::format(
        "an example of {} x {}, as no dimension was given; yours go in as --screw-diameter and "
        "--lead",
        mm(d.screw_diameter), mm(d.lead));
  }
  std::vector<std::string> assumed;
  if (!o.starts) assumed.emplace_back("starts");
  if (!o.rollers) assumed.emplace_back("rollers");
  const bool grooved = contact::is_grooved(type_of(o));
  for (const QuantityOption& q : kQuantities)
    if (!(o.*q.text) && (grooved || q.value != &ScrewData::roller_diameter)) assumed.emplace_back(q.meaning);
  if (grooved) assumed.emplace_back("one unloaded roller");
  if (!o.lubricant) assumed.emplace_back("lubricant");
  return assumed.empty() ? "" : fmt::format("assumed in it: {}", fmt::join(assumed, ", "));
}

std::string new_case_text(const NewOptions& o) {
  const Mechanism::Type type = type_of(o);
  const bool by_options = has_screw(o);
  std::vector<std::string> given;
  try {
    const ScrewData data = by_options ? data_of(o, type, given) : example(type);
    const CaseLubricant lubricant = lubricant_of(o, given);
    const std::string origin = by_options
                                   ? fmt::format("Given: {}.", fmt::join(given, ", "))
                                   : fmt::format(
                                         "An example: replace what is marked `given`, or write a case of your "
                                         "screw with `prs new {} FILE --screw-diameter \"{}\" --lead \"{}\"` and "
                                         "what else is known of it.",
                                         contact::facts_of(type).name, mm(data.screw_diameter), mm(data.lead));
    return screw_case(complete_screw(data), lubricant, origin, mechanism_of(o, type));
  } catch (const CaseError& error) {
    if (error.path().starts_with("--")) throw;
    throw CaseError(option_of(error.path()), error.what());
  }
}

}  // namespace prs
