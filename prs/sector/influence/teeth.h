#pragma once

#include "prs/sector/influence/flexibility.h"

namespace prs {

/// Response of a long body to one loaded ridge, harmonic by harmonic.
struct BlockResponse {
  int reach = 0;  ///< Number of ridges to each side.
  /// Entry d + `reach`: displacement at the contacts of ridge d (rows) by the contacts of ridge 0.
  std::vector<Eigen::MatrixXd> kernel;
};

/// Harmonic n >= 2 of unit forces at theta = 0 on the given types of contacts on one ridge in a block of equal ridges;
/// `far_radius` as in GroovedShape. Makes a new mesh for each `reach` and keeps it for calls with the same one.
class BlockSolver {
 public:
  explicit BlockSolver(const Teeth& teeth) : teeth_(teeth) {}
  BlockResponse solve(int harmonic, int reach);
  /// Number of ridges over which the harmonic decays to each side, at most all but one of the contacts.
  int reach(int harmonic) const;

 private:
  Teeth teeth_;
  int reach_ = -1;
  GroovedBody body_;
  std::unique_ptr<fe::HarmonicBody> solver_;
};

/// Adds the contribution of harmonics that decay along a body. Rows and columns of the matrix are the types in blocks
/// of `contacts`. With `centred`, contacts of different types lie at the same axial position, not half a pitch apart as
/// on the ridge.
void add_teeth(Flexibility& f, const Teeth& teeth, bool centred, MatrixCache& cache);

}  // namespace prs
