#pragma once

#include "prs/mechanism/full_distribution.h"
#include "prs/threads/motion_orders.h"

namespace prs {

/// Deviations of a travel, after ISO 3408-3 [m].
struct TravelBands {
  double mean = 0.0;                       ///< e_0a: rise of the least-squares line, > 0 for too much travel.
  double variation = 0.0;                  ///< v_ua: width of the band along that line.
  std::optional<double> variation_300_mm;  ///< v_300a
  double variation_one_turn = 0.0;         ///< v_2pia
  std::vector<double> line;                ///< Value of the line at each position.
};

/// Bands of the displacements d_k at equal distances. `sense`: > 0 if the travel is along x; `one_turn` and
/// `in_300_mm`: number of steps of these lengths, 0 if the travel is shorter.
TravelBands travel_bands(const std::vector<double>& d, double sense, int one_turn, int in_300_mm);

struct OrderAmplitude {
  std::string name;
  double order = 0.0;
  double amplitude = 0.0;  ///< [m]
};

/// Amplitudes of the orders k/turns, by a discrete Fourier transform of the displacements less the
/// line through the first and the last.
std::vector<OrderAmplitude> travel_spectrum(const std::vector<double>& d, int turns);

/// Amplitudes by one least-squares fit of 1, k and all orders. Orders that the travel cannot distinguish are left out.
std::vector<OrderAmplitude> fitted_orders(const std::vector<double>& d, const Travel& travel,
                                          const std::vector<MotionOrder>& orders);

/// Normal loads over a travel.
struct TravelLoads {
  double largest = 0.0;                        ///< [N]
  double angle = 0.0;                          ///< Theta of the largest load [rad].
  int roller = 0, thread = 0;                  ///< Roller and thread of the largest load, from 1.
  double least = 0.0;                          ///< [N]
  RollerThreads mean, ripple;                  ///< Mean; ripple: largest less smallest [N].
  std::vector<std::vector<double>> of_roller;  ///< Loads of the roller with the largest load, at each
                                               ///< position one for each thread [N].
};

/// A support over a travel.
struct TravelSupport {
  double position = 0.0;               ///< x [m]
  std::vector<Eigen::Vector3d> force;  ///< Force on the part [N].
  std::vector<Lateral> moment;         ///< [N m]
};

/// Quasi-static positions of the turning mechanism. SI units.
struct TravelResult {
  struct Failure {
    double angle = 0.0;  ///< Theta [rad].
    std::string why;
    fe::NewtonStatus status = fe::NewtonStatus::no_equilibrium;
  };
  std::optional<Failure> failure;  ///< First position without equilibrium.
  bool converged() const { return !failure; }

  Travel travel;
  double slip_ratio = 0.0;
  double lead = 0.0;                 ///< Lead of the screw [m].
  std::vector<double> angle;         ///< Theta [rad].
  std::vector<double> displacement;  ///< u_x of the loaded section [m].
  double mean_displacement = 0.0;
  TravelBands bands;
  std::vector<OrderAmplitude> spectrum, orders;
  std::vector<double> tangent_stiffness;  ///< Stiffness at each position; empty if one has none [N/m].
  std::optional<double> left_out_at;      ///< Theta of the first position without stiffness.
  std::vector<Lateral> end_displacement, end_rotation;
  TravelSupport nut;
  std::vector<TravelSupport> bearings;
  double side_force_ripple = 0.0;  ///< [N]
  double tilt_ripple = 0.0;        ///< [rad]
  PerInterface<TravelLoads> loads;

  int positions() const { return static_cast<int>(angle.size()); }
  /// Displacement less its mean [m].
  std::vector<double> deviation() const {
    std::vector<double> less_mean = displacement;
    for (double& d : less_mean) d -= mean_displacement;
    return less_mean;
  }
};

/// A mechanism at each theta, and the solver of successive positions.
struct TravelModel {
  std::function<FullModel(double theta)> model;
  /// Turn of the carrier since the start; if it is given, models are solved in axes that turn with it, and results are
  /// turned back.
  std::function<double(double theta)> carrier;
  /// Makes a new solver for each chunk of positions, so that results do not depend on the number of threads.
  std::function<std::function<FullDistribution(const FullModel&)>()> solver;
};

TravelResult travel(const TravelModel& model, const Mechanism& mechanism, const Travel& wanted);

}  // namespace prs
