#pragma once

#include "prs/model/body_model.h"

namespace prs {

struct BodySolver;
extern const BodySolver kMeshed;

/// Grooved bodies of revolution by finite elements (docs/influence.md).
inline constexpr BodyModel kInfluence{
    .name = "influence",
    .help = "grooved bodies of revolution by finite elements",
    .bias = "within 0.5 % of finite elements on an inverted 21 x 5 mm screw",
    .meshes = true,
    .single_roller = false,
    .straight_rollers = false,
    .both_flanks = false,
    .derivatives = false,
    .side_by_side = false,
    .friction_on_all_rollers = false,
    .helical_contacts = false,
    .loose_guides_of_all_rollers = false,
};

}  // namespace prs
