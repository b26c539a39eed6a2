#include "prs/model/block_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/model/quantity_text.h"

namespace prs {
namespace {

void check_pitch_error(const PitchError& e, Part part, const Mechanism& m, Problems& problems) {
  const auto path = [&] { return fmt::format("deviations.pitch_error.{}", name(part)); };
  const auto contacts = static_cast<std::size_t>(m.contacts_per_roller);
  if (!e.list.empty() && e.list.size() != contacts)
    problems.add(path() + ".list",
                 fmt::format("got {} value{}; expected {}, one per contact of a roller; {}",
                             e.list.size(), e.list.size() == 1 ? "" : "s", contacts,
                             e.list.size() < contacts ? "add the others, 0 where nothing deviates"
                                                      : "delete the others"));
  double largest = std::max(std::abs(e.linear), e.periodic ? std::abs(e.periodic->amplitude) : 0.0);
  for (const double value : e.list) largest = std::max(largest, std::abs(value));
  if (largest > kMostDeviation * axial_pitch(m))
    problems.add(path(), fmt::format("got up to {}; expected at most {}, a quarter of the pitch; "
                                     "check the unit",
                                     mm(largest), mm(kMostDeviation * axial_pitch(m))));
}

}  // namespace

void check_offset(const char* path, double offset, const Mechanism& m, Problems& problems) {
  const double most = kMostDeviation * axial_pitch(m);
  if (std::abs(offset) > most)
    problems.add(path,
                 fmt::format("got {}; expected at most {} either way, a quarter of the pitch; "
                             "check the unit",
                             mm(offset), mm(most)));
}

void check_deviations(const Case& c, Problems& problems) {
  const Deviations& d = c.deviations;
  const Mechanism& m = c.mechanism;
  for (const Part part : kParts) check_pitch_error(d.pitch_error[part], part, m, problems);
  const std::pair<const char*, double> drops[] = {
      {"deviations.roller_diameter", d.roller_diameter},
      {"deviations.crowning", d.crowning},
      {"deviations.end_relief.drop", d.end_relief ? d.end_relief->drop : 0.0}};
  for (const auto& [path, value] : drops) check_offset(path, value, m, problems);
  if (d.end_relief && 2 * d.end_relief->threads > m.contacts_per_roller)
    problems.add("deviations.end_relief.threads",
                 fmt::format("got {}; expected at most {}, half of the contacts of a roller",
                             d.end_relief->threads, m.contacts_per_roller / 2));
  if (!d.temperature || !c.materials) return;
  for (const Part part : kParts)
    if ((*d.temperature)[part] != d.reference_temperature &&
        !(*c.materials)[part].thermal_expansion)
      problems.add("materials",
                   fmt::format("the {} lacks `thermal_expansion`; expected it where a temperature "
                               "differs from the reference, {}; add `thermal_expansion: 11.5 "
                               "um/m/K`, for example",
                               name(part), celsius(d.reference_temperature)));
}

}  // namespace prs
