#pragma once

#include "prs/heat/thermal_network.h"
#include "prs/life/analyze_life.h"
#include "prs/preload/preloaded_mechanism.h"
#include "prs/slip/slip.h"

namespace prs {

/// What friction makes of power at given temperatures [W].
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

/// Whether friction may grow with temperature: that of full films falls, Coulomb's stays.
bool heat_may_grow(const Conditions& c);

/// Losses of one load case over the temperatures of the parts. Refers to conditions and contacts.
class CaseLosses {
 public:
  /// Losses with the load case's shares, or with equal ones in their place.
  CaseLosses(const Conditions& c, const Contacts& contacts, const LoadCase& load, LoadCase::Share share);

  /// Loads, slip and friction at these temperatures of the parts [K]; none where there is no slip.
  std::optional<Losses> at(const OfParts& temperature);
  /// Why there was none.
  const std::string& failure() const { return failure_; }

  /// A good estimate for a small part of the effort: heat of equal shares at the slip ratio that
  /// `at` found last, for the temperatures of the oils [K].
  std::optional<OfParts> estimate(const PerInterface<double>& oil) const { return estimate(models_, oil); }
  /// The same on a coarse grid of points in the patches, some per cent off.
  std::optional<OfParts> rough_estimate(const PerInterface<double>& oil) const { return estimate(rough_models_, oil); }

 private:
  std::optional<OfParts> estimate(const SlipModels& models, const PerInterface<double>& oil) const;

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
  std::string name;  ///< Name to tell it apart; else empty.

  /// Why it had no losses.
  std::string failure() const {
    return name.empty() ? losses->failure() : fmt::format("{} in `{}`", losses->failure(), name);
  }
};

/// Mean heat of loads that take turns; `equal` gives the estimates of it.
HeatSource mean_heat(const std::vector<LossShare>& exact, const std::vector<LossShare>& equal, bool may_grow);

/// Least and greatest of the three coordinates of temperatures in a `LossTable` [K].
struct TemperatureBox {
  OfParts least = OfParts::Zero(), greatest = OfParts::Zero();

  void include(const OfParts& coordinates);
  bool contains(const TemperatureBox& other) const;
  /// By a tenth of each width and by `margin` [K] to each side.
  TemperatureBox widened(double margin) const;
};

/// Coordinates of temperatures of the parts: mean of both oils, screw's oil less nut's, rollers
/// less that mean [K]. Along a cycle the two differences change little.
OfParts table_coordinates(const OfParts& temperature);

/// Heat into screw, rollers and nut, power that flows in and power that comes out [W].
using Flows = Eigen::Matrix<double, 5, 1>;

/// Losses over the temperatures of the parts as polynomials: products of one for each coordinate
/// through up to nine of Chebyshev's extreme points, on panels of a box that are halved, the worst
/// one first, until what their last coefficients let expect beyond them, and the difference to
/// losses off the points, are below `Effort::accuracy` of the panel's largest losses.
class LossTable {
 public:
  /// Nothing is lost.
  LossTable() = default;
  /// The same at all temperatures.
  explicit LossTable(const Losses& constant);
  using At = std::function<std::optional<Losses>(const OfParts& temperature)>;
  struct Effort {
    double accuracy = 0.0;
    int evaluations = 0;  ///< No panel is halved beyond that many.
  };
  /// `by_rollers`: whether the losses depend on the parts' temperatures other than by the oils'.
  /// What `rough`, nearly the same losses, leaves over takes fewer points. None where `at` has
  /// none.
  static std::optional<LossTable> over(const TemperatureBox& box, const At& at, bool by_rollers, const Effort& effort,
                                       LossTable rough);

  using ByTemperature = Eigen::Matrix<double, 5, 3>;
  struct Value {
    Flows value = Flows::Zero();
    ByTemperature by_temperature = ByTemperature::Zero();  ///< d/d(screw, rollers, nut) [W/K]
  };
  Value at(const OfParts& temperature, bool with_slopes = true) const;
  Flows value_at(const OfParts& temperature) const { return at(temperature, false).value; }

  /// Largest of all panels, as for `Effort::accuracy`.
  double error() const { return error_; }

 private:
  struct Panel {
    TemperatureBox box;
    std::array<int, 3> points{1, 1, 1};
    /// Coefficients of Chebyshev's polynomials, the last coordinate fastest.
    std::vector<Flows> coefficients;
    std::array<double, 3> last{};  ///< Left out along each coordinate, over the largest losses.
    double error = 0.0;

    OfParts unit(const OfParts& coordinates) const;
    void add(const OfParts& coordinates, bool with_slopes, Value& sum) const;
    void transform(const std::vector<Flows>& values, double largest);
    /// The coordinate to halve along; none where the panel is good or too narrow.
    std::optional<int> worst(double accuracy) const;
  };
  /// A panel, or where it was halved.
  struct Node {
    Panel panel;
    int along = -1;
    double halved_at = 0.0;
    std::size_t below = 0;  ///< The half below, followed by that above.
  };
  using Layer = std::vector<Node>;

  std::optional<Panel> fit(const TemperatureBox& box, const At& exact, bool by_rollers, double accuracy,
                           int& evaluations) const;
  static const Panel& panel_at(const Layer& layer, const OfParts& coordinates);

  std::vector<Layer> layers_;  ///< Which add up.
  double error_ = 0.0;
};

/// Losses over a cycle: none at rest, then those of each load case of the duty.
struct DutyLosses {
  std::vector<LossTable> tables;
  std::vector<TemperatureBox> covered = {};  ///< Temperatures of the load cases at which their tables hold.
  OfParts start = OfParts::Zero();           ///< First temperatures of the cycle.
};

/// A load case for a share of the time.
struct TimedLoad {
  LoadCase load;
  double share = 1.0;
};

/// Temperatures at which the mean heat of loads that take turns flows off: parts take minutes to
/// warm, so that each has one temperature under all of them,
///
///     Q(T) = sum_j w_j Q_j(T),   w_j the shares of time.
///
/// With solved shares from the steady state of equal ones. The case must have passed `check_case`
/// and the requirements of `slip`.
SteadyHeat steady_heat_of(const Conditions& c, const Contacts& contacts, std::span<const TimedLoad> loads);

/// Moves those over that are not there yet.
void add_new(std::vector<Warning> found, std::vector<Warning>& warnings);

/// A warning that there is no steady state.
Warning no_steady_state(HeatStatus status, const std::string& reason);

/// What `analyze_slip` delivers. Where the case states `heat`, loads and slip of each load case are
/// those at its steady temperatures, and the cycle of its duty is found. The case must have passed
/// `check_case` and the requirements of `slip`. Throws CaseError as `analyze_slip`.
Result analyze_heat(const Conditions& c, Contacts contacts, AnalysisOptions options = {});
inline Result analyze_heat(const Case& c, AnalysisOptions options = {}) {
  return analyze_heat(c, checked_contacts(c, options.detail), options);
}

/// Heat capacities of screw, rollers and nut [J/K]: those of the file, or the specific heat times
/// the masses of `measures`, the screw's over the length of the nut.
OfParts heat_capacities(const Conditions& c, const Mechanism& mechanism);

/// The state that repeats itself from cycle to cycle of the duty in `c.heat`: slip follows the
/// temperatures at once, these follow
///
///     C dT/dt = Q_k(T) - K (T - T_ambient 1)
///
/// with the losses of load case k while it acts and none at rest. Losses stand in a `LossTable` of
/// each load case over the temperatures of the cycle. Integrated by linearly implicit Euler steps,
/// extrapolated (Deuflhard; Hairer and Wanner, Solving Ordinary Differential Equations II, IV.9),
/// to 1e-8 K in a step; the start of the cycle that is also its end is found by Newton's method.
/// Energies are integrated along with the temperatures, so that they balance to rounding.
/// The peak is that within steps too. `warnings` tells of tables that losses are too rough for.
/// `known` of a case with other conductances, capacities or times serves where its tables hold for
/// the whole cycle, else `found` are new ones, over a wider range than this cycle needs.
HeatCycle periodic_heat_cycle(const Conditions& c, const Contacts& contacts, std::vector<Warning>& warnings,
                              const DutyLosses* known = nullptr, DutyLosses* found = nullptr);

// Preload and life at the temperatures that follow from the losses, where the case states `heat`.

/// What `analyze_preload` delivers, with a block `heat` at the steady temperatures of the load case
/// that `preload.load_case` names, by default the first one. The case must have passed `check_case`
/// and the requirements of `preload`.
PreloadResult analyze_warm_preload(const Conditions& c, Contacts contacts);
inline PreloadResult analyze_warm_preload(const Case& c) {
  return analyze_warm_preload(c, checked_contacts(c, Detail::complete));
}

/// What `analyze_life` delivers, with a block `heat`, solved shares and `life.temperatures: heat`
/// at one temperature of each part: that at which the mean heat of the spectrum flows off, or the
/// mean over the cycle of `heat.duty`. The case must have passed `check_case` and the requirements
/// of `life`.
LifeResult analyze_warm_life(const Conditions& c, Contacts contacts, std::optional<LoadHistory> history = {});
inline LifeResult analyze_warm_life(const Case& c, std::optional<LoadHistory> history = {}) {
  return analyze_warm_life(c, checked_contacts(c, Detail::complete), std::move(history));
}

}  // namespace prs
