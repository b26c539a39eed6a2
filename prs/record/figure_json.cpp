#include "prs/record/figure_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "prs/record/schema_parts.h"

namespace prs {
namespace {

using schema_parts::Json, schema_parts::link, schema_parts::list, schema_parts::names,
    schema_parts::object, schema_parts::type;

constexpr std::array<std::string_view, 11> kColours = {"blue",      "vermillion", "green", "purple",
                                                       "orange",    "sky",        "ink",   "grey",
                                                       "reference", "muted",      "bad"};
constexpr std::array<std::string_view, 5> kDashes = {"none", "solid", "dashed", "dotted",
                                                     "dash_dotted"};
constexpr std::array<std::string_view, 9> kMarks = {
    "none", "circle", "square", "triangle", "diamond", "down", "plus", "cross", "star"};
constexpr std::array<std::string_view, 3> kWeights = {"thin", "normal", "strong"};
constexpr std::array<std::string_view, 3> kShapes = {"line", "area", "arrows"};
constexpr std::array<std::string_view, 3> kAnchors = {"left", "centre", "right"};

constexpr int kMostColumns = 100;  ///< Of panels side by side.

template <class Names, class Value>
std::string_view name_of(const Names& names, Value value) {
  return names[static_cast<std::size_t>(value)];
}

template <class Value>
void put_unless(Json& json, const char* key, const Value& value, const Value& left_out) {
  if (value != left_out) json[key] = value;
}

template <class Items>
void put_all(Json& json, const char* key, const Items& items, auto to_json_of) {
  if (items.empty()) return;
  Json& list = json[key] = Json::array();
  for (const auto& item : items) list.push_back(to_json_of(item));
}

Json tick_json(const Tick& tick) {
  Json json{{"at", tick.at}};
  put_unless(json, "text", tick.text, {});
  return json;
}

Json axis_json(const Axis& axis) {
  Json json{{"label", axis.label}};
  put_unless(json, "unit", axis.unit, {});
  if (std::isfinite(axis.from)) json["from"] = axis.from;
  if (std::isfinite(axis.to)) json["to"] = axis.to;
  put_unless(json, "logarithmic", axis.logarithmic, false);
  put_unless(json, "whole", axis.whole, false);
  put_unless(json, "hidden", axis.hidden, false);
  put_all(json, "ticks", axis.ticks, tick_json);
  return json;
}

Json style_json(const Style& style) {
  const Style plain;
  Json json{{"shape", name_of(kShapes, style.shape)}, {"colour", name_of(kColours, style.colour)}};
  if (style.dash != plain.dash) json["dash"] = name_of(kDashes, style.dash);
  if (style.mark != plain.mark) json["mark"] = name_of(kMarks, style.mark);
  if (style.weight != plain.weight) json["weight"] = name_of(kWeights, style.weight);
  put_unless(json, "open", style.open, false);
  put_unless(json, "pale", style.pale, false);
  return json;
}

Json scale_json(const ColourScale& colours) {
  Json json{{"label", colours.label}};
  put_unless(json, "unit", colours.unit, {});
  json["from"] = colours.from;
  json["to"] = colours.to;
  put_unless(json, "levels", colours.levels, {});
  put_unless(json, "logarithmic", colours.logarithmic, false);
  put_unless(json, "whole", colours.whole, false);
  return json;
}

void put_grid(Json& json, const GridData& grid) {
  json["x"] = grid.x;
  json["y"] = grid.y;
  Json& rows = json["values"] = Json::array();
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    Json& row = rows.emplace_back(Json::array());
    for (std::size_t j = 0; j < grid.y.size(); ++j) row.push_back(grid.at(i, j));
  }
}

Json series_json(const Series& series) {
  Json json{{"style", series.style}, {"parts", series.parts}};
  put_unless(json, "values", series.values, {});
  return json;
}

Json reference_json(const ReferenceLine& reference) {
  Json json{{"style", reference.style}, {"at", reference.at}};
  put_unless(json, "vertical", reference.vertical, false);
  return json;
}

Json label_json(const Label& label) {
  Json json{{"text", label.text}, {"x", label.x}, {"y", label.y}};
  put_unless(json, "in_panel", label.in_panel, false);
  if (label.anchor != Label::Anchor::left) json["anchor"] = name_of(kAnchors, label.anchor);
  return json;
}

Json panel_json(const Panel& panel) {
  Json json = Json::object();
  put_unless(json, "title", panel.title, {});
  if (panel.x) json["x"] = axis_json(*panel.x);
  if (panel.y) json["y"] = axis_json(*panel.y);
  put_all(json, "series", panel.series, series_json);
  put_all(json, "references", panel.references, reference_json);
  put_all(json, "labels", panel.labels, label_json);
  if (!panel.map.grid.empty()) {
    put_grid(json["map"], panel.map.grid);
    put_unless(json["map"], "cells", panel.map.cells, false);
  }
  if (panel.surface) {
    Json& surface = json["surface"];
    put_grid(surface, panel.surface->grid);
    surface["z"] = axis_json(panel.surface->z);
    put_all(surface, "points", panel.surface->points, [](const SurfacePoint& p) {
      return Json{{"name", p.name}, {"x", p.x}, {"y", p.y}, {"z", p.z}};
    });
  }
  return json;
}

/// Rounds every number, so that files of large maps stay short.
void shorten(Json& json) {
  if (json.is_structured())
    for (Json& entry : json) shorten(entry);
  else if (json.is_number_float() && std::isfinite(json.get<double>()))
    json = Json::parse(fmt::format("{:.7g}", json.get<double>())).get<double>();
}

// From JSON: what is absent keeps its default.

double read_number(const Json& json) { return json.is_null() ? kFree : json.get<double>(); }

template <class Value>
void read_to(const Json& json, const char* key, Value& value) {
  if (const auto found = json.find(key); found != json.end()) value = found->get<Value>();
}
void read_to(const Json& json, const char* key, double& value) {
  if (const auto found = json.find(key); found != json.end()) value = read_number(*found);
}
template <class Names, class Value>
void read_name(const Json& json, const char* key, const Names& names, Value& value) {
  const auto found = json.find(key);
  if (found == json.end()) return;
  const auto name = std::ranges::find(names, found->get<std::string>());
  if (name == names.end()) throw std::runtime_error(key);
  value = static_cast<Value>(name - names.begin());
}
template <class Item>
void read_all(const Json& json, const char* key, std::vector<Item>& items, auto item_of) {
  if (const auto found = json.find(key); found != json.end())
    for (const Json& entry : *found) items.push_back(item_of(entry));
}

Axis read_axis(const Json& json) {
  Axis axis;
  read_to(json, "label", axis.label);
  read_to(json, "unit", axis.unit);
  read_to(json, "from", axis.from);
  read_to(json, "to", axis.to);
  read_to(json, "logarithmic", axis.logarithmic);
  read_to(json, "whole", axis.whole);
  read_to(json, "hidden", axis.hidden);
  read_all(json, "ticks", axis.ticks, [](const Json& entry) {
    Tick tick{entry.at("at").get<double>()};
    read_to(entry, "text", tick.text);
    return tick;
  });
  return axis;
}

Style read_style(const Json& json) {
  Style style;
  read_name(json, "shape", kShapes, style.shape);
  read_name(json, "colour", kColours, style.colour);
  read_name(json, "dash", kDashes, style.dash);
  read_name(json, "mark", kMarks, style.mark);
  read_name(json, "weight", kWeights, style.weight);
  read_to(json, "open", style.open);
  read_to(json, "pale", style.pale);
  return style;
}

ColourScale read_scale(const Json& json) {
  ColourScale scale;
  read_to(json, "label", scale.label);
  read_to(json, "unit", scale.unit);
  read_to(json, "from", scale.from);
  read_to(json, "to", scale.to);
  read_to(json, "levels", scale.levels);
  read_to(json, "logarithmic", scale.logarithmic);
  read_to(json, "whole", scale.whole);
  return scale;
}

GridData read_grid(const Json& json) {
  GridData grid{json.at("x"), json.at("y"), {}};
  for (const Json& row : json.at("values"))
    for (const Json& value : row) grid.values.push_back(read_number(value));
  if (grid.values.size() != grid.x.size() * grid.y.size()) throw std::runtime_error("values");
  return grid;
}

Series read_series(const Json& json) {
  Series series{json.at("style")};
  read_all(json, "parts", series.parts, [](const Json& part) {
    Polyline points;
    for (const Json& point : part)
      points.push_back({read_number(point.at(0)), read_number(point.at(1))});
    return points;
  });
  read_all(json, "values", series.values, read_number);
  return series;
}

Label read_label(const Json& json) {
  Label label{json.at("text"), json.at("x"), json.at("y")};
  read_to(json, "in_panel", label.in_panel);
  read_name(json, "anchor", kAnchors, label.anchor);
  return label;
}

Panel read_panel(const Json& json) {
  Panel panel;
  read_to(json, "title", panel.title);
  if (json.contains("x")) panel.x = read_axis(json["x"]);
  if (json.contains("y")) panel.y = read_axis(json["y"]);
  read_all(json, "series", panel.series, read_series);
  read_all(json, "references", panel.references, [](const Json& entry) {
    ReferenceLine line{entry.at("style"), entry.at("at")};
    read_to(entry, "vertical", line.vertical);
    return line;
  });
  read_all(json, "labels", panel.labels, read_label);
  if (const auto map = json.find("map"); map != json.end()) {
    panel.map.grid = read_grid(*map);
    read_to(*map, "cells", panel.map.cells);
  }
  if (const auto surface = json.find("surface"); surface != json.end()) {
    panel.surface = {read_grid(*surface), read_axis(surface->at("z")), {}};
    read_all(*surface, "points", panel.surface->points, [](const Json& p) {
      return SurfacePoint{p.at("name"), read_number(p.at("x")), read_number(p.at("y")),
                          read_number(p.at("z"))};
    });
  }
  return panel;
}

Figure read_figure(const Json& json) {
  Figure figure{json.at("name"), json.at("title"), read_axis(json.at("x")), read_axis(json.at("y")),
                json.at("columns")};
  read_to(json, "aspect", figure.aspect);
  read_to(json, "overview", figure.overview);
  read_to(json, "to_scale", figure.to_scale);
  if (json.contains("colours")) figure.colours = read_scale(json["colours"]);
  read_all(json, "styles", figure.styles, read_style);
  read_all(json, "legend", figure.legend, [](const Json& entry) {
    return LegendEntry{entry.at("title"), entry.at("style")};
  });
  read_all(json, "panels", figure.panels, read_panel);
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

}  // namespace

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
    return {};  // Changed by other hands, or of another version.
  }
}

Json to_json(const Figure& figure) {
  Json json{{"name", figure.name}, {"title", figure.title}, {"columns", figure.columns}};
  put_unless(json, "aspect", figure.aspect, 0.0);
  put_unless(json, "overview", figure.overview, 0.0);
  put_unless(json, "to_scale", figure.to_scale, false);
  json["x"] = axis_json(figure.x);
  json["y"] = axis_json(figure.y);
  if (figure.colours) json["colours"] = scale_json(*figure.colours);
  put_all(json, "styles", figure.styles, style_json);
  put_all(json, "legend", figure.legend, [](const LegendEntry& entry) {
    return Json{{"title", entry.title}, {"style", entry.style}};
  });
  put_all(json, "panels", figure.panels, panel_json);
  return json;
}

Json figure_schema() {
  const Json text = type("string"), number = type("number"), flag = type("boolean");
  const Json index = {{"type", "integer"}, {"minimum", 0}};
  const Json numbers = list(number);
  const Json maybe = {{"type", {"number", "null"}}};
  const Json point = {{"type", "array"}, {"items", maybe}, {"minItems", 2}, {"maxItems", 2}};
  const Json axis = link("axis"), style = index;
  Json grid{{"x", numbers}, {"y", numbers}, {"values", list(list(maybe))}};
  Json map = grid, surface = grid;
  map["cells"] = type("boolean",
                      "a rectangle of one colour at each node, else filled contours with "
                      "labelled lines at the levels of the colours");
  surface["z"] = axis;
  surface["points"] =
      list(object({{"name", text}, {"x", number}, {"y", number}, {"z", number}}, {"name"}));
  Json definitions;
  definitions["axis"] = object({{"label", text},
                                {"unit", text},
                                {"from", type("number", "absent: fitted to what the panel shows")},
                                {"to", number},
                                {"logarithmic", flag},
                                {"whole", type("boolean", "ticks at whole numbers alone")},
                                {"hidden", type("boolean", "neither ticks nor label")},
                                {"ticks", list(object({{"at", number}, {"text", text}}, {"at"}))}},
                               {"label"});
  definitions["style"] =
      object({{"shape", names(kShapes)},
              {"colour", names(kColours)},
              {"dash", names(kDashes)},
              {"mark", names(kMarks)},
              {"weight", names(kWeights)},
              {"open", type("boolean", "marks outlined")},
              {"pale", type("boolean", "areas in a light shade")}},
             {"shape", "colour"}, "dash: solid, mark: none, weight: normal unless given");
  definitions["panel"] =
      object({{"title", text},
              {"x", axis},
              {"y", axis},
              {"series", list(object({{"style", style},
                                      {"parts", list(list(point))},
                                      {"values",
                                       {{"type", "array"},
                                        {"items", maybe},
                                        {"description", "one per part: its colour on the scale"}}}},
                                     {"style", "parts"}))},
              {"references", list(object({{"style", style}, {"at", number}, {"vertical", flag}},
                                         {"style", "at"}, "a line across the panel"))},
              {"labels", list(object({{"text", text},
                                      {"x", number},
                                      {"y", number},
                                      {"in_panel", type("boolean", "x, y are shares of the panel")},
                                      {"anchor", names(kAnchors)}},
                                     {"text", "x", "y"}))},
              {"map", object(std::move(map), {"x", "y", "values"})},
              {"surface", object(std::move(surface), {"x", "y", "values", "z"})}},
             {});
  Json schema = object(
      {{"name", text},
       {"title", text},
       {"columns", type("integer", "panels side by side, filled row by row")},
       {"aspect", type("number", "height of a panel over its width")},
       {"overview", type("number",
                         "the first panel fills the first column, so many times as wide "
                         "as the others")},
       {"to_scale", type("boolean", "a unit is as long on both axes")},
       {"x", axis},
       {"y", axis},
       {"colours", object({{"label", text},
                           {"unit", text},
                           {"from", number},
                           {"to", number},
                           {"levels", numbers},
                           {"logarithmic", flag},
                           {"whole", flag}},
                          {"label", "from", "to"})},
       {"styles", list(link("style"))},
       {"legend", list(object({{"title", text}, {"style", style}}, {"title", "style"}))},
       {"panels", list(link("panel"))}},
      {"name", "title", "columns", "x", "y", "panels"}, "A picture as data, of documents' figures");
  schema["$schema"] = schema_parts::kDialect;
  schema["$defs"] = std::move(definitions);
  return schema;
}

}  // namespace prs
