#include "prs/configurations/configurations_files.h"

#include <fmt/ranges.h>

#include "prs/indices.h"
#include "prs/input/units.h"
#include "prs/loads/load_record.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {

Record<GearPair> record_of(Type<GearPair>);

namespace {

constexpr std::string_view kTypes = "standard | inverted | recirculating";

constexpr Quantity<Mechanism::Starts> kStarts[] = {
    {"screw", always<&Mechanism::Starts::screw>},
    {"roller", always<&Mechanism::Starts::roller>},
};

template <auto get>
constexpr auto its_mechanism = [](const Configuration& c) { return std::invoke(get, c.mechanism); };

std::optional<double> indexing(const Mechanism& m) {
  if (m.starts.roller == 0) return std::nullopt;
  return indexing_angle(m.type, m.starts, m.rollers);
}

std::vector<double> indexing_of_all(const Mechanism& m) {
  std::vector<double> all;
  for (int k = 0; m.starts.roller > 0 && k < m.rollers; ++k)
    all.push_back(indexing_angle(m.type, {m.starts.screw * k, m.starts.roller}, m.rollers));
  return all;
}

constexpr Quantity<Configuration> kRollers[] = {
    {"most", always<&Configuration::most_rollers>, "that fit with the gap"},
    {"chosen", always<its_mechanism<&Mechanism::rollers>>},
    {"crest_gap_mm", of<&Configuration::crest_gap>, "between neighbours"},
    {"unloaded", always<its_mechanism<[](auto& m) { return m.rollers - loaded_rollers(m); }>>, "that carry nothing"},
    {"indexing_angle_deg", of<its_mechanism<indexing>>, "by which each is turned against its neighbour"},
    {"indexing_angles_deg", of<its_mechanism<indexing_of_all>>,
     "of each roller against the carrier, the first one at 0"},
    {"alike", always<&Configuration::alike>, "numbers of rollers that all go in turned the same way"},
};

constexpr Quantity<GearPair> kGears[] = {
    {"roller_teeth", always<&GearPair::roller_teeth>},
    {"body_teeth", always<&GearPair::body_teeth>},
    {"module_mm", always<&GearPair::module>},
    {"series", always<&GearPair::series>, "of the standard modules"},
    {"working_pressure_angle_deg", of<&GearPair::working_pressure_angle>},
    {"profile_shift", of<&GearPair::profile_shift>},
    {"most_rollers", of<&GearPair::most_rollers>},
    {"tooth_misfit_mm", of<&GearPair::tooth_misfit>,
     "along the axis, of the threads of a roller that goes in one tooth off"},
};

double travel_speed(const Configuration& c) {
  return c.greatest_speed * std::abs(c.mechanism.lead) / (2.0 * std::numbers::pi);
}

const char* hand(const Configuration& c) {
  return c.lead.roller > 0.0 ? "right" : c.lead.roller < 0.0 ? "left" : "none";
}

using Numbered = Within<Configurations, Configuration>;

constexpr Quantity<Numbered> kConfiguration[] = {
    {"number", always<[](auto& c) { return c.item - c.whole->found.data() + 1; }>, "what `--write` takes"},
    {"type", always<[](auto& c) { return contact::facts_of(c.item->mechanism.type).name; }>, kTypes},
    {"starts", always_table<kStarts, its<its_mechanism<&Mechanism::starts>>>},
    {"pitch_mm", of<its<its_mechanism<axial_pitch>>>},
    {"rolling_diameter_mm", of<its<&Configuration::rolling_diameter>>},
    {"pitch_diameter_mm", of<its<&Configuration::pitch_diameter>>},
    {"centre_distance_mm", of<its<&Configuration::centre_distance>>},
    {"gear_ratio", of<its<&Configuration::gear_ratio>>},
    {"lead_mm", of<its<&Configuration::lead>>},
    {"helix_angle_deg", of<its<&Configuration::helix_angle>>},
    {"roller_hand", of<[](auto& c) { return hand(*c.item); }>, "right | left | none"},
    {"roller_profile_radius_mm", of<its<its_mechanism<[](auto& m) { return m.profile.roller.radius; }>>>},
    {"rollers", always_table<kRollers, its<std::identity{}>>},
    {"gears", always_table<kGears, its<&Configuration::gears>>, "the most suitable first"},
    {"nut_outer_diameter_mm", of<its<&Configuration::outer_diameter>>, "of the written case"},
    {"dynamic_capacity_kN", of<its<&Configuration::dynamic_capacity>>, "Lemor's, of the written case"},
    {"greatest_speed_rpm", of<its<&Configuration::greatest_speed>>, "with 150,000 mm/min over the screw's diameter"},
    {"greatest_travel_mm_per_s", of<its<travel_speed>>, "along the axis at that speed"},
};

constexpr Quantity<LeftOut> kLeftOut[] = {
    {"type", always<[](auto& l) { return contact::facts_of(l.type).name; }>, kTypes},
    {"starts", always_table<kStarts, &LeftOut::starts>},
    {"reason", always<&LeftOut::reason>},
    {"detail", filled<&LeftOut::detail>},
};

constexpr Quantity<Configurations> kConfigurations[] = {
    {"configurations", always_table<kConfiguration, [](auto& all) { return within(all, all.found); }>},
    {"left_out", always_table<kLeftOut, &Configurations::left_out>},
};

/// Largest number of left-out geometries that the table explains; for more, see the document.
constexpr std::size_t kMostDetails = 6;

std::string gears_cell(const Configuration& c) {
  if (c.gears.empty()) return std::string(kAbsent);
  const GearPair& best = c.gears.front();
  std::string text = fmt::format("{}:{}, {:.4g}{}", best.roller_teeth, best.body_teeth, best.module * "mm"_per_si,
                                 best.series == 1 ? "" : "*");
  if (best.most_rollers < c.mechanism.rollers) text += fmt::format(" ≤{}", best.most_rollers);
  return text;
}

std::string millimetres(double si) { return fixed(si, "mm", 3); }

using Found = const Configuration&;

struct Column {
  const char* title;
  const char* subtitle;
  std::size_t width;
  std::string (*cell)(Found);
  bool left_aligned = false;
};

constexpr Column kColumns[] = {
    {"  type", "", 12, [](Found c) { return fmt::format("  {}", contact::facts_of(c.mechanism.type).name); }, true},
    {"starts", "S/R", 6,
     [](Found c) { return fmt::format("{}/{}", c.mechanism.starts.screw, c.mechanism.starts.roller); }},
    {"pitch", "mm", 7, [](Found c) { return millimetres(axial_pitch(c.mechanism)); }},
    {"screw", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.screw); }},
    {"roller", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.roller); }},
    {"nut", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.nut); }},
    {"centres", "mm", 8, [](Found c) { return millimetres(c.centre_distance); }},
    {"hand", "roller", 7, [](Found c) { return std::string(hand(c)); }},
    {"rollers", "≤", 8, [](Found c) { return std::to_string(c.most_rollers); }},
    {"one", "angle", 7,
     [](Found c) { return c.alike.empty() ? std::string(kAbsent) : fmt::format("{}", fmt::join(c.alike, " ")); }},
    {"gears", "teeth, module/mm", 18, gears_cell}};

/// Columns of a comparison at one diameter of the nut.
constexpr Column kComparison[] = {
    kColumns[0],
    kColumns[1],
    kColumns[3],
    kColumns[4],
    {"rollers", "", 8, [](Found c) { return std::to_string(c.mechanism.rollers); }},
    {"C_a", "kN", 8, [](Found c) { return fixed(c.dynamic_capacity, "kN", 1); }},
    {"speed", "rpm", 7, [](Found c) { return fixed(c.greatest_speed, "rpm", 0); }},
    {"travel", "mm/s", 8, [](Found c) { return fixed(travel_speed(c), "mm/s", 0); }},
    {"gears", "teeth, module/mm", 18, gears_cell},
    {"misfit", "mm", 8,
     [](Found c) { return c.gears.empty() ? std::string(kAbsent) : millimetres(c.gears.front().tooth_misfit); }},
    {"turn", "deg", 9, [](Found c) {
       const std::optional<double> angle = indexing(c.mechanism);
       return angle ? fixed(*angle, "deg", 3) : std::string(kAbsent);
     }}};

/// A number and the cells after it.
std::string line(std::span<const Column> columns, std::string text, const auto& cell) {
  text = padded(text, 3, false);
  for (const Column& column : columns) text += padded(cell(column), column.width, column.left_aligned);
  return ended(text);
}

std::string heading(const ConfigurationQuery& q) {
  const auto length = [](double si) { return fmt::format("{:.6g} {}", shown(si, "mm"), table_unit("mm").text); };
  return fmt::format("{} {}, lead {}, flanks {}, no backlash, crests of neighbours {} apart or more\n\n",
                     q.nut_diameter ? "Nut" : "Screw", length(q.nut_diameter.value_or(q.screw_diameter)),
                     length(q.lead), input::format_quantity(q.flank_angle, input::unit::angle), length(q.gap));
}

}  // namespace

PRS_RECORD(GearPair, "GearPair", "Gears that fit the centre distance.", kGears);
PRS_RECORD(Configurations, "Configurations", "Starts that give a sound mechanism, and those that do not.",
           kConfigurations);

nlohmann::ordered_json configurations_json(const Configurations& all, const DocumentInfo& info) {
  nlohmann::ordered_json document = document_head(info, {});
  put_object(document, all);
  return document;
}

std::string left_out_text(const Configurations& all) {
  const bool with_details = all.left_out.size() <= kMostDetails;
  std::vector<std::pair<std::string, std::string>> reasons;  // Reason, starts concerned.
  for (const LeftOut& left_out : all.left_out) {
    std::string key = fmt::format("{}: {}", contact::facts_of(left_out.type).name, left_out.reason);
    if (with_details && !left_out.detail.empty()) key += fmt::format(" ({})", left_out.detail);
    auto known = std::ranges::find(reasons, key, &std::pair<std::string, std::string>::first);
    if (known == reasons.end()) {
      reasons.emplace_back(key, std::string(contact::facts_of(left_out.type).name));
      known = reasons.end() - 1;
    }
    known->second += fmt::format(" {}/{}", left_out.starts.screw, left_out.starts.roller);
  }
  std::string text;
  for (const auto& [key, who] : reasons) text += wrapped(who + key.substr(key.find(':')), "  ", kTableWidth);
  return text;
}

std::string configurations_table(const ConfigurationQuery& query, const Configurations& all) {
  std::string text = heading(query);
  const std::span<const Column> columns =
      query.nut_diameter ? std::span<const Column>(kComparison) : std::span<const Column>(kColumns);
  text += line(columns, "#", [](const Column& column) { return column.title; });
  text += line(columns, "", [](const Column& column) { return with_table_unit(column.subtitle); });
  for (std::size_t k = 0; k < all.found.size(); ++k)
    text += line(columns, std::to_string(k + 1), [&](const Column& column) { return column.cell(all.found[k]); });
  text += "\n";
  if (query.nut_diameter)
    text += wrapped(
        "C_a is Lemor's, of the case that `--write` gives, speed that of the makers' limit of 150,000 mm/min over the "
        "screw's diameter. Misfit: way along the axis by which the threads of a roller are off if it goes in one tooth "
        "beside its place. Turn: of each roller against the one before; the document has that of each. ",
        "", kTableWidth);
  text += wrapped(
      "Every number of rollers up to the one given meshes at equal spacing; with those of `one "
      "angle` "
      "all go in turned the same way. Gears: roller to nut (standard) or screw (inverted), the "
      "most suitable pair; * second series of modules, ≤ rollers whose pinions clear each other.",
      "", kTableWidth);
  if (!all.left_out.empty()) text += "\nLeft out\n" + left_out_text(all);
  return text;
}

std::string configurations_csv(const Configurations& all, const CsvStyle& style) {
  CsvRows csv(style);
  for (const auto k : indices(all.found)) {
    const Configuration& c = all.found[k];
    const Mechanism& m = c.mechanism;
    csv("number", k + 1);
    csv("type", contact::facts_of(m.type).name);
    csv("screw_starts", m.starts.screw);
    csv("roller_starts", m.starts.roller);
    csv("pitch_mm", axial_pitch(m));
    for (const Part p : kParts) csv(fmt::format("{}_rolling_diameter_mm", name(p)), c.rolling_diameter[p]);
    for (const Part p : kParts) csv(fmt::format("{}_pitch_diameter_mm", name(p)), c.pitch_diameter[p]);
    csv("centre_distance_mm", c.centre_distance);
    csv("gear_ratio", c.gear_ratio);
    csv("lead_mm", c.lead.screw);
    csv("roller_lead_mm", c.lead.roller);
    for (const Part p : kParts) csv(fmt::format("{}_helix_angle_deg", name(p)), c.helix_angle[p]);
    csv("most_rollers", c.most_rollers);
    csv("rollers", m.rollers);
    csv("crest_gap_mm", c.crest_gap);
    csv("indexing_angle_deg", indexing(m));
    csv("alike", fmt::format("{}", fmt::join(c.alike, " ")));
    csv("nut_outer_diameter_mm", c.outer_diameter);
    csv("dynamic_capacity_kN", c.dynamic_capacity);
    csv("greatest_speed_rpm", c.greatest_speed);
    csv("greatest_travel_mm_per_s", travel_speed(c));
    csv.end_row();
  }
  return csv.take();
}

std::string gear_pairs_csv(const Configurations& all, const CsvStyle& style) {
  CsvRows csv(style);
  const auto add_row = [&](const GearPair& pair, std::size_t k) {
    csv("number", k + 1);
    csv.record("", pair);
    csv.end_row();
  };
  add_row({}, 0);
  csv.drop_rows();
  for (const auto k : indices(all.found))
    for (const GearPair& pair : all.found[k].gears) add_row(pair, k);
  return csv.take();
}

}  // namespace prs
