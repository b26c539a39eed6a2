#include "prs/output/check.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "prs/model/units.h"
#include "prs/quantities/contact_quantities.h"
#include "prs/quantities/record_table.h"
#include "prs/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

struct Derived {
  const char* key;
  double value;
};

/// Lengths that follow from the mechanism.
std::vector<Derived> lengths(const Mechanism& m) {
  const double contact_length = (m.contacts_per_roller - 1) * axial_pitch(m);
  const double spacing = 2.0 * *m.centre_distance * std::sin(std::numbers::pi / m.rollers);
  return {{"axial_pitch_mm", axial_pitch(m) * per_si::millimetre},
          {"contact_length_mm", contact_length * per_si::millimetre},
          {"roller_spacing_mm", spacing * per_si::millimetre}};
}

}  // namespace

std::string check_table(const std::vector<input::EchoEntry>& fields, const Contacts& contacts,
                        const std::vector<std::string>& warnings) {
  std::string text = "Input\n";
  for (const input::EchoEntry& f : fields)
    text += fmt::format(
        "  {:<42} {}{}\n", f.path, printable(f.value),
        f.is_default ? fmt::format("   ({})", f.origin.empty() ? "default" : f.origin) : "");
  text += "\nDerived\n";
  const auto line = [&](const std::string& key, double value) {
    text += fmt::format("  {:<42} {:.8g}\n", key, value);
  };
  for (const auto& [key, value] : lengths(contacts.mechanism)) line(key, value);
  const Json json = object_of(contacts);
  line("centre_distance_mm", json["centre_distance_mm"]);
  for (const char* key : {"pitch_diameter_mm", "helix_angle_deg"})
    for (const auto& [part, value] : json[key].items())
      line(fmt::format("{}.{}", key, part), value);
  line("max_rollers", json["max_rollers"]);
  const Json threads = object_of(contacts.threads);
  for (const auto& [part, widths] : threads.items())
    for (const auto& [key, value] : widths.items())
      line(fmt::format("threads.{}.{}", part, key), value);
  for (const char* interface : {"screw", "nut"})
    for (const char* key :
         {"normal_angle_deg", "backlash_mm", "flank_clearance_mm", "body_crest_clearance_mm",
          "roller_crest_clearance_mm", "hertz_constant_N_per_mm1_5"})
      if (json.contains(interface) && json[interface].contains(key))
        line(fmt::format("contact.{}.{}", interface, key), json[interface][key]);
  if (!warnings.empty()) text += "\nUnusual\n";
  for (const std::string& warning : warnings) text += wrapped(warning, "  ", 110);
  return text;
}

nlohmann::ordered_json check_json(const std::vector<input::EchoEntry>& fields,
                                  const Contacts& contacts,
                                  const std::vector<std::string>& warnings,
                                  const DocumentInfo& info) {
  Json document = document_head(info, warnings);
  for (const input::EchoEntry& f : fields) {
    document["input"].push_back({{"path", f.path}, {"value", f.value}, {"default", f.is_default}});
    if (!f.origin.empty()) document["input"].back()["origin"] = f.origin;
  }
  for (const auto& [key, value] : lengths(contacts.mechanism)) document["derived"][key] = value;
  put_contacts(document, contacts);
  return document;
}

}  // namespace prs
