#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "prs/heat/thermal_network.h"
#include "prs/loads/analyze.h"
#include "prs/slip/slip_model.h"

namespace prs {

/// What friction makes of power at given temperatures [W].
struct Losses {
  OfParts heat = OfParts::Zero();  ///< Into each part.
  double input = 0.0;              ///< That shaft and load bring in, each while it drives.
  double output = 0.0;             ///< That they take out, each while it is driven.
};

/// A case with one load case alone, its parts at these temperatures [K]: with solved shares they
/// expand.
Conditions at_temperatures(const Conditions& c, const LoadCase& load, const OfParts& temperature);

/// The lubricant at these temperatures of the contacts [K]; none where the case has none.
Oils warm_oils(const Conditions& c, const PerInterface<double>& oil);

/// Whether friction may grow with temperature: that of full films falls, Coulomb's stays.
bool heat_may_grow(const Conditions& c);

/// Losses of one load case over the temperatures of the parts. Refers to conditions and contacts.
class CaseLosses {
 public:
  /// With the load case's shares, or with equal ones in their place.
  CaseLosses(const Conditions& c, const Contacts& contacts, const LoadCase& load,
             LoadCase::Share share);

  /// Loads, slip and friction at these temperatures of the parts [K]; none where there is no slip.
  std::optional<Losses> at(const OfParts& temperature);
  /// Why there was none.
  const std::string& failure() const { return failure_; }

  /// A good estimate for a small part of the effort: heat of equal shares at the slip ratio that
  /// `at` found last, for the temperatures of the oils [K].
  std::optional<OfParts> estimate(const PerInterface<double>& oil) const {
    return estimate(models_, oil);
  }
  /// The same on a coarse grid of points in the patches, some per cent off.
  std::optional<OfParts> rough_estimate(const PerInterface<double>& oil) const {
    return estimate(rough_models_, oil);
  }

 private:
  std::optional<Losses> of(const SlipModel& model);
  /// Heat and power of the rollers of a nut; false where they have no slip.
  bool add(const SlipModel& model, const SlipEquilibrium& found, OfParts& heat, PowerFlow& flow);
  std::optional<OfParts> estimate(const SlipModels& models, const PerInterface<double>& oil) const;

  const Conditions& conditions_;
  const Contacts& contacts_;
  LoadCase load_;
  SlipModels models_;
  SlipModels rough_models_;
  double slip_ratio_ = 0.0;
  std::string failure_;
};

}  // namespace prs
