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

/// One sector of it: a direction of the load, and a position of the first contact on the nut.
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

/// A sector of a screw that turns: a state, which goes on under the axial force of the last solve at rest and friction.
class RunningSector {
 public:
  virtual ~RunningSector() = default;

  virtual LoadDistribution at_rest(double axial_force) = 0;
  /// Goes on under friction that does not follow the loads.
  virtual fe::NewtonStatus go_on(const RollerPush& push) = 0;
  /// Goes on under friction in these proportions to the normal loads. False, and the state is as it was, where it
  /// finds none.
  virtual bool follow(const RollerPush& per_normal_load) = 0;

  /// At the state.
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
  /// Positions of a travel; `turn`: of the carrier since the start.
  virtual TravelModel travel(std::function<FullModel(double theta)> at, std::function<double(double theta)> turn) = 0;
  /// Without deviations, under the axial force alone.
  virtual SymmetricLoads symmetric(const FullModel& model) = 0;
  /// Whether the nut can lift off its shoulder.
  virtual bool shoulder_lifts() const { return false; }
};

using MakeModel = std::function<FullModel()>;

/// Solvers of a model of the bodies; null where `BodyModel` says that it knows no such loads.
struct BodySolver {
  DistributionSolver (*at_rest)(const LoadedSector&, Solver);
  std::unique_ptr<RunningSector> (*running)(const LoadedSector&) = nullptr;
  /// `model`: makes the one from whose direction, position and stations bodies are worked out; `solver`: of
  /// one-dimensional bodies, kept from model to model.
  std::unique_ptr<RollersOnBodies> (*all_rollers)(const LoadedMechanism&, const MakeModel& model,
                                                  FullSolver& solver) = nullptr;
  /// Whether solves take no time to speak of, be it that what takes long is kept; null: always.
  bool (*is_at_hand)(const LoadedSector&) = nullptr;
};

/// The solver of the bodies that the conditions ask for.
const BodySolver& body_solver(const Conditions& c);

}  // namespace prs
