#pragma once

#include "prs/model/case.h"
#include "prs/model/warning.h"

namespace prs {

/// An input that would move the load distribution, but for overrides that stand in for what it
/// gives: loads, displacements and stiffness do not follow it.
struct VoidInput {
  std::string path;                 ///< `mechanism.flank_angle`, or of one part.
  std::string_view overrides = {};  ///< The keys that make it void.
};

/// What the overrides of a case under `contact` make void. Of the threads the load distribution
/// reads k_0 and psi of each interface, pitch diameters, lead, the screw's starts, numbers of
/// rollers and contacts (docs/load_distribution.md), `refined` also thread heights and Poisson's
/// ratios, Yamamoto's teeth also flank angles, `influence` whole profiles. Flank angles, profiles
/// and their plane, and the centre distance act through k_0 and psi alone where all radii are
/// given; Poisson's ratios through k_0 alone where the roller's beams have no shear. Ellipses,
/// pressures, capacities and slip follow the geometry all the same. Empty without a structure, as
/// nothing is solved then.
std::vector<VoidInput> void_inputs(const Case& c);

/// How each is no longer void.
inline constexpr std::string_view kDeleteOverrides =
    "delete the overrides to compute all from the geometry";

/// The void input that a path names or leads into; null where none does.
const VoidInput* find_void(const std::vector<VoidInput>& inputs, std::string_view path);

/// Warnings of `prs check`: which inputs are void, why, and how they are not.
std::vector<Warning> void_input_warnings(const Case& c);

/// Adds that the load cases are solved one by one, each on the contacts that it closes.
void add_preload_note(const Case& c, std::vector<Warning>& warnings);
/// Adds that the load cases are solved with all parts at the reference temperature.
void add_heat_note(const Case& c, std::vector<Warning>& warnings);

}  // namespace prs
