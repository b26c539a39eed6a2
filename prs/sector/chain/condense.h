#pragma once

#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/sector_model.h"

namespace prs {

/// The sector's numbers as a chain. Nodes of shells between contacts and beyond them are eliminated
/// in extended precision, all else in closed form.
ChainSector condense(const SectorModel& model);

}  // namespace prs
