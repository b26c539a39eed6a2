#include "prs/input/echo.h"

#include <algorithm>
#include <unordered_map>

namespace prs::input {
namespace {

std::string_view stripped(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

/// Where the comment of a line begins, at its `#`; npos without one.
std::size_t comment_in(std::string_view line) {
  char quote = 0;
  for (std::size_t k = 0; k < line.size(); ++k) {
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
  std::string_view value;  ///< Empty: whatever stands there.
  std::string_view reason;
};

std::optional<Mark> mark_in(std::string_view comment) {
  constexpr std::string_view kWord = "assumed";
  if (!comment.starts_with(kWord)) return std::nullopt;
  comment.remove_prefix(kWord.size());
  if (!comment.starts_with(' ') && !comment.starts_with(':')) return std::nullopt;
  int depth = 0;
  for (std::size_t k = 0; k < comment.size(); ++k) {
    const char c = comment[k];
    depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
    if (c == ':' && depth == 0)
      return Mark{stripped(comment.substr(0, k)), stripped(comment.substr(k + 1))};
  }
  return std::nullopt;
}

/// A value that stands by itself; absent where it is no YAML.
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

/// Marks the scalars of a value that are still as they were assumed; `was` null: all of them.
void mark(const Node& value, const Node* was, std::string_view reason, Reasons& reasons) {
  if (value.place.argument >= 0 || (was && was->kind != value.kind)) return;
  if (value.kind == Node::Kind::scalar && (!was || was->text == value.text))
    reasons.try_emplace(&value, reason);
  for (std::size_t k = 0; k < value.children.size(); ++k) {
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
    for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 1))
      starts_.push_back(at + 1);
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

/// The reasons of all scalars that comments mark.
Reasons marked(const Node& root, std::string_view text) {
  const FirstOnLine first(root, text);
  Reasons reasons;
  const auto take = [&](std::string_view comment, std::size_t line) {
    const std::optional<Mark> found = mark_in(comment);
    const Node* node = found ? first[line] : nullptr;
    if (!node) return;
    if (found->value.empty()) return mark(*node, nullptr, found->reason, reasons);
    if (const std::optional<Node> was = value_of(found->value))
      mark(*node, &*was, found->reason, reasons);
  };
  std::string above;  // The mark on the lines before, and whether the next one may continue it.
  bool is_open = false;
  std::size_t number = 0;
  for (std::size_t at = 0; at < text.size(); ++number) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    at = end + 1;
    const std::size_t hash = comment_in(line);
    const std::string_view comment =
        hash == line.npos ? std::string_view() : stripped(line.substr(hash + 1));
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

/// The reason of a value all of whose scalars are marked; null for others.
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

std::map<std::string, std::string> assumptions(const std::vector<EchoEntry>& entries,
                                               const Source& source) {
  std::map<std::string, std::string> all;
  if (entries.empty()) return all;
  ErrorList errors(source);
  const Node root = read_document(source, errors);
  const Reasons reasons = marked(root, source.text);
  for (const EchoEntry& entry : entries) {
    if (entry.is_default) continue;
    const Node* node = find_path(root, entry.path);
    if (const std::string* reason = node ? reason_of(*node, reasons) : nullptr)
      all.emplace(entry.path, *reason);
  }
  return all;
}

}  // namespace prs::input
