#pragma once

// Curvature tensors and their principal values.
#include "contact/curvature.h"
