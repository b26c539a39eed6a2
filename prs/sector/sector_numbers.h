#pragma once

#include "prs/model/part.h"
#include "simd/inlined.h"

namespace prs {

/// Rigidities of a roller's section.
template <class Number>
struct RollerSection {
  Number axial{};    ///< E A [N]
  Number bending{};  ///< E I [N m^2]
  Number shear{};    ///< kappa G A [N]; 0 leaves shear out.
};

/// The numbers of one sector (Abevi 2015, section 3) that do not belong to a single thread or
/// flange. `Number` is a number, a batch of numbers, one per design, or a column of designs.
/// Rigidities of screw and nut are those of the mechanism divided by the rollers. SI units.
template <class Number>
struct SectorNumbers {
  Number rollers{};
  Number sense{};  ///< s, -1 in tension and +1 in compression.
  Number pitch{};  ///< Distance of neighbouring contacts [m].

  Number plain_screw_rigidity{};  ///< E A from the loaded section to the first contact [N].
  Number free_length{};           ///< Distance of these two; 0 if they are the same place [m].
  Number screw_rigidity{};        ///< E A between the contacts [N]

  RollerSection<Number> thread;    ///< Section of the roller between its end elements.
  RollerSection<Number> end;       ///< Section of the roller's end elements.
  Number end_length{};             ///< [m]
  Number outer_guide{};            ///< Radial stiffness at the outermost nodes; infinite: held [N/m].
  Number inner_guide{};            ///< Radial stiffness at the inner nodes of the end elements [N/m].
  Number rigid_bending{};          ///< 1 if v = theta = 0 everywhere, else 0.
  Number roller_radius{};          ///< Rigid arms of the contacts [m].
  Number contact_half_distance{};  ///< Half the distance along x of a tooth's two contacts [m].

  Number nut_rigidity{};  ///< E A between the flanges [N]
  Number nut_length{};    ///< [m]
  Number thrust{};        ///< Position of the held section [m].
  Number position{};      ///< Position of the first contact [m].

  PerInterface<Number> hertz_constant;  ///< k_0 [N/m^1.5]
  PerInterface<Number> cosine, sine;    ///< cos(psi), sin(psi).
  PerInterface<Number> compliance;      ///< Compliance of the teeth, in series with the contact [m/N].
  /// Axial displacement of the loaded section per load on one roller that does not act on the contacts, due to
  /// Poisson's contraction [m/N].
  Number offset_compliance{};
};

/// Dimensions from which refined bodies are computed, beyond a sector's numbers.
template <class Number>
struct RefinedNumbers {
  PerPart<contact::ElasticityOf<Number>> material;
  Number screw_radius{};      ///< Pitch radius of the screw [m].
  Number screw_bore{};        ///< Radius of its bore [m].
  Number nut_pitch_radius{};  ///< [m]
  Number ring_inner{};        ///< Radii of the ring that the thrust section leans on; 0 without a ring [m].
  Number ring_outer{};
};

/// f(a.n, b.n, ..) for every number n of sectors side by side.
template <class F, class... Sectors>
PRS_INLINED inline void for_each_number(F f, Sectors&... s) {
  const auto section = [&](auto&... r) PRS_INLINED {
    f(r.axial...);
    f(r.bending...);
    f(r.shear...);
  };
  const auto interfaces = [&](auto&... i) PRS_INLINED {
    f(i.screw...);
    f(i.nut...);
  };
  f(s.rollers...);
  f(s.sense...);
  f(s.pitch...);
  f(s.plain_screw_rigidity...);
  f(s.free_length...);
  f(s.screw_rigidity...);
  section(s.thread...);
  section(s.end...);
  f(s.end_length...);
  f(s.outer_guide...);
  f(s.inner_guide...);
  f(s.rigid_bending...);
  f(s.roller_radius...);
  f(s.contact_half_distance...);
  f(s.nut_rigidity...);
  f(s.nut_length...);
  f(s.thrust...);
  f(s.position...);
  interfaces(s.hertz_constant...);
  interfaces(s.cosine...);
  interfaces(s.sine...);
  interfaces(s.compliance...);
  f(s.offset_compliance...);
}

}  // namespace prs
