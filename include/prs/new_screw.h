#pragma once

// A complete case from what a catalogue prints.
#include "prs/configurations/configurations.h"
