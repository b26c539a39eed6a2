#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "modules/response/response.h"
#include "prs/model/response_input.h"

namespace prs {
namespace {

constexpr double kReach = 0.005 / (2.0 * std::numbers::pi);

/// A drive of linear or Hertzian flanks, without friction of threads, whose motion has a closed form.
class PlainDrive {
 public:
  PlainDrive() {
    drive.mass = 40.0;
    drive.by = PRS_BY_SPEED;
    drive.cut_at = drive.brake_at = drive.largest_torque = drive.largest_speed = drive.start_deflection = HUGE_VAL;
    drive.shaft_span = HUGE_VAL;
    drive.curves.lead = 0.005;
    set_stiffness(2e8);
  }

  /// A spring that pulls in both senses; with play flanks that open.
  void set_stiffness(double k, double play = 0.0) {
    if (play > 0.0)
      set_branch({0.0, 0.01}, {0.0, 1e-4 * k}, {0.0, 0.02 * k}, true, play);
    else
      set_branch({0.0, 1e-4}, {0.0, 1e-4 * k}, {k, k}, false, 0.0);
  }
  /// F = C w^1.5, the cube of the root.
  void set_hertz(double c, double play) { set_branch({0.0, 0.01}, {0.0, 1e-6 * c}, {0.0, 3e-4 * c}, true, play); }

  DriveResult run(double duration, double interval, double tolerance = 1e-8) {
    PrsSignals functions{this,
                         [](void* self, double t) {
                           static_cast<PlainDrive*>(self)->motor.bind(t);
                           static_cast<PlainDrive*>(self)->force.bind(t);
                         },
                         [](void* self, double t, PrsInputs* in) {
                           const BoundSignal::Value v = static_cast<PlainDrive*>(self)->motor.at(t);
                           *in = {v.value, v.slope, v.curve, static_cast<PlainDrive*>(self)->force.at(t).value};
                         },
                         [](void* self, double t) {
                           return std::min(static_cast<PlainDrive*>(self)->motor.next(t),
                                           static_cast<PlainDrive*>(self)->force.next(t));
                         }};
    const auto samples = static_cast<std::size_t>((1.0 + 1e-12) * duration / interval) + 1;
    DriveResult result;
    modules::loaded<ResponseModule>().integrate({drive, functions, duration, interval, samples, tolerance, 0.0},
                                                result);
    EXPECT_EQ(result.status, DriveStatus::converged);
    return result;
  }

  PrsDrive drive{};
  BoundSignal motor, force;

 private:
  void set_branch(std::vector<double> at, std::vector<double> value, std::vector<double> slope, bool root,
                  double play) {
    at_ = std::move(at), value_ = std::move(value), slope_ = std::move(slope);
    drive.curves.tension = {play, root ? 1 : 0, at_.size(), at_.data(), value_.data(), slope_.data()};
    drive.curves.compression = drive.curves.tension;
  }
  std::vector<double> at_, value_, slope_;
};

BoundSignal constant(double value) {
  Signal signal;
  signal.one.constant = value;
  return BoundSignal(signal.terms());
}

BoundSignal ramp(std::vector<SignalTerm::Point> points) {
  Signal signal;
  signal.one.points = std::move(points);
  return BoundSignal(signal.terms());
}

double residual(const DriveResult& r) {
  const double lost =
      r.screw_friction + r.motor_friction + r.load_friction + r.coupling + r.contact + r.end_stop + r.viscous;
  return std::abs(r.motor + r.load - (r.stored_end - r.stored_start) - lost) / r.turnover;
}

TEST(Drive, MassOnAHeldScrewVibratesAsTheClosedForm) {
  PlainDrive d;
  d.drive.material_damping = 30e-6;
  d.drive.start_deflection = 10e-6;
  const DriveResult r = d.run(0.02, 1e-4);
  const double w = std::sqrt(2e8 / 40.0), zeta = 0.5 * 30e-6 * w, damped = w * std::sqrt(1.0 - zeta * zeta);
  for (std::size_t k = 0; k < r.time.size(); ++k) {
    const double t = r.time[k];
    const double expected =
        10e-6 * std::exp(-zeta * w * t) * (std::cos(damped * t) + zeta * w / damped * std::sin(damped * t));
    EXPECT_NEAR(r.delta[k], expected, 1e-6 * 10e-6) << t;
  }
  EXPECT_LT(residual(r), 1e-6);
}

TEST(Drive, ThreeInertiasFollowTheMatrixExponential) {
  PlainDrive d;
  d.drive.by = PRS_BY_TORQUE;
  d.drive.coupled = 1;
  d.drive.motor_inertia = 4e-4, d.drive.screw_inertia = 3e-4;
  d.drive.coupling_stiffness = 2000.0, d.drive.coupling_damping = 0.05;
  d.drive.load_damping = 300.0, d.drive.motor_damping = 0.002;
  d.motor = constant(3.0);
  const DriveResult r = d.run(0.02, 1e-3);
  // States v, delta, omega, theta, omega_M and a constant.
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(6, 6);
  const double k = 2e8, m = 40.0;
  a(0, 1) = k / m, a(0, 0) = -300.0 / m;
  a(1, 2) = kReach, a(1, 0) = -1.0;
  a(2, 3) = 2000.0 / 3e-4, a(2, 4) = 0.05 / 3e-4, a(2, 2) = -0.05 / 3e-4, a(2, 1) = -kReach * k / 3e-4;
  a(3, 4) = 1.0, a(3, 2) = -1.0;
  a(4, 3) = -2000.0 / 4e-4, a(4, 4) = -(0.05 + 0.002) / 4e-4, a(4, 2) = 0.05 / 4e-4, a(4, 5) = 3.0 / 4e-4;
  const Eigen::EigenSolver<Eigen::MatrixXd> modes(a);
  Eigen::VectorXcd start = Eigen::VectorXcd::Zero(6);
  start(5) = 1.0;
  const Eigen::VectorXcd weights = modes.eigenvectors().partialPivLu().solve(start);
  for (const std::size_t i : {5, 12, 20}) {
    const Eigen::VectorXcd y =
        modes.eigenvectors() * ((modes.eigenvalues() * r.time[i]).array().exp() * weights.array()).matrix();
    EXPECT_NEAR(r.v[i], y(0).real(), 1e-6 * 0.1);
    EXPECT_NEAR(r.delta[i], y(1).real(), 1e-6 * 3e-5);
    EXPECT_NEAR(r.omega_m[i], y(4).real(), 1e-6 * 100.0);
  }
  EXPECT_LT(residual(r), 1e-6);
}

TEST(Drive, PlayIsCrossedBackAndForth) {
  PlainDrive d;
  const double a = 20e-6, v = 0.01, k = 2e8, m = 40.0;
  d.set_stiffness(k, a);
  d.drive.start_speed = v;
  d.drive.start_deflection = 0.0;
  d.motor = constant(0.0);
  const double half = 2.0 * a / v + std::numbers::pi * std::sqrt(m / k);
  const DriveResult r = d.run(16.0 * half, half / 10.0);
  ASSERT_GE(r.impacts.size(), 15U);
  for (std::size_t i = 0; i < 15; ++i) {
    EXPECT_NEAR(r.impacts[i].time, a / v + static_cast<double>(i) * half, 1e-6 * half);
    EXPECT_EQ(r.impacts[i].flank, i % 2 == 0 ? -1 : 1);  // The load is ahead of the held screw.
    EXPECT_NEAR(r.impacts[i].speed, v, 1e-5 * v);
    EXPECT_NEAR(r.impacts[i].energy, 0.5 * m * v * v, 2e-5 * m * v * v);
  }
  EXPECT_NEAR(r.impacts[3].force.value, v * std::sqrt(k * m), 1e-5 * v * std::sqrt(k * m));
  EXPECT_LT(residual(r), 1e-6);
}

TEST(Drive, HertzianFlanksStopAMass) {
  PlainDrive d;
  const double c = 5e10, m = 40.0, v = 0.02;
  d.set_hertz(c, 5e-6);
  d.drive.start_speed = -v;
  d.drive.start_deflection = 0.0;
  const DriveResult r = d.run(0.005, 1e-4);
  ASSERT_FALSE(r.impacts.empty());
  const double expected = c * std::pow(5.0 * m * v * v / (4.0 * c), 0.6);
  EXPECT_NEAR(r.impacts[0].force.value, expected, 1e-5 * expected);
  EXPECT_NEAR(r.tension.value, expected, 1e-5 * expected);
}

/// The loss of material damping begins with the root of the time after each impact.
TEST(Drive, EnergiesOfADampedMassThatBouncesClose) {
  for (const double beta : {2e-5, 2e-4}) {
    PlainDrive d;
    d.set_hertz(5e10, 20e-6);
    d.drive.material_damping = beta;
    d.drive.start_speed = 0.03;
    d.drive.start_deflection = 0.0;
    const DriveResult r = d.run(0.05, 1e-3);
    EXPECT_GE(r.impacts.size(), 3U);
    EXPECT_GT(r.contact, 0.1 * r.stored_start);
    EXPECT_LT(residual(r), 1e-6) << beta;
  }
}

TEST(Drive, AStopTakesTheWholeSpeed) {
  PlainDrive d;
  d.set_stiffness(2e8, 0.1);  // The load is free.
  d.drive.start_deflection = 0.0;
  d.drive.start_speed = 0.1;
  d.drive.stop[PRS_UPPER] = {1, 1e-3, 2e7, 0.0};
  const DriveResult r = d.run(0.03, 1e-3);
  EXPECT_NEAR(r.stop.value, 0.1 * std::sqrt(2e7 * 40.0), 1e-5 * r.stop.value);
  EXPECT_NEAR(r.v.back(), -0.1, 1e-6);
}

TEST(Drive, AScrewDraggedThroughASoftCouplingLetsGoWhereItsFrictionEnds) {
  PlainDrive d;
  const double speed = 10.0, k = 50.0, drag = 0.2;
  d.set_stiffness(2e8, 0.1);  // The load does not take part.
  d.drive.start_deflection = 0.0;
  d.drive.coupled = 1;
  d.drive.coupling_stiffness = k;
  d.drive.screw_inertia = 3e-4;
  d.drive.drag = drag;
  // The load's start has the motor's speed, which is 0.
  d.motor = ramp({{0.0, 0.0}, {1e-9, speed}});
  const DriveResult r = d.run(4e-3, 1e-5);
  const double lets_go = drag / (k * speed) + 0.5e-9;
  for (std::size_t i = 0; i < r.time.size(); ++i) {
    if (r.time[i] < lets_go) {
      EXPECT_EQ(r.omega[i], 0.0);
    }
    EXPECT_LE(r.omega[i], 2.0 * speed * (1.0 + 1e-6));
  }
  const auto first = std::ranges::find_if(r.omega, [](double w) { return w != 0.0; });
  EXPECT_NEAR(r.time[static_cast<std::size_t>(first - r.omega.begin())], lets_go, 2e-5);
  // The friction is W (1 - cos) from then on, without a peak above that of sliding.
  const double w = std::sqrt(k / 3e-4), t = 3e-3 - lets_go;
  EXPECT_NEAR(r.omega[300], speed * (1.0 - std::cos(w * t)), 1e-5 * speed);
}

TEST(Drive, ATorqueBelowBreakAwayMovesNothing) {
  PlainDrive d;
  d.drive.by = PRS_BY_TORQUE;
  d.drive.motor_inertia = 4e-4, d.drive.screw_inertia = 3e-4;
  d.drive.drag = 0.3, d.drive.motor_friction = 0.2;
  d.motor = constant(0.499);
  const DriveResult r = d.run(0.1, 1e-3);
  for (std::size_t i = 0; i < r.time.size(); ++i) {
    EXPECT_EQ(r.omega[i], 0.0);
    EXPECT_EQ(r.x[i], 0.0);
  }
  d.motor = constant(0.501);
  EXPECT_GT(d.run(0.1, 1e-3).omega.back(), 0.0);
}

TEST(Drive, TheCurrentLoopLagsAsAFirstOrder) {
  PlainDrive d;
  const double lag = 3e-4;
  d.drive.by = PRS_BY_TORQUE;
  d.drive.motor_inertia = 4e-4;
  d.drive.time_constant = lag;
  d.drive.cut_at = 5e-3;
  Signal step;
  step.one.steps = std::vector<SignalTerm::Point>{{1e-3, 2.0}};
  d.motor = BoundSignal(step.terms());
  const DriveResult r = d.run(8e-3, 1e-4);
  for (std::size_t i = 0; i < r.time.size(); ++i) {
    const double t = r.time[i];
    const auto risen = [&](double at) { return 2.0 * (1.0 - std::exp(-(at - 1e-3) / lag)); };
    const double expected = t < 1e-3 ? 0.0 : t < 5e-3 ? risen(t) : risen(5e-3) * std::exp(-(t - 5e-3) / lag);
    EXPECT_NEAR(r.motor_torque[i], expected, 1e-6) << t;
  }
  const double slow = r.x.back();
  d.drive.time_constant = 1e-6;
  const DriveResult fast = d.run(8e-3, 1e-4);
  d.drive.time_constant = 0.0;
  EXPECT_NEAR(fast.x.back(), d.run(8e-3, 1e-4).x.back(), 1e-3 * slow);
}

TEST(Drive, APositionLoopOnTheLoadHoldsItUnderALoad) {
  PlainDrive d;
  d.drive.by = PRS_POSITION_LOOP;
  d.drive.coupled = 1;
  d.drive.coupling_stiffness = 1500.0, d.drive.coupling_damping = 0.2;
  d.drive.motor_inertia = 4e-4, d.drive.screw_inertia = 3.5e-4;
  d.drive.material_damping = 5e-5, d.drive.motor_damping = 0.001;
  d.drive.position_gain = 60.0, d.drive.speed_gain = 0.5, d.drive.integral_time = 0.02;
  d.drive.feedback_of_load = 1;
  d.motor = constant(1e-3);
  d.force = constant(2000.0);
  const DriveResult on_load = d.run(0.8, 1e-3);
  EXPECT_NEAR(on_load.x.back(), 1e-3, 1e-4 * on_load.lost_motion);
  d.drive.feedback_of_load = 0;
  const DriveResult on_motor = d.run(0.8, 1e-3);
  const double twist = kReach * kReach * 2000.0 / 1500.0;
  EXPECT_NEAR(on_motor.x.back(), 1e-3 - 2000.0 / 2e8 - twist, 1e-4 * on_motor.lost_motion);
}

TEST(Drive, OnARampTheLoadFollowsBehindUnlessTheSpeedIsFedForward) {
  PlainDrive d;
  d.drive.by = PRS_POSITION_LOOP;
  d.drive.motor_inertia = 4e-4, d.drive.screw_inertia = 3.5e-4, d.drive.material_damping = 5e-5;
  d.drive.position_gain = 60.0, d.drive.speed_gain = 0.5, d.drive.integral_time = 0.02;
  d.drive.feedback_of_load = 1;
  d.motor = ramp({{0.0, 0.0}, {2.0, 0.1}});
  const double speed = 0.05;
  EXPECT_NEAR(0.05 * 0.8 - d.run(0.8, 1e-3).x.back(), speed / 60.0, 1e-6 * speed / 60.0);
  d.drive.feeds_speed_forward = 1;
  EXPECT_NEAR(d.run(0.8, 1e-3).x.back(), 0.05 * 0.8, 1e-8);
}

TEST(Drive, ATorqueThatStaysAtItsBoundEnds) {
  PlainDrive d;
  d.drive.by = PRS_SPEED_LOOP;
  d.drive.motor_inertia = 4e-4, d.drive.screw_inertia = 3.5e-4;
  d.drive.speed_gain = 0.5, d.drive.integral_time = 0.02, d.drive.largest_torque = 2.0;
  d.motor = ramp({{0.0, 0.0}, {0.1, 280.0}});  // A little more than 2 N m accelerate.
  const DriveResult r = d.run(0.15, 1e-3);
  EXPECT_EQ(r.torque.value, 2.0);
  EXPECT_LT(residual(r), 1e-6);
  EXPECT_NEAR(r.omega_m.back(), 280.0, 5.0);
}

TEST(Drive, PositionOfTheStartDoesNotMatter) {
  PlainDrive d;
  d.set_stiffness(2e8, 10e-6);
  d.drive.by = PRS_BY_TORQUE;
  d.drive.motor_inertia = 4e-4, d.drive.screw_inertia = 3e-4, d.drive.load_friction = 50.0, d.drive.drag = 0.1;
  d.drive.stop[PRS_UPPER] = {1, 2e-3, 2e7, 0.3};
  d.motor = constant(2.0);
  const DriveResult here = d.run(0.1, 1e-3);
  d.drive.start_position = 0.75;
  d.drive.stop[PRS_UPPER].at += 0.75;
  const DriveResult there = d.run(0.1, 1e-3);
  EXPECT_GT(here.stop.value, 100.0);
  EXPECT_NEAR(there.tension.value, here.tension.value, 1e-5 * here.tension.value);
  for (std::size_t i = 0; i < here.time.size(); ++i) EXPECT_NEAR(there.x[i] - 0.75, here.x[i], 1e-5 * 2e-3);
}

/// The rotor alone: below the bound J omega' = k (largest - omega).
TEST(Drive, ThePositionLoopAsksForNoMoreThanTheLargestSpeed) {
  PlainDrive d;
  d.set_stiffness(2e8, 0.1);  // The load does not take part.
  d.drive.start_deflection = 0.0;
  d.drive.by = PRS_POSITION_LOOP;
  d.drive.motor_inertia = 4e-4;
  d.drive.position_gain = 60.0, d.drive.speed_gain = 0.2, d.drive.largest_speed = 50.0;
  d.motor = constant(20e-3);
  const DriveResult r = d.run(0.1, 1e-3);
  for (std::size_t i = 0; i < r.time.size(); ++i) {
    EXPECT_NEAR(r.omega_m[i], 50.0 * (1.0 - std::exp(-0.2 / 4e-4 * r.time[i])), 1e-6 * 50.0);
    EXPECT_LE(r.omega_m[i], 50.0 * (1.0 + 1e-9));
  }
  EXPECT_LT(kReach * (50.0 + 1.0), 60.0 * (20e-3 - kReach * r.phi_m.back()));  // Without the bound it is faster.
}

TEST(Drive, ALoadDrawnTowardsTheBearingStandsStiffer) {
  PlainDrive d;
  const double force = 3000.0, speed = 400.0, rigidity = 2e7, length = 0.2, beta = 2e-4;
  d.drive.has_shaft = 1;
  d.drive.shaft_length = length, d.drive.shaft_rigidity = rigidity;
  d.drive.start_speed = kReach * speed;
  d.drive.material_damping = beta;
  d.motor = constant(speed);
  d.force = constant(force);
  const DriveResult r = d.run(0.2, 0.1);
  const auto expected = [&](double x) {
    const double compliance = 1.0 / 2e8 + (length - x) / rigidity;
    const double of_energy = 0.5 * force * force / rigidity, of_damping = beta * force / rigidity / compliance * r.v[1];
    return (force + of_energy + of_damping) * compliance;
  };
  for (const std::size_t i : {1, 2}) EXPECT_NEAR(r.delta[i], expected(r.x[i]), 1e-6 * expected(r.x[i]));
  EXPECT_LT(r.delta[2], 0.8 * r.delta[0]);
}

TEST(Drive, ASumOfSignalsIsTheSumOfEachAlone) {
  const double turn = 2.0 * std::numbers::pi;
  std::vector<SignalForm> forms(5);
  forms[0].steps = {{0.1, 2.0}, {0.3, -1.0}};
  forms[1].points = {{0.05, 1.0}, {0.25, 3.0}};
  forms[2].sine = SignalForm::Sine{0.4, 1.5, 7.0, 0.3};
  forms[3].sweep = SignalForm::Sweep{0.2, 0.7, 2.0, 20.0, 0.3, SignalForm::Spacing::logarithmic};
  forms[4].sweep = SignalForm::Sweep{0.0, 0.3, 20.0, 5.0, 0.3, SignalForm::Spacing::linear};
  const auto expected = [&](std::size_t k, double t) {
    const double s = std::min(t, 0.3), over = t - s;
    switch (k) {
      case 0:
        return t < 0.1 ? 0.0 : t < 0.3 ? 2.0 : -1.0;
      case 1:
        return 1.0 + 10.0 * (std::clamp(t, 0.05, 0.25) - 0.05);
      case 2:
        return 0.4 + 1.5 * std::sin(turn * 7.0 * t + 0.3);
      case 3:
        return 0.2 +
               0.7 * std::sin(turn * (2.0 * 0.3 / std::log(10.0) * (std::pow(10.0, s / 0.3) - 1.0) + 20.0 * over));
      default:
        return 0.3 * std::sin(turn * (20.0 * s - 0.5 * 15.0 / 0.3 * s * s + 5.0 * over));
    }
  };
  BoundSignal all(forms);
  for (double t = 0.0; t < 0.5; t += 0.01 + 1e-5) {
    double sum = 0.0;
    for (std::size_t k = 0; k < forms.size(); ++k) {
      BoundSignal one({forms[k]});
      one.bind(t);
      EXPECT_NEAR(one.at(t).value, expected(k, t), 1e-12) << k << " at " << t;
      sum += expected(k, t);
    }
    all.bind(t);
    EXPECT_NEAR(all.at(t).value, sum, 1e-12);
    EXPECT_NEAR(all.at(t).slope, (all.at(t + 1e-6).value - all.at(t - 1e-6).value) / 2e-6, 1e-4);
  }
}

/// A lever of 2 kg m^2 with its linkage, at an angle.
PlainDrive lever_at(double degrees) {
  PlainDrive d;
  d.drive.linkage = {0.5, 0.3};
  const PrsLever lever = prs_lever(&d.drive.linkage, degrees * std::numbers::pi / 180.0);
  d.drive.lever_inertia = 2.0;
  d.drive.lever_length = lever.length;
  d.drive.mass = 2.0 / (lever.ratio * lever.ratio);
  return d;
}

TEST(Drive, ALeverHasTheNumbersOfItsDefinition) {
  const PrsDrive drive = lever_at(60.0).drive;
  const PrsLever lever = prs_lever_at(&drive, 0.0);
  EXPECT_NEAR(lever.length, 0.435889894, 5e-10);
  EXPECT_NEAR(lever.ratio, 0.298019780, 5e-10);
  EXPECT_NEAR(prs_mass_at(&drive, 0.0), 22.518519, 5e-7);
  const double step = 1e-6, angle = std::numbers::pi / 3.0;
  const auto ratio = [&](double at) { return prs_lever(&drive.linkage, at).ratio; };
  EXPECT_NEAR(lever.bend, (ratio(angle + step) - ratio(angle - step)) / (2.0 * step), 1e-9);
}

/// A lever that swings widely on a soft held screw, against J theta'' + M = g F in the angle itself, by Runge-Kutta.
TEST(Drive, ALeverOnAHeldScrewFollowsItsOwnEquation) {
  constexpr double kStiffness = 4e4, kTorque = 300.0, kInertia = 2.0, kRest = std::numbers::pi / 3.0;
  PlainDrive d = lever_at(60.0);
  d.set_stiffness(kStiffness);
  d.drive.start_deflection = 0.0;
  d.motor = constant(0.0);
  d.force = constant(kTorque);
  constexpr double kStep = 1e-5;
  constexpr int kEach = 100, kSamples = 200;
  const DriveResult r = d.run(kSamples * kEach * kStep, kEach * kStep, 1e-10);
  ASSERT_EQ(r.lever_angle.size(), static_cast<std::size_t>(kSamples) + 1);
  const auto length = [](double theta) { return std::sqrt(0.34 - 0.3 * std::cos(theta)); };
  const auto turning = [&](double theta) {
    const double now = length(theta);
    return (-kTorque - 0.15 * std::sin(theta) / now * kStiffness * (now - length(kRest))) / kInertia;
  };
  double theta = kRest, speed = 0.0, lowest = kRest;
  for (int k = 0; k <= kSamples; ++k) {
    const auto at = static_cast<std::size_t>(k);
    EXPECT_NEAR(r.lever_angle[at], theta, 1e-8) << k;
    EXPECT_NEAR(r.lever_speed[at], speed, 1e-6) << k;
    EXPECT_NEAR(r.x[at], length(theta) - length(kRest), 1e-9) << k;
    EXPECT_NEAR(r.external[at] * prs_lever(&d.drive.linkage, theta).ratio, kTorque, 1e-5) << k;
    lowest = std::min(lowest, theta);
    for (int j = 0; j < kEach; ++j) {
      const double k1 = turning(theta), k2 = turning(theta + 0.5 * kStep * speed),
                   k3 = turning(theta + 0.5 * kStep * (speed + 0.5 * kStep * k1)),
                   k4 = turning(theta + kStep * (speed + 0.5 * kStep * k2));
      theta += kStep * (speed + kStep * (k1 + k2 + k3) / 6.0);
      speed += kStep * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
    }
  }
  EXPECT_LT(lowest, kRest - 0.1);  // Far enough that a constant mass would be wrong.
  EXPECT_LT(residual(r), 1e-8);
}

/// The resonance of a lever under load, against a small vibration of the run itself.
TEST(Drive, ALeverVibratesAboutItsLoadAsSmallVibrationHasIt) {
  constexpr double kTorque = 300.0;
  PlainDrive d = lever_at(60.0);
  d.set_stiffness(1e6);
  d.motor = constant(0.0);
  d.force = constant(kTorque);
  const double ratio = prs_lever_at(&d.drive, 0.0).ratio;
  const FrequencyResponse f = small_vibration(d.drive, {kTorque / ratio, 0.0}, {1.0});
  ASSERT_EQ(f.resonances.size(), 1U);
  d.drive.start_speed = 1e-6;
  const double period = 1.0 / f.resonances[0].frequency;
  const DriveResult r = d.run(20.0 * period, period / 40.0, 1e-11);
  // After twenty periods it is back, but for the share of a period by which the frequency is off.
  EXPECT_NEAR(r.x.back(), 0.0, 2e-4 * 1e-6 * period);
  EXPECT_NEAR(r.v.back(), 1e-6, 1e-5 * 1e-6);
}

TEST(Drive, FlanksThatTouchAtRestBeginToCarryWithoutAnImpact) {
  PlainDrive d;
  d.set_hertz(5e10, 0.0);
  d.drive.by = PRS_BY_TORQUE;
  d.drive.motor_inertia = 4e-4;
  d.motor = constant(1.0);
  const DriveResult r = d.run(2e-3, 1e-4);
  EXPECT_GT(r.force[5], 0.0);
  EXPECT_TRUE(r.impacts.empty() || r.impacts[0].time > 1e-4);
}

TEST(Drive, ABrakeHoldsWhatRunsAway) {
  PlainDrive d;
  d.drive.by = PRS_BY_TORQUE;
  d.drive.motor_inertia = 4e-4, d.drive.screw_inertia = 3e-4, d.drive.motor_friction = 0.1;
  d.force = constant(3000.0);
  d.motor = constant(0.0);
  EXPECT_LT(d.run(0.1, 1e-3).x.back(), -1e-3);
  d.drive.brake_torque = 5.0, d.drive.brake_at = 0.0;
  const DriveResult held = d.run(0.1, 1e-3);
  EXPECT_EQ(held.omega_m.back(), 0.0);
  EXPECT_NEAR(held.x.back(), 0.0, 1e-18);  // Rounding of the deflection under the force.
}

}  // namespace
}  // namespace prs
