#include "prs/sector/chain/condense.h"

#include <Eigen/Core>

#include "fe/shell.h"
#include "prs/sector/chain/bar_station.h"

namespace prs {
namespace {

/// Differences of stiff neighbours are what is left after condensation: long double.
using Real = long double;
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
using Matrix6 = Eigen::Matrix<Real, 6, 6>;
using Matrix9 = Eigen::Matrix<Real, 9, 9>;

/// Upper triangle row by row.
template <class Matrix, std::size_t N>
void set_triangle(const Matrix& m, double (&triangle)[N]) {
  double* next = triangle;
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = i; j < m.cols(); ++j) *next++ = static_cast<double>(m(i, j));
}

/// Eliminates freedom p; one that nothing stiffens has nothing to pass on.
template <class Matrix>
void eliminate(Matrix& k, Eigen::Index p) {
  if (k(p, p) > 0.0L) {
    const auto column = (k.col(p) / k(p, p)).eval();
    k -= column * k.row(p).eval();
  }
  k.row(p).setZero();
  k.col(p).setZero();
}

/// (q_2 - q_1, (q_1 + q_2)/2) takes the place of (q_1, q_2).
Matrix6 over_deformation(const Matrix6& k) {
  Matrix6 t = Matrix6::Zero();
  for (int i = 0; i < 3; ++i) {
    t(i, i) = -0.5L;
    t(i + 3, i) = 0.5L;
    t(i, i + 3) = t(i + 3, i + 3) = 1.0L;
  }
  return t.transpose() * k * t;
}

NutSegment segment(const Matrix6& k) {
  NutSegment s;
  set_triangle(k.topLeftCorner<3, 3>(), s.first);
  set_triangle(k.bottomRightCorner<3, 3>(), s.second);
  for (int i = 0; i < 9; ++i) s.coupling[i] = static_cast<double>(k(i / 3, 3 + i % 3));
  set_triangle(over_deformation(k), s.deformation);
  return s;
}

/// The nut's line walked along: between contacts a segment, beyond them a support.
class NutWalk {
 public:
  explicit NutWalk(const SectorModel& s) : model_(s), line_(nut_line(s)) {}

  void set(ChainSector& c) {
    const auto contacts = line_.contacts.size();
    std::vector<Matrix3> supports(contacts, Matrix3::Zero());
    std::size_t passed = 0;           // contacts
    Matrix6 piece = Matrix6::Zero();  // from the last contact, if any, to the node reached
    const auto reach = [&](int node) {
      if (passed == contacts || node != line_.contacts[passed]) return false;
      if (passed == 0)
        supports[0] = piece.bottomRightCorner<3, 3>();
      else
        c.segments.push_back(segment(piece));
      piece.setZero();
      return ++passed > 0;
    };
    const int last = static_cast<int>(line_.outer_radius.size());
    bool at_contact = reach(0);
    for (int node = 0; node < last; ++node) {
      if (at_contact && passed < contacts && line_.contacts[passed] == node + 1) {
        c.segments.push_back(segment_of(node));
        ++passed;
        continue;
      }
      if (at_contact) {
        piece = element(node);
      } else {
        Matrix9 both = Matrix9::Zero();
        both.topLeftCorner<6, 6>() = piece;
        both.bottomRightCorner<6, 6>() += element(node);
        eliminate_node(node, both);
        piece << both.topLeftCorner<3, 3>(), both.topRightCorner<3, 3>(),
            both.bottomLeftCorner<3, 3>(), both.bottomRightCorner<3, 3>();
      }
      at_contact = reach(node + 1);
    }
    if (!at_contact) {
      eliminate_node(last, piece);
      supports.back() += piece.topLeftCorner<3, 3>();
    }
    for (std::size_t k = 0; k < contacts; ++k) {
      for (int i = 0; i < 3; ++i)
        if (held(line_.contacts[k], i)) supports[k](i, i) = kHeld;
      set_triangle(supports[k], c.supports.emplace_back().stiffness);
    }
  }

 private:
  /// What lies between two contacts that are neighbours; equal ones in a row are condensed once.
  const NutSegment& segment_of(int node) {
    if (known_node_ < 0 || !alike(known_node_, node)) {
      known_ = segment(element(node));
      known_node_ = node;
    }
    return known_;
  }

  bool alike(int a, int b) const {
    const auto i = static_cast<std::size_t>(a), k = static_cast<std::size_t>(b);
    if (model_.nut_shell) return model_.nut_shell->segments[i] == model_.nut_shell->segments[k];
    return line_.axial_rigidity[i] == line_.axial_rigidity[k] && line_.length(i) == line_.length(k);
  }

  /// What lies between a node and the next, over (u, v, r theta) of both.
  Matrix6 element(int node) const {
    const auto i = static_cast<std::size_t>(node);
    Matrix6 k = Matrix6::Zero();
    if (!model_.nut_shell) {
      k(0, 0) = k(3, 3) = static_cast<Real>(line_.axial_rigidity[i]) / line_.length(i);
      k(0, 3) = k(3, 0) = -k(0, 0);
      return k;
    }
    k = fe::nodal_stiffness<Real>(model_.nut_shell->segments[i]);
    for (const int theta : {2, 5}) {
      k.row(theta) /= model_.roller_radius;
      k.col(theta) /= model_.roller_radius;
    }
    return k;
  }

  /// Whether the node does not move so, being held or part of bars.
  bool held(int node, int freedom) const {
    const bool at_thrust = node == line_.thrust;
    if (freedom == 0) return at_thrust;
    if (!model_.nut_shell) return true;
    return freedom == 1 ? model_.nut_shell->radially_rigid
                        : at_thrust && model_.nut_shell->straight_thrust_section;
  }

  /// Eliminates the node of freedoms 3 .. 5; what is held there passes nothing on.
  template <class Matrix>
  void eliminate_node(int node, Matrix& k) const {
    for (int i = 0; i < 3; ++i)
      if (held(node, i)) {
        k.row(3 + i).setZero();
        k.col(3 + i).setZero();
      }
    for (int i = 0; i < 3; ++i) eliminate(k, 3 + i);
  }

  const SectorModel& model_;
  NutLine line_;
  int known_node_ = -1;
  NutSegment known_;
};

void set_bars(const SectorModel& s, ChainSector& c) {
  c.nut.resize(s.gaps.nut.size());
  c.ground.resize(s.gaps.nut.size());
  const auto flange = [&](std::size_t i) -> const SectorModel::Flange& { return s.flanges[i]; };
  NutOfBars<double, decltype(flange)>(s, s.flanges.size(), flange)
      .set(c.contacts, c.nut.data(), c.ground.data());
}

}  // namespace

ChainSector condense(const SectorModel& s) {
  using Kind = ChainSector::Kind;
  ChainSector c;
  c.contacts = s.contacts();
  c.numbers = s;
  c.roller = roller_chain<double>(s);
  c.gaps = s.gaps;
  const bool bars = !s.contacts_apart() && !s.nut_shell;
  if (!bars || s.has_compliance())
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < s.gaps[i].size(); ++k)
        c.compliance[i].push_back(s.contact_compliance(i, k));
  if (bars) {
    set_bars(s, c);
    return c;
  }
  c.kind = !s.contacts_apart() ? Kind::shell
           : s.sense < 0.0     ? Kind::apart_nut_first
                               : Kind::apart_screw_first;
  if (s.contacts_apart())
    c.roller.tooth = roller_beam<double>(s.thread, 2.0 * s.contact_half_distance, s.roller_radius);
  if (s.nut_shell)
    c.nut_rotation_part = s.sense * s.cosine.nut * s.nut_shell->contact_arm / s.roller_radius;
  NutWalk(s).set(c);
  return c;
}

}  // namespace prs
