#include "dormand_prince.h"

#include <math.h>
#include <string.h>

enum { STAGES = PRS_STAGES, ORDER = 12 }; /* Of all, and of them those that a step takes */

static const double kAt[STAGES] = {0.0,
                                   0.05260015195876773,
                                   0.0789002279381516,
                                   0.1183503419072274,
                                   0.2816496580927726,
                                   0.3333333333333333,
                                   0.25,
                                   0.3076923076923077,
                                   0.6512820512820513,
                                   0.6,
                                   0.8571428571428571,
                                   1.0,
                                   1.0,
                                   0.1,
                                   0.2,
                                   0.7777777777777778};
/* Row 12 holds the weights of the step itself. */
static const double kWeight[STAGES][STAGES - 1] = {
    {0.0},
    {0.05260015195876773},
    {0.0197250569845379, 0.0591751709536137},
    {0.02958758547680685, 0.0, 0.08876275643042054},
    {0.2413651341592667, 0.0, -0.8845494793282861, 0.924834003261792},
    {0.037037037037037035, 0.0, 0.0, 0.17082860872947386, 0.12546768756682242},
    {0.037109375, 0.0, 0.0, 0.17025221101954405, 0.06021653898045596, -0.017578125},
    {0.03709200011850479, 0.0, 0.0, 0.17038392571223998, 0.10726203044637328, -0.015319437748624402,
     0.008273789163814023},
    {0.6241109587160757, 0.0, 0.0, -3.3608926294469414, -0.868219346841726, 27.59209969944671, 20.154067550477894,
     -43.48988418106996},
    {0.47766253643826434, 0.0, 0.0, -2.4881146199716677, -0.590290826836843, 21.230051448181193, 15.279233632882423,
     -33.28821096898486, -0.020331201708508627},
    {-0.9371424300859873, 0.0, 0.0, 5.186372428844064, 1.0914373489967295, -8.149787010746927, -18.52006565999696,
     22.739487099350505, 2.4936055526796523, -3.0467644718982196},
    {2.273310147516538, 0.0, 0.0, -10.53449546673725, -2.0008720582248625, -17.9589318631188, 27.94888452941996,
     -2.8589982771350235, -8.87285693353063, 12.360567175794303, 0.6433927460157636},
    {0.054293734116568765, 0.0, 0.0, 0.0, 0.0, 4.450312892752409, 1.8915178993145003, -5.801203960010585,
     0.3111643669578199, -0.1521609496625161, 0.20136540080403034, 0.04471061572777259},
    {0.056167502283047954, 0.0, 0.0, 0.0, 0.0, 0.0, 0.25350021021662483, -0.2462390374708025, -0.12419142326381637,
     0.15329179827876568, 0.00820105229563469, 0.007567897660545699, -0.008298},
    {0.03183464816350214, 0.0, 0.0, 0.0, 0.0, 0.028300909672366776, 0.053541988307438566, -0.05492374857139099, 0.0,
     0.0, -0.00010834732869724932, 0.0003825710908356584, -0.00034046500868740456, 0.1413124436746325},
    {-0.42889630158379194, 0.0, 0.0, 0.0, 0.0, -4.697621415361164, 7.683421196062599, 4.06898981839711,
     0.3567271874552811, 0.0, 0.0, 0.0, -0.0013990241651590145, 2.9475147891527724, -9.15095847217987}};
static const double kError5[ORDER + 1] = {0.01312004499419488,
                                          0.0,
                                          0.0,
                                          0.0,
                                          0.0,
                                          -1.2251564463762044,
                                          -0.4957589496572502,
                                          1.6643771824549864,
                                          -0.35032884874997366,
                                          0.3341791187130175,
                                          0.08192320648511571,
                                          -0.022355307863886294};
static const double kError3[ORDER + 1] = {-0.18980075407240762,
                                          0.0,
                                          0.0,
                                          0.0,
                                          0.0,
                                          4.450312892752409,
                                          1.8915178993145003,
                                          -5.801203960010585,
                                          -0.4226823213237919,
                                          -0.1521609496625161,
                                          0.20136540080403034,
                                          0.02265179219836082};
static const double kDense[4][STAGES] = {
    {-8.428938276109013, 0.0, 0.0, 0.0, 0.0, 0.5667149535193777, -3.0689499459498917, 2.38466765651207,
     2.117034582445028, -0.871391583777973, 2.2404374302607883, 0.6315787787694688, -0.08899033645133331,
     18.148505520854727, -9.194632392478356, -4.436036387594894},
    {10.427508642579134, 0.0, 0.0, 0.0, 0.0, 242.28349177525817, 165.20045171727028, -374.5467547226902,
     -22.113666853125306, 7.733432668472264, -30.674084731089398, -9.332130526430229, 15.697238121770845,
     -31.139403219565178, -9.35292435884448, 35.81684148639408},
    {19.985053242002433, 0.0, 0.0, 0.0, 0.0, -387.0373087493518, -189.17813819516758, 527.8081592054236,
     -11.57390253995963, 6.8812326946963, -1.0006050966910838, 0.7777137798053443, -2.778205752353508,
     -60.19669523126412, 84.32040550667716, 11.99229113618279},
    {-25.69393346270375, 0.0, 0.0, 0.0, 0.0, -154.18974869023643, -231.5293791760455, 357.6391179106141,
     93.40532418362432, -37.45832313645163, 104.0996495089623, 29.8402934266605, -43.53345659001114, 96.32455395918828,
     -39.17726167561544, -149.72683625798564}};

/* y + h times a sum of the first `count` stages. */
static void sum_of(const double* y, double h, const double* weight, double (*k)[PRS_STATES], int count,
                   double* result) {
  double sum[PRS_STATES] = {0.0};
  int i, j;
  for (j = 0; j < count; ++j)
    if (weight[j] != 0.0)
      for (i = 0; i < PRS_STATES; ++i) sum[i] += weight[j] * k[j][i];
  for (i = 0; i < PRS_STATES; ++i) result[i] = (y ? y[i] : 0.0) + h * sum[i];
}

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
  m->next = rate > 0.0 ? pow(m->tolerance, 0.125) * 0.3 / rate : HUGE_VAL;
  return 1;
}

static int step(void* self, double stop, double* from, double* to) {
  PrsDormandPrince* const m = (PrsDormandPrince*)self;
  double y[PRS_STATES], error[PRS_STATES];
  int s, tries;
  memcpy(m->stage[0], m->rate, sizeof m->rate);
  for (tries = 0; tries < 100; ++tries) {
    const double rest = stop - m->t, most = m->next < m->largest ? m->next : m->largest;
    double h = most < rest ? most : rest, fifth, third, share, factor;
    if (most < rest && most > 0.5 * rest) h = 0.5 * rest;
    if (!(h > 0.0)) return 0;
    for (s = 1; s <= ORDER; ++s) {
      sum_of(m->y, h, kWeight[s], m->stage, s, y);
      prs_rates(m->run, m->t + kAt[s] * h, y, m->stage[s]);
    }
    sum_of(NULL, h, kError5, m->stage, ORDER + 1, error);
    fifth = size_of(m, error, y);
    sum_of(NULL, h, kError3, m->stage, ORDER + 1, error);
    third = size_of(m, error, y);
    share = fifth > 0.0 ? fifth * fifth / sqrt(fifth * fifth + 0.01 * third * third) / m->tolerance : 0.0;
    if (fifth != fifth) share = fifth;
    factor = share > 0.0 ? 0.9 * pow(share, -0.125) : 6.0;
    if (!(share <= 1.0)) {
      m->next = h * (factor > 0.2 ? factor : 0.2);
      continue;
    }
    memcpy(m->before, m->y, sizeof y);
    memcpy(m->y, y, sizeof y);
    memcpy(m->rate, m->stage[ORDER], sizeof m->rate);
    *from = m->t;
    *to = h == rest ? stop : m->t + h;
    m->h = *to - *from;
    m->t = *to;
    m->next = h * (factor < 6.0 ? factor : 6.0);
    m->is_dense = 0;
    return 1;
  }
  return 0;
}

/* Three more stages, and the form of order 7 through all. */
static void make_dense(PrsDormandPrince* m) {
  const double start = m->t - m->h;
  double y[PRS_STATES];
  int i, s;
  for (s = ORDER + 1; s < STAGES; ++s) {
    sum_of(m->before, m->h, kWeight[s], m->stage, s, y);
    prs_rates(m->run, start + kAt[s] * m->h, y, m->stage[s]);
  }
  for (i = 0; i < PRS_STATES; ++i) {
    const double change = m->y[i] - m->before[i];
    m->form[0][i] = change;
    m->form[1][i] = m->h * m->stage[0][i] - change;
    m->form[2][i] = 2.0 * change - m->h * (m->stage[ORDER][i] + m->stage[0][i]);
  }
  for (s = 0; s < 4; ++s) sum_of(NULL, m->h, kDense[s], m->stage, STAGES, m->form[3 + s]);
  m->is_dense = 1;
}

static void at(void* self, double t, double* y) {
  PrsDormandPrince* const m = (PrsDormandPrince*)self;
  const double s = (t - (m->t - m->h)) / m->h, r = 1.0 - s;
  int i, k;
  if (t == m->t) {
    memcpy(y, m->y, sizeof m->y);
    return;
  }
  if (!m->is_dense) make_dense(m);
  for (i = 0; i < PRS_STATES; ++i) {
    double value = 0.0;
    for (k = PRS_FORMS - 1; k >= 0; --k) value = (value + m->form[k][i]) * (k % 2 == 0 ? s : r);
    y[i] = m->before[i] + value;
  }
}

void prs_dormand_prince_start(PrsDormandPrince* m, const PrsRun* run, double tolerance) {
  memset(m, 0, sizeof *m);
  m->run = run;
  m->tolerance = tolerance;
  m->largest = 1.5 / prs_fastest(run);
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
