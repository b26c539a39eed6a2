#include "prs/bodies/body_models.h"

#include "prs/bodies/body_solver.h"

namespace prs {

const BodySolver& body_solver(const Conditions& c) {
  const auto* row = kBodyModels;
  while (&row->model != c.model.bodies) ++row;
  return row->solver;
}

}  // namespace prs
