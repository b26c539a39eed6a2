#pragma once

// Friction over the ellipse of a contact.
#include "contact/patch.h"
