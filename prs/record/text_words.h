#pragma once

#include <string>
#include <string_view>

namespace prs {

/// A text of documents as tables show it: `flank's edge` of `flank_edge`, `iteration limit` of
/// `iteration_limit`.
std::string words_of_text(std::string_view text);

}  // namespace prs
