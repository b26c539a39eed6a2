#pragma once

// Finite elements of bodies of revolution.
#include "fe/axisymmetric.h"
