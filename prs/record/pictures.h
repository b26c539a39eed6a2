#pragma once

#include <functional>
#include <iterator>
#include <stdexcept>

#include "prs/json_type.h"
#include "prs/model/part.h"
#include "prs/record/figure.h"

namespace prs {

using Figures = std::vector<Figure>;

/// Which of several pictures of a kind, and what it shows.
struct FigureOptions {
  std::vector<std::size_t> load_cases = {};  ///< By their places; empty: all.
  std::optional<std::size_t> load_case = {};
  std::optional<Interface> interface = {};
  std::optional<std::string> response = {};  ///< A path; absent: one figure for each.
  std::optional<std::string> x = {};         ///< Paths of factors.
  std::optional<std::string> y = {};
  std::optional<std::size_t> thread = {};  ///< Thread of all rollers, from 0; absent: the most loaded.
  std::optional<std::size_t> panel = {};   ///< Only this one.
  bool one_panel = false;                  ///< All in one panel, as far as that is possible.
};

/// There is no such picture, or the result has no data for it.
class NoFigure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A picture of a result.
struct Picture {
  std::string_view name;
  std::string_view needs;  ///< What the result must have.
  std::function<Figures(const FigureOptions&)> make;
  /// When a command writes it.
  enum class Drawn { always, with_all, by_name } drawn = Drawn::always;
};
using Pictures = std::vector<Picture>;

Figures in_kilonewtons(Figures figures);

/// A picture that a function makes of the result, which must outlive it.
template <class R>
auto of_result(const R& result, Figures (*make)(const R&, const FigureOptions&)) {
  return [&result, make](const FigureOptions& options) { return in_kilonewtons(make(result, options)); };
}
template <class R>
auto of_result(const R& result, Figures (*make)(const R&)) {
  return [&result, make](const FigureOptions&) { return in_kilonewtons(make(result)); };
}

/// Those of another analysis, asked for by their names alone.
Pictures with(Pictures own, Pictures others);

constexpr Picture::Drawn drawn_if(bool suitable) { return suitable ? Picture::Drawn::always : Picture::Drawn::by_name; }

/// Whether a figure shows any number.
bool has_data(const Figure& figure);

/// All that the result has data for, as a command writes them; with `all` (`--all`), also those
/// that few readers want.
Figures figures(const Pictures& pictures, bool all = false);

/// One of them, the first where the options leave several, in one panel if they ask for it. Throws
/// NoFigure.
Figure figure(const Pictures& pictures, std::string_view name, const FigureOptions& options);

/// A description as documents have it under `figures`; what has its default is absent.
Json to_json(const Figure& figure);

/// What documents have under `figures`.
Json to_json(const Figures& figures);

/// Descriptions in a file, of which `figures_of` makes the figures again; none where the text is no
/// such file. Numbers have seven digits.
inline constexpr std::string_view kFiguresEnding = "_figures.json";
std::string figures_text(const Figures& figures);
Figures figures_of(std::string_view text);

/// Options as a JSON object with the names of their members. Throws NoFigure.
FigureOptions figure_options(const std::string& text);

/// JSON Schema of a description.
Json figure_schema();

/// Lines that can be told apart.
inline constexpr std::size_t kMostLines = kPaletteSize;

/// Points that a curve over loads needs.
inline constexpr std::size_t kMinSweepPoints = 3;

/// The k-th of several lines with marks.
Style marked_line(std::size_t k);

/// The k-th of several load cases or models, in other colours than those of the parts as far as
/// there are any; grey is what stands behind, or belongs to all of them.
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

/// What users named, in one line that is not too long.
std::string shown_name(std::string_view name);

/// Label of loads in both senses.
inline constexpr std::string_view kSignedForce = "Axial force, tension >\u00a00";

Axis thread_axis(std::size_t threads);

/// (1, value), (2, value), .. in shown units.
Polyline over_threads(const std::vector<double>& values, double factor);

Polyline rectangle(double left, double right, double bottom, double top);

/// A closed line, with the major semi-axis at an angle from x.
Polyline ellipse(double x, double y, double semi_major, double semi_minor, double angle);

/// A number with a typographic minus, as the axes have it.
std::string number(double value, int decimals);

/// Names along y, from above, for bars at 1, 2, ..
Axis ranked_axis(const std::vector<std::string>& names);
/// Position of the k-th, from 0.
double rank_position(std::size_t k, std::size_t count);

/// Axes and colours in one unit instead of another, of which it is `factor`, where their numbers
/// reach `least`.
struct UnitChange {
  std::string from;
  std::string to;
  double factor = 1e-3;
  double least = 0.0;
};
Figure in_unit(Figure figure, const UnitChange& change);

/// Forces of 10 kN and more in kN where the figure has them in N.
Figure in_kilonewtons(Figure figure);

/// As tables of the page have them: kN from 1000 N on, and GPa.
Figure in_page_units(Figure figure);

/// A dashed line where all threads would share the load equally, at `mean`, in every panel.
void add_mean(Figure& figure, double mean);

/// The least of 1, 2 or 5 times a power of ten that is not below `least` > 0.
double round_step(double least);

/// Round numbers around all values, at most so many steps; empty where there is none.
std::vector<double> round_levels(const Range& range, std::size_t most_steps);

/// Says in the legend of each line that lies under another where that is; without entries of which
/// nothing is shown.
Figure with_true_legend(Figure figure);

/// Drops what is beyond the first `count` and says so in the title.
template <class Item>
void keep_first(std::vector<Item>& items, std::size_t count, std::string& title) {
  if (items.size() <= count) return;
  title += ", first " + std::to_string(count) + " of " + std::to_string(items.size());
  items.resize(count);
}

}  // namespace prs
