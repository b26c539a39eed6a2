#include "prs/sector/full/full_influence.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "prs/model/case_error.h"
#include "prs/sector/full/full_structure.h"
#include "prs/sector/full/rigid_motions.h"

namespace prs {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostFaceRounds = 10;
/// Shares of the mean below which a roller carries nothing.
constexpr double kIdle = 1e-6;
constexpr int kScrewMotions = 5;

/// Sections of screw or nut that carry the rings, from `origin` on, within the body.
std::vector<double> ring_sections(const FullModel& f, Rings::Carrier body,
                                  const std::vector<BodyPiece>& pieces, double origin) {
  std::vector<double> sections;
  if (f.carrier != body) return sections;
  for (const double x : guide_places(f))
    sections.push_back(std::clamp(x, pieces.front().from, pieces.back().to) - origin);
  return sections;
}

/// The contact problem, contacts roller by roller, those at the screw first.
class Assembly {
 public:
  Assembly(const FullModel& f, const FullBodies& bodies)
      : f_(f),
        threads_(f.threads()),
        contacts_(2 * threads_ * static_cast<Index>(f.present.size())) {
    const auto motions = kScrewMotions + static_cast<Index>(f.present.size());
    problem.rigid = MatrixXd::Zero(contacts_, motions);
    problem.hertz_constant.resize(contacts_);
    problem.gap.resize(contacts_);
    lines_ = MatrixXd::Zero(contacts_, 4);
    nut_ = MatrixXd::Zero(contacts_, kScrewMotions);
    for (std::size_t r = 0; r < f.present.size(); ++r) add_roller(r);
    add_bodies(bodies);
    add_supports();
    load_ = VectorXd::Zero(motions);
    const double force = f.sense() * f.axial_force, arm = f.sector.roller_radius;
    const SpatialLoad& l = f.load;
    load_.head(kScrewMotions) << force, l.side_force.value.y, l.side_force.value.z,
        (l.moment.value.z - force * l.eccentricity.y) / arm,
        (-l.moment.value.y - force * l.eccentricity.z) / arm;
  }

  ContactProblem problem;
  const VectorXd& load() const { return load_; }
  Index index(std::size_t roller, Interface i, int thread) const {
    return (2 * static_cast<Index>(roller) + (i == Interface::nut ? 1 : 0)) * threads_ + thread;
  }
  /// Change of the nut's flexibility that is alike for all pairs of rollers.
  void add_to_nut(const MatrixXd& change) {
    for (std::size_t a = 0; a < f_.present.size(); ++a)
      for (std::size_t b = 0; b < f_.present.size(); ++b) block(a, b, Interface::nut) += change;
  }
  /// Forces of the contacts on the seat of the nut, conjugate to its motions about the thrust
  /// section, and of the guides' lines on the rollers: near y, z, far y, z.
  VectorXd on_nut(const VectorXd& loads) const { return -nut_.transpose() * loads; }
  VectorXd of_guides(const VectorXd& loads, std::size_t roller) const {
    const Index first = index(roller, Interface::screw, 0);
    return lines_.middleRows(first, 2 * threads_).transpose() * loads.segment(first, 2 * threads_);
  }

 private:
  Eigen::Block<MatrixXd> block(std::size_t a, std::size_t b, Interface i) {
    return problem.flexibility.block(index(a, i, 0), index(b, i, 0), threads_, threads_);
  }

  void add_roller(std::size_t r) {
    const FullModel::Roller& roller = f_.present[r];
    const double y = std::cos(roller.azimuth), z = std::sin(roller.azimuth);
    const double arm = f_.sector.roller_radius;
    const auto [near, far] = guide_places(f_);
    for (const Interface i : kInterfaces)
      for (int k = 0; k < f_.threads(); ++k) {
        const Index row = index(r, i, k);
        const bool screw = i == Interface::screw;
        const double sign = screw ? 1.0 : -1.0, x = roller.contact_x[static_cast<std::size_t>(k)];
        const double along = f_.sense() * f_.sector.cosine[i], across = f_.sector.sine[i];
        const double radius = f_.centre_distance - sign * arm;
        // A rigid motion about the section at `origin`, rotations in 1/r_R.
        const auto body = [&](double origin) {
          const double tilt = (-along * radius + across * (x - origin)) / arm;
          return Eigen::Matrix<double, 1, 5>(sign * along, sign * across * y, sign * across * z,
                                             sign * tilt * y, sign * tilt * z);
        };
        if (screw)
          problem.rigid.row(row).head<5>() = body(f_.loaded_section);
        else
          nut_.row(row) = body(f_.thrust);
        problem.rigid(row, kScrewMotions + static_cast<Index>(r)) = -sign * along;
        // v of a line through both guides, and theta.
        const double at_far = (x - near) / (far - near), turn = -along * arm / (far - near);
        const double by_near = -sign * across * (1.0 - at_far) - turn;
        const double by_far = -sign * across * at_far + turn;
        lines_.row(row) << by_near * y, by_near * z, by_far * y, by_far * z;
        problem.hertz_constant[row] = f_.sector.hertz_constant[i];
        problem.gap[row] = roller.gaps[i][static_cast<std::size_t>(k)] -
                           by_near * roller.ring_offset[0] - by_far * roller.ring_offset[1];
      }
  }

  void add_bodies(const FullBodies& bodies) {
    problem.flexibility = MatrixXd::Zero(contacts_, contacts_);
    for (int d = 0; d <= f_.rollers / 2; ++d) {
      const MatrixXd screw = bodies.screw.between(d, f_.rollers);
      const MatrixXd nut = bodies.nut.between(d, f_.rollers);
      for (std::size_t a = 0; a < f_.present.size(); ++a)
        for (std::size_t b = 0; b < f_.present.size(); ++b) {
          const int apart = std::abs(f_.present[a].number - f_.present[b].number);
          if (std::min(apart, f_.rollers - apart) != d) continue;
          block(a, b, Interface::screw) = screw;
          block(a, b, Interface::nut) = nut;
        }
    }
    for (std::size_t r = 0; r < f_.present.size(); ++r) {
      const Index first = index(r, Interface::screw, 0);
      problem.flexibility.block(first, first, 2 * threads_, 2 * threads_) += bodies.roller;
    }
    for (std::size_t r = 0; r < f_.present.size(); ++r)
      for (const Interface i : kInterfaces)
        block(r, r, i).diagonal().array() += f_.sector.compliance[i];
    if (f_.carrier == Rings::Carrier::screw) carry_rings(bodies.screw, Interface::screw);
    if (f_.carrier == Rings::Carrier::nut) carry_rings(bodies.nut, Interface::nut);
  }

  /// The rings' forces bend the body that carries them, whose sections move the rings.
  void carry_rings(const FlexibilityAround& body, Interface i) {
    // Displacement of the sections (near y, z, far y, z) by the contacts of the body.
    MatrixXd by_contacts = MatrixXd::Zero(4, contacts_), by_rings = MatrixXd::Zero(4, 4);
    for (std::size_t r = 0; r < f_.present.size(); ++r) {
      const double azimuth = f_.present[r].azimuth;
      for (Index ring = 0; ring < 2; ++ring) {
        const auto at = Eigen::seqN(index(r, i, 0), threads_);
        by_contacts(2 * ring, at) = std::cos(azimuth) * body.coupling.col(ring).transpose();
        by_contacts(2 * ring + 1, at) = std::sin(azimuth) * body.coupling.col(ring).transpose();
      }
    }
    for (Index a = 0; a < 2; ++a)
      for (Index b = 0; b < 2; ++b)
        by_rings(2 * a, 2 * b) = by_rings(2 * a + 1, 2 * b + 1) = body.sections(a, b);
    // The rings push the body by -lines' N.
    const MatrixXd mixed = lines_ * by_contacts;
    problem.flexibility -= mixed + mixed.transpose();
    problem.flexibility += lines_ * by_rings * lines_.transpose();
    // They move with its rigid motions too.
    const bool screw = i == Interface::screw;
    const std::array<double, 2> places = guide_places(f_);
    for (Index ring = 0; ring < 2; ++ring) {
      const double arm =
          (places[static_cast<std::size_t>(ring)] - (screw ? f_.loaded_section : f_.thrust)) /
          f_.sector.roller_radius;
      const auto line = lines_.middleCols<2>(2 * ring);
      if (screw) {
        problem.rigid.middleCols<2>(1) += line;
        problem.rigid.middleCols<2>(3) += arm * line;
      } else {
        nut_.middleCols<2>(1) += line;
        nut_.middleCols<2>(3) += arm * line;
      }
    }
  }

  void add_supports() {
    const double arm = f_.sector.roller_radius;
    const auto spring = [&](Index motion, double stiffness) {
      if (stiffness < kRigid)
        problem.flexibility += nut_.col(motion) * nut_.col(motion).transpose() / stiffness;
    };
    spring(0, f_.housing.axial);
    for (const Index motion : {1, 2}) spring(motion, f_.housing.lateral);
    for (const Index motion : {3, 4}) spring(motion, f_.housing.tilt / (arm * arm));
    if (f_.floating_rings()) problem.flexibility += lines_ * lines_.transpose() / f_.ring_stiffness;
    Eigen::Matrix<double, 5, 1> seat;
    seat << 0.0, f_.load.nut_offset.y, f_.load.nut_offset.z, arm * rigid_slope(f_).y,
        arm * rigid_slope(f_).z;
    problem.gap -= nut_ * seat;
  }

  const FullModel& f_;
  Index threads_, contacts_;
  MatrixXd lines_;  ///< Approaches by the rings' displacements (near y, z, far y, z).
  MatrixXd nut_;    ///< Approaches by rigid motions of the nut.
  VectorXd load_;
};

/// Mean over the rollers of the loads at each thread of the nut.
VectorXd mean_nut_load(const FullModel& f, const Assembly& a, const VectorXd& loads) {
  VectorXd mean = VectorXd::Zero(f.threads());
  for (std::size_t r = 0; r < f.present.size(); ++r)
    mean += loads.segment(a.index(r, Interface::nut, 0), f.threads());
  return mean / f.rollers;
}

void read(const FullModel& f, const Assembly& a, const ContactSolution& s, FullDistribution& d) {
  const auto threads = static_cast<std::size_t>(f.threads());
  const double share = f.axial_force / static_cast<double>(f.present.size());
  for (RingForce& ring : d.rings) ring.rollers.assign(static_cast<std::size_t>(f.rollers), 0.0);
  for (const Interface i : kInterfaces)
    d.normal_load[i] = d.approach[i] =
        RollerThreads(static_cast<std::size_t>(f.rollers), std::vector<double>(threads, 0.0));
  for (std::size_t r = 0; r < f.present.size(); ++r) {
    const FullModel::Roller& roller = f.present[r];
    const auto number = static_cast<std::size_t>(roller.number);
    double carried = 0.0;
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < threads; ++k) {
        const Index row = a.index(r, i, static_cast<int>(k));
        d.normal_load[i][number][k] = s.normal_load[row];
        d.approach[i][number][k] = s.approach[row];
        d.largest_opening[i] = std::max(d.largest_opening[i], s.openings[row]);
        if (i == Interface::screw) carried += s.normal_load[row] * f.sector.cosine[i];
      }
    if (carried <= kIdle * share) d.idle_rollers.push_back(roller.number);
    const VectorXd guides = a.of_guides(s.normal_load, r);
    for (std::size_t ring = 0; ring < 2; ++ring) {
      const auto at = static_cast<Index>(2 * ring);
      const double y = guides[at], z = guides[at + 1];
      d.rings[ring].rollers[number] = y * std::cos(roller.azimuth) + z * std::sin(roller.azimuth);
      d.rings[ring].force.y += y;
      d.rings[ring].force.z += z;
    }
  }
  const double arm = f.sector.roller_radius;
  const VectorXd nut = -a.on_nut(s.normal_load);
  d.nut = {f.thrust, nut.head<3>(), {-nut[4] * arm, nut[3] * arm}};
  const VectorXd& u = s.motion;
  d.screw_end.displacement << u[0], u[1], u[2], -u[4] / arm, u[3] / arm;
  d.axial_displacement = f.sense() * u[0];
}

void add_compliance(const FullModel& f, const ContactSolution& s, FullDistribution& d) {
  const double arm = f.sector.roller_radius;
  Eigen::Matrix<double, 5, 5> turn = Eigen::Matrix<double, 5, 5>::Zero();
  turn(0, 0) = turn(1, 1) = turn(2, 2) = 1.0;
  turn(3, 4) = -1.0 / arm;
  turn(4, 3) = 1.0 / arm;
  d.screw_end.freedoms = {0, 1, 2, 3, 4};
  d.screw_end.compliance = turn * s.compliance.topLeftCorner<5, 5>() * turn.transpose();
  d.screw_end.stiffness = d.screw_end.compliance.inverse();
  d.tangent_stiffness = 1.0 / d.screw_end.compliance(0, 0);
}

}  // namespace

std::array<double, 2> guide_places(const FullModel& f) {
  const double in = f.sector.inner_guide > 0.0 ? 0.5 * f.sector.end_length : 0.0;
  return {f.roller_ends.first + in, f.roller_ends.last - in};
}

FullBodies full_bodies(const Conditions& c, const Contacts& contacts,
                       const PerInterface<ContactLaw>& laws, const FullModel& f,
                       MatrixCache& cache) {
  const Direction direction = f.sense() < 0.0 ? Direction::tension : Direction::compression;
  const BodyGeometry geometry = influence_geometry(c, contacts, laws, direction);
  const FlexibilityOptions options = flexibility_options(c.model.accuracy);
  try {
    const BodyFlexibilities alike =
        body_flexibilities(geometry, direction, f.sector.position, options, cache);
    return {screw_around(geometry, direction,
                         ring_sections(f, Rings::Carrier::screw, f.screw, f.loaded_section),
                         options, cache),
            nut_around(geometry, direction, f.sector.position,
                       ring_sections(f, Rings::Carrier::nut, f.nut, 0.0), options, cache),
            alike.roller.matrix, alike.nut.face};
  } catch (const std::invalid_argument& reason) {
    throw CaseError("model.bodies",
                    fmt::format("`influence` cannot mesh these bodies: {}; take `refined` or fix "
                                "the geometry",
                                reason.what()));
  }
}

FullDistribution solve(const FullModel& f, const FullBodies& bodies, Detail detail) {
  const FullStructure structure = full_structure(f);
  FullDistribution d;
  if (const FreeMotions free = free_motions(f, structure); free.count > 0) {
    d.solve.status = fe::NewtonStatus::mechanism;
    d.reason = why_free(free);
    return d;
  }
  Assembly a(f, bodies);
  d.freedoms = static_cast<int>(a.problem.gap.size() + a.load().size());
  const double contact = f.axial_force / (static_cast<double>(f.present.size()) * f.threads());
  VectorXd stiffness(a.problem.gap.size());
  for (Index k = 0; k < stiffness.size(); ++k)
    stiffness[k] = std::cbrt(std::pow(a.problem.hertz_constant[k], 2) * contact /
                             std::max(f.sector.cosine.screw, f.sector.cosine.nut));
  ContactSolveOptions options;
  options.least_tangent = 1e-7 * stiffness.minCoeff();
  ContactSolution s = prs::solve(a.problem, a.load(), stiffness, options);
  std::vector<ContactIteration> history = s.history;
  if (bodies.face && s.converged()) {
    const ThrustFace& face = *bodies.face;
    const ThrustFace::Touching all = face.all();
    ThrustFace::Touching touching =
        face.touching_under(VectorXd::Ones(f.threads()), all).value_or(all);
    bool settled = false;
    for (int round = 0; round < kMostFaceRounds && s.converged(); ++round) {
      const auto now = face.touching_under(mean_nut_load(f, a, s.normal_load), touching);
      settled = now == touching;
      if (settled || !now) break;
      a.add_to_nut(face.flexibility(*now) - face.flexibility(touching));
      touching = *now;
      s = prs::solve(a.problem, a.load(), stiffness, options);
      history.insert(history.end(), s.history.begin(), s.history.end());
    }
    if (s.converged() && !settled) s.status = ContactSolveStatus::iteration_limit;
  }
  d.solve = newton_summary(s, history);
  if (!d.solve.converged()) {
    if (load_left(f, structure) > 1e-9) {
      d.solve.status = fe::NewtonStatus::no_equilibrium;
      d.reason = why_not_held(f, structure);
    }
    return d;
  }
  read(f, a, s, d);
  if (detail == Detail::complete && d.idle_rollers.empty()) add_compliance(f, s, d);
  return d;
}

}  // namespace prs
