#pragma once

#include "prs/loads/result.h"
#include "prs/sector/roller_guides.h"
#include "prs/slip/slip_equilibrium.h"

namespace prs {

/// The case's lubricant at its operating temperature everywhere; none where the case has none, or
/// states no temperature.
Oils oils_in_operation(const Conditions& c);

/// A lubricant that follows its temperature [K], that of the contacts of each interface; the
/// bearings of the roller heads run at the mean of both.
Oils oils_at(const Lubricant& lubricant, const PerInterface<double>& temperature);

/// The lubricant of a load case: at the temperatures of its heat balance, else as in the file.
Oils oils_of(const Conditions& c, const LoadCaseResult& loaded);

/// Composite Rq of the flanks of an interface [m]; absent where the case has none.
std::optional<double> composite_roughness(const Conditions& c, Interface i);

/// The grid of a number of points along each axis. That of a thread's last design is kept: all
/// designs of a study have it, as a rule.
std::shared_ptr<const contact::PatchGrid> grid_of(int points);

// The parts of a model. Into memory that it keeps, as far as it has any.

/// What the case says of a load case, without contacts. The mechanism is the resolved one.
void set_conditions(SlipModel& model, const Conditions& c, const Mechanism& mechanism, const LoadCase& load_case,
                    const Oils& oils);
/// Points and directions of the faces that touch; `set_conditions` comes first.
void set_geometry(SlipModel& model, const Contacts& contacts);
/// One contact that stands for all threads of an interface, without its patch.
void set_equal_contacts(SlipModel& model, const Contacts& contacts);

/// Builds the models of slip of one case from its contacts and loads. The models refer to the grid
/// in here and to the contacts.
class SlipModels {
 public:
  /// The case must have passed the requirements of `slip`, the contacts must be its own.
  /// `oils`: in place of those in operation.
  SlipModels(const Conditions& c, const Contacts& contacts, std::optional<Oils> oils = {});
  SlipModels(const SlipModels&) = delete;
  SlipModels& operator=(const SlipModels&) = delete;

  /// One patch for each thread that carries load, of all rollers of a full mechanism; for equal
  /// shares one for all.
  SlipModel of(const LoadCaseResult& loaded) const;
  /// The same, of each nut of a double nut by itself: first nut, second nut. They carry
  /// compression and tension, the second one with patches of its own.
  std::vector<SlipModel> of_nuts(const LoadCaseResult& loaded) const;
  /// One patch that stands for all threads of an interface (Sandu 2018); `oils`: in place of those
  /// that all models have.
  SlipModel equal_shares(const LoadCase& load_case, const Oils* oils = nullptr) const;
  /// Without threads.
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
  /// Guides of the roller of a sector at rest, made when first asked for: not for two threads at once.
  mutable PerDirection<std::optional<RollerGuides>> roller_guides_;
};

/// Geometry of the faces that a force closes, > 0 in tension [N].
KinematicGeometry kinematic_geometry(const Contacts& contacts, double force);

}  // namespace prs
