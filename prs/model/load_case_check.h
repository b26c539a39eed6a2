#pragma once

#include "prs/model/check_case.h"

namespace prs {

void check_load_cases(const Case& c, Problems& problems);

/// Requirements of `model: {loads: running}`.
void check_loads(const Case& c, Problems& problems);

/// The roller's contacts, from the first at the position, must lie on the nut. `block` states it.
void check_position(std::string_view block, double position, const Mechanism& m, const Structure::Nut& nut,
                    Problems& problems);

/// A section must hold the nut under a load of this sense.
void check_thrust(Direction direction, std::string_view load, const Structure::Nut& nut, Problems& problems);

void check_preload(const Case& c, Problems& problems);

void check_life(const Case& c, Problems& problems);
void check_measures(const Case& c, Problems& problems);

void require_preload(const Case& c, Problems& problems);

/// Requirements of the temperatures of `preload` if the case states `heat`.
void require_warm_preload(const Case& c, Problems& problems);

}  // namespace prs
