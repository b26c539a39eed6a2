#pragma once

#include "prs/model/check_case.h"

namespace prs {

void check_threads(const Mechanism& m, Problems& problems);

/// Whether the threads reach each other and the rollers clear each other.
void check_meshing(const Mechanism& m, Problems& problems);

void check_structure(const Structure& s, const Mechanism& m, Problems& problems);

void check_deviations(const Case& c, Problems& problems);

/// An axial or radial offset of threads must lie within `kMostDeviation`.
void check_offset(const char* path, double offset, const Mechanism& m, Problems& problems);

}  // namespace prs
