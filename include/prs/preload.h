#pragma once

// Oversized rollers and double nuts: `prs::analyze_preload`.
#include "prs/preload/preloaded_mechanism.h"
