#pragma once

#include "prs/sector/roller_push.h"
#include "prs/sector/sector.h"

namespace prs {

/// What the guides of a roller that bends hold of the forces at its threads.
///
/// Let phi_h be the shape of the free roller whose guides at end h move outwards by 1. By
/// reciprocity the guides of that end push the roller outwards with R_h = -sum f phi_h, f all other
/// forces and moments on it; phi_near + phi_far = 1, a rigid motion.
class RollerGuides {
 public:
  explicit RollerGuides(const Sector& sector);

  /// R_near and R_far under the normal loads of all threads and a push [N].
  std::array<double, 2> forces(const PerInterface<std::vector<double>>& normal_load,
                               const RollerPush& push) const;

 private:
  /// phi at a thread: deflection, and rotation times the arm of an axial force.
  struct At {
    double across = 0.0, along = 0.0;
  };
  struct End {
    PerInterface<std::vector<At>> threads;
    double of_thread = 0.0, of_heads = 0.0;  ///< Integral of phi over their lengths [m].
  };
  double sense_;
  PerInterface<double> cosine_, sine_;
  std::array<End, 2> ends_;
};

}  // namespace prs
