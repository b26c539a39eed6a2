#include "prs/configurations/configurations_files.h"

#include <fmt/ranges.h>

#include "prs/input/units.h"
#include "prs/loads/load_record.h"
#include "prs/record/record_table.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {

Record<GearPair> record_of(Type<GearPair>);

namespace {

constexpr std::string_view kTypes = "standard | inverted";

constexpr Quantity<Mechanism::Starts> kStarts[] = {
    {"screw", always<&Mechanism::Starts::screw>},
    {"roller", always<&Mechanism::Starts::roller>},
};

template <auto get>
constexpr auto its_mechanism = [](const Configuration& c) { return std::invoke(get, c.mechanism); };

constexpr Quantity<Configuration> kRollers[] = {
    {"most", always<&Configuration::most_rollers>, "that fit with the gap"},
    {"chosen", always<its_mechanism<&Mechanism::rollers>>},
    {"crest_gap_mm", of<&Configuration::crest_gap>, "between neighbours"},
    {"indexing_angle_deg", of<its_mechanism<[](auto& m) { return indexing_angle(m.type, m.starts, m.rollers); }>>,
     "by which each is turned against its neighbour"},
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
};

using Numbered = Within<Configurations, Configuration>;

constexpr Quantity<Numbered> kConfiguration[] = {
    {"number", always<[](auto& c) { return c.item - c.whole->found.data() + 1; }>, "what `--write` takes"},
    {"type", always<[](auto& c) { return type_name(c.item->mechanism.type); }>, kTypes},
    {"starts", always_table<kStarts, its<its_mechanism<&Mechanism::starts>>>},
    {"pitch_mm", of<its<its_mechanism<axial_pitch>>>},
    {"rolling_diameter_mm", of<its<&Configuration::rolling_diameter>>},
    {"pitch_diameter_mm", of<its<&Configuration::pitch_diameter>>},
    {"centre_distance_mm", of<its<&Configuration::centre_distance>>},
    {"gear_ratio", of<its<&Configuration::gear_ratio>>},
    {"lead_mm", of<its<&Configuration::lead>>},
    {"helix_angle_deg", of<its<&Configuration::helix_angle>>},
    {"roller_hand", of<[](auto& c) { return (c.item->lead.roller > 0.0) ? "right" : "left"; }>, "right | left"},
    {"roller_profile_radius_mm", of<its<its_mechanism<[](auto& m) { return m.profile.roller.radius; }>>>},
    {"rollers", always_table<kRollers, its<std::identity{}>>},
    {"gears", always_table<kGears, its<&Configuration::gears>>, "the most suitable first"},
};

constexpr Quantity<LeftOut> kLeftOut[] = {
    {"type", always<[](auto& l) { return type_name(l.type); }>, kTypes},
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
    {"  type", "", 12, [](Found c) { return fmt::format("  {}", type_name(c.mechanism.type)); }, true},
    {"starts", "S/R", 6,
     [](Found c) { return fmt::format("{}/{}", c.mechanism.starts.screw, c.mechanism.starts.roller); }},
    {"pitch", "mm", 7, [](Found c) { return millimetres(axial_pitch(c.mechanism)); }},
    {"screw", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.screw); }},
    {"roller", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.roller); }},
    {"nut", "mm", 8, [](Found c) { return millimetres(c.pitch_diameter.nut); }},
    {"centres", "mm", 8, [](Found c) { return millimetres(c.centre_distance); }},
    {"hand", "roller", 7, [](Found c) { return std::string(c.lead.roller > 0.0 ? "right" : "left"); }},
    {"rollers", "≤", 8, [](Found c) { return std::to_string(c.most_rollers); }},
    {"one", "angle", 7,
     [](Found c) { return c.alike.empty() ? std::string(kAbsent) : fmt::format("{}", fmt::join(c.alike, " ")); }},
    {"gears", "teeth, module/mm", 18, gears_cell}};

/// A number and the cells after it.
std::string line(std::string text, const auto& cell) {
  text = padded(text, 3, false);
  for (const Column& column : kColumns) text += padded(cell(column), column.width, column.left_aligned);
  return ended(text);
}

std::string heading(const ConfigurationQuery& q) {
  const auto length = [](double si) { return fmt::format("{:.6g} {}", shown(si, "mm"), table_unit("mm").text); };
  return fmt::format("Screw {}, lead {}, flanks {}, no backlash, crests of neighbours {} apart or more\n\n",
                     length(q.screw_diameter), length(q.lead),
                     input::format_quantity(q.flank_angle, input::unit::angle), length(q.gap));
}

}  // namespace

PRS_RECORD(GearPair, "GearPair", "Gears that fit the centre distance.", kGears);
PRS_RECORD(Configurations, "Configurations", "Starts that give a sound mechanism, and those that do not.",
           kConfigurations);

std::string_view type_name(Mechanism::Type type) { return type == Mechanism::Type::standard ? "standard" : "inverted"; }

nlohmann::ordered_json configurations_json(const Configurations& all, const DocumentInfo& info) {
  nlohmann::ordered_json document = document_head(info, {});
  put_object(document, all);
  return document;
}

std::string left_out_text(const Configurations& all) {
  const bool with_details = all.left_out.size() <= kMostDetails;
  std::vector<std::pair<std::string, std::string>> reasons;  // Reason, starts concerned.
  for (const LeftOut& left_out : all.left_out) {
    std::string key = fmt::format("{}: {}", type_name(left_out.type), left_out.reason);
    if (with_details && !left_out.detail.empty()) key += fmt::format(" ({})", left_out.detail);
    auto known = std::ranges::find(reasons, key, &std::pair<std::string, std::string>::first);
    if (known == reasons.end()) {
      reasons.emplace_back(key, std::string(type_name(left_out.type)));
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
  text += line("#", [](const Column& column) { return column.title; });
  text += line("", [](const Column& column) { return with_table_unit(column.subtitle); });
  for (std::size_t k = 0; k < all.found.size(); ++k)
    text += line(std::to_string(k + 1), [&](const Column& column) { return column.cell(all.found[k]); });
  text += "\n";
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
  CsvWriter csv(style);
  csv.row("number", "type", "screw_starts", "roller_starts", "pitch_mm", "screw_rolling_diameter_mm",
          "roller_rolling_diameter_mm", "nut_rolling_diameter_mm", "screw_pitch_diameter_mm",
          "roller_pitch_diameter_mm", "nut_pitch_diameter_mm", "centre_distance_mm", "gear_ratio", "lead_mm",
          "roller_lead_mm", "screw_helix_angle_deg", "roller_helix_angle_deg", "nut_helix_angle_deg", "most_rollers",
          "rollers", "crest_gap_mm", "indexing_angle_deg", "alike");
  constexpr double mm = "mm"_per_si, degree = "deg"_per_si;
  for (std::size_t k = 0; k < all.found.size(); ++k) {
    const Configuration& c = all.found[k];
    const Mechanism& m = c.mechanism;
    csv.fields(k + 1, type_name(m.type), m.starts.screw, m.starts.roller, axial_pitch(m) * mm);
    for (const auto* diameter : {&c.rolling_diameter, &c.pitch_diameter})
      for (const Part p : kParts) csv.number((*diameter)[p], mm);
    csv.fields(c.centre_distance * mm, c.gear_ratio, c.lead.screw * mm, c.lead.roller * mm);
    for (const Part p : kParts) csv.number(c.helix_angle[p], degree);
    csv.row(c.most_rollers, m.rollers, scaled(c.crest_gap, mm),
            scaled(indexing_angle(m.type, m.starts, m.rollers), degree), fmt::format("{}", fmt::join(c.alike, " ")));
  }
  return csv.take();
}

std::string gear_pairs_csv(const Configurations& all, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.text("number");
  scalar_header<GearPair>(csv);
  csv.end_row();
  for (std::size_t k = 0; k < all.found.size(); ++k)
    for (const GearPair& g : all.found[k].gears) {
      csv.integer(k + 1);
      scalar_fields<GearPair>(csv, &g);
      csv.end_row();
    }
  return csv.take();
}

}  // namespace prs
