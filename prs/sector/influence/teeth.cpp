#include "prs/sector/influence/teeth.h"

#include "prs/indices.h"

namespace prs {
namespace {

using Eigen::Index;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Whether the matrices are, for each type of contacts, its half-space part and the harmonics left out [m/N], then the
/// response at the ridges around a loaded one, summed over the harmonics, by types.
bool are_teeth(const Teeth& t, const MatrixCache::Matrices& m) {
  const auto count = static_cast<Index>(t.types.size());
  const auto is_kernel = [&](const Eigen::MatrixXd& k) { return k.rows() == count && k.cols() == count; };
  return m.size() % 2 == 1 && m.size() >= 3 && have_sizes({m[0], m[1]}, {{count, 1}, {count, 1}}) &&
         std::all_of(m.begin() + 2, m.end(), is_kernel);
}

MatrixCache::Matrices compute(const Teeth& t) {
  BlockSolver block(t);
  const double radius = t.groove.pitch_radius;
  double widest = 0.0;
  for (const LoadedFlank& flank : t.types) widest = std::max(widest, flank.patch.along_circumference);
  const double last = t.options.largest_wave * radius / widest;
  const auto count = static_cast<Index>(t.types.size());
  int n = t.first;
  const int reach = block.reach(n);
  MatrixCache::Matrices m(at(2 * reach + 3), Eigen::MatrixXd::Zero(count, count));
  for (; n <= last; n += t.step) {
    const BlockResponse r = block.solve(n, block.reach(n));
    for (int d = -r.reach; d <= r.reach; ++d)
      for (Index a = 0; a < count; ++a)
        for (Index b = 0; b < count; ++b) {
          const bool turned = item_at(t.opposite, a) != item_at(t.opposite, b);
          m[at(2 + d + reach)](a, b) += (turned && n % 2 == 1 ? -t.step : t.step) * r.kernel[at(d + r.reach)](a, b);
        }
  }
  m[0].resize(count, 1);
  m[1].resize(count, 1);
  for (Index a = 0; a < count; ++a) {
    const HertzPatch& patch = item_at(t.types, a).patch;
    m[0](a) = half_space_compliance(patch, t.material);
    m[1](a) = half_space_remainder(patch, t.material, (n - 0.5 * t.step) / radius);
  }
  return m;
}

}  // namespace

void add_teeth(Flexibility& f, const Teeth& t, bool centred, MatrixCache& cache) {
  const auto teeth = cached(cache, "teeth", t, compute, are_teeth);
  const MatrixCache::Matrices& m = *teeth;
  const int reach = static_cast<int>(m.size() - 3) / 2, contacts = t.contacts;
  const auto kernel = [&](int d, Index a, Index b) { return std::abs(d) > reach ? 0.0 : m[at(2 + d + reach)](a, b); };
  // Number of half pitches by which the flank of one type lies before that of another on the same ridge.
  const auto ahead = [&](Index a, Index b) {
    const FlankSide of_a = item_at(t.types, a).side;
    const FlankSide of_b = item_at(t.types, b).side;
    return static_cast<int>(0.5 * (sign(of_a) - sign(of_b)));
  };
  const auto count = static_cast<Index>(t.types.size());
  for (Index a = 0; a < count; ++a)
    for (Index b = 0; b < count; ++b)
      for (int d = -reach - 1; d <= reach + 1; ++d) {
        const double value = centred ? 0.5 * (kernel(d, a, b) + kernel(d - ahead(a, b), a, b)) : kernel(d, a, b);
        for (int j = std::max(0, -d); j < std::min(contacts, contacts - d); ++j)
          f.matrix(a * contacts + j + d, b * contacts + j) += value;
      }
  for (Index a = 0; a < count; ++a) f.matrix.diagonal().segment(a * contacts, contacts).array() += m[1](a) - m[0](a);
  f.matrix = 0.5 * (f.matrix + f.matrix.transpose()).eval();
  f.half_space = m[0](0);
}

int BlockSolver::reach(int harmonic) const {
  // Harmonic n decays as exp(-n x/r) or faster along a body of outer radius r.
  const double radius = std::max(teeth_.far_radius, teeth_.groove.pitch_radius);
  const double length = -std::log(teeth_.options.block_tolerance) * radius / harmonic;
  return std::min(teeth_.contacts - 1, static_cast<int>(std::ceil(length / teeth_.groove.pitch)));
}

BlockResponse BlockSolver::solve(int harmonic, int reach) {
  const auto types = static_cast<Index>(teeth_.types.size());
  if (reach != reach_) {
    GroovedShape shape;
    shape.groove = teeth_.groove;
    shape.far_radius = teeth_.far_radius;
    shape.start = -(reach + 0.5) * teeth_.groove.pitch;
    shape.end = (reach + 0.5) * teeth_.groove.pitch;
    std::vector<LoadedFlank> flanks;
    for (int d = -reach; d <= reach; ++d)
      for (LoadedFlank f : teeth_.types) {
        f.ridge = d * teeth_.groove.pitch;
        if (d != 0) f.patch_cells = teeth_.options.neighbour_patch_cells;
        flanks.push_back(f);
      }
    body_ = mesh_grooved_body(shape, flanks, teeth_.options.mesh);
    solver_ = std::make_unique<fe::HarmonicBody>(body_.mesh, isotropic(teeth_.material), harmonic);
    reach_ = reach;
  }
  factorize(*solver_, harmonic);
  const Eigen::MatrixXd loads = patch_loads(body_, harmonic);
  const Eigen::MatrixXd displacement = solver_->solve(loads.middleCols(reach * types, types));
  BlockResponse r;
  r.reach = reach;
  for (int d = 0; d <= 2 * reach; ++d)
    r.kernel.push_back(loads.middleCols(d * types, types).transpose() * displacement);
  return r;
}

}  // namespace prs
