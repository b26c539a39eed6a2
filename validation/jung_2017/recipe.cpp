#include "validation/jung_2017/recipe.h"

#include <fmt/ranges.h>

#include "prs/life/capacity.h"
#include "prs/validation/csv_table.h"

namespace prs::jung_2017 {
namespace {

using input::ErrorList;
using input::InputError;
using input::Node;
using Json = nlohmann::ordered_json;

/// A diameter that the user gives.
struct Given {
  std::string_view key;
  double Diameters::*diameter;
};
constexpr Given kGiven[] = {{"nut_outer", &Diameters::nut_outer},
                            {"screw", &Diameters::screw},
                            {"roller", &Diameters::roller}};
constexpr std::size_t kGivenCount = std::size(kGiven);
constexpr std::string_view kExample = "54 mm, 27 mm, 9 mm";

/// Smaller and larger ones are units gone wrong.
constexpr double kSmallest = 1e-4, kLargest = 10.0;

/// What is wrong with a row and with which of its diameters.
struct Problem {
  std::size_t given = 0;
  std::string message;
};

std::string in_mm(double length) { return fmt::format("{:.10g} mm", length * per_si::millimetre); }

std::optional<Problem> problem_of(const Diameters& d) {
  for (std::size_t k = 0; k < kGivenCount; ++k) {
    const double value = d.*kGiven[k].diameter;
    if (!(value >= kSmallest && value <= kLargest))
      return Problem{k,
                     fmt::format("got {}; expected 0.1 mm to 10 m; check its unit", in_mm(value))};
  }
  if (d.nut_outer <= d.nut_inner())
    return Problem{0, fmt::format("got {}; expected more than screw and two rollers, {}; enlarge "
                                  "the nut or make the rollers smaller",
                                  in_mm(d.nut_outer), in_mm(d.nut_inner()))};
  const double cosine = std::numbers::sqrt2 / 2.0;
  const double ratio = d.roller * cosine / d.nut_inner();
  if (geometry_factor(ratio)) return {};
  // d_r cos/d_n = q, d_n = d_s + 2 d_r; to whole micrometres within the range.
  const auto roller_at = [&](double limit) {
    return d.screw / (cosine / limit - 2.0) * per_si::micrometre;
  };
  return Problem{
      2, fmt::format("got {}, d_r cos(45 deg)/d_n = {:.4g}; expected 0.01 to 0.30, where Lemor's "
                     "geometry factor is known; with this screw take {:g} to {:g} mm",
                     in_mm(d.roller), ratio, std::ceil(roller_at(kFactorRatios.least)) * 1e-3,
                     std::floor(roller_at(kFactorRatios.greatest)) * 1e-3)};
}

/// A length, or a message what is wrong with its text.
struct ParsedLength {
  double value = 0.0;
  std::string message = {};
};
ParsedLength parse_length(std::string_view text) {
  const input::ParsedQuantity parsed = input::parse_quantity(text, input::unit::length);
  if (parsed.value) return {*parsed.value};
  return {0.0, fmt::format("got {}; expected a length; {}", input::shown(text),
                           parsed.hint.empty() ? "write for example 54 mm" : parsed.hint)};
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

Diameters read_text(const std::string& text) {
  const auto fail = [&](const std::string& message) {
    throw InputError(
        fmt::format("prs: error: --diameters \"{}\": {}", input::shown(text), message));
  };
  std::vector<std::string_view> fields;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    fields.push_back(trimmed(std::string_view(text).substr(from, to - from)));
    from = to + 1;
  }
  if (fields.size() != kGivenCount)
    fail(
        fmt::format("got {} values; expected 3, the diameters of nut (outer), screw and roller, "
                    "separated by commas; write for example --diameters \"{}\"",
                    fields.size(), kExample));
  Diameters d;
  for (std::size_t k = 0; k < kGivenCount; ++k) {
    const ParsedLength length = parse_length(fields[k]);
    if (!length.message.empty()) fail(fmt::format("{}: {}", kGiven[k].key, length.message));
    d.*kGiven[k].diameter = length.value;
  }
  if (const std::optional<Problem> problem = problem_of(d))
    fail(fmt::format("{}: {}", kGiven[problem->given].key, problem->message));
  return d;
}

std::string key_list() {
  return fmt::format("{}, {} and {}", kGiven[0].key, kGiven[1].key, kGiven[2].key);
}

std::optional<Diameters> read_row(const Node& row, ErrorList& errors) {
  if (row.kind != Node::Kind::map) {
    errors.add(row.place, row.key,
               fmt::format("expected a map of {}; write for example - {{nut_outer: 54 mm, screw: "
                           "27 mm, roller: 9 mm}}",
                           key_list()));
    return {};
  }
  for (const Node& child : row.children)
    if (std::ranges::find(kGiven, child.key, &Given::key) == std::end(kGiven))
      errors.add(child.key_place, child.key,
                 fmt::format("unknown key; expected one of {}", key_list()));
  Diameters d;
  std::array<const Node*, kGivenCount> nodes{};
  bool complete = true;
  for (std::size_t k = 0; k < kGivenCount; ++k) {
    nodes[k] = input::find(row, kGiven[k].key);
    std::string message = "missing; expected a length; write for example 54 mm";
    if (nodes[k] != nullptr) {
      const bool scalar = nodes[k]->kind == Node::Kind::scalar;
      ParsedLength length = parse_length(scalar ? nodes[k]->text : "");
      d.*kGiven[k].diameter = length.value;
      message = std::move(length.message);
    }
    if (message.empty()) continue;
    errors.add(nodes[k] != nullptr ? nodes[k]->place : row.place, kGiven[k].key, message);
    complete = false;
  }
  if (!complete) return {};
  if (const std::optional<Problem> problem = problem_of(d))
    errors.add(nodes[problem->given]->place, kGiven[problem->given].key, problem->message);
  return d;
}

std::vector<Diameters> read_yaml(const std::string& file) {
  const input::Source source = input::load_source(file, {});
  ErrorList errors(source);
  const Node root = input::read_document(source, errors);
  std::vector<Diameters> rows;
  const Node* list = input::find(root, "diameters");
  for (const Node& child : root.children)
    if (&child != list)
      errors.add(child.key_place, child.key, "unknown key; expected diameters and nothing else");
  if (list == nullptr || list->kind != Node::Kind::sequence || list->children.empty())
    errors.add(list != nullptr ? list->place : root.place, "diameters",
               fmt::format("expected a list of {}; write for example - {{nut_outer: 54 mm, screw: "
                           "27 mm, roller: 9 mm}}",
                           key_list()));
  else
    for (const Node& row : list->children)
      if (const std::optional<Diameters> d = read_row(row, errors)) rows.push_back(*d);
  errors.throw_if_any();
  return rows;
}

std::vector<Diameters> read_csv(const std::string& file) {
  const CsvTable table{file};
  std::array<std::size_t, kGivenCount> columns{};
  for (std::size_t k = 0; k < kGivenCount; ++k)
    columns[k] = table.column(fmt::format("{}_mm", kGiven[k].key));
  std::vector<Diameters> rows(table.rows());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t k = 0; k < kGivenCount; ++k)
      rows[row].*kGiven[k].diameter = table.number(row, columns[k]) / per_si::millimetre;
    if (const std::optional<Problem> problem = problem_of(rows[row]))
      table.fail(row, columns[problem->given], problem->message);
  }
  return rows;
}

/// A column as keys, headings and table 7.1 have it.
struct Column {
  const char* key;
  const char* heading;
  double factor;  ///< Shown = SI * factor.
  const char* format;
  double (*value)(const Diameters&, const Measures&);
};
constexpr Column kColumns[] = {
    {"nut_outer_mm", "D_n, mm", per_si::millimetre, "{:.10g}",
     [](const Diameters& d, const Measures&) { return d.nut_outer; }},
    {"screw_mm", "d_s, mm", per_si::millimetre, "{:.10g}",
     [](const Diameters& d, const Measures&) { return d.screw; }},
    {"roller_mm", "d_r, mm", per_si::millimetre, "{:.10g}",
     [](const Diameters& d, const Measures&) { return d.roller; }},
    {"nut_thickness_mm", "T, mm", per_si::millimetre, "{:.6g}",
     [](const Diameters&, const Measures& m) { return m.nut_thickness; }},
    {"volume_l", "V, l", 1e3, "{:.3f}",
     [](const Diameters&, const Measures& m) { return m.volume; }},
    {"stiffness_N_per_mm", "k, N/mm", 1e-3, "{:.6g}",
     [](const Diameters&, const Measures& m) { return m.stiffness; }},
    {"load_capacity_kN", "C_a, kN", per_si::kilonewton, "{:.3f}",
     [](const Diameters&, const Measures& m) { return m.load_capacity; }},
    {"weight_kg", "W, kg", 1.0, "{:.3f}",
     [](const Diameters&, const Measures& m) { return m.weight; }},
    {"force_density_kN_per_kg", "C_a/W, kN/kg", per_si::kilonewton, "{:.3f}",
     [](const Diameters&, const Measures& m) { return m.force_density(); }},
};

double shown(const Column& c, const Diameters& d, const Measures& m) {
  return c.factor * c.value(d, m);
}

}  // namespace

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = {
      {"jung-as-printed", as_printed,
       "Jung 2017, tables 7.1 and 7.2 as printed, slips included (their m^3 are litres)"},
      {"jung-corrected", corrected,
       "Jung 2017, columns of tables 7.1 and 7.2 by the right formulas"}};
  return all;
}

const Recipe* find_recipe(std::string_view name) {
  const auto found = std::ranges::find(recipes(), name, &Recipe::name);
  return found != recipes().end() ? &*found : nullptr;
}

std::vector<Diameters> read_diameters(const std::string& file,
                                      const std::vector<std::string>& texts) {
  std::vector<Diameters> rows;
  if (!file.empty()) rows = file.ends_with(".csv") ? read_csv(file) : read_yaml(file);
  for (const std::string& text : texts) rows.push_back(read_text(text));
  if (rows.empty())
    throw InputError(
        fmt::format("prs: error: --recipe: got no diameters; expected a file or --diameters; write "
                    "for example --diameters \"{}\", nut (outer), screw and roller",
                    kExample));
  return rows;
}

std::string recipe_text(const Recipe& recipe, const std::vector<Diameters>& rows) {
  std::vector<std::vector<std::string>> lines(1);
  for (const Column& c : kColumns) lines[0].emplace_back(c.heading);
  for (const Diameters& d : rows) {
    const Measures m = recipe.measures(d);
    std::vector<std::string>& line = lines.emplace_back();
    for (const Column& c : kColumns)
      line.push_back(fmt::format(fmt::runtime(c.format), shown(c, d, m)));
  }
  std::array<std::size_t, std::size(kColumns)> widths{};
  for (const auto& line : lines)
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], line[k].size());
  std::string text = fmt::format("{}: {}\n", recipe.name, recipe.title);
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k)
      text += fmt::format("  {:>{}}", line[k], widths[k]);
    text += '\n';
  }
  return text;
}

std::string recipe_csv(const Recipe& recipe, const std::vector<Diameters>& rows,
                       const CsvStyle& style) {
  CsvWriter csv(style);
  for (const Column& c : kColumns) csv.text(c.key);
  csv.end_row();
  for (const Diameters& d : rows) {
    const Measures m = recipe.measures(d);
    for (const Column& c : kColumns) csv.number(c.value(d, m), c.factor);
    csv.end_row();
  }
  return csv.take();
}

Json row_json(const Recipe& recipe, const Diameters& d) {
  const Measures m = recipe.measures(d);
  Json row = Json::object();
  for (const Column& c : kColumns) row[c.key] = shown(c, d, m);
  return row;
}

Json recipe_json(const Recipe& recipe, const std::vector<Diameters>& rows,
                 const DocumentInfo& info) {
  Json document = document_head(info, {});
  document["recipe"] = recipe.name;
  document["rows"] = Json::array();
  for (const Diameters& d : rows) document["rows"].push_back(row_json(recipe, d));
  return document;
}

}  // namespace prs::jung_2017
