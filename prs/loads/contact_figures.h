#pragma once

#include "prs/loads/load_pictures.h"

namespace prs {

/// Label of the semi-axes of an ellipse [mm].
std::string semi_axes_text(double a, double b);
/// Sections of the threads through their contacts, and the contact ellipses.
Pictures contact_drawings(const Result& result);

}  // namespace prs
