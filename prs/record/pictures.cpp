#include "prs/record/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <numbers>
#include <tuple>

#include "prs/indices.h"
#include "prs/record/schema_parts.h"
#include "prs/text.h"

namespace prs {

Pictures with(Pictures own, Pictures others) {
  for (Picture& picture : others) {
    picture.drawn = Picture::Drawn::by_name;
    own.push_back(std::move(picture));
  }
  return own;
}

Figures figures(const Pictures& pictures, bool all) {
  Figures drawn;
  for (const Picture& picture : pictures)
    if (picture.drawn == Picture::Drawn::always || (all && picture.drawn == Picture::Drawn::with_all))
      for (Figure& figure : picture.make({})) drawn.push_back(std::move(figure));
  return drawn;
}

Figure figure(const Pictures& pictures, std::string_view name, const FigureOptions& options) {
  const auto found = std::ranges::find(pictures, name, &Picture::name);
  if (found == pictures.end()) {
    std::vector<std::string_view> names;
    for (const Picture& picture : pictures) names.push_back(picture.name);
    throw NoFigure(fmt::format("no picture {}; there is {}", name, fmt::join(names, ", ")));
  }
  Figures made = found->make(options);
  if (made.empty()) throw NoFigure(fmt::format("no picture {}: it needs {}", name, found->needs));
  if (options.panel) return only_panel(std::move(made.front()), *options.panel);
  return options.one_panel ? folded(made.front()) : std::move(made.front());
}

bool has_data(const Figure& figure) {
  return std::ranges::any_of(figure.panels, [](const Panel& panel) {
    return !panel.map.grid.empty() || std::ranges::any_of(panel.series, [](const Series& series) {
      return std::ranges::any_of(series.parts, [](const Polyline& p) { return !p.empty(); });
    });
  });
}

namespace {

using schema_parts::link, schema_parts::list, schema_parts::names, schema_parts::object, schema_parts::type;

// Contents of a description, listed once for writing, reading and the schema.

constexpr std::array<std::string_view, 11> names_of(Colour) {
  return {"blue", "vermillion", "green", "purple", "orange", "sky", "ink", "grey", "reference", "muted", "bad"};
}
constexpr std::array<std::string_view, 5> names_of(Dash) {
  return {"none", "solid", "dashed", "dotted", "dash_dotted"};
}
constexpr std::array<std::string_view, 9> names_of(Mark) {
  return {"none", "circle", "square", "triangle", "diamond", "down", "plus", "cross", "star"};
}
constexpr std::array<std::string_view, 3> names_of(Weight) { return {"thin", "normal", "strong"}; }
constexpr std::array<std::string_view, 3> names_of(Shape) { return {"line", "area", "arrows"}; }
constexpr std::array<std::string_view, 3> names_of(Label::Anchor) { return {"left", "centre", "right"}; }

/// A member and its key. It is omitted if it has its default, unless it is required.
template <class Owner, class Value>
struct Field {
  const char* key;
  Value Owner::*value;
  bool required = false;
  const char* description = nullptr;
  Json (*form)() = nullptr;  ///< Schema in place of that of its type.
};
template <class Owner, class Value>
constexpr Field<Owner, Value> field(const char* key, Value Owner::*value, const char* description = nullptr,
                                    Json (*form)() = nullptr) {
  return {key, value, false, description, form};
}
template <class Owner, class Value>
constexpr Field<Owner, Value> required(const char* key, Value Owner::*value, const char* description = nullptr,
                                       Json (*form)() = nullptr) {
  return {key, value, true, description, form};
}

Json number_or_null() { return {{"type", {"number", "null"}}}; }

constexpr auto fields_of(const Tick*) { return std::tuple(required("at", &Tick::at), field("text", &Tick::text)); }
constexpr auto fields_of(const Axis*) {
  return std::tuple(required("label", &Axis::label), field("unit", &Axis::unit),
                    field("from", &Axis::from, "absent: fitted to what the panel shows"), field("to", &Axis::to),
                    field("logarithmic", &Axis::logarithmic),
                    field("whole", &Axis::whole, "ticks at whole numbers alone"),
                    field("hidden", &Axis::hidden, "neither ticks nor label"), field("ticks", &Axis::ticks));
}
constexpr auto fields_of(const Style*) {
  return std::tuple(required("shape", &Style::shape), required("colour", &Style::colour), field("dash", &Style::dash),
                    field("mark", &Style::mark), field("weight", &Style::weight),
                    field("open", &Style::open, "marks outlined"),
                    field("pale", &Style::pale, "areas in a light shade"));
}
constexpr auto fields_of(const ColourScale*) {
  return std::tuple(required("label", &ColourScale::label), field("unit", &ColourScale::unit),
                    required("from", &ColourScale::from), required("to", &ColourScale::to),
                    field("levels", &ColourScale::levels), field("logarithmic", &ColourScale::logarithmic),
                    field("whole", &ColourScale::whole));
}
constexpr auto fields_of(const Series*) {
  return std::tuple(
      required("style", &Series::style), required("parts", &Series::parts),
      field(
          "values", &Series::values, "one per part: its colour on the scale", +[] { return list(number_or_null()); }));
}
constexpr auto fields_of(const ReferenceLine*) {
  return std::tuple(required("style", &ReferenceLine::style), required("at", &ReferenceLine::at),
                    field("vertical", &ReferenceLine::vertical));
}
constexpr auto fields_of(const Label*) {
  return std::tuple(required("text", &Label::text), required("x", &Label::x), required("y", &Label::y),
                    field("in_panel", &Label::in_panel, "x, y are shares of the panel"),
                    field("anchor", &Label::anchor));
}
constexpr auto fields_of(const Map*) {
  return std::tuple(field("cells", &Map::cells,
                          "a rectangle of one colour at each node, else filled contours with "
                          "labelled lines at the levels of the colours"));
}
constexpr auto fields_of(const SurfacePoint*) {
  return std::tuple(required("name", &SurfacePoint::name), required("x", &SurfacePoint::x),
                    required("y", &SurfacePoint::y), required("z", &SurfacePoint::z));
}
constexpr auto fields_of(const Surface*) {
  return std::tuple(required("z", &Surface::z), field("points", &Surface::points));
}
constexpr auto fields_of(const Panel*) {
  return std::tuple(field("title", &Panel::title), field("x", &Panel::x), field("y", &Panel::y),
                    field("series", &Panel::series), field("references", &Panel::references),
                    field("labels", &Panel::labels), field("map", &Panel::map), field("surface", &Panel::surface));
}
constexpr auto fields_of(const LegendEntry*) {
  return std::tuple(required("title", &LegendEntry::title), required("style", &LegendEntry::style));
}
constexpr auto fields_of(const Figure*) {
  return std::tuple(
      required("name", &Figure::name), required("title", &Figure::title),
      required(
          "columns", &Figure::columns, "panels side by side, filled row by row", +[] { return type("integer"); }),
      field("aspect", &Figure::aspect, "height of a panel over its width"),
      field("overview", &Figure::overview,
            "the first panel fills the first column, so many times as wide as the "
            "others"),
      field("to_scale", &Figure::to_scale, "a unit is as long on both axes"), required("x", &Figure::x),
      required("y", &Figure::y), field("colours", &Figure::colours), field("styles", &Figure::styles),
      field("legend", &Figure::legend), required("panels", &Figure::panels));
}

template <class T>
concept Described = requires {
  fields_of(static_cast<const T*>(nullptr));
};
template <class T>
concept HasGrid = requires(const T& owner) {
  owner.grid;
};
template <class T>
concept Optional = requires(const T& value) {
  value.has_value();
};
template <class T>
concept Items = !std::is_same_v<T, std::string> && requires(T & items) {
  items.emplace_back();
};

template <class T>
void for_each_field(const auto& use) {
  std::apply([&](const auto&... fields) { (use(fields), ...); }, fields_of(static_cast<const T*>(nullptr)));
}

// To JSON.

template <class T>
bool is_left_out(const T& value, const T& otherwise) {
  if constexpr (Optional<T>)
    return !value;
  else if constexpr (HasGrid<T>)
    return value.grid.empty();
  else if constexpr (Items<T>)
    return value.empty();
  else if constexpr (std::is_floating_point_v<T>)
    return !std::isfinite(value) || value == otherwise;
  else if constexpr (Described<T>)
    return false;
  else
    return value == otherwise;
}

void put_grid(Json& json, const GridData& grid) {
  json["x"] = grid.x;
  json["y"] = grid.y;
  Json& rows = json["values"] = Json::array();
  for (const auto i : indices(grid.x)) {
    Json& row = rows.emplace_back(Json::array());
    for (const auto j : indices(grid.y)) row.push_back(grid.at(i, j));
  }
}

template <class T>
Json json_of(const T& value) {
  if constexpr (Described<T>) {
    Json json = Json::object();
    if constexpr (HasGrid<T>) put_grid(json, value.grid);
    const T plain{};
    for_each_field<T>([&](const auto& f) {
      if (f.required || !is_left_out(value.*f.value, plain.*f.value)) json[f.key] = json_of(value.*f.value);
    });
    return json;
  } else if constexpr (Optional<T>) {
    return json_of(*value);
  } else if constexpr (std::is_enum_v<T>) {
    return item_at(names_of(value), value);
  } else if constexpr (Items<T>) {
    Json json = Json::array();
    for (const auto& item : value) json.push_back(json_of(item));
    return json;
  } else {
    return value;
  }
}

/// Rounds every number, to keep files of large maps short.
void shorten(Json& json) {
  if (json.is_structured()) {
    for (Json& entry : json) shorten(entry);
  } else if (double* number = json.get_ptr<double*>(); number && std::isfinite(*number)) {
    std::array<char, 32> text;
    const char* end = fmt::format_to(text.begin(), "{:.7g}", *number);
    std::from_chars(text.begin(), end, *number);
  }
}

// Reads JSON: absent keys keep their defaults.

template <class T>
void read(const Json& json, T& value) {
  if constexpr (HasGrid<T>) {
    read(json.at("x"), value.grid.x);
    read(json.at("y"), value.grid.y);
    for (const Json& row : json.at("values")) read(row, value.grid.values);
    if (value.grid.values.size() != value.grid.x.size() * value.grid.y.size()) throw std::runtime_error("values");
  }
  if constexpr (Described<T>) {
    for_each_field<T>([&](const auto& f) {
      if (const auto found = json.find(f.key); found != json.end())
        read(*found, value.*f.value);
      else if (f.required)
        throw std::runtime_error(f.key);
    });
  } else if constexpr (Optional<T>) {
    read(json, value.emplace());
  } else if constexpr (std::is_enum_v<T>) {
    const auto all = names_of(value);
    const auto name = std::ranges::find(all, json.get<std::string>());
    if (name == all.end()) throw std::runtime_error("name");
    value = static_cast<T>(name - all.begin());
  } else if constexpr (Items<T>) {
    for (const Json& entry : json) read(entry, value.emplace_back());
  } else if constexpr (std::is_floating_point_v<T>) {
    value = json.is_null() ? kFree : json.get<double>();
  } else if constexpr (std::is_same_v<T, std::array<double, 2>>) {
    for (const std::size_t k : {0U, 1U}) read(json.at(k), value[k]);
  } else {
    value = json.get<T>();
  }
}

Figure read_figure(const Json& json) {
  constexpr std::size_t kMostColumns = 100;  // Largest number of panels side by side.
  Figure figure;
  read(json, figure);
  const auto is_style = [&](std::size_t k) { return k < figure.styles.size(); };
  for (const Panel& panel : figure.panels)
    if (!std::ranges::all_of(panel.series, is_style, &Series::style) ||
        !std::ranges::all_of(panel.references, is_style, &ReferenceLine::style))
      throw std::runtime_error("style");
  if (!std::ranges::all_of(figure.legend, is_style, &LegendEntry::style) || figure.columns < 1 ||
      figure.columns > kMostColumns)
    throw std::runtime_error("legend");
  return figure;
}

// The schema.

template <class T>
constexpr const char* kMeaning = "";
template <>
constexpr const char* kMeaning<Style> = "dash: solid, mark: none, weight: normal unless given";
template <>
constexpr const char* kMeaning<ReferenceLine> = "a line across the panel";
template <>
constexpr const char* kMeaning<Figure> = "A picture as data, of documents' figures";

template <class T>
Json schema_of();

template <class T>
Json object_schema() {
  Json properties = Json::object();
  std::vector<std::string> keys;
  if constexpr (HasGrid<T>) {
    for (const char* axis : {"x", "y"}) properties[axis] = list(type("number"));
    properties["values"] = list(list(number_or_null()));
    keys = {"x", "y", "values"};
  }
  for_each_field<T>([&]<class Value>(const Field<T, Value>& f) {
    Json& form = properties[f.key] = f.form ? f.form() : schema_of<Value>();
    if (f.description) form["description"] = f.description;
    if (f.required) keys.emplace_back(f.key);
  });
  return object(std::move(properties), std::move(keys), kMeaning<T>);
}

template <class T>
Json schema_of() {
  if constexpr (std::is_same_v<T, Axis>)
    return link("axis");
  else if constexpr (std::is_same_v<T, Style>)
    return link("style");
  else if constexpr (std::is_same_v<T, Panel>)
    return link("panel");
  else if constexpr (Described<T>)
    return object_schema<T>();
  else if constexpr (Optional<T>)
    return schema_of<typename T::value_type>();
  else if constexpr (std::is_enum_v<T>)
    return names(names_of(T()));
  else if constexpr (Items<T>)
    return list(schema_of<typename T::value_type>());
  else if constexpr (std::is_same_v<T, std::array<double, 2>>)
    return {{"type", "array"}, {"items", number_or_null()}, {"minItems", 2}, {"maxItems", 2}};
  else if constexpr (std::is_same_v<T, std::size_t>)
    return {{"type", "integer"}, {"minimum", 0}};
  else
    return type(std::is_same_v<T, bool> ? "boolean" : std::is_floating_point_v<T> ? "number" : "string");
}

}  // namespace

Json to_json(const Figure& figure) { return json_of(figure); }

Json to_json(const Figures& figures) { return json_of(figures); }

std::string figures_text(const Figures& figures) {
  Json json = to_json(figures);
  shorten(json);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

Figures figures_of(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_array()) return {};
  try {
    Figures figures;
    for (const Json& entry : json) figures.push_back(read_figure(entry));
    return figures;
  } catch (const std::exception&) {
    return {};  // The file was edited, or is of another version.
  }
}

Json figure_schema() {
  Json schema = object_schema<Figure>();
  schema["$schema"] = schema_parts::kDialect;
  schema["$defs"] = {
      {"axis", object_schema<Axis>()}, {"style", object_schema<Style>()}, {"panel", object_schema<Panel>()}};
  return schema;
}

FigureOptions figure_options(const std::string& text) {
  FigureOptions options;
  const auto take = [](const Json& value, auto& option) {
    using Option = std::remove_reference_t<decltype(option)>;
    if constexpr (Optional<Option>)
      option = value.get<typename Option::value_type>();
    else
      option = value.get<Option>();
  };
  try {
    const Json given = Json::parse(text);
    for (const auto& entry : given.items()) {
      const std::string& key = entry.key();
      const Json& value = entry.value();
      const auto is = [&](const char* name, auto& option) {
        if (key == name) take(value, option);
        return key == name;
      };
      if (is("load_cases", options.load_cases) || is("load_case", options.load_case) || is("thread", options.thread) ||
          is("panel", options.panel) || is("one_panel", options.one_panel) || is("response", options.response) ||
          is("x", options.x) || is("y", options.y))
        continue;
      if (key != "interface" || (value != "screw" && value != "nut"))
        throw NoFigure("options of a picture: got " + key + ": " + value.dump());
      options.interface = value == "screw" ? Interface::screw : Interface::nut;
    }
  } catch (const Json::exception& error) {
    throw NoFigure(std::string("options of a picture: ") + error.what());
  }
  return options;
}

Style marked_line(std::size_t k) {
  Style style{palette(k)};
  style.mark = static_cast<Mark>(1 + k % 8);
  return style;
}

Style case_line(std::size_t k) {
  Style style = marked_line(k);
  style.colour = case_colour(k);
  return style;
}

std::string interface_title(Interface i) { return i == Interface::screw ? "Roller-screw" : "Roller-nut"; }

std::string shown_name(std::string_view name) {
  constexpr std::size_t kMost = 30;
  return shortened(printable(name), kMost);
}

Figure in_page_units(Figure figure) {
  for (const UnitChange& change : {UnitChange{"um", "µm", 1.0}, {"degC", "°C", 1.0}})
    figure = in_unit(std::move(figure), change);
  return figure;
}

Figure in_unit(Figure figure, const UnitChange& change) {
  const auto scale = [&](auto&... values) { ((values *= change.factor), ...); };
  const auto scale_all = [&](std::vector<double>& values) {
    for (double& value : values) value *= change.factor;
  };
  const auto is_large = [&](const std::string& unit, const Range& range) {
    return unit == change.from && std::max(-range.from, range.to) >= change.least;
  };
  for (const std::size_t d : {0U, 1U}) {
    const auto axis_of = [&](Panel& panel) -> Axis& {
      std::optional<Axis>& own = d == 0 ? panel.x : panel.y;
      return own ? *own : d == 0 ? figure.x : figure.y;
    };
    std::map<Axis*, Range> shown;
    for (Panel& panel : figure.panels)
      for (const Series& series : panel.series)
        for (const Polyline& part : series.parts)
          for (const auto& point : part) shown[&axis_of(panel)].include(point[d]);
    std::erase_if(shown, [&](const auto& axis) { return !is_large(axis.first->unit, axis.second); });
    for (const auto& axis : shown) {
      Axis& a = *axis.first;
      a.unit = change.to;
      scale(a.from, a.to);
      for (Tick& tick : a.ticks) scale(tick.at);
    }
    for (Panel& panel : figure.panels) {
      if (!shown.contains(&axis_of(panel))) continue;
      for (Series& series : panel.series)
        for (Polyline& part : series.parts)
          for (auto& point : part) scale(point[d]);
      for (ReferenceLine& reference : panel.references)
        if (reference.vertical == (d == 0)) scale(reference.at);
      for (Label& label : panel.labels)
        if (!label.in_panel) scale(d == 0 ? label.x : label.y);
      scale_all(d == 0 ? panel.map.grid.x : panel.map.grid.y);
      if (!panel.surface) continue;
      scale_all(d == 0 ? panel.surface->grid.x : panel.surface->grid.y);
      for (SurfacePoint& point : panel.surface->points) scale(d == 0 ? point.x : point.y);
    }
  }
  if (!figure.colours || !is_large(figure.colours->unit, {figure.colours->from, figure.colours->to})) return figure;
  figure.colours->unit = change.to;
  scale(figure.colours->from, figure.colours->to);
  scale_all(figure.colours->levels);
  for (Panel& panel : figure.panels) {
    for (Series& series : panel.series) scale_all(series.values);
    scale_all(panel.map.grid.values);
    if (!panel.surface) continue;
    panel.surface->z.unit = change.to;
    scale(panel.surface->z.from, panel.surface->z.to);
    scale_all(panel.surface->grid.values);
    for (SurfacePoint& point : panel.surface->points) scale(point.z);
  }
  return figure;
}

namespace {

/// All points that a style draws in a panel.
std::vector<std::array<double, 2>> points_of_style(const Panel& panel, std::size_t style) {
  std::vector<std::array<double, 2>> points;
  for (const Series& series : panel.series)
    if (series.style == style)
      for (const Polyline& part : series.parts) append(points, part);
  return points;
}

/// Whether the lines of two styles coincide wherever both are shown, as far as is visible.
bool are_alike(const Figure& figure, std::size_t a, std::size_t b) {
  constexpr double kSeen = 0.004;  // Visible difference, as a share of the height of a panel.
  bool shown = false;
  for (const Panel& panel : figure.panels) {
    const auto left = points_of_style(panel, a), right = points_of_style(panel, b);
    if (left.size() != right.size()) return false;
    shown = shown || left.size() > 1;
    Range range = range_of_y(panel.series);
    if (const Axis& y = panel.y ? *panel.y : figure.y; std::isfinite(y.from + y.to))
      range = {std::min(y.from, y.to), std::max(y.from, y.to)};
    for (const auto k : indices(left))
      if (left[k][0] != right[k][0] || !(std::abs(left[k][1] - right[k][1]) <= kSeen * (range.to - range.from)))
        return false;
  }
  return shown;
}

/// Whether a range from a to b, in either order, reaches an axis.
bool reaches(const Axis& axis, double a, double b) {
  return !(std::max(a, b) < std::min(axis.from, axis.to) || std::min(a, b) > std::max(axis.from, axis.to));
}

/// Whether some series have the style, but nothing that their axes reach.
bool is_empty(const Figure& figure, std::size_t style) {
  bool used = false;
  for (const Panel& panel : figure.panels) {
    const Axis &x = panel.x ? *panel.x : figure.x, &y = panel.y ? *panel.y : figure.y;
    for (const Series& series : panel.series) {
      if (series.style != style) continue;
      used = true;
      for (const Polyline& part : series.parts)
        for (const auto k : indices(part)) {
          const auto &here = part[k], &before = part[k > 0 ? k - 1 : 0];
          if (reaches(x, here[0], before[0]) && reaches(y, here[1], before[1])) return false;
        }
    }
  }
  return used;
}

void drop_empty_entries(Figure& figure) {
  std::erase_if(figure.legend, [&](const LegendEntry& e) { return is_empty(figure, e.style); });
}

}  // namespace

Figures in_shown_units(Figures figures) {
  for (Figure& figure : figures) {
    figure = in_unit(in_unit(std::move(figure), {"N", "kN", 1e-3, 1e3}), {"MPa", "GPa"});
    drop_empty_entries(figure);
  }
  return figures;
}

Figure with_true_legend(Figure figure) {
  drop_empty_entries(figure);
  const auto is_line = [&](const LegendEntry& e) {
    const Style& style = figure.styles[e.style];
    return style.shape == Shape::line && style.dash != Dash::none;
  };
  const std::vector<LegendEntry> plain = figure.legend;
  for (const auto k : indices(plain))
    for (std::size_t above = k + 1; above < plain.size() && is_line(plain[k]); ++above)
      if (is_line(plain[above]) && are_alike(figure, plain[k].style, plain[above].style)) {
        figure.legend[k].title += fmt::format(", under {}", plain[above].title);
        break;
      }
  return figure;
}

Axis thread_axis(std::size_t threads) {
  const std::size_t step = threads <= 10 ? 1 : threads <= 30 ? 5 : 10 * ((threads + 99) / 100);
  Axis axis{"Thread, from the loaded end of the screw", "", 0.4, static_cast<double>(threads) + 0.6};
  axis.whole = true;
  axis.ticks.push_back({1.0});
  for (std::size_t tick = step; tick <= threads; tick += step)
    if (tick > 1) axis.ticks.push_back({static_cast<double>(tick)});
  return axis;
}

Polyline over_threads(const std::vector<double>& values, double factor) {
  Polyline points;
  for (const double value : values) points.push_back({static_cast<double>(points.size() + 1), value * factor});
  return points;
}

Polyline rectangle(double left, double right, double bottom, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Polyline ellipse(double x, double y, double semi_major, double semi_minor, double angle) {
  constexpr int kPoints = 72;
  const double c = std::cos(angle), s = std::sin(angle);
  Polyline points;
  for (int k = 0; k <= kPoints; ++k) {
    const double t = 2.0 * std::numbers::pi * k / kPoints;
    const double u = semi_major * std::cos(t), v = semi_minor * std::sin(t);
    points.push_back({x + c * u - s * v, y + s * u + c * v});
  }
  return points;
}

std::string number(double value, int decimals) {
  const bool is_negative = value < -0.5 * std::pow(10.0, -decimals);
  return fmt::format("{}{:.{}f}", is_negative ? "−" : "", std::abs(value), decimals);
}

double rank_position(std::size_t k, std::size_t count) { return static_cast<double>(count - k); }

Axis ranked_axis(const std::vector<std::string>& names) {
  Axis axis{"", "", 0.5, static_cast<double>(names.size()) + 0.5};
  for (const auto k : indices(names)) axis.ticks.push_back({rank_position(k, names.size()), names[k]});
  return axis;
}

void add_mean(Figure& figure, double mean) {
  const std::size_t style = figure.add("equal thread loads", kMeanStyle);
  for (Panel& panel : figure.panels) panel.references.push_back({style, mean});
}

double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= least * (1.0 - 1e-9)) return digit * power;
  return 10.0 * power;
}

std::vector<double> round_levels(const Range& range, std::size_t most_steps) {
  if (range.empty()) return {};
  const double least = range.from, largest = range.to;
  const double magnitude = std::max(std::abs(least), std::abs(largest));
  if (largest - least <= 1e-9 * magnitude || largest == least) {
    const double margin = magnitude > 0.0 ? 0.05 * magnitude : 1.0;
    return {least - margin, largest + margin};
  }
  const double most = static_cast<double>(most_steps);
  double step = round_step((largest - least) / most);
  while (std::ceil(largest / step) - std::floor(least / step) > most) step = round_step(1.5 * step);
  std::vector<double> levels;
  for (double k = std::floor(least / step); k <= std::ceil(largest / step); k += 1.0) levels.push_back(k * step);
  return levels;
}

}  // namespace prs
