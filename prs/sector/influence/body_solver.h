#pragma once

#include "fe/axisymmetric.h"
#include "prs/model/materials.h"

namespace prs {

inline fe::Isotropic isotropic(const Material& m) { return {m.youngs_modulus, m.poisson_ratio}; }

/// Throws where the stiffness of a harmonic cannot be factorized.
inline void factorize(fe::HarmonicBody& body, int harmonic) {
  if (body.factorize(harmonic) != fe::FactorizationStatus::ok)
    throw std::runtime_error("the stiffness of a grooved body could not be factorized");
}

/// Displacements by and at the loads, each weighted like its load: L' K^-1 L.
inline Eigen::MatrixXd flexibility_of(fe::HarmonicBody& body, int harmonic,
                                      const Eigen::MatrixXd& loads) {
  factorize(body, harmonic);
  return loads.transpose() * body.solve(loads);
}

}  // namespace prs
