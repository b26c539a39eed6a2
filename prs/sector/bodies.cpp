#include "prs/sector/bodies.h"

#include <algorithm>

#include "prs/sector/section_properties.h"

namespace prs {
namespace {

RoundBody operator+(const RoundBody& a, const RoundBody& b) {
  return {a.volume + b.volume, a.polar_moment + b.polar_moment};
}

}  // namespace

RoundBody tube(double outer, double inner, double length) {
  return {ring_area(outer, inner) * length,
          std::numbers::pi / 32.0 * (std::pow(outer, 4) - std::pow(inner, 4)) * length};
}

RoundBody nut_body(const Mechanism& m, const Structure::Nut& nut) {
  RoundBody body = tube(nut.outer_diameter, *m.pitch_diameter.nut, nut.length);
  for (const Structure::Flange& f : nut.flanges)
    body = body + tube(f.outer_diameter, nut.outer_diameter, f.to - f.from);
  return body;
}

RoundBody roller_body(const Mechanism& m, const Structure::Roller& roller) {
  return tube(*m.pitch_diameter.roller, 0.0, m.contacts_per_roller * axial_pitch(m)) +
         tube(roller.end_diameter, 0.0, 2.0 * roller.end_length);
}

RoundBody screw_body(const Mechanism& m, const Structure::Screw& screw, double length) {
  return tube(*m.pitch_diameter.screw, screw.bore, length);
}

double envelope_volume(const Structure::Nut& nut) {
  double diameter = nut.outer_diameter;
  for (const Structure::Flange& f : nut.flanges) diameter = std::max(diameter, f.outer_diameter);
  return disc_area(diameter) * nut.length;
}

}  // namespace prs
