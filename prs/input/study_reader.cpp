#include "prs/input/study_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prs/input/reader.h"
#include "prs/input/units.h"
#include "prs/input/value_text.h"

namespace prs::input {

namespace {

/// A level as the document has it.
struct WrittenLevel {
  Node value;
  Level level;
};

Node scalar(std::string text, Place place) {
  return {.kind = Node::Kind::scalar, .text = std::move(text), .place = place};
}

bool stands_in(const Node& node, Place place) {
  return node.place == place || std::ranges::any_of(node.children, [&](const Node& child) {
           return child.key_place == place || stands_in(child, place);
         });
}

/// Curvature of a profile [1/mm], convex > 0: `straight`, `{convex: 6 mm}`, `{concave: 60 mm}`.
std::optional<double> profile_curvature(const Node& value) {
  if (value.kind == Node::Kind::scalar && value.text == "straight") return 0.0;
  if (value.kind != Node::Kind::map || value.children.size() != 1) return std::nullopt;
  const Node& radius = value.children[0];
  const std::optional<double> r = number_in(radius.text, "mm");
  if (!r || *r == 0.0 || (radius.key != "convex" && radius.key != "concave")) return std::nullopt;
  return (radius.key == "convex" ? 1.0 : -1.0) / *r;
}

/// Reads the factors of one study.
class FactorReader {
 public:
  FactorReader(const Node& root, const std::vector<EchoEntry>& fields, ErrorList& errors)
      : root_(root), fields_(fields), errors_(errors) {}

  Factor read(const FactorItem& item, std::size_t index) {
    path_ = fmt::format("study.factors[{}]", index);
    const Node& values = *find_path(root_, path_ + ".values");
    std::vector<WrittenLevel> levels =
        item.values.range ? range_levels(*item.values.range, values) : list_levels(values);
    Factor factor;
    factor.path = item.path;
    factor.label = item.label.value_or(item.path);
    factor.logarithmic =
        item.values.range && item.values.range->spacing == WrittenRange::Spacing::logarithmic;
    std::optional<WrittenLevel> base = base_level(item.path);
    place_on_axis(levels, base, factor.unit);
    for (const WrittenLevel& level : levels) factor.levels.push_back(level.level);
    if (base) factor.base = base->level;
    return factor;
  }

  /// Adds what is wrong with the levels of a factor in their place.
  void check_levels(const FactorItem& item, std::size_t index, const Source& source,
                    const Node& base) {
    path_ = fmt::format("study.factors[{}]", index);
    const Place at = locate(root_, path_ + ".path");
    const Node& values = *find_path(root_, path_ + ".values");
    if (item.path == "study" || item.path.starts_with("study."))
      return errors_.add(at, path_ + ".path",
                         fmt::format("got {}; expected a value outside the study; write for "
                                     "example `path: mechanism.rollers`",
                                     shown(item.path)));
    const std::vector<WrittenLevel> levels =
        item.values.range ? range_levels(*item.values.range, values) : list_levels(values);
    for (const WrittenLevel& level : levels) {
      ErrorList found(source);
      Node design = base;
      if (set_value(design, item.path, level.value, at, found)) read_case_file(design, found);
      errors_.take(found, [&](Place place) {
        return place == at || stands_in(level.value, place) ? place : level.value.place;
      });
    }
  }

  /// Whether the ends of a range go together.
  bool check_range(const WrittenRange& range, std::size_t index) {
    path_ = fmt::format("study.factors[{}].values", index);
    const auto refuse = [&](const char* key, const std::string& message) {
      const std::string path = fmt::format("{}.{}", path_, key);
      errors_.add(locate(root_, path), path, message);
      return false;
    };
    const std::optional<NumberAndUnit> from = split_unit(range.from), to = split_unit(range.to);
    if (!from || !to)
      return refuse(from ? "to" : "from",
                    fmt::format("got {}; expected a number with its unit as in the file; of words "
                                "write a list `values: [.., ..]`",
                                shown(from ? range.to : range.from)));
    if (from->unit != to->unit)
      return refuse("to",
                    fmt::format("got {}; expected the unit of `from`, {}; write both ends in "
                                "the same unit",
                                shown(range.to), from->unit.empty() ? "none" : shown(from->unit)));
    if (from->number == to->number)
      return refuse("to", fmt::format("got {}; expected another value than that of `from`; write a "
                                      "list for a single value",
                                      shown(range.to)));
    if (range.spacing == WrittenRange::Spacing::logarithmic && !(from->number * to->number > 0.0))
      return refuse("spacing", fmt::format("got logarithmic from {} to {}; expected ends of one "
                                           "sign, neither of them 0; write `spacing: linear`",
                                           shown(range.from), shown(range.to)));
    return true;
  }

 private:
  static std::vector<WrittenLevel> list_levels(const Node& values) {
    std::vector<WrittenLevel> levels;
    for (const Node& value : values.children)
      levels.push_back({value, {flow_text(value), std::nullopt}});
    return levels;
  }

  /// The ends as they are written, points between them with 15 digits.
  static std::vector<WrittenLevel> range_levels(const WrittenRange& range, const Node& values) {
    const NumberAndUnit from = *split_unit(range.from), to = *split_unit(range.to);
    const bool logarithmic = range.spacing == WrittenRange::Spacing::logarithmic;
    const int last = range.steps - 1;
    const auto text_at = [&](int k) {
      if (k == 0 || k == last) return k == 0 ? range.from : range.to;
      const double share = static_cast<double>(k) / last;
      const double number = logarithmic ? from.number * std::pow(to.number / from.number, share)
                                        : from.number + (to.number - from.number) * share;
      return fmt::format("{:.15g}{}{}", number, from.unit.empty() ? "" : " ", from.unit);
    };
    std::vector<WrittenLevel> levels;
    for (int k = 0; k <= last; ++k) {
      const Place place = k == 0      ? find(values, "from")->place
                          : k == last ? find(values, "to")->place
                                      : values.place;
      levels.push_back({scalar(text_at(k), place), {text_at(k), std::nullopt}});
    }
    return levels;
  }

  /// What the file says of a path, or the default.
  std::optional<WrittenLevel> base_level(const std::string& path) const {
    if (const Node* node = find_path(root_, path))
      return WrittenLevel{*node, {flow_text(*node), {}}};
    const auto entry = std::ranges::find(fields_, path, &EchoEntry::path);
    if (entry == fields_.end()) return std::nullopt;
    return WrittenLevel{scalar(entry->value, {}), {entry->value, {}}};
  }

  /// Numbers in the unit of the first level, or curvatures of profiles.
  static void place_on_axis(std::vector<WrittenLevel>& levels, std::optional<WrittenLevel>& base,
                            std::string& unit) {
    const std::optional<NumberAndUnit> first = split_unit(levels[0].level.text);
    unit = first ? std::string(first->unit) : "1/mm";
    const auto place = [&](WrittenLevel& level) {
      level.level.number =
          first ? number_in(level.level.text, unit) : profile_curvature(level.value);
    };
    std::ranges::for_each(levels, place);
    if (base) place(*base);
    const auto has_number = [](const WrittenLevel& level) {
      return level.level.number.has_value();
    };
    if (!std::ranges::any_of(levels, has_number)) unit.clear();
  }

  const Node& root_;
  const std::vector<EchoEntry>& fields_;
  ErrorList& errors_;
  std::string path_;
};

std::size_t number_of_levels(const std::vector<FactorItem>& items) {
  std::size_t count = 0;
  for (const FactorItem& item : items)
    count += item.values.range ? static_cast<std::size_t>(item.values.range->steps)
                               : item.values.list.size();
  return count;
}

void check_factors(const StudyItem& item, const Node& root, ErrorList& errors) {
  if (number_of_levels(item.factors) >= kMostDesigns)
    errors.add(locate(root, "study.factors"), "study.factors",
               fmt::format("got {} values; expected fewer than {}; write ranges with fewer steps",
                           number_of_levels(item.factors), kMostDesigns));
  for (std::size_t i = 0; i < item.factors.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (item.factors[k].path == item.factors[i].path) {
        const std::string path = fmt::format("study.factors[{}].path", i);
        errors.add(locate(root, path), path,
                   fmt::format("got {} a second time; expected each path once; put all its values "
                               "into one factor",
                               shown(item.factors[i].path)));
      }
}

StudyItem written_study(const CaseFile& file, const Node& root, ErrorList& errors) {
  if (!file.study && !find(root, "study"))
    errors.add(root.place, "study",
               "missing; expected what to vary; add for example `study: {command: slip, factors: "
               "[{path: mechanism.rollers, values: [8, 9, 10]}]}`");
  errors.throw_if_any();
  return *file.study;
}

}  // namespace

StudyInput read_study_input(const Source& source) {
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  const CaseFile file = read_case_file(root, errors);
  const StudyItem item = written_study(file, root, errors);
  checked_case(file, root, item.command, errors);
  check_factors(item, root, errors);
  errors.throw_if_any();

  const std::vector<EchoEntry> fields = echo(file, root);
  FactorReader reader(root, fields, errors);
  for (std::size_t i = 0; i < item.factors.size(); ++i)
    if (item.factors[i].values.range) reader.check_range(*item.factors[i].values.range, i);
  errors.throw_if_any();

  StudyInput input{source, root, {}};
  std::erase_if(input.base.children, [](const Node& child) { return child.key == "study"; });
  input.study.command = item.command;
  input.study.plan = item.plan;
  input.study.responses = item.responses.value_or(std::vector<std::string>{});
  for (std::size_t i = 0; i < item.factors.size(); ++i) {
    input.study.factors.push_back(reader.read(item.factors[i], i));
    reader.check_levels(item.factors[i], i, source, input.base);
  }
  errors.throw_if_any();
  return input;
}

Case read_design(const StudyInput& input, const std::vector<std::string>& overrides) {
  Source source = input.source;
  source.overrides.insert(source.overrides.end(), overrides.begin(), overrides.end());
  ErrorList errors(source);
  Node root = input.base;
  for (std::size_t k = input.source.overrides.size(); k < source.overrides.size(); ++k)
    apply_override(root, source, k, errors);
  const CaseFile file = read_case_file(root, errors);
  if (errors.empty()) {
    Case values = checked_case(file, root, input.study.command, errors);
    if (errors.empty()) return values;
  }
  throw InputError(errors.first());
}

}  // namespace prs::input
