#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace prs {

/// A value over time: a constant or one of the other forms, SI units.
struct SignalForm {
  struct Point {
    double at = 0.0, value = 0.0;
  };
  struct Sine {
    double mean = 0.0, amplitude = 0.0, frequency = 0.0, phase = 0.0;
  };
  enum class Spacing { logarithmic, linear };
  struct Sweep {
    double mean = 0.0, amplitude = 0.0, from = 0.0, to = 0.0, duration = 0.0;
    Spacing spacing = Spacing::logarithmic;
  };

  double constant = 0.0;  ///< NaN for a map without a form.
  std::optional<std::vector<Point>> steps, points;
  std::optional<Sine> sine;
  std::optional<Sweep> sweep;

  bool has_form() const { return steps || points || sine || sweep; }
};

/// Sum of several signals, valid for times from `bind` on up to `next`: a jump belongs to the later times.
class BoundSignal {
 public:
  struct Value {
    double value = 0.0, slope = 0.0, curve = 0.0;
  };

  explicit BoundSignal(const std::vector<SignalForm>& terms = {{}});

  void bind(double t);
  Value at(double t) const;
  /// First time after t at which the signal may jump or bend; infinity if there is none.
  double next(double t) const;
  double fastest() const;  ///< Highest frequency [Hz]

 private:
  struct Term {
    SignalForm what;
    std::size_t piece = 0;  ///< Points at or before the time
    bool is_over = false;   ///< Whether a sweep has ended
  };
  std::vector<Term> terms_;
};

}  // namespace prs
