#include "python/engine/document.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "prs/loads/load_analysis.h"
#include "prs/study/designs.h"
#include "python/engine/interpreter_guard.h"

namespace nb = nanobind;

namespace prs::python {
namespace {

using Json = Document::Json;

/// Largest depth; documents of the program have a dozen levels.
constexpr int kMostLevels = 64;

bool is_number_or_null(const Json& json) { return json.is_number() || json.is_null(); }

bool is_vector(const Json& json) {
  return json.is_array() && !json.empty() && std::ranges::all_of(json, is_number_or_null) &&
         std::ranges::any_of(json, &Json::is_number);
}

bool is_matrix(const Json& json) {
  return json.is_array() && !json.empty() && std::ranges::all_of(json, [&](const Json& row) {
           return row.is_array() && !row.empty() && row.size() == json.front().size() &&
                  std::ranges::all_of(row, is_number_or_null);
         });
}

nb::object text_object(const std::string& text) {
  return nb::steal(PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

/// Objects become nodes, arrays of numbers arrays of numpy, other arrays lists.
nb::object object_of(const std::shared_ptr<const Document>& document, const Json& json) {
  if (json.is_object()) return nb::cast(Node{document, &json});
  if (is_vector(json)) return view(document->numbers(json), json.size());
  if (is_matrix(json)) return view(document->numbers(json), json.size(), json.front().size());
  if (json.is_array()) {
    nb::list list;
    for (const Json& item : json) list.append(object_of(document, item));
    return list;
  }
  if (json.is_string()) return text_object(json.get_ref<const std::string&>());
  if (json.is_boolean()) return nb::bool_(json.get<bool>());
  if (json.is_number_unsigned()) return nb::int_(json.get<std::uint64_t>());
  if (json.is_number_integer()) return nb::int_(json.get<std::int64_t>());
  if (json.is_number()) return nb::float_(json.get<double>());
  return nb::none();
}

std::vector<double> numbers_of(const Json& array) {
  std::vector<double> numbers;
  for (const Json& item : array) {
    if (item.is_array()) {
      const std::vector<double> row = numbers_of(item);
      numbers.insert(numbers.end(), row.begin(), row.end());
    } else {
      numbers.push_back(item.is_number() ? item.get<double>() : kNoResponse);
    }
  }
  return numbers;
}

nb::capsule owner_of(std::shared_ptr<const std::vector<double>> numbers) {
  using Shared = std::shared_ptr<const std::vector<double>>;
  return nb::capsule(new Shared(std::move(numbers)),
                     [](void* shared) noexcept { delete static_cast<Shared*>(shared); });
}

}  // namespace

std::shared_ptr<Document> Document::from_text(const std::string& text) {
  const auto bounded = [](int depth, Json::parse_event_t, Json&) {
    if (depth > kMostLevels) throw std::invalid_argument("no result document: nested too deeply");
    return true;
  };
  try {
    auto json = std::make_shared<Json>(Json::parse(text, bounded));
    if (!json->is_object() || !json->contains("prs_version"))
      throw std::invalid_argument("no result document: expected what `to_json` or `prs --json` wrote");
    return std::make_shared<Document>([json] { return *json; });
  } catch (const Json::exception& error) {
    throw std::invalid_argument(std::string("no result document: ") + error.what());
  }
}

const Json& Document::json() const {
  if (!json_) {
    auto made = [make = make_] {
      const GilRelease released;
      return std::make_unique<const Json>(make());
    }();
    if (!json_) json_ = std::move(made);
    make_ = nullptr;
  }
  return *json_;
}

std::string Document::text() const {
  const Json& written = json();
  const GilRelease released;
  return json_text(written);
}

std::string Document::figure(const std::string& name, const std::string& options, bool one_panel) const {
  if (pictures_.empty()) {
    const Json& written = json();
    const bool is_plain = options == "{}";
    if (is_plain && written.contains("figures"))
      for (const Json& drawn : written["figures"])
        if (drawn.value("name", "") == name) return drawn.dump();
    throw std::invalid_argument("a result that was read from JSON has no picture " + name +
                                (is_plain ? "" : " " + options) +
                                "; run the case again, or write the result with `prs --figures --json`");
  }
  const GilRelease released;
  try {
    FigureOptions chosen = figure_options(options);
    chosen.one_panel = one_panel;
    return to_json(prs::figure(pictures_, name, chosen)).dump();
  } catch (const NoFigure& error) {
    throw std::invalid_argument(error.what());
  }
}

std::string Document::figures() const {
  if (pictures_.empty() && json().contains("figures")) return json()["figures"].dump();
  const GilRelease released;
  return to_json(prs::figures(pictures_)).dump();
}

std::shared_ptr<const std::vector<double>> Document::numbers(const Json& array) const {
  std::shared_ptr<const std::vector<double>>& kept = numbers_[&array];
  if (!kept) kept = std::make_shared<const std::vector<double>>(numbers_of(array));
  return kept;
}

nb::object view(std::shared_ptr<const std::vector<double>> numbers, std::size_t rows) {
  const double* data = numbers->data();
  return nb::cast(nb::ndarray<nb::numpy, const double, nb::ndim<1>>(data, {rows}, owner_of(std::move(numbers))));
}

nb::object view(std::shared_ptr<const std::vector<double>> numbers, std::size_t rows, std::size_t columns) {
  const double* data = numbers->data();
  return nb::cast(
      nb::ndarray<nb::numpy, const double, nb::ndim<2>>(data, {rows, columns}, owner_of(std::move(numbers))));
}

void bind_document(nb::module_& module) {
  nb::class_<Node>(module, "Node", "An object within a result document.")
      .def(
          "keys",
          [](const Node& node) {
            nb::list keys;
            for (const auto& item : node.json->items()) keys.append(text_object(item.key()));
            return keys;
          },
          nb::sig("def keys(self) -> list[str]"))
      .def("text", [](const Node& node) { return json_text(*node.json); })
      .def_static(
          "of_text",
          [](const std::string& text) {
            const auto document = std::make_shared<Document>([json = Json::parse(text)] { return json; });
            return Node{document, &document->json()};
          },
          nb::arg("text"), "What `text` gave.")
      .def("__contains__", [](const Node& node, const std::string& key) { return node.json->contains(key); })
      .def(
          "get",
          [](const Node& node, const std::string& key) {
            const auto at = node.json->find(key);
            if (at == node.json->end()) throw nb::key_error(key.c_str());
            return object_of(node.document, *at);
          },
          nb::sig("def get(self, key: str) -> object"),
          "The value of a key: a number, a text, a read-only array, a node, or a list of them.");

  nb::class_<Document>(module, "Document", "A result document, as `--json` prints it.")
      .def_static(
          "from_text",
          [](const std::string& text) {
            const GilRelease released;
            return Document::from_text(text);
          },
          nb::arg("text"), "Reads what `text` gave. ValueError where the text is no document.")
      .def("text", &Document::text)
      .def_prop_ro("converged", &Document::converged)
      .def("figure", &Document::figure, nb::arg("name"), nb::arg("options") = "{}", nb::arg("one_panel") = false,
           "Description of a picture as JSON. ValueError where the result has none.")
      .def("figures", &Document::figures, "Descriptions of all pictures, a list as JSON.")
      .def_prop_ro("has_pictures", &Document::has_pictures,
                   "Whether any can be drawn; none of a document that was written without.")
      .def_prop_ro("root", [](const std::shared_ptr<Document>& document) {
        return Node{document, &document->json()};
      });
}

}  // namespace prs::python
