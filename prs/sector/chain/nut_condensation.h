#pragma once

#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/refined/nut_formulas.h"
#include "simd/wide.h"

/// A nut's shells condensed to its contacts, for a number or a batch of numbers.
namespace prs {

/// Held freedoms of a nut.
struct NutHolds {
  int thrust = 0;               ///< Node that u is held at.
  bool radial = false;          ///< Whether v = 0 everywhere.
  bool turning = false;         ///< Whether theta = 0 everywhere.
  bool thrust_turning = false;  ///< Whether theta = 0 at the thrust section.

  /// Whether freedom 0 .. 2 of a node is held.
  bool operator()(int node, int freedom) const {
    if (freedom == 0) return node == thrust;
    return freedom == 1 ? radial : turning || (node == thrust && thrust_turning);
  }
};

/// Sets the segment of each interval between contacts, numbered in order of appearance; intervals without a node
/// between their contacts share the segments of equal shells.
inline void set_segments_of(const NutShape& shape, std::vector<int>& segment_of) {
  segment_of.clear();
  const auto shell_of = [&](std::size_t interval) {
    const int node = shape.contacts[interval];
    return shape.contacts[interval + 1] == node + 1 ? shape.same[static_cast<std::size_t>(node)] : -1;
  };
  int segments = 0;
  for (std::size_t k = 0; k + 1 < shape.contacts.size(); ++k) {
    std::size_t known = shell_of(k) < 0 ? k : 0;
    while (known < k && shell_of(known) != shell_of(k)) ++known;
    segment_of.push_back(known < k ? segment_of[known] : segments++);
  }
}

/// Condensation of a nut to its contacts. It leaves small differences of large stiffnesses and therefore uses wide
/// numbers.
template <class Real>
class NutCondensation {
 public:
  /// `radius`: the radius that rotations are scaled by.
  NutCondensation(const NutShape& shape, const NutHolds& holds, const fe::ShellBlocks<Real>* shells, const Real& radius)
      : shape_(shape), holds_(holds), shells_(shells), inverse_radius_(1.0 / radius) {}

  /// Supports of all contacts, and the segments that `set_segments_of` has counted.
  void set(std::span<const int> segment_of, NutSegment<Real>* segments, NutSupport<Real>* supports) const {
    const std::span<const int> contacts = shape_.contacts;
    for (std::size_t k = 0; k < contacts.size(); ++k) supports[k] = {};
    add(from_end(0, contacts.front(), 1), supports[0]);
    add(from_end(static_cast<int>(shape_.same.size()), contacts.back(), -1), supports[contacts.size() - 1]);
    for (std::size_t k = 0; k < contacts.size(); ++k)
      for (int i = 0, diagonal = 0; i < 3; diagonal += 3 - i, ++i)
        if (holds_(contacts[k], i)) supports[k].stiffness[diagonal] = Real(__builtin_inf());
    for (std::size_t k = 0, next = 0; k < segment_of.size(); ++k) {
      if (static_cast<std::size_t>(segment_of[k]) < next) continue;
      NutSegment<Real>& segment = segments[next++];
      if (contacts[k + 1] == contacts[k] + 1)
        set_segment(element(contacts[k]), segment);
      else
        set_segment(between(contacts[k], contacts[k + 1]), segment);
    }
  }

 private:
  using Wide = simd::Wide<Real>;
  /// Upper triangle over (u, v, r theta) of N/3 nodes.
  template <int N>
  struct Symmetric {
    Wide k[N][N];
    Wide& operator()(int i, int j) { return i < j ? k[i][j] : k[j][i]; }
    const Wide& operator()(int i, int j) const { return i < j ? k[i][j] : k[j][i]; }
  };

  fe::ShellBlocks<Real> element(int node) const {
    fe::ShellBlocks<Real> b = shells_[static_cast<std::size_t>(shape_.same[static_cast<std::size_t>(node)])];
    const Real square = inverse_radius_ * inverse_radius_;
    b.ut *= inverse_radius_;
    b.tt *= square;
    b.tv *= inverse_radius_;
    b.dm *= inverse_radius_;
    b.mm *= square;
    return b;
  }

  /// Adds the shell between a node, whose freedoms begin at `first`, and the next one.
  template <int N>
  static void add_nodal(const fe::ShellBlocks<Real>& b, int first, Symmetric<N>& k) {
    // Stiffness over differences d and means m: d with d, d with m, and m with m.
    const Wide d[3][3] = {{b.uu, Real(0.0), b.ut}, {Real(0.0), b.dd, Real(0.0)}, {b.ut, Real(0.0), b.tt}};
    const Wide both[3][3] = {{Real(0.0), b.uv, Real(0.0)}, {Real(0.0), Real(0.0), b.dm}, {Real(0.0), b.tv, Real(0.0)}};
    const Wide m[3] = {Real(0.0), b.vv, b.mm};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Wide mean = i == j ? m[i].scaled(0.25) : Wide(Real(0.0));
        const Wide skew = (both[i][j] - both[j][i]).scaled(0.5);
        Wide& across = k(first + i, first + 3 + j);
        across = across + (mean - d[i][j] - skew);
        if (j < i) continue;
        const Wide even = (both[i][j] + both[j][i]).scaled(0.5);
        Wide &here = k(first + i, first + j), &there = k(first + 3 + i, first + 3 + j);
        here = here + (d[i][j] + mean - even);
        there = there + (d[i][j] + mean + even);
      }
  }

  /// Eliminates a node, whose freedoms begin at `first`; one without stiffness, or a held one, passes nothing on.
  template <int N>
  void eliminate(int node, int first, Symmetric<N>& k) const {
    using simd::select;
    for (int freedom = 0; freedom < 3; ++freedom) {
      if (holds_(node, freedom)) continue;
      const int p = first + freedom;
      const auto stiff = k(p, p).head > 0.0;
      Wide inverse = k(p, p).inverse();
      inverse = {select(stiff, inverse.head, Real(0.0)), select(stiff, inverse.tail, Real(0.0))};
      const auto gone = [&](int i) { return first <= i && i <= p; };
      for (int i = 0; i < N; ++i) {
        if (gone(i)) continue;
        const Wide share = k(i, p) * inverse;
        for (int j = i; j < N; ++j)
          if (!gone(j)) k.k[i][j] = k.k[i][j] - share * k(p, j);
      }
    }
  }

  /// Stiffness at node `to` of the nut between it and the nut's end, whose node is `from`.
  Symmetric<3> from_end(int from, int to, int step) const {
    Symmetric<3> end{};
    for (int node = from; node != to; node += step) {
      const int here = step > 0 ? 0 : 3, there = 3 - here;
      Symmetric<6> k{};
      add_nodal(element(step > 0 ? node : node - 1), 0, k);
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) k.k[here + i][here + j] = k.k[here + i][here + j] + end.k[i][j];
      eliminate(node, here, k);
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) end.k[i][j] = k.k[there + i][there + j];
    }
    return end;
  }

  /// Stiffness of the shells between two contacts with nodes between them.
  Symmetric<6> between(int from, int to) const {
    Symmetric<6> piece{};
    add_nodal(element(from), 0, piece);
    for (int node = from + 1; node < to; ++node) {
      Symmetric<9> k{};
      for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) k.k[i][j] = piece.k[i][j];
      add_nodal(element(node), 3, k);
      eliminate(node, 3, k);
      const auto place = [](int i) { return i < 3 ? i : i + 3; };
      for (int i = 0; i < 6; ++i)
        for (int j = i; j < 6; ++j) piece.k[i][j] = k.k[place(i)][place(j)];
    }
    return piece;
  }

  static void add(const Symmetric<3>& end, NutSupport<Real>& support) {
    Real* next = support.stiffness;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j) *next++ += end.k[i][j].rounded();
  }

  static void set_segment(const Symmetric<6>& k, NutSegment<Real>& s) {
    int upper = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j, ++upper) {
        s.first[upper] = k.k[i][j].rounded();
        s.second[upper] = k.k[3 + i][3 + j].rounded();
      }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) s.coupling[3 * i + j] = k.k[i][3 + j].rounded();
    Real* next = s.deformation;
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j) {
        const int a = i % 3, b = j % 3;
        const Wide &first = k(a, b), &second = k(3 + a, 3 + b);
        const Wide &across = k.k[a][3 + b], &back = k.k[b][3 + a];
        if (j < 3)
          *next++ = ((first + second) - (across + back)).scaled(0.25).rounded();
        else if (i < 3)
          *next++ = ((second - first) + (back - across)).scaled(0.5).rounded();
        else
          *next++ = ((first + second) + (across + back)).rounded();
      }
  }

  /// Sets the segment of one shell.
  static void set_segment(const fe::ShellBlocks<Real>& b, NutSegment<Real>& s) {
    const Real none(0.0), v = 0.25 * b.vv, t = 0.25 * b.mm, uv = 0.5 * b.uv, vt = 0.5 * (b.dm + b.tv),
                          skew = 0.5 * (b.dm - b.tv);
    const Real dd = b.dd + v, tt = b.tt + t;
    const Real first[] = {b.uu, -uv, b.ut, dd, -vt, tt}, second[] = {b.uu, uv, b.ut, dd, vt, tt};
    const Real coupling[] = {-b.uu, -uv, -b.ut, uv, v - b.dd, -skew, -b.ut, skew, t - b.tt};
    const Real deformation[] = {b.uu, none, b.ut, none, b.uv, none,   // u_2 - u_1
                                b.dd, none, none, none, b.dm,         // v_2 - v_1
                                b.tt, none, b.tv, none,               // theta_2 - theta_1
                                none, none, none, b.vv, none, b.mm};  // means
    for (int i = 0; i < 6; ++i) {
      s.first[i] = first[i];
      s.second[i] = second[i];
    }
    for (int i = 0; i < 9; ++i) s.coupling[i] = coupling[i];
    for (int i = 0; i < 21; ++i) s.deformation[i] = deformation[i];
  }

  const NutShape& shape_;
  const NutHolds& holds_;
  const fe::ShellBlocks<Real>* shells_;
  Real inverse_radius_;
};

}  // namespace prs
