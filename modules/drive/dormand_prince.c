#include "dormand_prince.h"

#include <math.h>
#include <string.h>

enum { STAGES = 7 };

static const double kAt[STAGES] = {0.0, 0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0};
static const double kWeight[STAGES][STAGES - 1] = {
    {0.0},
    {0.2},
    {3.0 / 40.0, 9.0 / 40.0},
    {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
    {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
    {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
    {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0}};
static const double kError[STAGES] = {71.0 / 57600.0,      0.0,          -71.0 / 16695.0, 71.0 / 1920.0,
                                      -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0};
static const double kDense[STAGES] = {-12715105075.0 / 11282082432.0,  0.0,
                                      87487479700.0 / 32700410799.0,   -10690763975.0 / 1880347072.0,
                                      701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0,
                                      69997945.0 / 29380423.0};

static double size_of(const PrsDormandPrince* m, const double* value, const double* y) {
  double largest = 0.0;
  int i;
  for (i = 0; i < PRS_STATES; ++i) {
    const double share = fabs(value[i]) / (fabs(y[i]) > m->scale[i] ? fabs(y[i]) : m->scale[i]);
    if (!(share <= largest)) largest = share; /* NaN too */
  }
  return largest;
}

static int begin(void* self, const PrsState* state) {
  PrsDormandPrince* const m = (PrsDormandPrince*)self;
  double rate;
  m->t = state->t;
  memcpy(m->y, state->y, sizeof m->y);
  prs_rates(m->run, m->t, m->y, m->rate);
  rate = size_of(m, m->rate, m->y);
  m->next = rate > 0.0 ? pow(m->tolerance, 0.2) * 0.1 / rate : HUGE_VAL;
  return 1;
}

static int step(void* self, double stop, double* from, double* to) {
  PrsDormandPrince* const m = (PrsDormandPrince*)self;
  double k[STAGES][PRS_STATES], y[PRS_STATES], error[PRS_STATES];
  int i, s, j, tries;
  memcpy(k[0], m->rate, sizeof k[0]);
  for (tries = 0; tries < 100; ++tries) {
    const double rest = stop - m->t;
    double h = m->next < rest ? m->next : rest, share, factor;
    if (m->next < rest && m->next > 0.5 * rest) h = 0.5 * rest;
    if (!(h > 0.0)) return 0;
    for (s = 1; s < STAGES; ++s) {
      for (i = 0; i < PRS_STATES; ++i) {
        double sum = 0.0;
        for (j = 0; j < s; ++j) sum += kWeight[s][j] * k[j][i];
        y[i] = m->y[i] + h * sum;
      }
      prs_rates(m->run, m->t + kAt[s] * h, y, k[s]);
    }
    for (i = 0; i < PRS_STATES; ++i) {
      double sum = 0.0;
      for (s = 0; s < STAGES; ++s) sum += kError[s] * k[s][i];
      error[i] = h * sum;
    }
    share = size_of(m, error, y) / m->tolerance;
    factor = share > 0.0 ? 0.9 * pow(share, -0.2) : 5.0;
    if (!(share <= 1.0)) {
      m->next = h * (factor > 0.2 ? factor : 0.2);
      continue;
    }
    for (i = 0; i < PRS_STATES; ++i) {
      const double change = y[i] - m->y[i], bend = h * k[0][i] - change;
      double sum = 0.0;
      for (s = 0; s < STAGES; ++s) sum += kDense[s] * k[s][i];
      m->form[0][i] = m->y[i];
      m->form[1][i] = change;
      m->form[2][i] = bend;
      m->form[3][i] = change - h * k[STAGES - 1][i] - bend;
      m->form[4][i] = h * sum;
    }
    *from = m->t;
    *to = h == rest ? stop : m->t + h;
    m->h = *to - *from;
    m->t = *to;
    memcpy(m->y, y, sizeof y);
    memcpy(m->rate, k[STAGES - 1], sizeof m->rate);
    m->next = h * (factor < 5.0 ? factor : 5.0);
    return 1;
  }
  return 0;
}

static void at(void* self, double t, double* y) {
  const PrsDormandPrince* const m = (const PrsDormandPrince*)self;
  const double s = (t - (m->t - m->h)) / m->h, r = 1.0 - s;
  int i;
  for (i = 0; i < PRS_STATES; ++i)
    y[i] = t == m->t
               ? m->y[i]
               : m->form[0][i] + s * (m->form[1][i] + r * (m->form[2][i] + s * (m->form[3][i] + r * m->form[4][i])));
}

void prs_dormand_prince_start(PrsDormandPrince* m, const PrsRun* run, double tolerance) {
  memset(m, 0, sizeof *m);
  m->run = run;
  m->tolerance = tolerance;
  prs_scales(run, m->scale);
}

PrsStepper prs_dormand_prince_stepper(PrsDormandPrince* m) {
  PrsStepper stepper;
  stepper.self = m;
  stepper.begin = begin;
  stepper.step = step;
  stepper.at = at;
  return stepper;
}
