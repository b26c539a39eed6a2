/* Force and torque of a roller screw from tables. SI units; deflection and force > 0 in tension. */
#ifndef PRS_CURVES_H
#define PRS_CURVES_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One sense of the load. Between nodes the force is the cubic with their values and slopes, and
   monotone. Flanks that only begin to touch have force ~ way^1.5 (Hertz), which is a cubic of the
   root of the way: the stiffness is good from the first contact on. */
typedef struct {
  double origin; /* |deflection| at which the force begins [m] */
  int root;      /* The nodes stand over the root of the way beyond the origin, else over the way. */
  size_t count;
  const double* at;    /* Of the nodes, ascending from 0 [m^0.5] or [m] */
  const double* force; /* Magnitude [N] */
  const double* slope; /* d force / d at */
} PrsBranch;

typedef struct {
  double lead; /* > 0 right-handed [m] */
  PrsBranch tension, compression;
  /* Torque that friction takes, by force and speed; without friction `forces` is 0. */
  size_t forces, speeds;
  const double* root_force; /* Signed root of the force [N^0.5], ascending. */
  const double* speed;      /* Magnitude [rad/s], ascending, > 0. */
  const double* forward;    /* [speeds][forces], turning forwards [N m] */
  const double* backward;   /* The same, turning backwards. */
} PrsCurves;

/* Points into `data`, the content of the file `curves.bin`; 0 where that is no such content. */
int prs_read_curves(const double* data, size_t count, PrsCurves* curves);

/* Force [N] under a deflection [m], its tangent stiffness [N/m], and whether the deflection lies
   beyond the last node, where the force goes on in a straight line. */
double prs_force(const PrsCurves* curves, double deflection, double* stiffness, int* beyond);

/* Torque of the drive on the screw [N m]: force x lead / (2 pi) and what friction takes. Below the
   smallest speed of the table the latter goes in a straight line from one sense of rotation to the
   other. Beyond the table it grows with the force, and has the value of the largest speed. */
double prs_torque(const PrsCurves* curves, double force, double speed, int* beyond);

#ifdef __cplusplus
}
#endif

#endif
