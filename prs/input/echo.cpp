#include "prs/input/echo.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "prs/indices.h"
#include "prs/input/described_file.h"
#include "prs/input/force_history.h"
#include "prs/input/reader.h"
#include "prs/input/schema.h"
#include "prs/sha256.h"

namespace prs::input {
namespace {

/// Lists the values of one map with the text written for each (null if there was none).
class Lister {
 public:
  explicit Lister(std::vector<EchoEntry>& entries) : entries_(entries) {}

  void list(const Node* map, const std::string& path, const MapValue& value) {
    value.for_each([&](const Field& field) {
      if (!stands(field)) return;
      list(map ? find(*map, field.key) : nullptr,
           path.empty() ? std::string(field.key) : fmt::format("{}.{}", path, field.key), field.value());
    });
  }

 private:
  void list(const Node* node, const std::string& path, const Value& value) {
    std::visit([&](const auto& v) { list(node, path, v); }, value.as);
  }

  /// Lists one value that takes one line.
  void list_line(const Node* node, const std::string& path, const Value& value) {
    EchoEntry& entry = entries_.emplace_back();
    entry = {path, text_of(value), node == nullptr};
    if (node) entry.written = node->kind == Node::Kind::scalar ? node->text : flow_text(*node);
  }
  template <class Kind, class T>
  void list(const Node* node, const std::string& path, const Leaf<Kind, T>& leaf) {
    list_line(node, path, {leaf});
    if constexpr (std::is_same_v<T, double>) put_number(leaf.value, leaf.kind);
  }
  void put_number(double value, const Number&) { entries_.back().number = value; }
  void put_number(double value, const Quantity& kind) {
    entries_.back().number = value;
    entries_.back().dimension = &kind.dimension;
  }
  void put_number(double value, const Held& held) {
    if (std::isfinite(value) && value > 0.0) put_number(value, Quantity{held.dimension});
  }

  void list(const Node* node, const std::string& path, const ChoiceValue& choice) { list_line(node, path, {choice}); }
  void list(const Node* node, const std::string& path, const ChoiceUnderKey& under) {
    list(node, fmt::format("{}.{}", path, under.key), under.choice);
  }
  void list(const Node* node, const std::string& path, const ListValue& items) {
    if (items.size() == 0 && items.least == 0) entries_.push_back({path, "[]", node == nullptr});
    for (const auto i : indices(items))
      list(node ? &node->children[i] : nullptr, fmt::format("{}[{}]", path, i), items.entry(i));
  }
  void list(const Node* node, const std::string& path, const OneOr& value) {
    using Form = OneOr::Form;
    const bool several = node && is_several(*node, value);
    if (value.form == Form::ends || value.form == Form::word)
      return list(several ? node : nullptr, path, value.several());
    const Value shown = several ? value.several() : value.one();
    if (value.form != Form::levels && !(value.form == Form::range && several)) return list(node, path, shown);
    list_line(node, path, shown);
    if (value.form == Form::range) put_farther_end(std::get<MapValue>(shown.as));
  }
  void put_farther_end(const MapValue& range) {
    range.for_each([&](const Field& end) {
      if (!end.has_value()) return;
      const Value value = end.value();
      const auto* const leaf = std::get_if<Leaf<Quantity, double>>(&value.as);
      const std::optional<double>& number = entries_.back().number;
      if (leaf && (!number || std::abs(leaf->value) > std::abs(*number))) put_number(leaf->value, leaf->kind);
    });
  }

  std::vector<EchoEntry>& entries_;
};

std::string_view stripped(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

/// Offset of the comment of a line, at its `#`; npos without one.
std::size_t comment_in(std::string_view line) {
  char quote = 0;
  for (const auto k : indices(line)) {
    const char c = line[k], before = k > 0 ? line[k - 1] : ' ';
    if (quote != 0)
      quote = c == quote ? 0 : quote;
    else if ((c == '"' || c == '\'') && std::string_view(" [{,").find(before) != line.npos)
      quote = c;
    else if (c == '#' && (before == ' ' || before == '\t'))
      return k;
  }
  return line.npos;
}

/// `assumed VALUE: REASON`
struct Mark {
  std::string_view value;  ///< Empty: any value.
  std::string_view reason;
};

std::optional<Mark> mark_in(std::string_view comment) {
  constexpr std::string_view kWord = "assumed";
  if (!comment.starts_with(kWord)) return std::nullopt;
  comment.remove_prefix(kWord.size());
  if (!comment.starts_with(' ') && !comment.starts_with(':')) return std::nullopt;
  int depth = 0;
  for (const auto k : indices(comment)) {
    const char c = comment[k];
    depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
    if (c == ':' && depth == 0) return Mark{stripped(comment.substr(0, k)), stripped(comment.substr(k + 1))};
  }
  return std::nullopt;
}

/// A separate value of a text; absent if it is not YAML.
std::optional<Node> value_of(std::string_view text) try {
  const Source source = source_of_text("", "value: " + std::string(text), {});
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  errors.throw_if_any();
  const Node* value = find(root, "value");
  return value ? std::optional(*value) : std::nullopt;
} catch (const InputError&) {
  return std::nullopt;
}

using Reasons = std::unordered_map<const Node*, std::string>;

/// Marks the scalars of a value that still equal the assumed ones; `was` null: all of them.
void mark(const Node& value, const Node* was, std::string_view reason, Reasons& reasons) {
  if (value.place.argument >= 0 || (was && was->kind != value.kind)) return;
  if (value.kind == Node::Kind::scalar && (!was || was->text == value.text)) reasons.try_emplace(&value, reason);
  for (const auto k : indices(value.children)) {
    const Node& child = value.children[k];
    const Node* before = nullptr;
    if (was) {
      const bool is_map = value.kind == Node::Kind::map;
      if (is_map)
        before = find(*was, child.key);
      else if (k < was->children.size())
        before = &was->children[k];
      if (!before) continue;
    }
    mark(child, before, reason, reasons);
  }
}

/// The outermost value that begins on each line, by the line's number.
class FirstOnLine {
 public:
  FirstOnLine(const Node& root, std::string_view text) {
    for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1)) starts_.push_back(at + 1);
    for (const Node& child : root.children) add(child);
  }
  const Node* operator[](std::size_t line) const {
    const auto found = first_.find(line);
    return found == first_.end() ? nullptr : found->second;
  }

 private:
  void add(const Node& node) {
    const Place& place = node.key.empty() ? node.place : node.key_place;
    if (place.argument < 0) {
      const auto behind = std::ranges::upper_bound(starts_, place.offset);
      first_.try_emplace(static_cast<std::size_t>(behind - starts_.begin()) - 1, &node);
    }
    for (const Node& child : node.children) add(child);
  }

  std::vector<std::size_t> starts_{0};
  std::unordered_map<std::size_t, const Node*> first_;
};

/// Reasons of all scalars that comments mark.
Reasons marked(const Node& root, std::string_view text) {
  const FirstOnLine first(root, text);
  Reasons reasons;
  const auto take = [&](std::string_view comment, std::size_t line) {
    const std::optional<Mark> found = mark_in(comment);
    const Node* node = found ? first[line] : nullptr;
    if (!node) return;
    if (found->value.empty()) return mark(*node, nullptr, found->reason, reasons);
    if (const std::optional<Node> was = value_of(found->value)) mark(*node, &*was, found->reason, reasons);
  };
  std::string above;  // Mark on the lines above, which may still continue.
  bool is_open = false;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + 1;
    const std::size_t hash = comment_in(line);
    const std::string_view comment = hash == line.npos ? std::string_view() : stripped(line.substr(hash + 1));
    const bool is_alone = stripped(line.substr(0, hash)).empty();
    if (!is_alone) {
      take(comment, number);
      take(std::exchange(above, {}), number);
    } else if (mark_in(comment) || comment.starts_with("assumed ")) {
      above = comment;
      is_open = true;
    } else if (hash == line.npos) {
      is_open = false;
    } else if (is_open) {
      above.append(" ").append(comment);
    }
  }
  return reasons;
}

/// Reason of a value all of whose scalars are marked; null for others.
const std::string* reason_of(const Node& node, const Reasons& reasons) {
  const std::string* reason = nullptr;
  if (node.kind == Node::Kind::scalar)
    if (const auto found = reasons.find(&node); found != reasons.end()) reason = &found->second;
  for (const Node& child : node.children) {
    reason = reason_of(child, reasons);
    if (!reason) return nullptr;
  }
  return reason;
}

}  // namespace

std::vector<EchoEntry> echo_of(const Node& root, const Value& description) {
  std::vector<EchoEntry> entries;
  Lister(entries).list(&root, "", std::get<MapValue>(description.as));
  return entries;
}

std::vector<EchoEntry> echo(CaseFile file, const Node& root) {
  std::optional<Lubricant>& lubricant = file.values.lubricant;
  if (lubricant) lubricant = resolved(*lubricant);
  std::vector<EchoEntry> entries = echo_of(root, {map_of([&](const Fields& io) { fields(io, file); })});
  constexpr std::string_view block = "lubricant.";
  if (lubricant && lubricant->name)
    for (EchoEntry& entry : entries)
      if (entry.is_default && entry.path.starts_with(block))
        entry.origin = origin_of(std::string_view(entry.path).substr(block.size()), *lubricant->name);
  return entries;
}

std::map<std::string, std::string> assumptions(const std::vector<EchoEntry>& entries, const Source& source) {
  std::map<std::string, std::string> all;
  if (entries.empty()) return all;
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  const Reasons reasons = marked(root, source.text);
  for (const EchoEntry& entry : entries) {
    if (entry.is_default) continue;
    const Node* node = find_path(root, entry.path);
    if (const std::string* reason = node ? reason_of(*node, reasons) : nullptr) all.emplace(entry.path, *reason);
  }
  return all;
}

namespace {

/// Offset after the bracket that closes the one at `at`; npos if it is not closed.
std::size_t end_of_brackets(std::string_view text, std::size_t at) {
  int depth = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = text.find(c, at + 1);
      if (at == text.npos) return at;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if ((c == '}' || c == ']') && --depth == 0) {
      return at + 1;
    }
  }
  return text.npos;
}

/// Offset after a value on one line; npos if it takes several lines.
std::size_t end_of_value(std::string_view text, const Node& node) {
  const std::size_t at = node.place.offset;
  if (at >= text.size()) return text.npos;
  const char first = text[at];
  if (first == '{' || first == '[') return end_of_brackets(text, at);
  if (first == '"' || first == '\'') {
    const std::size_t end = text.find(first, at + 1);
    return end == text.npos ? end : end + 1;
  }
  const bool is_plain = node.kind == Node::Kind::scalar && !node.text.empty() && text.substr(at).starts_with(node.text);
  return is_plain ? at + node.text.size() : text.npos;
}

/// `nut_tilt: {z: 0.1 deg}` for the path `nut_tilt.z`
std::string entry(std::string_view path, const std::string& value) {
  const std::size_t dot = path.find('.');
  if (dot == path.npos) return std::string(path) + ": " + value;
  return std::string(path.substr(0, dot)) + ": {" + entry(path.substr(dot + 1), value) + "}";
}

/// Adds a value to the innermost map on its path that the text has.
bool insert(std::string& text, const Node& root, const std::string& path, const std::string& value) {
  std::size_t cut = path.size();
  const Node* map = nullptr;
  while (!map && cut > 0) {
    cut = path.rfind('.', cut - 1);
    if (cut == path.npos) break;
    map = find_path(root, path.substr(0, cut));
  }
  const std::string rest = map ? path.substr(cut + 1) : path;
  if (!map) map = &root;
  if (map->kind != Node::Kind::map || rest.find('[') != rest.npos) return false;
  const std::size_t at = map->place.offset;
  std::string added = entry(rest, value);
  if (text[at] == '{') {
    text.insert(at + 1, added + (map->children.empty() ? "" : ", "));
    return true;
  }
  const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  text.insert(at, added + "\n" + std::string(at - line, ' '));
  return true;
}

bool is_same(const Node& a, const Node& b) {
  if (a.kind != b.kind || a.text != b.text || a.children.size() != b.children.size()) return false;
  for (const auto k : indices(a.children)) {
    const Node* other = a.kind == Node::Kind::map ? find(b, a.children[k].key) : &b.children[k];
    if (!other || !is_same(a.children[k], *other)) return false;
  }
  return true;
}

Node document_of(const Source& source) {
  ErrorList errors(source);
  Node root = read_document(source, errors);
  errors.throw_if_any();
  return root;
}

using Json = nlohmann::ordered_json;

/// A value as it was written.
Json written_json(const Node& node) {
  if (node.kind == Node::Kind::scalar) switch (scalar_type(node)) {
      case ScalarType::text:
        return node.text;
      case ScalarType::boolean:
        return node.text[0] == 't' || node.text[0] == 'T';
      case ScalarType::number:
        return Json::accept(node.text) ? Json::parse(node.text) : Json(*parse_number(node.text));
    }
  const bool is_map = node.kind == Node::Kind::map;
  Json json = is_map ? Json::object() : Json::array();
  for (const Node& child : node.children)
    if (is_map)
      json[child.key] = written_json(child);
    else
      json.push_back(written_json(child));
  return node.kind == Node::Kind::null ? Json() : json;
}

Json json_of(const Node* node, const Value& value);

/// Value in the unit of the file, in which studies vary it.
template <class Kind, class T>
Json json_of(const Node* node, const Leaf<Kind, T>& leaf) {
  if constexpr (std::is_same_v<Kind, Verbatim>)
    return node ? written_json(*node) : Json();
  else if constexpr (std::is_same_v<Kind, Quantity> || std::is_same_v<Kind, EitherQuantity> ||
                     std::is_same_v<Kind, Held>)
    return node ? node->text : text_of({leaf});
  else
    return leaf.value;
}

Json json_of(const Node* node, const MapValue& map);

Json json_of(const Node* node, const ChoiceValue& choice) {
  for (const Alternative& a : choice.alternatives())
    if (a.holds && a.map)
      return json_of(node, a.map());
    else if (a.holds && a.content)
      return {{a.name, json_of(node ? find(*node, a.name) : nullptr, a.content())}};
    else if (a.holds)
      return a.name;
  return Json();
}

Json json_of(const Node* node, const MapValue& map) {
  Json json = Json::object();
  map.for_each([&](const Field& field) {
    if (!stands(field)) return;
    const Node* own = node ? find(*node, field.key) : nullptr;
    Json value = json_of(own, field.value());
    if (field.is_optional() || own || !value.empty()) json[field.key] = std::move(value);
  });
  return json;
}

Json json_of(const Node* node, const ChoiceUnderKey& under) {
  const Node* choice = node ? find(*node, under.key) : nullptr;
  // Form as written, so that paths into it stay valid.
  if (node && !choice) return json_of(node, under.choice);
  return {{under.key, json_of(choice, under.choice)}};
}

Json json_of(const Node* node, const ListValue& items) {
  Json list = Json::array();
  for (const auto i : indices(items)) list.push_back(json_of(node ? &node->children[i] : nullptr, items.entry(i)));
  return list;
}

Json json_of(const Node* node, const OneOr& value) {
  const bool several = node && is_several(*node, value);
  if (value.form == OneOr::Form::word) return json_of(several ? node : nullptr, value.several());
  return json_of(node, several ? value.several() : value.one());
}

Json json_of(const Node* node, const Value& value) {
  return std::visit([&](const auto& v) { return json_of(node, v); }, value.as);
}

/// Text of the file that a case names; none if it cannot be read, as only `life` needs it.
std::optional<std::string> history_text(const HistorySource& history, const Source& source) {
  try {
    return force_history_text(history, source);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The history with the absolute path of its file, as the case may be written elsewhere, and its hash.
Json located(const Json& history, const HistorySource& read, const Source& source) {
  const std::optional<std::string> text = history_text(read, source);
  Json whole;
  for (const auto& [key, value] : history.items()) {
    whole[key] = value;
    if (key != "file" || !text) continue;
    whole[key] = place_of_file(read.file, source).string();
    whole["sha256"] = sha256(*text);
  }
  return whole;
}

}  // namespace

std::optional<std::string> written_case(const Source& source) try {
  Source written{source.name, source.text, {}, source.folder};
  for (const std::string& override : source.overrides) {
    const std::size_t equals = override.find('=');
    const std::string path = override.substr(0, equals), value = override.substr(equals + 1);
    const Node root = document_of(written);
    const Node* node = find_path(root, path);
    if (!node) {
      if (!insert(written.text, root, path, value)) return std::nullopt;
      continue;
    }
    const std::size_t end = end_of_value(written.text, *node);
    if (end == std::string::npos) return std::nullopt;
    written.text.replace(node->place.offset, end - node->place.offset, value);
  }
  if (!is_same(document_of(written), document_of(source))) return std::nullopt;
  return written.text;
} catch (const InputError&) {
  document_of(source);  // Throws if the source was wrong before: then that is the error to report.
  return std::nullopt;
}

Json resolved(const Node& root, const Value& description) { return json_of(&root, description); }

Json resolved_input(const Source& source) {
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  CaseFile file = read_case_file(root, errors);
  errors.throw_if_any();
  Json json = json_of(&root, value_of(file, Block{}));
  if (file.values.life && file.values.life->history) {
    Json& history = json["life"]["history"];
    history = located(history, *file.values.life->history, source);
  }
  return json;
}

std::string input_sha256(const Source& source, std::optional<Command> command) {
  ErrorList errors(source);
  CaseFile file = read_case_file(read_document(source, errors), errors);
  std::vector<std::string> texts;
  if (file.values.life && file.values.life->history)
    if (const auto text = history_text(*file.values.life->history, source)) texts.push_back(*text);
  if (file.values.response)
    file.values.response->for_each_signal([&](const std::string& path, const Signal& signal) {
      for (const SignalTerm& term : signal.many.empty() ? std::vector{signal.one} : signal.many) try {
          if (term.file) texts.push_back(named_file_text(term.file->name, path, source));
        } catch (const InputError&) {  // The command reports this error.
        }
    });
  const auto add = [&](const auto& items, const char* list) {
    for (const auto k : indices(items))
      texts.push_back(named_file_text(items[k].file, fmt::format("{}[{}].file", list, k), source));
  };
  if (command == Command::fit && file.fit) add(file.fit->curves, "fit.curves");
  if (command == Command::compare) add(file.references, "references");
  return input_sha256(source, texts);
}

std::string input_sha256(const Source& source, const std::vector<std::string>& files) {
  std::string all = source.text;
  for (const std::string& override : source.overrides) all.append(1, '\0').append(override);
  for (const std::string& text : files) all.append(1, '\0').append(sha256(text));
  return sha256(all);
}

namespace {

/// Usual magnitudes of a value, ends included, as text of a file; an empty end is no limit. The path applies to each
/// part and each entry of a list.
struct UsualValue {
  std::string_view path;
  std::string_view least;
  std::string_view greatest;
  std::string_view example;  ///< Typical values.
};

constexpr UsualValue kUsual[] = {
    // Screws in catalogues have 3.5 to 150 mm and leads of 0.5 to 50 mm; lessons have 25 mm.
    {"mechanism.lead", "0.2 mm", "100 mm", "catalogues have 1 mm to 50 mm"},
    {"mechanism.pitch_diameter", "1 mm", "500 mm", "screws in catalogues have 3.5 mm to 150 mm"},
    {"mechanism.centre_distance", "2 mm", "500 mm", "two thirds of the screw's diameter"},
    // Polymers of nuts (polyoxymethylene, polyether ether ketone) to tungsten carbide.
    {"materials.youngs_modulus", "1 GPa", "700 GPa", "steel has 190 GPa to 215 GPa"},
    {"materials.poisson_ratio", "0.15", "0.44", "steel has 0.27 to 0.3"},
    {"materials.density", "900 kg/m^3", "16000 kg/m^3", "steel has 7700 kg/m^3 to 8000 kg/m^3"},
    {"materials.thermal_expansion", "2 um/m/K", "150 um/m/K", "steel has 10 um/m/K to 17 um/m/K"},
    // A nut on springs to a block of steel.
    {"structure.nut.housing.axial", "100 N/mm", "1e6 kN/mm", "housings have 10 kN/mm to 10000 kN/mm"},
    {"structure.nut.housing.lateral", "1 N/mm", "1e6 kN/mm", "housings have 10 kN/mm to 10000 kN/mm"},
    {"structure.nut.outer_diameter", "3 mm", "700 mm", "twice to three times the screw's diameter"},
    {"structure.nut.length", "1 mm", "1 m", "one to five screw diameters"},
    {"structure.screw.free_length", "", "10 m", "up to a hundred screw diameters"},
    {"structure.roller.end_length", "", "200 mm", "up to two roller diameters"},
    // The largest static capacities in catalogues are about 3 MN.
    {"load_cases.axial_force", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    {"life.spectrum.force", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    {"life.dynamic_capacity", "500 N", "10 MN", "catalogues have 5 kN to 2 MN"},
    {"life.static_capacity", "500 N", "10 MN", "catalogues have 5 kN to 3 MN"},
    {"preload.force", "", "1 MN", "some 5 % of the dynamic capacity"},
    {"preload.lost_motion_load", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    {"preload.load.from", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    {"preload.load.to", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    // n d of 150,000 mm/min is 37,500 rpm of the smallest screw.
    {"load_cases.speed", "", "40000 rpm", "n d is at most 150000 mm/min"},
    {"operation.speed", "", "40000 rpm", "n d is at most 150000 mm/min"},
    // Lathe-turned to superfinished flanks.
    {"roughness", "0.01 um", "5 um", "ground flanks have Rq 0.2 um to 0.8 um"},
    // Thin hot oil to the cold base oil of a stiff grease.
    {"lubricant.viscosity", "1 mPa s", "50 Pa s", "oil in operation has 5 mPa s to 500 mPa s"},
    {"lubricant.viscosity_at.viscosity", "1 mPa s", "50 Pa s", "oil has 5 mPa s to 500 mPa s"},
    {"lubricant.viscosity_at.kinematic_viscosity", "1 mm^2/s", "50000 mm^2/s",
     "ISO VG grades have 2 mm^2/s to 1500 mm^2/s at 40 degC"},
    // Lower: cold space hardware and superconductors; higher: oils decompose.
    {"lubricant.temperature", "200 K", "570 K", "-50 degC to 200 degC"},
    {"lubricant.viscosity_at.temperature", "200 K", "570 K", "40 degC and 100 degC"},
    {"deviations.temperature", "200 K", "570 K", "-50 degC to 200 degC"},
    {"deviations.reference_temperature", "200 K", "570 K", "20 degC"},
    // Hydrocarbons to perfluoropolyethers.
    {"lubricant.density", "600 kg/m^3", "2100 kg/m^3", "mineral oil has 860 kg/m^3 to 900 kg/m^3"},
    {"lubricant.pressure_viscosity", "3 1/GPa", "60 1/GPa", "oils have 10 1/GPa to 35 1/GPa"},
    {"lubricant.eyring_stress", "0.5 MPa", "50 MPa", "oils have 2 MPa to 20 MPa"},
    // Full films to steel on steel without oil.
    {"wear.coefficient", "1e-13 mm^3/(N m)", "1e-2 mm^3/(N m)", "lubricated steel has about 1e-8 mm^3/(N m)"},
    // Conductivity: water-like oils to filled greases. Below: titanium and austenite to copper alloys.
    {"lubricant.film.inlet_heating.conductivity", "0.05 W/(m K)", "0.7 W/(m K)",
     "oils have 0.12 W/(m K) to 0.16 W/(m K)"},
    {"lubricant.film.inlet_heating.temperature_coefficient", "0.005 1/K", "0.2 1/K", "oils have 0.02 1/K to 0.06 1/K"},
    {"materials.conductivity", "0.1 W/(m K)", "430 W/(m K)", "bearing steel has 45 W/(m K)"},
    {"materials.specific_heat", "100 J/(kg K)", "3000 J/(kg K)", "steel has 460 J/(kg K)"},
    {"heat.ambient", "200 K", "570 K", "-50 degC to 200 degC"},
    {"heat.start", "200 K", "570 K", "-50 degC to 200 degC"},
    // A nut of a few mm in still air to one cooled by oil.
    {"heat.conductance.screw_ambient", "", "1000 W/K", "some W/K through bearings and housing"},
    {"heat.conductance.nut_ambient", "", "1000 W/K", "some W/K through seat and housing"},
    {"heat.conductance.rollers_ambient", "", "1000 W/K", "none, in a closed nut"},
    {"heat.specific_heat", "100 J/(kg K)", "3000 J/(kg K)", "steel has 460 J/(kg K)"},
    {"carrier.roller_torque", "", "50 N m", "some mN m"},
    {"structure.masses.mass", "", "100 t", "up to some tonnes"},
    {"response.load.mass", "", "10000 t", "up to some hundred tonnes"},
    {"measures.friction_coefficient", "0.001", "0.3", "catalogues have 0.01"},
    {"measures.yield_strength", "100 MPa", "4 GPa", "steel has 300 MPa to 2 GPa"},
    {"measures.system.shaft.length", "5 mm", "20 m", "ten to a hundred screw diameters"},
    {"measures.system.support_bearing", "1 N/um", "100 kN/um", "bearings have 100 N/um to 3 kN/um"},
    {"bearings.fixed.stiffness", "1 N/um", "100 kN/um", "bearings have 100 N/um to 3 kN/um"},
    {"measures.system.housing", "1 N/um", "1000 kN/um", "housings have 10 N/um to 10 kN/um"},
    {"measures.shaft.length", "5 mm", "20 m", "ten to a hundred screw diameters"},
};

/// Whether the path is that of the row or of one of its parts.
bool is_of(std::string_view path, std::string_view row) {
  if (path == row) return true;
  for (const Part p : kParts) {
    const std::string part = fmt::format(".{}", name(p));
    const std::size_t at = path.find(part);
    if (at == std::string_view::npos || path.size() != row.size() + part.size()) continue;
    if (path.substr(0, at) == row.substr(0, at) && path.substr(at + part.size()) == row.substr(at)) return true;
  }
  return false;
}

double end_of(std::string_view text, const Dimension* dimension, double where_absent) {
  if (text.empty()) return where_absent;
  return dimension ? parse_quantity(text, *dimension).value.value() : parse_number(text).value();
}

/// Number with a unit that makes it usual, the nearest by powers of a thousand; empty if there is none.
std::string usual_unit(const EchoEntry& field, double least, double greatest) {
  const auto written = split_unit(field.written);
  if (!written || !field.dimension) return {};
  const Unit* found = nullptr;
  double fewest = HUGE_VAL;  // Powers of a thousand.
  for (const Unit& unit : field.dimension->units) {
    const auto si = to_si(written->number, unit);
    if (!si || std::abs(*si) < least || std::abs(*si) > greatest) continue;
    const double powers = std::abs(std::log10(std::abs(*si / *field.number))) / 3.0;
    const bool is_power = std::abs(powers - std::round(powers)) < 1e-9;
    if (found && !(is_power && powers < fewest)) continue;
    found = &unit;
    fewest = is_power ? powers : HUGE_VAL;
  }
  return found ? fmt::format("{:.10g} {}", written->number, found->spellings[0]) : std::string();
}

std::string range_text(const UsualValue& row) {
  if (row.least.empty()) return fmt::format("up to {}", row.greatest);
  return fmt::format("{} to {}", row.least, row.greatest);
}

}  // namespace

std::vector<Warning> unusual_values(const std::vector<EchoEntry>& fields) {
  std::vector<Warning> warnings;
  for (const EchoEntry& field : fields) {
    if (field.is_default || !field.number) continue;
    const std::string path = without_places(field.path);
    const auto row = std::ranges::find_if(kUsual, [&](const UsualValue& u) { return is_of(path, u.path); });
    if (row == std::end(kUsual)) continue;
    const double least = end_of(row->least, field.dimension, 0.0);
    const double greatest = end_of(row->greatest, field.dimension, std::numeric_limits<double>::infinity());
    const double size = std::abs(*field.number);
    if (size >= least && size <= greatest) continue;
    const std::string unit = usual_unit(field, least, greatest);
    warnings.push_back(Warning{field.path, "unusual_value",
                               fmt::format("got {}; usual is {} ({})", field.written, range_text(*row), row->example),
                               unit.empty() ? "check value and unit" : fmt::format("check the unit: `{}`?", unit)}
                           .with(size, size < least ? least : greatest, {},
                                 size < least ? Warning::Worse::smaller : Warning::Worse::larger));
  }
  return warnings;
}

}  // namespace prs::input
