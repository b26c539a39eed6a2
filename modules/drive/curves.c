#include "curves.h"

#include <math.h>

#define FORMAT 1.0
#define TURN 6.283185307179586476925287

/* Takes numbers off a list; nothing more once it was too short. */
typedef struct {
  const double* next;
  size_t left;
  int ok;
} List;

static const double* take(List* list, size_t count) {
  const double* const values = list->next;
  if (count > list->left) {
    list->ok = 0;
    return values;
  }
  list->next += count;
  list->left -= count;
  return values;
}

static double take_number(List* list) {
  const double* const value = take(list, 1);
  return list->ok ? *value : 0.0;
}

static size_t take_count(List* list) {
  const double value = take_number(list);
  if (!(value >= 0.0 && value <= 1e6)) {
    list->ok = 0;
    return 0;
  }
  return (size_t)value;
}

static void take_branch(List* list, PrsBranch* branch) {
  branch->origin = take_number(list);
  branch->root = take_number(list) != 0.0;
  branch->count = take_count(list);
  branch->at = take(list, branch->count);
  branch->force = take(list, branch->count);
  branch->slope = take(list, branch->count);
  if (branch->count < 2) list->ok = 0;
}

int prs_read_curves(const double* data, size_t count, PrsCurves* curves) {
  List list;
  list.next = data;
  list.left = count;
  list.ok = 1;
  if (take_number(&list) != FORMAT) return 0;
  curves->lead = take_number(&list);
  take_branch(&list, &curves->tension);
  take_branch(&list, &curves->compression);
  curves->forces = take_count(&list);
  curves->speeds = take_count(&list);
  curves->root_force = take(&list, curves->forces);
  curves->speed = take(&list, curves->speeds);
  curves->forward = take(&list, curves->forces * curves->speeds);
  curves->backward = take(&list, curves->forces * curves->speeds);
  if (curves->forces == 1 || (curves->forces > 0 && curves->speeds == 0)) return 0;
  return list.ok && list.left == 0;
}

/* Index k of the interval from at[k] to at[k + 1] that holds x; the first or last one beyond. */
static size_t interval_of(const double* at, size_t count, double x) {
  size_t low = 0, high = count - 1;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (x < at[middle])
      high = middle;
    else
      low = middle;
  }
  return low;
}

/* The cubic with these values and slopes at both ends of an interval of width h, at the share t of
   it; its slope. */
static double hermite(double h, double t, double y0, double d0, double y1, double d1, double* slope) {
  const double secant = (y1 - y0) / h;
  const double c2 = 3.0 * secant - 2.0 * d0 - d1;
  const double c3 = d0 + d1 - 2.0 * secant;
  *slope = d0 + t * (2.0 * c2 + t * 3.0 * c3);
  return y0 + h * t * (d0 + t * (c2 + t * c3));
}

/* Of one sense: magnitude of the force at |deflection|. */
static double branch_force(const PrsBranch* branch, double deflection, double* stiffness, int* beyond) {
  const size_t last = branch->count - 1;
  const double way = deflection - branch->origin;
  const double end = branch->root ? branch->at[last] * branch->at[last] : branch->at[last];
  double x, force, slope;
  size_t k;
  if (branch->root && !(way > 0.0)) {
    *stiffness = 0.0;
    return way == way ? 0.0 : way;
  }
  if (way > end) {
    *stiffness = branch->root ? branch->slope[last] / (2.0 * branch->at[last]) : branch->slope[last];
    *beyond = way > end * (1.0 + 1e-9); /* A node itself may lie there by rounding. */
    return branch->force[last] + *stiffness * (way - end);
  }
  x = branch->root ? sqrt(way) : way;
  k = interval_of(branch->at, branch->count, x);
  force = hermite(branch->at[k + 1] - branch->at[k], (x - branch->at[k]) / (branch->at[k + 1] - branch->at[k]),
                  branch->force[k], branch->slope[k], branch->force[k + 1], branch->slope[k + 1], &slope);
  *stiffness = branch->root ? slope / (2.0 * x) : slope;
  return force;
}

double prs_force(const PrsCurves* curves, double deflection, double* stiffness, int* beyond) {
  *beyond = 0;
  if (deflection < 0.0) return -branch_force(&curves->compression, -deflection, stiffness, beyond);
  return branch_force(&curves->tension, deflection, stiffness, beyond);
}

/* Slope at node k so that the curve through the nodes stays monotone between them (Fritsch and
   Butland, SIAM J. Sci. Stat. Comput. 5, 1984, 300). */
static double node_slope(size_t count, const double* x, const double* y, size_t k) {
  double before, after, h0, h1, w;
  if (count == 2) return (y[1] - y[0]) / (x[1] - x[0]);
  if (k == 0 || k == count - 1) { /* The parabola through the last three nodes, kept monotone. */
    const size_t i = k == 0 ? 0 : count - 2, j = k == 0 ? 1 : count - 3;
    const double near = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    const double far = (y[j + 1] - y[j]) / (x[j + 1] - x[j]);
    const double width = x[i + 1] - x[i];
    const double slope = near + (near - far) * width / (width + x[j + 1] - x[j]);
    if (slope * near <= 0.0) return 0.0;
    return near * far <= 0.0 && fabs(slope) > 3.0 * fabs(near) ? 3.0 * near : slope;
  }
  h0 = x[k] - x[k - 1];
  h1 = x[k + 1] - x[k];
  before = (y[k] - y[k - 1]) / h0;
  after = (y[k + 1] - y[k]) / h1;
  if (before * after <= 0.0) return 0.0;
  w = (h0 + 2.0 * h1) / (3.0 * (h0 + h1));
  return before * after / (w * after + (1.0 - w) * before);
}

/* The monotone curve through nodes; beyond them the value of the last one. */
static double between(size_t count, const double* x, const double* y, double at) {
  size_t k;
  double h, slope;
  if (count == 1 || at <= x[0]) return y[0];
  if (at >= x[count - 1]) return y[count - 1];
  k = interval_of(x, count, at);
  h = x[k + 1] - x[k];
  return hermite(h, (at - x[k]) / h, y[k], node_slope(count, x, y, k), y[k + 1], node_slope(count, x, y, k + 1),
                 &slope);
}

/* Speeds stand at equal ratios: over their fourth roots they are spread evenly enough. */
static double spread(double speed) { return sqrt(sqrt(speed)); }

/* Friction while turning in one sense, over the four speeds around this one. */
static double friction_at(const PrsCurves* c, const double* table, double root_force, double speed) {
  double x[4], y[4];
  size_t first = 0, count = c->speeds, k;
  if (count > 4) {
    k = interval_of(c->speed, count, speed);
    first = k == 0 ? 0 : k - 1;
    if (first > count - 4) first = count - 4;
    count = 4;
  }
  for (k = 0; k < count; ++k) {
    x[k] = spread(c->speed[first + k]);
    y[k] = between(c->forces, c->root_force, table + (first + k) * c->forces, root_force);
  }
  return between(count, x, y, spread(speed));
}

double prs_torque(const PrsCurves* c, double force, double speed, int* beyond) {
  const double plain = force * c->lead / TURN;
  double root, least, most, slowest, magnitude, factor = 1.0, friction;
  *beyond = 0;
  if (c->forces == 0) return plain;
  root = force < 0.0 ? -sqrt(-force) : sqrt(force);
  least = c->root_force[0];
  most = c->root_force[c->forces - 1];
  if (root > most || root < least) {
    const double end = root > most ? most : least;
    factor = force / (end * fabs(end));
    root = end;
    *beyond = 1;
  }
  slowest = c->speed[0];
  magnitude = fabs(speed);
  if (magnitude > c->speed[c->speeds - 1]) *beyond = 1;
  if (magnitude < slowest) {
    const double forward = friction_at(c, c->forward, root, slowest);
    const double backward = friction_at(c, c->backward, root, slowest);
    friction = backward + (forward - backward) * (0.5 + 0.5 * speed / slowest);
  } else {
    friction = friction_at(c, speed < 0.0 ? c->backward : c->forward, root, magnitude);
  }
  return plain + factor * friction;
}
