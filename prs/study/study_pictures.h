#pragma once

#include <array>

#include "prs/record/pictures.h"
#include "prs/study/study_result.h"
#include "prs/text.h"

namespace prs {

/// A level as it is written, long numbers with six digits.
std::string level_text(const Level& level, const std::string& unit);

/// A factor as a heading: its label, or its path as it stands.
std::string factor_title(const Factor& factor);

inline constexpr std::size_t kMostStudyFigures = 24;
inline constexpr std::size_t kMostStudyPanels = 12;

constexpr Style kDesignStyle = {Colour::blue, Dash::solid, Mark::circle};
constexpr Style kBaseStyle = points_of(Colour::vermillion, Mark::diamond, Weight::strong);
constexpr const char* kBaseTitle = "as in the file";

/// Whether each design differs from the file in one factor.
inline bool varies_one_at_a_time(const Study& study) {
  return study.plan == Plan::one_at_a_time || (study.plan == Plan::grid && study.factors.size() == 1);
}

/// Indices of the response that the options choose, else of the first numbers, entries of arrays not among them.
/// Throws NoFigure.
std::vector<std::size_t> chosen_responses(const std::vector<std::string>& responses, const FigureOptions& options);

/// A figure for each of these responses for which `make` has data.
template <class Make>
Figures figures_of(const std::vector<std::string>& responses, const FigureOptions& options, Make make) {
  Figures figures;
  for (const std::size_t k : chosen_responses(responses, options))
    if (std::optional<Figure> figure = make(k); figure && has_data(*figure)) figures.push_back(std::move(*figure));
  return figures;
}

/// `03_flank_angle`
std::string study_figure_name(std::size_t index, const std::string& label);

/// Name and title of a figure of a response.
Figure response_figure(const std::vector<std::string>& responses, std::size_t response);

/// Axis over these values of a factor; for words, at 1, 2, ..
Axis factor_axis(const Factor& factor, const std::vector<double>& values);

/// Axis of a response's values.
Axis response_axis(const std::string& path);

/// A factor's name in a list.
std::string factor_name(const Factor& factor);

/// Positions of the levels of a factor, words at 1, 2, ...
std::vector<double> positions(const Factor& factor);

/// At most `most` indices below `count`, evenly distributed, both ends among them.
std::vector<std::size_t> spread(std::size_t count, std::size_t most);

/// Number of panels side by side.
std::size_t columns_for(std::size_t panels);

/// The figure with the panel, whose rows have these names, from above to below; `height`: share of a row in the aspect.
Figure ranked(Figure figure, Panel panel, const std::vector<std::string>& names, double height);

/// Signed bars from above to below, the longest first, with their numbers; titles of those above and below zero.
Figure ranked_bars(Figure figure, const std::vector<std::string>& names, const std::vector<double>& values,
                   const std::array<const char*, 2>& titles = {"grows with the factor", "falls"});

/// Pictures of a study. The result must outlive the list.
Pictures study_pictures(const StudyResult& result);

}  // namespace prs
