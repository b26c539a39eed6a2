#include "prs/sector/chain/condense.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fe/shell.h"

namespace prs {
namespace {

using fe::Dof;

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

/// What lies between two neighbouring nodes of the nut, over (u, v, r theta) of both.
struct NutElement {
  int first = 0;
  Matrix6 stiffness;
};

Matrix6 nodal_stiffness(const fe::ShellMatrix& stiffness, double radius) {
  Eigen::Matrix<Real, 5, 6> b = Eigen::Matrix<Real, 5, 6>::Zero();
  for (int i = 0; i < 3; ++i) {
    const Real scale = i == 2 ? 1.0L / radius : 1.0L;
    b(i, i) = -scale;
    b(i, i + 3) = scale;
    if (i > 0) b(i + 2, i) = b(i + 2, i + 3) = 0.5L * scale;
  }
  return b.transpose() * stiffness.cast<Real>() * b;
}

Matrix6 nodal_stiffness(const fe::Bar& bar) {
  Matrix6 k = Matrix6::Zero();
  k(0, 0) = k(3, 3) = static_cast<Real>(bar.axial_rigidity) / bar.length;
  k(0, 3) = k(3, 0) = -k(0, 0);
  return k;
}

/// From one end of the nut to the other.
std::vector<NutElement> nut_elements(const Sector& s) {
  std::vector<NutElement> elements;
  for (const fe::ShellElement& e : s.model.shells)
    elements.push_back({e.first, nodal_stiffness(e.stiffness, s.roller_radius)});
  const auto of_screw = [&](const fe::BarElement& e) {
    return std::find(s.screw_nodes.begin(), s.screw_nodes.end(), e.second) != s.screw_nodes.end();
  };
  for (const fe::BarElement& e : s.model.bars)
    if (!of_screw(e)) elements.push_back({e.first, nodal_stiffness(e.bar)});
  return elements;
}

bool fixed(const Sector& s, int node, Dof dof) {
  return std::any_of(s.model.fixed_supports.begin(), s.model.fixed_supports.end(),
                     [&](const fe::FixedSupport& f) { return f.node == node && f.dof == dof; });
}

/// Whether the nut's node does not move so, being held or part of bars.
bool held(const Sector& s, int node, int freedom) {
  return fixed(s, node, static_cast<Dof>(freedom)) || (s.model.shells.empty() && freedom != 0);
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

/// Eliminates the node of freedoms 3 .. 5; what is held there passes nothing on.
template <class Matrix>
void eliminate_node(const Sector& s, int node, Matrix& k, Eigen::Index first) {
  for (int i = 0; i < 3; ++i)
    if (held(s, node, i)) {
      k.row(first + i).setZero();
      k.col(first + i).setZero();
    }
  for (int i = 0; i < 3; ++i) eliminate(k, first + i);
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
struct CondensedNut {
  std::vector<Matrix6> segments;
  std::vector<Matrix3> supports;
};

CondensedNut condense_nut(const Sector& s) {
  const auto contacts = s.nut_nodes.size();
  CondensedNut nut;
  nut.supports.assign(contacts, Matrix3::Zero());
  std::size_t passed = 0;           // contacts
  Matrix6 piece = Matrix6::Zero();  // from the last contact, if any, to the node reached
  const auto reach = [&](int node) {
    if (passed == contacts || node != s.nut_nodes[passed]) return false;
    if (passed == 0)
      nut.supports[0] = piece.bottomRightCorner<3, 3>();
    else
      nut.segments.push_back(piece);
    piece.setZero();
    return ++passed > 0;
  };
  const std::vector<NutElement> elements = nut_elements(s);
  bool at_contact = reach(elements.front().first);
  for (const NutElement& e : elements) {
    if (at_contact) {
      piece = e.stiffness;
    } else {
      Matrix9 both = Matrix9::Zero();
      both.topLeftCorner<6, 6>() = piece;
      both.bottomRightCorner<6, 6>() += e.stiffness;
      eliminate_node(s, e.first, both, 3);
      piece << both.topLeftCorner<3, 3>(), both.topRightCorner<3, 3>(),
          both.bottomLeftCorner<3, 3>(), both.bottomRightCorner<3, 3>();
    }
    at_contact = reach(e.first + 1);
  }
  if (!at_contact) {
    eliminate_node(s, elements.back().first + 1, piece, 3);
    nut.supports.back() += piece.topLeftCorner<3, 3>();
  }
  for (std::size_t k = 0; k < contacts; ++k)
    for (int i = 0; i < 3; ++i)
      if (held(s, s.nut_nodes[k], i)) nut.supports[k](i, i) = kHeld;
  return nut;
}

/// Nut nodes of bars move along the axis alone.
void set_bars(const CondensedNut& nut, ChainSector& c) {
  for (const Matrix3& k : nut.supports) c.ground.push_back(static_cast<double>(k(0, 0)));
  for (std::size_t k = 0; k < nut.segments.size(); ++k) {
    const Matrix6& m = nut.segments[k];
    c.nut.push_back(static_cast<double>(-m(0, 3)));
    c.ground[k] += static_cast<double>(m(0, 0) + m(0, 3));
    c.ground[k + 1] += static_cast<double>(m(3, 3) + m(0, 3));
  }
}

void set_shell(const CondensedNut& nut, ChainSector& c) {
  for (const Matrix3& k : nut.supports) set_triangle(k, c.supports.emplace_back().stiffness);
  for (const Matrix6& k : nut.segments) c.segments.push_back(segment(k));
}

RollerBeam<double> roller_beam(const fe::Beam& beam, double radius) {
  const double phi = fe::shear_ratio(beam);
  const double b = beam.bending_rigidity / (beam.length * (1.0 + phi) * radius * radius);
  return {beam.axial_rigidity / beam.length, (4.0 + phi) * b, (2.0 - phi) * b,
          radius / beam.length};
}

RollerLength<double> roller_length(const fe::Beam& beam) {
  return {beam.length, 1.0 / beam.bending_rigidity,
          beam.shear_rigidity > 0.0 ? 1.0 / beam.shear_rigidity : 0.0};
}

/// Radial stiffness of what guides a node of the roller [N/m].
double guide(const Sector& s, int node) {
  if (fixed(s, node, Dof::v)) return kHeld;
  double stiffness = 0.0;
  for (const fe::ElasticSupport& e : s.model.elastic_supports)
    if (e.node == node && e.dof == Dof::v) stiffness += e.stiffness;
  return stiffness;
}

void set_roller(const Sector& s, bool apart, ChainSector& c) {
  const std::vector<fe::BeamElement>& beams = s.model.beams;
  const double r = s.roller_radius;
  const auto beam = [&](std::size_t k) { return roller_beam(beams[k].beam, r); };
  if (apart) c.tooth = beam(2);
  if (c.contacts > 1) c.thread = beam(apart ? 3 : 2);
  const auto end = [&](const fe::Beam& run_out, const fe::Beam& last, int outer, int inner,
                       double side) {
    return roller_end(roller_length(run_out), roller_length(last), guide(s, outer), guide(s, inner),
                      side, r);
  };
  const std::vector<int>& nodes = s.roller_end_nodes;
  const std::size_t last = beams.size() - 1;
  c.ends[0] = end(beams[1].beam, beams[0].beam, nodes[0], nodes[1], -1.0);
  c.ends[1] = end(beams[last - 1].beam, beams[last].beam, nodes[3], nodes[2], 1.0);
  c.bending_support = fixed(s, s.roller_nodes.front(), Dof::theta) ? kHeld : 0.0;
}

/// True where contacts have compliances in series.
bool set_contacts(const Sector& s, ChainSector& c) {
  bool compliant = false;
  for (const Interface i : kInterfaces) {
    const fe::SpringElement& first = s.model.springs[static_cast<std::size_t>(s.spring(i, 0))];
    c.axial_part[i] = first.nx;
    c.radial_part[i] = first.ny;
    c.hertz_constant[i] = first.law.stiffness;
    if (i == Interface::nut) c.nut_rotation_part = first.nx * first.to.dy / s.roller_radius;
    for (int k = 0; k < c.contacts; ++k) {
      const fe::PowerLawSpring& law = s.model.springs[static_cast<std::size_t>(s.spring(i, k))].law;
      c.compliance[i].push_back(law.series_compliance);
      c.gaps[i].push_back(law.gap);
      compliant = compliant || law.series_compliance != 0.0;
    }
  }
  return compliant;
}

}  // namespace

ChainSector condense(const Sector& s) {
  ChainSector c;
  c.contacts = s.contacts();
  c.rollers = s.rollers;
  c.sense = sense(s.direction);
  c.offset_compliance = s.offset_compliance;
  for (const fe::BarElement& e : s.model.bars) {
    if (e.first == s.loaded_node && s.loaded_node != s.screw_nodes.front())
      c.free_compliance = 1.0 / e.bar.stiffness();
    else if (c.contacts > 1 && e.first == s.screw_nodes[0])
      c.screw = e.bar.stiffness();
  }
  const bool apart = s.roller_nodes.size() > s.screw_nodes.size();
  set_roller(s, apart, c);
  const bool compliant = set_contacts(s, c);
  const CondensedNut nut = condense_nut(s);
  if (!apart && s.model.shells.empty()) {
    c.kind = ChainSector::Kind::bars;
    set_bars(nut, c);
    if (!compliant) c.compliance = {};
  } else {
    const bool screw_first = s.model.springs.front().to.node == s.roller_nodes.front();
    c.kind = !apart        ? ChainSector::Kind::shell
             : screw_first ? ChainSector::Kind::apart_screw_first
                           : ChainSector::Kind::apart_nut_first;
    set_shell(nut, c);
  }
  return c;
}

}  // namespace prs
