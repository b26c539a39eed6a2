#pragma once

#include "prs/model/case.h"
#include "prs/model/command.h"
#include "prs/model/problems.h"

// Checks of the blocks of a case, each in the file of its block. `check_case` calls them in order.

namespace prs {

void check_threads(const Mechanism& m, Problems& problems);
/// Whether the threads reach each other and the rollers clear each other.
void check_meshing(const Mechanism& m, Problems& problems);

void check_structure(const Structure& s, const Mechanism& m, Problems& problems);

/// Checks of inputs that only some models of the bodies know.
void check_bodies(const Case& c, Problems& problems);
/// The bodies of `refined` and `influence` have teeth of half a pitch.
void check_thickness(const Case& c, Problems& problems);

/// Checks of inputs that only a full mechanism knows, and of those that it does not know yet.
void check_full_mechanism(const Case& c, Problems& problems);

void check_load_cases(const Case& c, Problems& problems);
/// What `model: {loads: running}` needs of the case.
void check_loads(const Case& c, Problems& problems);
/// The roller's contacts, from the first at the position, must lie on the nut. `block` states it.
void check_position(std::string_view block, double position, const Mechanism& m,
                    const Structure::Nut& nut, Problems& problems);
/// A section must hold the nut under a load of this sense.
void check_thrust(Direction direction, std::string_view load, const Structure::Nut& nut,
                  Problems& problems);

void check_deviations(const Case& c, Problems& problems);
/// An axial or radial offset of threads must lie within `kMostDeviation`.
void check_offset(const char* path, double offset, const Mechanism& m, Problems& problems);

/// The viscosity as it stands, or as it follows from the temperature: that of the file, or any
/// with `heat`.
void check_lubricant(const Lubricant& l, const std::optional<Heat>& heat, Problems& problems);
void check_carrier(const Carrier& carrier, Problems& problems);

void check_preload(const Case& c, Problems& problems);
void check_life(const Case& c, Problems& problems);
void check_heat(const Case& c, Problems& problems);
void check_measures(const MeasureOptions& m, Problems& problems);

// What `slip` needs of the blocks that it reads.

void require_preload(const Case& c, Problems& problems);
/// What the temperatures of `preload` need where the case states `heat`.
void require_warm_preload(const Case& c, Problems& problems);
/// Of the law of friction and the bearings of the roller heads.
void require_friction(const Conditions& c, Problems& problems);
void require_slip(const Conditions& c, Problems& problems);
/// What `slip` needs where the case states `heat`.
void require_heat(const Case& c, Problems& problems);
void require_expansion(const Case& c, Problems& problems);

inline constexpr std::string_view kMaterialsExample =
    "{youngs_modulus: 210 GPa, poisson_ratio: 0.3}";

}  // namespace prs
