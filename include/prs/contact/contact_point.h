#pragma once

// Contact points of two thread surfaces.
#include "contact/contact_point.h"
