#include "prs/validation/reference.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "prs/input/document.h"
#include "prs/input/units.h"

namespace prs {
namespace {

using input::ErrorList;
using input::Node;
using input::parse_number;
using Keys = std::initializer_list<std::string_view>;

constexpr int kMostDecimals = 15;

/// A map that has no other keys than these; missing ones are told of when they are asked for.
bool is_map_of(const Node& node, Keys known, ErrorList& errors) {
  if (node.kind != Node::Kind::map) {
    errors.add(node.place, node.key, "expected a map of {}", fmt::join(known, ", "));
    return false;
  }
  for (const Node& child : node.children)
    if (std::find(known.begin(), known.end(), child.key) == known.end())
      errors.add(child.key_place, child.key, "unknown key; expected one of {}",
                 fmt::join(known, ", "));
  return true;
}

std::string optional_text(const Node& map, std::string_view key, ErrorList& errors) {
  const Node* node = input::find(map, key);
  if (node == nullptr) return {};
  if (node->kind == Node::Kind::scalar && !node->text.empty()) return node->text;
  errors.add(node->place, key, "expected a text");
  return {};
}

std::string required_text(const Node& map, std::string_view key, ErrorList& errors) {
  if (input::find(map, key) == nullptr) errors.add(map.place, key, "missing; expected a text");
  return optional_text(map, key, errors);
}

/// The items of a list, which must stand and hold something.
const std::vector<Node>& required_list(const Node& map, std::string_view key, ErrorList& errors) {
  static const std::vector<Node> none;
  const Node* list = input::find(map, key);
  if (list != nullptr && list->kind == Node::Kind::sequence && !list->children.empty())
    return list->children;
  errors.add(list != nullptr ? list->place : map.place, key, "expected a list");
  return none;
}

PrintedNumber printed_number(const Node& map, std::string_view key, ErrorList& errors) {
  PrintedNumber number{required_text(map, key, errors), {}};
  if (!number.text.empty() && !parse_number(number.text))
    errors.add(input::find(map, key)->place, key, "got {}; expected a number",
               input::shown(number.text));
  return number;
}

/// `{decimals: 4, because: ..}`: a precision other than the last digit's needs a reason.
std::optional<int> stated_decimals(const Node& map, ErrorList& errors) {
  const Node* precision = input::find(map, "precision");
  if (precision == nullptr || !is_map_of(*precision, {"decimals", "because"}, errors)) return {};
  required_text(*precision, "because", errors);
  const std::optional<double> decimals =
      parse_number(required_text(*precision, "decimals", errors));
  if (decimals && *decimals >= 0.0 && *decimals <= kMostDecimals &&
      *decimals == std::floor(*decimals))
    return static_cast<int>(*decimals);
  errors.add(precision->place, "decimals", "expected a whole number from 0 to {}", kMostDecimals);
  return {};
}

PrintedValue read_value(const Node& node, ErrorList& errors) {
  PrintedValue value;
  if (!is_map_of(node, {"quantity", "where", "printed", "precision", "differs", "corrected"},
                 errors))
    return value;
  value.quantity = required_text(node, "quantity", errors);
  value.where = required_text(node, "where", errors);
  value.printed = printed_number(node, "printed", errors);
  value.printed.decimals = stated_decimals(node, errors);
  value.differs = optional_text(node, "differs", errors);
  if (const Node* corrected = input::find(node, "corrected")) {
    value.corrected = printed_number(node, "corrected", errors);
    if (value.differs.empty())
      errors.add(corrected->key_place, "corrected", "expected `differs` next to it: say why");
  }
  return value;
}

Command read_command(const Node& node, ErrorList& errors) {
  const std::string command = optional_text(node, "command", errors);
  if (command == "contact") return Command::contact;
  if (command == "slip") return Command::slip;
  if (!command.empty() && command != "solve")
    errors.add(input::find(node, "command")->place, "command",
               "got {}; expected solve | contact | slip", input::shown(command));
  return Command::solve;
}

ReferenceCase read_case(const Node& node, const std::filesystem::path& folder, ErrorList& errors) {
  ReferenceCase c;
  if (input::find(node, "formulas") != nullptr) {
    if (!is_map_of(node, {"formulas", "values"}, errors)) return c;
    c.formulas = required_text(node, "formulas", errors);
  } else {
    if (!is_map_of(node, {"case", "command", "values"}, errors)) return c;
    c.file = folder / required_text(node, "case", errors);
    c.command = read_command(node, errors);
  }
  for (const Node& value : required_list(node, "values", errors))
    c.values.push_back(read_value(value, errors));
  return c;
}

PrintedStatement read_statement(const Node& node, ErrorList& errors) {
  if (!is_map_of(node, {"section", "text", "check", "why"}, errors)) return {};
  return {required_text(node, "section", errors), required_text(node, "text", errors),
          required_text(node, "check", errors), optional_text(node, "why", errors)};
}

}  // namespace

double PrintedNumber::value() const { return parse_number(text).value_or(0.0); }

/// Decimal exponent of the last known digit: 3.6062e5 -> 1.
int PrintedNumber::last_place() const {
  if (decimals) return -*decimals;
  const std::size_t exponent_at = text.find_first_of("eE");
  int exponent = 0;
  if (exponent_at != std::string::npos)
    exponent = static_cast<int>(parse_number(text.substr(exponent_at + 1)).value_or(0.0));
  const std::string mantissa = text.substr(0, exponent_at);
  const std::size_t point = mantissa.find('.');
  if (point == std::string::npos) return exponent;
  return exponent - static_cast<int>(mantissa.size() - point - 1);
}

double PrintedNumber::half_unit() const { return 0.5 * std::pow(10.0, last_place()); }

bool PrintedNumber::is_reproduced_by(double computed) const {
  // A printed digit is rounded from a computation of unknown rounding: one part in 1e9 of slack.
  return std::abs(computed - value()) <= half_unit() * (1.0 + 1e-9);
}

int PrintedNumber::digits() const {
  const double size = std::abs(value());
  const int first_place = size > 0.0 ? static_cast<int>(std::floor(std::log10(size))) : -1;
  return std::max(first_place - last_place() + 1, 0);
}

int PrintedNumber::agreeing_digits(double computed) const {
  if (is_reproduced_by(computed)) return digits();
  const double off = std::abs(computed - value()) / half_unit();
  return std::max(digits() - static_cast<int>(std::ceil(std::log10(off))), 0);
}

Reference read_reference(const std::filesystem::path& file) {
  const input::Source source = input::load_source(file.string(), {});
  ErrorList errors(source);
  const Node root = input::read_document(source, errors);
  Reference reference{.folder = file.parent_path()};
  if (is_map_of(root, {"source", "cases", "statements"}, errors)) {
    reference.source = required_text(root, "source", errors);
    for (const Node& c : required_list(root, "cases", errors))
      reference.cases.push_back(read_case(c, reference.folder, errors));
    if (input::find(root, "statements") != nullptr)
      for (const Node& s : required_list(root, "statements", errors))
        reference.statements.push_back(read_statement(s, errors));
  }
  errors.throw_if_any();
  return reference;
}

}  // namespace prs
