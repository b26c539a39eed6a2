#include "prs/preload/preloaded_mechanism.h"

#include "prs/threads/contact_laws.h"

namespace prs {

PerDirection<double> held_sections(const Structure::Thrust& thrust) {
  return {thrust.tension ? *thrust.tension : *thrust.compression,
          thrust.compression ? *thrust.compression : *thrust.tension};
}

PreloadSectors preload_sectors(const Conditions& c, const Contacts& contacts,
                               const PerInterface<ContactLaw>& laws, double position, Play play) {
  Preload preload = *c.preload;
  preload.position = position;
  const PreloadParts parts{contacts.mechanism, *c.structure, *c.materials, c.model, laws,
                           c.deviations,       preload};
  const PerDirection<double> section = held_sections(c.structure->nut.thrust);
  PreloadSectors sectors;
  for (const Direction d : kDirections)
    sectors[d] = build_preload_sector(parts, d, section[d], play);
  return sectors;
}

namespace {

PreloadSector reference_sector(const Conditions& c, const Contacts& contacts) {
  Conditions cold = c;
  cold.deviations.temperature.reset();
  return preload_sectors(cold, contacts, contact_laws(c, contacts), c.preload->position).tension;
}

}  // namespace

Fit preload_fit(const Conditions& c, const Contacts& contacts, const PreloadSectors& sectors) {
  const bool warm = c.deviations.temperature.has_value();
  const Fit fit = find_fit(warm ? reference_sector(c, contacts) : sectors.tension, *c.preload);
  const double found = interference(sectors.tension, fit);
  const double most = kMostDeviation * axial_pitch(contacts.mechanism);
  if (found <= most) return warm ? at_temperature(sectors.tension, fit) : fit;
  throw CaseError(
      "preload.force",
      fmt::format("asks for an interference of {:.4g} mm; expected at most {:.4g} mm, a "
                  "quarter of the pitch; take less preload",
                  1e3 * found, 1e3 * most));
}

Conditions with_interference(Conditions c, const Contacts& contacts) {
  if (!c.preload || !c.preload->force) return c;
  Conditions cold = c;
  cold.deviations.temperature.reset();
  const PreloadSectors sectors =
      preload_sectors(cold, contacts, contact_laws(cold, contacts), cold.preload->position);
  c.preload->interference = interference(sectors.tension, preload_fit(cold, contacts, sectors));
  c.preload->force.reset();
  return c;
}

double reference_preload(const Conditions& c, const Contacts& contacts) {
  const PreloadSector sector = reference_sector(c, contacts);
  return PreloadSolver(fitted(sector, find_fit(sector, *c.preload)))
      .at_rest()
      .sides.tension.axial_load.screw;
}

}  // namespace prs
