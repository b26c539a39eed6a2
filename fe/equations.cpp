#include "fe/equations.h"

#include "fe/cholesky.h"
#include "fe/quad.h"
#include "fe/rounding.h"

namespace fe {
namespace {

using Eigen::VectorXd;

int global(int node, Dof dof) { return kDofsPerNode * node + static_cast<int>(dof); }

/// Freedoms of a beam or a shell.
template <class Element>
std::array<int, 6> globals(const Element& e) {
  return {global(e.first, Dof::u),  global(e.first, Dof::v),  global(e.first, Dof::theta),
          global(e.second, Dof::u), global(e.second, Dof::v), global(e.second, Dof::theta)};
}

/// The approach of a spring as a linear form.
LinearForm approach_of(const SpringElement& e) {
  LinearForm form;
  const auto end = [&](const RigidArm& arm, double sign) {
    form.push_back({arm.node, Dof::u, sign * e.nx});
    form.push_back({arm.node, Dof::v, sign * e.ny});
    form.push_back({arm.node, Dof::theta, sign * (e.ny * arm.dx - e.nx * arm.dy)});
  };
  end(e.from, 1.0);
  end(e.to, -1.0);
  return form;
}

/// Pattern of the upper triangle over the equations that `number` gives to the freedoms. A follower couples the free
/// freedoms that it depends on in the end.
SparseSymmetric pattern_of(const Model& model, const std::vector<int>& number, int size) {
  Places places;
  std::vector<int> coupled;
  const auto add_equations_of = [&](const auto& self, int freedom) -> void {
    const int n = at(number, freedom);
    if (n < size) return coupled.push_back(n);
    for (const Term& term : at(model.constraints, n - size).form) self(self, global(term.node, term.dof));
  };
  const auto couple = [&](const auto& freedoms) {
    coupled.clear();
    for (const int freedom : freedoms) add_equations_of(add_equations_of, freedom);
    for (const int i : coupled)
      for (const int j : coupled)
        if (i >= 0 && i <= j) places.add(i, j);
  };
  const auto couple_form = [&](const LinearForm& form) {
    std::vector<int> freedoms;
    for (const Term& term : form) freedoms.push_back(global(term.node, term.dof));
    couple(freedoms);
  };
  for (int i = 0; i < size; ++i) places.add(i, i);
  for (const BarElement& e : model.bars) couple(std::array{global(e.first, Dof::u), global(e.second, Dof::u)});
  for (const BeamElement& e : model.beams) couple(globals(e));
  for (const ShellElement& e : model.shells) couple(globals(e));
  for (const SpringElement& e : model.springs) couple_form(approach_of(e));
  for (const FormSpring& e : model.form_springs) couple_form(e.approach);
  for (const ElasticLink& e : model.elastic_links) couple_form(e.form);
  return places.compressed(size);
}

/// Freedoms joined by each part of a model, in order: equal for models that differ in numbers other than 0 only.
std::vector<int> shape_of(const Model& model) {
  std::vector<int> shape{model.nodes};
  const auto add = [&](const auto& parts, auto freedoms_of) {
    shape.push_back(static_cast<int>(parts.size()));
    for (const auto& part : parts) freedoms_of(part);
  };
  const auto ends = [&](const auto& e) { shape.insert(shape.end(), {e.first, e.second}); };
  const auto support = [&](const auto& s) { shape.push_back(global(s.node, s.dof)); };
  const auto form = [&](const LinearForm& terms) {
    shape.push_back(static_cast<int>(terms.size()));
    for (const Term& t : terms) shape.insert(shape.end(), {global(t.node, t.dof), t.coefficient != 0.0});
  };
  add(model.bars, ends);
  add(model.beams, ends);
  add(model.shells, ends);
  add(model.springs, [&](const SpringElement& s) { shape.insert(shape.end(), {s.from.node, s.to.node, s.nx != 0.0}); });
  add(model.form_springs, [&](const FormSpring& s) { form(s.approach); });
  add(model.elastic_supports, support);
  add(model.elastic_links, [&](const ElasticLink& e) { form(e.form); });
  add(model.fixed_supports, support);
  add(model.constraints, [&](const Constraint& c) {
    support(c);
    form(c.form);
  });
  return shape;
}

/// A state in numbers with more digits, for forces of elements that are much shorter than thick.
template <class Number>
struct LongState {
  const State& state;

  Number operator[](int i) const { return i < 0 ? Number(0.0) : Number(state.head[i]) + Number(state.tail[i]); }
  Number compensation(int) const { return Number(0.0); }
  Number difference(int i, int j) const { return (*this)[j] - (*this)[i]; }
};

/// Largest change of a force where approaches change by approach_change(spring), relative to the
/// largest force.
template <class ApproachChange>
double largest_change(const std::vector<Equations::Spring>& springs, const State& q, ApproachChange approach_change) {
  double change = 0.0, largest = 0.0;
  for (const Equations::Spring& s : springs) {
    const SpringResponse r = evaluate(s.law, s.approach(q));
    change = std::max(change, r.tangent * approach_change(s));
    largest = std::max(largest, r.force);
  }
  return largest > 0.0 ? change / largest : 0.0;
}

/// residual = f - residual, less the forces force_of(k) of the springs.
template <class ForceOf>
void less_forces(const std::vector<Equations::Spring>& springs, const VectorXd& f, ForceOf force_of,
                 VectorXd& residual) {
  residual = f - residual;
  for (std::size_t k = 0; k < springs.size(); ++k) {
    const Equations::Spring& s = springs[k];
    const double force = force_of(k);
    for (std::size_t i = 0; i < s.count; ++i) residual[s.equation[i]] -= force * s.coefficient[i];
  }
}

/// Length below which beams are computed in numbers of 113 binary digits [m]: by choice about a hundredth of a screw's
/// diameter, where forces of a beam are small differences of large ones.
constexpr double kShortBeam = 2e-4;

}  // namespace

Equations::Equations(const Model& model) : shape_(shape_of(model)) {
  number_freedoms(model);
  add_followers(model);
  add_linear_elements(model);
  add_springs(model);
}

bool Equations::take(const Model& model) {
  if (shape_of(model) != shape_) return false;
  add_followers(model);
  add_linear_elements(model);
  add_springs(model);
  return true;
}

void Equations::add_followers(const Model& model) {
  followers_.clear();
  for (const Constraint& c : model.constraints) {
    Follower follower{{}, c.offset};
    follower.terms = terms_of(c.form, follower.offset);
    followers_.push_back(std::move(follower));
  }
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
  for (const SpringElement& e : model.springs)
    if (e.nx != 0.0)
      for (const RigidArm& end : {e.from, e.to}) activate(global(end.node, Dof::u));
  const auto activate_all = [&](const LinearForm& form) {
    for (const Term& term : form)
      if (term.coefficient != 0.0) activate(global(term.node, term.dof));
  };
  for (const FormSpring& e : model.form_springs) activate_all(e.approach);
  for (const ElasticLink& e : model.elastic_links) activate_all(e.form);
  for (const ElasticSupport& s : model.elastic_supports) activate(global(s.node, s.dof));
  for (const FixedSupport& s : model.fixed_supports) at(number_, global(s.node, s.dof)) = kOut;

  constexpr int kFollows = -2;
  for (const Constraint& c : model.constraints) at(number_, global(c.node, c.dof)) = kFollows;

  int size = 0;
  for (int& n : number_)
    if (n == kFree) n = size++;
  for (std::size_t k = 0; k < model.constraints.size(); ++k) {
    const Constraint& c = model.constraints[k];
    int& n = at(number_, global(c.node, c.dof));
    assert(n == kFollows);  // One constraint for a freedom, whose form names no later ones.
    n = size + static_cast<int>(k);
    assert(std::ranges::all_of(c.form, [&](const Term& t) {
      const int followed = at(number_, global(t.node, t.dof));
      return followed != kFollows && followed < n;
    }));
  }

  const SparseSymmetric pattern = pattern_of(model, number_, size);
  const std::vector<int> place = inverse(fill_reducing_order(pattern));
  linear_ = permuted(pattern, place);

  kind_.resize(place.size());
  for (std::size_t freedom = 0; freedom < number_.size(); ++freedom) {
    int& n = number_[freedom];
    if (n < 0 || n >= size) continue;
    n = at(place, n);
    at(kind_, n) = static_cast<Dof>(freedom % kDofsPerNode);
  }
}

void Equations::add_linear_elements(const Model& model) {
  bars_.clear();
  beams_.clear();
  shells_.clear();
  supports_.clear();
  links_.clear();
  const auto numbered = [&](std::array<int, 6> freedoms) {
    for (int& freedom : freedoms) freedom = at(number_, freedom);
    return freedoms;
  };
  for (const BarElement& e : model.bars)
    bars_.push_back({{number(e.first, Dof::u), number(e.second, Dof::u)}, e.bar.stiffness()});
  for (const BeamElement& e : model.beams) beams_.push_back({numbered(globals(e)), e.beam});
  for (const ShellElement& e : model.shells) shells_.push_back({numbered(globals(e)), e.stiffness});
  for (const ElasticSupport& s : model.elastic_supports) supports_.push_back({number(s.node, s.dof), s.stiffness});
  for (const ElasticLink& e : model.elastic_links) {
    NumberedLink link{{}, e.rest, e.stiffness};
    double offset = 0.0;
    link.terms = terms_of(e.form, offset);
    link.rest -= offset;
    links_.push_back(std::move(link));
  }
  linear_.value = linear_values<double>();
}

std::vector<std::pair<int, double>> Equations::terms_of(const LinearForm& form, double& offset) const {
  std::vector<std::pair<int, double>> terms;
  const auto add = [&](int equation, double c) {
    const auto same = std::ranges::find(terms, equation, [](const auto& term) { return term.first; });
    if (same != terms.end())
      same->second += c;
    else if (c != 0.0)
      terms.emplace_back(equation, c);
  };
  for (const Term& term : form) {
    const int n = number(term.node, term.dof);
    for_each_term(n, [&](int equation, double c) { add(equation, term.coefficient * c); });
    if (n >= size()) offset += term.coefficient * at(followers_, n - size()).offset;
  }
  return terms;
}

void Equations::add_springs(const Model& model) {
  std::vector<Spring> before = std::exchange(springs_, {});
  springs_.reserve(model.springs.size() + model.form_springs.size());
  const auto add = [&](const LinearForm& approach, const PowerLawSpring& law) {
    Spring s;
    s.law = law;
    double offset = 0.0;
    for (const auto& [equation, coefficient] : terms_of(approach, offset)) {
      assert(s.count < Spring::kMost);
      s.equation[s.count] = equation;
      s.coefficient[s.count] = coefficient;
      ++s.count;
    }
    s.law.gap -= offset;
    Spring* same = springs_.size() < before.size() ? &before[springs_.size()] : nullptr;
    if (same && same->count == s.count && same->equation == s.equation) {
      s.slot = std::move(same->slot);
    } else {
      s.slot.reserve(s.count * (s.count + 1) / 2);
      for (std::size_t i = 0; i < s.count; ++i)
        for (std::size_t j = i; j < s.count; ++j) s.slot.push_back(slot(s.equation[i], s.equation[j]));
    }
    springs_.push_back(std::move(s));
  };
  for (const SpringElement& e : model.springs) add(approach_of(e), e.law);
  for (const FormSpring& e : model.form_springs) add(e.approach, e.law);
}

int Equations::slot(int i, int j) const { return slot_in(linear_, i, j); }

VectorXd Equations::load_vector(const std::vector<NodalLoad>& loads) const {
  VectorXd f = VectorXd::Zero(size());
  for_each_load(loads, [&](int equation, double force) { f[equation] += force; });
  return f;
}

double Equations::Spring::approach(const State& q) const {
  double w = 0.0;
  for (std::size_t i = 0; i < count; ++i) w += coefficient[i] * q.head[equation[i]];
  for (std::size_t i = 0; i < count; ++i) w += coefficient[i] * q.tail[equation[i]];
  return w;
}

double Equations::Spring::net_approach(const State& q) const {
  double sum = -law.gap, lost = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double product = coefficient[i] * q.head[equation[i]];
    lost += std::fma(coefficient[i], q.head[equation[i]], -product);
    const double next = sum + product, rounded = next - sum;
    lost += (sum - (next - rounded)) + (product - rounded);
    lost += coefficient[i] * q.tail[equation[i]];
    sum = next;
  }
  return sum + lost;
}

double Equations::net_approach(const State& q, int k) const { return at(springs_, k).net_approach(q); }

SpringResponse Equations::response(const State& q, int k) const {
  const Spring& s = at(springs_, k);
  return evaluate(without_gap(s.law), s.net_approach(q));
}

double Equations::law_approach(const State& q, int k) const {
  const Spring& s = at(springs_, k);
  return fe::law_approach(without_gap(s.law), s.net_approach(q));
}

double Equations::energy_and_residual(const State& q, const VectorXd& f, VectorXd& residual) const {
  double energy = 0.5 * linear_forces(q, residual);
  energy += q.head.dot(0.5 * residual - f);
  residual -= f;
  for (const Spring& s : springs_) {
    const SpringResponse r = evaluate(s.law, s.approach(q));
    energy += r.energy;
    for (std::size_t i = 0; i < s.count; ++i) residual[s.equation[i]] += r.force * s.coefficient[i];
  }
  return energy;
}

void Equations::tangent_residual(const State& q, const State& x, const VectorXd& f, VectorXd& residual) const {
  forces_of(Displacements<State>{*this, x, 0.0}, residual);
  const auto force = [&](std::size_t k) {
    const Spring& s = springs_[k];
    return evaluate(s.law, s.approach(q)).tangent * s.approach(x);
  };
  less_forces(springs_, f, force, residual);
}

template <class Number>
std::vector<double> Equations::nodal_forces_by(const State& q) const {
  std::vector<Number> forces(static_cast<std::size_t>(size()) + followers_.size());
  const LongState<Number> longer{q};
  for_each_force(
      Displacements<LongState<Number>>{*this, longer, 1.0},
      [&](int equation, const Number& force) {
        if (equation >= 0) at(forces, equation) += force;
      },
      [](const NumberedLink&, const Number&) {});
  std::vector<double> rounded;
  for (const Number& force : forces) rounded.push_back(static_cast<double>(force));
  return rounded;
}

std::vector<double> Equations::nodal_forces(const State& q) const {
  const bool has_short_beam =
      std::ranges::any_of(beams_, [](const NumberedBeam& b) { return b.beam.length < kShortBeam; });
  return has_short_beam ? nodal_forces_by<Quad>(q) : nodal_forces_by<long double>(q);
}

double Equations::force_change(const State& q, const VectorXd& x) const {
  return largest_change(springs_, q, [&](const Spring& s) {
    double w = 0.0;
    for (std::size_t i = 0; i < s.count; ++i) w += s.coefficient[i] * x[s.equation[i]];
    return std::abs(w);
  });
}

double Equations::force_rounding(const State& q) const {
  return kForceRounding * largest_change(springs_, q, [&](const Spring& s) {
           double size = std::abs(s.law.gap);
           for (std::size_t i = 0; i < s.count; ++i)
             size = std::max(size, std::abs(s.coefficient[i] * q[s.equation[i]]));
           return size;
         });
}

VectorXd Equations::rounding_residual(const State& q) const {
  VectorXd r = VectorXd::Zero(size());
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
    for (std::size_t i = 0; i < s.count; ++i) r[s.equation[i]] += force * std::abs(s.coefficient[i]);
  }
  return std::numeric_limits<double>::epsilon() * r;
}

void Equations::secant_stiffness(const std::vector<double>& stiffness, SparseSymmetric& matrix) const {
  matrix.value = linear_.value;
  for (std::size_t k = 0; k < springs_.size(); ++k)
    springs_[k].for_each_tangent(stiffness[k], [&](int slot, double value) { at(matrix.value, slot) += value; });
}

void Equations::secant_residual(const std::vector<double>& stiffness, const VectorXd& f, VectorXd& residual) const {
  linear_forces(State(VectorXd::Zero(size())), residual);
  less_forces(
      springs_, f, [&](std::size_t k) { return -stiffness[k] * springs_[k].law.gap; }, residual);
}

void Equations::secant_residual(const std::vector<double>& stiffness, const State& x, const VectorXd& f,
                                VectorXd& residual) const {
  forces_of(Displacements<State>{*this, x, 0.0}, residual);
  less_forces(
      springs_, f, [&](std::size_t k) { return stiffness[k] * springs_[k].approach(x); }, residual);
}

double Equations::largest_approach(const State& q) const {
  double largest = 0.0;
  for (const Spring& s : springs_) largest = std::max(largest, std::abs(s.approach(q)));
  return largest;
}

}  // namespace fe
