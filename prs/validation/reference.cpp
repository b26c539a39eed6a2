#include "prs/validation/reference.h"

#include <cmath>
#include <cstdlib>

#include "prs/input/document.h"

namespace prs {
namespace {

using input::ErrorList;
using input::Node;

std::string text_of(const Node& map, std::string_view key, bool required, ErrorList& errors) {
  const Node* node = input::find(map, key);
  if (node != nullptr && node->kind == Node::Kind::scalar) return node->text;
  if (node != nullptr || required)
    errors.add(node != nullptr ? node->place : map.place, key, "expected a text");
  return {};
}

/// Decimal exponent of the last printed digit: 3.6062e5 -> 1.
int last_place(const std::string& printed) {
  const std::size_t exponent_at = printed.find_first_of("eE");
  const int exponent =
      exponent_at == std::string::npos ? 0 : std::atoi(printed.c_str() + exponent_at + 1);
  const std::string mantissa = printed.substr(0, exponent_at);
  const std::size_t point = mantissa.find('.');
  const auto decimals =
      point == std::string::npos ? 0 : static_cast<int>(mantissa.size() - point - 1);
  return exponent - decimals;
}

}  // namespace

double PrintedValue::value() const { return std::strtod(printed.c_str(), nullptr); }

double PrintedValue::half_unit() const { return 0.5 * std::pow(10.0, last_place(printed)); }

Reference read_reference(const std::filesystem::path& file) {
  const input::Source source = input::load_source(file.string(), {});
  ErrorList errors(source);
  const Node root = input::read_document(source, errors);
  Reference reference;
  reference.source = text_of(root, "source", true, errors);
  reference.case_file = file.parent_path() / text_of(root, "case", true, errors);
  if (const Node* values = input::find(root, "values"))
    for (const Node& item : values->children) {
      PrintedValue value{
          text_of(item, "quantity", true, errors), text_of(item, "where", true, errors),
          text_of(item, "printed", true, errors), text_of(item, "differs", false, errors)};
      if (!std::isfinite(value.value()) || value.printed.empty())
        errors.add(item.place, "printed", "expected a number");
      reference.values.push_back(std::move(value));
    }
  errors.throw_if_any();
  return reference;
}

}  // namespace prs
