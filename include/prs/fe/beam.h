#pragma once

// Beams of Euler and Bernoulli, and Timoshenko.
#include "fe/beam.h"
