#pragma once

#include <cmath>

#include "modules/drive/response_module.h"

namespace prs {

/// Collects samples, energies and extremes from the steps of a run. Energies are integrals over each step by Lobatto's
/// rule of five points, of magnitudes split at changes of sign; extremes inside a step are refined on the integrator's
/// own curve.
class Recorder {
 public:
  Recorder(const DriveRun& run, PrsRun& core, const PrsStepper& stepper, DriveResult& result);

  PrsObserver observer();
  void finish();

 private:
  enum Tracked { kTension, kCompression, kTorque, kBackTorque, kLag, kLead, kStop, kError, kBackError, kImpact, kAll };

  void begin(const PrsView& view, int closed);
  void step(const PrsView points[PRS_POINTS]);
  PrsView at(double t) const;
  double tracked(const PrsView& view, int which) const;
  void track(const PrsView& view);
  void refine(const PrsView points[PRS_POINTS]);
  double magnitude(double (*power)(const PrsView&), const PrsView points[PRS_POINTS], int depth) const;
  void sample(const PrsView& view);
  double next_sample() const {
    return run_.times != nullptr ? (*run_.times)[result_.time.size()]
                                 : static_cast<double>(result_.time.size()) * run_.sample_interval;
  }
  bool follows(double t) const { return t <= follow_until_; }
  DrivePeak larger(Tracked a, Tracked b) const { return peaks_[b].value > peaks_[a].value ? peaks_[b] : peaks_[a]; }

  const DriveRun& run_;
  PrsRun& core_;
  const PrsStepper& stepper_;
  DriveResult& result_;
  double follow_until_;
  double closed_ = -HUGE_VAL;  ///< Time of the last closing of a flank.
  DrivePeak peaks_[kAll];
};

}  // namespace prs
