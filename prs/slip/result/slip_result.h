#pragma once

#include <memory>

#include "prs/model/load_case.h"
#include "prs/threads/kinematics.h"

namespace prs {

/// Friction at the threads of one interface of one roller, thread 1 first; for a full mechanism roller after roller. SI
/// units. An open thread has zeros.
struct InterfaceSlip {
  int threads_per_roller = 0;                ///< Threads per roller of a full mechanism; 0: one roller represents all.
  std::vector<double> power;                 ///< W_M, lost power, >= 0 [W] (Sandu 2018, (3.51)).
  std::vector<double> power_density;         ///< Power over the ellipse's area pi a b [W/m^2].
  std::vector<double> friction_coefficient;  ///< mu_a, mean over the points (2.40).
  std::vector<double> spin_torque;           ///< C_M about the roller's outward normal [N m] (3.10)
  std::vector<double> sliding_speed;         ///< Sliding speed at the centre [m/s].
  std::vector<double> max_sliding_speed;     ///< Largest sliding speed of the points [m/s].
  std::vector<double> film_thickness;        ///< Sandu's h_c [m] (2.39); empty without lubricant.
  std::vector<double> central_film;          ///< `contact::central_film` [m]; empty without lubricant.
  std::vector<double> film_factor;           ///< phi, `contact::film_factor`; empty without lubricant.
  std::vector<double> film_ratio;            ///< Lambda, central film over roughness, if given.
  std::vector<double> boundary_share;        ///< Share of the load on touching flanks; with film_ratio.
  std::vector<double> dynamic_normal_load;   ///< N_M [N] (3.11), (3.12)
  std::vector<double> flash_temperature;     ///< `contact::flash_temperature` [K]; empty without data.
  double along_major = 0.0;                  ///< Share of the squared rolling speed along the major axis.
  std::vector<double> wear;                  ///< Wear volume of both bodies over travel [m^3/m]; empty without `wear`.
};

/// Power lost in the whole mechanism by each source of friction, >= 0 [W].
struct PowerBySource {
  double screw = 0.0;           ///< Roller-screw contacts
  double nut = 0.0;             ///< Roller-nut contacts
  double carrier_roller = 0.0;  ///< Roller heads in the carrier
  double carrier_screw = 0.0;
  double carrier_nut = 0.0;

  double total() const { return screw + nut + carrier_roller + carrier_screw + carrier_nut; }
};

/// Moments on one roller about its axis by source [N m]; they add up to zero in equilibrium. The
/// terms of Sandu 2018, (3.39) to (3.42), times c |F_N|/N_R.
template <class Number>
struct RollerMomentsOf {
  Number contacts{};  ///< R_c
  Number spin{};      ///< R_s
  Number carrier{};   ///< R_p
  Number gears{};     ///< R_e

  Number residue() const { return contacts + spin + carrier + gears; }
};
using RollerMoments = RollerMomentsOf<double>;

/// Forces on one roller across its axis, x away from the screw's axis, y along the orbit [N].
template <class Number>
struct RollerForcesOf {
  Number contacts_x{}, contacts_y{};  ///< N_C F_c/R, sum over all threads (3.27).
  Number gears_x{}, gears_y{};        ///< F_E/R (3.28), (3.29)
  Number carrier_x{}, carrier_y{};    ///< F_R/P, from the roller on the carrier (3.26), (3.32).
  Number centrifugal{};               ///< F_cf (3.33), from the orbit against the frame; 0 without density.
};
using RollerForces = RollerForcesOf<double>;

/// A head of a roller in the carrier.
struct RollerHead {
  double guide_force = 0.0;                  ///< R_h, force of the guides on the roller, > 0 outwards [N].
  double bearing_force = 0.0;                ///< F_h, force of the bearing, gear force included [N].
  std::optional<double> torque;              ///< M_h >= 0 [N m]; with `bearing`.
  std::optional<double> eccentricity_ratio;  ///< e/c; with a film.
};

/// Outcome of the search for the slip ratio.
enum class SlipStatus {
  not_computed,
  converged,
  imposed,         ///< The slip ratio was given: the roller need not be in equilibrium.
  no_equilibrium,  ///< The roller's moment has the same sign over the whole range of slip ratios.
  jammed,          ///< Friction exceeds a contact's capacity: no normal load balances it.
  iteration_limit,
  held,  ///< The speed is 0: between the bounds of `holding` the screw does not move.
};

constexpr std::string_view name(SlipStatus status) {
  constexpr std::string_view kNames[] = {"not_computed", "converged",       "imposed", "no_equilibrium",
                                         "jammed",       "iteration_limit", "held"};
  return kNames[static_cast<std::size_t>(status)];
}

/// A thread of an interface.
struct ThreadOf {
  Interface interface = Interface::screw;
  int thread = 0;  ///< Index in the lists of the interface.
};

/// Slip if all threads carried the same load.
struct EqualShareSlip {
  double slip_ratio = 0.0;
  double power_loss = 0.0;  ///< [W]
  std::optional<double> efficiency;
  PerInterface<double> thread_power;  ///< Power lost at every thread [W].
  double max_power_density = 0.0;     ///< [W/m^2]
};

/// A screw held at rest under its load with the help of static friction: bounds of the drive torque before it moves.
struct Holding {
  struct Bound {
    double holding_torque = 0.0;  ///< Torque on the screw, > 0 against the load [N m].
    double torque_screw = 0.0;    ///< C_S with its sign [N m].
    double torque_nut = 0.0;      ///< C_N [N m]
    double slip_ratio = 0.0;      ///< Slip ratio at the start of motion.
    RollerForces forces;          ///< Forces on a roller, including the carrier's.
  };
  Bound against_load;  ///< Torque above which the drive moves the load.
  Bound with_load;     ///< Torque below which the load moves the screw; < 0 for a self-locking screw.
};

struct SecondNut;

/// Stationary slip of one load case: the roller's equilibrium and the friction losses. Torques have
/// the signs of Sandu 2018; powers are losses, > 0. SI units.
struct SlipResult {
  SlipStatus status = SlipStatus::not_computed;
  int evaluations = 0;                     ///< Number of evaluations of the roller's moment balance.
  std::optional<double> relative_residue;  ///< R_z, (3.38) over c |F_N|/N_R; none if jammed.

  double speed = 0.0;             ///< omega_s/n, speed of screw against nut [rad/s].
  double gear_ratio = 0.0;        ///< Gamma (2.1)
  double slip_ratio = 0.0;        ///< epsilon, carrier against nut over screw against nut (2.2).
  double ideal_slip_ratio = 0.0;  ///< epsilon* (2.16), (2.17)
  SlipEstimates estimates;
  double optimality = 0.0;  ///< (2.19), 1 at the ideal slip ratio.
  // Distances per turn of the screw against the nut [m]:
  double travel_per_turn = 0.0;     ///< Travel of the nut on the screw: the lead if both have the same.
  double migration_per_turn = 0.0;  ///< Migration of the rollers along the geared part, > 0 ahead of its travel.
  /// Circumferential sliding of the pitch cylinders of rollers and geared part, if the ratio of their diameters is not
  /// that of the teeth.
  double pitch_sliding_per_turn = 0.0;

  PerInterface<InterfaceSlip> threads;
  PowerBySource power;
  double power_loss_input_output = 0.0;  ///< Input minus output [W] (3.53).
  DrivenBy driven_by = DrivenBy::screw;
  std::optional<double> efficiency;  ///< Output over input, (3.52); absent if self-locking.
  // Members for a driving load only:
  std::optional<bool> self_locking;      ///< Whether there is no output: the shaft has to drive as well.
  std::optional<Holding> holding;        ///< Present only for a screw held at rest.
  std::optional<double> holding_torque;  ///< C_S in the sense of the motion [N m]: < 0 brakes.
  /// (3.55), Sandu's fit near his reference example; absent with Coulomb friction.
  std::optional<double> efficiency_fit;
  double torque_screw = 0.0;  ///< C_S, torque of the drive on the screw [N m] (3.30).
  double torque_nut = 0.0;    ///< C_N, torque on the nut [N m] (3.31).
  RollerMoments moments;
  RollerForces forces;
  /// Heads at the near and far end; for a full mechanism those of each roller, missing ones without forces.
  std::vector<std::array<RollerHead, 2>> heads;
  std::optional<double> bearing_eccentricity;  ///< e/c of the roller heads.
  std::optional<double> viscosity;             ///< eta_0 in operation, mean oil [Pa s].

  ThreadOf hottest;                            ///< Thread with the largest power density.
  std::optional<EqualShareSlip> equal_shares;  ///< Present only for solved cases, without preload.
  /// Rollers of the second nut of a double nut, separately. Powers, torques and efficiency above are those of both
  /// nuts, all else belongs to the first one.
  std::shared_ptr<const SecondNut> second_nut;

  /// Slip of the rollers that carry the load case's direction: of a double nut those of the second nut in tension.
  const SlipResult& of_nut_that_carries(const LoadCase& load) const;

  bool converged() const { return status == SlipStatus::converged || status == SlipStatus::imposed; }
  bool is_held() const { return status == SlipStatus::held; }
  bool has_answer() const { return converged() || is_held(); }
};

/// Slip of the rollers of the second nut, whose own `second_nut` is empty.
struct SecondNut : SlipResult {};

inline const SlipResult& SlipResult::of_nut_that_carries(const LoadCase& load) const {
  return second_nut && load.direction == Direction::tension ? *second_nut : *this;
}

}  // namespace prs
