#pragma once

// From a case to the load of every thread: `prs::analyze`.
#include "prs/loads/analyze.h"
