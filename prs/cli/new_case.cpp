#include "prs/cli/new_case.h"

#include <fmt/ranges.h>

#include "prs/cli/command_line.h"
#include "prs/cli/package.h"
#include "prs/cli/program.h"
#include "prs/configurations/configurations_files.h"
#include "prs/configurations/new_case.h"
#include "prs/configurations/screw_case.h"
#include "prs/version.h"

namespace prs::cli {
namespace {

namespace fs = std::filesystem;

/// Case of a screw by the command line.
std::string new_text(const NewOptions& options) {
  try {
    return new_case_text(options);
  } catch (const CaseError& error) {
    fail_option(error.path(), error.what());
  }
}

std::string content_of_file(const fs::path& file) { return input::load_source(file.string(), {}).text; }

/// Copies the files that the lesson reads, except those that stand there already, as after another lesson.
void copy_companions(const Lesson& lesson, const fs::path& file) {
  std::vector<std::pair<fs::path, std::string>> copies;
  for (const std::string& name : companions(input::load_source(lesson.file.string(), {}))) {
    const fs::path copy = file.parent_path() / name;
    std::string content = content_of_file(lesson.file.parent_path() / name);
    if (fs::is_regular_file(copy) && fs::file_size(copy) == content.size() && content_of_file(copy) == content)
      continue;
    refuse_taken(OutputOptions{}, copy);
    copies.emplace_back(copy, std::move(content));
  }
  for (const auto& [copy, content] : copies) write_case(copy, content);
}

ConfigurationQuery query_of(const ConfigurationOptions& o) {
  using namespace input;
  constexpr double kDegree = std::numbers::pi / 180;
  const Bounds size{1e-3, 1.0};
  ConfigurationQuery q;
  if (o.screw_diameter.has_value() == o.nut_diameter.has_value())
    fail_option("--screw-diameter", "{}; expected this or `--nut-diameter`; give one of them",
                o.screw_diameter ? "got it and the nut's" : "missing");
  const std::string_view size_text = "1 mm to 1 m; check the unit";
  if (o.screw_diameter)
    q.screw_diameter = quantity_option("--screw-diameter", *o.screw_diameter, unit::length, size, size_text);
  else
    q.nut_diameter = quantity_option("--nut-diameter", *o.nut_diameter, unit::length, size, size_text);
  const double diameter = q.nut_diameter.value_or(q.screw_diameter);
  q.lead = quantity_option("--lead", o.lead, unit::length, not_zero,
                           "a lead other than 0; > 0 right-handed, < 0 left-handed");
  if (std::abs(q.lead) > 10.0 * diameter || std::abs(q.lead) < 1e-4 * diameter)
    fail_option("--lead", "got {}; expected 0.0001 to 10 diameters; check the units", shown(o.lead));
  if (o.flank_angle)
    q.flank_angle = quantity_option("--flank-angle", *o.flank_angle, unit::angle, {20 * kDegree, 70 * kDegree},
                                    "20 deg to 70 deg, usually 45 deg");
  if (o.gap) q.gap = quantity_option("--gap", *o.gap, unit::length, not_negative, "0 mm or more");
  if (o.roller_profile_radius)
    q.roller_profile_radius =
        quantity_option("--roller-profile-radius", *o.roller_profile_radius, unit::length, positive, "more than 0 mm");
  if (o.type) q.type = contact::type_named(*o.type);
  q.screw_starts = o.starts;
  q.roller_starts = o.roller_starts;
  q.rollers = o.rollers;
  return q;
}

[[noreturn]] void refuse_none(const Configurations& nothing) {
  std::string reasons = left_out_text(nothing);
  reasons.pop_back();  // Without the newline that the printing of the error adds.
  throw input::InputError(
      "prs: error: no valid screw has this diameter, lead and starts; change what the reasons "
      "name\n" +
      reasons);
}

/// The configuration chosen by `--write`.
const Configuration& chosen(const Configurations& all, const ConfigurationOptions& o) {
  const std::optional<double> number = input::parse_number(o.write[0]);
  if (number)
    for (std::size_t k = 0; k < all.found.size(); ++k)
      if (*number == static_cast<double>(k + 1)) return all.found[k];
  fail_option("--write", "got {}; expected the number of a line, 1 to {}, and a file", input::shown(o.write[0]),
              all.found.size());
}

/// Writes the case of `--write` into a new file.
void write_configuration(const Configuration& configuration, const Options& options) {
  const ConfigurationOptions& o = options.configurations;
  const auto text = [&] {
    try {
      return configuration_case(configuration);
    } catch (const CaseError& error) {
      fail_option("--write", "line {}: {}: {}", o.write[0], error.path(), error.what());
    }
  }();
  refuse_taken(options, o.write[1]);
  write_new(options, o.write[1], text, fmt::format("line {} is written", o.write[0]));
}

}  // namespace

void refuse_taken(const OutputOptions& options, const fs::path& file) {
  if (file == kStandardInput && options.json)
    throw UsageError("got --json and `-` for a case; expected one document; give a file for the case");
  std::error_code told_by_the_file;
  if (file != kStandardInput && fs::exists(fs::symlink_status(file, told_by_the_file)))
    throw UsageError("{}: the file exists already; give another name", input::shown(file.string()));
}

void write_new(const OutputOptions& options, const std::string& file, const std::string& text,
               const std::string& said) {
  if (file != kStandardInput) {
    write_case(file, text);
    return note(options, fmt::format("{}: {}; `prs check {}` is the next step", file, said, quoted(file)));
  }
  print(text);
}

void add_new_options(CLI::App& command, NewOptions& options) {
  add_value(command, "type", options.type, "standard|inverted|recirculating", "Type of the screw");
  add_value(command, "file", options.file, "FILE", "New file; printed without one, or with `-`");
  const auto add = [&](const char* name, std::optional<std::string>& text, const char* what, const char* kind) {
    command.add_option(name, text, what)->type_name(kind);
  };
  add("--screw-diameter", options.screw_diameter, "Nominal diameter, with its unit", "LENGTH");
  add("--lead", options.lead, "Of screw and nut; > 0 right-handed", "LENGTH");
  take_whole_number(
      command.add_option("--starts", options.starts, "Of screw and nut; default: 5, 4 or 3, recirculating 1"), 1, 100);
  take_whole_number(command.add_option("--rollers", options.rollers, "Default: as many as fit"), 1, 1000);
  add("--nut-diameter", options.nut_diameter, "Outer; default: as in catalogues", "LENGTH");
  add("--nut-length", options.nut_length,
      "Of the whole nut, inverted: of the tube that the rollers travel in; default: by rule", "LENGTH");
  add("--roller-diameter", options.roller_diameter,
      "Of a recirculating screw, pitch diameter; default: that of a standard screw of three starts", "LENGTH");
  add("--roller-profile-radius", options.roller_profile_radius, "Of the convex rollers; default: 5 pitches", "LENGTH");
  add("--load", options.load, "Axial; default: 1.8 GPa with equal thread loads", "FORCE");
  add("--speed", options.speed, "Screw against nut; default: half of 150,000 mm/min over the diameter", "SPEED");
  add("--lubricant", options.lubricant, "One of `prs list lubricants`; default: iso-vg-100", "LUBRICANT");
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
      fail_option(name, "got a value; expected none with --lesson, which copies what is there; change the copy");
    std::swap(options.type, options.file);
  } else if (!options.type.empty() && !contact::type_named(options.type)) {
    throw UsageError("TYPE: got {}; expected one of standard, inverted, recirculating, then the FILE",
                     input::shown(options.type));
  }
  const std::optional<Lesson> copied = options.lesson ? std::optional(lesson(*options.lesson)) : std::nullopt;
  if (options.file.empty()) options.file = kStandardInput;
  refuse_taken(all, options.file);
  if (copied && options.file != kStandardInput) copy_companions(*copied, options.file);
  const std::string assumed = copied ? "" : assumptions(options);
  write_new(all, options.file, copied ? content_of_file(copied->file) : new_text(options),
            fmt::format("written{}{}", assumed.empty() ? "" : "; ", assumed));
  return kDone;
}

int configurations(const Options& options) {
  const ConfigurationOptions& asked = options.configurations;
  const ConfigurationQuery query = query_of(asked);
  const Configurations all = prs::configurations(query);
  if (all.found.empty()) refuse_none(all);

  const bool writes = !asked.write.empty();
  if (writes) write_configuration(chosen(all, asked), options);
  Options rest = options;
  if (writes && asked.write[1] == kStandardInput) rest.quiet = true;
  return deliver({.file = "configurations.json",
                  .document = [&](const DocumentInfo& info) { return configurations_json(all, info); },
                  .table = [&] { return writes ? "" : configurations_table(query, all); },
                  .files =
                      [&](const CsvStyle& style) {
                        return std::vector<OutputFile>{{"configurations.csv", configurations_csv(all, style)},
                                                       {"gear_pairs.csv", gear_pairs_csv(all, style)}};
                      }},
                 {kVersion, kSchemaVersion, "", {}, "configurations"}, rest);
}

}  // namespace prs::cli
