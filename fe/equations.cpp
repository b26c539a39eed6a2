#include "fe/equations.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "fe/cholesky.h"
#include "fe/index.h"

namespace fe {
namespace {

using Column = std::vector<int>;

int global(int node, Dof dof) { return kDofsPerNode * node + static_cast<int>(dof); }

/// Freedoms of a beam or a shell.
template <class Element>
std::array<int, 6> globals(const Element& e) {
  return {global(e.first, Dof::u),  global(e.first, Dof::v),  global(e.first, Dof::theta),
          global(e.second, Dof::u), global(e.second, Dof::v), global(e.second, Dof::theta)};
}

/// Calls visit(freedom, coefficient) for the approach of a spring as a linear form.
template <class Visit>
void for_each_coefficient(const SpringElement& e, Visit visit) {
  const auto end = [&](const RigidArm& arm, double sign) {
    visit(global(arm.node, Dof::u), sign * e.nx);
    visit(global(arm.node, Dof::v), sign * e.ny);
    visit(global(arm.node, Dof::theta), sign * (e.ny * arm.dx - e.nx * arm.dy));
  };
  end(e.from, 1.0);
  end(e.to, -1.0);
}

SparseSymmetric compress(std::vector<Column> columns) {
  SparseSymmetric m;
  m.column_start.push_back(0);
  for (Column& column : columns) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    m.row.insert(m.row.end(), column.begin(), column.end());
    m.column_start.push_back(static_cast<int>(m.row.size()));
  }
  m.value.assign(m.row.size(), 0.0);
  return m;
}

/// Pattern of the upper triangle over the equations that `number` gives to the freedoms.
SparseSymmetric pattern_of(const Model& model, const std::vector<int>& number, int size) {
  std::vector<Column> columns(static_cast<std::size_t>(size));
  const auto couple = [&](const auto& freedoms) {
    for (const int a : freedoms)
      for (const int b : freedoms) {
        const int i = at(number, a), j = at(number, b);
        if (i >= 0 && j >= 0 && i <= j) at(columns, j).push_back(i);
      }
  };
  for (int i = 0; i < size; ++i) at(columns, i).push_back(i);
  for (const BarElement& e : model.bars)
    couple(std::array{global(e.first, Dof::u), global(e.second, Dof::u)});
  for (const BeamElement& e : model.beams) couple(globals(e));
  for (const ShellElement& e : model.shells) couple(globals(e));
  for (const SpringElement& e : model.springs) {
    std::vector<int> freedoms;
    for_each_coefficient(e, [&](int freedom, double) { freedoms.push_back(freedom); });
    couple(freedoms);
  }
  return compress(std::move(columns));
}

void add_to(Eigen::VectorXd& r, int equation, double value) {
  if (equation >= 0) r[equation] += value;
}

}  // namespace

Equations::Equations(const Model& model) {
  number_freedoms(model);
  linear_ = pattern_of(model, number_, size());
  add_linear_elements(model);
  add_springs(model);
}

void Equations::number_freedoms(const Model& model) {
  constexpr int kOut = -1, kFree = 0;
  number_.assign(static_cast<std::size_t>(kDofsPerNode * model.nodes), kOut);
  const auto activate = [&](int freedom) { at(number_, freedom) = kFree; };
  for (const BarElement& e : model.bars) {
    activate(global(e.first, Dof::u));
    activate(global(e.second, Dof::u));
  }
  for (const BeamElement& e : model.beams)
    for (const int freedom : globals(e)) activate(freedom);
  for (const ShellElement& e : model.shells)
    for (const int freedom : globals(e)) activate(freedom);
  for (const ElasticSupport& s : model.elastic_supports) activate(global(s.node, s.dof));
  for (const FixedSupport& s : model.fixed_supports) at(number_, global(s.node, s.dof)) = kOut;

  int size = 0;
  for (int& n : number_)
    if (n == kFree) n = size++;

  const std::vector<int> order = fill_reducing_order(pattern_of(model, number_, size));
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) at(place, order[k]) = static_cast<int>(k);

  kind_.resize(order.size());
  for (std::size_t freedom = 0; freedom < number_.size(); ++freedom) {
    int& n = number_[freedom];
    if (n < 0) continue;
    n = at(place, n);
    at(kind_, n) = static_cast<Dof>(freedom % kDofsPerNode);
  }
}

void Equations::add_linear_elements(const Model& model) {
  const auto numbered = [&](int freedom) { return at(number_, freedom); };
  const auto add = [&](int i, int j, double value) {
    if (i >= 0 && j >= 0) at(linear_.value, slot(i, j)) += value;
  };
  for (const BarElement& e : model.bars) {
    const int i = number(e.first, Dof::u), j = number(e.second, Dof::u);
    const double k = e.bar.stiffness();
    bars_.push_back({{i, j}, k});
    add(i, i, k);
    add(j, j, k);
    add(i, j, -k);
  }
  const auto add_all = [&](const std::array<int, 6>& equation, const BeamMatrix& k) {
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j)
        add(equation[i], equation[j],
            k(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  };
  for (const BeamElement& e : model.beams) {
    NumberedBeam beam{globals(e), e.beam};
    for (int& freedom : beam.equation) freedom = numbered(freedom);
    add_all(beam.equation, stiffness_matrix(e.beam));
    beams_.push_back(beam);
  }
  for (const ShellElement& e : model.shells) {
    NumberedShell shell{globals(e), e.stiffness};
    for (int& freedom : shell.equation) freedom = numbered(freedom);
    add_all(shell.equation, nodal_stiffness(e.stiffness));
    shells_.push_back(shell);
  }
  for (const ElasticSupport& s : model.elastic_supports) {
    const int i = number(s.node, s.dof);
    supports_.push_back({i, s.stiffness});
    add(i, i, s.stiffness);
  }
}

void Equations::add_springs(const Model& model) {
  springs_.reserve(model.springs.size());
  for (const SpringElement& e : model.springs) {
    Spring s;
    s.law = e.law;
    for_each_coefficient(e, [&](int freedom, double coefficient) {
      const int n = at(number_, freedom);
      if (n < 0 || coefficient == 0.0) return;
      s.equation[s.count] = n;
      s.coefficient[s.count] = coefficient;
      ++s.count;
    });
    std::size_t next = 0;
    for (std::size_t i = 0; i < s.count; ++i)
      for (std::size_t j = i; j < s.count; ++j) s.slot[next++] = slot(s.equation[i], s.equation[j]);
    springs_.push_back(s);
  }
}

int Equations::slot(int i, int j) const {
  if (i > j) std::swap(i, j);
  const auto begin = linear_.row.begin() + at(linear_.column_start, j);
  const auto end = linear_.row.begin() + at(linear_.column_start, j + 1);
  const auto found = std::lower_bound(begin, end, i);
  assert(found != end && *found == i);
  return static_cast<int>(found - linear_.row.begin());
}

Eigen::VectorXd Equations::load_vector(const std::vector<NodalLoad>& loads) const {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(size());
  for (const NodalLoad& load : loads) {
    const int i = number(load.node, load.dof);
    if (i >= 0) f[i] += load.value;
  }
  return f;
}

double Equations::Spring::approach(const State& q) const {
  double w = 0.0;
  for (std::size_t i = 0; i < count; ++i) w += coefficient[i] * q.head[equation[i]];
  for (std::size_t i = 0; i < count; ++i) w += coefficient[i] * q.tail[equation[i]];
  return w;
}

double Equations::approach(const State& q, int k) const { return at(springs_, k).approach(q); }

double Equations::energy_and_residual(const State& q, const Eigen::VectorXd& f,
                                      Eigen::VectorXd& residual) const {
  residual.setZero();
  for (const NumberedBar& bar : bars_) {
    const auto [i, j] = bar.equation;
    const double tension = bar.stiffness * q.difference(i, j);
    add_to(residual, i, -tension);
    add_to(residual, j, tension);
  }
  for (const NumberedBeam& b : beams_) {
    const auto& [u1, v1, t1, u2, v2, t2] = b.equation;
    const BeamVector forces = end_forces(
        b.beam, {q.difference(u1, u2), q.difference(v1, v2), q[t1], q[t2], q.rest(t1), q.rest(t2)});
    for (std::size_t i = 0; i < 6; ++i)
      add_to(residual, b.equation[i], forces[static_cast<Eigen::Index>(i)]);
  }
  for (const NumberedShell& s : shells_) {
    const auto& [u1, v1, t1, u2, v2, t2] = s.equation;
    const auto mean = [&](int i, int j) {
      return 0.5 * (q[i] + q[j]) + 0.5 * (q.rest(i) + q.rest(j));
    };
    const BeamVector forces =
        end_forces(s.stiffness, {q.difference(u1, u2), q.difference(v1, v2), q.difference(t1, t2),
                                 mean(v1, v2), mean(t1, t2)});
    for (std::size_t i = 0; i < 6; ++i)
      add_to(residual, s.equation[i], forces[static_cast<Eigen::Index>(i)]);
  }
  for (const NumberedSupport& s : supports_)
    add_to(residual, s.equation, s.stiffness * q[s.equation]);
  double energy = q.head.dot(0.5 * residual - f);
  residual -= f;
  for (const Spring& s : springs_) {
    const SpringResponse r = evaluate(s.law, s.approach(q));
    energy += r.energy;
    for (std::size_t i = 0; i < s.count; ++i) residual[s.equation[i]] += r.force * s.coefficient[i];
  }
  return energy;
}

Eigen::VectorXd Equations::rounding_residual(const State& q) const {
  Eigen::VectorXd r = Eigen::VectorXd::Zero(size());
  for (int j = 0; j < size(); ++j)
    for (int k = at(linear_.column_start, j); k < at(linear_.column_start, j + 1); ++k) {
      const int i = at(linear_.row, k);
      const double value = std::abs(at(linear_.value, k));
      r[i] += value * std::abs(q[j]);
      if (i != j) r[j] += value * std::abs(q[i]);
    }
  for (const Spring& s : springs_) {
    double w = 0.0;
    for (std::size_t i = 0; i < s.count; ++i) w += std::abs(s.coefficient[i] * q[s.equation[i]]);
    const double force = evaluate(s.law, s.approach(q)).tangent * w;
    for (std::size_t i = 0; i < s.count; ++i)
      r[s.equation[i]] += force * std::abs(s.coefficient[i]);
  }
  return std::numeric_limits<double>::epsilon() * r;
}

void Equations::tangent_stiffness(const State& q, SparseSymmetric& tangent) const {
  std::copy(linear_.value.begin(), linear_.value.end(), tangent.value.begin());
  for (const Spring& s : springs_) {
    const double k = evaluate(s.law, s.approach(q)).tangent;
    std::size_t next = 0;
    for (std::size_t i = 0; i < s.count; ++i) {
      const double row = k * s.coefficient[i];
      for (std::size_t j = i; j < s.count; ++j)
        at(tangent.value, s.slot[next++]) += row * s.coefficient[j];
    }
  }
}

}  // namespace fe
