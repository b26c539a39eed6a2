#pragma once

// Bars.
#include "fe/bar.h"
