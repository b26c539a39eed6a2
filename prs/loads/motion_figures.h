#pragma once

#include "prs/loads/load_pictures.h"

namespace prs {

/// Pictures of travels and modes.
Pictures motion_pictures(const Result& result);

}  // namespace prs
