#include "prs/input/reader.h"

#include <algorithm>
#include <charconv>
#include <numeric>

#include "prs/indices.h"
#include "prs/input/described_file.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/schema.h"
#include "prs/model/check_case.h"

namespace prs::input {
namespace {

constexpr std::size_t kMostLoadCases = 100'000;

// Words of messages -----------------------------------------------------------------------------

std::string got(const Node& node) {
  switch (node.kind) {
    case Node::Kind::null:
      return "nothing";
    case Node::Kind::sequence:
      return fmt::format("a list of {}", node.children.size());
    case Node::Kind::map:
      return node.children.size() == 1 ? fmt::format("{{{}: ..}}", shown(node.children[0].key)) : "a map";
    case Node::Kind::scalar:
      break;
  }
  return node.quoted ? fmt::format("\"{}\"", shown(node.text)) : shown(node.text);
}

/// Description of a valid value, and an example.
struct Wanted {
  std::string what;
  std::string example;
};

Wanted wanted(const Value& value);

/// The example if it is admissible, else the middle of the bounds.
Wanted wanted(const Quantity& q) {
  std::string example(q.example.empty() ? q.dimension.example : q.example);
  const std::optional<double> usual = parse_quantity(example, q.dimension).value;
  const double middle = 0.5 * (q.bounds.least + q.bounds.greatest);
  if (!(usual && q.bounds.contain(*usual)) && std::isfinite(middle)) example = format_quantity(middle, q.dimension);
  return {fmt::format("{}{} with its unit", q.dimension.name, text_of_bounds(q.bounds, q)), example};
}
Wanted wanted(const EitherQuantity& kind) {
  const Wanted first = wanted(kind.first), second = wanted(kind.second);
  return {fmt::format("{} or {}", first.what, second.what), first.example};
}
Wanted wanted(const Held& h) {
  return {fmt::format("rigid{} or {}{} with its unit", h.may_be_free ? ", free" : "", h.dimension.name,
                      text_of_bounds(h.least, Quantity{h.dimension, h.least})),
          std::string(h.dimension.example)};
}
Wanted wanted(const Number& n) {
  const double middle = 0.5 * (n.bounds.least + n.bounds.greatest);
  const bool usual = n.bounds.contain(*parse_number(n.example)) || !std::isfinite(middle);
  return {fmt::format("a number{}", text_of_bounds(n.bounds, n)),
          usual ? std::string(n.example) : fmt::format("{:g}", middle)};
}
Wanted wanted(const Whole& w) {
  return {fmt::format("a whole number from {} to {}{}{}", w.least, w.greatest, w.reason.empty() ? "" : ", ", w.reason),
          fmt::format("{}", std::clamp<std::int64_t>(3, w.least, w.greatest))};
}
Wanted wanted(const Flag&) { return {"true or false", "true"}; }
Wanted wanted(const Text& kind) {
  return {fmt::format("a line of 1 to {} characters", kLongestText), std::string(kind.example)};
}
Wanted wanted(const Verbatim& kind) { return {"a value", std::string(kind.example)}; }

template <class Kind, class T>
Wanted wanted(const Leaf<Kind, T>& leaf) {
  return wanted(leaf.kind);
}

/// Names of the alternatives of a choice.
struct ChoiceNames {
  std::vector<std::string_view> words, keys;

  explicit ChoiceNames(const ChoiceValue& choice) {
    for (const Alternative& a : choice.alternatives()) (a.content ? keys : words).push_back(a.name);
  }
};

Wanted wanted(const ChoiceValue& choice) {
  const ChoiceNames names(choice);
  std::string what = fmt::format("{}", fmt::join(names.words, " | "));
  for (std::string_view key : names.keys) what += fmt::format(" | {{{}: ..}}", key);
  if (!choice.command.empty()) what = fmt::format("a name that `{}` shows", choice.command);
  return {what, std::string(names.words[0])};
}
Wanted wanted(const ChoiceUnderKey& under) {
  const ChoiceNames names(under.choice);
  std::string what;
  for (std::string_view word : names.words)
    what += fmt::format("{}{{{}: {}}}", what.empty() ? "" : " | ", under.key, word);
  for (std::string_view key : names.keys) what += fmt::format(" | {{{}: ..}}", key);
  return {what, fmt::format("{{{}: {}}}", under.key, wanted(under.choice).example)};
}

/// The required keys, as an example.
Wanted wanted(const MapValue& map) {
  if (!map.example.empty()) return {"a map", std::string(map.example)};
  std::string keys;
  map.for_each([&](const Field& field) {
    if (field.presence.required) keys += fmt::format("{}{}: ..", keys.empty() ? "" : ", ", field.key);
  });
  return {"a map", fmt::format("{{{}}}", keys)};
}

Wanted wanted(const ListValue& list) {
  std::string what = "a list";
  if (list.least == list.greatest)
    what += fmt::format(" of {}", list.least);
  else if (list.greatest < std::numeric_limits<int>::max())
    what += fmt::format(" of {} to {}", list.least, list.greatest);
  else if (list.least > 0)
    what += fmt::format(" of at least {}", list.least);
  const Wanted entry = sample_entry(list, [](const Value& v) { return wanted(v); });
  const std::vector<std::string> examples(static_cast<std::size_t>(std::max(1, list.least)), entry.example);
  return {what, fmt::format("[{}]", fmt::join(examples, ", "))};
}

Wanted wanted(const OneOr& value) {
  if (value.form == OneOr::Form::levels)
    return {"a list of at least 1 value, or a range {from, to, steps, spacing}", "[20 mm, 30 mm]"};
  const Wanted one = wanted(value.one());
  return {one.what + value.others, one.example};
}

Wanted wanted(const Value& value) {
  return std::visit([](const auto& v) { return wanted(v); }, value.as);
}

// Reading ---------------------------------------------------------------------------------------

/// One value of the document and its key path.
struct Written {
  const Node& node;
  std::string path;
  ErrorList& errors;

  /// Adds an error: what was expected, and how to fix the value, by an example if there is no better hint.
  void refuse(const Wanted& w, std::string_view hint = {}) const {
    errors.add(node.place, path, "got {}; expected {}; {}", got(node), w.what,
               hint.empty() ? "write " + example(path, w) : hint);
  }

  static std::string example(std::string_view path, const Wanted& w) {
    const std::string_view key = path.substr(path.rfind('.') + 1);
    if (key.empty() || key.ends_with(']')) return fmt::format("for example `{}`", w.example);
    return fmt::format("for example `{}: {}`", key, w.example);
  }
};

std::string join(std::string_view path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

/// Whether a share was written as a fraction that is out of bounds in per cent too, so that another unit does not fix
/// it.
bool is_wrong_fraction(const std::string& text, const Quantity& q) {
  const std::optional<double> bare = &q.dimension == &unit::share ? parse_number(text) : std::nullopt;
  return bare && *bare <= 1.0 && !q.bounds.contain(*bare);
}

void read(const Written& w, const Value& value);

void read(const Written& w, double& value, const Quantity& q) {
  if (w.node.kind != Node::Kind::scalar || is_wrong_fraction(w.node.text, q)) return w.refuse(wanted(q));
  const ParsedQuantity parsed = parse_quantity(w.node.text, q.dimension, q.example);
  if (!parsed.value || !q.bounds.contain(*parsed.value)) return w.refuse(wanted(q), parsed.hint);
  value = *parsed.value;
}

void read(const Written& w, LeastLife& life, const EitherQuantity& kind) {
  const auto taken = [&](const Quantity& q, std::optional<double>& into) {
    const ParsedQuantity parsed = parse_quantity(w.node.text, q.dimension);
    if (parsed.value && q.bounds.contain(*parsed.value)) into = parsed.value;
    return into.has_value();
  };
  if (w.node.kind != Node::Kind::scalar || (!taken(kind.first, life.duration) && !taken(kind.second, life.travel)))
    w.refuse(wanted(kind));
}

void read(const Written& w, double& value, const Held& held) {
  if (w.node.kind != Node::Kind::scalar) return w.refuse(wanted(held));
  if (w.node.text == "rigid" || (held.may_be_free && w.node.text == "free")) {
    value = w.node.text == "rigid" ? kRigid : 0.0;
    return;
  }
  const ParsedQuantity parsed = parse_quantity(w.node.text, held.dimension);
  if (!parsed.value || !held.least.contain(*parsed.value)) return w.refuse(wanted(held), parsed.hint);
  value = *parsed.value;
}

/// How to fix a number or a flag in quotes.
std::string_view quotes_hint(const Node& node) {
  const bool is_text = scalar_type({.kind = node.kind, .text = node.text}) == ScalarType::text;
  return node.quoted && !is_text ? "write it without quotes" : "";
}

void read(const Written& w, double& value, const Number& number) {
  const bool plain = w.node.kind == Node::Kind::scalar && !w.node.quoted;
  const std::optional<double> parsed = plain ? parse_number(w.node.text) : std::nullopt;
  if (!parsed || !number.bounds.contain(*parsed)) return w.refuse(wanted(number), quotes_hint(w.node));
  value = *parsed;
}

template <std::signed_integral T>
void read(const Written& w, T& value, const Whole& whole) {
  const std::string& text = w.node.text;
  const char* end = text.data() + text.size();
  T parsed = 0;
  const auto [stop, error] = std::from_chars(text.data() + (text.starts_with('+') ? 1 : 0), end, parsed);
  const bool plain = w.node.kind == Node::Kind::scalar && !w.node.quoted && !text.starts_with("+-");
  if (!plain || error != std::errc{} || stop != end || parsed < whole.least || parsed > whole.greatest)
    return w.refuse(wanted(whole), quotes_hint(w.node));
  value = parsed;
}

void read(const Written& w, bool& value, const Flag& flag) {
  if (w.node.kind != Node::Kind::scalar || scalar_type(w.node) != ScalarType::boolean)
    return w.refuse(wanted(flag), quotes_hint(w.node));
  value = w.node.text[0] == 't' || w.node.text[0] == 'T';
}

void read(const Written& w, std::string& value, const Text& text) {
  const auto is_control = [](char c) { return c >= 0 && c < ' '; };
  if (w.node.kind != Node::Kind::scalar || w.node.text.empty() || w.node.text.size() > kLongestText ||
      std::ranges::any_of(w.node.text, is_control))
    return w.refuse(wanted(text));
  if (scalar_type(w.node) != ScalarType::text)
    return w.refuse(wanted(text), fmt::format("put it in quotes: \"{}\"", w.node.text));
  value = w.node.text;
}

void read(const Written& w, std::string& value, const Verbatim& kind) {
  if (w.node.kind == Node::Kind::null) return w.refuse(wanted(kind));
  value = flow_text(w.node);
}

template <class Kind, class T>
void read(const Written& w, const Leaf<Kind, T>& leaf) {
  read(w, leaf.value, leaf.kind);
}

/// `ISO VG 100` -> `iso-vg-100`
std::string spelled_as_a_name(std::string_view text) {
  std::string name;
  for (const char c : text) name += c == ' ' || c == '_' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return name;
}

void read(const Written& w, const MapValue& map);

void read(const Written& w, const ChoiceValue& choice) {
  const bool is_word = w.node.kind == Node::Kind::scalar;
  const bool is_key = w.node.kind == Node::Kind::map && w.node.children.size() == 1;
  for (const Alternative& a : choice.alternatives()) {
    if (a.map && w.node.kind == Node::Kind::map && find(w.node, a.name)) {
      a.choose();
      return read(w, a.map());
    }
    if (a.content ? !is_key || w.node.children[0].key != a.name : !is_word || w.node.text != a.name) continue;
    a.choose();
    if (a.content) read({w.node.children[0], join(w.path, a.name), w.errors}, a.content());
    return;
  }
  const ChoiceNames names(choice);
  std::string hint;
  if (is_word && !choice.command.empty())
    hint = did_you_mean(spelled_as_a_name(w.node.text), names.words);
  else if (is_word)
    hint = std::ranges::count(names.keys, w.node.text) > 0 ? "the value is missing"
                                                           : did_you_mean(w.node.text, names.words);
  else if (is_key && !names.keys.empty())
    hint = did_you_mean(w.node.children[0].key, names.keys);
  w.refuse(wanted(choice), hint);
}

/// Refuses a map that names two alternatives, or one together with the key that chooses.
bool refuse_second_choice(const Written& w, const ChoiceUnderKey& under) {
  const ChoiceNames names(under.choice);
  const Node* first = nullptr;
  for (const Node& child : w.node.children) {
    const auto is = [&](std::string_view name) { return name == child.key; };
    if (!is(under.key) && std::ranges::none_of(names.words, is) && std::ranges::none_of(names.keys, is)) continue;
    if (first) {
      w.errors.add(child.key_place, join(w.path, child.key),
                   "stands next to `{}`; expected one of {}; delete one of the two", first->key,
                   wanted(under.choice).what);
      return true;
    }
    first = &child;
  }
  return false;
}

void read(const Written& w, const ChoiceUnderKey& under) {
  const bool bare =
      w.node.kind == Node::Kind::map && w.node.children.size() == 1 && w.node.children[0].key != under.key;
  const ChoiceNames names(under.choice);
  if (bare && contains(names.keys, w.node.children[0].key)) return read(w, under.choice);
  if (bare) return w.refuse(wanted(under), did_you_mean(w.node.children[0].key, names.keys));
  if (w.node.kind != Node::Kind::map) return w.refuse(wanted(under));
  if (!refuse_second_choice(w, under)) read(w, under.map);
}

void read(const Written& w, const ListValue& list) {
  const std::size_t size = w.node.children.size();
  if (w.node.kind != Node::Kind::sequence || size < static_cast<std::size_t>(list.least) ||
      size > static_cast<std::size_t>(list.greatest))
    return w.refuse(wanted(list));
  list.resize(size);
  for (const auto i : up_to(size))
    read({w.node.children[i], fmt::format("{}[{}]", w.path, i), w.errors}, list.entry(i));
}

void read(const Written& w, const OneOr& value) {
  if (is_several(w.node, value)) {
    read(w, value.several());
    if (value.is_odd())
      w.errors.add(w.node.place, w.path, "got 1 step between different ends; expected at least 2; write `steps: 2`");
    return;
  }
  if (value.form == OneOr::Form::levels && (w.node.kind != Node::Kind::sequence || w.node.children.empty()))
    return w.refuse(wanted(value));
  read(w, value.one());
  value.spread();
}

/// Reads the keys of one map.
class MapReader {
 public:
  MapReader(const Written& map, const MapValue& value) : map_(map), value_(value) {}

  void read_key(const Field& field) {
    known_.push_back(field.key);
    const Node* node = find(map_.node, field.key);
    const std::string path = join(map_.path, field.key);
    if (!node) {
      if (field.presence.required)
        refuse_absence(path, field.sample([](const Value& v) { return wanted(v); }), field.presence);
      return;
    }
    field.renew();
    if (field.presence.allowed) return read({*node, path, map_.errors}, field.value());
    map_.errors.add_consequence(node->key_place, path,
                                fmt::format("got {}; expected no such key here: it stands {}; {}", got(*node),
                                            field.presence.condition, fix_of(field.presence.condition)));
  }

  void refuse_other_keys() const {
    for (const Node& child : map_.node.children) {
      if (contains(known_, child.key)) continue;
      std::string fix = blank_hint(child.key);
      if (fix.empty()) fix = range_hint(child.key);
      if (fix.empty()) fix = elsewhere_hint(child.key);
      if (fix.empty()) fix = did_you_mean(child.key, known_);
      map_.errors.add(child.key_place, join(map_.path, child.key), "unknown key; expected one of {}; {}",
                      fmt::join(known_, ", "), fix.empty() ? "delete it, or write it as one of these" : fix);
    }
  }

 private:
  /// How to fix `{path: mechanism.lead, from: 4 mm, to: 6 mm, steps: 3}`.
  std::string range_hint(std::string_view key) const {
    const bool is_of_range = key == "from" || key == "to" || key == "steps";
    const bool has_values = contains(known_, "values");
    return is_of_range && has_values ? "write `values: {from: .., to: .., steps: ..}`" : "";
  }

  /// Hint for a missing key that is somewhere else: `mechanism.rollers` if `rollers` is in the wrong map.
  std::string elsewhere_hint(std::string_view key) const {
    constexpr std::size_t kMost = 2;
    const bool is_case = contains(known_, "mechanism");
    if (!map_.path.empty() || !is_case) return {};
    std::vector<std::string> paths;  // Outermost paths.
    std::ptrdiff_t least = std::numeric_limits<std::ptrdiff_t>::max();
    for (const InputKey& known : input_keys()) {
      const std::ptrdiff_t depth = std::ranges::count(known.path, '.');
      if (depth > least || !known.path.ends_with(fmt::format(".{}", key))) continue;
      if (depth < least) paths.clear();
      least = depth;
      paths.push_back(fmt::format("`{}`", known.path));
    }
    if (paths.empty() || paths.size() > kMost) return {};
    return fmt::format("did you mean {}?", fmt::join(paths, " or "));
  }

  /// How to fix `lead:5 mm`, which is a key to YAML.
  std::string blank_hint(std::string_view key) const {
    const std::size_t colon = std::min(key.find(':'), key.size());
    if (colon == key.size() || !contains(known_, key.substr(0, colon))) return {};
    return fmt::format("write a blank after the colon: `{}: {}`", key.substr(0, colon), shown(key.substr(colon + 1)));
  }

  /// How to fix a key that stands only with another one, which is in backticks.
  std::string fix_of(std::string_view condition) const {
    constexpr std::string_view kWith = "with `";
    const std::size_t from = condition.find(kWith);
    if (from == condition.npos) return "delete it";
    const std::string_view behind = condition.substr(from + kWith.size()), key = behind.substr(0, behind.find('`'));
    std::string text(key);
    value_.for_each([&](const Field& field) {
      if (field.key == key) text += ": " + field.sample([](const Value& v) { return wanted(v); }).example;
    });
    return find(map_.node, key) ? "delete it" : fmt::format("write `{}`, or delete it", text);
  }

  void refuse_absence(const std::string& path, const Wanted& w, Presence presence) const {
    const Node& map = map_.node;
    const Place place = map.key.empty() ? map.place : map.key_place;
    const std::string add = "add " + Written::example(path, w);
    if (presence.condition.empty())
      map_.errors.add(place, path, "missing; expected {}; {}", w.what, add);
    else
      map_.errors.add_consequence(place, path,
                                  fmt::format("missing; expected {} ({}); {}", w.what, presence.condition, add));
  }

  const Written& map_;
  const MapValue& value_;
  std::vector<std::string_view> known_;
};

void read(const Written& w, const MapValue& map) {
  if (w.node.kind != Node::Kind::map) return w.refuse(wanted(map));
  MapReader keys(w, map);
  map.for_each([&](const Field& field) { keys.read_key(field); });
  keys.refuse_other_keys();
}

void read(const Written& w, const Value& value) {
  std::visit([&](const auto& v) { read(w, v); }, value.as);
}

// Load cases ------------------------------------------------------------------------------------

int points(const LoadCaseItem& item) { return item.axial_force.steps.value_or(1); }

std::size_t number_of_cases(const std::vector<LoadCaseItem>& items) {
  return std::transform_reduce(items.begin(), items.end(), std::size_t{0}, std::plus{},
                               [](const LoadCaseItem& i) { return static_cast<std::size_t>(points(i)); });
}

}  // namespace

void read_described(const Node& root, const Value& description, ErrorList& errors) {
  read({root, "", errors}, description);
}

std::vector<LoadCase> expand(const std::vector<LoadCaseItem>& items) {
  std::vector<LoadCase> cases;
  for (const auto i : indices(items)) {
    const LoadCaseItem& item = items[i];
    for (int k = 0; k < points(item); ++k) {
      LoadCase c;
      c.name = item.axial_force.steps ? fmt::format("{}[{}]", *item.name, k) : *item.name;
      c.direction = item.direction;
      c.share = item.share;
      c.input_path = fmt::format("load_cases[{}]", i);
      cases.push_back(std::move(c));
    }
  }
  for (const auto i : indices(items)) update_numbers(cases, items, i);
  return cases;
}

std::size_t first_case(const std::vector<LoadCaseItem>& items, std::size_t item) {
  std::size_t first = 0;
  for (const auto i : up_to(item)) first += static_cast<std::size_t>(points(items[i]));
  return first;
}

void update_numbers(std::vector<LoadCase>& cases, const std::vector<LoadCaseItem>& items, std::size_t item) {
  const LoadCaseItem& from = items[item];
  const Range& force = from.axial_force;
  const int last = points(from) - 1;
  LoadCase* c = cases.data() + first_case(items, item);
  for (int k = 0; k <= last; ++k, ++c) {
    c->axial_force = k == last ? force.to : force.from + (force.to - force.from) * k / last;
    c->position = from.position;
    c->speed = from.speed;
    c->spatial = from.spatial;
    c->travel = from.travel;
    c->modes = from.modes;
  }
}

std::vector<Problem> problems_of(const Case& c, Command command) {
  std::vector<Problem> problems = check_case(c);
  return problems.empty() ? prs::missing(c, command) : problems;
}

namespace {

/// Converts speeds along the axis to speeds of rotation, by the lead; whether there are any. A missing or wrong lead is
/// reported where the lead is read.
bool turn_speeds(Node& root) {
  const Node* const written = find_path(root, "mechanism.lead");
  const bool has_lead = written && written->kind == Node::Kind::scalar;
  double lead = has_lead ? parse_quantity(written->text, unit::length).value.value_or(1.0) : 1.0;
  if (lead == 0.0) lead = 1.0;
  bool any = false;
  const auto turn = [&](Node& block) {
    for (Node& speed : block.children) {
      if (speed.key != "speed" || speed.kind != Node::Kind::scalar) continue;
      const std::optional<double> travel = parse_quantity(speed.text, unit::travel_speed).value;
      if (!travel) continue;
      speed.text = fmt::format("{} rad/s", rotation(*travel, lead));
      any = true;
    }
  };
  const std::function<void(Node&)> turn_signal = [&](Node& node) {
    const std::optional<double> travel = parse_quantity(node.text, unit::travel_speed).value;
    if (node.kind == Node::Kind::scalar && travel) {
      node.text = fmt::format("{} rad/s", rotation(*travel, lead));
      any = true;
    }
    std::ranges::for_each(node.children, turn_signal);
  };
  const std::function<void(Node&)> turn_signals = [&](Node& block) {
    for (Node& part : block.children) {
      if (part.key == "controller") turn_signals(part);
      if (part.key == "speed" || part.key == "largest_speed") turn_signal(part);
    }
  };
  for (Node& block : root.children) {
    if (block.key == "operation") turn(block);
    if (block.key == "load_cases") std::ranges::for_each(block.children, turn);
    if (block.key != "response") continue;
    for (Node& part : block.children) {
      if (part.key == "motor") turn_signals(part);
      if (part.key == "curves" || part.key == "frequency_response") turn(part);
    }
  }
  return any;
}

}  // namespace

CaseFile read_case_file(const Node& root, ErrorList& errors) {
  if (const Node* motion = find(root, "motion"); motion && !find(root, "mechanism"))
    errors.fail(motion->key_place, "motion",
                "got a requirement; expected a case, with `mechanism`; run `prs size` on it, whose "
                "`--write 1 case.yaml` writes one");
  CaseFile file;
  Node turned = root;
  file.speeds_follow_lead = turn_speeds(turned);
  read({turned, "", errors}, value_of(file, Block{}));
  if (number_of_cases(file.load_cases) > kMostLoadCases)
    refuse(root, "load_cases",
           fmt::format("got {} cases; expected at most {}; write ranges with fewer steps",
                       number_of_cases(file.load_cases), kMostLoadCases),
           errors);
  for (const auto i : indices(file.load_cases))
    if (!file.load_cases[i].name) file.load_cases[i].name = fmt::format("case-{}", i + 1);
  return file;
}

namespace {

template <class Item>
std::optional<Command> command_of(const std::optional<Item>& item) {
  return item ? std::optional(item->command) : std::nullopt;
}

}  // namespace

Case checked_case(const CaseFile& file, const Node& root, Command command, ErrorList& errors) {
  Case values = file.values;
  values.load_cases = expand(file.load_cases);
  std::vector<Problem> problems = problems_of(values, command);
  std::ranges::move(check_limits(file.limits.value_or(Limits{}), values), std::back_inserter(problems));
  if (file.motor) std::ranges::move(check_motor(*file.motor, values), std::back_inserter(problems));
  for (const Problem& p : problems) refuse(root, p.path, p.message, errors);
  return values;
}

CaseInput read_case_input(const Source& source, Command command) {
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  const CaseFile file = read_case_file(root, errors);
  errors.throw_if_any();
  Case values = checked_case(file, root, command, errors);
  errors.throw_if_any();
  CaseInput input{std::move(values), echo(file, root), command_of(file.study), command_of(file.optimize),
                  file.fit.has_value()};
  input.limits = file.limits;
  input.motor = file.motor;
  if (command == Command::fit)  // Other commands need inputs of the case.
    for (const Problem& p : unmet(input, command)) refuse(root, p.path, p.message, errors);
  errors.throw_if_any();
  input.warnings = unusual_values(input.fields);
  return input;
}

std::vector<Problem> unmet(const CaseInput& input, Command command) {
  if (command == Command::fit) {
    Problems lacks;
    if (!input.fits)
      lacks.add_missing("fit", "unknown inputs and measured curves",
                        "{parameters: [{path: friction.coulomb, from: 0.02, to: 0.4}], curves: [{file: torque.csv, "
                        "response: slip.torque_screw_Nm, measured: {column: torque_Nm, unit: N m}}]}");
    return std::move(lacks).take();
  }
  if (command != Command::study && command != Command::optimize) return prs::missing(input.values, command);
  const std::optional<Command>& designs = command == Command::study ? input.study : input.optimize;
  if (designs) return unmet(input, *designs);
  Problems problems;
  // The file's own design should be among the suggested values; one roller more may not fit.
  const int fewer = std::max(1, input.values.mechanism.rollers - 1), rollers = fewer + 1;
  problems.add_missing(
      std::string(name(command)), fmt::format("what `{}` varies", name(command)),
      command == Command::study
          ? fmt::format("{{command: solve, factors: [{{path: mechanism.rollers, values: [{}, {}]}}]}}", fewer, rollers)
          : fmt::format("{{command: solve, variables: [{{path: mechanism.rollers, from: {}, to: "
                        "{}}}], objectives: [{{maximize: axial_stiffness_N_per_um}}]}}",
                        fewer, rollers));
  return std::move(problems).take();
}

std::vector<std::string> missing(const CaseInput& input, Command command) {
  std::vector<std::string> paths;
  for (Problem& problem : unmet(input, command)) paths.push_back(std::move(problem.path));
  return paths;
}

Case read_case(const std::string& file, const std::vector<std::string>& overrides, Command command) {
  return read_case_input(load_source(file, overrides), command).values;
}

Case read_case_text(const std::string& text, const std::string& name, const std::vector<std::string>& overrides,
                    Command command) {
  return read_case_input({name, text, overrides}, command).values;
}

}  // namespace prs::input
