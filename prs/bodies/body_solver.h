#pragma once

#include "prs/mechanism/travel.h"
#include "prs/sector/sector.h"
#include "prs/threads/contacts.h"

namespace prs {

/// A mechanism on which loads are solved. What it refers to must outlive what is made from it.
struct LoadedMechanism {
  const Conditions& conditions;
  const Contacts& contacts;
  const PerInterface<ContactLaw>& laws;
};

/// One sector of a loaded mechanism: a direction of the load, and a position of the first contact on the nut.
struct LoadedSector : LoadedMechanism {
  Direction direction = Direction::tension;
  double position = 0.0;  ///< [m]

  SectorModel model() const {
    return sector_model(contacts.mechanism, *conditions.structure, *conditions.materials, conditions.model, laws,
                        direction, position, conditions.deviations);
  }
};

/// Equilibrium of one sector under the axial force on the whole mechanism [N], > 0.
using DistributionSolver = std::function<LoadDistribution(double axial_force)>;

/// A sector of a screw that turns. Its state begins with the last solve at rest and continues under the same axial
/// force with friction.
class RunningSector {
 public:
  virtual ~RunningSector() = default;

  virtual LoadDistribution at_rest(double axial_force) = 0;
  /// Continues under friction that does not follow the loads.
  virtual fe::NewtonStatus go_on(const RollerPush& push) = 0;
  /// Continues under friction in these proportions to the normal loads. Returns false, with the state unchanged, if it
  /// finds no equilibrium.
  virtual bool follow(const RollerPush& per_normal_load) = 0;

  /// Normal loads at the state.
  virtual PerInterface<std::vector<double>> normal_load() const = 0;
  virtual GuideLoads guides() const = 0;  ///< Guides with a clearance.
  /// All loads at the state, which `push` has led to.
  virtual LoadDistribution loads(const RollerPush& push) = 0;
};

/// All rollers on the bodies of a mechanism, in one direction of the load and at one position.
class RollersOnBodies {
 public:
  virtual ~RollersOnBodies() = default;

  virtual FullDistribution solve(const FullModel& model, Detail detail) = 0;
  /// Model of a travel. `at`: model at an angle of the travel; `turn`: turn of the carrier since its start.
  virtual TravelModel travel(std::function<FullModel(double theta)> at, std::function<double(double theta)> turn) = 0;
  /// Loads without deviations, under the axial force alone.
  virtual SymmetricLoads symmetric(const FullModel& model) = 0;
  /// Whether the nut can lift off its shoulder.
  virtual bool shoulder_lifts() const { return false; }
};

using MakeModel = std::function<FullModel()>;

/// Solvers of a model of the bodies; null where `BodyModel` says that it knows no such loads.
struct BodySolver {
  DistributionSolver (*at_rest)(const LoadedSector&, Solver);
  std::unique_ptr<RunningSector> (*running)(const LoadedSector&) = nullptr;
  /// `model`: makes the model for whose direction, position and stations the bodies are computed. `solver`: that of
  /// one-dimensional bodies, kept from model to model.
  std::unique_ptr<RollersOnBodies> (*all_rollers)(const LoadedMechanism&, const MakeModel& model,
                                                  FullSolver& solver) = nullptr;
  /// Whether a solve takes hardly any time, for example because its matrices are cached; null: always.
  bool (*is_at_hand)(const LoadedSector&) = nullptr;
};

/// The solver of the bodies that the conditions ask for.
const BodySolver& body_solver(const Conditions& c);

}  // namespace prs
