#pragma once

#include "prs/life/load_history.h"
#include "prs/life/static_limits.h"
#include "prs/loads/analyze.h"
#include "prs/slip/slip_equilibrium.h"

namespace prs {

/// Threads of the rollers of a full mechanism at one interface, roller after roller; zero load for missing ones. SI
/// units.
struct RollerLives {
  int threads_per_roller = 0;
  std::vector<double> equivalent_load;  ///< Axial load, cubic mean over all revolutions [N].
  std::vector<double> life;             ///< L10 of the thread [revolutions].
  std::vector<double> rated_life;       ///< Life at the requested reliability [revolutions].
};

/// Threads of one interface over the whole spectrum, thread 1 first: of one roller and its counterpart. For a full
/// mechanism threads of screw or nut, which meet all rollers in turn. SI units.
struct ThreadLives {
  std::vector<double> equivalent_load;  ///< Axial load, cubic mean over all revolutions [N].
  std::vector<double> life;             ///< L10 of the thread on all rollers [revolutions].
  std::vector<double> rated_life;       ///< Life at the requested reliability [revolutions].
  /// Largest N cos(psi) of all forces: at rest, and of a running screw if its loads determine life [N].
  std::vector<double> largest_load;
  /// Equivalent range of the axial load over the cycles of the history [N]; empty without history.
  std::vector<double> equivalent_range;
  std::optional<RollerLives> rollers;  ///< Lives at the rollers; full mechanism only.
};

/// One sense of the load, whose flanks the other sense does not load unless they are preloaded.
struct FlankLife {
  double revolutions = 0.0;    ///< Revolutions under this sense of the load.
  double largest_force = 0.0;  ///< Largest force of this sense [N].
  /// Cubic mean over the revolutions of *both* senses [N], of the load that the flanks carry at the screw, which
  /// differs from the force only with preload.
  double mean_load = 0.0;
  double life = 0.0;          ///< L10 with the solved thread loads [revolutions of both senses].
  double life_at_rest = 0.0;  ///< L10 with those of a screw at rest.
  PerInterface<ThreadLives> threads;
  PerInterface<std::optional<double>> peak_pressure;  ///< Peak pressure under the largest loads of threads [Pa].
  /// Peak pressure under the largest loads of threads while the screw turns [Pa].
  PerInterface<std::optional<double>> running_peak_pressure;
  /// Force at which the most loaded thread reaches `kStaticPressureLimit` [N].
  std::optional<double> static_capacity;
  /// Force at which the ellipse of the most loaded thread reaches a crest or root [N].
  std::optional<double> flank_edge_load;
  /// Ratio of `flank_edge_load` to the largest force.
  std::optional<double> flank_edge_margin() const {
    return flank_edge_load && largest_force > 0.0 ? std::optional(*flank_edge_load / largest_force) : std::nullopt;
  }
  /// Limit of static safety, see prs/life/static_limits.h.
  std::optional<StaticRating> static_rating;
  /// The rating over the largest force.
  std::optional<double> static_safety() const {
    return static_rating && largest_force > 0.0 ? std::optional(static_rating->force / largest_force) : std::nullopt;
  }
  int solves = 0;                    ///< Number of equilibria solved for this sense.
  double interpolation_error = 0.0;  ///< Relative error of thread loads interpolated between them.
};

/// Load cycles counted in a history.
struct LoadCycles {
  std::vector<Cycle> cycles;
  CycleMatrix matrix;
  double equivalent_range = 0.0;  ///< [N]
};

/// Thread that fails first, of those that turn under load.
struct WeakestThread {
  Direction direction = Direction::tension;
  Interface interface = Interface::screw;
  std::size_t thread = 0;
  std::optional<Part> part;           ///< Part of the thread; full mechanism only.
  std::optional<std::size_t> roller;  ///< Index of the roller, if the thread belongs to a roller of a full mechanism.
  double equivalent_load = 0.0;
  double life = 0.0;
};

/// Effect of film and contamination on the life, by ISO 281:2007, under the mean load at the mean speed.
struct ModifiedLife {
  double film_ratio = 0.0;       ///< Lambda, the smallest of all threads.
  double viscosity_ratio = 0.0;  ///< kappa = Lambda^1.3.
  double load_ratio = 0.0;       ///< C_u/P: (1.5 GPa over the largest peak pressure)^3.
  double factor = 0.0;           ///< a_ISO
};

/// Axial bearing of the turning part under the loads of the spectrum, rests and travel without load included. SI units.
struct BearingLife {
  double revolutions = 0.0;      ///< Revolutions of one pass.
  double equivalent_load = 0.0;  ///< Mean of the loads with preload, over the revolutions [N].
  std::optional<double> life;    ///< L10 in its own revolutions; none without dynamic capacity.
  std::optional<double> static_safety;
};

/// All results of `analyze_life`. SI units; lives in revolutions.
struct LifeResult {
  Life life;
  Contacts contacts;
  ModelOptions model;
  ModelOptions::Loads loads = ModelOptions::Loads::at_rest;  ///< Loads that determine fatigue.
  std::optional<LemorCapacity> lemor;                        ///< Absent if the case states the capacity.
  double dynamic_capacity = 0.0;
  Interval dynamic_capacity_range;
  PerInterface<double> failure_shares;
  /// Share of the rollers in the failures of each interface; full mechanism only.
  std::optional<PerInterface<double>> roller_shares;
  double reliability_factor = 1.0;  ///< a1
  double element_ratio = 0.0;       ///< gamma = d_r cos(alpha)/(2 c)

  std::optional<PerPart<double>> temperature;    ///< Temperatures of the parts, by `heat` [K].
  std::optional<HeatStatus> temperature_status;  ///< Outcome of the search for them.

  std::vector<LoadStep> steps;  ///< Steps of the history or the spectrum.
  std::optional<LoadHistory> history;
  double revolutions = 0.0;        ///< Sum over all steps; 1 if they are shares.
  bool revolutions_known = true;   ///< false if the spectrum states shares.
  std::optional<double> duration;  ///< Duration of one pass, if the clock time is known [s].
  /// Mean rate that converts lives to hours: by the clock, else in motion [1/s].
  std::optional<double> revolution_rate;
  std::optional<double> moving_rate;  ///< Rate at the operation's speed [1/s].
  double mean_load = 0.0;             ///< Cubic mean over all loads [N].
  double largest_force = 0.0;         ///< [N]

  double catalogue_life = 0.0;         ///< (C_a/F_m)^3, one flank, equal shares.
  double equal_shares_life = 0.0;      ///< Life of both flanks separately, equal shares.
  double system_life = 0.0;            ///< Life of both flanks separately, solved thread loads.
  std::optional<double> life_at_rest;  ///< Life with thread loads at rest, if the others are those of a running screw.
  std::optional<WeakestThread> weakest;
  PerDirection<std::optional<FlankLife>> flanks;
  /// Forces at which equal thread loads reach `kStaticPressureLimit` and the end of a flank [N].
  std::optional<double> equal_shares_static_capacity, equal_shares_flank_edge_load;
  std::optional<LoadCycles> cycles;

  std::optional<BearingLife> bearing;    ///< Present if the case states its bearing.
  std::optional<ModifiedLife> modified;  ///< Life with film and contamination, if `life.contamination` is stated.

  std::optional<std::string> failure;  ///< Reason why there are no lives: a load did not converge.
  std::vector<Warning> warnings;

  bool converged() const { return !failure; }
  /// Life of the screw: that of a stated capacity, which has uneven sharing in it, else with solved thread loads.
  double screw_life() const { return lemor ? system_life : catalogue_life; }
  /// Life of the bearing in revolutions of the screw under load, as all others.
  std::optional<double> bearing_life() const;
  /// Life of screw and bearing together.
  std::optional<double> life_with_bearings() const;
  /// Rated life over L10: a1 times the modification factor.
  double rated_over_l10() const { return reliability_factor * life.modification_factor; }
  /// Static safety of the weaker sense of the load: the smaller ratio of rating to largest force.
  std::optional<double> static_safety() const;
  std::optional<StaticLimit> static_safety_limit() const;

 private:
  const FlankLife* statically_weakest() const;
};

/// Static limits; absent if the geometry gives no Hertz contact, or no equilibrium is found.
struct StaticForces {
  std::optional<StaticRating> rating;
  std::optional<double> flank_edge_load;  ///< See `FlankLife`.
};

/// Static limits under forces of one sense, with the thread loads solved at the limit, as `analyze_life` computes them
/// for a spectrum of such forces, with the preload of the conditions; along the axis, so not where a load case of a
/// full mechanism has side loads of its own. `force`: start of the search [N].
StaticForces solved_static_forces(const Conditions& c, const Contacts& contacts, Direction direction, double position,
                                  double force);

/// Contacts -> capacity -> load distribution over the loads of the spectrum -> lives. Reads and prints nothing. The
/// case must have passed `check_case` and the requirements of `life`; `history` is given if the case has one. Throws
/// CaseError if Lemor's factor is not known for the geometry, the loads need a thrust section that is not given, the
/// screw never turns or never carries, or the geometry gives no contact. `oils`: replace the lubricant at the
/// temperature of the file, for running loads. With a block `heat` see prs/heat/analyze_heat.h.
LifeResult analyze_life(const Conditions& c, Contacts contacts, std::optional<LoadHistory> history = {},
                        const std::optional<Oils>& oils = {});
inline LifeResult analyze_life(const Case& c, std::optional<LoadHistory> history = {}) {
  return analyze_life(c, checked_contacts(c, Detail::complete), std::move(history));
}

}  // namespace prs
