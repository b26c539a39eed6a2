#pragma once

// A structure of nodes, elements and supports: `fe::Model`.
#include "fe/model.h"
