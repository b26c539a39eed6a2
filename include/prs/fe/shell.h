#pragma once

// Shells of revolution.
#include "fe/shell.h"
