/* The pair of order 5 and 4 of Dormand and Prince with its continuous extension (Hairer, Norsett,
   Wanner, Solving Ordinary Differential Equations I, II.5 and II.6). */
#ifndef PRS_DORMAND_PRINCE_H
#define PRS_DORMAND_PRINCE_H

#include "drive.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
  const PrsRun* run;
  double tolerance;         /* Relative, of a step */
  double scale[PRS_STATES]; /* Sizes from which errors count */
  double t, h, next;        /* The last step and the one to try */
  double y[PRS_STATES], rate[PRS_STATES];
  double form[5][PRS_STATES]; /* Of the continuous extension */
} PrsDormandPrince;

void prs_dormand_prince_start(PrsDormandPrince* method, const PrsRun* run, double tolerance);
PrsStepper prs_dormand_prince_stepper(PrsDormandPrince* method);

#ifdef __cplusplus
}
#endif

#endif
