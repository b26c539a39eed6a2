#include "prs/sector/influence/flexibility_around.h"

#include "prs/indices.h"
#include "prs/sector/influence/teeth.h"

namespace prs {
namespace {

using Eigen::MatrixXd;

using Eigen::Index;
using fe::Component;

/// Highest harmonic computed on the whole nut, beyond its rollers.
constexpr int kWholeNut = 6;

/// All inputs of the harmonics from 2 on.
struct UnlikeLoads {
  HeldNut body;  ///< The nut, or the screw, which is held at its start.
  Teeth teeth;
  int whole = 1;  ///< Highest harmonic on the whole body.
};
PRS_MEMBERS(UnlikeLoads, body, teeth, whole)

/// All inputs of harmonic 1.
struct ClampedBody {
  HeldNut body;
  std::vector<double> sections;
};
PRS_MEMBERS(ClampedBody, body, sections)

/// Sums of harmonics, one for each mode.
class Modes {
 public:
  Modes(int rollers, int threads)
      : rollers_(rollers), sums_(static_cast<std::size_t>(rollers / 2 + 1), MatrixXd::Zero(threads, threads)) {}

  int of(int harmonic) const {
    const int n = harmonic % rollers_;
    return std::min(n, rollers_ - n);
  }
  double weight(int mode) const { return 2 * mode % rollers_ == 0 ? rollers_ : 0.5 * rollers_; }
  void add(int harmonic, const MatrixXd& g) { sum(of(harmonic)) += weight(of(harmonic)) * g; }
  MatrixXd& sum(int mode) { return item_at(sums_, mode); }
  int count() const { return static_cast<int>(sums_.size()); }

 private:
  int rollers_;
  std::vector<MatrixXd> sums_;
};

/// Response of a block at every thread.
MatrixXd along_threads(const BlockResponse& r, int threads) {
  MatrixXd g = MatrixXd::Zero(threads, threads);
  for (int d = -r.reach; d <= r.reach; ++d)
    for (int j = std::max(0, -d); j < std::min(threads, threads - d); ++j)
      g(j + d, j) = item_at(r.kernel, d + r.reach)(0, 0);
  return 0.5 * (g + g.transpose());
}

/// Contribution of the harmonics beyond `last` to mode m: n = m + q N and n = N - m + q N.
double left_out(const HertzPatch& patch, const Material& material, double radius, int mode, int rollers, int last) {
  double sum = 0.0;
  for (const int first : {mode, rollers - mode}) {
    int n = first;
    while (n <= last) n += rollers;
    sum += 0.5 * half_space_remainder(patch, material, std::max(n - 0.5 * rollers, 0.0) / radius);
  }
  return sum;
}

/// Harmonic 1 of a clamped body: threads by threads, threads by sections, sections by sections.
MatrixCache::Matrices bent_around(const ClampedBody& given) {
  const LoadedBody& loaded = given.body.body;
  const GroovedBody body = loaded.meshed();
  const auto threads = static_cast<Index>(loaded.flanks.size());
  const auto ends = 2 * static_cast<Index>(given.sections.size());
  std::vector<fe::HarmonicSupport> clamped;
  for (const int node : held_nodes(body, given.body))
    for (const Component c : {Component::radial, Component::circumferential, Component::axial})
      clamped.push_back({node, c});
  MatrixXd loads(fe::kComponents * body.mesh.size(), threads + ends);
  loads.leftCols(threads) = patch_loads(body, 1);
  for (const auto k : indices(given.sections)) {
    const auto column = threads + 2 * static_cast<Index>(k);
    const std::vector<fe::MeridianEdge>& section = body.section(given.sections[k]);
    loads.col(column) = transverse_force(body, section);
    loads.col(column + 1) = turning_moment(body, section);
  }
  fe::HarmonicBody solver(body.mesh, isotropic(loaded.material), 1, clamped);
  const MatrixXd g = flexibility_of(solver, 1, loads);
  return {g.topLeftCorner(threads, threads), g.topRightCorner(threads, ends), g.bottomRightCorner(ends, ends)};
}

bool is_bent_around(const ClampedBody& given, const MatrixCache::Matrices& m) {
  const auto threads = static_cast<Index>(given.body.body.flanks.size());
  const auto ends = 2 * static_cast<Index>(given.sections.size());
  return have_sizes(m, {{threads, threads}, {threads, ends}, {ends, ends}});
}

MatrixCache::Matrices unlike_modes(const UnlikeLoads& given) {
  const Teeth& t = given.teeth;
  const HertzPatch& patch = t.types.front().patch;
  const int last = static_cast<int>(t.options.largest_wave * t.groove.pitch_radius / patch.along_circumference);
  Modes modes(t.first, t.contacts);
  const int whole = std::min(given.whole, last);
  if (whole >= 2) {
    const GroovedBody body = given.body.body.meshed();
    fe::HarmonicBody oval(body.mesh, isotropic(t.material), 2);
    for (int n = 2; n <= whole; ++n)
      if (modes.of(n) != 0) modes.add(n, flexibility_of(oval, n, patch_loads(body, n)));
  }
  BlockSolver block(t);
  for (int n = whole + 1; n <= last; ++n)
    if (modes.of(n) != 0) modes.add(n, along_threads(block.solve(n, block.reach(n)), t.contacts));

  const double own = half_space_compliance(patch, t.material);
  MatrixCache::Matrices matrices;
  for (int m = 1; m < modes.count(); ++m) {
    modes.sum(m).diagonal().array() += left_out(patch, t.material, t.groove.pitch_radius, m, t.first, last) - own;
    matrices.push_back(std::move(modes.sum(m)));
  }
  return matrices;
}

/// Whether there is one matrix for each mode except that of equal loads.
bool are_modes(const UnlikeLoads& given, const MatrixCache::Matrices& m) {
  const Index threads = given.teeth.contacts;
  return m.size() == static_cast<std::size_t>(given.teeth.first / 2) &&
         std::ranges::all_of(m, [&](const MatrixXd& mode) { return mode.rows() == threads && mode.cols() == threads; });
}

FlexibilityAround around(const UnlikeLoads& given, const std::vector<double>& sections, const Flexibility& alike,
                         MatrixCache& cache) {
  ClampedBody clamped{given.body, sections};
  std::vector<double>& columns = clamped.body.body.shape.sections;
  append(columns, sections);
  const auto first = cached(cache, "clamped body", clamped, bent_around, is_bent_around);
  const auto kept = cached(cache, "uneven loads", given, unlike_modes, are_modes);
  FlexibilityAround f;
  f.modes.push_back(alike.matrix);
  f.modes.insert(f.modes.end(), kept->begin(), kept->end());
  if (f.modes.size() > 1) f.modes[1] += Modes(given.teeth.first, given.teeth.contacts).weight(1) * (*first)[0];
  f.coupling = (*first)[1];
  f.sections = (*first)[2];
  return f;
}

/// Lateral displacement and slope at the distance `at` from the clamped end of a beam by a unit force and a unit moment
/// at the distance `from`.
Eigen::Matrix2d cantilever(const RollerSection<double>& beam, double at, double from) {
  const double s = std::min(at, from);
  Eigen::Matrix2d f;
  f << at * from * s - 0.5 * (at + from) * s * s + s * s * s / 3.0, at * s - 0.5 * s * s, from * s - 0.5 * s * s, s;
  f /= beam.bending;
  f(0, 0) += s / beam.shear;
  return f;
}

/// Moves loads on the last section of a body to their places behind it, on a beam.
void lengthen(FlexibilityAround& f, const RollerSection<double>& beam, const std::vector<double>& behind) {
  const auto sections = static_cast<Index>(behind.size());
  MatrixXd moved = MatrixXd::Identity(2 * sections, 2 * sections);
  for (Index k = 0; k < sections; ++k) moved(2 * k + 1, 2 * k) = item_at(behind, k);
  f.coupling *= moved;
  f.sections = moved.transpose() * f.sections * moved;
  for (Index i = 0; i < sections; ++i)
    for (Index j = 0; j < sections; ++j)
      f.sections.block<2, 2>(2 * i, 2 * j) += cantilever(beam, item_at(behind, i), item_at(behind, j));
}

}  // namespace

FlexibilityAround screw_around(const BodyGeometry& b, Direction direction, const std::vector<double>& sections,
                               const FlexibilityOptions& options, MatrixCache& cache) {
  const LoadedBody body = loaded_screw(b, direction, options);
  std::vector<double> within, behind;
  for (const double section : sections) {
    within.push_back(std::clamp(section, body.shape.start, body.shape.end));
    behind.push_back(std::max(section - body.shape.end, 0.0));
  }
  FlexibilityAround f = around({{body, body.shape.start, false}, teeth_of(b, Part::screw, direction, options), 1},
                               within, screw_flexibility(b, direction, options, cache), cache);
  lengthen(f, ring_rigidity(body.material, 2.0 * b.grooves.screw.pitch_radius, b.structure.screw.bore, true), behind);
  return f;
}

FlexibilityAround nut_around(const BodyGeometry& b, Direction direction, double position,
                             const std::vector<double>& sections, const FlexibilityOptions& options,
                             MatrixCache& cache) {
  return around({held_nut(b, direction, position, options), teeth_of(b, Part::nut, direction, options), kWholeNut},
                sections, nut_flexibility(b, direction, position, options, cache), cache);
}

}  // namespace prs
