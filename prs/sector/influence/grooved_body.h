#pragma once

#include "fe/axisymmetric.h"
#include "prs/model/groove.h"
#include "prs/model/model_options.h"
#include "prs/model/part.h"

namespace prs {

/// Contact ellipse on a flank: semi-axes along the meridian profile and around the axis [m].
struct HertzPatch {
  double along_profile = 0.0;        ///< a_s
  double along_circumference = 0.0;  ///< a_t
};

/// Amplitude p_n of cos(n theta) in the pressure of one patch that carries 1 N, centred at
/// theta = 0 on a circle of radius r, at the distance s from its centre along the profile
/// [Pa/N = 1/m^2]:
///
///     p = p_0 sqrt(1 - (s/a_s)^2 - (r theta/a_t)^2) = sum p_n cos(n theta),   p_0 = 3/(2 pi a_s a_t),
///     p_n = e_n p_0 A^2/(a_t r) J_1(x)/x,   A = a_t sqrt(1 - (s/a_s)^2),   x = n A/r,
///
/// e_0 = 1/2 and e_n = 1 (Fourier transform of a half-ellipse, Bracewell, table of pairs). The
/// circumference is unrolled at the local radius, so that the series carries exactly 1 N.
double pressure_amplitude(const HertzPatch& patch, int harmonic, double s, double r);

/// Pressure-weighted mean displacement <u>/P of a half-space under the patch [m/N]:
///
///     6/5 K(m) (1 - nu^2)/(pi a E),   m = 1 - (b/a)^2,
///
/// 4/5 of the body's share of the approach delta. Equals
/// (delta/2 - rho_s a_s^2/20 - rho_t a_t^2/20)/P for two equal materials, since
/// rho_s a_s^2 + rho_t a_t^2 = 2 delta.
double half_space_compliance(const HertzPatch& patch, const Material& material);

/// Contribution of wave numbers beyond |k| > `wave_number` to `half_space_compliance` [m/N].
double half_space_remainder(const HertzPatch& patch, const Material& material, double wave_number);

/// Density of the mesh of a grooved body. The defaults are those of working accuracy.
struct MeshDensity {
  int patch_cells = 6;        ///< Cells across a contact patch, along the profile; even.
  double growth = 1.5;        ///< Size ratio of neighbouring cells, away from the patch.
  double largest_cell = 0.5;  ///< Radial size of cells in the core, over the body's thickness there.
  double step_cell = 0.02;    ///< Radial size at a step of a nut's surface, over the thickness.
  int plain_flank_cells = 4;  ///< Cells on flanks without load.
  int split = 1;              ///< Number of parts into which every cell is split, in each direction.
  double ridge_depth = 0.36;  ///< Depth below the roots that follows the profile, in pitches.
};

/// A flank that carries contact patches.
struct LoadedFlank {
  double ridge = 0.0;  ///< Axial position of the middle of its ridge [m].
  FlankSide side = FlankSide::backward;
  HertzPatch patch;         ///< Contact patch; must fit on the flank (see `fitted`).
  int patch_cells = 4;      ///< Cells across the patch.
  bool tangential = false;  ///< Whether it is loaded along the flank, see `patch_loads`.
};

/// A plain length of a body next to its threads, up to a radius [m].
struct PlainEnd {
  double length = 0.0;
  double radius = 0.0;
};

/// A length on which the outer surface of a nut is not `outer_radius` [m].
struct Collar {
  double from = 0.0;
  double to = 0.0;
  double radius = 0.0;
};

/// A body of revolution with grooves, in the meridian plane. Axial positions are the body's own.
struct GroovedShape {
  Groove groove;
  double start = 0.0;  ///< Start of the threads [m].
  double end = 0.0;    ///< End of the threads [m].
  double ridge = 0.0;  ///< Middle of any ridge [m].
  /// First and last ridge [m]; beyond their grooves the body is plain at the pitch radius. Absent: endless.
  std::optional<std::pair<double, double>> ridges;
  double far_radius = 0.0;            ///< Bore radius of a screw, 0 for a solid roller; outer radius of a nut [m].
  std::optional<PlainEnd> plain_end;  ///< Plain ends on both sides of an external thread.
  std::vector<Collar> collars;        ///< Collars of a nut.
  std::vector<double> sections;       ///< Further axial positions with a column of nodes [m].
  std::vector<double> radii;          ///< Further radii with a layer of nodes beyond the core of a nut [m].
};

/// The mesh of a grooved body and the places of its flanks and sections.
struct GroovedBody {
  /// Cells under one patch, with the flank's outward normal (r, z) and its pitch point.
  struct Patch {
    HertzPatch patch;
    std::vector<fe::MeridianEdge> edges;
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    bool tangential = false;
  };

  GroovedShape shape;
  fe::MeridianMesh mesh;
  std::vector<Patch> patches;  ///< Patch of each loaded flank, in the order given.

  /// Sides of the cells on a section across the body, the axis first; the section must be an end, a step or among the
  /// shape's sections. Throws std::invalid_argument otherwise.
  const std::vector<fe::MeridianEdge>& section(double z) const { return column(z).edges; }
  /// Sides of the section that lie on the surface: the whole section at an end, the face of a step.
  const std::vector<fe::MeridianEdge>& free_face(double z) const { return column(z).free_face; }

 private:
  friend GroovedBody mesh_grooved_body(const GroovedShape&, const std::vector<LoadedFlank>&, const MeshDensity&);
  struct Column {
    double z = 0.0;
    std::vector<fe::MeridianEdge> edges;
    std::vector<fe::MeridianEdge> free_face;
  };
  const Column& column(double z) const;

  std::vector<Column> columns_;
};

/// Meshes the body by 8-node quadrilaterals: columns of nodes at constant z, layers that follow the profile and fade
/// into cylinders below the roots. The ends of each patch are ends of cells. Suitable for flank normals between about
/// 20 and 70 deg to the axis, where the columns cut the flanks at a good angle. Throws std::invalid_argument if a patch
/// lies beyond the threads.
GroovedBody mesh_grooved_body(const GroovedShape& shape, const std::vector<LoadedFlank>& flanks,
                              const MeshDensity& density);

/// The patch, scaled down in both directions if it is too long for the flanks of a groove. The flexibility without its
/// half-space part hardly depends on the size of the patch.
HertzPatch fitted(HertzPatch patch, const Groove& groove);

/// Consistent nodal loads of harmonic n of one patch that pushes with 1 N along the inward normal at theta = 0, one
/// column for each patch of the body. A tangential patch pushes with 1 N along the profile: with the axial sense of the
/// inward normal and against its radial one, so that it is opposite on the two bodies of a contact.
Eigen::MatrixXd patch_loads(const GroovedBody& body, int harmonic);

inline fe::Isotropic isotropic(const Material& m) { return {m.youngs_modulus, m.poisson_ratio}; }

/// Factorizes the stiffness of a harmonic; throws if it cannot.
inline void factorize(fe::HarmonicBody& body, int harmonic) {
  if (body.factorize(harmonic) != fe::FactorizationStatus::ok)
    throw std::runtime_error("the stiffness of a grooved body could not be factorized");
}

/// Displacements by and at the loads, each weighted like its load: L' K^-1 L.
inline Eigen::MatrixXd flexibility_of(fe::HarmonicBody& body, int harmonic, const Eigen::MatrixXd& loads) {
  factorize(body, harmonic);
  return loads.transpose() * body.solve(loads);
}

/// Accuracy settings of the flexibility of the bodies.
struct FlexibilityOptions {
  MeshDensity mesh;
  /// n a_t/r up to which harmonics are summed by finite elements; beyond, the body is taken as a half-space and its
  /// harmonics are added in closed form. A larger value is not better on a coarse mesh, which represents the short
  /// waves worse than the closed form does.
  double largest_wave = 1.0;
  /// Share to which a harmonic must have decayed along the body before it is cut off.
  double block_tolerance = 1e-3;
  /// Cells across the patches of the neighbours, which carry no load in a harmonic.
  int neighbour_patch_cells = 2;
  /// Whether the thrust face of the nut only pushes: parts of it that would pull are released.
  bool unilateral_thrust = true;
};

/// Options for an accuracy: `working` uses the defaults.
inline FlexibilityOptions flexibility_options(ModelOptions::Accuracy accuracy) {
  FlexibilityOptions options;
  if (accuracy == ModelOptions::Accuracy::reference) {
    options.mesh.patch_cells = 4;
    options.mesh.split = 2;
  }
  return options;
}

}  // namespace prs
