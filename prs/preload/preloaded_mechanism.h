#pragma once

#include "prs/model/case.h"
#include "prs/preload/preload_solver.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Sectors by the sense of the load, without play and without preload.
using PreloadSectors = PerDirection<PreloadSector>;

/// Where the first nut is held under each sense of the load [m]. Rigid shoulders of the housing:
/// each sense rests on its own; the only one holds both.
PerDirection<double> held_sections(const Structure::Thrust& thrust);

/// Both senses of a case with a block `preload`, its first contact at a position on the nut [m].
PreloadSectors preload_sectors(const Conditions& c, const Contacts& contacts,
                               const PerInterface<ContactLaw>& laws, double position,
                               Play play = Play::of_cold_parts);

/// The fit that the case asks for, with its first contact where `preload.position` has it, made at
/// the reference temperature. The rollers float at the temperatures of the sectors. Throws
/// CaseError where no fit within the threads gives the preload force.
Fit preload_fit(const Conditions& c, const Contacts& contacts, const PreloadSectors& sectors);

/// The case with the interference that its preload force asks for in place of the force, so that it
/// is found once for many temperatures. Throws CaseError as `preload_fit`.
Conditions with_interference(Conditions c, const Contacts& contacts);

/// Axial load of each side without external load where the fit was made, at the reference
/// temperature [N].
double reference_preload(const Conditions& c, const Contacts& contacts);

/// Equilibria of a fit under either sense of the load: one solver each, which differ in the section
/// that holds the nut.
class PreloadedMechanism {
 public:
  PreloadedMechanism(const PreloadSectors& sectors, const Fit& fit)
      : tension_(fitted(sectors.tension, fit)), compression_(fitted(sectors.compression, fit)) {}

  PreloadSolver& operator[](Direction d) {
    return d == Direction::tension ? tension_ : compression_;
  }
  /// Under an external load [N], > 0 in tension.
  PreloadPoint solve(double axial_force) {
    return (*this)[axial_force < 0.0 ? Direction::compression : Direction::tension].solve(
        axial_force);
  }

 private:
  PreloadSolver tension_, compression_;
};

}  // namespace prs
