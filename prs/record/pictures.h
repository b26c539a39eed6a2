#pragma once

#include <functional>
#include <iterator>
#include <stdexcept>

#include "prs/json_type.h"
#include "prs/model/part.h"
#include "prs/record/figure.h"

namespace prs {

using Figures = std::vector<Figure>;

/// Choice among several pictures of a kind, and of its content.
struct FigureOptions {
  std::vector<std::size_t> load_cases = {};  ///< Load cases by index; empty: all.
  std::optional<std::size_t> load_case = {};
  std::optional<Interface> interface = {};
  std::optional<std::string> response = {};  ///< Path of the response; absent: one figure for each.
  std::optional<std::string> x = {};         ///< Paths of factors.
  std::optional<std::string> y = {};
  std::optional<std::size_t> thread = {};  ///< Thread of all rollers, from 0; absent: the most loaded.
  std::optional<std::size_t> panel = {};   ///< Index of the only panel to show.
  bool one_panel = false;                  ///< Whether to show all in one panel, as far as possible.
};

/// Error: there is no such picture, or the result has no data for it.
class NoFigure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A picture of a result.
struct Picture {
  std::string_view name;
  std::string_view needs;  ///< Data that the result must have, in words.
  std::function<Figures(const FigureOptions&)> make;
  /// Occasion on which a command writes the picture.
  enum class Drawn { always, with_all, by_name } drawn = Drawn::always;
};
using Pictures = std::vector<Picture>;

/// Figures in the units of tables, kN from 1000 N on and GPa, without legend entries for what their axes do not reach.
Figures in_shown_units(Figures figures);

/// List of a figure; one without panels is none.
inline Figures listed(const Figure& figure) { return Figures(figure.panels.empty() ? 0 : 1, figure); }
inline Figures listed(Figures figures) { return figures; }

/// A picture that a function makes, one figure or several, from the result, which must outlive it.
template <class R, class Made>
auto of_result(const R& result, Made (*make)(const R&, const FigureOptions&)) {
  return [&result, make](const FigureOptions& options) { return in_shown_units(listed(make(result, options))); };
}
template <class R, class Made>
auto of_result(const R& result, Made (*make)(const R&)) {
  return [&result, make](const FigureOptions&) { return in_shown_units(listed(make(result))); };
}

/// Own pictures, and those of another analysis, which are drawn by name only.
Pictures with(Pictures own, Pictures others);

constexpr Picture::Drawn drawn_if(bool suitable) { return suitable ? Picture::Drawn::always : Picture::Drawn::by_name; }

/// Whether a figure shows any data.
bool has_data(const Figure& figure);

/// All figures that the result has data for, as a command writes them; with `all` (`--all`), also the less common ones.
Figures figures(const Pictures& pictures, bool all = false);

/// One figure, the first if the options leave several, in one panel if they ask for it. Throws NoFigure.
Figure figure(const Pictures& pictures, std::string_view name, const FigureOptions& options);

/// Description of a figure for documents under `figures`; members with their defaults are omitted.
Json to_json(const Figure& figure);

/// Descriptions of figures for documents under `figures`.
Json to_json(const Figures& figures);

/// Ending of files of descriptions, from which `figures_of` makes the figures again; none for other texts. Numbers have
/// seven digits.
inline constexpr std::string_view kFiguresEnding = "_figures.json";
std::string figures_text(const Figures& figures);
Figures figures_of(std::string_view text);

/// Options from a JSON object with the names of their members. Throws NoFigure.
FigureOptions figure_options(const std::string& text);

/// JSON Schema of a description.
Json figure_schema();

/// Largest number of lines that can be distinguished.
inline constexpr std::size_t kMostLines = kPaletteSize;

/// Fewest points of a curve over loads.
inline constexpr std::size_t kMinSweepPoints = 3;

/// Style of the k-th of several lines with marks.
Style marked_line(std::size_t k);

/// Colour of the k-th of several load cases or models, different from those of the parts as far as possible; grey is
/// for the background and for what belongs to all.
constexpr Colour case_colour(std::size_t k) {
  constexpr Colour kOrder[] = {Colour::ink,   Colour::orange, Colour::purple,    Colour::sky,
                               Colour::green, Colour::blue,   Colour::vermillion};
  return kOrder[k % std::size(kOrder)];
}
Style case_line(std::size_t k);

constexpr Style kMeanStyle = line_of(Colour::reference, Dash::dashed, Weight::thin);
constexpr Style kZeroStyle = line_of(Colour::reference, Dash::solid, Weight::thin);

constexpr Colour colour_of(Part part) {
  return part == Part::screw ? Colour::blue : part == Part::roller ? Colour::green : Colour::vermillion;
}

constexpr std::string_view title(Part part) {
  return part == Part::screw ? "screw" : part == Part::roller ? "roller" : "nut";
}

/// `Roller-screw` or `Roller-nut`.
std::string interface_title(Interface i);

/// Name given by a user, in one line of limited length.
std::string shown_name(std::string_view name);

/// Label of loads in both senses.
inline constexpr std::string_view kSignedForce = "Axial force, tension >\u00a00";

Axis thread_axis(std::size_t threads);

/// Points (1, value), (2, value), .. in shown units.
Polyline over_threads(const std::vector<double>& values, double factor);

Polyline rectangle(double left, double right, double bottom, double top);

/// A closed line, with the major semi-axis at an angle from x.
Polyline ellipse(double x, double y, double semi_major, double semi_minor, double angle);

/// A number with a typographic minus, as on the axes.
std::string number(double value, int decimals);

/// Names along y, from above, for bars at 1, 2, ..
Axis ranked_axis(const std::vector<std::string>& names);
/// y of the k-th name, from 0.
double rank_position(std::size_t k, std::size_t count);

/// Change of axes and colours to a unit that is `factor` times the old one, if their numbers reach `least`.
struct UnitChange {
  std::string from;
  std::string to;
  double factor = 1e-3;
  double least = 0.0;
};
Figure in_unit(Figure figure, const UnitChange& change);

/// The figure with the signs of pages for its SI units: µm, °C.
Figure in_page_units(Figure figure);

/// Adds to every panel a dashed line at `mean`, the load of each thread if all had the same.
void add_mean(Figure& figure, double mean);

/// Smallest value not below `least` > 0 of the form 1, 2 or 5 times a power of ten.
double round_step(double least);

/// Round numbers around all values, in at most this many steps; empty if there are no values.
std::vector<double> round_levels(const Range& range, std::size_t most_steps);

/// Figure whose legend says where a line lies under another, and has no entries for lines that are not shown.
Figure with_true_legend(Figure figure);

/// Drops items after the first `count` and says so in the title.
template <class Item>
void keep_first(std::vector<Item>& items, std::size_t count, std::string& title) {
  if (items.size() <= count) return;
  title += ", first " + std::to_string(count) + " of " + std::to_string(items.size());
  items.resize(count);
}

}  // namespace prs
