#include "prs/configurations/configurations_json.h"

#include "prs/configurations/roller_spacing.h"
#include "prs/loads/contact_record.h"
#include "prs/record/record_table.h"

namespace prs {
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
    {"indexing_angle_deg",
     of<its_mechanism<[](auto& m) { return indexing_angle(m.type, m.starts, m.rollers); }>>,
     "by which each is turned against its neighbour"},
    {"alike", always<&Configuration::alike>,
     "numbers of rollers that all go in turned the same way"},
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
    {"number", always<[](auto& c) { return c.item - c.whole->found.data() + 1; }>,
     "what `--write` takes"},
    {"type", always<[](auto& c) { return type_name(c.item->mechanism.type); }>, kTypes},
    {"starts", always_table<kStarts, its<its_mechanism<&Mechanism::starts>>>},
    {"pitch_mm", of<its<its_mechanism<axial_pitch>>>},
    {"rolling_diameter_mm", of<its<&Configuration::rolling_diameter>>},
    {"pitch_diameter_mm", of<its<&Configuration::pitch_diameter>>},
    {"centre_distance_mm", of<its<&Configuration::centre_distance>>},
    {"gear_ratio", of<its<&Configuration::gear_ratio>>},
    {"lead_mm", of<its<&Configuration::lead>>},
    {"helix_angle_deg", of<its<&Configuration::helix_angle>>},
    {"roller_hand", of<[](auto& c) { return (c.item->lead.roller > 0.0) ? "right" : "left"; }>,
     "right | left"},
    {"roller_profile_radius_mm",
     of<its<its_mechanism<[](auto& m) { return m.profile.roller.radius; }>>>},
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
    {"configurations",
     always_table<kConfiguration, [](auto& all) { return within(all, all.found); }>},
    {"left_out", always_table<kLeftOut, &Configurations::left_out>},
};

}  // namespace

template <>
Record<Configurations> record_of() {
  return {"Configurations", "Starts that give a sound mechanism, and those that do not.",
          kConfigurations};
}

std::string_view type_name(Mechanism::Type type) {
  return type == Mechanism::Type::standard ? "standard" : "inverted";
}

nlohmann::ordered_json configurations_json(const Configurations& all, const DocumentInfo& info) {
  nlohmann::ordered_json document = document_head(info, {});
  put_object(document, all);
  return document;
}

}  // namespace prs
