#pragma once

#include "fe/axisymmetric.h"
#include "prs/model/materials.h"
#include "prs/sector/influence/flexibility_options.h"
#include "prs/sector/influence/matrix_cache.h"

namespace prs {

/// Response of a long body to one loaded ridge, harmonic by harmonic.
struct BlockResponse {
  int reach = 0;  ///< Ridges to each side.
  /// Entry d + `reach`: displacement at the contacts of ridge d (rows) by the contacts of ridge 0.
  std::vector<Eigen::MatrixXd> kernel;
};

/// Harmonic n >= 2 of unit forces at theta = 0 on the given flanks of one ridge in a block of
/// equal ridges; `far_radius` as in GroovedShape. Builds a new mesh for each `reach`, kept between
/// calls with the same one.
class BlockSolver {
 public:
  BlockSolver(const Groove& groove, double far_radius, const Material& material,
              const std::vector<LoadedFlank>& flanks, const FlexibilityOptions& options);

  BlockResponse solve(int harmonic, int reach);
  /// Ridges that the harmonic reaches to each side, at most `largest`.
  int reach(int harmonic, int largest) const;

 private:
  Groove groove_;
  double far_radius_;
  fe::Isotropic material_;
  std::vector<LoadedFlank> flanks_;
  FlexibilityOptions options_;
  int reach_ = -1;
  GroovedBody body_;
  std::unique_ptr<fe::HarmonicBody> solver_;
};

/// The teeth of one body: types of contacts on each ridge, whether they lie at theta = pi, and the
/// harmonics step, 2 step, .. from `first` on.
struct Teeth {
  Groove groove;
  double far_radius = 0.0;
  Material material;
  std::vector<LoadedFlank> types;
  std::vector<bool> opposite;
  int first = 0;
  int step = 1;
  int contacts = 1;
  FlexibilityOptions options;
};

/// What the harmonics that die out along a body add to its flexibility, the same at all threads.
struct TeethFlexibility {
  BlockResponse response;      ///< Sum of the harmonics; rows and columns are types of contacts.
  Eigen::VectorXd half_space;  ///< Half-space part per type, to subtract from the diagonal [m/N].
  Eigen::VectorXd remainder;   ///< Harmonics left out, to add to the diagonal [m/N].
};

TeethFlexibility teeth_flexibility(const Teeth& teeth, MatrixCache& cache);

/// Adds the teeth to a body's matrix, whose rows and columns are the types in blocks of `contacts`.
/// With `centred`, contacts of different types lie at the same axial position, and not half a pitch
/// apart as on the ridge.
void add_teeth(const TeethFlexibility& flexibility, const Teeth& teeth, bool centred,
               Eigen::MatrixXd& matrix);

}  // namespace prs
