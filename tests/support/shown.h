#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prs/record/pictures.h"

namespace test {

/// Picture with that name; absent if the result has no data for it.
inline std::optional<prs::Figure> shown(const prs::Pictures& pictures, const std::string& name,
                                        const prs::FigureOptions& options = {}) try {
  return prs::figure(pictures, name, options);
} catch (const prs::NoFigure&) {
  return std::nullopt;
}

inline std::vector<std::string> names(const prs::Figures& figures) {
  std::vector<std::string> names;
  for (const prs::Figure& figure : figures) names.push_back(figure.name);
  return names;
}

}  // namespace test
