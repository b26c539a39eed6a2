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

/// A result document: computed when it is first read, and kept. Threads may share it: its cached data are only accessed
/// by the thread with the interpreter, also when the process forks.
class Document : public std::enable_shared_from_this<Document> {
 public:
  using Json = nlohmann::ordered_json;

  /// `pictures`: must own the data that they draw.
  explicit Document(std::function<Json()> make, Pictures pictures = {}, std::optional<bool> converged = std::nullopt)
      : make_(std::move(make)), pictures_(std::move(pictures)), converged_(converged) {}

  /// A document of the program from its text. Throws std::invalid_argument for other texts.
  static std::shared_ptr<Document> from_text(const std::string& text);

  const Json& json() const;

  /// Whether the command ends with 0; none for a document from a text.
  std::optional<bool> converged() const { return converged_; }

  /// Text as printed by `--json`.
  std::string text() const;

  /// Description of one picture as JSON text, see prs/record/pictures.h; for a document from a text, one of those that
  /// it contains. Throws std::invalid_argument if there is none.
  std::string figure(const std::string& name, const std::string& options, bool one_panel) const;

  /// List of the pictures that a command writes.
  std::string figures() const;
  bool has_pictures() const { return !pictures_.empty() || json().contains("figures"); }

  /// Numbers of an array within the document, null as NaN; they live as long as they are used.
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

/// A read-only numpy array on memory that lives as long as the array.
nanobind::object view(std::shared_ptr<const std::vector<double>> numbers, std::size_t rows);
nanobind::object view(std::shared_ptr<const std::vector<double>> numbers, std::size_t rows, std::size_t columns);

}  // namespace prs::python
