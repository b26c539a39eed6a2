#pragma once

#include "prs/run/commands.h"

namespace prs {

/// All analyses and searches of a case, in the order in which they are shown.
std::span<const AnyAnalysis> analyses();

/// Files other than a case.
std::span<const OtherFile> other_files();
std::span<const DocumentForm> document_forms();

/// Part that a case requests and this program omits (PRS_FULL): `model.bodies: influence`; empty in a complete program.
std::string_view left_out(const Case& c);

}  // namespace prs
