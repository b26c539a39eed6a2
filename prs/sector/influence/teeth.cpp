#include "prs/sector/influence/flexibility.h"

namespace prs {
namespace {

using Eigen::Index;

MatrixCache::Matrices packed(const TeethFlexibility& t) {
  MatrixCache::Matrices m{t.half_space, t.remainder};
  m.insert(m.end(), t.response.kernel.begin(), t.response.kernel.end());
  return m;
}

/// As `unpacked` reads them.
bool are_packed(const Teeth& t, const MatrixCache::Matrices& m) {
  const auto count = static_cast<Index>(t.types.size());
  const auto is_kernel = [&](const Eigen::MatrixXd& k) {
    return k.rows() == count && k.cols() == count;
  };
  return m.size() % 2 == 1 && m.size() >= 3 && have_sizes({m[0], m[1]}, {{count, 1}, {count, 1}}) &&
         std::all_of(m.begin() + 2, m.end(), is_kernel);
}

TeethFlexibility unpacked(const MatrixCache::Matrices& m) {
  TeethFlexibility t;
  t.half_space = m[0];
  t.remainder = m[1];
  t.response.kernel.assign(m.begin() + 2, m.end());
  t.response.reach = (static_cast<int>(t.response.kernel.size()) - 1) / 2;
  return t;
}

MatrixCache::Matrices compute(const Teeth& t) {
  BlockSolver block(t.groove, t.far_radius, t.material, t.types, t.options);
  const double radius = t.groove.pitch_radius;
  double widest = 0.0;
  for (const LoadedFlank& flank : t.types)
    widest = std::max(widest, flank.patch.along_circumference);
  const double last = t.options.largest_wave * radius / widest;
  const auto count = static_cast<Index>(t.types.size());

  TeethFlexibility f;
  int n = t.first;
  f.response.reach = block.reach(n, t.contacts - 1);
  f.response.kernel.assign(static_cast<std::size_t>(2 * f.response.reach + 1),
                           Eigen::MatrixXd::Zero(count, count));
  for (; n <= last; n += t.step) {
    const BlockResponse r = block.solve(n, block.reach(n, t.contacts - 1));
    for (int d = -r.reach; d <= r.reach; ++d)
      for (Index a = 0; a < count; ++a)
        for (Index b = 0; b < count; ++b) {
          const bool turned =
              t.opposite[static_cast<std::size_t>(a)] != t.opposite[static_cast<std::size_t>(b)];
          f.response.kernel[static_cast<std::size_t>(d + f.response.reach)](a, b) +=
              (turned && n % 2 == 1 ? -t.step : t.step) *
              r.kernel[static_cast<std::size_t>(d + r.reach)](a, b);
        }
  }
  f.half_space.resize(count);
  f.remainder.resize(count);
  for (Index a = 0; a < count; ++a) {
    const HertzPatch& patch = t.types[static_cast<std::size_t>(a)].patch;
    f.half_space[a] = half_space_compliance(patch, t.material);
    f.remainder[a] = half_space_remainder(patch, t.material, (n - 0.5 * t.step) / radius);
  }
  return packed(f);
}

}  // namespace

TeethFlexibility teeth_flexibility(const Teeth& t, MatrixCache& cache) {
  return unpacked(*cached(cache, "teeth", t, compute, are_packed));
}

void add_teeth(const TeethFlexibility& f, const Teeth& t, bool centred, Eigen::MatrixXd& matrix) {
  const int reach = f.response.reach, contacts = t.contacts;
  const auto kernel = [&](int d, Index a, Index b) {
    return std::abs(d) > reach ? 0.0 : f.response.kernel[static_cast<std::size_t>(d + reach)](a, b);
  };
  // Half pitches by which the flank of one type lies before that of another on the same ridge.
  const auto ahead = [&](Index a, Index b) {
    const FlankSide of_a = t.types[static_cast<std::size_t>(a)].side;
    const FlankSide of_b = t.types[static_cast<std::size_t>(b)].side;
    return static_cast<int>(0.5 * (sign(of_a) - sign(of_b)));
  };
  const auto count = static_cast<Index>(t.types.size());
  for (Index a = 0; a < count; ++a)
    for (Index b = 0; b < count; ++b)
      for (int d = -reach - 1; d <= reach + 1; ++d) {
        const double value =
            centred ? 0.5 * (kernel(d, a, b) + kernel(d - ahead(a, b), a, b)) : kernel(d, a, b);
        for (int j = std::max(0, -d); j < std::min(contacts, contacts - d); ++j)
          matrix(a * contacts + j + d, b * contacts + j) += value;
      }
  for (Index a = 0; a < count; ++a)
    matrix.diagonal().segment(a * contacts, contacts).array() += f.remainder[a] - f.half_space[a];
  matrix = 0.5 * (matrix + matrix.transpose()).eval();
}

BlockSolver::BlockSolver(const Groove& groove, double far_radius, const Material& material,
                         const std::vector<LoadedFlank>& flanks, const FlexibilityOptions& options)
    : groove_(groove),
      far_radius_(far_radius),
      material_(isotropic(material)),
      flanks_(flanks),
      options_(options) {}

int BlockSolver::reach(int harmonic, int largest) const {
  // Harmonic n decays as exp(-n x/r) or faster along a body of outer radius r.
  const double radius = std::max(far_radius_, groove_.pitch_radius);
  const double length = -std::log(options_.block_tolerance) * radius / harmonic;
  return std::min(largest, static_cast<int>(std::ceil(length / groove_.pitch)));
}

BlockResponse BlockSolver::solve(int harmonic, int reach) {
  const auto types = static_cast<Index>(flanks_.size());
  if (reach != reach_) {
    GroovedShape shape;
    shape.groove = groove_;
    shape.far_radius = far_radius_;
    shape.start = -(reach + 0.5) * groove_.pitch;
    shape.end = (reach + 0.5) * groove_.pitch;
    std::vector<LoadedFlank> flanks;
    for (int d = -reach; d <= reach; ++d)
      for (LoadedFlank f : flanks_) {
        f.ridge = d * groove_.pitch;
        if (d != 0) f.patch_cells = options_.neighbour_patch_cells;
        flanks.push_back(f);
      }
    body_ = mesh_grooved_body(shape, flanks, options_.mesh);
    solver_ = std::make_unique<fe::HarmonicBody>(body_.mesh, material_, harmonic);
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
