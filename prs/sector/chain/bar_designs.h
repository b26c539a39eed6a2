#pragma once

#include <memory>
#include <span>
#include <vector>

#include "fe/newton_types.h"
#include "prs/sector/chain/bar_columns.h"
#include "prs/sector/chain/instruction_set.h"
#include "prs/sector/chain/thread_loads.h"
#include "prs/model/deviations.h"
#include "prs/model/load_case.h"
#include "prs/sector/load_distribution.h"
#include "prs/model/materials.h"
#include "prs/model/mechanism.h"
#include "prs/model/model_options.h"
#include "prs/model/part.h"
#include "prs/sector/sector.h"
#include "prs/model/structure.h"

namespace prs {

/// The numbers that one sector of bars consists of (Abevi 2015, section 3), what changes from
/// design to design. Rigidities of screw and nut are those of the mechanism divided by the rollers.
/// SI units.
struct BarSector {
  /// Rigidities of a roller's section.
  struct Section {
    double axial = 0.0;    ///< E A [N]
    double bending = 0.0;  ///< E I [N m^2]
    double shear = 0.0;    ///< kappa G A [N]; 0 leaves shear out.
  };
  struct Flange {
    double from = 0.0;            ///< As in `Structure` [m].
    double to = 0.0;              ///< [m]
    double axial_rigidity = 0.0;  ///< E A of the nut there [N]
  };

  int contacts = 0;
  int rollers = 1;
  Direction direction = Direction::tension;
  double pitch = 0.0;  ///< Between neighbouring contacts [m].

  double screw_rigidity = 0.0;  ///< E A [N]
  double free_length = 0.0;     ///< [m]

  Section thread;            ///< Of the roller between its ends.
  Section end;               ///< Of its end elements.
  double end_length = 0.0;   ///< [m]
  double outer_guide = 0.0;  ///< Radial stiffness at the outermost nodes; infinite: held [N/m].
  double inner_guide = 0.0;  ///< At the inner nodes of the end elements [N/m].
  bool rigid_bending = false;
  double roller_radius = 0.0;  ///< Rigid arms of the contacts [m].

  double nut_rigidity = 0.0;    ///< E A between the flanges [N]
  double nut_length = 0.0;      ///< [m]
  double thrust = 0.0;          ///< Held section [m].
  double position = 0.0;        ///< Of the first contact [m].
  std::vector<Flange> flanges;  ///< They do not overlap.

  PerInterface<ContactLaw> laws;
  PerInterface<std::vector<double>> gaps;  ///< As in `Sector`; empty: none.
};

/// What `build_sector` puts into a model of bars (`options.bodies` is not looked at), as numbers.
/// The case must have passed `check_case`.
BarSector bar_sector(const Mechanism& mechanism, const Structure& structure,
                     const Materials& materials, const ModelOptions& options,
                     const PerInterface<ContactLaw>& laws, Direction direction, double position,
                     const Deviations& deviations = {});

/// Solves designs side by side: as many sectors as a batch has numbers in lock step, each with its
/// own convergence. Set-up of the sectors is part of it. A design's result does not depend, bit
/// for bit, on the designs beside it. Workspace is kept from call to call; one solver a thread.
class BarDesignSolver {
 public:
  explicit BarDesignSolver(InstructionSet set = InstructionSet::best);
  ~BarDesignSolver();
  BarDesignSolver(BarDesignSolver&&) noexcept;
  BarDesignSolver& operator=(BarDesignSolver&&) noexcept;

  /// Of Newton's method; force_scale, length_scale and reuse_factorization_below are not used. On
  /// slender rollers a residual of 1e-12 can leave 1e-10 in a thread's load.
  fe::NewtonOptions options{.residual_tolerance = 1e-13};

  /// Designs of any mixture of thread counts under the axial force on the whole mechanism [N]. With
  /// m times as many forces as designs, those of design k are m k .. m k + m - 1: each starts from
  /// the extrapolation of those before it, as far as they ascend.
  void solve(std::span<const BarSector> sectors, std::span<const double> axial_forces,
             std::span<LoadDistribution> results);

  /// The same into arrays, `results.stride` >= the largest number of contacts.
  void solve(std::span<const BarSector> sectors, std::span<const double> axial_forces,
             const ThreadLoads& results);

  /// Arrays in, arrays out, several loads a design: no allocation, no copy.
  void solve(const BarDesigns& designs, const ThreadLoads& results);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace prs
