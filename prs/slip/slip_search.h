#pragma once

#include <optional>

namespace prs {

// Included in kernels, therefore without Eigen.
struct SlipRange;
enum class SlipStatus;

/// Search for the slip ratio at which the moments on a roller are in balance: Newton's method from the ideal slip
/// ratio, between bounds. It requests one evaluation after the other, so that searches can run side by side:
///
///     while (!search.done()) search.take(evaluate at search.slip_ratio(), ..);
///
/// The last evaluation is without slope, at the slip ratio that was found or where the search gave up.
class SlipSearch {
 public:
  SlipSearch() = default;
  /// `imposed`: only this slip ratio is evaluated. `near`: a slip ratio near the root, on the same side of the ideal
  /// one, to start from.
  SlipSearch(const SlipRange& range, double speed, const std::optional<double>& imposed = {},
             const std::optional<double>& near = {});

  bool done() const { return status_ != SlipStatus{}; }
  SlipStatus status() const { return status_; }
  /// Slope of the residue along the slip ratio, at its last evaluation.
  double slope() const { return slope_ / (sense_ * way_); }
  int evaluations() const { return evaluations_; }

  double slip_ratio() const;
  /// Whether the next evaluation needs the slope along the slip ratio.
  bool wants_slope() const { return wants_slope_; }

  /// Takes R_z at `slip_ratio()`, see `relative_residue`, and its slope if requested.
  void take(double relative_residue, double slope);
  /// Replaces `take` if no normal loads exist.
  void jam();

 private:
  void end_as(SlipStatus status);
  void step();
  void set_end(double residue_at_ideal);
  void evaluate_next_at(double t);

  SlipStatus status_{};
  SlipStatus last_{};  ///< Status after the last evaluation.
  std::optional<double> imposed_;
  double sense_ = 1.0;              ///< Sign of the speed.
  double ideal_ = 0.0, way_ = 1.0;  ///< Ideal slip ratio, and from there to pure sliding.
  double t_ = 0.0;                  ///< 0 at the ideal slip ratio, 1 at pure sliding.
  double end_ = 1.0;                ///< Bound of t: 1, or where a driven carrier turns with the driving part, < 0.
  double at_ideal_ = 0.0;           ///< Residue at the ideal slip ratio.
  double residue_ = 0.0, slope_ = 0.0;
  double last_step_ = 0.0;
  double near_ = 0.0, far_ = 0.0;  ///< Bounds of the root; NaN: far one not known.
  bool wants_slope_ = true;
  int evaluations_ = 0;
};

}  // namespace prs
