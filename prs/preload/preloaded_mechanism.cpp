#include "prs/preload/preloaded_mechanism.h"

#include <fmt/format.h>

#include "prs/model/problems.h"

namespace prs {

PerDirection<double> held_sections(const Structure::Thrust& thrust) {
  return {thrust.tension ? *thrust.tension : *thrust.compression,
          thrust.compression ? *thrust.compression : *thrust.tension};
}

PreloadSectors preload_sectors(const Conditions& c, const Contacts& contacts,
                               const PerInterface<ContactLaw>& laws, double position) {
  Preload preload = *c.preload;
  preload.position = position;
  const PreloadParts parts{contacts.mechanism, *c.structure, *c.materials, c.model, laws,
                           c.deviations,       preload};
  const PerDirection<double> section = held_sections(c.structure->nut.thrust);
  PreloadSectors sectors;
  for (const Direction d : kDirections) sectors[d] = build_preload_sector(parts, d, section[d]);
  return sectors;
}

Fit preload_fit(const Conditions& c, const Contacts& contacts, const PreloadSectors& sectors) {
  const Fit fit = find_fit(sectors.tension, *c.preload);
  const double found = interference(sectors.tension, fit);
  const double most = kMostDeviation * axial_pitch(contacts.mechanism);
  if (found <= most) return fit;
  throw CaseError(
      "preload.force",
      fmt::format("asks for an interference of {:.4g} mm; expected at most {:.4g} mm, a "
                  "quarter of the pitch; take less preload",
                  1e3 * found, 1e3 * most));
}

}  // namespace prs
