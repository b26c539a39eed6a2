#pragma once

#include <nanobind/nanobind.h>

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "prs/record/pictures.h"

namespace prs::python {

/// A result document: made when it is first looked at, and kept. Threads may share it: what it
/// keeps is only touched by who has the interpreter, as whoever forks the process has.
class Document : public std::enable_shared_from_this<Document> {
 public:
  using Json = nlohmann::ordered_json;

  /// `pictures` keep what they show.
  explicit Document(std::function<Json()> make, Pictures pictures = {}, std::optional<bool> converged = std::nullopt)
      : make_(std::move(make)), pictures_(std::move(pictures)), converged_(converged) {}

  /// A document of the program. Throws std::invalid_argument where the text is none.
  static std::shared_ptr<Document> from_text(const std::string& text);

  const Json& json() const;

  /// Whether the command ends with 0; none of a document that was read.
  std::optional<bool> converged() const { return converged_; }

  /// As `--json` prints it.
  std::string text() const;

  /// Description of one picture as JSON text, see prs/record/pictures.h; of a document that was
  /// read, one of those that it holds. Throws std::invalid_argument where there is none.
  std::string figure(const std::string& name, const std::string& options, bool one_panel) const;

  /// Those that a command writes, as a list.
  std::string figures() const;
  bool has_pictures() const { return !pictures_.empty() || json().contains("figures"); }

  /// Numbers of an array within the document, null as NaN; they live as long as anyone uses them.
  std::shared_ptr<const std::vector<double>> numbers(const Json& array) const;

 private:
  mutable std::function<Json()> make_;
  Pictures pictures_;
  std::optional<bool> converged_;
  mutable std::unique_ptr<const Json> json_;
  mutable std::map<const Json*, std::shared_ptr<const std::vector<double>>> numbers_;
};

/// Pictures that keep the result that they show.
template <class Kept>
Pictures keeping(Pictures pictures, const std::shared_ptr<Kept>& kept) {
  for (Picture& picture : pictures)
    picture.make = [make = std::move(picture.make), kept](const FigureOptions& options) { return make(options); };
  return pictures;
}

/// An object within a document.
struct Node {
  std::shared_ptr<const Document> document;
  const Document::Json* json = nullptr;
};

void bind_document(nanobind::module_& module);

/// A read-only array of numpy on memory that lives as long as the array.
nanobind::object view(std::shared_ptr<const std::vector<double>> numbers, std::size_t rows);
nanobind::object view(std::shared_ptr<const std::vector<double>> numbers, std::size_t rows, std::size_t columns);

}  // namespace prs::python
