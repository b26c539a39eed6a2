#pragma once

// Surfaces of threads.
#include "contact/thread_surface.h"
