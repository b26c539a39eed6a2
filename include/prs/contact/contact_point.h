#pragma once

// Where two thread surfaces touch.
#include "contact/contact_point.h"
