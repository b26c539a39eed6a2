#pragma once

#include "prs/model/deviations.h"
#include "prs/model/load_case.h"
#include "prs/sector/refined/nut_formulas.h"
#include "prs/sector/refined/nut_shell.h"
#include "prs/sector/ring_guide.h"
#include "prs/sector/sector_numbers.h"
#include "prs/threads/contact_law.h"

namespace prs {

/// Stiffness of a rigid support.
inline constexpr double kHeld = std::numeric_limits<double>::infinity();

/// Refined bodies as numbers, before the shells and compliances are computed.
struct RefinedBodies {
  RefinedNumbers<double> numbers;
  NutLine line;
  NutBore bore;
  std::vector<int> same;  ///< First segment equal to it, for each segment of the line.
  bool has_ring = false;  ///< Whether the thrust section leans on a ring.
  RefinedEffects effects;

  bool has_shell() const { return effects.hoop || effects.flange; }
  NutShape shape() const { return {line.contacts, line.thrust, same, has_ring, effects}; }
};

/// One roller with its share of screw and nut as numbers: all that a solver of bars or refined bodies reads.
struct SectorModel : SectorNumbers<double> {
  /// Stretch of the nut with an outer radius of its own. Flanges do not overlap.
  struct Flange {
    double from = 0.0;            ///< Start, as in `Structure` [m].
    double to = 0.0;              ///< End [m].
    double outer_radius = 0.0;    ///< [m]
    double axial_rigidity = 0.0;  ///< E A of the nut there [N]
  };
  double guide_clearance = 0.0;  ///< Clearance of both guides of an end [m]; > 0: they are rings.
  double nut_radius = 0.0;       ///< Outer radius between the flanges [m].
  std::vector<Flange> flanges;
  bool is_refined = false;
  RefinedBodies bodies;               ///< Bodies of a refined sector.
  std::optional<NutShell> nut_shell;  ///< Shell in place of the nut's bars.

  PerInterface<std::vector<double>> gaps;  ///< Initial gap of each thread along the normal [m].
  /// Compliance of refined bodies in series with each contact, added to `compliance` [m/N]; empty:
  /// none.
  PerInterface<std::vector<double>> body_compliance;

  int contacts() const { return static_cast<int>(gaps.screw.size()); }
  bool bends() const { return rigid_bending == 0.0; }
  /// Whether the roller bends and rings guide it with a clearance, which the chain solver does not take.
  bool has_loose_guides() const { return bends() && guide_clearance > 0.0; }
  RingGuide ring_guide() const { return {outer_guide, guide_clearance}; }
  bool contacts_apart() const { return contact_half_distance > 0.0; }
  /// Compliance in series with the Hertz contact of thread k [m/N].
  double contact_compliance(Interface i, std::size_t k) const {
    return compliance[i] + (body_compliance[i].empty() ? 0.0 : body_compliance[i][k]);
  }
  bool has_compliance() const {
    return !body_compliance.screw.empty() || compliance.screw != 0.0 || compliance.nut != 0.0;
  }
};

/// The sector for one direction of the load and one position of the first contact on the nut, refined by the options
/// (docs/refined.md). The case must have passed `check_case`.
///
/// With `refined.core`, roots lie by the dedendum of `mechanism.thread` from the pitch radius, by default that of
/// `default_groove`. In a thin nut they are less deep: they leave `kLeastWall`, or half of the wall outside the pitch
/// radius if that is less. The thread of an inverted screw begins at its first contact, that of a standard one at the
/// loaded section.
SectorModel sector_model(const Mechanism& mechanism, const Structure& structure, const Materials& materials,
                         const ModelOptions& options, const PerInterface<ContactLaw>& laws, Direction direction,
                         double position, const Deviations& deviations = {});

/// Fills a model that keeps its memory; refined bodies are left to `work_out`, laws without a constant to `set_laws`.
void set_sector_model(SectorModel& model, const Mechanism& mechanism, const Structure& structure,
                      const Materials& materials, const ModelOptions& options, const PerInterface<ContactLaw>& laws,
                      Direction direction, double position, const Deviations& deviations);

/// Replaces the laws of a sector of bars without initial gaps, where nothing else depends on them.
void set_laws(SectorModel& model, const PerInterface<ContactLawNumbers>& laws);

/// Computes shells and compliances of refined bodies.
void work_out(SectorModel& model);

/// Nodes at the ends, the flange faces, the thrust section and the contacts.
NutLine nut_line(const SectorModel& model);
/// Fills a line that keeps its memory.
void set_nut_line(NutLine& line, const SectorModel& model);
/// Nut line with contacts at these places.
NutLine nut_line(const SectorModel& model, const std::vector<double>& contact_x);

/// Radii of the sections that carry axial force and bend, as in `sector_model` [m].
struct BodyRadii {
  double plain_screw = 0.0;  ///< Radius before the first contact.
  double screw = 0.0;        ///< Radius from the first contact on.
  NutBore nut;               ///< Bore along a nut line.
};
BodyRadii body_radii(const Mechanism& mechanism, const Structure& structure, const Materials& materials,
                     const ModelOptions& options, const PerInterface<ContactLaw>& laws, const NutLine& line);

/// Forces on a running roller, in the plane of its axis and the screw's, besides the normal loads of its contacts. x
/// along the axis, y outwards, as in the sector.
struct RollerPush {
  /// T_x and T_y, friction of each thread on the roller; an equal and opposite force acts on screw or nut [N].
  PerInterface<std::vector<double>> axial, radial;
  bool per_normal_load = false;  ///< Whether these are T over N [-].
  bool is_trial = false;         ///< Whether it may have no equilibrium, so that the solver gives up early.
  /// m' c Omega^2 of the orbit, outwards, per length of thread and of heads [N/m].
  double of_thread = 0.0, of_heads = 0.0;
};

/// Volume and polar moment of volume of a body about its axis. The parts are bodies of revolution bounded by the pitch
/// diameters, where a thread is as wide as its groove: crests add what roots lack, except for the difference of their
/// radii.
struct RoundBody {
  double volume = 0.0;        ///< [m^3]
  double polar_moment = 0.0;  ///< Integral of r^2 dV [m^5]; times the density, the inertia.
};

/// Cylinder or tube of a length: pi/4 (D^2 - d^2) L and pi/32 (D^4 - d^4) L.
RoundBody tube(double outer_diameter, double inner_diameter, double length);

/// Nut with its flanges, bored to the pitch diameter over its whole length.
RoundBody nut_body(const Mechanism& mechanism, const Structure::Nut& nut);

/// One roller as in the sector model: its pitch diameter over the threads with half a pitch of
/// run-out at both ends, N p together, and both end pieces.
RoundBody roller_body(const Mechanism& mechanism, const Structure::Roller& roller);

/// Screw of a length, from its bore to the pitch diameter.
RoundBody screw_body(const Mechanism& mechanism, const Structure::Screw& screw, double length);

/// Volume of the cylinder around the nut [m^3]: its largest diameter over its length.
double envelope_volume(const Structure::Nut& nut);

/// pi d^2/4 [m^2]
inline double disc_area(double diameter) { return std::numbers::pi / 4.0 * diameter * diameter; }

/// Area between two diameters [m^2].
inline double ring_area(double outer, double inner) { return disc_area(outer) - disc_area(inner); }

/// A ring-shaped section with m the inner over the outer diameter (Cowper 1966):
///
///     I = pi (d_o^4 - d_i^4)/64,   q = (1 + m^2)^2,
///     kappa = 6 (1 + nu) q/((7 + 6 nu) q + (20 + 12 nu) m^2)
inline RollerSection<double> ring_rigidity(const Material& material, double outer, double inner, bool shear) {
  const double modulus = material.youngs_modulus, nu = material.poisson_ratio;
  const double area = ring_area(outer, inner);
  RollerSection<double> r{modulus * area,
                          modulus * (std::numbers::pi / 64.0 * (std::pow(outer, 4) - std::pow(inner, 4))), 0.0};
  if (!shear) return r;
  const double m2 = std::pow(inner / outer, 2), q = (1.0 + m2) * (1.0 + m2);
  const double kappa = 6.0 * (1.0 + nu) * q / ((7.0 + 6.0 * nu) * q + (20.0 + 12.0 * nu) * m2);
  r.shear = kappa * (modulus / (2.0 * (1.0 + nu))) * area;
  return r;
}

/// A solid round section.
inline RollerSection<double> disc_rigidity(const Material& material, double diameter, bool shear) {
  return ring_rigidity(material, diameter, 0.0, shear);
}

}  // namespace prs
