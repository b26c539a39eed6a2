#pragma once

#include "prs/model/case.h"
#include "prs/model/command.h"
#include "prs/model/problems.h"

namespace prs {

/// Problems of values that contradict each other or that no mechanism can have, at most one per path. Each value must
/// lie in its own bounds; the reader of the input checks that.
std::vector<Problem> check_case(const Case& c);

/// Inputs that a command needs and the case lacks: each with the block to add and an example. A study or an
/// optimization needs what the command of its designs needs.
std::vector<Problem> missing(const Case& c, Command command);

/// Signals from files are left out until their points are known.
void check_response(const Case& c, Problems& problems);

inline constexpr std::string_view kMaterialsExample = "{youngs_modulus: 210 GPa, poisson_ratio: 0.3}";

/// An input without effect on loads, displacements and stiffness, because overrides replace what would follow from it.
struct VoidInput {
  std::string path;                 ///< `mechanism.flank_angle`, or of one part.
  std::string_view overrides = {};  ///< Keys of the overrides that make it void.
};

/// Inputs that the overrides under `contact` make void. The load distribution reads k_0 and psi of each interface, and
/// of the threads pitch diameters, lead, the screw's starts, numbers of rollers and contacts
/// (docs/load_distribution.md); `refined` also reads thread heights and Poisson's ratios, Yamamoto's teeth also flank
/// angles, `influence` whole profiles. Flank angles, profiles and their plane, and the centre distance act through k_0
/// and psi alone where all radii are given; Poisson's ratios through k_0 alone where the roller's beams have no shear.
/// Ellipses, pressures, capacities and slip follow the geometry in every case. Empty without a structure, as nothing is
/// solved then.
std::vector<VoidInput> void_inputs(const Case& c);

/// Advice on how to make void inputs effective again.
inline constexpr std::string_view kDeleteOverrides = "delete the overrides to compute all from the geometry";

/// The void input that a path names or leads into; null if there is none.
const VoidInput* find_void(const std::vector<VoidInput>& inputs, std::string_view path);

/// Warnings of `prs check`: which inputs are void, why, and how to make them effective.
std::vector<Warning> void_input_warnings(const Case& c);

/// Adds a warning that the load cases are solved one by one, each on the contacts that it closes.
void add_preload_note(const Case& c, std::vector<Warning>& warnings);
/// Adds a warning that the load cases are solved with all parts at the reference temperature.
void add_heat_note(const Case& c, std::vector<Warning>& warnings);

}  // namespace prs
