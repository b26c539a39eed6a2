#pragma once

#include "prs/loads/analyze.h"
#include "prs/slip/slip_model.h"

namespace prs {

/// The whole chain with slip: what `analyze` delivers, or for equal shares `analyze_contacts`, and
/// for each load case the stationary slip and what friction takes. The case must have passed
/// `check_case` and the requirements of `slip`. Throws CaseError where the geometry gives no
/// contact, or measured pitches bring its threads out of mesh.
/// `oils`: in place of the lubricant at the temperature of the file.
Result analyze_slip(const Conditions& c, Contacts contacts, AnalysisOptions options = {},
                    const std::optional<Oils>& oils = {});
inline Result analyze_slip(const Case& c, AnalysisOptions options = {}) {
  return analyze_slip(c, checked_contacts(c, options.detail), options);
}

/// Throws CaseError where the geometry gives no contact or measured pitches bring its threads out of mesh.
void require_rolling(const Conditions& c, const Contacts& contacts);

/// Whether all threads of a roller stay in the grooves that they begin with, for all measured pitches.
bool rolls(const Mechanism& mechanism);

/// Slip of one load case, without the comparison with equal shares.
SlipResult slip_result(const SlipModel& model);

/// Which numbers of the threads are wanted.
struct SlipDetail {
  bool threads = true;  ///< All but films.
  bool films = true;
};

/// The same for an equilibrium that is known, into memory that the result keeps.
void set_slip_result(SlipResult& slip, const SlipModel& model, const SlipEquilibrium& found, const SlipDetail& detail);

/// Efficiency of the same load at the same speed where the load drives; absent where the screw
/// locks itself, or the case lacks what `slip` needs or a temperature of its oil.
std::optional<double> back_driving_efficiency(const Conditions& c, const Contacts& contacts,
                                              const LoadCaseResult& loaded);

/// Film over roughness below which flanks begin to touch, and below which touching flanks carry
/// most: the usual bounds of lubrication (Hamrock, Schmid, Jacobson, Fundamentals of Fluid Film
/// Lubrication, 2004, chapter 3).
inline constexpr double kFullFilm = 3.0, kTouchingFlanks = 1.0;

/// `boundary`, `mixed` or `full film`.
std::string_view lubrication(double film_ratio);

/// A warning that there is no slip, `where` it was looked for: a contact jams, or nothing balances.
Warning no_slip(bool jammed, const std::string& where);

/// A warning where the film of a lubricant cannot be compared with the roughness of the flanks.
std::optional<Warning> unknown_film_ratio(const Conditions& c);

/// Moments on a roller along the slip ratio: one curve of Sandu 2018, fig. 3.6.
struct ResidueCurve {
  std::vector<double> slip_ratio;
  std::vector<RollerMoments> moments;
};

/// Sliding and friction at the points inside the ellipse of one thread (figs. 2.8 and 2.9).
struct PatchField {
  double semi_major = 0.0, semi_minor = 0.0;         ///< a, b [m]
  int points = 0;                                    ///< Along each axis of the grid.
  std::vector<double> along_major, along_minor;      ///< t_1D, t_2D [m]
  std::vector<double> sliding_major, sliding_minor;  ///< v_D . t_1, v_D . t_2 [m/s]
  std::vector<double> friction_coefficient;          ///< mu_D
};

/// Data for the pictures of one load case, in addition to its result.
struct SlipPictures {
  ResidueCurve residue;                         ///< Over the whole range of slip ratios.
  ResidueCurve residue_near_root;               ///< Around the ideal one, the root inside.
  PerInterface<PatchField> most_loaded_thread;  ///< At the result's slip ratio.
};

/// What friction does from a thousandth to ten times the speed of a load case, loads at rest and
/// the oil as they are, loads of a running screw found anew; speeds without an equilibrium are left
/// out.
struct StribeckCurve {
  std::vector<double> speed;                      ///< Magnitude [rad/s], ascending.
  std::vector<double> power;                      ///< Lost in the whole mechanism [W]
  std::vector<std::optional<double>> efficiency;  ///< Absent where self-locking.
  // At the thread of the largest load:
  PerInterface<std::vector<double>> friction;    ///< mu_a, mean over the points.
  PerInterface<std::vector<double>> film_ratio;  ///< Lambda; empty where it is not known.
};
StribeckCurve stribeck_curve(const Conditions& c, const Result& result, std::size_t load_case);

/// Patches of one thread at both interfaces, at the slip of a load case that converged; absent where the
/// thread is open at one of them.
std::optional<PerInterface<PatchField>> thread_patches(const Conditions& c, const Result& result, std::size_t load_case,
                                                       std::size_t thread);

/// For one load case with a converged slip, on the loads that the result holds.
SlipPictures slip_pictures(const Conditions& c, const Result& result, std::size_t load_case);

}  // namespace prs
