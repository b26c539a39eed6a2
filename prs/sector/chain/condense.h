#pragma once

#include "prs/sector/chain/chain_sector.h"
#include "prs/sector/sector.h"

namespace prs {

/// The sector's model as a chain. Nodes between contacts and beyond them are eliminated in extended
/// precision, what the roller's ends do in closed form.
ChainSector condense(const Sector& sector);

}  // namespace prs
