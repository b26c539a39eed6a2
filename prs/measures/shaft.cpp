#include "prs/measures/shaft.h"

#include "prs/model/groove.h"
#include "prs/sector/section_properties.h"

namespace prs {
namespace {

using std::numbers::pi;
using Ends = MeasureOptions::Ends;

double bending_root(Ends ends) {
  switch (ends) {
    case Ends::fixed_free:
      return 1.87510406871196117;
    case Ends::supported_supported:
      return pi;
    case Ends::fixed_supported:
      return 3.92660231204791878;
    case Ends::fixed_fixed:
      return 4.73004074486270403;
  }
  return 0.0;
}

}  // namespace

ShaftSection core_section(const Mechanism& m, const Structure::Screw& screw) {
  const std::optional<ThreadHeight>& thread = m.thread.screw;
  const double depth =
      thread ? thread->dedendum : default_root_depth(axial_pitch(m), m.flank_angle.screw);
  return {*m.pitch_diameter.screw - 2.0 * depth, screw.bore};
}

double radius_of_gyration(const ShaftSection& s) { return 0.25 * std::hypot(s.diameter, s.bore); }

double effective_length_factor(Ends ends) {
  switch (ends) {
    case Ends::fixed_free:
      return 2.0;
    case Ends::supported_supported:
      return 1.0;
    case Ends::fixed_supported:
      return pi / 4.49340945790906418;
    case Ends::fixed_fixed:
      return 0.5;
  }
  return 0.0;
}

double buckling_load(const ShaftSection& section, double modulus,
                     const MeasureOptions::Shaft& shaft, std::optional<double> yield) {
  const double area = ring_area(section.diameter, section.bore);
  const double slenderness =
      effective_length_factor(shaft.ends) * shaft.length / radius_of_gyration(section);
  const double euler = pi * pi * modulus / (slenderness * slenderness);
  if (yield && euler > 0.5 * *yield) return area * *yield * (1.0 - 0.25 * *yield / euler);
  return area * euler;
}

double critical_speed(const ShaftSection& section, double modulus, double density,
                      const MeasureOptions::Shaft& shaft) {
  const double wave_number = bending_root(shaft.ends) / shaft.length;
  return wave_number * wave_number * radius_of_gyration(section) * std::sqrt(modulus / density);
}

}  // namespace prs
