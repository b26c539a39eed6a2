#pragma once

#include <Eigen/Core>

namespace prs {

/// The two flanks of a thread in the meridian plane, named by the axial direction of their outward normal.
enum class FlankSide { backward, forward };  // against x, along x

constexpr double sign(FlankSide f) { return f == FlankSide::backward ? -1.0 : 1.0; }

/// Threads of one body as annular ridges of trapezoidal profile: the section through the axis, without its lead. Ridges
/// are half a pitch wide at the pitch radius, so that a loaded flank meets the pitch radius a quarter of a pitch from
/// the middle of its ridge.
struct Groove {
  bool internal = false;        ///< Whether ridges point inwards, as those of a nut.
  double pitch = 0.0;           ///< [m]
  double pitch_radius = 0.0;    ///< [m]
  double addendum = 0.0;        ///< Height of the crest above the pitch radius [m].
  double dedendum = 0.0;        ///< Depth of the root below the pitch radius [m].
  double backward_angle = 0.0;  ///< Angle between normal and axis of the backward flank [rad].
  double forward_angle = 0.0;   ///< Angle between normal and axis of the forward flank [rad].

  double angle(FlankSide f) const { return f == FlankSide::backward ? backward_angle : forward_angle; }
  /// Radius at a height above the pitch line, towards the crest [m].
  double radius(double height) const { return pitch_radius + (internal ? -height : height); }
  /// Height of the profile at the axial distance x from the middle of a ridge [m].
  double height(double x) const;
  /// Axial distance from the middle of the ridge at which a flank has a height [m].
  double position(FlankSide f, double height) const;
  /// Outward normal (r, z) of a flank.
  Eigen::Vector2d normal(FlankSide f) const;
};

/// Height of the crest above the pitch line of usual threads, in pitches; below, depth of the root: from the outer and
/// root diameters of a catalogue (tests/prs/measures/shaft_test.cpp). At 45 deg the flanks of a groove meet at its
/// root.
inline constexpr double kCrestHeight = 0.15;
inline constexpr double kRootDepth = 0.25;
/// Root depth, in pitches, of meshes and where heights are stated, which leaves a flat bottom in the groove.
inline constexpr double kMeshedRootDepth = 0.23;

/// Radial distance from the pitch line at which the flanks of ridges half a pitch wide meet [m].
double sharp_height(double pitch, double flank_angle);

/// Depth of the root below the pitch line if the mechanism gives no heights [m]: `kRootDepth` or where the flanks meet.
double default_root_depth(double pitch, double flank_angle);

/// Groove for bodies with teeth if the mechanism gives no heights: crest of a catalogue and, since a mesh needs a flat
/// between the flanks, `kMeshedRootDepth` only; both at most 95 % of the height at which flanks meet.
Groove default_groove(bool internal, double pitch, double pitch_radius, double backward_angle, double forward_angle);

/// Least wall that `kRefined` takes below the roots, and under a flange outside the pitch
/// radius, in pitches.
inline constexpr double kLeastWall = 0.1;

}  // namespace prs
