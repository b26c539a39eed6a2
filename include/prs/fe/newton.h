#pragma once

// Equilibrium of a structure: `fe::Equations`, and `fe::NewtonSolver` on their sparse tangent.
#include "fe/newton.h"
