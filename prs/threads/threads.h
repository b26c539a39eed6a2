#pragma once

#include "prs/model/deviations.h"
#include "prs/model/load_case.h"

namespace prs {

/// The mechanism with all pitch diameters and the centre distance: as stated with `geometry: simulation`, designed for
/// the backlash with `geometry: design` (Sandu 2018, table 1.3). Throws CaseError if no mechanism has that backlash.
Mechanism resolved(const Mechanism& mechanism);

/// Axial widths of a truncated thread [m]: a crest of zero width is sharp, neighbouring threads whose roots are wider
/// than the pitch overlap. Both may lie beyond those limits; absent if the profile ends before.
struct ThreadWidths {
  std::optional<double> crest;  ///< c
  std::optional<double> root;   ///< a
};

/// Widths w(r) = p - 2 f(r) of the material between two flanks z = +-f(r) of a groove, 2 f(r) of a
/// nut (whose f is that of its air), at the two ends of `mechanism.thread`. For straight flanks of
/// an axial profile w = h +- 2 (r - r_T) tan(alpha), which is Yao 2023, (52) and (54), for a
/// roller's arc about its axis (53); any other arc and the normal plane generalise them. In the
/// second line of (52) the signs are wrong: it lets the crest of the screw grow with its height;
/// right is c_S = h_S - (d_S1 - d_S0) tan(beta_S). Yao asks for c > 0 and a < p (51). Nothing where
/// the thread's heights are not given.
std::optional<ThreadWidths> thread_widths(const contact::Thread& thread);

/// Axial distance of a roller's threads from those of one body [m], with each thread in the middle of the other's
/// groove; negative if they overlap. Twice the distance is the axial play.
struct ThreadClearance {
  /// Clearance of the flanks at the contact point, epsilon_SRc, epsilon_NRc (55): half the
  /// backlash.
  double flank = 0.0;
  /// Distance from the edge of the body's crest to the roller's flank, epsilon_ST, epsilon_NT (57).
  std::optional<double> body_crest;
  /// Distance from the edge of the roller's crest to the body's flank, epsilon_RST, epsilon_RNT (58).
  std::optional<double> roller_crest;
};

/// The clearances of Yao 2023, section 3.3, with phi(r) the half groove of the material at r, w the
/// width of a crest, c the centre distance, upper signs for a screw, lower ones for a nut:
///
///     flank = phi_B(r_B) + phi_R(r_R) + rise of both helices - p/2,  at the contact point     (55)
///     body crest   = phi_R(+-(c - r_crest,B)) - w_B/2                                         (57)
///     roller crest = phi_B(c -+ r_crest,R) - w_R/2                                            (58)
///
/// (55) is taken at the exact contact point, where the clearance of the flanks is least (erratum:
/// the nut's second term is -alpha_Nc l_N/(2 pi)). Crests are compared on the line of centres, as
/// Yao does. Where the helix angles of the two parts differ, as at Yao's screw, the contact lies
/// off that line, and there the edge of a crest comes nearer to the flank: 0.123 mm in place of
/// 0.359 mm in his initial design, yet never as near as a contact point inside both flanks. Yao has
/// phi for straight bodies and a roller's arc about its axis in the axial plane, at the radii
/// d_R0/2 -+ h_a (59), which supposes c = r_S + r_R = r_N - r_R; any profile, plane and centre
/// distance generalise that. A crest is absent if the other part's profile has ended. Yao asks
/// for flank > 0 (56) and for crests farther away than flanks (60).
///
/// Nothing if the heights of one of the two threads are not given, pitches differ (then the
/// parts have no middle) or the contact point is not `ok`.
std::optional<ThreadClearance> thread_clearance(const contact::MechanismGeometry& threads, Interface interface,
                                                const contact::ContactPoint& point);

/// Offsets of a part's threads from their nominal place, one per contact [m].
struct ThreadOffsets {
  std::vector<double> axial;   ///< a_k, positive away from the loaded end of the screw.
  std::vector<double> radial;  ///< rho_k, offset of the pitch radius.
};

/// Offsets of which `initial_gaps` is made: measured pitch, pitch error, expansion, diameter, crowning, relief.
ThreadOffsets thread_offsets(const Mechanism& mechanism, const Deviations& deviations, const Materials& materials,
                             Part part);

/// Gaps of an interface, before the smallest is subtracted [m].
std::vector<double> gaps_between(const ThreadOffsets& body, const ThreadOffsets& roller, Interface i,
                                 double normal_angle, Direction direction);

/// Whether any deviation moves a thread of one sector from its nominal place; else all gaps are 0.
bool deviates(const Mechanism& mechanism, const Deviations& deviations);

/// Initial gaps of the threads along their contact normals for one direction of the load, the
/// closest thread of each interface touching [m]. With axial offsets a_k of the threads (measured
/// pitch, pitch error, expansion), away from the loaded end, and radial offsets rho_k of their
/// pitch radii (diameter, crowning, relief, expansion):
///
///     screw  g = -s cos(psi)(a_S - a_R) - sin(psi)(rho_S + rho_R),
///     nut    g = -s cos(psi)(a_R - a_N) - sin(psi)(rho_R - rho_N),
///
/// s = -1 in tension, +1 in compression, less the smallest of each interface, which a rigid motion
/// takes up. Materials must state their expansion where a temperature differs.
PerInterface<std::vector<double>> initial_gaps(const Mechanism& mechanism, const Deviations& deviations,
                                               const Materials& materials, const PerInterface<double>& normal_angle,
                                               Direction direction);

}  // namespace prs
