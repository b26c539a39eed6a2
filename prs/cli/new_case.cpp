#include <fmt/ranges.h>

#include "prs/cli/command_line.h"
#include "prs/cli/commands.h"
#include "prs/cli/package.h"
#include "prs/cli/program.h"
#include "prs/configurations/configurations_files.h"
#include "prs/input/did_you_mean.h"
#include "prs/model/quantity_text.h"
#include "prs/version.h"

namespace prs::cli {
namespace {

namespace fs = std::filesystem;

/// An option that gives a quantity of the screw.
struct QuantityOption {
  const char* name;
  std::optional<std::string> NewOptions::*text;
  std::optional<double> ScrewData::*value;
  const input::Dimension& dimension;
  const char* meaning;  ///< In the list of what was given.
};

const QuantityOption kQuantities[] = {
    {"--nut-diameter", &NewOptions::nut_diameter, &ScrewData::nut_diameter, input::unit::length,
     "nut diameter"},
    {"--nut-length", &NewOptions::nut_length, &ScrewData::nut_length, input::unit::length,
     "nut length"},
    {"--roller-profile-radius", &NewOptions::roller_profile_radius,
     &ScrewData::roller_profile_radius, input::unit::length, "profile radius"},
    {"--load", &NewOptions::load, &ScrewData::load, input::unit::force, "load"},
    {"--speed", &NewOptions::speed, &ScrewData::speed, input::unit::rotational_speed, "speed"},
};

/// Screws of the examples that the command writes without options.
ScrewData example(Mechanism::Type type) {
  if (type == Mechanism::Type::standard)
    return {.type = type,
            .screw_diameter = 30e-3,
            .lead = 10e-3,
            .starts = 5,
            .nut_diameter = 64e-3,
            .nut_length = 85e-3};
  return {.type = type,
          .screw_diameter = 21e-3,
          .lead = 5e-3,
          .starts = 3,
          .nut_diameter = 46e-3,
          .nut_length = 90e-3};
}

/// `nut_diameter` -> `--nut-diameter`
std::string option_of(std::string member) {
  std::ranges::replace(member, '_', '-');
  return "--" + member;
}

/// `--nut-diameter` -> `nut_diameter`
std::string member_of(std::string option) {
  std::ranges::replace(option, '-', '_');
  return option.substr(2);
}

/// `+30mm` -> `30 mm`, as it stands in a case.
std::string spaced(std::string_view quantity) {
  if (quantity.starts_with('+')) quantity.remove_prefix(1);
  const std::string_view unit = input::split_unit(quantity)->unit;
  quantity.remove_suffix(unit.size());
  return fmt::format("{} {}", quantity.substr(0, quantity.find_last_not_of(' ') + 1), unit);
}

ScrewData data_of(const NewOptions& o, Mechanism::Type type, std::vector<std::string>& given) {
  using namespace input;
  for (const auto& [option, text] :
       {std::pair{"--screw-diameter", &o.screw_diameter}, std::pair{"--lead", &o.lead}})
    if (!*text)
      fail_option(option,
                  "missing; expected diameter and lead with the other options; add `{} \"{}\"`, "
                  "for example",
                  option, option == std::string_view("--lead") ? "10 mm" : "30 mm");
  ScrewData d;
  d.type = type;
  d.screw_diameter = quantity_option("--screw-diameter", *o.screw_diameter, unit::length,
                                     {1e-3, 1.0}, "1 mm to 1 m; check the unit");
  d.lead = quantity_option("--lead", *o.lead, unit::length, {}, "");
  given = {fmt::format("screw diameter {}", shown(*o.screw_diameter)),
           fmt::format("lead {}", shown(*o.lead))};
  d.as_written = {{"screw_diameter", spaced(*o.screw_diameter)}, {"lead", spaced(*o.lead)}};
  d.starts = o.starts;
  d.rollers = o.rollers;
  if (o.starts) given.push_back(fmt::format("{} starts", *o.starts));
  if (o.rollers) given.push_back(fmt::format("{} rollers", *o.rollers));
  for (const QuantityOption& q : kQuantities)
    if (const std::optional<std::string>& text = o.*q.text) {
      const bool travels = q.dimension.by_lead && is_travel_speed(*text);
      const double value = quantity_option(
          q.name, *text, travels ? unit::travel_speed : q.dimension, positive, "more than 0");
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
      fail_option("--lubricant", "got {}; expected a name of `prs list lubricants`{}{}",
                  input::shown(l.name), hint.empty() ? "" : "; ", hint);
    }
    given.push_back("lubricant " + l.name);
  }
  if (o.temperature) {
    l.temperature = quantity_option("--temperature", *o.temperature, input::unit::temperature,
                                    {230.0, 500.0}, "an oil's temperature, -43 to 226 degC");
    l.temperature_as_written = spaced(*o.temperature);
    given.push_back("its temperature " + *o.temperature);
  }
  return l;
}

ModelOptions::Mechanism mechanism_of(const NewOptions& o) {
  return o.mechanism == "full" ? ModelOptions::Mechanism::full : ModelOptions::Mechanism::sector;
}

/// An option that says something of the case; empty where none is given.
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

Mechanism::Type type_of(const NewOptions& o) {
  return o.type == "standard" ? Mechanism::Type::standard : Mechanism::Type::inverted;
}

/// Whether anything is said of the screw, which else is an example.
bool has_screw(NewOptions o) {
  o.mechanism.reset();
  return !first_given(o).empty();
}

/// What the case says that nobody gave.
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
  for (const QuantityOption& q : kQuantities)
    if (!(o.*q.text)) assumed.emplace_back(q.meaning);
  if (!o.lubricant) assumed.emplace_back("lubricant");
  return assumed.empty() ? "" : fmt::format("assumed in it: {}", fmt::join(assumed, ", "));
}

std::string new_text(const NewOptions& o) {
  const Mechanism::Type type = type_of(o);
  const bool by_options = has_screw(o);
  std::vector<std::string> given;
  try {
    const ScrewData data = by_options ? data_of(o, type, given) : example(type);
    const CaseLubricant lubricant = lubricant_of(o, given);
    const std::string origin =
        by_options ? fmt::format("Given: {}.", fmt::join(given, ", "))
                   : fmt::format(
                         "An example: replace what is marked `given`, or write a case of your "
                         "screw with `prs new {} FILE --screw-diameter \"{}\" --lead \"{}\"` and "
                         "what else is known of it.",
                         type_name(type), mm(data.screw_diameter), mm(data.lead));
    return screw_case(complete_screw(data), lubricant, origin, mechanism_of(o));
  } catch (const CaseError& error) {
    fail_option(option_of(error.path()), error.what());
  }
}

void refuse_existing(const fs::path& file) {
  if (fs::exists(fs::symlink_status(file)))
    throw UsageError("{}: the file exists already; give another name", input::shown(file.string()));
}

std::string content_of_file(const fs::path& file) {
  return input::load_source(file.string(), {}).text;
}

/// The lesson, and next to it the files that it reads.
void copy_lesson(const Lesson& lesson, const fs::path& file) {
  const std::vector<std::string> names = companions(lesson);
  refuse_existing(file);
  for (const std::string& name : names) refuse_existing(file.parent_path() / name);
  for (const std::string& name : names)
    write_case(file.parent_path() / name, content_of_file(lesson.file.parent_path() / name));
  write_case(file, content_of_file(lesson.file));
}

ConfigurationQuery query_of(const ConfigurationOptions& o) {
  using namespace input;
  constexpr double kDegree = std::numbers::pi / 180;
  const Bounds size{1e-3, 1.0};
  ConfigurationQuery q;
  q.screw_diameter = quantity_option("--screw-diameter", o.screw_diameter, unit::length, size,
                                     "1 mm to 1 m; check the unit");
  q.lead = quantity_option("--lead", o.lead, unit::length, not_zero,
                           "a lead other than 0; > 0 right-handed, < 0 left-handed");
  if (std::abs(q.lead) > 10.0 * q.screw_diameter || std::abs(q.lead) < 1e-4 * q.screw_diameter)
    fail_option("--lead", "got {}; expected 0.0001 to 10 screw diameters; check the units",
                shown(o.lead));
  if (o.flank_angle)
    q.flank_angle =
        quantity_option("--flank-angle", *o.flank_angle, unit::angle, {20 * kDegree, 70 * kDegree},
                        "20 deg to 70 deg, usually 45 deg");
  if (o.gap) q.gap = quantity_option("--gap", *o.gap, unit::length, not_negative, "0 mm or more");
  if (o.roller_profile_radius)
    q.roller_profile_radius = quantity_option("--roller-profile-radius", *o.roller_profile_radius,
                                              unit::length, positive, "more than 0 mm");
  if (o.type)
    q.type = *o.type == "standard" ? Mechanism::Type::standard : Mechanism::Type::inverted;
  q.screw_starts = o.starts;
  q.roller_starts = o.roller_starts;
  q.rollers = o.rollers;
  return q;
}

[[noreturn]] void refuse_none(const Configurations& nothing) {
  std::string reasons = left_out_text(nothing);
  reasons.pop_back();  // The newline that whoever prints the error adds.
  throw input::InputError(
      "prs: error: nothing sound has this diameter, lead and starts; change what the reasons "
      "name\n" +
      reasons);
}

/// The configuration that `--write` asks for.
const Configuration& chosen(const Configurations& all, const ConfigurationOptions& o) {
  const std::optional<double> number = input::parse_number(o.write[0]);
  if (number)
    for (std::size_t k = 0; k < all.found.size(); ++k)
      if (*number == static_cast<double>(k + 1)) return all.found[k];
  fail_option("--write", "got {}; expected the number of a line, 1 to {}, and a file",
              input::shown(o.write[0]), all.found.size());
}

/// The case of `--write`, into a file that is new.
void write_configuration(const Configuration& configuration, const ConfigurationOptions& o) {
  const auto text = [&] {
    try {
      return configuration_case(configuration);
    } catch (const CaseError& error) {
      fail_option("--write", error.what());
    }
  }();
  if (std::filesystem::exists(o.write[1]))
    fail_option("--write", "{}: the file exists already; give another name",
                input::shown(o.write[1]));
  write_case(o.write[1], text);
}

}  // namespace

void add_new_options(CLI::App& command, NewOptions& options) {
  add_value(command, "type", options.type, "standard|inverted", "Type of the screw");
  add_value(command, "file", options.file, "FILE", "New file; printed without one, or with `-`");
  const auto add = [&](const char* name, std::optional<std::string>& text, const char* what,
                       const char* kind) { command.add_option(name, text, what)->type_name(kind); };
  add("--screw-diameter", options.screw_diameter, "Nominal diameter, with its unit", "LENGTH");
  add("--lead", options.lead, "Of screw and nut; > 0 right-handed", "LENGTH");
  take_whole_number(
      command.add_option("--starts", options.starts, "Of screw and nut; default: 5, 4 or 3"), 1,
      100);
  take_whole_number(command.add_option("--rollers", options.rollers, "Default: as many as fit"), 1,
                    1000);
  add("--nut-diameter", options.nut_diameter, "Outer; default: as in catalogues", "LENGTH");
  add("--nut-length", options.nut_length,
      "Of the whole nut, inverted: of the tube that the rollers travel in; default: by rule",
      "LENGTH");
  add("--roller-profile-radius", options.roller_profile_radius,
      "Of the convex rollers; default: 5 pitches", "LENGTH");
  add("--load", options.load, "Axial; default: 1.8 GPa with equal shares", "FORCE");
  add("--speed", options.speed,
      "Screw against nut; default: half of 150,000 mm/min over the diameter", "SPEED");
  add("--lubricant", options.lubricant, "One of `prs list lubricants`; default: iso-vg-100",
      "LUBRICANT");
  add("--temperature", options.temperature, "Of the lubricant; default: 60 degC", "TEMPERATURE");
  take_one_of(command.add_option("--mechanism", options.mechanism,
                                 "One roller with its share, or all rollers; default: sector"),
              {"sector", "full"});
  add_value(command, "--lesson", options.lesson, "LESSON",
            "Copy a lesson, by number or name, and the files that it reads");
}

int new_case(const Options& all) {
  NewOptions options = all.new_case;
  if (options.lesson) {
    if (!options.file.empty())
      fail_option("--lesson", "got {} and {}; expected one FILE", input::shown(options.type),
                  input::shown(options.file));
    if (const std::string name = first_given(options); !name.empty())
      fail_option(
          name,
          "got a value; expected none with --lesson, which copies what is there; change the copy");
    std::swap(options.type, options.file);
  } else if (!options.type.empty() && options.type != "standard" && options.type != "inverted") {
    throw UsageError("TYPE: got {}; expected one of standard, inverted, then the FILE",
                     input::shown(options.type));
  }
  const std::optional<Lesson> copied =
      options.lesson ? std::optional(lesson(*options.lesson)) : std::nullopt;
  if (options.file.empty() || options.file == kStandardInput) {
    print(copied ? content_of_file(copied->file) : new_text(options));
    return kDone;
  }
  if (copied) {
    copy_lesson(*copied, options.file);
  } else {
    refuse_existing(options.file);
    write_case(options.file, new_text(options));
  }
  const std::string assumed = copied ? "" : assumptions(options);
  note(all, fmt::format("{0}: written{1}{2}; `prs check {0}` is the next step", options.file,
                        assumed.empty() ? "" : "; ", assumed));
  return kDone;
}

int configurations(const Options& options) {
  const ConfigurationOptions& asked = options.configurations;
  const ConfigurationQuery query = query_of(asked);
  const Configurations all = prs::configurations(query);
  if (all.found.empty()) refuse_none(all);

  const bool writes = !asked.write.empty();
  if (writes) write_configuration(chosen(all, asked), asked);
  const int status = deliver(
      {.file = "configurations.json",
       .document = [&](const DocumentInfo& info) { return configurations_json(all, info); },
       .table = [&] { return writes ? "" : configurations_table(query, all); },
       .files =
           [&](const CsvStyle& style) {
             return std::vector<OutputFile>{{"configurations.csv", configurations_csv(all, style)},
                                            {"gear_pairs.csv", gear_pairs_csv(all, style)}};
           }},
      {kVersion, kSchemaVersion, "", {}, "configurations"}, options);
  if (writes)
    note(options, fmt::format("{0}: line {1} is written; `prs check {0}` is the next step",
                              asked.write[1], asked.write[0]));
  return status;
}

}  // namespace prs::cli
