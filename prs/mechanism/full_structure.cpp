#include "prs/mechanism/full_structure.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <memory>

#include "prs/indices.h"

namespace prs {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using fe::Dof;
using fe::LinearForm;

struct Direction2 {
  double y, z;  ///< e_j
};

/// Adds `factor` times the displacement of the axis along e, or times its slope.
void add_along(LinearForm& form, const SpatialNode& n, Dof dof, Direction2 e, double factor) {
  form.push_back({n.y_plane, dof, factor * e.y});
  form.push_back({n.z_plane, dof, factor * e.z});
}

class Builder {
 public:
  Builder(const FullModel& model, const std::optional<FullMesh>& mesh)
      : f_(model), mesh_(mesh), same_(kSamePlace * model.sector.nut_length) {}

  FullStructure build() {
    s_.screw = body(screw_stations(), f_.screw);
    s_.nut = body(nut_stations(), f_.nut);
    if (f_.nut_wall) add_wall(*f_.nut_wall);
    s_.loaded = nearest(s_.screw, f_.loaded_section);
    add_rings();
    add_housing();
    add_bearings();  // Added before the guides, which may follow their nodes.
    for (const FullModel::Roller& r : f_.present) add_roller(r);
    add_stops();
    add_loads();
    return std::move(s_);
  }

 private:
  double outer(int ring) const { return ring == 0 ? f_.roller_ends.first : f_.roller_ends.last; }
  /// x of the middle of a ring.
  double ring_middle(int ring) const { return outer(ring) + (ring == 0 ? 0.5 : -0.5) * f_.sector.end_length; }

  void add_contact_stations(std::vector<double>& x) const {
    for (const FullModel::Roller& r : f_.present) append(x, r.contact_x);
  }
  void add_ring_stations(std::vector<double>& x, Rings::Carrier body, const std::vector<BodyPiece>& pieces) const {
    if (f_.carrier != body) return;
    for (int ring = 0; ring < 2; ++ring)
      x.push_back(std::clamp(ring_middle(ring), pieces.front().from, pieces.back().to));
  }
  std::vector<double> screw_stations() const {
    std::vector<double> x{f_.loaded_section, f_.screw.back().to};
    add_contact_stations(x);
    add_ring_stations(x, Rings::Carrier::screw, f_.screw);
    for (const Bearing& b : f_.bearings) x.push_back(b.position);
    for (const auto& at : {f_.load.side_force.at, f_.load.moment.at})
      if (at) x.push_back(*at);
    if (mesh_) append(x, mesh_->screw);
    return x;
  }
  std::vector<double> nut_stations() const {
    std::vector<double> x{f_.thrust};
    add_contact_stations(x);
    if (f_.nut_wall) {
      const std::vector<double>& line = f_.nut_wall->line.sections;
      append(x, line);
    }
    add_ring_stations(x, Rings::Carrier::nut, f_.nut);
    const auto [first, last] = std::ranges::minmax(x);
    for (const BodyPiece& piece : f_.nut)
      if (piece.from > first && piece.from < last) x.push_back(piece.from);
    if (mesh_) append(x, mesh_->nut);
    return x;
  }

  /// Adds beams in both planes between stations.
  std::vector<SpatialNode> body(std::vector<double> x, const std::vector<BodyPiece>& pieces) {
    std::ranges::sort(x);
    x.erase(std::unique(x.begin(), x.end(), [&](double a, double b) { return b - a < same_; }), x.end());
    if (mesh_) divide(x);
    std::vector<SpatialNode> nodes;
    for (const double at : x) {
      const int y_plane = s_.model.add_node(), z_plane = s_.model.add_node();
      hold_still(z_plane, Dof::u);
      nodes.push_back({at, y_plane, z_plane, y_plane});
    }
    std::vector<bool> placed(nodes.size(), false);
    if (mesh_) join_near(nodes, pieces, placed);
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      if (placed[i]) continue;
      const SpatialNode &a = nodes[i - 1], &b = nodes[i];
      const RollerSection<double>& section = section_at(pieces, 0.5 * (a.x + b.x));
      s_.model.beams.push_back({a.y_plane, b.y_plane, beam(section, b.x - a.x, true)});
      s_.model.beams.push_back({a.z_plane, b.z_plane, beam(section, b.x - a.x, false)});
    }
    return nodes;
  }
  static fe::Beam beam(const RollerSection<double>& section, double length, bool has_bar) {
    return {has_bar ? section.axial : 0.0, section.bending, section.shear, length};
  }

  void divide(std::vector<double>& x) const {
    std::vector<double> all{x.front()};
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double from = x[i - 1], length = x[i] - from;
      const double pieces = std::max(1.0, std::ceil(length / mesh_->longest - 1e-9));
      for (double k = 1.0; k < pieces; ++k) all.push_back(from + length * k / pieces);
      all.push_back(x[i]);
    }
    x = std::move(all);
  }

  /// Joins successive nodes that are close: nodes that may be held stay free and the others follow. `done`: whether the
  /// piece before each node is joined.
  void join_near(const std::vector<SpatialNode>& nodes, const std::vector<BodyPiece>& pieces, std::vector<bool>& done) {
    const auto near = [&](std::size_t i) { return nodes[i].x - nodes[i - 1].x < kNearNodes; };
    const auto may_be_held = [&](double x) {
      const auto there = [&](double held) { return std::abs(x - held) <= same_; };
      return there(f_.thrust) || there(f_.loaded_section) ||
             std::ranges::any_of(f_.bearings, [&](const Bearing& b) { return there(b.position); });
    };
    for (std::size_t first = 0, end = 1; first < nodes.size(); first = end++) {
      while (end < nodes.size() && near(end)) ++end;
      std::size_t root = first;
      for (std::size_t i = first; i < end; ++i)
        if (may_be_held(nodes[i].x)) root = i;
      for (std::size_t i = root; i-- > first && !may_be_held(nodes[i].x);) {
        follow(nodes[i + 1], nodes[i], section_at(pieces, 0.5 * (nodes[i].x + nodes[i + 1].x)));
        done[i + 1] = true;
      }
      for (std::size_t i = root + 1; i < end; ++i) {
        follow(nodes[i - 1], nodes[i], section_at(pieces, 0.5 * (nodes[i].x + nodes[i - 1].x)));
        done[i] = true;
      }
    }
  }
  /// Makes `node` follow `before` rigidly, plus the end of a beam clamped there.
  void follow(const SpatialNode& before, const SpatialNode& node, const RollerSection<double>& section) {
    const double arm = node.x - before.x;
    const int clamped = s_.model.add_node();
    for (const Dof dof : {Dof::u, Dof::v, Dof::theta}) hold_still(clamped, dof);
    for (const bool y : {true, false}) {
      const int from = y ? before.y_plane : before.z_plane, to = y ? node.y_plane : node.z_plane;
      const int own = s_.model.add_node();
      if (y)
        s_.model.constraints.push_back({to, Dof::u, {{from, Dof::u, 1.0}, {own, Dof::u, 1.0}}, 0.0});
      else
        hold_still(own, Dof::u);
      s_.model.constraints.push_back(
          {to, Dof::v, {{from, Dof::v, 1.0}, {from, Dof::theta, arm}, {own, Dof::v, 1.0}}, 0.0});
      s_.model.constraints.push_back({to, Dof::theta, {{from, Dof::theta, 1.0}, {own, Dof::theta, 1.0}}, 0.0});
      s_.model.beams.push_back({arm > 0.0 ? clamped : own, arm > 0.0 ? own : clamped, beam(section, std::abs(arm), y)});
    }
  }

  /// Moves the nut's u to its wall, and adds the wall's harmonics, cos before sin, after it.
  void add_wall(const NutWall& wall) {
    for (fe::BeamElement& b : s_.model.beams)
      if (b.first >= s_.nut.front().y_plane) b.beam.axial_rigidity = 0.0;
    for (const SpatialNode& n : s_.nut) hold_still(n.y_plane, Dof::u);
    const int nodes = 1 + 2 * static_cast<int>(wall.harmonics.size());
    SpatialNode* before = nullptr;
    for (const auto i : indices(wall.line.sections)) {
      SpatialNode& n = item_at(s_.nut, nearest(s_.nut, wall.line.sections[i]));
      n.axial = n.wall = s_.model.nodes;
      s_.model.nodes += nodes;
      if (wall.shell.radially_rigid) hold_still(n.wall, Dof::v);
      for (int k = 1; k < nodes; ++k) hold_still(n.wall + k, Dof::u);
      if (before) {
        s_.model.shells.push_back({before->wall, n.wall, wall.shell.segments[i - 1]});
        for (int k = 1; k < nodes; ++k)
          s_.model.shells.push_back(
              {before->wall + k, n.wall + k, wall.harmonics[static_cast<std::size_t>(k - 1) / 2].segments[i - 1]});
      }
      before = &n;
    }
    if (wall.shell.straight_thrust_section) hold_still(at(s_.nut, f_.thrust).wall, Dof::theta);
  }
  void hold_still(int node, Dof dof) { s_.model.fixed_supports.push_back({node, dof}); }

  int nearest(const std::vector<SpatialNode>& nodes, double x) const {
    const auto found = std::ranges::min_element(nodes, {}, [&](const SpatialNode& n) { return std::abs(n.x - x); });
    return static_cast<int>(found - nodes.begin());
  }
  const SpatialNode& at(const std::vector<SpatialNode>& nodes, double x) const {
    return item_at(nodes, nearest(nodes, x));
  }

  void add_rings() {
    if (f_.carrier != Rings::Carrier::housing) {
      const auto& carrier = f_.carrier == Rings::Carrier::nut ? s_.nut : s_.screw;
      for (int ring = 0; ring < 2; ++ring) item_at(s_.seats, ring) = &at(carrier, ring_middle(ring));
    }
    if (!f_.floating_rings()) return;
    for (int& ring : s_.rings) {
      ring = s_.model.add_node();
      s_.model.elastic_supports.push_back({ring, Dof::u, f_.ring_stiffness});
      s_.model.elastic_supports.push_back({ring, Dof::v, f_.ring_stiffness});
    }
  }

  void add_roller(const FullModel::Roller& r) {
    FullStructure::Roller roller;
    const SectorModel& sector = f_.sector;
    const double first = f_.roller_ends.first, last = f_.roller_ends.last;
    const double half = sector.contact_half_distance;
    std::vector<double> x{first, first + sector.end_length};
    for (const double contact : r.contact_x) {
      x.push_back(contact - half);
      if (sector.contacts_apart()) x.push_back(contact + half);
    }
    x.insert(x.end(), {last - sector.end_length, last});
    for (const auto i : indices(x)) {
      const bool same = i > 0 && x[i] - x[i - 1] < same_;
      const int node = same ? roller.nodes.back() : s_.model.add_node();
      if (!same && i > 0) {
        const bool end = i == 1 || i + 1 == x.size();
        const RollerSection<double>& section = end ? sector.end : sector.thread;
        s_.model.beams.push_back(
            {roller.nodes.back(), node, {section.axial, section.bending, section.shear, x[i] - x[i - 1]}});
        if (!f_.push.empty()) {
          const RollerPush& push = f_.push[s_.rollers.size()];
          const double weight = (end ? push.of_heads : push.of_thread) * (x[i] - x[i - 1]);
          for (const int at : {roller.nodes.back(), node}) s_.loads.push_back({at, Dof::v, 0.5 * weight});
        }
      }
      if (!same) {
        roller.nodes.push_back(node);
        roller.x.push_back(x[i]);
      }
      if (i >= 2 && i + 2 < x.size())
        for (const Interface at : kInterfaces) {
          // Two contacts of a tooth: the screw's faces against the load.
          const bool second = (at == Interface::screw) == (f_.sense() < 0.0);
          if (!sector.contacts_apart() || (i % 2 == 1) == second) roller.contacts[at].push_back(node);
        }
      if (i < 2) roller.guided[0].push_back(node);
      if (i + 2 >= x.size()) roller.guided[1].push_back(node);
    }
    const Direction2 e{std::cos(r.azimuth), std::sin(r.azimuth)};
    guide(r, roller, e, x);
    roller.first_spring = static_cast<int>(s_.model.form_springs.size());
    for (const Interface i : kInterfaces)
      for (const auto k : indices(r.contact_x)) add_contact(i, r, roller.contacts[i][k], k, e);
    s_.rollers.push_back(std::move(roller));
  }

  /// Adds v = e.[d_B + beta_B (x - x_B) + o_r] + delta, rigid or by springs.
  void guide(const FullModel::Roller& r, const FullStructure::Roller& roller, Direction2 e,
             const std::vector<double>& x) {
    if (!f_.sector.bends()) {
      for (const int node : roller.nodes)
        for (const Dof dof : {Dof::v, Dof::theta}) hold_still(node, dof);
      return;
    }
    const std::array<std::size_t, 4> places{0, 1, x.size() - 2, x.size() - 1};
    for (const auto p : up_to(4)) {
      const std::size_t ring = p / 2;
      const double stiffness = p == 0 || p == 3 ? f_.sector.outer_guide : f_.sector.inner_guide;
      if (stiffness == 0.0) continue;
      const int node = roller.guided[ring][p % 2];
      LinearForm form;
      double offset = r.ring_offset[ring];
      if (const SpatialNode* seat = s_.seats[ring]) {
        add_along(form, *seat, Dof::v, e, 1.0);
        add_along(form, *seat, Dof::theta, e, x[places[p]] - seat->x);
      } else {
        const Lateral moved = rigid_offset(f_, x[places[p]]);
        offset -= e.y * moved.y + e.z * moved.z;
      }
      if (f_.floating_rings()) {
        form.push_back({s_.rings[ring], Dof::u, e.y});
        form.push_back({s_.rings[ring], Dof::v, e.z});
      }
      FullStructure::Guide guide{s_.rollers.size(), ring, x[places[p]]};
      if (stiffness == kHeld) {
        guide.constraint = static_cast<int>(s_.model.constraints.size());
        s_.model.constraints.push_back({node, Dof::v, std::move(form), offset});
        s_.guides.push_back(guide);
        continue;
      }
      for (fe::Term& term : form) term.coefficient = -term.coefficient;
      form.push_back({node, Dof::v, 1.0});
      if (f_.sector.has_loose_guides()) {
        guide.stop = static_cast<int>(stops_.size());
        for (const double side : {1.0, -1.0}) {
          stops_.push_back({form, f_.sector.ring_guide().stop()});
          stops_.back().law.gap += side * offset;
          for (fe::Term& term : form) term.coefficient = -term.coefficient;
        }
      } else {
        guide.link = static_cast<int>(s_.model.elastic_links.size());
        s_.model.elastic_links.push_back({std::move(form), offset, stiffness});
      }
      s_.guides.push_back(guide);
    }
  }

  /// Adds the stops of guides with a clearance, after the springs of all contacts.
  void add_stops() {
    const auto contacts = static_cast<int>(s_.model.form_springs.size());
    for (FullStructure::Guide& guide : s_.guides)
      if (guide.stop >= 0) guide.stop += contacts;
    append(s_.model.form_springs, stops_);
    if (!s_.per_force.empty()) s_.per_force.resize(s_.model.form_springs.size());
  }

  /// Adds the approach along the normal, with arms a - r_R on the screw and a + r_R on the nut.
  void add_contact(Interface i, const FullModel::Roller& r, int node, std::size_t k, Direction2 e) {
    const bool screw = i == Interface::screw;
    const double sign = screw ? 1.0 : -1.0;
    const SpatialNode& body = at(screw ? s_.screw : s_.nut, r.contact_x[k]);
    const double arm = f_.centre_distance - sign * f_.sector.roller_radius;
    const auto row = [&](double along, double across) {
      LinearForm w;
      w.push_back({body.axial, Dof::u, sign * along});
      add_along(w, body, Dof::theta, e, -sign * along * arm);
      w.push_back({node, Dof::u, -sign * along});
      w.push_back({node, Dof::theta, -along * f_.sector.roller_radius});
      add_along(w, body, Dof::v, e, sign * across);
      w.push_back({node, Dof::v, -sign * across});
      if (body.wall >= 0) add_wall_motion(w, body, r.azimuth, along, across);
      return w;
    };
    s_.model.form_springs.push_back({row(f_.sense() * f_.sector.cosine[i], f_.sector.sine[i]),
                                     {f_.sector.hertz_constant[i], r.gaps[i][k], f_.sector.contact_compliance(i, k)}});
    if (f_.push.empty()) return;
    const RollerPush& push = f_.push[s_.rollers.size()];
    std::vector<fe::NodalLoad>& loads = push.per_normal_load ? s_.per_force.emplace_back() : s_.loads;
    for (const fe::Term& t : row(push.axial[i][k], push.radial[i][k]))
      loads.push_back({t.node, t.dof, -sign * t.coefficient});
  }

  /// The nut's contacts are at an arm from the u of its wall, and move outwards with the wall.
  void add_wall_motion(LinearForm& w, const SpatialNode& body, double azimuth, double along, double across) const {
    w.push_back({body.wall, Dof::theta, along * f_.nut_wall->shell.contact_arm});
    w.push_back({body.wall, Dof::v, -across});
    int node = body.wall;
    for (const NutHarmonic& h : f_.nut_wall->harmonics) {
      w.push_back({++node, Dof::v, -across * std::cos(h.order * azimuth)});
      w.push_back({++node, Dof::v, -across * std::sin(h.order * azimuth)});
    }
  }

  FullStructure::Held hold(int node, Dof dof, double stiffness, double rest) {
    FullStructure::Held held{node, dof};
    if (stiffness == kRigid) {
      held.constraint = static_cast<int>(s_.model.constraints.size());
      s_.model.constraints.push_back({node, dof, {}, rest});
    } else if (stiffness > 0.0) {
      held.link = static_cast<int>(s_.model.elastic_links.size());
      s_.model.elastic_links.push_back({{{node, dof, 1.0}}, rest, stiffness});
    }
    return held;
  }

  void add_housing() {
    const SpatialNode& n = at(s_.nut, f_.thrust);
    const Housing& h = f_.housing;
    s_.housing = {n.x,
                  hold(n.axial, Dof::u, h.axial, 0.0),
                  hold(n.y_plane, Dof::v, h.lateral, 0.0),
                  hold(n.z_plane, Dof::v, h.lateral, 0.0),
                  hold(n.y_plane, Dof::theta, h.tilt, 0.0),
                  hold(n.z_plane, Dof::theta, h.tilt, 0.0)};
  }

  void add_bearings() {
    const Lateral slope = rigid_slope(f_);
    for (const Bearing& b : f_.bearings) {
      const SpatialNode& n = at(s_.screw, b.position);
      const Lateral moved = rigid_offset(f_, b.position);
      s_.bearings.push_back({n.x,
                             {},
                             hold(n.y_plane, Dof::v, b.lateral, b.offset.y - moved.y),
                             hold(n.z_plane, Dof::v, b.lateral, b.offset.z - moved.z),
                             hold(n.y_plane, Dof::theta, b.tilt, b.angle.z - slope.y),
                             hold(n.z_plane, Dof::theta, b.tilt, -b.angle.y - slope.z)});
    }
  }

  void add_loads() {
    const double force = f_.sense() * f_.axial_force;
    const SpatialNode& end = item_at(s_.screw, s_.loaded);
    s_.loads.push_back({end.y_plane, Dof::u, force});
    s_.loads.push_back({end.y_plane, Dof::theta, -force * f_.load.eccentricity.y});
    s_.loads.push_back({end.z_plane, Dof::theta, -force * f_.load.eccentricity.z});
    const SpatialLoad::Across& side = f_.load.side_force;
    const SpatialLoad::Across& moment = f_.load.moment;
    const SpatialNode& at_side = at(s_.screw, side.at.value_or(f_.loaded_section));
    s_.loads.push_back({at_side.y_plane, Dof::v, side.value.y});
    s_.loads.push_back({at_side.z_plane, Dof::v, side.value.z});
    const SpatialNode& at_moment = at(s_.screw, moment.at.value_or(f_.loaded_section));
    s_.loads.push_back({at_moment.y_plane, Dof::theta, moment.value.z});
    s_.loads.push_back({at_moment.z_plane, Dof::theta, -moment.value.y});
  }

  const FullModel& f_;
  const std::optional<FullMesh>& mesh_;
  double same_;
  FullStructure s_;
  std::vector<fe::FormSpring> stops_;
};

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
    for (const auto r : indices(s.rollers)) {
      const int first = add_part(fmt::format("roller {}", f.present[r].number + 1), 3);
      for (const auto k : indices(s.rollers[r].nodes))
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
  void add(const LinearForm& form, RowOf row) const {
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
  Row& at(int node, Dof dof) { return item_at(rows_, fe::kDofsPerNode * node + static_cast<int>(dof)); }
  const Row& at(int node, Dof dof) const { return const_cast<Motions*>(this)->at(node, dof); }

  double arm_, middle_;
  int count_ = 0;
  std::vector<Part> parts_;
  std::vector<Row> rows_;
};

/// Rows of bilateral forces: constraints, supports and springs.
std::vector<LinearForm> bilateral(const fe::Model& model) {
  std::vector<LinearForm> forms;
  for (const fe::Constraint& c : model.constraints) {
    forms.push_back(c.form);
    forms.back().push_back({c.node, c.dof, -1.0});
  }
  for (const fe::ElasticLink& e : model.elastic_links) forms.push_back(e.form);
  for (const fe::ElasticSupport& e : model.elastic_supports) forms.push_back({{e.node, e.dof, 1.0}});
  for (const fe::FixedSupport& e : model.fixed_supports)
    if (e.dof != Dof::u) forms.push_back({{e.node, e.dof, 1.0}});  // No rigid part has freedoms u.
  return forms;
}

MatrixXd rows_over(const Motions& motions, const std::vector<LinearForm>& forms) {
  MatrixXd rows = MatrixXd::Zero(static_cast<Index>(forms.size()), static_cast<Index>(motions.count()));
  for (const auto i : indices(forms)) motions.add(forms[i], rows.row(static_cast<Index>(i)));
  return rows;
}

/// Rows that are not zero, scaled to norm one.
MatrixXd unit_rows(const MatrixXd& rows) {
  MatrixXd units(rows.rows(), rows.cols());
  Index count = 0;
  for (Index i = 0; i < rows.rows(); ++i)
    if (const double norm = rows.row(i).norm(); norm > 0.0) units.row(count++) = rows.row(i) / norm;
  return units.topRows(count);
}

/// Whether the smallest singular value of a triangle is above kNoResistance times the largest, by
/// 1/|R^-1| and |R| in Frobenius' norm, which bound them; far cheaper than the values.
bool surely_regular(const MatrixXd& r) {
  const MatrixXd inverse = r.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(r.rows(), r.cols()));
  return kNoResistance * r.norm() * inverse.norm() < 1.0;  // false with NaN and infinity.
}

/// x >= 0 that minimises |A x - b| (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23); returns the
/// remaining part of b.
VectorXd left_by_pushing(const MatrixXd& a, const VectorXd& b) {
  const double small = 1e-12 * b.norm();
  VectorXd x = VectorXd::Zero(a.cols());
  std::vector<Index> pushing;
  const auto solved = [&] {
    MatrixXd columns(a.rows(), static_cast<Index>(pushing.size()));
    for (const auto k : indices(pushing)) columns.col(static_cast<Index>(k)) = a.col(pushing[k]);
    return VectorXd(columns.colPivHouseholderQr().solve(b));
  };
  for (Index step = 0; step < 3 * a.cols(); ++step) {
    const VectorXd left = b - a * x;
    VectorXd gain = a.transpose() * left;
    for (const Index k : pushing) gain[k] = 0.0;
    Index best = 0;
    if (left.norm() <= small || gain.maxCoeff(&best) <= 1e-10 * b.norm()) return left;
    pushing.push_back(best);
    for (VectorXd wanted = solved();; wanted = solved()) {
      double length = 1.0;
      for (const auto k : indices(pushing))
        if (const double to = wanted[static_cast<Index>(k)]; to <= 0.0)
          length = std::min(length, x[pushing[k]] / std::max(x[pushing[k]] - to, 1e-300));
      for (const auto k : indices(pushing)) x[pushing[k]] += length * (wanted[static_cast<Index>(k)] - x[pushing[k]]);
      if (length == 1.0) break;
      std::erase_if(pushing, [&](Index k) {
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

Lateral rigid_slope(const FullModel& f) { return {f.load.nut_tilt.z, -f.load.nut_tilt.y}; }

Lateral rigid_offset(const FullModel& f, double x) {
  const Lateral slope = rigid_slope(f);
  return {f.load.nut_offset.y + slope.y * (x - f.thrust), f.load.nut_offset.z + slope.z * (x - f.thrust)};
}

FullStructure full_structure(const FullModel& model, const std::optional<FullMesh>& mesh) {
  return Builder(model, mesh).build();
}

const RollerSection<double>& section_at(const std::vector<BodyPiece>& pieces, double x) {
  return std::ranges::find_if(pieces.begin(), pieces.end() - 1, [&](const BodyPiece& p) { return x < p.to; })->section;
}

double load_left(const FullModel& f, const FullStructure& s) {
  const Motions motions(f, s);
  std::vector<LinearForm> contacts;
  for (const fe::FormSpring& spring : s.model.form_springs) contacts.push_back(spring.approach);
  LinearForm& load = contacts.emplace_back();  // The load is the last column.
  for (const fe::NodalLoad& l : s.loads) load.push_back({l.node, l.dof, l.value / f.axial_force});
  MatrixXd push = rows_over(motions, contacts).transpose();

  // Loads that guides and bearings can take are excluded: only the complement of their range counts.
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(rows_over(motions, bilateral(s.model)).transpose());
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

FreeMotions free_motions(const FullModel& f, const FullStructure& s, const std::vector<bool>& closed) {
  const Motions motions(f, s);
  std::vector<LinearForm> forms = bilateral(s.model);
  const auto is_closed = [&](int spring) { return closed.empty() || item_at(closed, spring); };
  const auto add = [&](int spring) { forms.push_back(item_at(s.model.form_springs, spring).approach); };
  // Rows of a roller are linear in x: any two span those between them.
  for (const FullStructure::Roller& r : s.rollers)
    for (const Interface i : kInterfaces) {
      std::size_t first = 0, last = r.contacts[i].size();
      while (first < last && !is_closed(r.spring(i, first))) ++first;
      while (last > first && !is_closed(r.spring(i, last - 1))) --last;
      if (first < last) add(r.spring(i, first));
      if (first + 1 < last) add(r.spring(i, last - 1));
    }
  for (const FullStructure::Guide& guide : s.guides)
    if (guide.stop >= 0 && (is_closed(guide.stop) || is_closed(guide.stop + 1))) add(guide.stop);
  const MatrixXd rows = unit_rows(rows_over(motions, forms));
  const Index count = std::min(rows.rows(), rows.cols());
  MatrixXd r = MatrixXd::Zero(rows.cols(), rows.cols());
  r.topRows(count) = Eigen::HouseholderQR<MatrixXd>(rows).matrixQR().topRows(count).triangularView<Eigen::Upper>();
  if (surely_regular(r)) return {};
  const Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner> svd(r, Eigen::ComputeFullV);
  const VectorXd& sizes = svd.singularValues();
  FreeMotions free;
  for (Index m = 0; m < svd.matrixV().cols(); ++m) {
    if (sizes[m] > kNoResistance * sizes[0]) continue;
    ++free.count;
    const VectorXd motion = svd.matrixV().col(m);
    for (int part = 0; part < motions.count(); ++part)
      if (std::abs(motion[part]) > 1e-6 && !contains(free.parts, motions.part(part)))
        free.parts.push_back(motions.part(part));
  }
  return free;
}

std::string why_free(const FreeMotions& free) {
  return fmt::format("mechanism: {} motion{} of {} meet{} no resistance", free.count, free.count == 1 ? "" : "s",
                     free.parts.front(), free.count == 1 ? "s" : "");
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
