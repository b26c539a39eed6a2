#include "prs/sector/influence/flexibility_around.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "prs/sector/influence/body_solver.h"
#include "prs/sector/influence/loaded_bodies.h"

namespace prs {
namespace {

using Eigen::Index;
using fe::Component;

/// Harmonics of a nut that reach beyond its rollers.
constexpr int kWholeNut = 6;

/// All that the matrices of unlike loads depend on.
struct UnlikeLoads {
  HeldNut body;  ///< Or a screw, held where it starts.
  Teeth teeth;
  std::vector<double> sections;
  int whole = 1;  ///< Highest harmonic on the whole body.
};
PRS_MEMBERS(UnlikeLoads, body, teeth, sections, whole)

/// Sums of harmonics by the mode that sees them.
class Modes {
 public:
  Modes(int rollers, int threads)
      : rollers_(rollers),
        sums_(static_cast<std::size_t>(rollers / 2 + 1), Eigen::MatrixXd::Zero(threads, threads)) {}

  int of(int harmonic) const {
    const int n = harmonic % rollers_;
    return std::min(n, rollers_ - n);
  }
  double weight(int mode) const { return 2 * mode % rollers_ == 0 ? rollers_ : 0.5 * rollers_; }
  void add(int harmonic, const Eigen::MatrixXd& g) {
    sum(of(harmonic)) += weight(of(harmonic)) * g;
  }
  Eigen::MatrixXd& sum(int mode) { return sums_[static_cast<std::size_t>(mode)]; }
  int count() const { return static_cast<int>(sums_.size()); }

 private:
  int rollers_;
  std::vector<Eigen::MatrixXd> sums_;
};

/// A block's response at every thread.
Eigen::MatrixXd along_threads(const BlockResponse& r, int threads) {
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(threads, threads);
  for (int d = -r.reach; d <= r.reach; ++d)
    for (int j = std::max(0, -d); j < std::min(threads, threads - d); ++j)
      g(j + d, j) = r.kernel[static_cast<std::size_t>(d + r.reach)](0, 0);
  return 0.5 * (g + g.transpose());
}

/// What is left of a mode beyond the harmonic `last`, two combs of period N.
double left_out(const HertzPatch& patch, const Material& material, double radius, int mode,
                int rollers, int last) {
  double sum = 0.0;
  for (const int first : {mode, rollers - mode}) {
    int n = first;
    while (n <= last) n += rollers;
    sum += 0.5 * half_space_remainder(patch, material, std::max(n - 0.5 * rollers, 0.0) / radius);
  }
  return sum;
}

MatrixCache::Matrices unlike_modes(const UnlikeLoads& given) {
  const Teeth& t = given.teeth;
  const HertzPatch& patch = t.types.front().patch;
  const int last =
      static_cast<int>(t.options.largest_wave * t.groove.pitch_radius / patch.along_circumference);
  const GroovedBody body = given.body.body.meshed();
  const fe::Isotropic material = isotropic(t.material);
  const auto threads = static_cast<Index>(t.contacts);
  Modes modes(t.first, t.contacts);

  std::vector<fe::HarmonicSupport> clamped;
  for (const int node : held_nodes(body, given.body))
    for (const Component c : {Component::radial, Component::circumferential, Component::axial})
      clamped.push_back({node, c});
  Eigen::MatrixXd loads(fe::kComponents * body.mesh.size(),
                        threads + static_cast<Index>(given.sections.size()));
  loads.leftCols(threads) = patch_loads(body, 1);
  for (std::size_t k = 0; k < given.sections.size(); ++k)
    loads.col(threads + static_cast<Index>(k)) =
        transverse_force(body, body.section(given.sections[k]));
  fe::HarmonicBody bent(body.mesh, material, 1, clamped);
  const Eigen::MatrixXd first = flexibility_of(bent, 1, loads);
  modes.add(1, first.topLeftCorner(threads, threads));

  const int whole = std::min(given.whole, last);
  if (whole >= 2) {
    fe::HarmonicBody oval(body.mesh, material, 2);
    for (int n = 2; n <= whole; ++n)
      if (modes.of(n) != 0) modes.add(n, flexibility_of(oval, n, patch_loads(body, n)));
  }
  BlockSolver block(t.groove, t.far_radius, t.material, t.types, t.options);
  for (int n = whole + 1; n <= last; ++n)
    if (modes.of(n) != 0)
      modes.add(n, along_threads(block.solve(n, block.reach(n, t.contacts - 1)), t.contacts));

  const double own = half_space_compliance(patch, t.material);
  MatrixCache::Matrices matrices;
  for (int m = 1; m < modes.count(); ++m) {
    modes.sum(m).diagonal().array() +=
        left_out(patch, t.material, t.groove.pitch_radius, m, t.first, last) - own;
    matrices.push_back(std::move(modes.sum(m)));
  }
  matrices.push_back(first.topRightCorner(threads, first.cols() - threads));
  matrices.push_back(first.bottomRightCorner(first.cols() - threads, first.cols() - threads));
  return matrices;
}

FlexibilityAround around(UnlikeLoads given, const Flexibility& alike, MatrixCache& cache) {
  GroovedShape& shape = given.body.body.shape;
  shape.sections.insert(shape.sections.end(), given.sections.begin(), given.sections.end());
  const auto kept = cached(cache, "unlike loads", given, unlike_modes);
  FlexibilityAround f;
  f.modes.push_back(alike.matrix);
  f.modes.insert(f.modes.end(), kept->begin(), kept->end() - 2);
  f.coupling = *(kept->end() - 2);
  f.sections = kept->back();
  return f;
}

}  // namespace

Eigen::MatrixXd FlexibilityAround::between(int spacings, int rollers) const {
  Eigen::MatrixXd g = modes.front();
  for (std::size_t m = 1; m < modes.size(); ++m) {
    const auto order = static_cast<double>(m);
    const double weight = 2 * static_cast<int>(m) == rollers ? 1.0 : 2.0;
    g += weight * std::cos(2.0 * std::numbers::pi * order * spacings / rollers) * modes[m];
  }
  return g / rollers;
}

FlexibilityAround screw_around(const BodyGeometry& b, Direction direction,
                               const std::vector<double>& sections,
                               const FlexibilityOptions& options, MatrixCache& cache) {
  const LoadedBody body = loaded_screw(b, direction, options);
  return around(
      {{body, body.shape.start, false}, teeth_of(b, Part::screw, direction, options), sections, 1},
      screw_flexibility(b, direction, options, cache), cache);
}

FlexibilityAround nut_around(const BodyGeometry& b, Direction direction, double position,
                             const std::vector<double>& sections, const FlexibilityOptions& options,
                             MatrixCache& cache) {
  return around({held_nut(b, direction, position, options),
                 teeth_of(b, Part::nut, direction, options), sections, kWholeNut},
                nut_flexibility(b, direction, position, options, cache), cache);
}

}  // namespace prs
