#pragma once

#include "contact/interface_geometry.h"

namespace contact {

/// The end of a flank that a contact ellipse reaches first as it grows about its centre.
struct FlankEdge {
  bool of_roller = false;  ///< Else of the body.
  FlankEnd end = FlankEnd::root;
  double scale = 0.0;  ///< Factor on both semi-axes to reach the edge [-].
};

/// Where an ellipse of those semi-axes [m], both > 0, ends as it grows: the smallest ratio of the
/// radial distance from the contact point to a root or crest over the ellipse's radial reach
///
///     sqrt((a t_1 e_r)^2 + (b t_2 e_r)^2)
///
/// e_r outwards from the axis of the flank's part, the reach by which `ellipse_beyond_flanks`
/// measures. Flanks end at the heights of their threads where these are given, else where they
/// meet their neighbours. As a and b grow with N^(1/3), the load at the edge is scale^3 N.
FlankEdge nearest_flank_edge(const ThreadPair& pair, const InterfaceGeometry& interface,
                             double semi_major, double semi_minor);

}  // namespace contact
