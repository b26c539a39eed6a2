#include "prs/input/varied_input.h"

#include <algorithm>

#include "prs/input/case_file.h"
#include "prs/input/reader.h"

namespace prs::input {

Node scalar(std::string text, Place place) {
  return {.kind = Node::Kind::scalar, .text = std::move(text), .place = place};
}

void take_indices(const Node& root, std::string& path, std::optional<std::string>& label) {
  std::string indexed = with_indices(root, path);
  if (indexed != path && !label) label = path;
  path = std::move(indexed);
}

bool is_part_of(std::string_view path, std::string_view whole) {
  return path.size() > whole.size() && path.starts_with(whole) &&
         (path[whole.size()] == '.' || path[whole.size()] == '[');
}

void check_paths(const std::vector<SetPath>& paths, std::string_view noun, bool one_at_a_time,
                 const Node& root, ErrorList& errors) {
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const SetPath &own = paths[i], &other = paths[k];
      const bool together = own.factor == other.factor || !one_at_a_time;
      if (other.path == own.path && (together || (!own.companion && !other.companion)))
        refuse(root, own.at,
               fmt::format("got {} a second time; expected each path once; put all its values into "
                           "one {}",
                           shown(own.path), noun),
               errors);
      else if (together && (is_part_of(own.path, other.path) || is_part_of(other.path, own.path)))
        refuse(root, own.at,
               fmt::format("got {} as well as {}; expected {}s of which none is a part of another; "
                           "delete one of them",
                           shown(own.path), shown(other.path), noun),
               errors);
    }
}

void VariedInput::refuse_at(std::string_view key, std::string_view message) const {
  refuse(root_, fmt::format("{}.{}", path_, key), message, errors_);
}

bool VariedInput::check_outside(std::string_view key, std::string_view path) const {
  for (const std::string_view block : {"study", "optimize"})
    if (path == block || is_part_of(path, block)) {
      refuse_at(key, fmt::format("got {}; expected a value outside `{}`; write for example `path: "
                                 "mechanism.rollers`",
                                 shown(path), block));
      return false;
    }
  return true;
}

std::optional<Node> VariedInput::base_value(std::string_view path,
                                            const std::vector<EchoEntry>& fields) const {
  if (const Node* node = find_path(base_, path)) return *node;
  const auto entry = std::ranges::find(fields, path, &EchoEntry::path);
  return entry == fields.end() ? std::nullopt : std::optional(scalar(entry->value, {}));
}

bool VariedInput::check_in_place(const std::string& path, const Node& value) const {
  const Place at = locate(root_, path_ + ".path");
  ErrorList found(source_);
  Node design = base_;
  if (set_value(design, path, value, at, found)) read_case_file(design, found);
  errors_.take(found, [&](Place place) {
    return place == at || stands_in(value, place) ? place : value.place;
  });
  return found.empty();
}

std::optional<VariedInput::Ends> VariedInput::read_ends(std::string_view prefix,
                                                        std::string_view written_from,
                                                        std::string_view written_to,
                                                        bool ascending) const {
  const auto refuse = [&](std::string_view key, std::string_view message) {
    refuse_at(fmt::format("{}{}", prefix, key), message);
    return std::nullopt;
  };
  const std::optional<NumberAndUnit> from = split_unit(written_from), to = split_unit(written_to);
  if (!from || !to)
    return refuse(from ? "to" : "from",
                  fmt::format("got {}; expected a number with its unit as in the file; of words "
                              "write a list `values: [.., ..]`",
                              shown(from ? written_to : written_from)));
  if (!from->unit.empty() && !is_unit(from->unit) && from->unit != to->unit)
    return refuse("from", fmt::format("got {}; expected a number with its unit; `{}` is not a "
                                      "known unit; write both ends in the same unit",
                                      shown(written_from), from->unit));
  if (from->unit != to->unit)
    return refuse(
        "to", fmt::format("got {}; expected the unit of `from`, {}; write both ends in the same "
                          "unit",
                          shown(written_to), from->unit.empty() ? "none" : shown(from->unit)));
  if (from->number == to->number)
    return refuse("to", fmt::format("got {}; expected another value than that of `from`; write a "
                                    "list for a single value",
                                    shown(written_to)));
  if (ascending && from->number > to->number)
    return refuse("to", fmt::format("got {}; expected more than `from`, {}; swap the two",
                                    shown(written_to), shown(written_from)));
  return Ends{*from, *to};
}

}  // namespace prs::input
