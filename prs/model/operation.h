#pragma once

#include <array>

#include "contact/friction_laws.h"
#include "contact/journal_bearing.h"
#include "prs/model/part.h"
#include "prs/model/warning.h"

namespace prs {

/// A lubricant that the program knows, with the values of its standard or data sheet.
struct NamedLubricant {
  std::string_view name;  ///< Name in a case file: `iso-vg-100`.
  std::string_view what;
  contact::BaseOil base;
  double viscosity_40;   ///< Kinematic viscosity of the oil, or the base oil of the grease, at 40 degC [m^2/s].
  double viscosity_100;  ///< Kinematic viscosity at 100 degC [m^2/s].
  double density;        ///< Density at 15 degC [kg/m^3].
  std::string_view source;
};

/// All named lubricants, in the order in which they are shown.
std::span<const NamedLubricant> named_lubricants();

/// Index in `named_lubricants`.
enum class LubricantName : std::size_t {};

const NamedLubricant& data_of(LubricantName name);

/// Viscosity at one temperature, dynamic or kinematic.
struct ViscosityPoint {
  double temperature = 0.0;                   ///< [K]
  std::optional<double> viscosity;            ///< [Pa s]
  std::optional<double> kinematic_viscosity;  ///< [m^2/s]
};

/// Lubricant as a data sheet states it. Its viscosity is that at operating temperature, or follows from the temperature
/// by a Walther line: given, or through two points. A named lubricant supplies all values that are left out.
struct Lubricant {
  std::optional<LubricantName> name;
  std::optional<double> viscosity;           ///< eta_0 at operating temperature [Pa s]
  std::optional<double> pressure_viscosity;  ///< alpha [1/Pa]
  std::optional<double> eyring_stress;       ///< tau_0 [Pa]
  std::optional<double> temperature;         ///< Temperature in operation [K].
  std::vector<ViscosityPoint> viscosity_at;
  std::optional<contact::WaltherLine> walther;
  std::optional<double> density;  ///< Density, from kinematic to dynamic viscosity [kg/m^3].

  struct Film {
    contact::FilmDirection direction = contact::FilmDirection::minor_axis;
    std::optional<double> starvation;  ///< phi_s, ratio of film thickness to that with a full inlet.
    /// Reduction of the film by shear heating at the inlet.
    struct InletHeating {
      double conductivity = 0.0;  ///< k of the oil [W/(m K)]
      /// beta = -(d eta/dT)/eta [1/K]; default: from the oil's own law.
      std::optional<double> temperature_coefficient;
    };
    std::optional<InletHeating> inlet_heating;
  };
  Film film;
};

/// Eyring stress where only the name of a lubricant is given [Pa]: of the 2 to 10 MPa that traction
/// of mineral, polyalphaolefin and ester oils shows (Evans and Johnson, Proc. Instn Mech. Engrs C
/// 200, 1986, 303).
inline constexpr double kTypicalEyringStress = 5e6;

/// The lubricant at a temperature [K], also one other than in operation. It must have passed `check_lubricant`. A named
/// one without `pressure_viscosity` gets the estimate from its viscosity there, see `contact::gold_pressure_viscosity`.
contact::Lubricant at_temperature(const Lubricant& lubricant, double temperature);

/// Whether the file states the temperature or the viscosity in operation, which it may omit with `heat`.
bool has_operating_point(const Lubricant& lubricant);

/// The lubricant at its operating temperature, or with the viscosity stated for operation. The case must have passed
/// `check_case`.
contact::Lubricant in_operation(const Lubricant& lubricant);

/// The lubricant with viscosities and density of its name where the file does not state them.
Lubricant with_data_of_name(Lubricant lubricant);

/// The lubricant with all values of its name, and with estimates at operating temperature.
Lubricant resolved(const Lubricant& lubricant);

/// Source of a value, such as `density`, of a named lubricant; empty if the name does not give that value.
std::string origin_of(std::string_view key, LubricantName name);

/// Warning about values of a lubricant that are estimates, and how to replace them; none if all are stated.
std::optional<Warning> estimated_lubricant(const Lubricant& lubricant);

/// Law of friction of the threads; its parameters may differ between screw and nut, as their flanks and oil do (Sandu
/// 2018, section 2.3.2).
struct Friction : contact::LawParametersOf<PerInterface<double>> {
  contact::FrictionKind kind = {};

  contact::LawFacts facts() const { return contact::facts_of(kind); }
  bool is(contact::Lubrication lubrication) const { return facts().lubrication == lubrication; }
  /// The law at an interface, without film.
  contact::FrictionLaw at(Interface i) const;
};

template <template <class> class Law>
Friction friction_by(const Law<PerInterface<double>>& parameters) {
  Friction friction;
  static_cast<Law<PerInterface<double>>&>(friction) = parameters;
  friction.kind = contact::kind_of<Law>;
  return friction;
}

/// Wear of flanks by Archard (J. Appl. Phys. 24, 1953, 981): volume = k times the integral of pressure times sliding
/// distance, sum of both bodies.
struct Wear {
  double coefficient = 0.0;  ///< k [m^3/(N m)]
};

struct Operation {
  double speed = 0.0;                     ///< Speed of screw against nut [rad/s].
  std::optional<double> slip_ratio = {};  ///< Imposed slip ratio; if absent from the roller's equilibrium.
  /// Largest speed of the motion [rad/s]; speeds of load cases are means.
  std::optional<double> largest_speed = {};
};

/// Friction of the roller heads in their bearings in the carrier.
struct HeadFriction {
  /// hydrodynamic: short bearings; coulomb: M = mu F d/2; mixed: both by the share of touching
  /// surfaces, `contact::boundary_share`.
  enum class Model { hydrodynamic, coulomb, mixed };
  struct Mixed {
    double boundary = 0.0;   ///< mu without film.
    double roughness = 0.0;  ///< Composite Rq of pin and bore [m].
    double exponent = 2.0;
  };
  Model model = Model::hydrodynamic;
  double coefficient = 0.0;  ///< mu, coulomb only.
  Mixed mixed = {};
};

/// Plain bearing of a roller's head in the carrier; one with dry friction has a diameter alone.
struct HeadBearing : contact::JournalBearing {
  HeadFriction friction = {};

  bool has_film() const { return friction.model != HeadFriction::Model::coulomb; }
};

/// Carrier: what acts on the rollers besides the threads. Torques are resisting magnitudes [N m].
struct Carrier {
  double roller_torque = 0.0;  ///< C_P/R, both heads of one roller.
  double screw_torque = 0.0;   ///< C_P/S
  double nut_torque = 0.0;     ///< C_P/N
  /// Bearings of the two heads of a roller in the carrier; replaces `roller_torque`.
  std::optional<HeadBearing> bearing;
  double gear_pressure_angle = std::numbers::pi / 9;  ///< alpha_g [rad]

  bool is_oiled() const { return bearing && bearing->has_film(); }
};

/// Heat transfer of bare parts in still air, free convection and radiation together [W/(m^2 K)]: 5
/// to 15 for parts of some cm that are 20 to 80 K warmer than the room (Incropera, DeWitt,
/// Fundamentals of Heat and Mass Transfer, chapters 1 and 9).
inline constexpr double kStillAir = 10.0;

/// Conductance of a bare nut to still air [W/K], by `kStillAir` over its cylinder and both end faces around the bore
/// [m].
inline double nut_in_still_air(double outer_diameter, double bore, double length) {
  const double faces = 0.5 * std::numbers::pi * (outer_diameter * outer_diameter - bore * bore);
  return kStillAir * (std::numbers::pi * outer_diameter * length + faces);
}

/// Heat flow between the parts and to the surroundings, and the duty cycle that warms the parts. SI units.
struct Heat {
  /// Conductances between two parts, or from a part to its surroundings [W/K].
  struct Conductance {
    double screw_ambient = 0.0;
    double nut_ambient = 0.0;
    double rollers_ambient = 0.0;
    double screw_rollers = 0.0;
    double rollers_nut = 0.0;

    double to_ambient() const { return screw_ambient + nut_ambient + rollers_ambient; }
  };
  /// One step of the duty cycle: a load case for a time, or a rest without motion.
  struct DutyStep {
    std::optional<std::string> load_case;  ///< Name of the load case; none: a rest.
    std::optional<double> duration;        ///< Duration of the load case [s].
    std::optional<double> rest;            ///< Duration of a rest [s].

    double time() const { return load_case ? *duration : *rest; }
  };
  /// Heat capacities [J/K]; `rollers`: all of them together.
  struct Capacity {
    double screw = 0.0;
    double rollers = 0.0;
    double nut = 0.0;
  };

  enum class Losses {
    warm,    ///< Losses at the temperatures that they cause.
    stated,  ///< Losses at the temperatures that the case states, or at the mean ones of `duty`, without iteration.
  };

  double ambient = 0.0;  ///< [K]
  Conductance conductance;
  Losses losses = Losses::warm;
  std::vector<DutyStep> duty = {};            ///< Steps, repeated without end or `cycles` times; none: no cycle.
  std::optional<int> cycles = {};             ///< Number of cycles of a mission from `start`; none: the periodic state.
  std::optional<PerPart<double>> start = {};  ///< Temperatures at the start of a mission [K]; default `ambient`.
  std::optional<Capacity> capacity = {};
  std::optional<double> specific_heat = {};  ///< One value for all parts, replaces `capacity` [J/(kg K)].

  bool has_mission() const { return cycles && !duty.empty(); }
  PerPart<double> start_temperature() const { return start.value_or(PerPart<double>{ambient, ambient, ambient}); }
  /// Duration of one cycle [s].
  double period() const {
    double time = 0.0;
    for (const DutyStep& step : duty) time += step.time();
    return time;
  }
};

/// Whether loads, losses and life are computed at the temperatures of `heat`.
inline bool warms(const std::optional<Heat>& heat) { return heat && heat->losses == Heat::Losses::warm; }

/// Viscosities of a named lubricant at 40 and 100 degC.
std::array<ViscosityPoint, 2> viscosities_of(LubricantName name);

}  // namespace prs
