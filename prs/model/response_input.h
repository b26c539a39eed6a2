#pragma once

#include <functional>

#include "modules/drive/drive.h"
#include "modules/drive/signal.h"
#include "prs/model/load_case.h"
#include "prs/model/model_options.h"

namespace prs {

/// Term of a signal that may also come from a file.
struct SignalTerm : SignalForm {
  struct File {
    std::string name;
    CsvColumn time, value;
  };
  std::optional<File> file;
};

/// A term, or the sum of several.
struct Signal {
  SignalTerm one;
  std::vector<SignalTerm> many;

  std::vector<SignalForm> terms() const {
    return many.empty() ? std::vector<SignalForm>{one} : std::vector<SignalForm>(many.begin(), many.end());
  }
};

/// Inputs of `prs response`: a screw in its drive, docs/response.md.
struct ResponseInput {
  enum class Feedback { motor, load };
  struct Controller {
    std::optional<Signal> speed, position;
    std::optional<double> position_gain, integral_time, largest_torque, largest_speed;
    double speed_gain = 0.0;
    Feedback feedback = Feedback::motor;
    bool speed_feed_forward = false;
  };
  struct CurrentLoop {
    double time_constant = 0.0;
  };
  struct Motor {
    double inertia = 0.0, friction_torque = 0.0, damping = 0.0;
    std::optional<Signal> torque, speed;
    std::optional<Controller> controller;
    std::optional<CurrentLoop> current_loop;
    std::optional<double> cut_at;
  };
  struct Brake {
    double torque = 0.0, at = 0.0;
  };
  struct Coupling {
    double stiffness = 0.0, damping = 0.0;
  };
  struct Screw {
    double inertia = 0.0, drag_torque = 0.0;
  };
  struct Load {
    double mass = 0.0, friction_force = 0.0, damping = 0.0;
    Signal force;
    std::optional<PrsLinkage> linkage;  ///< Linkage of a lever, with inertia and torque in place of mass and force.
    double inertia = 0.0;               ///< [kg m^2]
    Signal torque;                      ///< Torque against growing angles [N m].

    const Signal& acting() const { return linkage ? torque : force; }
  };
  struct MaterialDamping {
    std::optional<double> time, loss_factor, at_frequency;
  };
  struct EndStop {
    double at = 0.0, stiffness = 0.0, damping = 0.0;
  };
  struct EndStops {
    std::optional<EndStop> upper, lower;
  };
  enum class Ends { fixed_free, fixed_fixed };
  struct Shaft {
    double length = 0.0;
    Ends ends = Ends::fixed_free;
    std::optional<double> span;
  };
  struct Start {
    double position = 0.0, speed = 0.0;
    std::optional<double> deflection;
    std::optional<double> angle;  ///< Angle of a lever at `position` [rad].
  };
  struct Curves {
    std::optional<double> force, speed;
    std::optional<std::string> load_case;
  };
  struct Settling {
    double after = 0.0, band = 0.0;
  };
  enum class ScrewState { held, rolling };
  enum class Input { load_force, motor_torque };
  struct FrequencyResponse {
    double from = 0.0, to = 0.0;
    int points = 200;
    SignalTerm::Spacing spacing = SignalTerm::Spacing::logarithmic;
    std::optional<double> force, position;
    ScrewState screw = ScrewState::held;
    std::optional<double> speed;
    Input input = Input::load_force;
  };

  double duration = 0.0;
  std::optional<double> sample_interval;
  double tolerance = 1e-8;
  Motor motor;
  std::optional<Brake> brake;
  std::optional<Coupling> coupling;
  Screw screw;
  Load load;
  std::optional<MaterialDamping> material_damping;
  EndStops end_stops;
  std::optional<Shaft> shaft;
  Start start;
  Curves curves;
  std::optional<Settling> settling;
  std::optional<FrequencyResponse> frequency_response;

  double interval() const { return sample_interval.value_or(duration / 1000.0); }
  std::size_t samples() const { return 1 + static_cast<std::size_t>((1.0 + 1e-12) * duration / interval()); }
  /// The signal of the motor and its path below `response`.
  const Signal& signal() const;
  std::string_view signal_path() const;
  /// Every signal with its path.
  void for_each_signal(const std::function<void(const std::string&, Signal&)>& use);
};

inline constexpr double kMostSamples = 1e6;

}  // namespace prs
