#include "prs/mechanism/full_influence.h"

#include <Eigen/LU>

#include "prs/indices.h"
#include "prs/mechanism/contacts_around.h"
#include "prs/mechanism/full_structure.h"

namespace prs {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Share of the mean load below which a roller carries nothing.
constexpr double kIdle = 1e-6;

/// Middles of the rings that a body carries, inside the body.
std::vector<double> ring_sections(const FullModel& f, Rings::Carrier body, const std::vector<BodyPiece>& pieces,
                                  double origin) {
  std::vector<double> sections;
  if (f.carrier != body) return sections;
  for (const double x : guide_places(f))
    sections.push_back(std::clamp(x, pieces.front().from, pieces.back().to) - origin);
  return sections;
}

/// A held lateral displacement or slope of a station of the screw. Slopes, like all rotations here, are times r_R and
/// moments over r_R.
struct Held {
  Index freedom = 0;  ///< Index among the stations' freedoms, two for each, the displacement first.
  double stiffness = kRigid;
  Lateral rest;
};

/// Components in the frame that turns with the first roller.
Lateral turned(const Lateral& l, double angle) {
  return {along(l, angle), l.z * std::cos(angle) - l.y * std::sin(angle)};
}
double component(const Lateral& l, bool sine) { return sine ? l.z : l.y; }

/// The contact problem, built from the view of one roller: vectors over its contacts, those at the screw first, of
/// which waves of order 1 take cos(theta_j) or sin(theta_j) times sqrt(N/2).
class Assembly {
 public:
  Assembly(const FullModel& f, const FullBodies& bodies) : f_(f), threads_(f.threads()), arm_(f.sector.roller_radius) {
    const Index contacts = 2 * threads_;
    screw_ = nut_ = MatrixXd::Zero(contacts, 3);
    lines_.resize(contacts, 2);
    roller_.resize(contacts);
    problem.hertz_constant.resize(contacts);
    add_contacts();
    find_stations(bodies);
    carry_rings();
    add_modes(bodies);
    add_waves();
    add_gaps();
  }

  ContactsAround problem;

  ContactsAroundOptions options() const {
    ContactsAroundOptions o;
    const double contact = f_.axial_force / (static_cast<double>(f_.present.size()) * f_.threads() *
                                             std::max(f_.sector.cosine.screw, f_.sector.cosine.nut));
    o.force = f_.axial_force;
    o.length = std::pow(contact / problem.hertz_constant.mean(), 2.0 / 3.0);
    o.stiffness = contact / o.length;
    return o;
  }
  /// Adds a change of the nut's flexibility that is equal for all pairs of rollers.
  void add_to_nut(const MatrixXd& change) {
    problem.modes[0].flexibility.bottomRightCorner(threads_, threads_) += f_.rollers * change;
  }
  VectorXd mean_nut_load(const MatrixXd& loads) const {
    return loads.bottomRows(threads_).rowwise().sum() / f_.rollers;
  }
  int freedoms() const {
    const auto rollers = static_cast<Index>(f_.present.size());
    const auto held = static_cast<Index>(held_.size());
    return static_cast<int>((2 * threads_ + 1) * rollers + 5 + 2 * (floating() + held));
  }

  void read(const ContactsAroundSolution& s, FullDistribution& d) const {
    read_rollers(s, d);
    SupportForce nut{f_.thrust, Eigen::Vector3d::Zero(), {}};
    Lateral turning;
    for (const FullModel::Roller& r : f_.present) {
      const Eigen::Vector3d push = nut_.transpose() * s.normal_load.col(r.number);
      nut.force += Eigen::Vector3d(push[0], push[1] * std::cos(r.azimuth), push[1] * std::sin(r.azimuth));
      turning.y += push[2] * std::cos(r.azimuth);
      turning.z += push[2] * std::sin(r.azimuth);
    }
    nut.moment = {-turning.z * arm_, turning.y * arm_};
    d.nut = nut;
    const double u = s.motion[0][0];
    const Lateral across = across_of(s, 0), slope = across_of(s, 1);
    d.screw_end.displacement << u, across.y, across.z, -slope.z / arm_, slope.y / arm_;
    d.axial_displacement = f_.sense() * u;
    read_bearings(s, d);
  }

  /// Adds the compliance, in the order of the freedoms of the screw's end.
  void add_compliance(const ContactsAroundSolution& s, FullDistribution& d) const {
    const std::vector<WaveMotion> motions{{0, 0}, {1, 0}, {2, 0}, {1, 1}, {2, 1}};
    const MatrixXd turning = compliance(problem, s, options(), motions);
    const double c = std::cos(f_.load.carrier_angle), n = std::sin(f_.load.carrier_angle);
    Eigen::Matrix<double, 5, 5> turn = Eigen::Matrix<double, 5, 5>::Zero();
    turn(0, 0) = 1.0;
    turn.block<2, 2>(1, 1) << c, -n, n, c;
    turn.block<2, 2>(3, 3) << -n / arm_, -c / arm_, c / arm_, -n / arm_;
    const MatrixXd all = turn * turning * turn.transpose();
    const bool across = is_held_at_end(&Bearing::lateral), tilt = is_held_at_end(&Bearing::tilt);
    for (int k = 0; k < 5; ++k)
      if (k == 0 || !(k < 3 ? across : tilt)) d.screw_end.freedoms.push_back(k);
    d.screw_end.compliance = all(d.screw_end.freedoms, d.screw_end.freedoms);
    d.screw_end.stiffness = d.screw_end.compliance.inverse();
    d.tangent_stiffness = 1.0 / axial_compliance(d.screw_end, f_.load.eccentricity);
  }

 private:
  Index row(Interface i, int thread) const { return (i == Interface::screw ? 0 : threads_) + thread; }
  /// Number of freedoms of rings that move against their carrier.
  Index floating() const { return f_.floating_rings() ? 2 : 0; }
  /// Index of the first reaction in waves of order 1, after the motions: lateral, slope, each roller along its axis,
  /// rings.
  Index first_reaction() const { return 3 + floating(); }
  Eigen::Index rings_on_screw() const { return f_.carrier == Rings::Carrier::screw ? 2 : 0; }

  void add_contacts() {
    const auto [near, far] = guide_places(f_);
    const std::vector<double>& contact_x = f_.present.front().contact_x;
    for (const Interface i : kInterfaces)
      for (int k = 0; k < f_.threads(); ++k) {
        const bool screw = i == Interface::screw;
        const double sign = screw ? 1.0 : -1.0, x = item_at(contact_x, k);
        const double along = f_.sense() * f_.sector.cosine[i], across = f_.sector.sine[i];
        const double radius = f_.centre_distance - sign * arm_;
        const double origin = screw ? f_.loaded_section : f_.thrust;
        (screw ? screw_ : nut_).row(row(i, k)) << sign * along, sign * across,
            sign * (-along * radius + across * (x - origin)) / arm_;
        roller_[row(i, k)] = -sign * along;
        // v of a line through both guides, and theta.
        const double at_far = (x - near) / (far - near), turn = -along * arm_ / (far - near);
        lines_.row(row(i, k)) << -sign * across * (1.0 - at_far) - turn, -sign * across * at_far + turn;
        problem.hertz_constant[row(i, k)] = f_.sector.hertz_constant[i];
      }
  }

  /// Computes approaches by loads on the stations of the screw, and displacements of the stations.
  void find_stations(const FullBodies& bodies) {
    stations_ = screw_stations(f_);
    const auto freedoms = 2 * static_cast<Index>(stations_.size());
    VectorXd units = VectorXd::Ones(freedoms);
    units(Eigen::seq(1, freedoms - 1, 2)).setConstant(arm_);
    by_stations_ = MatrixXd::Zero(2 * threads_, freedoms);
    if (freedoms > 0) {
      by_stations_.topRows(threads_) = -bodies.screw.coupling * units.asDiagonal();
      between_stations_ = units.asDiagonal() * bodies.screw.sections * units.asDiagonal();
    }
    rigid_stations_ = MatrixXd::Zero(freedoms, 2);
    for (Index k = 0; k < freedoms; k += 2)
      rigid_stations_.middleRows(k, 2) << 1.0, item_at(stations_, k / 2) / arm_, 0.0, 1.0;
    Index freedom = 2 * rings_on_screw();
    for (const Bearing& b : f_.bearings) {
      if (b.lateral > 0.0) held_.push_back({freedom, b.lateral, b.offset});
      if (b.tilt > 0.0) held_.push_back({freedom + 1, b.tilt / (arm_ * arm_), {arm_ * b.angle.z, -arm_ * b.angle.y}});
      freedom += 2;
    }
    loads_ = {MatrixXd::Zero(freedoms, 1), MatrixXd::Zero(freedoms, 1)};
    const SpatialLoad& l = f_.load;
    const auto add = [&](Index at, const Lateral& load) {
      const Lateral t = turned(load, l.carrier_angle);
      loads_[0](at) += t.y;
      loads_[1](at) += t.z;
    };
    if (l.side_force.at) {
      add(freedom, l.side_force.value);
      freedom += 2;
    }
    if (l.moment.at) add(freedom + 1, {l.moment.value.z / arm_, -l.moment.value.y / arm_});
    bodies_of_rings_ = f_.carrier == Rings::Carrier::screw ? &bodies.screw
                       : f_.carrier == Rings::Carrier::nut ? &bodies.nut
                                                           : nullptr;
  }

  /// Adds the deformation of the body that carries the rings by the rings' forces; its sections move the rings and with
  /// them the lines: more approaches by its motions and by loads on it.
  void carry_rings() {
    if (!bodies_of_rings_) return;
    const bool screw = f_.carrier == Rings::Carrier::screw;
    const std::array<double, 2> places = guide_places(f_);
    const double origin = screw ? f_.loaded_section : f_.thrust;
    for (Index ring = 0; ring < 2; ++ring) {
      MatrixXd& body = screw ? screw_ : nut_;
      body.col(1) += lines_.col(ring);
      body.col(2) += (item_at(places, ring) - origin) / arm_ * lines_.col(ring);
      if (screw) by_stations_ += lines_.col(ring) * between_stations_.row(2 * ring);
    }
  }

  void add_modes(const FullBodies& bodies) {
    const auto body = [&](std::size_t m) {
      MatrixXd c = bodies.roller;
      c.topLeftCorner(threads_, threads_) += bodies.screw.modes[m];
      c.bottomRightCorner(threads_, threads_) += bodies.nut.modes[m];
      c.diagonal().head(threads_).array() += f_.sector.compliance.screw;
      c.diagonal().tail(threads_).array() += f_.sector.compliance.nut;
      return c;
    };
    ContactsAround::Mode axial{body(0), MatrixXd(2 * threads_, 2), MatrixXd::Zero(2, 2), 0};
    axial.flexibility += f_.rollers / f_.housing.axial * nut_.col(0) * nut_.col(0).transpose();
    axial.rigid << std::sqrt(f_.rollers) * screw_.col(0), roller_;
    problem.modes.push_back(std::move(axial));
    problem.modes.push_back(bending(body(1)));
    for (std::size_t m = 2; m < bodies.screw.modes.size(); ++m)
      problem.modes.push_back({body(m), roller_, MatrixXd::Zero(1, 1), 0});
  }

  /// Mode of order 1, in the order of first_reaction: motions, then reactions of bearings. Soft rings move far more
  /// than contacts approach: as motions they keep the digits that their flexibility would lose.
  ContactsAround::Mode bending(MatrixXd flexibility) const {
    const double count = amplitude() * amplitude();
    const auto add = [&](const MatrixXd& by, double c) { flexibility += c * count * by * by.transpose(); };
    add(nut_.col(1), 1.0 / f_.housing.lateral);
    add(nut_.col(2), arm_ * arm_ / f_.housing.tilt);
    if (bodies_of_rings_) {
      const std::array<Index, 2> displacements{0, 2};
      MatrixXd coupling = MatrixXd::Zero(2 * threads_, 2);
      (f_.carrier == Rings::Carrier::screw ? coupling.topRows(threads_) : coupling.bottomRows(threads_)) =
          bodies_of_rings_->coupling(Eigen::all, displacements);
      const MatrixXd mixed = lines_ * coupling.transpose();
      flexibility += count * (lines_ * bodies_of_rings_->sections(displacements, displacements) * lines_.transpose() -
                              mixed - mixed.transpose());
    }
    const auto held = static_cast<Index>(held_.size());
    const Index first = first_reaction(), all = first + held;
    ContactsAround::Mode mode{std::move(flexibility), MatrixXd(2 * threads_, all), MatrixXd::Zero(all, all), held};
    mode.rigid.leftCols(first) << amplitude() * screw_.rightCols(2), roller_, amplitude() * lines_.leftCols(floating());
    mode.support.diagonal().segment(3, floating()).setConstant(f_.ring_stiffness);
    for (Index a = 0; a < held; ++a) {
      const Held& at = item_at(held_, a);
      mode.rigid.col(first + a) = amplitude() * by_stations_.col(at.freedom);
      mode.support.block(first + a, 0, 1, 2) = -rigid_stations_.row(at.freedom);
      mode.support.block(0, first + a, 2, 1) = -rigid_stations_.row(at.freedom).transpose();
      for (Index b = 0; b < held; ++b)
        mode.support(first + a, first + b) = -between_stations_(at.freedom, item_at(held_, b).freedom);
      mode.support(first + a, first + a) -= 1.0 / at.stiffness;
    }
    return mode;
  }

  /// Amplitude of cos(theta_j) over all rollers.
  double amplitude() const { return std::sqrt(f_.rollers == 2 ? 2.0 : 0.5 * f_.rollers); }

  void add_waves() {
    const int n = f_.rollers;
    const auto wave = [&](std::size_t mode, auto value) {
      ContactsAround::Wave w{mode, VectorXd(n), VectorXd::Zero(problem.modes[mode].rigid.cols())};
      for (int j = 0; j < n; ++j) w.shape[j] = value(j);
      if (const double size = w.shape.norm(); size > 0.0) w.shape /= size;
      problem.waves.push_back(std::move(w));
    };
    const auto angle = [n](std::size_t m, int j) { return 2.0 * std::numbers::pi * static_cast<double>(m) * j / n; };
    wave(0, [](int) { return 1.0; });
    for (std::size_t m = 1; 2 * m <= static_cast<std::size_t>(n); ++m) {
      wave(m, [&](int j) { return std::cos(angle(m, j)); });
      if (2 * m < static_cast<std::size_t>(n)) wave(m, [&](int j) { return std::sin(angle(m, j)); });
    }
    if (n == 2) {  // No contact resists motions across both rollers, only bearings do.
      ContactsAround::Mode alone = problem.modes[1];
      alone.flexibility.setZero();
      alone.rigid.setZero();
      alone.support(2, 2) = 1.0;
      problem.modes.push_back(std::move(alone));
      wave(2, [](int) { return 0.0; });
    }
    problem.waves[0].load[0] = f_.sense() * f_.axial_force;
    for (const bool sine : {false, true}) add_loads(problem.waves[sine ? 2 : 1].load, sine);
  }

  void add_loads(VectorXd& load, bool sine) const {
    const double force = f_.sense() * f_.axial_force;
    const SpatialLoad& l = f_.load;
    const Lateral side = l.side_force.at ? Lateral{} : l.side_force.value;
    const Lateral moment = l.moment.at ? Lateral{} : l.moment.value;
    const Lateral turning{(moment.z - force * l.eccentricity.y) / arm_, (-moment.y - force * l.eccentricity.z) / arm_};
    const MatrixXd& on_stations = loads_[sine];
    load.head(2) << component(turned(side, l.carrier_angle), sine), component(turned(turning, l.carrier_angle), sine);
    load.head(2) += rigid_stations_.transpose() * on_stations;
    for (const auto a : indices(held_)) {
      load[first_reaction() + static_cast<Index>(a)] = -component(turned(held_[a].rest, l.carrier_angle), sine);
      if (on_stations.size() > 0)
        load[first_reaction() + static_cast<Index>(a)] +=
            between_stations_.row(held_[a].freedom).dot(on_stations.col(0));
    }
  }

  void add_gaps() {
    problem.gap = MatrixXd::Zero(2 * threads_, f_.rollers);
    problem.present.assign(static_cast<std::size_t>(f_.rollers), false);
    const MatrixXd by_loads[] = {by_stations_ * loads_[0], by_stations_ * loads_[1]};
    for (const FullModel::Roller& r : f_.present) {
      item_at(problem.present, r.number) = true;
      auto gap = problem.gap.col(r.number);
      for (const Interface i : kInterfaces)
        for (int k = 0; k < f_.threads(); ++k) gap[row(i, k)] = item_at(r.gaps[i], k);
      gap -= lines_ * Eigen::Vector2d(r.ring_offset[0], r.ring_offset[1]);
      gap -=
          along(f_.load.nut_offset, r.azimuth) * nut_.col(1) + arm_ * along(rigid_slope(f_), r.azimuth) * nut_.col(2);
      const double theta = r.azimuth - f_.load.carrier_angle;
      gap -= std::cos(theta) * by_loads[0] + std::sin(theta) * by_loads[1];
    }
  }

  /// A lateral motion or reaction of the waves of order 1.
  Lateral across_of(const ContactsAroundSolution& s, Index motion) const {
    return turned({s.motion[1][motion], s.motion[2][motion]}, -f_.load.carrier_angle);
  }
  bool is_held_at_end(double Bearing::*stiffness) const {
    return std::ranges::any_of(f_.bearings, [&](const Bearing& b) {
      return b.*stiffness == kRigid && std::abs(b.position - f_.loaded_section) <= kSamePlace * f_.sector.nut_length;
    });
  }

  void read_rollers(const ContactsAroundSolution& s, FullDistribution& d) const {
    const auto threads = static_cast<std::size_t>(f_.threads());
    const double share = f_.axial_force / static_cast<double>(f_.present.size());
    const std::array<double, 2> places = guide_places(f_);
    for (const auto ring : up_to(2)) {
      d.rings[ring].position = places[ring];
      d.rings[ring].rollers.assign(static_cast<std::size_t>(f_.rollers), 0.0);
    }
    for (const Interface i : kInterfaces)
      d.normal_load[i] = d.approach[i] =
          RollerThreads(static_cast<std::size_t>(f_.rollers), std::vector<double>(threads, 0.0));
    for (const FullModel::Roller& r : f_.present) {
      const auto number = static_cast<std::size_t>(r.number);
      double carried = 0.0;
      for (const Interface i : kInterfaces)
        for (const auto k : up_to(threads)) {
          const Index at = row(i, static_cast<int>(k));
          const double load = s.normal_load(at, r.number), y = s.y(at, r.number);
          d.normal_load[i][number][k] = load;
          d.approach[i][number][k] = std::max(y, 0.0);
          d.largest_opening[i] = std::max(d.largest_opening[i], -y);
          if (i == Interface::screw) carried += load * f_.sector.cosine[i];
        }
      if (carried <= kIdle * share) d.idle_rollers.push_back(r.number);
      const Eigen::Vector2d guides = lines_.transpose() * s.normal_load.col(r.number);
      for (const auto ring : up_to(2)) {
        const double force = guides[static_cast<Index>(ring)];
        d.rings[ring].rollers[number] = force;
        d.rings[ring].force.y += force * std::cos(r.azimuth);
        d.rings[ring].force.z += force * std::sin(r.azimuth);
      }
    }
  }

  void read_bearings(const ContactsAroundSolution& s, FullDistribution& d) const {
    const Index first = 2 * rings_on_screw();
    for (const Bearing& b : f_.bearings) d.bearings.push_back({b.position, {0.0, 0.0, 0.0}, {}});
    for (const auto a : indices(held_)) {
      SupportForce& bearing = d.bearings[static_cast<std::size_t>(held_[a].freedom - first) / 2];
      const Lateral force = across_of(s, first_reaction() + static_cast<Index>(a));
      if (held_[a].freedom % 2 == 0)
        bearing.force << 0.0, force.y, force.z;
      else
        bearing.moment = {-force.z * arm_, force.y * arm_};
    }
  }

  const FullModel& f_;
  Index threads_;
  double arm_;
  MatrixXd screw_, nut_;  ///< Approaches by motions: axial, lateral, slope.
  VectorXd roller_;       ///< Approaches by the roller's motion along its axis.
  MatrixXd lines_;        ///< Approaches by outward displacements of the near and the far ring.
  std::vector<double> stations_;
  MatrixXd by_stations_;           ///< Approaches by loads on the screw's stations.
  MatrixXd between_stations_;      ///< Displacements of the stations by these loads.
  MatrixXd rigid_stations_;        ///< Displacements of the stations by lateral motion and slope of the loaded section.
  std::array<MatrixXd, 2> loads_;  ///< Loads on the stations, for the waves cos and sin.
  std::vector<Held> held_;
  const FlexibilityAround* bodies_of_rings_ = nullptr;
};

}  // namespace

std::array<double, 2> guide_places(const FullModel& f) {
  const double in = f.sector.inner_guide > 0.0 ? 0.5 * f.sector.end_length : 0.0;
  return {f.roller_ends.first + in, f.roller_ends.last - in};
}

std::vector<double> screw_stations(const FullModel& f) {
  std::vector<double> x = ring_sections(f, Rings::Carrier::screw, f.screw, f.loaded_section);
  for (const Bearing& b : f.bearings) x.push_back(b.position - f.loaded_section);
  for (const auto& at : {f.load.side_force.at, f.load.moment.at})
    if (at) x.push_back(*at - f.loaded_section);
  return x;
}

std::vector<double> nut_stations(const FullModel& f) { return ring_sections(f, Rings::Carrier::nut, f.nut, 0.0); }

FullBodies full_bodies(const Conditions& c, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                       const FullModel& f, MatrixCache& cache) {
  const Direction direction = f.sense() < 0.0 ? Direction::tension : Direction::compression;
  const BodyGeometry geometry = influence_geometry(c, contacts, laws, direction);
  const FlexibilityOptions options = flexibility_options(c.model.accuracy);
  return meshed_or_refused([&]() -> FullBodies {
    const BodyFlexibilities alike = body_flexibilities(geometry, direction, f.sector.position, options, cache);
    return {screw_around(geometry, direction, screw_stations(f), options, cache),
            nut_around(geometry, direction, f.sector.position, nut_stations(f), options, cache), alike.roller.matrix,
            alike.nut.face};
  });
}

double lifting_moment(const Structure::Nut& nut, const SupportForce& seat) {
  const auto [before, behind] = nut_diameters_at(nut, seat.position);
  const Structure::Shoulder ring =
      nut.shoulder.value_or(Structure::Shoulder{std::min(before, behind), std::max(before, behind)});
  const double inner = 0.5 * ring.inner_diameter, outer = 0.5 * ring.outer_diameter;
  return std::abs(seat.force[0]) * (outer * outer + inner * inner) / (4.0 * outer);
}

FullDistribution solve(const FullModel& f, const FullBodies& bodies, Detail detail) {
  const FullStructure structure = full_structure(f);
  if (std::optional<FullDistribution> d = mechanism(f, structure)) return *d;
  FullDistribution d;
  Assembly a(f, bodies);
  d.freedoms = a.freedoms();
  const ContactsAroundOptions options = a.options();
  ContactsAroundSolution s = prs::solve(a.problem, options);
  if (bodies.face) {
    const ThrustFace& face = *bodies.face;
    const ThrustFace::Touching all = face.all();
    settle_on_shoulder(
        face, face.touching_under(VectorXd::Ones(f.threads()), all).value_or(all), s,
        [&] { return a.mean_nut_load(s.normal_load); },
        [&](const MatrixXd& change) {
          a.add_to_nut(change);
          s = prs::solve(a.problem, options, &s);
        });
  }
  d.solve = s;
  if (!d.solve.converged()) {
    if (load_left(f, structure) > 1e-9) {
      d.solve.status = fe::NewtonStatus::no_equilibrium;
      d.reason = why_not_held(f, structure);
    }
    return d;
  }
  a.read(s, d);
  if (detail != Detail::complete) return d;
  if (d.idle_rollers.empty())
    a.add_compliance(s, d);
  else
    d.screw_end.left_out =
        fmt::format("roller {} carries nothing, which `bodies: influence` does not take out of the stiffness",
                    d.idle_rollers.front() + 1);
  return d;
}

}  // namespace prs
