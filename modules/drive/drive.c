#include "drive.h"

#include <math.h>
#include <string.h>

#define TURN 6.283185307179586476925287

enum { EVENT_FLANK = 6, EVENT_STOP = 8, EVENT_BOUND = 10, EVENT_SPEED = 12, EVENT_WIND = 14, EVENT_LIFT = 15 };

const double prs_places[PRS_POINTS] = {0.0, 0.17267316464601142810, 0.5, 0.82732683535398857190, 1.0};

static double sign_of(double x) { return x < 0.0 ? -1.0 : 1.0; }
static double largest_of(double a, double b) { return a > b ? a : b; }
static double smallest_of(double a, double b) { return a < b ? a : b; }

size_t prs_drive_numbers(PrsDrive* d, double* values, int store) {
  double* const real[] = {&d->mass,
                          &d->screw_inertia,
                          &d->motor_inertia,
                          &d->coupling_stiffness,
                          &d->coupling_damping,
                          &d->motor_friction,
                          &d->motor_damping,
                          &d->brake_torque,
                          &d->brake_at,
                          &d->cut_at,
                          &d->drag,
                          &d->load_friction,
                          &d->load_damping,
                          &d->material_damping,
                          &d->stop[0].at,
                          &d->stop[0].stiffness,
                          &d->stop[0].damping,
                          &d->stop[1].at,
                          &d->stop[1].stiffness,
                          &d->stop[1].damping,
                          &d->shaft_length,
                          &d->shaft_span,
                          &d->shaft_rigidity,
                          &d->start_position,
                          &d->start_speed,
                          &d->start_deflection,
                          &d->position_gain,
                          &d->speed_gain,
                          &d->integral_time,
                          &d->largest_torque,
                          &d->largest_speed,
                          &d->time_constant,
                          &d->linkage.base,
                          &d->linkage.arm,
                          &d->lever_inertia,
                          &d->lever_length};
  int* const whole[] = {&d->coupled, &d->stop[0].stands,   &d->stop[1].stands,     &d->has_shaft, &d->fixed_fixed,
                        &d->by,      &d->feedback_of_load, &d->feeds_speed_forward};
  size_t n = 0, k;
  for (k = 0; k < sizeof real / sizeof *real; ++k, ++n)
    if (store)
      values[n] = *real[k];
    else
      *real[k] = values[n];
  for (k = 0; k < sizeof whole / sizeof *whole; ++k, ++n)
    if (store)
      values[n] = *whole[k];
    else
      *whole[k] = (int)values[n];
  return n;
}

/* The lever with a length and an angle that belong to each other. */
static PrsLever lever_of(const PrsLinkage* k, double length, double angle) {
  PrsLever lever;
  lever.angle = angle;
  lever.length = length;
  lever.ratio = k->base * k->arm * sin(angle) / length;
  lever.bend = (k->base * k->arm * cos(angle) - lever.ratio * lever.ratio) / length;
  return lever;
}

PrsLever prs_lever(const PrsLinkage* k, double angle) {
  const double a = k->base, b = k->arm;
  return lever_of(k, sqrt(a * a + b * b - 2.0 * a * b * cos(angle)), angle);
}

PrsLever prs_lever_of_length(const PrsLinkage* k, double length) {
  /* Of the half angle, which keeps its digits near a line. */
  const double a = k->base, b = k->arm;
  const double share = (length * length - (a - b) * (a - b)) / (4.0 * a * b);
  return lever_of(k, length, 2.0 * asin(sqrt(smallest_of(1.0, largest_of(0.0, share)))));
}

PrsLever prs_lever_at(const PrsDrive* d, double x) {
  return prs_lever_of_length(&d->linkage, d->lever_length + (x - d->start_position));
}

double prs_mass_at(const PrsDrive* d, double x) {
  double ratio;
  if (!(d->linkage.arm > 0.0)) return d->mass;
  ratio = prs_lever_at(d, x).ratio;
  return d->lever_inertia / (ratio * ratio);
}

double prs_friction_torque(const PrsCurves* curves, double force, double speed, int sigma) {
  int beyond;
  PrsCurves plain;
  if (curves->forces == 0) return 0.0;
  speed = sigma * largest_of(fabs(speed), curves->speed[0]);
  if (curves->lead == 0.0) return prs_torque(curves, force, speed, &beyond);
  plain = *curves;
  plain.lead = 0.0;
  return prs_torque(&plain, force, speed, &beyond);
}

/* Solves a u + c F(u) = right, which rises, from u on by Newton's method within bounds. */
static double solve_within(const PrsCurves* curves, double a, double c, double right, double low, double high, double u,
                           double* force, double* stiffness) {
  int beyond, k;
  *force = prs_force(curves, u, stiffness, &beyond);
  for (k = 0; k < 100; ++k) {
    const double rest = a * u + c * *force - right, slope = a + c * *stiffness;
    double next = slope > 0.0 ? u - rest / slope : low;
    if (fabs(next - u) <= 4e-16 * largest_of(fabs(u), fabs(a * right))) break;
    if (rest > 0.0)
      high = u;
    else
      low = u;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    u = next;
    *force = prs_force(curves, u, stiffness, &beyond);
  }
  return u;
}

double prs_series_force(const PrsCurves* curves, double delta, double c, double* u, double* tangent) {
  double force, stiffness;
  *u = solve_within(curves, 1.0, c, delta, smallest_of(delta, 0.0), largest_of(delta, 0.0), delta, &force, &stiffness);
  *tangent = stiffness / (1.0 + c * stiffness);
  return force;
}

int prs_shaft_compliance(const PrsDrive* d, double x, double* c, double* slope) {
  const double length = d->shaft_length - (x - d->start_position);
  *c = *slope = 0.0;
  if (!d->has_shaft) return 1;
  if (d->fixed_fixed) {
    *c = length * (d->shaft_span - length) / (d->shaft_span * d->shaft_rigidity);
    *slope = -(d->shaft_span - 2.0 * length) / (d->shaft_span * d->shaft_rigidity);
  } else {
    *c = length / d->shaft_rigidity;
    *slope = -1.0 / d->shaft_rigidity;
  }
  if (length > 0.0 && !(d->fixed_fixed && length >= d->shaft_span)) return 1;
  *c = largest_of(*c, 0.0);
  return 0;
}

double prs_static_deflection(const PrsDrive* d, double force, double x) {
  const PrsBranch* const branch = force < 0.0 ? &d->curves.compression : &d->curves.tension;
  const double sense = sign_of(force), near = sense * branch->origin;
  double far = near + sense * 1e-6, c, slope, stiffness, found;
  int beyond, k;
  if (force == 0.0) return 0.0;
  prs_shaft_compliance(d, x, &c, &slope);
  for (k = 0; k < 60 && sense * prs_force(&d->curves, far, &stiffness, &beyond) < fabs(force); ++k)
    far = near + 2.0 * (far - near);
  return solve_within(&d->curves, 0.0, 1.0, force, smallest_of(near, far), largest_of(near, far), far, &found,
                      &stiffness) +
         c * force;
}

double prs_elastic_energy(const PrsCurves* curves, double u) {
  /* By Gauss's rule of three points in each interval, exact for cubics, of the root too. */
  static const double place[3] = {-0.7745966692414834, 0.0, 0.7745966692414834};
  static const double weight[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  const PrsBranch* const branch = u < 0.0 ? &curves->compression : &curves->tension;
  const double sense = sign_of(u), way = fabs(u) - branch->origin;
  const double end = way > 0.0 ? (branch->root ? sqrt(way) : way) : 0.0;
  double energy = 0.0;
  size_t k;
  for (k = 0; k < branch->count; ++k) {
    const double from = branch->at[k];
    const double to = k + 1 < branch->count ? smallest_of(branch->at[k + 1], end) : end;
    int i, beyond;
    if (from >= end) break;
    for (i = 0; i < 3; ++i) {
      const double x = 0.5 * (from + to) + 0.5 * (to - from) * place[i];
      double stiffness;
      const double at = branch->origin + (branch->root ? x * x : x);
      energy += 0.5 * (to - from) * weight[i] * fabs(prs_force(curves, sense * at, &stiffness, &beyond)) *
                (branch->root ? 2.0 * x : 1.0);
    }
  }
  return energy;
}

/* Whether the closed flank is one that can open. */
static int is_loose(const PrsRun* run) {
  const int flank = run->state.modes.flank;
  return flank != 0 && run->can_open[flank < 0];
}

static int can_open(const PrsRun* run) { return run->can_open[0] || run->can_open[1]; }

/* Whether a place can stick at all. */
static int has_friction(const PrsRun* run, int place) {
  const PrsDrive* const d = run->drive;
  const int rotor = d->motor_friction > 0.0 || (run->state.modes.braked && d->brake_torque > 0.0);
  if (place == PRS_LOAD) return d->load_friction > 0.0;
  if (place == PRS_MOTOR) return rotor && d->coupled && d->by != PRS_BY_SPEED;
  if (!d->coupled && d->by == PRS_BY_SPEED) return 0;
  return run->friction.forces > 0 || d->drag > 0.0 || (!d->coupled && rotor);
}

/* The reference of the speed loop and its slope. */
static double wanted_speed(const PrsRun* run, const PrsInputs* in, PrsView* v, double* slope) {
  const PrsDrive* const d = run->drive;
  double speed = in->motor;
  *slope = in->slope;
  if (d->by == PRS_POSITION_LOOP) {
    const double r = run->reach;
    const double place = d->feedback_of_load ? v->x : v->x + v->delta + r * v->theta;
    const double rate = d->feedback_of_load ? v->v : r * v->omega_m;
    speed = d->position_gain * (in->motor - place) / r;
    *slope = d->position_gain * (in->slope - rate) / r;
    if (d->feeds_speed_forward) {
      speed += in->slope / r;
      *slope += in->curve / r;
    }
  }
  v->asked = speed;
  if (run->state.modes.clipped == 0) return speed;
  *slope = 0.0;
  return run->state.modes.clipped * d->largest_speed;
}

/* What the controller or the signal commands. */
static double commanded_torque(const PrsRun* run, const PrsInputs* in, const double* y, PrsView* v,
                               double* reference_slope) {
  const PrsDrive* const d = run->drive;
  const int bound = run->state.modes.bound;
  *reference_slope = 0.0;
  v->reference = in->motor;
  v->error = d->by == PRS_POSITION_LOOP ? in->motor - v->x : in->motor - v->omega_m;
  if (run->state.modes.cut || d->by == PRS_BY_SPEED) return 0.0;
  if (d->by == PRS_BY_TORQUE) return in->motor;
  v->speed_error = wanted_speed(run, in, v, reference_slope) - v->omega_m;
  v->wanted = d->speed_gain * v->speed_error;
  if (d->integral_time > 0.0) v->wanted += d->speed_gain * y[PRS_INTEGRAL] / d->integral_time;
  return bound == 0 ? v->wanted : (bound > 0 ? d->largest_torque : -d->largest_torque);
}

/* What holds the screw at rest: torques beyond these let it go upwards and downwards. */
static void holding(const PrsRun* run, double force, double rest, double* up, double* down) {
  const double drag = run->drive->drag;
  *up = largest_of(0.0, prs_friction_torque(&run->friction, force, 0.0, 1) + drag) + rest;
  *down = largest_of(0.0, drag - prs_friction_torque(&run->friction, force, 0.0, -1)) + rest;
}

static void take_force(const PrsRun* run, PrsView* v) {
  const PrsDrive* const d = run->drive;
  const PrsModes* const m = &run->state.modes;
  double compliance, compliance_slope;
  v->left_shaft = !prs_shaft_compliance(d, v->x, &compliance, &compliance_slope);
  v->pressed = 0.0;
  if (can_open(run) && (m->flank == 0 ? run->play[0] + run->play[1] > 0.0 : m->flank * v->delta < 0.0)) {
    v->static_force = v->tangent = v->force = 0.0;
    v->u = v->delta;
  } else {
    v->static_force = prs_series_force(&d->curves, v->delta, compliance, &v->u, &v->tangent);
    v->force = v->static_force + d->material_damping * v->tangent * v->delta_rate;
    v->pressed = m->flank * v->force;
    if (is_loose(run)) {
      if (m->lifted) v->force = 0.0;
    } else if (v->static_force > 0.0 ? run->can_open[0] && v->force < 0.0
                                     : v->static_force < 0.0 && run->can_open[1] && v->force > 0.0) {
      v->force = 0.0;
    }
  }
  v->shaft_force = 0.5 * v->static_force * v->static_force * compliance_slope;
}

static void take_stops(const PrsRun* run, PrsView* v) {
  const PrsDrive* const d = run->drive;
  const PrsModes* const m = &run->state.modes;
  int i;
  v->stop_force = v->stop_pressed = v->stop_damped = 0.0;
  for (i = 0; i < 2; ++i) {
    const PrsStop* const stop = &d->stop[i];
    const double sense = i == PRS_UPPER ? 1.0 : -1.0;
    const double p = sense * (v->x - stop->at), p_rate = sense * v->v;
    double factor;
    if (stop->stands) v->event[EVENT_STOP + i] = m->stop[i] ? p : -p;
    if (!m->stop[i] || p < 0.0) continue;
    factor = largest_of(0.0, 1.0 + stop->damping * p_rate);
    v->stop_force -= sense * stop->stiffness * p * factor;
    v->stop_pressed += stop->stiffness * p * factor;
    v->stop_damped += stop->stiffness * p * (factor - 1.0) * p_rate;
  }
}

/* Places that come to rest or are let go. */
static void take_events_of_places(const PrsRun* run, double rotor_friction, PrsView* v) {
  const PrsDrive* const d = run->drive;
  const PrsModes* const m = &run->state.modes;
  int i;
  for (i = 0; i < PRS_PLACES; ++i) {
    const double w = i == PRS_LOAD ? v->v : i == PRS_SCREW ? v->omega : v->omega_m;
    if (i == PRS_MOTOR && d->by == PRS_BY_SPEED) {
      if (m->place[i] != 0) v->event[2 * i] = m->place[i] * w;
      continue;
    }
    if (m->place[i] == PRS_FREE) continue;
    if (m->place[i] != PRS_STICKS) {
      v->event[2 * i] = m->place[i] * w;
      continue;
    }
    if (i == PRS_LOAD) {
      v->up[i] = v->down[i] = d->load_friction;
    } else if (i == PRS_MOTOR) {
      v->up[i] = v->down[i] = rotor_friction;
    } else {
      holding(run, v->force, d->coupled ? 0.0 : rotor_friction, &v->up[i], &v->down[i]);
    }
    v->event[2 * i] = v->up[i] - v->drive[i];
    v->event[2 * i + 1] = v->drive[i] + v->down[i];
  }
}

static void take_events_of_flanks(const PrsRun* run, PrsView* v) {
  const PrsModes* const m = &run->state.modes;
  if (can_open(run)) {
    if (m->flank == 1) v->event[EVENT_FLANK] = v->delta - run->play[0];
    if (m->flank == -1) v->event[EVENT_FLANK] = -v->delta - run->play[1];
    if (m->flank == 0 && run->play[0] + run->play[1] > 0.0) {
      v->event[EVENT_FLANK] = run->play[0] - v->delta;
      v->event[EVENT_FLANK + 1] = v->delta + run->play[1];
    }
  }
  if (run->drive->material_damping > 0.0 && is_loose(run)) v->event[EVENT_LIFT] = m->lifted ? -v->pressed : v->pressed;
}

/* The controller at its bounds of speed and torque. */
static void take_events_of_controller(const PrsRun* run, PrsView* v) {
  const PrsDrive* const d = run->drive;
  const PrsModes* const m = &run->state.modes;
  if (d->by >= PRS_SPEED_LOOP && !m->cut && d->largest_speed < HUGE_VAL) {
    v->event[EVENT_SPEED] = m->clipped != 0 ? m->clipped * v->asked - d->largest_speed : d->largest_speed - v->asked;
    if (m->clipped == 0) v->event[EVENT_SPEED + 1] = d->largest_speed + v->asked;
  }
  if (d->by >= PRS_SPEED_LOOP && !m->cut && d->largest_torque < HUGE_VAL) {
    const double sense = m->bound < 0 ? -1.0 : 1.0;
    if (m->bound == 0) {
      v->event[EVENT_BOUND] = d->largest_torque - v->wanted;
      v->event[EVENT_BOUND + 1] = d->largest_torque + v->wanted;
    } else if (m->bound == 1 || m->bound == -1) {
      v->event[EVENT_BOUND] = sense * v->wanted - d->largest_torque;
    } else {
      v->event[EVENT_BOUND] = -sense * v->speed_error_rate;
      v->event[EVENT_BOUND + 1] = sense * (v->speed_error + d->integral_time * v->speed_error_rate);
    }
    if (d->integral_time > 0.0 && (m->bound == 1 || m->bound == -1))
      v->event[EVENT_WIND] = (m->winds ? -m->bound : m->bound) * v->speed_error;
  }
}

/* The equations: all quantities of an instant, derivatives where `rate` is not null, and with
   `with_events` angles, what holds places, and events. */
static void evaluate(const PrsRun* run, double t, const double* y, double* rate, PrsView* v, int with_events) {
  const PrsDrive* const d = run->drive;
  const PrsModes* const m = &run->state.modes;
  const double r = run->reach;
  const int by_speed = d->by == PRS_BY_SPEED, rigid = !d->coupled;
  double reference_slope, command, acceleration, turning, free_force;
  double rotor_friction, thread = 0.0, motor_turning, swing = 0.0;
  PrsInputs in;
  int motor_sense, i;
  for (i = 0; i < PRS_EVENTS; ++i) v->event[i] = 1.0;
  run->signals.at(run->signals.self, t, &in);
  v->t = t;
  v->x = d->start_position + y[PRS_X];
  v->v = y[PRS_V];
  v->delta = y[PRS_DELTA];
  v->theta = rigid ? 0.0 : y[PRS_THETA];
  v->omega = rigid && by_speed ? in.motor : y[PRS_OMEGA];
  v->omega_m = by_speed ? in.motor : rigid ? y[PRS_OMEGA] : y[PRS_OMEGA_M];
  v->delta_rate = r * v->omega - v->v;
  v->theta_rate = rigid ? 0.0 : v->omega_m - v->omega;
  v->external = in.force;
  v->mass = d->mass;
  take_force(run, v);
  if (d->linkage.arm > 0.0) { /* J angle'' + M = g F */
    const PrsLever lever = prs_lever_at(d, v->x);
    const double squared = lever.ratio * lever.ratio;
    v->lever = lever;
    v->mass = d->lever_inertia / squared;
    v->external = in.force / lever.ratio;
    swing = v->mass * lever.bend * v->v * v->v / squared;
    if (prs_is_dead_centre(lever.angle)) v->left_shaft = 2;
  }
  take_stops(run, v);

  /* Motor. */
  v->coupling_torque = rigid ? 0.0 : d->coupling_stiffness * v->theta + d->coupling_damping * v->theta_rate;
  v->wanted = v->speed_error = v->asked = 0.0;
  command = commanded_torque(run, &in, y, v, &reference_slope);
  if (with_events && m->bound == 0 && d->by >= PRS_SPEED_LOOP && fabs(command) > d->largest_torque)
    command = sign_of(command) * d->largest_torque; /* By rounding, at the event itself. */
  v->motor_torque = d->time_constant > 0.0 ? y[PRS_TORQUE] : command;
  rotor_friction = d->motor_friction + (m->braked ? d->brake_torque : 0.0);
  motor_sense = by_speed || !rigid ? m->place[PRS_MOTOR] : m->place[PRS_SCREW];
  if (motor_sense == PRS_FREE) motor_sense = v->omega_m < 0.0 ? -1 : 1; /* Without friction it does not matter. */
  v->motor_friction = motor_sense * rotor_friction;

  /* Load. */
  free_force = v->force + v->shaft_force - v->external + v->stop_force + swing;
  v->drive[PRS_LOAD] = free_force;
  v->load_friction = m->place[PRS_LOAD] == PRS_FREE ? 0.0 : m->place[PRS_LOAD] * d->load_friction;
  acceleration =
      m->place[PRS_LOAD] == PRS_STICKS ? 0.0 : (free_force - v->load_friction - d->load_damping * v->v) / v->mass;

  /* Screw, and with it the rotor where both are one. */
  {
    int sense = rigid && by_speed ? m->place[PRS_MOTOR] : m->place[PRS_SCREW];
    const double inertia = d->screw_inertia + (rigid ? d->motor_inertia : 0.0);
    if (sense == PRS_FREE) sense = v->omega < 0.0 ? -1 : 1;
    if (sense != 0) thread = prs_friction_torque(&run->friction, v->force, v->omega, sense) + sense * d->drag;
    v->screw_friction = thread;
    v->drive[PRS_SCREW] = (rigid ? v->motor_torque : v->coupling_torque) - r * v->force;
    if (rigid && by_speed)
      turning = in.slope;
    else if (m->place[PRS_SCREW] == PRS_STICKS)
      turning = 0.0;
    else
      turning =
          (v->drive[PRS_SCREW] - thread - (rigid ? v->motor_friction + d->motor_damping * v->omega : 0.0)) / inertia;
    motor_turning = turning;
  }

  /* Rotor. */
  v->drive[PRS_MOTOR] = v->motor_torque - v->coupling_torque;
  if (by_speed) {
    motor_turning = in.slope;
    if (!rigid) {
      if (motor_sense == 0)
        v->motor_friction = smallest_of(largest_of(-v->coupling_torque, -rotor_friction), rotor_friction);
      v->motor_torque =
          d->motor_inertia * in.slope + v->coupling_torque + v->motor_friction + d->motor_damping * v->omega_m;
    } else {
      const double load = r * v->force;
      double held = thread + v->motor_friction;
      if (motor_sense == 0) {
        double up, down;
        holding(run, v->force, rotor_friction, &up, &down);
        held = smallest_of(largest_of(-load, -down), up);
      }
      v->motor_torque = (d->motor_inertia + d->screw_inertia) * in.slope + load + held + d->motor_damping * v->omega_m;
    }
  } else if (!rigid) {
    motor_turning = m->place[PRS_MOTOR] == PRS_STICKS
                        ? 0.0
                        : (v->drive[PRS_MOTOR] - v->motor_friction - d->motor_damping * v->omega_m) / d->motor_inertia;
  }
  if (rigid)
    v->coupling_torque =
        v->motor_torque - d->motor_inertia * motor_turning - v->motor_friction - d->motor_damping * v->omega_m;
  v->speed_error_rate = reference_slope - motor_turning;

  if (rate) {
    rate[PRS_X] = v->v;
    rate[PRS_V] = acceleration;
    rate[PRS_DELTA] = v->delta_rate;
    rate[PRS_OMEGA] = rigid && by_speed ? 0.0 : turning;
    rate[PRS_THETA] = v->theta_rate;
    rate[PRS_OMEGA_M] = by_speed || rigid ? 0.0 : motor_turning;
    rate[PRS_INTEGRAL] = 0.0;
    if (d->integral_time > 0.0 && !m->cut) {
      if (m->bound == 2 || m->bound == -2)
        rate[PRS_INTEGRAL] = -d->integral_time * v->speed_error_rate;
      else if (m->bound == 0 || m->winds)
        rate[PRS_INTEGRAL] = v->speed_error;
    }
    rate[PRS_TORQUE] = d->time_constant > 0.0 ? (command - y[PRS_TORQUE]) / d->time_constant : 0.0;
  }
  if (!with_events) return;

  v->phi = (v->x + v->delta) / r;
  v->phi_m = v->phi + v->theta;
  take_events_of_places(run, rotor_friction, v);
  take_events_of_flanks(run, v);
  take_events_of_controller(run, v);
}

void prs_rates(const PrsRun* run, double t, const double y[PRS_STATES], double rate[PRS_STATES]) {
  PrsView view;
  evaluate(run, t, y, rate, &view, 0);
}

void prs_view(const PrsRun* run, double t, const double y[PRS_STATES], double rate[PRS_STATES], PrsView* view) {
  evaluate(run, t, y, rate, view, 1);
}

void prs_scales(const PrsRun* run, double scale[PRS_STATES]) {
  const PrsDrive* const d = run->drive;
  const PrsBranch* const branch = &d->curves.tension;
  const double force = 1e-3 * branch->force[branch->count - 1];
  const double way = fabs(prs_static_deflection(d, force, d->start_position)) - branch->origin;
  const double time = sqrt(d->mass * way / force), r = fabs(run->reach);
  scale[PRS_X] = scale[PRS_DELTA] = way;
  scale[PRS_V] = way / time;
  scale[PRS_OMEGA] = scale[PRS_OMEGA_M] = way / time / r;
  scale[PRS_THETA] = d->coupled ? r * force / d->coupling_stiffness : 1.0;
  scale[PRS_INTEGRAL] = way / r;
  scale[PRS_TORQUE] = r * force;
}

double prs_fastest(const PrsRun* run) {
  const PrsDrive* const d = run->drive;
  /* The arm of a screw at a lever is at most the shorter of base and arm. */
  const double arm = smallest_of(d->linkage.base, d->linkage.arm);
  const double r = run->reach, load = arm > 0.0 ? arm * arm / d->lever_inertia : 1.0 / d->mass;
  double steepest = 0.0, turns = 0.0, twists = 0.0;
  int i;
  for (i = 0; i < 2; ++i) {
    const PrsBranch* const branch = i == 0 ? &d->curves.tension : &d->curves.compression;
    const size_t last = branch->count - 1;
    const double slope = branch->slope[last] / (branch->root ? 2.0 * branch->at[last] : 1.0);
    steepest = largest_of(steepest, slope);
  }
  if (d->coupled) {
    turns = r * r / d->screw_inertia;
    twists = 1.0 / d->screw_inertia + (d->by == PRS_BY_SPEED ? 0.0 : 1.0 / d->motor_inertia);
  } else if (d->by != PRS_BY_SPEED) {
    turns = r * r / (d->screw_inertia + d->motor_inertia);
  }
  return sqrt(steepest * (load + turns) + d->coupling_stiffness * twists +
              largest_of(d->stop[PRS_UPPER].stiffness, d->stop[PRS_LOWER].stiffness) * load);
}

double prs_stored_energy(const PrsRun* run, const PrsView* v) {
  const PrsDrive* const d = run->drive;
  double c, slope, energy;
  int i;
  prs_shaft_compliance(d, v->x, &c, &slope);
  energy = 0.5 * (v->mass * v->v * v->v + d->screw_inertia * v->omega * v->omega +
                  d->motor_inertia * v->omega_m * v->omega_m + c * v->static_force * v->static_force +
                  d->coupling_stiffness * v->theta * v->theta) +
           prs_elastic_energy(&d->curves, v->u);
  for (i = 0; i < 2; ++i) {
    const double p = (i == PRS_UPPER ? 1.0 : -1.0) * (v->x - d->stop[i].at);
    if (d->stop[i].stands && p > 0.0) energy += 0.5 * d->stop[i].stiffness * p * p;
  }
  return energy;
}

/* Sense of a prescribed speed behind t. */
static int sense_of_speed(const PrsRun* run, double t, int at_zero) {
  PrsInputs in, later;
  run->signals.at(run->signals.self, t, &in);
  if (!at_zero && in.motor != 0.0) return in.motor < 0.0 ? -1 : 1;
  if (in.slope != 0.0) return in.slope < 0.0 ? -1 : 1;
  run->signals.at(run->signals.self, t + 1e3 * run->resolution, &later);
  return later.motor < 0.0 ? -1 : later.motor > 0.0 ? 1 : 0;
}

/* Whether the torque that stands at its bound stays there, and how. */
static void set_bound(PrsRun* run, int is_at_bound) {
  const PrsDrive* const d = run->drive;
  PrsModes* const m = &run->state.modes;
  const int before = m->bound;
  double rate[PRS_STATES], inside, outside, sense;
  PrsView v;
  m->bound = 0;
  if (d->by < PRS_SPEED_LOOP || m->cut || !(d->largest_torque < HUGE_VAL)) return;
  evaluate(run, run->state.t, run->state.y, rate, &v, 0);
  sense = sign_of(v.wanted);
  if (before == 2 || before == -2)
    is_at_bound = is_at_bound || fabs(fabs(v.wanted) - d->largest_torque) < 1e-9 * d->largest_torque;
  if (!is_at_bound) {
    m->bound = fabs(v.wanted) > d->largest_torque ? (int)sense : 0;
    return;
  }
  m->bound = (int)sense;
  evaluate(run, run->state.t, run->state.y, rate, &v, 0);
  inside = outside = sense * v.speed_error_rate;
  if (d->integral_time > 0.0) {
    inside += sense * v.speed_error / d->integral_time;
    if (!(sense * v.speed_error > 0.0)) outside = inside;
  }
  if (outside <= 0.0) m->bound = inside > 0.0 ? (int)(2.0 * sense) : 0;
}

/* Sets the modes behind t: places that have come to rest or may let go, flanks, stops, bounds. */
static int settle(PrsRun* run, const int fired[PRS_EVENTS]) {
  const PrsDrive* const d = run->drive;
  PrsState* const s = &run->state;
  PrsModes* const m = &s->modes;
  const double near = run->resolution;
  int closed = 0, i, tests[PRS_PLACES];
  PrsView v;
  run->signals.bind(run->signals.self, s->t);
  m->braked = s->t >= d->brake_at - near;
  if (!m->cut && s->t >= d->cut_at - near) m->cut = 1;

  if (fired[EVENT_FLANK] || fired[EVENT_FLANK + 1]) {
    const int before = m->flank;
    if (before == 0)
      closed = m->flank = fired[EVENT_FLANK] ? 1 : -1;
    else if (run->play[0] + run->play[1] > 0.0)
      m->flank = 0;
    else
      closed = m->flank = -before;
  }
  for (i = 0; i < 2; ++i)
    if (fired[EVENT_STOP + i]) m->stop[i] = !m->stop[i];

  for (i = 0; i < PRS_PLACES; ++i) {
    double* const w = &s->y[i == PRS_LOAD ? PRS_V : i == PRS_SCREW ? PRS_OMEGA : PRS_OMEGA_M];
    tests[i] = 0;
    if (i == PRS_MOTOR && d->by == PRS_BY_SPEED) {
      m->place[i] = sense_of_speed(run, s->t, fired[2 * i]);
      continue;
    }
    if (!has_friction(run, i)) {
      m->place[i] = PRS_FREE;
      continue;
    }
    if (m->place[i] == PRS_FREE) m->place[i] = *w < 0.0 ? -1 : 1; /* The brake has come. */
    if (m->place[i] == PRS_STICKS || fired[2 * i] || *w == 0.0) {
      tests[i] = fired[2 * i] != 2;
      *w = 0.0;
      m->place[i] = PRS_STICKS;
    }
  }
  evaluate(run, s->t, s->y, 0, &v, 0);
  m->clipped = v.asked > d->largest_speed ? 1 : v.asked < -d->largest_speed ? -1 : 0;
  m->lifted = v.pressed < 0.0;
  if (m->bound == 0 || m->cut) set_bound(run, fired[EVENT_BOUND] || fired[EVENT_BOUND + 1]);
  evaluate(run, s->t, s->y, 0, &v, 1);
  for (i = 0; i < PRS_PLACES; ++i) {
    if (!tests[i]) continue;
    if (v.drive[i] > v.up[i]) m->place[i] = 1;
    if (v.drive[i] < -v.down[i]) m->place[i] = -1;
  }
  set_bound(run, fired[EVENT_BOUND] || fired[EVENT_BOUND + 1]);
  m->winds = sign_of(m->bound) * v.speed_error <= 0.0;
  return closed;
}

void prs_run_start(PrsRun* run, const PrsDrive* d, PrsSignals signals, double resolution) {
  static const int none[PRS_EVENTS];
  PrsState* const s = &run->state;
  PrsInputs in;
  PrsView v;
  double c, slope, u, tangent;
  memset(s, 0, sizeof *s);
  run->drive = d;
  run->signals = signals;
  run->friction = d->curves;
  run->friction.lead = 0.0;
  run->reach = d->curves.lead / TURN;
  run->can_open[0] = d->curves.tension.root;
  run->can_open[1] = d->curves.compression.root;
  run->play[0] = d->curves.tension.origin;
  run->play[1] = d->curves.compression.origin;
  run->resolution = resolution;
  run->slowest = run->friction.forces > 0 ? run->friction.speed[0] : 0.0;
  signals.bind(signals.self, 0.0);
  signals.at(signals.self, 0.0, &in);
  s->y[PRS_V] = d->start_speed;
  s->y[PRS_OMEGA] = d->coupled || d->by != PRS_BY_SPEED ? d->start_speed / run->reach : 0.0;
  s->y[PRS_OMEGA_M] = d->coupled && d->by != PRS_BY_SPEED ? d->start_speed / run->reach : 0.0;
  s->y[PRS_DELTA] = d->start_deflection < HUGE_VAL
                        ? d->start_deflection
                        : prs_static_deflection(
                              d, d->linkage.arm > 0.0 ? in.force / prs_lever_at(d, d->start_position).ratio : in.force,
                              d->start_position);
  if (s->y[PRS_DELTA] > run->play[0]) s->modes.flank = 1;
  if (s->y[PRS_DELTA] < -run->play[1]) s->modes.flank = -1;
  prs_shaft_compliance(d, d->start_position, &c, &slope);
  if (d->coupled && (s->modes.flank != 0 || !can_open(run)))
    s->y[PRS_THETA] =
        run->reach * prs_series_force(&d->curves, s->y[PRS_DELTA], c, &u, &tangent) / d->coupling_stiffness;
  s->modes.stop[PRS_UPPER] = d->stop[PRS_UPPER].stands && d->start_position > d->stop[PRS_UPPER].at;
  s->modes.stop[PRS_LOWER] = d->stop[PRS_LOWER].stands && d->start_position < d->stop[PRS_LOWER].at;
  s->modes.place[PRS_LOAD] = s->modes.place[PRS_SCREW] = s->modes.place[PRS_MOTOR] = PRS_FREE;
  settle(run, none);
  if (d->time_constant > 0.0) {
    evaluate(run, 0.0, s->y, 0, &v, 0);
    s->y[PRS_TORQUE] = s->modes.cut             ? 0.0
                       : d->by == PRS_BY_TORQUE ? in.motor
                       : s->modes.bound == 0    ? v.wanted
                                                : sign_of(s->modes.bound) * d->largest_torque;
    settle(run, none);
  }
}

/* The event of a step: which, and when. */
typedef struct {
  double from, to; /* Before it and behind it */
  int index;
} Crossing;

static double event_at(const PrsRun* run, const PrsStepper* stepper, double t, int index) {
  double y[PRS_STATES];
  PrsView v;
  stepper->at(stepper->self, t, y);
  evaluate(run, t, y, 0, &v, 1);
  return v.event[index];
}

/* The first time behind the event, by the rule of Illinois. */
static double root_of(const PrsRun* run, const PrsStepper* stepper, Crossing c) {
  double before = event_at(run, stepper, c.from, c.index), behind = event_at(run, stepper, c.to, c.index);
  int side = 0, k;
  for (k = 0; k < 200 && c.to - c.from > run->resolution; ++k) {
    double t = c.from + (c.to - c.from) * before / (before - behind), g;
    if (k % 8 == 7 || !(t > c.from && t < c.to)) t = 0.5 * (c.from + c.to);
    if (t - c.from < 0.4 * run->resolution) t = c.from + 0.4 * run->resolution;
    if (c.to - t < 0.4 * run->resolution) t = c.to - 0.4 * run->resolution;
    g = event_at(run, stepper, t, c.index);
    if (g >= 0.0) {
      c.from = t;
      before = g;
      if (side == 1) behind *= 0.5;
      side = 1;
    } else {
      c.to = t;
      behind = g;
      if (side == -1) before *= 0.5;
      side = -1;
    }
  }
  return c.to;
}

static void points_of(const PrsRun* run, const PrsStepper* stepper, double from, double to, PrsView points[PRS_POINTS],
                      int first) {
  int k;
  for (k = first; k < PRS_POINTS; ++k) {
    double y[PRS_STATES];
    const double t = k == PRS_POINTS - 1 ? to : from + prs_places[k] * (to - from);
    stepper->at(stepper->self, t, y);
    evaluate(run, t, y, 0, &points[k], 1);
  }
}

int prs_vertex(const double t[3], const double y[3], double* when, double* value) {
  const double h0 = t[1] - t[0], h1 = t[2] - t[1];
  const double s0 = (y[1] - y[0]) / h0, s1 = (y[2] - y[1]) / h1;
  const double bend = (s1 - s0) / (h0 + h1), slope = (s0 * h1 + s1 * h0) / (h0 + h1);
  if (!(fabs(bend) > 0.0)) return 0;
  *when = t[1] - 0.5 * slope / bend;
  *value = y[1] - 0.25 * slope * slope / bend;
  return *when > t[0] && *when < t[2];
}

/* Finds the first event of a step; arms those that have left their root. A place of three points
   whose parabola dips below zero between them is looked at there, as two roots may lie in a step. */
static int first_event(const PrsRun* run, const PrsStepper* stepper, const PrsView points[PRS_POINTS],
                       int armed[PRS_EVENTS], double* when) {
  int found = 0, i, k;
  for (i = 0; i < PRS_EVENTS; ++i) {
    for (k = 1; k < PRS_POINTS; ++k) {
      const double a = points[k - 1].event[i], b = points[k].event[i];
      Crossing crossing;
      crossing.from = points[k - 1].t;
      crossing.to = points[k].t;
      crossing.index = i;
      if (found && crossing.from >= *when) break;
      if (!armed[i]) {
        if (b > 0.0) armed[i] = 1;
        continue;
      }
      if (b > 0.0 && b <= a && k + 1 < PRS_POINTS && b <= points[k + 1].event[i]) {
        double times[3], values[3], t, value;
        times[0] = points[k - 1].t, times[1] = points[k].t, times[2] = points[k + 1].t;
        values[0] = a, values[1] = b, values[2] = points[k + 1].event[i];
        if (prs_vertex(times, values, &t, &value) && value < 0.5 * b && event_at(run, stepper, t, i) < 0.0) {
          if (t >= points[k].t) crossing.from = points[k].t;
          crossing.to = t;
          *when = root_of(run, stepper, crossing);
          found = 1;
          break;
        }
      }
      if (b < 0.0) {
        const double t = root_of(run, stepper, crossing);
        if (!found || t < *when) *when = t;
        found = 1;
        break;
      }
    }
  }
  return found;
}

/* An event that stands at its root waits until it has left it, but for the end of sticking. */
static int is_armed(const PrsState* s, double event, int i) {
  const int sticks = i < EVENT_FLANK && s->modes.place[i / 2] == PRS_STICKS;
  return event > 0.0 || (sticks && event == 0.0);
}

/* What did not happen although it stood at its root: a place that was let go and turns back at once
   sticks, one that stuck by a hair goes, a flank that touched has not closed. */
static int false_start(const PrsRun* run, const PrsView* from, const PrsView* to, const int armed[PRS_EVENTS],
                       int fired[PRS_EVENTS]) {
  int i;
  for (i = 0; i < EVENT_BOUND; ++i) {
    if (armed[i] || !(to->event[i] < from->event[i] && to->event[i] < 0.0)) continue;
    if (i == 2 * PRS_MOTOR && run->drive->by == PRS_BY_SPEED) continue;
    fired[i] = i < EVENT_FLANK && run->state.modes.place[i / 2] != PRS_STICKS ? 2 : 1;
    return 1;
  }
  return 0;
}

int prs_run_to(PrsRun* run, const PrsStepper* stepper, const PrsObserver* observer, double end) {
  const PrsDrive* const d = run->drive;
  PrsState* const s = &run->state;
  int fired[PRS_EVENTS] = {0}, vain = 0;
  for (;;) {
    PrsView points[PRS_POINTS];
    int armed[PRS_EVENTS], happened = 0, i, closed;
    double stop;
    closed = settle(run, fired);
    memset(fired, 0, sizeof fired);
    evaluate(run, s->t, s->y, 0, &points[PRS_POINTS - 1], 1);
    if (points[PRS_POINTS - 1].left_shaft) return PRS_LEFT_SHAFT;
    if (observer) observer->begin(observer->self, &points[PRS_POINTS - 1], closed);
    if (s->t >= end) return PRS_DONE;
    for (i = 0; i < PRS_EVENTS; ++i) armed[i] = is_armed(s, points[PRS_POINTS - 1].event[i], i);
    stop = smallest_of(end, run->signals.next(run->signals.self, s->t));
    if (d->cut_at > s->t + run->resolution) stop = smallest_of(stop, d->cut_at);
    if (d->brake_at > s->t + run->resolution) stop = smallest_of(stop, d->brake_at);
    if (stop - s->t <= run->resolution) { /* Nothing moves by as much in that time. */
      s->t = stop;
      continue;
    }
    if (!stepper->begin(stepper->self, s)) return PRS_FAILED;
    while (!happened && s->t < stop) {
      double from, to, when = stop;
      if (--run->steps_left < 0) return PRS_STEP_LIMIT;
      if (!stepper->step(stepper->self, stop, &from, &to)) return PRS_FAILED;
      points[0] = points[PRS_POINTS - 1];
      points_of(run, stepper, from, to, points, 1);
      for (i = 1; i < PRS_POINTS; ++i)
        if (!(points[i].force + points[i].v + points[i].motor_torque <= HUGE_VAL)) return PRS_FAILED;
      happened = first_event(run, stepper, points, armed, &when);
      if (!happened && vain < 8 && false_start(run, &points[0], &points[PRS_POINTS - 1], armed, fired)) {
        ++vain;
        break;
      }
      if (happened) {
        to = when;
        points_of(run, stepper, from, to, points, 1);
        for (i = 0; i < PRS_EVENTS; ++i) fired[i] = armed[i] && points[PRS_POINTS - 1].event[i] < 0.0;
      } else {
        vain = 0;
      }
      s->t = to;
      stepper->at(stepper->self, to, s->y);
      if (observer) observer->step(observer->self, points);
      for (i = 1; i < PRS_POINTS; ++i)
        if (points[i].left_shaft) return PRS_LEFT_SHAFT;
      /* A touching flank without play begins to carry. */
      if (!happened && s->modes.flank == 0 && can_open(run) && run->play[0] + run->play[1] == 0.0 &&
          s->y[PRS_DELTA] != 0.0) {
        s->modes.flank = s->y[PRS_DELTA] > 0.0 ? 1 : -1;
        happened = 1;
      }
    }
  }
}
