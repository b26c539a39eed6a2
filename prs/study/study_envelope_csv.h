#pragma once

#include <string>

#include "prs/model/study.h"
#include "prs/record/csv_style.h"
#include "prs/study/envelope_result.h"
#include "prs/study/grid_maps.h"

namespace prs {

/// `envelope.csv`: one row per node of the grid and then one per point that was read off, which is
/// named in `point`; number of the design where it is one, factors and companions, responses,
/// measures divided by what normalises them (`normalised.PATH`) and the `envelope`.
std::string envelope_csv(const Study& study, const GridMaps& maps, const EnvelopeResult& envelope,
                         const CsvStyle& style = {});

}  // namespace prs
