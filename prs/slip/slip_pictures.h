#pragma once

#include "prs/slip/slip_model.h"

namespace prs {

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
  ResidueCurve residue;            ///< Moments over the whole range of slip ratios.
  ResidueCurve residue_near_root;  ///< Moments around the ideal slip ratio, the root inside.
  /// Patches at the result's slip ratio; absent where no thread touches.
  std::optional<PerInterface<PatchField>> most_loaded_thread;
};

/// Patches of one thread at both interfaces, at the slip of a load case that converged; absent where the
/// thread is open at one of them.
std::optional<PerInterface<PatchField>> thread_patches(const Conditions& c, const Result& result, std::size_t load_case,
                                                       std::size_t thread);

/// Pictures for a load case with a converged slip, on the loads that the result holds.
SlipPictures slip_pictures(const Conditions& c, const Result& result, std::size_t load_case);

}  // namespace prs
