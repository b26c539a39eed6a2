#pragma once

// Loads of every thread of a case: `prs::analyze`.
#include "prs/loads/analyze.h"
