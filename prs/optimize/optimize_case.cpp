#include "prs/optimize/optimize_case.h"

#include <algorithm>

#include "prs/input/document.h"
#include "prs/text.h"

namespace prs {
namespace {

using input::ErrorList;
using input::Node;
using input::Source;

Node document_of(const Source& source) {
  ErrorList errors(source);
  Node root = input::read_document(source, errors);
  errors.throw_if_any();
  return root;
}

/// The document as text, the keys of its maps in alphabetic order.
std::string in_order(Node node) {
  const auto sort = [](const auto& self, Node& map) -> void {
    for (Node& child : map.children) self(self, child);
    if (map.kind == Node::Kind::map) std::ranges::sort(map.children, {}, &Node::key);
  };
  sort(sort, node);
  return input::flow_text(node);
}

/// A piece of the text and what takes its place.
struct Edit {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string text = {};
};

/// `b: {c: value}` of `b.c`.
std::string nested(std::string_view rest, const std::string& value) {
  const std::size_t dot = rest.find('.');
  if (dot == std::string_view::npos) return fmt::format("{}: {}", rest, value);
  return fmt::format("{}: {{{}}}", rest.substr(0, dot), nested(rest.substr(dot + 1), value));
}

/// Adds a key to the map that has the longest part of the path: at the end of the file, else before
/// the first key of the map.
std::optional<Edit> insertion(const std::string& text, const Node& root, const std::string& path,
                              const std::string& value) {
  std::size_t dot = path.rfind('.');
  while (dot != std::string::npos && !input::find_path(root, path.substr(0, dot)))
    dot = dot == 0 ? std::string::npos : path.rfind('.', dot - 1);
  if (dot == std::string::npos) {
    const bool ended = text.empty() || text.back() == '\n';
    return Edit{text.size(), 0, fmt::format("{}{}\n", ended ? "" : "\n", nested(path, value))};
  }
  const Node& map = *input::find_path(root, path.substr(0, dot));
  if (map.kind != Node::Kind::map || map.children.empty()) return std::nullopt;
  const std::size_t at = map.children[0].key_place.offset;
  const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const std::string before = text.substr(line, at - line);
  const bool own_line = before.find_first_not_of(' ') == std::string::npos;
  return Edit{at, 0, nested(path.substr(dot + 1), value) + (own_line ? "\n" + before : ", ")};
}

/// The text with each override in the place of the scalar that it replaces, or added; none where
/// one has no such place.
std::optional<std::string> edited(const Source& source) {
  const Node root = document_of({source.name, source.text, {}});
  std::map<std::string, std::string> last;  // Later overrides of a path win.
  for (const std::string& text : source.overrides)
    last[text.substr(0, text.find('='))] = text.substr(text.find('=') + 1);
  std::vector<Edit> edits;
  for (const auto& [path, value] : last) {
    const Node* node = input::find_path(root, path);
    if (!node) {
      const std::optional<Edit> edit = insertion(source.text, root, path, value);
      if (!edit) return std::nullopt;
      edits.push_back(*edit);
      continue;
    }
    const std::size_t at = node->place.offset;
    if (node->kind != Node::Kind::scalar || node->quoted ||
        source.text.compare(at, node->text.size(), node->text) != 0)
      return std::nullopt;
    edits.push_back({at, node->text.size(), value});
  }
  std::ranges::stable_sort(edits, std::ranges::greater{}, &Edit::offset);
  std::string result = source.text;
  for (const Edit& edit : edits) result.replace(edit.offset, edit.length, edit.text);
  return result;
}

/// Maps and lists of maps over lines, the rest on one line each.
void write_block(const Node& node, std::size_t indent, std::string& text) {
  for (const Node& child : node.children) {
    text += fmt::format("{:{}}{}:", "", indent, child.key);
    if (child.kind == Node::Kind::map && !child.children.empty()) {
      text += '\n';
      write_block(child, indent + 2, text);
    } else if (child.kind == Node::Kind::sequence && !child.children.empty() &&
               child.children[0].kind == Node::Kind::map) {
      text += '\n';
      for (const Node& item : child.children)
        text += fmt::format("{:{}}- {}\n", "", indent + 2, input::flow_text(item));
    } else {
      text += fmt::format(" {}\n", input::flow_text(child));
    }
  }
}

}  // namespace

std::string case_with(const Source& source, const std::vector<std::string>& overrides,
                      const std::string& remark) {
  Source changed = source;
  changed.overrides.insert(changed.overrides.end(), overrides.begin(), overrides.end());
  const Node wanted = document_of(changed);
  const std::string expected = in_order(wanted);
  const std::string head = fmt::format("# {}\n", printable(remark));
  try {
    if (const std::optional<std::string> text = edited(changed);
        text && in_order(document_of({source.name, *text, {}})) == expected)
      return head + *text;
  } catch (const input::InputError&) {
    // Then the document is written anew.
  }
  std::string text = head;
  write_block(wanted, 0, text);
  return text;
}

}  // namespace prs
