#pragma once

#include <string>

#include "prs/study/envelope_result.h"
#include "prs/study/grid_maps.h"
#include "prs/model/study.h"

namespace prs {

/// `envelope.csv`: a row a node of the grid and then one a point that was read off, which is named
/// in `point`; number of the design where it is one, factors and companions, responses, measures
/// divided by what normalises them (`normalised.PATH`) and the `envelope`.
std::string envelope_csv(const Study& study, const GridMaps& maps, const EnvelopeResult& envelope);

}  // namespace prs
