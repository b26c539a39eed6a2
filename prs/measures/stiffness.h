#pragma once

#include "prs/model/materials.h"
#include "prs/model/mechanism.h"
#include "prs/model/structure.h"

namespace prs {

/// Axial stiffness of the sections of a mechanism between two threads [N/m], with the sections of
/// the sector model: screw from bore to pitch diameter, nut from pitch diameter to outer diameter
/// between the flanges, N_r rollers of their pitch diameter side by side:
///
///     k_S = E A_S/p (3.2),   k_N = E A_N/p (3.1),   k_R = N_r E A_R/(2 p) (3.3)
///
/// Jung 2017, section 3.1. (3.3) takes two pitches without a reason; the sector model has E A_R/p.
PerPart<double> section_stiffness(const Mechanism& mechanism, const Structure& structure,
                                  const Materials& materials);

/// Axial stiffness of a part's tooth at one contact [N/m]: the width w of thread that a contact
/// loads [m] over Yamamoto's deflection under 1 N/m, see `yamamoto_deflection`. What w is, theory
/// does not say; Hertz's approach on top counts part of the deflection twice.
double tooth_stiffness(const Mechanism& mechanism, const Structure& structure,
                       const Materials& materials, Part part, double width);

/// Coefficient h [m/N^(2/3)] of the axial approach h F^(2/3) of roller and body under the axial
/// load F of a thread, where neither moves radially. With N = F/cos(psi) = k_0 delta^(3/2) and
/// delta = u cos(psi),
///
///     h = 1/(k_0^(2/3) cos(psi)^(5/3))
///
/// `hertz_constant` k_0 [N/m^1.5], `normal_angle` psi between contact normal and axis [rad].
double axial_hertz_coefficient(double hertz_constant, double normal_angle);

/// Secant stiffness F/u [N/m] of `threads` n contacts side by side that share F [N] > 0 equally,
/// each with the axial approach h f^(2/3) + c f under its load f = F/n; `tooth_compliance` c [m/N]:
///
///     k = n/(h f^(-1/3) + c)
///
/// Jung 2017, (3.45), (3.46), for all threads in place of one.
double thread_stiffness(double force, int threads, double coefficient, double tooth_compliance);

}  // namespace prs
