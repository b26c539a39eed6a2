#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "modules/drive/dormand_prince.h"
#include "modules/drive/recorder.h"

namespace prs {
namespace {

/// Share of the tolerance per step, which keeps the sum of the errors of steps within it.
constexpr double kShare = 0.005;

/// The longest step that resolves each sine of the signals.
double largest_step(const DriveRun& run) {
  const double share = 0.05 * run.duration;
  return run.fastest > 0.0 ? std::min(share, 0.05 / run.fastest) : share;
}

/// Scales errors by the largest value that each state has had.
template <class Values>
void grow(double scales[PRS_STATES], const Values& values) {
  for (int k = 0; k < PRS_STATES; ++k) scales[k] = std::max(scales[k], std::abs(values[k]));
}

/// Method of order 8, also used in exported units, for problems that are not stiff.
class Explicit {
 public:
  Explicit(const DriveRun& run, PrsRun& core) {
    prs_dormand_prince_start(&method_, &core, std::max(kShare * run.tolerance, 1e-13));
    method_.largest = std::min(method_.largest, largest_step(run));
    plain_ = prs_dormand_prince_stepper(&method_);
  }
  PrsStepper stepper() {
    PrsStepper stepper = plain_;
    stepper.step = [](void* self, double stop, double* from, double* to) {
      auto& own = *static_cast<PrsDormandPrince*>(self);
      const int done = prs_dormand_prince_stepper(&own).step(self, stop, from, to);
      grow(own.scale, own.y);
      return done;
    };
    return stepper;
  }

 private:
  PrsDormandPrince method_;
  PrsStepper plain_{};
};

/// Whether something decays much faster than it vibrates.
bool is_stiff(const DriveRun& run, const PrsRun& core) {
  const PrsDrive& d = run.drive;
  const double fastest = prs_fastest(&core);
  const double turning = d.coupled != 0 ? d.motor_inertia : d.motor_inertia + d.screw_inertia;
  double decay = std::max({d.material_damping * fastest * fastest, d.load_damping / prs_mass_at(&d, d.start_position),
                           (d.motor_damping + d.speed_gain) / turning});
  if (d.time_constant > 0.0) decay = std::max(decay, 1.0 / d.time_constant);
  if (d.coupled != 0) decay = std::max(decay, d.coupling_damping / d.coupling_stiffness * fastest * fastest);
  return decay > 20.0 * fastest;
}

/// BDF of CVODE with Newton's method.
class Cvode {
 public:
  Cvode(const DriveRun& run, PrsRun& core) : core_(core), tolerance_(std::max(kShare * run.tolerance, 1e-12)) {
#if SUNDIALS_VERSION_MAJOR >= 7
    SUNContext_Create(SUN_COMM_NULL, &context_);
    SUNContext_ClearErrHandlers(context_);
#else
    SUNContext_Create(nullptr, &context_);
#endif
    y_ = N_VNew_Serial(PRS_STATES, context_);
    memory_ = CVodeCreate(CV_BDF, context_);
    N_VConst(0.0, y_);
    CVodeInit(memory_, rates, 0.0, y_);
    CVodeSetUserData(memory_, this);
    CVodeWFtolerances(memory_, weights);
    matrix_ = SUNDenseMatrix(PRS_STATES, PRS_STATES, context_);
    linear_ = SUNLinSol_Dense(y_, matrix_, context_);
    CVodeSetLinearSolver(memory_, linear_, matrix_);
#if SUNDIALS_VERSION_MAJOR < 7
    CVodeSetErrHandlerFn(
        memory_, [](int, const char*, const char*, char*, void*) {}, nullptr);
#endif
    CVodeSetMaxStep(memory_, largest_step(run));
    prs_scales(&core, scales_);
  }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;
  ~Cvode() {
    CVodeFree(&memory_);
    SUNLinSolFree(linear_);
    SUNMatDestroy(matrix_);
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
    grow(scales_, N_VGetArrayPointer(y_));
    return 1;
  }
  void at(double t, double* y) {
    if (t == reached_) {  // State at the end of the step, without interpolation.
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
};

constexpr long kMostSteps = 5'000'000;

void integrate(const DriveRun& run, DriveResult& result) {
  PrsRun core{};
  core.steps_left = kMostSteps;
  prs_run_start(&core, &run.drive, run.signals, 1e-12 * run.duration);
  std::optional<Explicit> explicit_method;
  std::optional<Cvode> cvode;
  const PrsStepper stepper =
      is_stiff(run, core) ? cvode.emplace(run, core).stepper() : explicit_method.emplace(run, core).stepper();
  Recorder recorder(run, core, stepper, result);
  const PrsObserver observer = recorder.observer();
  constexpr DriveStatus kStatus[] = {DriveStatus::converged, DriveStatus::integration_failed, DriveStatus::step_limit,
                                     DriveStatus::left_shaft};
  result.fastest = prs_fastest(&core);
  result.status = kStatus[prs_run_to(&core, &stepper, &observer, run.duration)];
  recorder.finish();
}

}  // namespace
}  // namespace prs

extern "C" __attribute__((visibility("default"))) const prs::ResponseModule prs_module{{}, prs::integrate};
