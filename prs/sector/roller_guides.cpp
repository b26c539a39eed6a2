#include "prs/sector/roller_guides.h"

#include <Eigen/SparseCholesky>

#include "prs/indices.h"

namespace prs {
namespace {

using Eigen::MatrixXd;
using fe::NodalLoad;

using fe::Dof;

/// The roller of a sector as a beam over (v, theta) of its nodes, in order.
class RollerBeam {
 public:
  explicit RollerBeam(const Sector& s)
      : first_(s.roller_end_nodes.front()), size_(2 * (s.roller_end_nodes.back() - first_ + 1)) {
    MatrixXd k = MatrixXd::Zero(size_, size_);
    for (const fe::BeamElement& b : s.model.beams) {
      const Eigen::Matrix<double, 6, 6> of = fe::stiffness_matrix(b.beam);
      const int from[] = {1, 2, 4, 5};
      const int to[] = {at(b.first, Dof::v), at(b.first, Dof::theta), at(b.second, Dof::v), at(b.second, Dof::theta)};
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) k(to[i], to[j]) += of(from[i], from[j]);
    }
    // A rigid guide imposes the shape.
    shapes_ = MatrixXd::Zero(size_, 2);
    MatrixXd loads = shapes_;
    std::vector<bool> held(static_cast<std::size_t>(size_), false);
    const auto end_of = [&](int node) {
      return node == s.roller_end_nodes[0] || node == s.roller_end_nodes[1] ? 0 : 1;
    };
    const auto is_roller = [&](int node) { return node >= first_ && at(node, Dof::v) < size_; };
    for (const fe::FixedSupport& support : s.model.fixed_supports)
      if (is_roller(support.node)) {
        const int v = at(support.node, support.dof);
        item_at(held, v) = true;
        shapes_(v, end_of(support.node)) = 1.0;
      }
    for (const fe::ElasticSupport& support : s.model.elastic_supports) {
      const int v = at(support.node, support.dof);
      k(v, v) += support.stiffness;
      loads(v, end_of(support.node)) += support.stiffness;
    }
    loads -= k * shapes_;
    std::vector<int> free;
    for (int i = 0; i < size_; ++i)
      if (!item_at(held, i)) free.push_back(i);
    const Eigen::SparseMatrix<double> banded = MatrixXd(k(free, free)).sparseView();
    const MatrixXd found =
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>(banded).solve(
            MatrixXd(loads(free, Eigen::all)));
    for (const auto i : indices(free)) shapes_.row(free[i]) = found.row(static_cast<Eigen::Index>(i));
  }

  double shape(int end, int node, Dof dof) const { return shapes_(at(node, dof), end); }

 private:
  int at(int node, Dof dof) const { return 2 * (node - first_) + (dof == Dof::v ? 0 : 1); }

  int first_, size_;
  MatrixXd shapes_;  ///< One column for each end.
};

void add_force(std::vector<NodalLoad>& loads, const fe::RigidArm& at, double x, double y) {
  loads.push_back({at.node, Dof::u, x});
  loads.push_back({at.node, Dof::v, y});
  loads.push_back({at.node, Dof::theta, at.dx * y - at.dy * x});
}

/// Friction of thread k on the roller, and its reaction on screw or nut.
void add_friction(std::vector<NodalLoad>& loads, const Sector& s, const RollerPush& push, Interface i, int k) {
  const fe::SpringElement& spring = item_at(s.model.springs, s.spring(i, k));
  const double x = item_at(push.axial[i], k);
  const double y = item_at(push.radial[i], k);
  const double sense = i == Interface::screw ? -1.0 : 1.0;
  add_force(loads, spring.from, sense * x, sense * y);
  add_force(loads, spring.to, -sense * x, -sense * y);
}

void add_centrifugal(std::vector<NodalLoad>& loads, const Sector& s, const RollerPush& push) {
  for (const fe::BeamElement& b : s.model.beams)
    for (const int node : {b.first, b.second})
      loads.push_back({node, Dof::v, 0.5 * b.beam.length * (is_head(s, b) ? push.of_heads : push.of_thread)});
}

}  // namespace

RollerGuides::RollerGuides(const Sector& s) : sense_(s.sense), cosine_(s.cosine), sine_(s.sine) {
  const RollerBeam beam(s);
  for (int h = 0; h < 2; ++h) {
    End& end = item_at(ends_, h);
    for (const Interface i : kInterfaces)
      for (int k = 0; k < s.contacts(); ++k) {
        const fe::SpringElement& spring = item_at(s.model.springs, s.spring(i, k));
        const fe::RigidArm& at = i == Interface::screw ? spring.to : spring.from;
        end.threads[i].push_back({beam.shape(h, at.node, Dof::v), -at.dy * beam.shape(h, at.node, Dof::theta)});
      }
    for (const fe::BeamElement& b : s.model.beams) {
      double& integral = is_head(s, b) ? end.of_heads : end.of_thread;
      integral += 0.5 * b.beam.length * (beam.shape(h, b.first, Dof::v) + beam.shape(h, b.second, Dof::v));
    }
  }
}

std::array<double, 2> RollerGuides::forces(const PerInterface<std::vector<double>>& normal_load,
                                           const RollerPush& push) const {
  std::array<double, 2> r{};
  for (const auto h : up_to(2)) {
    const End& end = ends_[h];
    r[h] = -(end.of_thread * push.of_thread + end.of_heads * push.of_heads);
    for (const Interface i : kInterfaces) {
      // The screw pushes outwards, the nut inwards.
      const double side = i == Interface::screw ? 1.0 : -1.0;
      for (const auto k : indices(end.threads[i])) {
        const At& phi = end.threads[i][k];
        const double x = side * sense_ * cosine_[i] * normal_load[i][k] + push.axial[i][k];
        const double y = side * sine_[i] * normal_load[i][k] + push.radial[i][k];
        r[h] -= y * phi.across + x * phi.along;
      }
    }
  }
  return r;
}

std::vector<NodalLoad> push_loads(const Sector& s, const RollerPush& push) {
  std::vector<NodalLoad> loads;
  for (const Interface i : kInterfaces)
    for (int k = 0; k < s.contacts(); ++k) add_friction(loads, s, push, i, k);
  add_centrifugal(loads, s, push);
  return loads;
}

fe::FollowingLoad turned_loads(const SectorSolver& solver, double axial_force, const RollerPush& per_normal_load) {
  const Sector& s = solver.sector();
  const fe::Equations& equations = solver.equations();
  std::vector<NodalLoad> centrifugal;
  add_centrifugal(centrifugal, s, per_normal_load);
  std::vector<std::vector<NodalLoad>> loads(equations.springs().size());
  for (std::vector<NodalLoad>& one : loads) one.reserve(6);
  for (const Interface i : kInterfaces)
    for (int k = 0; k < s.contacts(); ++k) add_friction(item_at(loads, s.spring(i, k)), s, per_normal_load, i, k);
  return {equations, axial_force / s.rollers * solver.unit_load() + equations.load_vector(centrifugal), loads};
}

}  // namespace prs
