#pragma once

#include "prs/heat/thermal_network.h"
#include "prs/slip/slip.h"

namespace prs {

/// Heat and power by friction at given temperatures [W].
struct Losses {
  OfParts heat = OfParts::Zero();  ///< Into each part.
  double input = 0.0;              ///< Power that shaft and load bring in, each while it drives.
  double output = 0.0;             ///< Power that they take out, each while it is driven.
};

/// A case with one load case alone, its parts at these temperatures [K]: with solved shares they
/// expand.
Conditions at_temperatures(const Conditions& c, const LoadCase& load, const OfParts& temperature);

/// The lubricant at these temperatures of the contacts [K]; none where the case has none.
Oils warm_oils(const Conditions& c, const PerInterface<double>& oil);

/// Losses of one load case over the temperatures of the parts. Refers to conditions and contacts.
class CaseLosses {
 public:
  /// Losses with the load case's shares, or with equal ones in their place.
  CaseLosses(const Conditions& c, const Contacts& contacts, const LoadCase& load, LoadCase::Share share);

  /// Loads, slip and friction at these temperatures of the parts [K]; none where there is no slip.
  std::optional<Losses> at(const OfParts& temperature);
  /// Reason why the last call of `at` had no losses.
  const std::string& failure() const { return failure_; }

  /// A good estimate for a small part of the effort: heat of equal shares at the slip ratio that
  /// `at` found last, for the temperatures of the oils [K]. `rough`: on a coarse grid of points in the patches, some
  /// per cent off, for still less.
  std::optional<OfParts> estimate(const PerInterface<double>& oil, bool rough = false) const;

 private:
  const Conditions& conditions_;
  const Contacts& contacts_;
  LoadCase load_;
  SlipModels models_;
  SlipModels rough_models_;
  double slip_ratio_ = 0.0;
  std::string failure_;
};

/// Losses of a load case for a share of the time.
struct LossShare {
  double share = 0.0;
  std::shared_ptr<CaseLosses> losses;
  std::string name;  ///< Name that distinguishes it from other loads; else empty.

  /// Reason why it had no losses.
  std::string failure() const {
    return name.empty() ? losses->failure() : fmt::format("{} in `{}`", losses->failure(), name);
  }
};

/// Mean heat of loads that take turns; `equal` gives the estimates of it.
HeatSource mean_heat(const std::vector<LossShare>& exact, const std::vector<LossShare>& equal, bool may_grow);

}  // namespace prs
