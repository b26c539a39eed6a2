#pragma once

#include <string>
#include <vector>

#include "prs/model/part.h"

namespace prs {

/// Radial guidance of the roller ends by the guide rings.
struct Guidance {
  enum class Kind {
    both_end_nodes,  ///< v = 0 on both nodes of each end element (Abevi's BC3).
    outer_node,      ///< v = 0 on the two outermost nodes.
    ring,            ///< A radial spring on both nodes of each end element.
  };
  Kind kind = Kind::both_end_nodes;
  double ring_stiffness = 0.0;  ///< Stiffness of each of a roller's four springs [N/m].
  double clearance = 0.0;       ///< Radial displacement below which a spring carries no force [m].
};

/// Support of the guide rings of a full mechanism, one ring at each end of the rollers.
struct Rings {
  enum class Carrier { housing, nut, screw };
  /// Part that carries the rings; default: the part on which the rollers stay in place.
  std::optional<Carrier> carrier;
  double stiffness = kRigid;  ///< Stiffness between ring and carrier [N/m]; below `kRigid` the ring floats.

  bool operator==(const Rings&) const = default;
};

/// Support of the screw of a full mechanism.
struct Bearing {
  double position = 0.0;    ///< x on the nut's axis [m].
  double lateral = kRigid;  ///< Lateral stiffness [N/m]; 0: free.
  double tilt = 0.0;        ///< Tilt stiffness [N m/rad]; 0: free.
  Lateral offset;           ///< Displacement of its seat [m].
  Lateral angle;            ///< Rotation of its seat [rad].
};

/// Support of the thrust section of the nut of a full mechanism.
struct Housing {
  double axial = kRigid;    ///< [N/m]
  double lateral = kRigid;  ///< [N/m]
  double tilt = kRigid;     ///< [N m/rad]

  bool operator==(const Housing&) const = default;
};

/// Drive that turns the screw of a full mechanism, for its vibration.
struct Drive {
  double position = 0.0;      ///< x on the nut's axis [m].
  double inertia = 0.0;       ///< [kg m^2]
  double stiffness = kRigid;  ///< Torsional stiffness at that section [N m/rad].
};

/// Components along x, y and z.
struct Spatial {
  double x = 0.0, y = 0.0, z = 0.0;
};

/// A rigid mass on a section of screw or nut, for vibration.
struct ExtraMass {
  enum class Carrier { screw, nut };

  std::optional<std::string> name;
  Carrier carrier = Carrier::nut;
  double position = 0.0;  ///< x of the section, on the nut's axis [m].
  double mass = 0.0;      ///< [kg]
  Spatial centre;         ///< Centre of mass, measured from the axis at the section [m].
  Spatial inertia;        ///< Inertia about the centre of mass [kg m^2].
};

/// Parts between and around the threads (one sector of Abevi 2015). Axial positions on the nut are measured from the
/// nut's end that faces the loaded end of the screw. SI units.
struct Structure {
  struct Screw {
    double bore = 0.0;         ///< Diameter [m].
    double free_length = 0.0;  ///< Length from the loaded section to the first contact [m].
    double far_length = 0.0;   ///< Length behind the last contact, full mechanism [m].
    std::vector<Bearing> bearings = {};
    std::optional<Drive> drive = {};
  };
  struct Roller {
    double end_length = 0.0;    ///< [m]
    double end_diameter = 0.0;  ///< [m]
    Guidance guidance;
    Rings rings = {};
  };
  struct Flange {
    double from = 0.0;
    double to = 0.0;
    double outer_diameter = 0.0;
  };
  /// Axial position of the constrained section, by the direction of the load [m].
  struct Thrust {
    std::optional<double> tension;
    std::optional<double> compression;
  };
  /// Ring of the thrust face that the housing touches; `refined` and `influence` only.
  struct Shoulder {
    double inner_diameter = 0.0;  ///< [m]
    double outer_diameter = 0.0;  ///< [m]
  };
  struct Nut {
    double length = 0.0;
    double outer_diameter = 0.0;
    std::vector<Flange> flanges;
    Thrust thrust;
    std::optional<Shoulder> shoulder = {};  ///< Spans from the nut's to the flange's diameter if absent.
    Housing housing = {};
  };

  Screw screw;
  Roller roller;
  Nut nut;
  std::vector<ExtraMass> masses = {};
};

/// Outer diameter of the nut between flanges or of the flange there; 0 beyond its ends [m].
inline double nut_diameter(const Structure::Nut& nut, double x) {
  if (x < 0.0 || x > nut.length) return 0.0;
  for (const Structure::Flange& flange : nut.flanges)
    if (flange.from < x && x < flange.to) return flange.outer_diameter;
  return nut.outer_diameter;
}

/// Diameters just before and just behind a section; they differ where the nut has a face.
inline std::pair<double, double> nut_diameters_at(const Structure::Nut& nut, double x) {
  const double close = 1e-8 * nut.length;
  return {nut_diameter(nut, x - close), nut_diameter(nut, x + close)};
}

/// Axial distance, as a share of the nut's length, below which two places are the same.
inline constexpr double kSamePlace = 1e-9;

/// Length from the loaded section to the first contact [m]; 0 if both are the same place.
inline double free_length(const Structure& s) {
  return s.screw.free_length < kSamePlace * s.nut.length ? 0.0 : s.screw.free_length;
}

}  // namespace prs
