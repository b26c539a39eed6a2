
#include "prs/cli/commands.h"
#include "prs/cli/deliver.h"
#include "prs/cli/option_values.h"
#include "prs/configurations/configurations_files.h"
#include "prs/configurations/screw_case.h"
#include "prs/input/source.h"
#include "prs/output/files.h"
#include "prs/version.h"

namespace prs::cli {
namespace {

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
