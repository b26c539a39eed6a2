#include "prs/configurations/configurations_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "prs/configurations/configurations_json.h"
#include "prs/input/units.h"
#include "prs/model/units.h"
#include "prs/record/table_text.h"
#include "prs/record/table_units.h"
#include "prs/text.h"

namespace prs {
namespace {

/// Most left-out geometries that the table explains; beyond that, see the document.
constexpr std::size_t kMostDetails = 6;

struct Column {
  const char* title;
  const char* subtitle;
  std::size_t width;
  bool left_aligned;
};

constexpr Column kColumns[] = {
    {"#", "", 3, false},          {"type", "", 10, true},
    {"starts", "S/R", 6, false},  {"pitch", "mm", 7, false},
    {"screw", "mm", 8, false},    {"roller", "mm", 8, false},
    {"nut", "mm", 8, false},      {"centres", "mm", 8, false},
    {"hand", "roller", 7, false}, {"rollers", "≤", 8, false},
    {"one", "angle", 7, false},   {"gears", "teeth, module/mm", 18, false}};

std::string line(const auto& cell) {
  std::string text;
  for (std::size_t k = 0; k < std::size(kColumns); ++k) {
    text += padded(cell(k), kColumns[k].width, kColumns[k].left_aligned);
    if (k == 0) text += "  ";
  }
  while (text.ends_with(' ')) text.pop_back();
  return text + '\n';
}

std::string gears_cell(const Configuration& c) {
  if (c.gears.empty()) return std::string(kAbsent);
  const GearPair& best = c.gears.front();
  std::string text = fmt::format("{}:{}, {:.4g}{}", best.roller_teeth, best.body_teeth,
                                 best.module * per_si::millimetre, best.series == 1 ? "" : "*");
  if (best.most_rollers < c.mechanism.rollers) text += fmt::format(" ≤{}", best.most_rollers);
  return text;
}

std::string row(std::size_t number, const Configuration& c) {
  const auto mm = [](double si) { return fixed(si, "mm", 3); };
  const std::string cells[] = {
      std::to_string(number),
      std::string(type_name(c.mechanism.type)),
      fmt::format("{}/{}", c.mechanism.starts.screw, c.mechanism.starts.roller),
      mm(axial_pitch(c.mechanism)),
      mm(c.pitch_diameter.screw),
      mm(c.pitch_diameter.roller),
      mm(c.pitch_diameter.nut),
      mm(c.centre_distance),
      c.lead.roller > 0.0 ? "right" : "left",
      std::to_string(c.most_rollers),
      c.alike.empty() ? std::string(kAbsent) : fmt::format("{}", fmt::join(c.alike, " ")),
      gears_cell(c)};
  return line([&](std::size_t k) { return cells[k]; });
}

std::string heading(const ConfigurationQuery& q) {
  const auto length = [](double si) {
    return fmt::format("{:.6g} {}", shown(si, "mm"), table_unit("mm").text);
  };
  return fmt::format(
      "Screw {}, lead {}, flanks {}, no backlash, crests of neighbours {} apart or more\n\n",
      length(q.screw_diameter), length(q.lead),
      input::format_quantity(q.flank_angle, input::unit::angle), length(q.gap));
}

}  // namespace

std::string left_out_text(const Configurations& all) {
  const bool with_details = all.left_out.size() <= kMostDetails;
  std::vector<std::pair<std::string, std::string>> reasons;  // Reason, who.
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
  for (const auto& [key, who] : reasons)
    text += wrapped(who + key.substr(key.find(':')), "  ", kTableWidth);
  return text;
}

std::string configurations_table(const ConfigurationQuery& query, const Configurations& all) {
  std::string text = heading(query);
  text += line([](std::size_t k) { return kColumns[k].title; });
  text += line([](std::size_t k) { return with_table_unit(kColumns[k].subtitle); });
  for (std::size_t k = 0; k < all.found.size(); ++k) text += row(k + 1, all.found[k]);
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

}  // namespace prs
