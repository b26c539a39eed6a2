#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prs/figures/figure.h"
#include "prs/loads/result.h"

namespace prs {

// Pictures of the contacts, to scale, in configuration I1J2 (Sandu 2018, section 1.3): frame of the
// screw, z along its axis, x towards the axis of the first roller. Absent where an interface has no
// contact point.

/// The three threads cut parallel to their axes: the section is stepped at the roller's axis and
/// passes through the contact points on both sides, so that the loaded flanks touch where they do
/// in space. An overview and each contact enlarged [mm] (Sandu 2018, figs. 1.8, 1.9). Parts of
/// different pitch touch at one thread.
std::optional<Figure> contact_section_figure(const Result& result);

/// Pitch circles of all parts along the axis and each contact point enlarged, with the angles
/// between the line of centres and the point about both axes [mm].
std::optional<Figure> contact_xy_figure(const Result& result);

/// Both contact ellipses with the principal directions of both bodies, in the tangent planes and
/// seen from outside the roller [mm] (Sandu 2018, fig. 1.16; Yao 2023, fig. 5): under the largest
/// normal load of the cases, or of unit major semi-axes where no case has ellipses. Absent also
/// where the relative curvatures give no ellipse.
std::optional<Figure> contact_ellipse_figure(const Result& result);

/// All of these that there are.
std::vector<Figure> contact_figures(const Result& result);

/// Why they are missing where they are, a line for each interface without a contact point.
std::vector<std::string> contacts_without_figure(const Result& result);

}  // namespace prs
