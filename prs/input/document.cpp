#include "prs/input/document.h"

#include <fmt/ranges.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <charconv>
#include <sstream>
#include <unordered_map>

#include "prs/indices.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/units.h"
#include "prs/text.h"

namespace prs::input {
namespace {

constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostValues = 200'000;
constexpr std::size_t kMostBadKeys = 20;  // Largest number of keys reported.

/// Number of values that a scalar counts as, so that long texts are bounded too.
std::size_t weight(const Node& node) { return 1 + node.text.size() / 64; }

/// Builds the tree of one YAML document from the parser's events.
class TreeBuilder final : public YAML::EventHandler {
 public:
  /// `at`: place where an override takes effect, which all its values get.
  TreeBuilder(std::optional<Place> at, std::string path, ErrorList& errors)
      : at_(at), path_(std::move(path)), errors_(errors) {}

  Node take_root() { return std::move(root_); }
  bool has_root() const { return has_root_; }

  /// Adds errors found outside the tree. Call it after the whole text has proved to be YAML.
  void report_keys() const {
    for (const BadKey& k : bad_keys_) errors_.add(k.place, k.path, k.message);
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (std::exchange(started_, true))
      errors_.fail(place(mark), path_,
                   "got more text after the end of the document; expected one YAML document; "
                   "delete it or put it into a file of its own");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add_leaf({.kind = Node::Kind::null, .place = place(mark)}, anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_tag(mark, tag);
    add_leaf({.kind = Node::Kind::scalar, .quoted = tag == "!", .text = value, .place = place(mark)}, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchored_.find(anchor);
    if (found == anchored_.end())
      errors_.fail(place(mark), here(),
                   "got an alias of a value that contains it; expected another value; write it "
                   "out");
    charge(found->second.size, place(mark));
    add(Node(found->second.node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    refuse_tag(mark, tag);
    open(Node::Kind::sequence, place(mark), anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    refuse_tag(mark, tag);
    open(Node::Kind::map, place(mark), anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  /// A sequence or map under construction.
  struct Frame {
    Node node;
    YAML::anchor_t anchor = 0;
    std::size_t size_before = 0;
    std::optional<Node> key;  ///< Key already read, whose value comes next.
    bool drop_value = false;  ///< Whether the key is bad and its value is dropped.
    std::unordered_map<std::string, Place> keys;
  };
  struct Anchored {
    Node node;
    std::size_t size;
  };
  struct BadKey {
    Place place;
    std::string path, message;
  };

  Place place(const YAML::Mark& mark) const {
    return at_.value_or(Place{static_cast<std::size_t>(std::max(mark.pos, 0))});
  }

  /// Key path of the next value.
  std::string here() const {
    std::string path = path_;
    for (const Frame& f : frames_) {
      if (f.node.kind == Node::Kind::sequence)
        path += fmt::format("[{}]", f.node.children.size());
      else if (f.key)
        path += (path.empty() ? "" : ".") + f.key->text;
    }
    return path;
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) {
    if (tag.size() > 1)
      errors_.fail(place(mark), here(), "got the tag `{}`; expected a value without tag; delete the tag", shown(tag));
  }

  void charge(std::size_t size, Place at) {
    size_ += size;
    if (size_ > kMostValues)
      errors_.fail(at, here(),
                   "got more than {} values, aliases expanded; expected fewer; write a range "
                   "{{from, to, steps}} or use several files",
                   kMostValues);
  }

  void open(Node::Kind kind, Place at, YAML::anchor_t anchor) {
    if (frames_.size() >= kDeepest)
      errors_.fail(at, here(), "got more than {} nested levels; expected fewer; check the brackets and the indentation",
                   kDeepest);
    Frame& f = frames_.emplace_back();
    f.node.kind = kind;
    f.node.place = at;
    f.anchor = anchor;
    f.size_before = size_;
    charge(1, at);
  }

  void close() {
    Frame f = std::move(frames_.back());
    frames_.pop_back();
    keep(f.node, f.anchor, size_ - f.size_before);
    add(std::move(f.node));
  }

  void add_leaf(Node node, YAML::anchor_t anchor) {
    charge(weight(node), node.place);
    keep(node, anchor, weight(node));
    add(std::move(node));
  }

  void keep(const Node& node, YAML::anchor_t anchor, std::size_t size) {
    if (anchor == 0) return;
    charge(size, node.place);
    anchored_.insert_or_assign(anchor, Anchored{node, size});
  }

  /// Puts a complete value where it belongs: as root, list item, key or value of a key.
  void add(Node node) {
    if (frames_.empty()) {
      root_ = std::move(node);
      has_root_ = true;
      return;
    }
    Frame& f = frames_.back();
    if (f.node.kind == Node::Kind::sequence) {
      f.node.children.push_back(std::move(node));
    } else if (!f.key) {
      f.drop_value = !check_key(f, node);
      f.key = std::move(node);
    } else {
      node.key = f.key->text;
      node.key_place = f.key->place;
      if (node.kind == Node::Kind::null) node.place = node.key_place;
      f.key.reset();
      if (f.drop_value) return;
      f.keys.emplace(node.key, node.key_place);
      f.node.children.push_back(std::move(node));
    }
  }

  bool check_key(const Frame& f, const Node& key) {
    const std::string parent = here();
    const std::string path = parent + (parent.empty() ? "" : ".") + key.text;
    const auto refuse = [&](std::string message) {
      bad_keys_.push_back({key.place, path, std::move(message)});
      return false;
    };
    if (bad_keys_.size() >= kMostBadKeys) return false;
    if (key.kind != Node::Kind::scalar)
      return refuse("got a key that is not a text; expected `key: value`; write the key as a word");
    if (key.text == "<<" && !key.quoted)
      return refuse("got a merge key; expected plain keys; write the merged keys out");
    if (const auto first = f.keys.find(key.text); first != f.keys.end())
      return refuse(fmt::format("duplicate key; expected each key once; it stands already at {}; delete one of them",
                                errors_.where(first->second)));
    return true;
  }

  std::optional<Place> at_;
  std::string path_;
  ErrorList& errors_;
  bool started_ = false;
  bool has_root_ = false;
  Node root_;
  std::size_t size_ = 0;
  std::vector<Frame> frames_;
  std::unordered_map<YAML::anchor_t, Anchored> anchored_;
  std::vector<BadKey> bad_keys_;
};

/// Length of the first UTF-8 character of a text; 0 if it is malformed or a control character not allowed in text
/// files.
std::size_t character_length(std::string_view text) {
  const bool is_control = (text[0] >= 0 && text[0] < ' ') || text[0] == '\x7F';
  return is_control && std::string_view("\t\n\r").find(text[0]) == text.npos ? 0 : sequence_length(text);
}

void check_encoding(std::string_view text, std::optional<Place> at, std::string_view path, ErrorList& errors) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text.substr(i));
    if (length == 0)
      errors.fail(at.value_or(Place{i}), path,
                  "got the byte 0x{:02X}; expected plain text in UTF-8; check that this is a YAML "
                  "file and save it as UTF-8",
                  static_cast<unsigned char>(text[i]));
    i += length;
  }
}

/// Whether a line has a key and a value without a blank between them: `lead:5 mm`.
bool lacks_blank(std::string_view line) {
  const std::size_t colon = line.find(':');
  return colon != std::string_view::npos && colon + 1 < line.size() && line.find(": ") == std::string_view::npos &&
         line.substr(0, colon).find_first_of("\"'# ") == std::string_view::npos;
}

struct Malformed {
  std::size_t offset;
  std::string message;
};

/// Error in a text that is not YAML, with its place. `at`: where the parser stopped, which may be in the line below.
Malformed malformed(std::string_view text, std::size_t at, std::string_view why) {
  const std::size_t whole = text.size();
  text = text.substr(0, text.find('\n', std::min(at, whole)));
  for (int lines = 0; lines < 2 && !text.empty(); ++lines) {
    const std::size_t end = text.rfind('\n');
    std::string_view line = text.substr(end + 1);  // Becomes the whole text if there is no line end.
    const std::size_t key = std::min(line.find_first_not_of(" \t-"), line.size());
    if (line.substr(0, key).find('\t') != std::string_view::npos)
      return {end + 1, "got a tab before the key; expected blanks; replace every tab by blanks"};
    line.remove_prefix(key);
    line = line.substr(0, std::min(line.find(" #"), line.find('\r')));
    line = line.substr(0, line.find_last_not_of(' ') + 1);
    if (lacks_blank(line))
      return {end + 1 + key, fmt::format("got {}; expected `key: value`; write a blank after the colon", shown(line))};
    text = text.substr(0, end == std::string_view::npos ? 0 : end);
  }
  return {std::min(at, whole), fmt::format("malformed YAML: {}; expected `key: value`; check indentation, quotes "
                                           "(around texts with brackets, too), brackets "
                                           "and colons here and above",
                                           why)};
}

/// The tree of one YAML text; none if the text has only comments.
std::optional<Node> parse_yaml(const std::string& text, std::optional<Place> at, const std::string& path,
                               ErrorList& errors) {
  check_encoding(text, at, path, errors);
  TreeBuilder builder(at, path, errors);
  try {
    std::istringstream in(text);
    YAML::Parser parser(in);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& e) {
    const auto offset = static_cast<std::size_t>(std::max(e.mark.pos, 0));
    const Malformed found = malformed(text, offset, e.msg);
    errors.fail(at.value_or(Place{found.offset}), path, found.message);
  }
  builder.report_keys();
  if (!builder.has_root()) return std::nullopt;
  return builder.take_root();
}

Node* find(Node& map, std::string_view key) { return const_cast<Node*>(input::find(std::as_const(map), key)); }

/// One step of a path: a key or, in brackets, the index or the name of an entry.
struct Step {
  std::string_view key;
  std::optional<std::size_t> index;
  std::string_view name = {};

  bool is_entry() const { return index || !name.empty(); }
};

/// `load_cases[0].axial_force` -> key, index, key; none if the path is malformed.
std::optional<std::vector<Step>> split_path(std::string_view path) {
  std::vector<Step> steps;
  while (true) {
    const std::size_t end = std::min(path.find_first_of(".["), path.size());
    if (end == 0) return std::nullopt;
    steps.push_back({path.substr(0, end), std::nullopt});
    path.remove_prefix(end);
    while (path.starts_with('[')) {
      std::size_t index = 0;
      const char* last = path.data() + path.size();
      const auto [stop, error] = std::from_chars(path.data() + 1, last, index);
      const std::size_t close = path.find(']');
      if (close == path.npos || close == 1) return std::nullopt;
      if (error == std::errc{} && stop != last && *stop == ']')
        steps.push_back({{}, index});
      else
        steps.push_back({{}, std::nullopt, path.substr(1, close - 1)});
      path.remove_prefix(close + 1);
    }
    if (path.empty()) return steps;
    if (!path.starts_with('.') || steps.size() > kDeepest) return std::nullopt;
    path.remove_prefix(1);
  }
}

std::string_view name_of(const Node& entry) {
  const Node* name = entry.kind == Node::Kind::map ? input::find(entry, "name") : nullptr;
  return name && name->kind == Node::Kind::scalar ? std::string_view(name->text) : "";
}

/// The entry of a list, the first if several have the name; null if there is none.
const Node* entry_of(const Node& list, const Step& step) {
  const auto found =
      step.index ? list.children.begin() + static_cast<std::ptrdiff_t>(std::min(*step.index, list.children.size()))
                 : std::ranges::find(list.children, step.name, name_of);
  return found == list.children.end() ? nullptr : &*found;
}

/// Reason why a step is not one entry of a list; empty if it is.
std::string no_entry(const Node& list, const Step& step) {
  if (list.kind != Node::Kind::sequence) return "the brackets have no list; expected a path that exists";
  if (step.index)
    return *step.index < list.children.size() ? ""
                                              : fmt::format("got the index {}; expected one below {}, counted from 0",
                                                            *step.index, list.children.size());
  const auto count = std::ranges::count(list.children, step.name, name_of);
  if (count == 1) return "";
  if (count > 1)
    return fmt::format(
        "got the name {}, which {} entries have; expected one; write its index, "
        "counted from 0",
        shown(step.name), count);
  std::vector<std::string_view> names;
  for (const Node& entry : list.children)
    if (const std::string_view name = name_of(entry); !name.empty()) names.push_back(name);
  const std::string hint = did_you_mean(step.name, names);
  return fmt::format(
      "got the name {}; expected that of an entry{}, or an index below {}, counted "
      "from 0{}{}",
      shown(step.name),
      names.empty() ? ", of which none has one"
                    : fmt::format(" ({})", shown(fmt::format("{}", fmt::join(names, ", ")))),
      list.children.size(), hint.empty() ? "" : "; ", hint);
}

/// The node at the end of the steps, created if missing; null if they lead nowhere. `at`, of an override, moves to the
/// innermost value of the file.
Node* descend(Node& root, const std::vector<Step>& steps, const std::string& path, Place& at, ErrorList& errors) {
  Node* node = &root;
  const auto refuse = [&](std::string_view message) {
    errors.add(at, path, message);
    return nullptr;
  };
  const auto note_place = [&] {
    if (at.argument >= 0 && node->place.argument < 0)
      at.offset = node->key.empty() ? node->place.offset : node->key_place.offset;
  };
  note_place();
  for (const Step& step : steps) {
    if (step.is_entry()) {
      if (const std::string problem = no_entry(*node, step); !problem.empty()) return refuse(problem);
      node = const_cast<Node*>(entry_of(*node, step));
      note_place();
      continue;
    }
    if (node->kind == Node::Kind::null) {
      node->kind = Node::Kind::map;
      node->place = at;
    }
    if (node->kind != Node::Kind::map)
      return refuse(
          fmt::format("`{}` cannot be set; the value that would hold it is not a map; set "
                      "that value as a whole",
                      step.key));
    Node* child = find(*node, step.key);
    if (!child) {
      child = &node->children.emplace_back();
      child->key = step.key;
      child->place = child->key_place = at;
    }
    node = child;
    note_place();
  }
  return node;
}

/// Whether a text means the same without quotes: words and quantities do, numbers do not.
bool needs_no_quotes(const std::string& text) {
  const auto is_alphanumeric = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  };
  const auto is_plain = [&](char c) {
    return is_alphanumeric(c) || std::string_view(" _./^()%+-").find(c) != std::string_view::npos;
  };
  static constexpr std::string_view kNullWords[] = {"null", "Null", "NULL"};
  return std::ranges::all_of(text, is_plain) && (is_alphanumeric(text.back()) || text.ends_with(" %")) &&
         (is_alphanumeric(text.front()) || split_unit(text)) && !contains(kNullWords, text) &&
         scalar_type({.kind = Node::Kind::scalar, .text = text}) == ScalarType::text;
}

/// A scalar in the form required inside `[..]` and `{..}`.
std::string flow_scalar(const Node& scalar, bool inside) {
  const bool bare =
      !scalar.text.empty() && (scalar.quoted ? needs_no_quotes(scalar.text)
                                             : !inside || scalar.text.find_first_of(",[]{}:#") == std::string::npos);
  if (bare) return scalar.text;
  std::string text = "\"";
  for (const char c : scalar.text) {
    if (c == '"' || c == '\\') text += '\\';
    if (c == '\n')
      text += "\\n";
    else
      text += c;
  }
  return text + '"';
}

std::string flow_text(const Node& value, bool inside) {
  if (value.kind == Node::Kind::null) return "~";
  if (value.kind == Node::Kind::scalar) return flow_scalar(value, inside);
  const bool is_map = value.kind == Node::Kind::map;
  std::string text = is_map ? "{" : "[";
  for (const Node& child : value.children) {
    if (text.size() > 1) text += ", ";
    if (is_map) text += child.key + ": ";
    text += flow_text(child, true);
  }
  return text + (is_map ? '}' : ']');
}

}  // namespace

bool set_value(Node& root, const std::string& path, Node value, Place at, ErrorList& errors) {
  const auto steps = split_path(path);
  if (!steps) {
    errors.add(at, path,
               "got no path; expected keys and indices; write for example `mechanism.rollers` or "
               "`load_cases[0].axial_force`");
    return false;
  }
  Node* node = descend(root, *steps, path, at, errors);
  if (!node) return false;
  value.key = node->key;
  value.key_place = at;
  *node = std::move(value);
  return true;
}

void apply_override(Node& root, const Source& source, std::size_t index, ErrorList& errors) {
  const std::string& text = source.overrides[index];
  Place at{0, static_cast<int>(index)};  // Place of the innermost value of the file on the path.
  const std::size_t equals = text.find('=');
  const std::string path = text.substr(0, equals);
  const auto steps = split_path(path);
  if (equals == std::string::npos || !steps)
    errors.fail(at, "",
                "got {}; expected path=value, for example mechanism.rollers=9 or "
                "load_cases[0].axial_force=20 kN",
                text.empty() ? "nothing" : shown(text));
  Node* node = descend(root, *steps, path, at, errors);
  if (!node) return errors.throw_if_any();
  Node value =
      parse_yaml(text.substr(equals + 1), at, path, errors).value_or(Node{.kind = Node::Kind::null, .place = at});
  value.key = node->key;
  value.key_place = at;
  *node = std::move(value);
}

std::string flow_text(const Node& value) { return flow_text(value, false); }

const Node* find_path(const Node& root, std::string_view path) {
  const Node* node = &root;
  for (const Step& step : split_path(path).value_or(std::vector<Step>{})) {
    node = step.is_entry() ? entry_of(*node, step) : find(*node, step.key);
    if (!node) return nullptr;
  }
  return node;
}

std::string with_indices(const Node& root, const std::string& path) {
  const auto steps = split_path(path);
  if (!steps) return path;
  std::string indexed;
  const Node* node = &root;
  for (const Step& step : *steps) {
    if (!step.is_entry()) {
      node = find(*node, step.key);
      indexed.append(indexed.empty() ? "" : ".").append(step.key);
    } else if (no_entry(*node, step).empty()) {
      const Node* entry = entry_of(*node, step);
      indexed += fmt::format("[{}]", entry - node->children.data());
      node = entry;
    } else {
      return path;
    }
    if (!node) return path;
  }
  return indexed;
}

bool stands_in(const Node& node, Place place) {
  return node.place == place || std::ranges::any_of(node.children, [&](const Node& child) {
           return child.key_place == place || stands_in(child, place);
         });
}

const Node* find(const Node& map, std::string_view key) {
  for (const Node& child : map.children)
    if (child.key == key) return &child;
  return nullptr;
}

bool is_per_part(const Node& node) {
  return find(node, "screw") || find(node, "roller") || find(node, "rollers") || find(node, "nut");
}

ScalarType scalar_type(const Node& scalar) {
  if (scalar.quoted) return ScalarType::text;
  static constexpr std::string_view kBooleans[] = {"true", "True", "TRUE", "false", "False", "FALSE"};
  if (contains(kBooleans, scalar.text)) return ScalarType::boolean;
  return parse_number(scalar.text) ? ScalarType::number : ScalarType::text;
}

Node read_document(const Source& source, ErrorList& errors) {
  std::optional<Node> root = parse_yaml(source.text, std::nullopt, "", errors);
  if (!root)
    errors.fail({}, "",
                "got an empty file; expected a case, with `mechanism`, or for `prs size` a requirement, with `motion`; "
                "`prs new FILE` writes a case to start from, and lesson 32 is a requirement");
  for (const auto i : indices(source.overrides)) apply_override(*root, source, i, errors);
  return std::move(*root);
}

Place locate(const Node& root, std::string_view path) {
  const Node* node = &root;
  Place nearest = root.place;
  for (const Step& step : split_path(path).value_or(std::vector<Step>{})) {
    const Node* child = step.is_entry() ? entry_of(*node, step) : find(*node, step.key);
    if (!child) return nearest;
    node = child;
    nearest = step.is_entry() ? node->place : node->key_place;
  }
  return node->place;
}

void refuse(const Node& root, std::string_view path, std::string_view message, ErrorList& errors) {
  errors.add(locate(root, path), path, message);
}

void fail_at(const Source& source, std::string_view path, std::string_view message) {
  ErrorList errors(source);
  errors.fail(locate(read_document(source, errors), path), path, message);
}

}  // namespace prs::input
