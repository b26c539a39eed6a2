#include "prs/input/written_case.h"

#include <algorithm>

#include "prs/input/document.h"

namespace prs::input {
namespace {

/// Behind the bracket that closes the one at `at`; npos where none does.
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

/// Behind a value that stands on one line; npos where it does not.
std::size_t end_of_value(std::string_view text, const Node& node) {
  const std::size_t at = node.place.offset;
  if (at >= text.size()) return text.npos;
  const char first = text[at];
  if (first == '{' || first == '[') return end_of_brackets(text, at);
  if (first == '"' || first == '\'') {
    const std::size_t end = text.find(first, at + 1);
    return end == text.npos ? end : end + 1;
  }
  const bool is_plain = node.kind == Node::Kind::scalar && !node.text.empty() &&
                        text.substr(at).starts_with(node.text);
  return is_plain ? at + node.text.size() : text.npos;
}

/// `nut_tilt: {z: 0.1 deg}` of `nut_tilt.z`
std::string entry(std::string_view path, const std::string& value) {
  const std::size_t dot = path.find('.');
  if (dot == path.npos) return std::string(path) + ": " + value;
  return std::string(path.substr(0, dot)) + ": {" + entry(path.substr(dot + 1), value) + "}";
}

/// Adds a value to the innermost map on its path that stands in the text.
bool insert(std::string& text, const Node& root, const std::string& path,
            const std::string& value) {
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
  for (std::size_t k = 0; k < a.children.size(); ++k) {
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
  document_of(source);  // Wrong as it was given: that is the error to tell.
  return std::nullopt;
}

}  // namespace prs::input
