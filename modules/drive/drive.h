/* A screw in its drive: motor, coupling, screw, mass, guides, end stops, brake, controller along one
   axis. SI units; force and deflection > 0 in tension. docs/response.md derives the equations. */
#ifndef PRS_DRIVE_H
#define PRS_DRIVE_H

#include "curves.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { PRS_BY_TORQUE, PRS_BY_SPEED, PRS_SPEED_LOOP, PRS_POSITION_LOOP };
enum { PRS_UPPER, PRS_LOWER };

typedef struct {
  int stands;
  double at, stiffness, damping; /* Force k p max(0, 1 + damping p') */
} PrsStop;

/* A screw between a point of a base and one of an arm, each at its distance from their joint. */
typedef struct {
  double base, arm; /* [m] */
} PrsLinkage;

/* The linkage at an angle between base and arm. */
typedef struct {
  double angle, length; /* [rad]; between the screw's ends [m] */
  double ratio, bend;   /* g = dL/dangle and dg/dangle [m/rad] */
} PrsLever;

/* All that does not change during a run. What is not there is 0, a bound or time that never comes
   HUGE_VAL. */
typedef struct {
  PrsCurves curves;
  double mass, screw_inertia, motor_inertia;
  int coupled;
  double coupling_stiffness, coupling_damping;
  double motor_friction, motor_damping, brake_torque, brake_at, cut_at;
  double drag, load_friction, load_damping;
  double material_damping; /* [s] */
  PrsStop stop[2];
  int has_shaft, fixed_fixed;
  double shaft_length, shaft_span, shaft_rigidity; /* Rigidity E A [N] */
  double start_position, start_speed, start_deflection;
  int by; /* PRS_BY_TORQUE, .. */
  double position_gain, speed_gain, integral_time, largest_torque, largest_speed;
  int feedback_of_load, feeds_speed_forward;
  double time_constant;               /* Of the current loop */
  PrsLinkage linkage;                 /* Arm 0: none; with a lever the mass is that at the start. */
  double lever_inertia, lever_length; /* Length between the screw's ends at the start */
} PrsDrive;

/* What the drive is told from outside. */
typedef struct {
  double motor;        /* Torque, speed, or reference of the controller */
  double slope, curve; /* Its first and second derivative */
  double force;        /* External, holds the load back against +x; of a lever its torque against growing angles */
} PrsInputs;

/* Values of one piece of the signals: `bind` chooses that which holds from t on, `at` continues it
   to both sides, `next` is the time at which it ends. */
typedef struct {
  void* self;
  void (*bind)(void* self, double t);
  void (*at)(void* self, double t, PrsInputs* inputs);
  double (*next)(void* self, double t);
} PrsSignals;

/* States; x counts from the start. */
enum { PRS_X, PRS_V, PRS_DELTA, PRS_OMEGA, PRS_THETA, PRS_OMEGA_M, PRS_INTEGRAL, PRS_TORQUE, PRS_STATES };
enum { PRS_LOAD, PRS_SCREW, PRS_MOTOR, PRS_PLACES };
enum { PRS_STICKS = 0, PRS_FREE = 2 }; /* Else the sense in which a place slides, 1 or -1 */

/* What holds between two events. */
typedef struct {
  int place[PRS_PLACES];
  int flank;   /* Which is closed: 1 in tension, -1 in compression, 0 none or not known yet */
  int stop[2]; /* Whether the load is in it */
  int bound;   /* T at the bound of its sign: 1, -1 with a frozen integral, 2, -2 along it */
  int winds;   /* The integral goes on although T is at its bound, as the error has the other sign. */
  int clipped; /* The reference of the speed loop is the largest speed, with its sign. */
  int lifted;  /* Damping would make a closed flank pull: it carries nothing. */
  int cut, braked;
} PrsModes;

typedef struct {
  double t;
  double y[PRS_STATES];
  PrsModes modes;
} PrsState;

enum { PRS_EVENTS = 16 };

/* All quantities of an instant. */
typedef struct {
  double t, x, v, phi, omega, phi_m, omega_m, delta, u;
  double force, static_force, tangent, shaft_force;
  double motor_torque, coupling_torque, external, stop_force, stop_pressed, stop_damped;
  double mass; /* That moves; of a lever reflected at this instant */
  PrsLever lever;
  double load_friction, screw_friction, motor_friction;
  double reference, error; /* Of the controller: its signal, and what following misses */
  double theta, delta_rate, theta_rate;
  double wanted, speed_error, speed_error_rate; /* T before its bound, e, e' */
  double asked, pressed; /* Speed before its bound; force of the closed flank before it is lifted */
  double drive[PRS_PLACES], up[PRS_PLACES], down[PRS_PLACES];
  double event[PRS_EVENTS]; /* > 0 until it happens */
  int left_shaft;           /* 2: the lever is at a dead centre */
} PrsView;

/* One step of an integrator; all return 0 where they failed. */
typedef struct {
  void* self;
  int (*begin)(void* self, const PrsState* state);
  int (*step)(void* self, double stop, double* from, double* to);
  void (*at)(void* self, double t, double y[PRS_STATES]); /* Within the last step */
} PrsStepper;

enum { PRS_POINTS = 5 };
extern const double prs_places[PRS_POINTS]; /* Of the points of Lobatto, 0 to 1 */

typedef struct {
  void* self;
  /* What happened at an instant: flanks that closed (1, -1), else 0; after all modes are set. */
  void (*begin)(void* self, const PrsView* view, int closed);
  /* One step or a part of it, without events inside, at the points of Lobatto. */
  void (*step)(void* self, const PrsView points[PRS_POINTS]);
} PrsObserver;

typedef struct {
  const PrsDrive* drive;
  PrsSignals signals;
  PrsCurves friction; /* Curves without lead: their torque is what friction takes. */
  double reach;       /* lead/(2 pi), signed [m/rad] */
  double slowest, play[2];
  int can_open[2];   /* Sense of the load that cannot pull: tension, compression */
  double resolution; /* Of the time of events [s] */
  long steps_left;
  PrsState state;
} PrsRun;

enum { PRS_DONE, PRS_FAILED, PRS_STEP_LIMIT, PRS_LEFT_SHAFT };

/* The drive at its start, t = 0, with the signals as they are. */
void prs_run_start(PrsRun* run, const PrsDrive* drive, PrsSignals signals, double resolution);
/* Goes on to a time. `run->state` is then that of this time, behind the events there. */
int prs_run_to(PrsRun* run, const PrsStepper* stepper, const PrsObserver* observer, double end);

/* The numbers of a drive but its curves, from `values` or, with `store`, into them; how many. */
enum { PRS_DRIVE_NUMBERS = 44 };
size_t prs_drive_numbers(PrsDrive* drive, double* values, int store);

/* Derivatives. */
void prs_rates(const PrsRun* run, double t, const double y[PRS_STATES], double rate[PRS_STATES]);
/* All quantities, with the derivatives where `rate` is not null. */
void prs_view(const PrsRun* run, double t, const double y[PRS_STATES], double rate[PRS_STATES], PrsView* view);

/* The linkage at an angle, or with a length between the screw's ends:
   L^2 = a^2 + b^2 - 2 a b cos(angle). */
PrsLever prs_lever(const PrsLinkage* linkage, double angle);
PrsLever prs_lever_of_length(const PrsLinkage* linkage, double length);
/* Whether base and arm are within 1 degree of a line, or beyond it. */
static inline int prs_is_dead_centre(double angle) {
  return !(angle > 0.017453292519943296 && angle < 3.1241393610698499);
}
/* The lever of a drive at a place of the load. */
PrsLever prs_lever_at(const PrsDrive* drive, double x);
/* Mass that moves along the axis at a place; of a lever J/g^2. */
double prs_mass_at(const PrsDrive* drive, double x);

/* Force of the curve under the shaft's compliance c: S and the way u of the screw under delta. */
double prs_series_force(const PrsCurves* curves, double delta, double c, double* u, double* tangent);
/* Compliance of the shaft [m/N] at a place of the load, its slope; 0 where the nut has left it. */
int prs_shaft_compliance(const PrsDrive* drive, double x, double* c, double* slope);
/* The deflection under a static force at a place. */
double prs_static_deflection(const PrsDrive* drive, double force, double x);
/* Integral of the force over the way of the screw [J]. */
double prs_elastic_energy(const PrsCurves* curves, double u);
/* What friction of the threads takes [N m], turning in the sense sigma. */
double prs_friction_torque(const PrsCurves* curves, double force, double speed, int sigma);
/* Sizes of the states from which errors of an integration count: those that a thousandth of the
   largest force brings about. */
void prs_scales(const PrsRun* run, double scale[PRS_STATES]);
/* Vertex of the parabola through three points with rising t; 0 where it has none between them. */
int prs_vertex(const double t[3], const double y[3], double* when, double* value);
/* Bound of the angular frequency of its vibrations [rad/s]. */
double prs_fastest(const PrsRun* run);
/* Energy that the drive holds [J]. */
double prs_stored_energy(const PrsRun* run, const PrsView* view);

#ifdef __cplusplus
}
#endif

#endif
