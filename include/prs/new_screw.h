#pragma once

// Complete cases from the data of catalogues.
#include "prs/configurations/configurations.h"
