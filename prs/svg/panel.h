#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "prs/svg/frame.h"
#include "prs/svg/text_width.h"

namespace prs {

/// The ticks of an axis with their texts, as many as there is room for.
std::vector<Tick> shown_ticks(const Axis& axis, int pixels, bool is_horizontal);

/// A text on paper of its own, of which a share lies left of x; as near to the place as it stands
/// within the box and covers no other.
std::string placed_text(std::string_view content, double x, double baseline, double share,
                        const Box& box, std::vector<TextBox>& taken);

/// A panel in its place, with its axes. `id` is unique in the document. Needs a figure with ranges.
std::string panel_svg(const Figure& figure, const Layout& layout, std::size_t index,
                      const std::string& id);

/// The scale of the colours, with its numbers and label below the box.
std::string colour_bar_svg(const ColourScale& scale, const Box& box);

}  // namespace prs
