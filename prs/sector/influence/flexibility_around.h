#pragma once

#include "prs/sector/influence/flexibility.h"

namespace prs {

/// Flexibility of screw or nut under unequal loads of N rollers. With g_n(i, k) the displacement of harmonic n at
/// thread i by a unit load at thread k, that of roller j by roller l is
///
///     G = sum_n g_n cos n(phi_j - phi_l),
///
/// a block circulant matrix. Loads cos(m phi_j) see its mode m, N/2 times the sum of the g_n with n = m + q N or -m + q
/// N, twice that for m = 0 and m = N/2. [m/N]
struct FlexibilityAround {
  /// m = 0 .. N/2, each a matrix over the threads; m = 0 is `Flexibility::matrix`. Without the
  /// half-space part of a contact's own patch.
  std::vector<Eigen::MatrixXd> modes;
  /// Harmonic 1 at the threads by unit loads on given sections, two columns for each: a lateral force, spread over the
  /// section, and a moment that turns its slope.
  Eigen::MatrixXd coupling;
  /// Mean lateral displacement and slope of each section by these loads.
  Eigen::MatrixXd sections;
};

/// Flexibility of the screw: n = 1 on the whole body, its loaded section clamped; higher harmonics on a block of equal
/// ridges up to n a_t/r = `largest_wave`, then those of the half-space. `sections` are axial places from the loaded
/// section [m]. Behind the body they lie on a beam of its pitch diameter.
FlexibilityAround screw_around(const BodyGeometry& body, Direction direction, const std::vector<double>& sections,
                               const FlexibilityOptions& options, MatrixCache& cache = shared_matrix_cache());

/// Flexibility of the nut: n = 1 on the whole body, its thrust face clamped; 2 to 6 on the whole body, free; higher
/// harmonics like the screw's.
FlexibilityAround nut_around(const BodyGeometry& body, Direction direction, double position,
                             const std::vector<double>& sections, const FlexibilityOptions& options,
                             MatrixCache& cache = shared_matrix_cache());

}  // namespace prs
