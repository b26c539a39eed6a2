#include "prs/output/check.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "prs/output/text.h"
#include "prs/output/units.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// What follows from the mechanism, as documents and tables show it.
std::vector<std::pair<std::string, double>> derived(const MechanismSummary& s) {
  return {{"axial_pitch_mm", s.axial_pitch * per_si::millimetre},
          {"contact_length_mm", s.contact_length * per_si::millimetre},
          {"helix_angle_deg.screw", s.helix_angle.screw * per_si::degree},
          {"helix_angle_deg.roller", s.helix_angle.roller * per_si::degree},
          {"helix_angle_deg.nut", s.helix_angle.nut * per_si::degree},
          {"roller_spacing_mm", s.roller_spacing * per_si::millimetre},
          {"rollers_that_fit", s.rollers_that_fit}};
}

}  // namespace

std::string check_table(const std::vector<input::EchoEntry>& fields,
                        const MechanismSummary& summary, const std::vector<std::string>& warnings) {
  std::string text = "Input\n";
  for (const input::EchoEntry& f : fields)
    text += fmt::format("  {:<42} {}{}\n", f.path, printable(f.value),
                        f.is_default ? "   (default)" : "");
  text += "\nDerived\n";
  for (const auto& [key, value] : derived(summary))
    text += fmt::format("  {:<42} {:.8g}\n", key, value);
  if (!warnings.empty()) text += "\nUnusual\n";
  for (const std::string& warning : warnings) text += wrapped(warning, "  ", 110);
  return text;
}

nlohmann::ordered_json check_json(const std::vector<input::EchoEntry>& fields,
                                  const MechanismSummary& summary,
                                  const std::vector<std::string>& warnings,
                                  const DocumentInfo& info) {
  Json document = document_head(info, warnings);
  for (const input::EchoEntry& f : fields)
    document["input"].push_back({{"path", f.path}, {"value", f.value}, {"default", f.is_default}});
  for (const auto& [key, value] : derived(summary)) {
    const std::size_t dot = key.find('.');
    if (dot == std::string::npos)
      document["derived"][key] = value;
    else
      document["derived"][key.substr(0, dot)][key.substr(dot + 1)] = value;
  }
  return document;
}

}  // namespace prs
