#pragma once

#include <map>
#include <string>
#include <vector>

#include "prs/input/echo.h"
#include "prs/input/source.h"

namespace prs::input {

/// Why each assumed value was assumed, by its path. A comment behind a value, or on the lines above
/// its key, marks it:
///
///     flank_angle: 45 deg                 # assumed 45 deg: as on nearly all screws
///     # assumed {roller: 1}: as in makers' catalogues
///     starts: {screw: 5, roller: 1}
///
/// What stands between `assumed` and the colon is the value as it was assumed; a map may name some
/// of the keys, a list the first items. A value that differs from it by now was changed and is none
/// any more, nor is one that `--set` gives. `assumed: REASON` marks whatever stands there.
std::map<std::string, std::string> assumptions(const std::vector<EchoEntry>& entries,
                                               const Source& source);

}  // namespace prs::input
