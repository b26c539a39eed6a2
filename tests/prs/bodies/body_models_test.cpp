#include "prs/bodies/body_models.h"

#include <gtest/gtest.h>

#include "prs/bodies/body_solver.h"

namespace prs {
namespace {

TEST(BodyModels, HaveTheSolversOfWhatTheyKnow) {
  for (const auto& [model, solver] : kBodyModels) {
    SCOPED_TRACE(model.name);
    Case c;
    c.model.bodies = &model;
    EXPECT_EQ(&body_solver(c), &solver);
    EXPECT_NE(solver.at_rest, nullptr);
    EXPECT_EQ(solver.running != nullptr, model.friction);
    EXPECT_EQ(solver.all_rollers != nullptr, model.all_rollers);
    EXPECT_TRUE(model.all_rollers || !(model.friction_on_all_rollers || model.loose_guides_of_all_rollers));
  }
}

}  // namespace
}  // namespace prs
