#pragma once

// Bars.
#include "fe/beam.h"
