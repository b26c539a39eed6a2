#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "modules/drive/recorder.h"

namespace prs {
namespace {

/// Steps of CVODE: the method of Adams, or BDF with Newton's method where something is stiff.
class Cvode {
 public:
  Cvode(const DriveRun& run, PrsRun& core) : core_(core), tolerance_(kShare * run.tolerance) {
    SUNContext_Create(nullptr, &context_);
    y_ = N_VNew_Serial(PRS_STATES, context_);
    const bool stiff = is_stiff(run);
    memory_ = CVodeCreate(stiff ? CV_BDF : CV_ADAMS, context_);
    N_VConst(0.0, y_);
    CVodeInit(memory_, rates, 0.0, y_);
    CVodeSetUserData(memory_, this);
    CVodeWFtolerances(memory_, weights);
    if (stiff) {
      matrix_ = SUNDenseMatrix(PRS_STATES, PRS_STATES, context_);
      linear_ = SUNLinSol_Dense(y_, matrix_, context_);
      CVodeSetLinearSolver(memory_, linear_, matrix_);
    } else {
      solver_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
      CVodeSetNonlinearSolver(memory_, solver_);
    }
    CVodeSetErrHandlerFn(
        memory_, [](int, const char*, const char*, char*, void*) {}, nullptr);
    double largest = 0.05 * run.duration;
    if (run.fastest > 0.0) largest = std::min(largest, 0.05 / run.fastest);
    CVodeSetMaxStep(memory_, largest);
    prs_scales(&core, scales_);
  }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;
  ~Cvode() {
    CVodeFree(&memory_);
    if (solver_ != nullptr) SUNNonlinSolFree(solver_);
    if (linear_ != nullptr) SUNLinSolFree(linear_);
    if (matrix_ != nullptr) SUNMatDestroy(matrix_);
    N_VDestroy(y_);
    SUNContext_Free(&context_);
  }

  PrsStepper stepper() {
    return {this, [](void* self, const PrsState* state) { return static_cast<Cvode*>(self)->begin(*state); },
            [](void* self, double stop, double* from, double* to) {
              return static_cast<Cvode*>(self)->step(stop, *from, *to);
            },
            [](void* self, double t, double* y) { static_cast<Cvode*>(self)->at(t, y); }};
  }

 private:
  static constexpr double kShare = 0.005;  ///< Errors of steps add up; this keeps their sum at the tolerance.

  /// Whether something dies away much faster than it vibrates.
  static bool is_stiff(const DriveRun& run) { return run.drive.time_constant > 0.0 && run.drive.time_constant < 2e-5; }

  static int rates(double t, N_Vector y, N_Vector rate, void* self) {
    prs_rates(&static_cast<Cvode*>(self)->core_, t, N_VGetArrayPointer(y), N_VGetArrayPointer(rate));
    return 0;
  }
  static int weights(N_Vector y, N_Vector weights, void* self) {
    const auto& cvode = *static_cast<Cvode*>(self);
    const double* const values = N_VGetArrayPointer(y);
    double* const w = N_VGetArrayPointer(weights);
    for (int k = 0; k < PRS_STATES; ++k)
      w[k] = 1.0 / (cvode.tolerance_ * std::max(std::abs(values[k]), cvode.scales_[k]));
    return 0;
  }

  int begin(const PrsState& state) {
    std::copy_n(state.y, PRS_STATES, N_VGetArrayPointer(y_));
    reached_ = state.t;
    return CVodeReInit(memory_, state.t, y_) == CV_SUCCESS ? 1 : 0;
  }
  int step(double stop, double& from, double& to) {
    CVodeSetStopTime(memory_, stop);
    if (CVode(memory_, stop, y_, &to, CV_ONE_STEP) < 0) return 0;
    double h = 0.0;
    CVodeGetLastStep(memory_, &h);
    from = to - h;
    reached_ = to;
    const double* const values = N_VGetArrayPointer(y_);
    for (int k = 0; k < PRS_STATES; ++k) scales_[k] = std::max(scales_[k], std::abs(values[k]));
    return 1;
  }
  void at(double t, double* y) {
    if (t == reached_) {  // As it came out of the step.
      std::copy_n(N_VGetArrayPointer(y_), PRS_STATES, y);
      return;
    }
    N_VectorContent_Serial content = static_cast<N_VectorContent_Serial>(y_->content);
    double* const own = content->data;
    content->data = y;
    CVodeGetDky(memory_, t, 0, y_);
    content->data = own;
  }

  PrsRun& core_;
  double tolerance_;
  double reached_ = -1.0;  ///< End of the last step
  double scales_[PRS_STATES] = {};
  SUNContext context_ = nullptr;
  N_Vector y_ = nullptr;
  void* memory_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
  SUNNonlinearSolver solver_ = nullptr;
};

constexpr long kMostSteps = 20'000'000;

void integrate(const DriveRun& run, DriveResult& result) {
  PrsRun core{};
  core.steps_left = kMostSteps;
  prs_run_start(&core, &run.drive, run.signals, 1e-12 * run.duration);
  Cvode cvode(run, core);
  const PrsStepper stepper = cvode.stepper();
  Recorder recorder(run, core, stepper, result);
  const PrsObserver observer = recorder.observer();
  constexpr DriveStatus kStatus[] = {DriveStatus::converged, DriveStatus::integration_failed, DriveStatus::step_limit,
                                     DriveStatus::left_shaft};
  result.status = kStatus[prs_run_to(&core, &stepper, &observer, run.duration)];
  recorder.finish();
}

}  // namespace
}  // namespace prs

extern "C" __attribute__((visibility("default"))) const prs::ResponseModule prs_module{{}, prs::integrate};
