#pragma once

// Thickness of the lubricant's film, and the share of load that flanks carry.
#include "contact/film.h"
