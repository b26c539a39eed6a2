#pragma once

#include "prs/loads/result.h"
#include "prs/sector/roller_guides.h"
#include "prs/slip/slip_equilibrium.h"

namespace prs {

/// The case's lubricant at its operating temperature everywhere; none if the case has none, or states no temperature.
Oils oils_in_operation(const Conditions& c);

/// A lubricant at given temperatures [K], those of the contacts of each interface; the bearings of the roller heads are
/// at the mean of both.
Oils oils_at(const Lubricant& lubricant, const PerInterface<double>& temperature);

/// The lubricant of a load case: at the temperatures of its heat balance, else as in the file.
Oils oils_of(const Conditions& c, const LoadCaseResult& loaded);

/// Composite Rq of the flanks of an interface [m]; absent if the case has none.
std::optional<double> composite_roughness(const Conditions& c, Interface i);

/// Grid with a number of points along each axis. Each thread keeps that of its last design, as all designs of a study
/// usually share it.
std::shared_ptr<const contact::PatchGrid> grid_of(int points);

// Parts of a model, set in memory that it keeps.

/// Sets the conditions of a load case, without contacts, in memory that the model keeps. The mechanism is the resolved
/// one.
void set_conditions(SlipModel& model, const Conditions& c, const Mechanism& mechanism, const LoadCase& load_case,
                    const Oils& oils);
/// Sets points and directions of the faces that touch; call `set_conditions` first.
void set_geometry(SlipModel& model, const Contacts& contacts);
/// Sets one contact that represents all threads of an interface, without its patch.
void set_equal_contacts(SlipModel& model, const Contacts& contacts);

/// Builds the models of slip of one case from its contacts and loads. The models refer to the grid
/// in here and to the contacts.
class SlipModels {
 public:
  /// The case must have passed the requirements of `slip`, the contacts must be its own. `oils`: replace those in
  /// operation.
  SlipModels(const Conditions& c, const Contacts& contacts, std::optional<Oils> oils = {});
  SlipModels(const SlipModels&) = delete;
  SlipModels& operator=(const SlipModels&) = delete;

  /// One patch for each thread that carries load, of all rollers of a full mechanism; for equal
  /// shares one for all.
  SlipModel of(const LoadCaseResult& loaded) const;
  /// Models of each nut of a double nut separately: first nut, second nut. They carry compression and tension, the
  /// second one with patches of its own.
  std::vector<SlipModel> of_nuts(const LoadCaseResult& loaded) const;
  /// Model of the nut that carries the direction of the load case, or of the only one.
  SlipModel of_nut_that_carries(const LoadCaseResult& loaded) const;
  /// Model with one patch that represents all threads of an interface (Sandu 2018); `oils`: replace those of all
  /// models.
  SlipModel equal_shares(const LoadCase& load_case, const Oils* oils = nullptr) const;
  /// Model without threads.
  SlipModel unloaded(const LoadCase& load_case, const Oils* oils = nullptr) const;

  const Oils& oils() const { return oils_; }
  const contact::PatchGrid& grid() const { return *grid_; }

 private:
  void add_patches(SlipModel& model) const;
  GuideForces guides_of(const LoadCaseResult& loaded) const;

  Conditions conditions_;
  const Contacts& contacts_;
  std::shared_ptr<const contact::PatchGrid> grid_;
  Oils oils_;
  /// Guides of the roller of a sector at rest, made at first use: not from two threads at once.
  mutable PerDirection<std::optional<RollerGuides>> roller_guides_;
};

/// Geometry of the faces that a force closes, > 0 in tension [N].
KinematicGeometry kinematic_geometry(const Contacts& contacts, double force);

}  // namespace prs
