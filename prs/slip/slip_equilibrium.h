#pragma once

#include "contact/patch.h"
#include "prs/model/operation.h"
#include "prs/slip/slip_formulas.h"

namespace prs {

/// The loaded threads of one interface, of one roller or of all. They share contact point and
/// directions, as all rollers have one speed of orbit and spin; each patch has a load of its own.
struct LoadedThreads {
  /// A patch under its static load, or that of the running screw.
  struct Contact {
    double axial_load = 0.0;                 ///< F_i, > 0; not used with a normal load [N]
    std::optional<double> normal_load = {};  ///< N_i, if known from the running screw [N].
    bool other_flank = false;                ///< See `SlipModel::other_flank`.
    contact::HertzContact ellipse;
    contact::FrictionLaw friction;  ///< Friction with the film of the contact, in every law.
  };
  std::vector<Contact> contacts;
  std::vector<contact::Patch> patches;  ///< Patches of these contacts.
  double alike = 1.0;                   ///< Number of threads of the mean roller that each patch represents.
  int threads_per_roller = 0;  ///< Threads per roller, in patches of all rollers, one after the other; 0: of one.
  /// Patch of each thread; absent if the thread is open.
  std::vector<std::optional<std::size_t>> patch_of_thread;
};

/// The lubricant in operation, at the temperature of each place; absent where there is none.
struct Oils {
  PerInterface<std::optional<contact::Lubricant>> threads;
  std::optional<contact::Lubricant> carrier;  ///< Oil in the bearings of the roller heads.
};

/// R_near and R_far of each present roller whose beam is known, the forces of its guides, > 0 outwards [N].
struct GuideForces {
  std::vector<std::array<double, 2>> of_roller;  ///< Forces of each roller; none: half of the total that balances them.
  std::vector<int> missing;                      ///< Numbers of missing rollers, from 1.
  bool carry_centrifugal = false;                ///< Whether they include the centrifugal force of the roller.
};

/// One roller between screw, nut, gears and carrier, loaded and turning (Sandu 2018, section 3.2, with a load of its
/// own for each thread). For a full mechanism the mean of all present rollers: the carrier gives all one speed of orbit
/// and the gears one spin, so that the balance is that of the sums over all. SI units.
struct SlipModel : RollerModelOf<double> {
  double axial_force = 0.0;  ///< F_N with sign, of the whole mechanism [N].
  PerInterface<LoadedThreads> threads;
  /// Points and directions of the flanks that do not face the load, if preload closes both flanks of the threads.
  struct OtherFlank {
    KinematicGeometry geometry;
    PerInterface<ContactFrameOf<double>> frames;
  };
  std::optional<OtherFlank> other_flank;
  /// Axial load that both flanks carry at the screw with preload, which replaces `axial_force` as a scale [N].
  std::optional<double> carried;
  Oils oils;

  GuideForces guides;

  double pitch_excess = 0.0;  ///< |r_R/Gamma - r| of the geared part, by which its pitch cylinder slides [m].

  // Friction for results.
  Friction friction;
  contact::FilmDirection film_direction = contact::FilmDirection::minor_axis;
  contact::FilmThinning film_thinning;
  /// Roller and the other body; present if their heat properties are known.
  PerInterface<std::optional<std::array<contact::HeatedBody, 2>>> heated;
  std::optional<Wear> wear;
  PerInterface<std::optional<double>> roughness;  ///< Composite Rq [m].
  std::optional<double> imposed_slip_ratio;

  const ContactFrameOf<double>& frame(Interface i, const LoadedThreads::Contact& c) const {
    return c.other_flank ? other_flank->frames[i] : frames[i];
  }
};

/// Friction at the patches of one interface of one roller.
struct PatchBalance {
  std::vector<contact::PatchFriction> friction;  ///< Friction over the normal load.
  std::vector<double> normal_load;               ///< N, dynamic (3.11), (3.12) [N]
  double power = 0.0;                            ///< Total lost power [W] (3.51).
};

/// Spin of a roller without teeth at a slip ratio, see `kinematics`; 0 with teeth.
struct RollerSpin {
  double slip_ratio = 0.0;
  double spin = 0.0;
  double slope = 0.0;  ///< Estimate of its slope along the slip ratio.

  /// The spin to expect at another slip ratio.
  RollerSpin at(double other) const { return {other, spin + slope * (other - slip_ratio), slope}; }
};

/// Forces on one roller, and the results of its patches.
struct SlipBalance : RollerBalance {
  RollerSpin spin;  ///< Spin of the roller, from which the next balance starts.
  PerInterface<PatchBalance> patches;
  PerInterface<contact::PatchMotion> other_sliding;  ///< Motion on `SlipModel::other_flank`.

  const contact::PatchMotion& motion_of(Interface i, const LoadedThreads::Contact& c) const {
    return c.other_flank ? other_sliding[i] : sliding[i];
  }
};

/// Balances all except the moment about the roller's axis, whose residue remains in `moments` (Sandu 2018,
/// section 3.2): axial forces give the normal loads (3.11), (3.12), the carrier's moment the force that drives it
/// (3.26), forces along the orbit the gears (3.28), radial ones the carrier's reaction (3.32). The arms of the gears
/// are their operating pitch radii, c Gamma/(1 -+ Gamma) of the roller, so that forces and ratio are consistent for any
/// backlash. A roller without teeth spins as its own moments balance; its residue is the moment that teeth would have
/// to give for the forces along the orbit to balance. `balance` is overwritten in place; the search of the spin starts
/// from the one that it has. Returns false if friction
/// exceeds a contact's capacity, so that no normal load exists, or if numbers overflow.
bool balance_at(const SlipModel& model, double slip_ratio, SlipBalance& balance);

/// c |F_N|/N_R [N m], under preload with the load of both flanks: the unit of `relative_residue`. For an open nut c/N_R
/// times 1 N.
double residue_unit(const SlipModel& model);

/// R_z, remaining moment on a roller over c |F_N|/N_R [-] (Sandu 2018, (3.39) to (3.43)).
double relative_residue(const SlipModel& model, const SlipBalance& balance);

/// Slip ratio at which the roller is in balance (Sandu 2018, (3.38)): between pure sliding and the ideal one, or beyond
/// the ideal one if the carrier is driven.
struct SlipEquilibrium {
  SlipStatus status = SlipStatus::not_computed;
  int evaluations = 0;  ///< Number of evaluations of the balance, with slopes or without.
  SlipBalance balance;  ///< Balance at the root.
  double slope = 0.0;   ///< Slope of the relative residue along the slip ratio, near the root.

  bool ok() const { return status == SlipStatus::converged || status == SlipStatus::imposed; }
};

/// Equilibrium by `SlipSearch`, to 1e-14 or better. Without friction every slip ratio balances and the ideal one is
/// returned. An imposed one is used unchanged. `near`: a slip ratio and its spin that may be close.
SlipEquilibrium find_slip_equilibrium(const SlipModel& model, const std::optional<RollerSpin>& near = {});

/// Continues from an equilibrium under slightly changed loads: the balance at its slip ratio, and the next one by the
/// slope. None if that is not a small step.
std::optional<double> next_slip_ratio(const SlipModel& model, SlipEquilibrium& slip);

/// Sets near and far end: for a full mechanism of each roller, missing ones without forces.
void set_heads(std::vector<std::array<RollerHead, 2>>& heads, const SlipModel& model, const SlipBalance& balance);

/// Torques on screw and nut that keep them turning (Sandu 2018, (3.30), (3.31)) [N m].
struct DriveTorques {
  double screw = 0.0;
  double nut = 0.0;
};
DriveTorques drive_torques(const SlipModel& model, const SlipBalance& balance);

/// Power lost to each source in the whole mechanism [W], positive (Sandu 2018, (3.47) to (3.51),
/// whose dissipation is negative).
PowerBySource lost_power(const SlipModel& model, const SlipBalance& balance);

/// Power through the shaft and through the load, both into the mechanism [W]: their sum is lost.
struct PowerFlow {
  double shaft = 0.0;  ///< C_S omega_s/n, inverted C_N omega_n/s
  double load = 0.0;   ///< F_N dz_n/s/dt

  double lost() const { return shaft + load; }
  /// Output over input (Sandu 2018, (3.52)); absent if both flow in, as in a self-locking screw.
  std::optional<double> efficiency() const;
};
PowerFlow power_flow(const SlipModel& model, const SlipBalance& balance);

DrivenBy driven_by(double axial_force, double speed, double lead);

}  // namespace prs
