#pragma once

#include <string>
#include <vector>

#include "prs/quantities/case_groups.h"
#include "prs/figures/figure.h"

namespace prs {

/// One a configuration. Told apart by marker, by lightness in grey print and by hue with any colour
/// vision: the first three are P. Tol's "high contrast" scheme. Later lines are thinner, so that
/// those below them show where they coincide.
inline constexpr LineStyle kConfigurationStyles[] = {
    {"#004488", 1, 7, 2.6}, {"#bb5566", 1, 5, 2.0},  {"#ddaa33", 1, 9, 1.4},
    {"#000000", 1, 6, 1.4}, {"#44aa99", 1, 13, 1.4}, {"#aa4499", 1, 11, 1.4},
    {"#88ccee", 1, 4, 1.4}, {"#777777", 1, 8, 1.4},
};

/// Characters of a load case's name in a title; longer names are cut.
inline constexpr std::size_t kMaxCaseName = 30;

/// `Screw–roller` or `Nut–roller`.
std::string interface_title(Interface i);

/// Appends a style to the figure and names it in the legend; returns its index.
std::size_t add_to_legend(Figure& figure, std::string title, const LineStyle& style);

/// A dashed line behind the others in every panel, where all threads would share the load equally.
void add_mean(Figure& figure, std::size_t threads);

/// Drops the configurations beyond the first `count` and says so in the title.
void keep_first(std::vector<LoadedConfiguration>& configurations, std::size_t count,
                std::string& title);

}  // namespace prs
