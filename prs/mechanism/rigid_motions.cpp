#include "prs/mechanism/rigid_motions.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <memory>

namespace prs {
namespace {

using fe::Dof;

constexpr double kNoResistance = 1e-9;

/// Rigid motions of screw, rollers and floating rings as displacements of every freedom.
class Motions {
 public:
  Motions(const FullModel& f, const FullStructure& s)
      : arm_(f.sector.roller_radius),
        middle_(0.5 * (f.roller_ends.first + f.roller_ends.last)),
        rows_(static_cast<std::size_t>(s.model.nodes) * fe::kDofsPerNode) {
    const int screw = add_part("screw", 5);
    for (const SpatialNode& n : s.screw) {
      move(n.y_plane, n.x, screw, screw + 1, screw + 2);
      move(n.z_plane, n.x, -1, screw + 3, screw + 4);
    }
    for (std::size_t r = 0; r < s.rollers.size(); ++r) {
      const int first = add_part(fmt::format("roller {}", f.present[r].number + 1), 3);
      for (std::size_t k = 0; k < s.rollers[r].nodes.size(); ++k)
        move(s.rollers[r].nodes[k], s.rollers[r].x[k], first, first + 1, first + 2);
    }
    for (const int ring : s.rings)
      if (ring >= 0) {
        const int first = add_part("ring", 2);
        at(ring, Dof::u).push_back({first, 1.0});
        at(ring, Dof::v).push_back({first + 1, 1.0});
      }
  }

  int count() const { return count_; }
  const std::string& part(int motion) const {
    return *std::ranges::find_if(parts_, [&](const auto& p) { return motion < p.end; })->name;
  }
  /// Adds the values of a form on every motion.
  template <class RowOf>
  void add(const fe::LinearForm& form, RowOf row) const {
    for (const fe::Term& t : form)
      for (const auto& [motion, value] : at(t.node, t.dof)) row[motion] += t.coefficient * value;
  }

 private:
  struct Part {
    std::shared_ptr<std::string> name;
    int end;
  };
  using Row = std::vector<std::pair<int, double>>;

  int add_part(std::string name, int motions) {
    const int first = count_;
    count_ += motions;
    parts_.push_back({std::make_shared<std::string>(std::move(name)), count_});
    return first;
  }
  void move(int node, double x, int along, int across, int turn) {
    if (along >= 0) at(node, Dof::u).push_back({along, 1.0});
    at(node, Dof::v).push_back({across, 1.0});
    at(node, Dof::v).push_back({turn, (x - middle_) / arm_});
    at(node, Dof::theta).push_back({turn, 1.0 / arm_});
  }
  Row& at(int node, Dof dof) {
    return rows_[static_cast<std::size_t>(fe::kDofsPerNode * node + static_cast<int>(dof))];
  }
  const Row& at(int node, Dof dof) const { return const_cast<Motions*>(this)->at(node, dof); }

  double arm_, middle_;
  int count_ = 0;
  std::vector<Part> parts_;
  std::vector<Row> rows_;
};

/// Rows of what pushes and pulls: constraints, supports and springs.
std::vector<fe::LinearForm> bilateral(const fe::Model& model) {
  std::vector<fe::LinearForm> forms;
  for (const fe::Constraint& c : model.constraints) {
    forms.push_back(c.form);
    forms.back().push_back({c.node, c.dof, -1.0});
  }
  for (const fe::ElasticLink& e : model.elastic_links) forms.push_back(e.form);
  for (const fe::ElasticSupport& e : model.elastic_supports)
    forms.push_back({{e.node, e.dof, 1.0}});
  for (const fe::FixedSupport& e : model.fixed_supports)
    if (e.dof != Dof::u) forms.push_back({{e.node, e.dof, 1.0}});  // No part moves those of u.
  return forms;
}

Eigen::MatrixXd rows_over(const Motions& motions, const std::vector<fe::LinearForm>& forms) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(forms.size()),
                                               static_cast<Eigen::Index>(motions.count()));
  for (std::size_t i = 0; i < forms.size(); ++i)
    motions.add(forms[i], rows.row(static_cast<Eigen::Index>(i)));
  return rows;
}

/// Rows that are not zero, scaled to one.
Eigen::MatrixXd unit_rows(const Eigen::MatrixXd& rows) {
  Eigen::MatrixXd units(rows.rows(), rows.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    if (const double norm = rows.row(i).norm(); norm > 0.0) units.row(count++) = rows.row(i) / norm;
  return units.topRows(count);
}

/// Whether the smallest singular value of a triangle is above kNoResistance times the largest, by
/// 1/|R^-1| and |R| in Frobenius' norm, which bound them; far cheaper than the values.
bool surely_regular(const Eigen::MatrixXd& r) {
  const Eigen::MatrixXd inverse =
      r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(r.rows(), r.cols()));
  return kNoResistance * r.norm() * inverse.norm() < 1.0;  // False with NaN and infinity.
}

/// x >= 0 that minimises |A x - b| (Lawson and Hanson, Solving Least Squares Problems, 1974,
/// chapter 23); returns what is left of b.
Eigen::VectorXd left_by_pushing(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) {
  const double small = 1e-12 * b.norm();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
  std::vector<Eigen::Index> pushing;
  const auto solved = [&] {
    Eigen::MatrixXd columns(a.rows(), static_cast<Eigen::Index>(pushing.size()));
    for (std::size_t k = 0; k < pushing.size(); ++k)
      columns.col(static_cast<Eigen::Index>(k)) = a.col(pushing[k]);
    return Eigen::VectorXd(columns.colPivHouseholderQr().solve(b));
  };
  for (Eigen::Index step = 0; step < 3 * a.cols(); ++step) {
    const Eigen::VectorXd left = b - a * x;
    Eigen::VectorXd gain = a.transpose() * left;
    for (const Eigen::Index k : pushing) gain[k] = 0.0;
    Eigen::Index best = 0;
    if (left.norm() <= small || gain.maxCoeff(&best) <= 1e-10 * b.norm()) return left;
    pushing.push_back(best);
    for (Eigen::VectorXd wanted = solved();; wanted = solved()) {
      double length = 1.0;
      for (std::size_t k = 0; k < pushing.size(); ++k)
        if (const double to = wanted[static_cast<Eigen::Index>(k)]; to <= 0.0)
          length = std::min(length, x[pushing[k]] / std::max(x[pushing[k]] - to, 1e-300));
      for (std::size_t k = 0; k < pushing.size(); ++k)
        x[pushing[k]] += length * (wanted[static_cast<Eigen::Index>(k)] - x[pushing[k]]);
      if (length == 1.0) break;
      std::erase_if(pushing, [&](Eigen::Index k) {
        if (x[k] > 1e-14 * x.maxCoeff()) return false;
        x[k] = 0.0;
        return true;
      });
      if (pushing.empty()) break;
    }
  }
  return b - a * x;
}

}  // namespace

double load_left(const FullModel& f, const FullStructure& s) {
  const Motions motions(f, s);
  std::vector<fe::LinearForm> contacts;
  for (const fe::FormSpring& spring : s.model.form_springs) contacts.push_back(spring.approach);
  fe::LinearForm& load = contacts.emplace_back();  // The last column.
  for (const fe::NodalLoad& l : s.loads) load.push_back({l.node, l.dof, l.value / f.axial_force});
  Eigen::MatrixXd push = rows_over(motions, contacts).transpose();

  // What guides and bearings take as well is of no interest: the complement of their range.
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(
      rows_over(motions, bilateral(s.model)).transpose());
  push.applyOnTheLeft(qr.householderQ().adjoint());
  const auto rest = push.bottomRows(push.rows() - qr.rank());
  return left_by_pushing(rest.leftCols(rest.cols() - 1), rest.rightCols<1>()).norm();
}

std::optional<double> holding_force(const FullModel& model) {
  FullModel f = model;
  const auto holds = [&](double force) {
    f.axial_force = force;
    return load_left(f, full_structure(f)) < 1e-9;
  };
  double below = model.axial_force, above = 1e3 * model.axial_force;
  if (!holds(above)) return std::nullopt;
  while (above > 1.01 * below) {
    const double middle = std::sqrt(below * above);
    (holds(middle) ? above : below) = middle;
  }
  return above;
}

FreeMotions free_motions(const FullModel& f, const FullStructure& s,
                         const std::vector<bool>& closed) {
  const Motions motions(f, s);
  std::vector<fe::LinearForm> forms = bilateral(s.model);
  const auto is_closed = [&](int spring) {
    return closed.empty() || closed[static_cast<std::size_t>(spring)];
  };
  const auto add = [&](int spring) {
    forms.push_back(s.model.form_springs[static_cast<std::size_t>(spring)].approach);
  };
  // Rows of a roller are linear in x: two of them span those between.
  for (const FullStructure::Roller& r : s.rollers)
    for (const Interface i : kInterfaces) {
      std::size_t first = 0, last = r.contacts[i].size();
      while (first < last && !is_closed(r.spring(i, first))) ++first;
      while (last > first && !is_closed(r.spring(i, last - 1))) --last;
      if (first < last) add(r.spring(i, first));
      if (first + 1 < last) add(r.spring(i, last - 1));
    }
  const Eigen::MatrixXd rows = unit_rows(rows_over(motions, forms));
  const Eigen::Index count = std::min(rows.rows(), rows.cols());
  Eigen::MatrixXd r = Eigen::MatrixXd::Zero(rows.cols(), rows.cols());
  r.topRows(count) = Eigen::HouseholderQR<Eigen::MatrixXd>(rows)
                         .matrixQR()
                         .topRows(count)
                         .triangularView<Eigen::Upper>();
  if (surely_regular(r)) return {};
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(r, Eigen::ComputeFullV);
  const Eigen::VectorXd& sizes = svd.singularValues();
  FreeMotions free;
  for (Eigen::Index m = 0; m < svd.matrixV().cols(); ++m) {
    if (sizes[m] > kNoResistance * sizes[0]) continue;
    ++free.count;
    const Eigen::VectorXd motion = svd.matrixV().col(m);
    for (int part = 0; part < motions.count(); ++part)
      if (std::abs(motion[part]) > 1e-6 &&
          std::ranges::find(free.parts, motions.part(part)) == free.parts.end())
        free.parts.push_back(motions.part(part));
  }
  return free;
}

std::string why_free(const FreeMotions& free) {
  return fmt::format("mechanism: {} motion{} of {} meet{} no resistance", free.count,
                     free.count == 1 ? "" : "s", free.parts.front(), free.count == 1 ? "s" : "");
}

std::string why_not_held(const FullModel& f, const FullStructure& s) {
  std::string text = fmt::format(
      "no equilibrium: flanks that only push cannot hold this load ({:.3f} of the axial force is "
      "left "
      "over); add `structure.screw.bearings`",
      load_left(f, s));
  if (const std::optional<double> force = holding_force(f))
    text += fmt::format(", or raise the axial force to {:.4g} kN", *force * 1e-3);
  return text;
}

}  // namespace prs
