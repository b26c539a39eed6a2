#include "prs/sector/influence/grooved_body.h"

#include <boost/math/special_functions/bessel.hpp>

#include "contact/hertz_formulas.h"
#include "prs/indices.h"

namespace prs {
namespace {

using std::numbers::pi;

/// Value of q beyond which the squared spectrum is replaced by its mean, 9/(2 q^4).
constexpr double kLargestSpectralRadius = 60.0;

/// (3 j_1(q)/q)^2, 1 at q = 0.
double squared_spectrum(double q) {
  if (q < 1e-2) return 1.0 - q * q / 5.0;
  const double f = 3.0 * (std::sin(q) - q * std::cos(q)) / (q * q * q);
  return f * f;
}

/// Simpson's rule over [a, b].
template <class Function>
double integral(double a, double b, int intervals, Function f) {
  const double h = (b - a) / (2 * intervals);
  double sum = f(a) + f(b);
  for (int i = 1; i < 2 * intervals; ++i) sum += (i % 2 ? 4.0 : 2.0) * f(a + i * h);
  return sum * h / 3.0;
}

}  // namespace

double pressure_amplitude(const HertzPatch& patch, int harmonic, double s, double r) {
  const double height = 1.0 - std::pow(s / patch.along_profile, 2);
  if (height <= 0.0) return 0.0;
  const double half_width = patch.along_circumference * std::sqrt(height);
  const double peak = 1.5 / (pi * patch.along_profile * patch.along_circumference);
  const double x = harmonic * half_width / r;
  const double share = x < 1e-4 ? 0.5 : boost::math::cyl_bessel_j(1, x) / x;
  const double factor = harmonic == 0 ? 0.5 : 1.0;
  return factor * peak * half_width * half_width / (patch.along_circumference * r) * share;
}

double half_space_compliance(const HertzPatch& patch, const Material& material) {
  const auto [minor, major] = std::minmax(patch.along_profile, patch.along_circumference);
  const double k = contact::complete_elliptic_integrals(minor / major).first;
  return 1.2 * k * contact::compliance(material) / (pi * major);
}

double half_space_remainder(const HertzPatch& patch, const Material& material, double wave_number) {
  const double start = patch.along_circumference * std::abs(wave_number);
  // Integral in polar coordinates a_t k = q cos(phi), a_s l = q sin(phi), over |cos(phi)| > start/q.
  const auto over_angle = [&](double q) {
    return integral(0.0, std::acos(std::min(1.0, start / q)), 10, [&](double phi) {
      return 1.0 / std::hypot(patch.along_profile * std::cos(phi), patch.along_circumference * std::sin(phi));
    });
  };
  const double last = std::max(kLargestSpectralRadius, 4.0 * start);
  const auto f = [&](double q) { return squared_spectrum(q) * over_angle(q); };
  const double body = integral(std::max(start, 1e-9), last, 3000, f);
  const double rest = 1.5 / (last * last * last) * over_angle(last);
  return 2.0 * contact::compliance(material) / (pi * pi) * (body + rest);
}

namespace {

/// Ends of cells from `from` to `to`, the first cell about `first` long, the others growing up to
/// `largest`; both ends included.
std::vector<double> graded(double from, double to, double first, double growth, double largest) {
  const double length = std::abs(to - from);
  std::vector<double> ends{0.0};
  for (double size = first; ends.back() < length * (1.0 - 1e-9); size = std::min(size * growth, largest))
    ends.push_back(ends.back() + size);
  // The last cell is dropped if more than half of it is beyond the end; all are then scaled to fit exactly.
  const std::size_t n = ends.size();
  if (n > 2 && ends[n - 1] - length > 0.5 * (ends[n - 1] - ends[n - 2])) ends.pop_back();
  const double scale = (to - from) / ends.back();
  for (double& e : ends) e = from + scale * e;
  ends.back() = to;
  return ends;
}

/// Ends after each cell is cut into `parts` equal ones.
std::vector<double> split(const std::vector<double>& ends, int parts) {
  std::vector<double> finer{ends.front()};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    for (int k = 1; k < parts; ++k) finer.push_back(ends[i - 1] + (ends[i] - ends[i - 1]) * k / parts);
    finer.push_back(ends[i]);
  }
  return finer;
}

/// A column of nodes; a non-essential one is dropped if it is close to its neighbours.
struct Cut {
  double z = 0.0;
  bool essential = false;
};

double patch_height(const HertzPatch& patch, const Groove& g, FlankSide side) {
  return patch.along_profile * std::cos(g.angle(side));
}

void add_flank(std::vector<Cut>& cuts, const Groove& g, double ridge, FlankSide side, const LoadedFlank* loaded,
               const MeshDensity& density) {
  const auto add = [&](double height, bool essential) {
    cuts.push_back({ridge + g.position(side, height), essential});
  };
  add(-g.dedendum, loaded != nullptr);
  add(g.addendum, loaded != nullptr);
  if (loaded == nullptr) {
    for (int i = 1; i < density.plain_flank_cells; ++i)
      add(-g.dedendum + (g.addendum + g.dedendum) * i / density.plain_flank_cells, false);
    return;
  }
  const double half = patch_height(loaded->patch, g, side);
  const double cell = 2.0 * half / loaded->patch_cells;
  for (int i = 0; i <= loaded->patch_cells; ++i) add(-half + i * cell, true);
  const double largest = 0.5 * (g.addendum + g.dedendum);
  for (const double h : graded(half, g.addendum, cell, density.growth, largest)) add(h, true);
  for (const double h : graded(-half, -g.dedendum, cell, density.growth, largest)) add(h, true);
}

const LoadedFlank* find(const std::vector<LoadedFlank>& flanks, double ridge, FlankSide side, double tolerance) {
  for (const LoadedFlank& f : flanks)
    if (f.side == side && std::abs(f.ridge - ridge) < tolerance) return &f;
  return nullptr;
}

/// Axial positions of all columns.
std::vector<double> columns_of(const GroovedShape& s, const std::vector<LoadedFlank>& flanks,
                               const MeshDensity& density) {
  const Groove& g = s.groove;
  std::vector<Cut> cuts{{s.start, true}, {s.end, true}};
  for (const double z : s.sections) cuts.push_back({z, true});
  for (const Collar& c : s.collars) {
    cuts.push_back({c.from, true});
    cuts.push_back({c.to, true});
  }
  if (s.plain_end) {
    const double length = s.plain_end->length;
    for (const double z : graded(s.start, s.start - length, 0.2 * g.pitch, density.growth, length))
      cuts.push_back({z, true});
    for (const double z : graded(s.end, s.end + length, 0.2 * g.pitch, density.growth, length))
      cuts.push_back({z, true});
  }

  const int first = static_cast<int>(std::floor((s.start - s.ridge) / g.pitch));
  const int last = static_cast<int>(std::ceil((s.end - s.ridge) / g.pitch));
  for (int k = first; k <= last; ++k) {
    const double ridge = s.ridge + k * g.pitch;
    bool is_loaded = false;
    for (const FlankSide side : {FlankSide::backward, FlankSide::forward}) {
      const LoadedFlank* loaded = find(flanks, ridge, side, 1e-3 * g.pitch);
      is_loaded = is_loaded || loaded != nullptr;
      add_flank(cuts, g, ridge, side, loaded, density);
    }
    const int crest_cells = is_loaded ? std::max(1, density.patch_cells / 2) : 1;
    const double left = g.position(FlankSide::backward, g.addendum);
    const double right = g.position(FlankSide::forward, g.addendum);
    for (int i = 1; i < crest_cells; ++i) cuts.push_back({ridge + left + (right - left) * i / crest_cells, false});
    cuts.push_back({ridge + 0.5 * g.pitch, false});
  }
  const double low = s.start - (s.plain_end ? s.plain_end->length : 0.0);
  const double high = s.end + (s.plain_end ? s.plain_end->length : 0.0);
  const double same = 1e-6 * g.pitch, close = 0.03 * g.pitch;
  std::erase_if(cuts, [&](const Cut& c) {
    const bool of_thread = c.z > s.start - same && c.z < s.end + same;
    return c.z < low - same || c.z > high + same || (!of_thread && !c.essential);
  });
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.z < b.z; });
  std::vector<Cut> distinct;
  for (const Cut& c : cuts) {
    if (distinct.empty() || c.z - distinct.back().z > same)
      distinct.push_back(c);
    else
      distinct.back().essential = distinct.back().essential || c.essential;
  }
  // Graded from both sides alike, so that the mesh of a mirrored body is mirrored.
  std::vector<double> z;
  for (const auto i : indices(distinct)) {
    const auto gives_way_to = [&](std::size_t k) {
      return k < distinct.size() && distinct[k].essential && std::abs(distinct[k].z - distinct[i].z) < close - same;
    };
    if (distinct[i].essential || !(gives_way_to(i + 1) || gives_way_to(i - 1))) z.push_back(distinct[i].z);
  }
  return z;
}

/// Radius of the cylinder down to which the layers follow the profile. If the shoulder of a plain end is a step, the
/// radius is no deeper than the step, so that a layer ends at its foot.
double base_radius(const GroovedShape& s, const MeshDensity& density) {
  const Groove& g = s.groove;
  const double base = g.radius(-g.dedendum - density.ridge_depth * g.pitch);
  if (!s.plain_end) return base;
  const double step = g.radius(-g.dedendum) - s.plain_end->radius;
  return step > 0.1 * g.pitch ? std::max(base, s.plain_end->radius) : base;
}

/// Shares of the depth between profile and the first cylinder, 0 at the profile.
std::vector<double> ridge_layers(const Groove& g, const std::vector<LoadedFlank>& flanks, const MeshDensity& density,
                                 double base) {
  const double depth = std::abs(base - g.radius(0.0));
  double cell = 0.2 * depth;
  for (const LoadedFlank& f : flanks) cell = std::min(cell, 2.0 * f.patch.along_profile / f.patch_cells);
  std::vector<double> share = graded(0.0, depth, cell, density.growth, depth);
  for (double& d : share) d /= depth;
  return share;
}

/// Whether a body's plain ends are thinner than its cylinder of radius `base`: a step.
bool has_step(const GroovedShape& s, double base) { return s.plain_end && s.plain_end->radius < base * (1.0 + 1e-9); }

/// Ends of cells from `from` to `to`, fine at both ends.
std::vector<double> graded_to_middle(double from, double to, double first, double last, double growth, double largest) {
  const double middle = from + (to - from) * (first >= last ? 0.4 : 0.6);
  std::vector<double> ends = graded(from, middle, first, growth, largest);
  std::vector<double> back = graded(to, middle, last, growth, largest);
  back.pop_back();
  ends.insert(ends.end(), back.rbegin(), back.rend());
  return ends;
}

/// Radii of the cylinders from the first one, included, to the far surface and beyond it to the collars. Cells are
/// small where the surface steps, since a thrust face ends there.
std::vector<double> core_radii(const GroovedShape& s, const MeshDensity& density, double first, double cell) {
  const double thickness = std::abs(s.far_radius - first);
  const double largest = density.largest_cell * thickness;
  if (!s.groove.internal) {
    std::vector<double> radii{first};
    if (has_step(s, first) && s.plain_end->radius < first * (1.0 - 1e-6))
      radii = graded(first, s.plain_end->radius, cell, density.growth, largest);
    if (radii.size() > 1) cell = radii[radii.size() - 2] - radii.back();
    const std::vector<double> rest = graded(radii.back(), s.far_radius, cell, density.growth, largest);
    radii.insert(radii.end(), rest.begin() + 1, rest.end());
    return radii;
  }
  std::vector<double> stops{s.far_radius};
  for (const Collar& c : s.collars) stops.push_back(c.radius);
  for (const double r : s.radii)
    if (r > first) stops.push_back(r);
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end(), [](double a, double b) { return b - a < 1e-9; }), stops.end());
  const double small = density.step_cell * thickness;
  std::vector<double> radii{first};
  for (const auto i : indices(stops)) {
    const bool outermost = i + 1 == stops.size();
    const std::vector<double> part =
        outermost ? graded(radii.back(), stops[i], cell, density.growth, largest)
                  : graded_to_middle(radii.back(), stops[i], cell, small, density.growth, largest);
    cell = small;
    radii.insert(radii.end(), part.begin() + 1, part.end());
  }
  return radii;
}

/// Throws if the profile closes on itself, or leaves no core to mesh.
void require_proper(const GroovedShape& s, const MeshDensity& density) {
  const Groove& g = s.groove;
  for (const FlankSide side : {FlankSide::backward, FlankSide::forward}) {
    const double angle = g.angle(side);
    if (angle < 10.0 / 180.0 * std::numbers::pi || angle > 75.0 / 180.0 * std::numbers::pi)
      throw std::invalid_argument("flank normals must make 10 to 75 deg with the axis for the meridian mesh");
    if (sign(side) * g.position(side, g.addendum) <= 0.0 || sign(side) * g.position(side, -g.dedendum) >= 0.5 * g.pitch)
      throw std::invalid_argument("the flanks of a thread meet below its crest or above its root");
  }
  const double base = base_radius(s, density), least = 0.05 * g.pitch;
  if (g.internal ? base + least > s.far_radius : base - least < s.far_radius)
    throw std::invalid_argument("the wall below the threads is thinner than about half a pitch");
}

/// Height of the surface over the pitch line.
double surface_height(const GroovedShape& s, double z) {
  const double groove = 0.75 * s.groove.pitch;
  const bool plain = s.ridges && (z < s.ridges->first - groove || z > s.ridges->second + groove);
  return plain ? 0.0 : s.groove.height(z - s.ridge);
}

/// Outer radius of a nut's surface between two columns.
double outer_radius(const GroovedShape& s, double z) {
  for (const Collar& c : s.collars)
    if (c.from < z && z < c.to) return c.radius;
  return s.far_radius;
}

/// Columns and layers of a body's grid. Layers are counted from the profile: those that follow it,
/// then those of the core.
struct Layers {
  std::vector<double> z;      ///< Positions of the columns.
  std::vector<double> share;  ///< Shares of the distance from profile to base, for layers that follow the profile.
  std::vector<double> core;   ///< Radii of the core's layers.
  double base = 0.0;
  bool outwards = false;  ///< Whether the profile is innermost.

  int columns() const { return static_cast<int>(z.size()) - 1; }
  int ridge_cells() const { return static_cast<int>(share.size()) - 1; }
  int count() const { return ridge_cells() + static_cast<int>(core.size()) - 1; }
  double middle(int column) const {
    const auto c = static_cast<std::size_t>(column);
    return 0.5 * (z[c] + z[c + 1]);
  }
  /// Radius of a line between layers below a surface.
  double radius(int line, double surface) const {
    return line <= ridge_cells() ? surface + (base - surface) * item_at(share, line)
                                 : item_at(core, line - ridge_cells());
  }
  /// Line in the grid, whose layers run outwards.
  int line_in_grid(int line) const { return outwards ? line : count() - line; }
  int cell_in_grid(int layer) const { return outwards ? layer : count() - 1 - layer; }
};

Layers layers_of(const GroovedShape& shape, const std::vector<LoadedFlank>& flanks, const MeshDensity& density) {
  const Groove& g = shape.groove;
  Layers layers{
      split(columns_of(shape, flanks, density), density.split), {}, {}, base_radius(shape, density), g.internal};
  const std::vector<double> share = ridge_layers(g, flanks, density, layers.base);
  const double last_cell =
      (share[share.size() - 1] - share[share.size() - 2]) * std::abs(g.radius(-g.dedendum) - layers.base);
  layers.core = split(core_radii(shape, density, layers.base, density.growth * std::max(last_cell, 0.05 * g.pitch)),
                      density.split);
  layers.share = split(share, density.split);
  return layers;
}

bool is_threaded(const GroovedShape& shape, double z) {
  const double same = 1e-6 * shape.groove.pitch;
  return z > shape.start - same && z < shape.end + same;
}

/// Radius of the surface at a column. Next to a step the layers that follow the profile are empty, and any radius will
/// do.
double surface_radius(const GroovedShape& shape, double base, double z) {
  if (is_threaded(shape, z)) return shape.groove.radius(surface_height(shape, z));
  if (!has_step(shape, base)) return shape.plain_end->radius;
  return shape.groove.radius(-shape.groove.dedendum);
}

/// Whether a cell between two columns, with z in its middle, belongs to the body.
bool is_filled(const GroovedShape& shape, const Layers& layers, double z, int layer) {
  const auto core = [&](int line) { return item_at(layers.core, line - layers.ridge_cells()); };
  const bool in_core = layer >= layers.ridge_cells();
  if (shape.groove.internal && in_core) return core(layer + 1) < outer_radius(shape, z) * (1.0 + 1e-9);
  if (!is_threaded(shape, z) && has_step(shape, layers.base))
    return in_core && core(layer) < shape.plain_end->radius * (1.0 + 1e-9);
  return true;
}

fe::MeridianGrid grid_of(const GroovedShape& shape, const Layers& layers) {
  fe::MeridianGrid grid(layers.columns(), layers.count());
  for (int c = 0; c <= layers.columns(); ++c) {
    const double z = item_at(layers.z, c);
    const double surface = surface_radius(shape, layers.base, z);
    for (int l = 0; l <= layers.count(); ++l) grid.point(c, layers.line_in_grid(l)) = {layers.radius(l, surface), z};
  }
  for (int c = 0; c < layers.columns(); ++c)
    for (int l = 0; l < layers.count(); ++l)
      grid.set_filled(c, layers.cell_in_grid(l), is_filled(shape, layers, layers.middle(c), l));
  return grid;
}

/// The edges of the profile that a loaded flank's patch lies on.
GroovedBody::Patch patch_on(const fe::MeshedGrid& meshed, const Layers& layers, const Groove& g, const LoadedFlank& f) {
  GroovedBody::Patch p;
  p.patch = f.patch;
  p.normal = g.normal(f.side);
  p.centre = {g.pitch_radius, f.ridge + g.position(f.side, 0.0)};
  const double half = patch_height(f.patch, g, f.side) * std::tan(g.angle(f.side));
  double covered = 0.0;
  for (int c = 0; c < layers.columns(); ++c) {
    if (std::abs(layers.middle(c) - p.centre.y()) >= half) continue;
    const fe::MeridianEdge e = meshed.along_axis(c, layers.line_in_grid(0));
    covered += std::abs(item_at(meshed.mesh().nodes, e[1]).y() - item_at(meshed.mesh().nodes, e[0]).y());
    p.edges.push_back(e);
  }
  if (std::abs(covered - 2.0 * half) > 1e-6 * half)
    throw std::invalid_argument("a contact patch lies beyond the end of the threads");
  return p;
}

}  // namespace

const GroovedBody::Column& GroovedBody::column(double z) const {
  const auto found = std::min_element(columns_.begin(), columns_.end(), [&](const Column& a, const Column& b) {
    return std::abs(a.z - z) < std::abs(b.z - z);
  });
  if (found == columns_.end() || std::abs(found->z - z) > 1e-3 * shape.groove.pitch)
    throw std::invalid_argument("the body has no column of nodes at that section");
  return *found;
}

GroovedBody mesh_grooved_body(const GroovedShape& shape, const std::vector<LoadedFlank>& flanks,
                              const MeshDensity& density) {
  require_proper(shape, density);
  const Layers layers = layers_of(shape, flanks, density);
  const fe::MeridianGrid grid = grid_of(shape, layers);
  const fe::MeshedGrid meshed(grid);
  GroovedBody body;
  body.shape = shape;
  body.mesh = meshed.mesh();
  for (int c = 0; c <= layers.columns(); ++c) {
    GroovedBody::Column column{item_at(layers.z, c), {}, {}};
    for (int l = 0; l < layers.count(); ++l) {
      const bool before = c > 0 && grid.is_filled(c - 1, l);
      const bool after = c < layers.columns() && grid.is_filled(c, l);
      if (!before && !after) continue;
      column.edges.push_back(meshed.outwards(c, l));
      if (before != after) column.free_face.push_back(meshed.outwards(c, l));
    }
    body.columns_.push_back(std::move(column));
  }
  for (const LoadedFlank& f : flanks)
    body.patches.emplace_back(patch_on(meshed, layers, shape.groove, f)).tangential = f.tangential;
  return body;
}

HertzPatch fitted(HertzPatch patch, const Groove& g) {
  double longest = patch.along_profile;
  for (const FlankSide side : {FlankSide::backward, FlankSide::forward})
    longest = std::min(longest, 0.85 * std::min(g.addendum, g.dedendum) / std::cos(g.angle(side)));
  patch.along_circumference *= longest / patch.along_profile;
  patch.along_profile = longest;
  return patch;
}

Eigen::MatrixXd patch_loads(const GroovedBody& body, int harmonic) {
  Eigen::MatrixXd loads =
      Eigen::MatrixXd::Zero(fe::kComponents * body.mesh.size(), static_cast<Eigen::Index>(body.patches.size()));
  Eigen::Index column = 0;
  for (const GroovedBody::Patch& p : body.patches) {
    const double turn = std::copysign(1.0, p.normal.x() * p.normal.y());
    const Eigen::Vector2d along =
        p.tangential ? Eigen::Vector2d(turn * p.normal.y(), -turn * p.normal.x()) : Eigen::Vector2d(-p.normal);
    const auto traction = [&](double r, double z) -> Eigen::Vector3d {
      const double s = (Eigen::Vector2d(r, z) - p.centre).norm();
      const double pressure = pressure_amplitude(p.patch, harmonic, s, r);
      return {pressure * along.x(), 0.0, pressure * along.y()};
    };
    for (const fe::MeridianEdge& edge : p.edges)
      fe::add_edge_load(body.mesh, edge, harmonic, traction, loads.col(column));
    ++column;
  }
  return loads;
}

}  // namespace prs
