/* The method of order 8 of Dormand and Prince with error estimates of order 5 and 3 and its
   continuous extension of order 7 (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I,
   II.5 and II.6, DOP853). */
#ifndef PRS_DORMAND_PRINCE_H
#define PRS_DORMAND_PRINCE_H

#include "drive.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { PRS_STAGES = 16, PRS_FORMS = 7 };

typedef struct {
  const PrsRun* run;
  double tolerance;         /* Relative, of a step */
  double scale[PRS_STATES]; /* Sizes from which errors count */
  double largest;           /* Of a step: a quarter of the fastest vibration */
  double t, h, next;        /* The last step and the one to try */
  double before[PRS_STATES], y[PRS_STATES], rate[PRS_STATES];
  double stage[PRS_STAGES][PRS_STATES];
  double form[PRS_FORMS][PRS_STATES]; /* Of the continuous extension */
  int is_dense;
} PrsDormandPrince;

void prs_dormand_prince_start(PrsDormandPrince* method, const PrsRun* run, double tolerance);
PrsStepper prs_dormand_prince_stepper(PrsDormandPrince* method);

#ifdef __cplusplus
}
#endif

#endif
