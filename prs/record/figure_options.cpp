#include <nlohmann/json.hpp>

#include "prs/record/figure_json.h"
#include "prs/record/pictures.h"

namespace prs {

FigureOptions figure_options(const std::string& text) {
  using Json = nlohmann::ordered_json;
  FigureOptions options;
  try {
    const Json given = Json::parse(text);
    for (const auto& [key, value] : given.items()) {
      if (key == "load_cases") {
        options.load_cases = value.get<std::vector<std::size_t>>();
      } else if (key == "load_case") {
        options.load_case = value.get<std::size_t>();
      } else if (key == "thread") {
        options.thread = value.get<std::size_t>();
      } else if (key == "panel") {
        options.panel = value.get<std::size_t>();
      } else if (key == "one_panel") {
        options.one_panel = value.get<bool>();
      } else if (key == "response") {
        options.response = value.get<std::string>();
      } else if (key == "x") {
        options.x = value.get<std::string>();
      } else if (key == "y") {
        options.y = value.get<std::string>();
      } else if (key == "interface" && (value == "screw" || value == "nut")) {
        options.interface = value == "screw" ? Interface::screw : Interface::nut;
      } else {
        throw NoFigure("options of a picture: got " + key + ": " + value.dump());
      }
    }
  } catch (const Json::exception& error) {
    throw NoFigure(std::string("options of a picture: ") + error.what());
  }
  return options;
}

nlohmann::ordered_json to_json(const Figures& figures) {
  auto list = nlohmann::ordered_json::array();
  for (const Figure& figure : figures) list.push_back(to_json(figure));
  return list;
}

}  // namespace prs
