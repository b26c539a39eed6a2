#pragma once

#include <functional>
#include <stdexcept>

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
  std::optional<std::size_t> thread = {};  ///< Of all rollers, from 0; absent: the most loaded.
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
  return [&result, make](const FigureOptions& options) {
    return in_kilonewtons(make(result, options));
  };
}
template <class R>
auto of_result(const R& result, Figures (*make)(const R&)) {
  return [&result, make](const FigureOptions&) { return in_kilonewtons(make(result)); };
}

/// Those of another analysis, asked for by their names alone.
Pictures with(Pictures own, Pictures others);

constexpr Picture::Drawn drawn_if(bool suitable) {
  return suitable ? Picture::Drawn::always : Picture::Drawn::by_name;
}

/// Whether a figure shows any number.
bool has_data(const Figure& figure);

/// All that the result has data for, as a command writes them; with `all` (`--all`), also those
/// that few readers want.
Figures figures(const Pictures& pictures, bool all = false);

/// One of them, the first where the options leave several, in one panel if they ask for it. Throws
/// NoFigure.
Figure figure(const Pictures& pictures, std::string_view name, const FigureOptions& options);

}  // namespace prs
