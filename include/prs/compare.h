#pragma once

// One case by every model of the bodies: `prs::compare_models`.
#include "prs/compare/compare_models.h"
