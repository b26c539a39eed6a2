#pragma once

#include "prs/model/body_model.h"

namespace prs {

struct BodySolver;
extern const BodySolver kOneDimensional;

}  // namespace prs
