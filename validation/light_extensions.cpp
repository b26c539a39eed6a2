#include "validation/extensions.h"

namespace prs {

std::vector<SourceExtension> extensions() {
  std::vector<SourceExtension> all{abevi_2015::extension(), reference_fe::extension()};
  for (const char* folder : {"jung_2017", "sandu_2018", "standard_screws", "yao_2023"})
    all.push_back({.folder = folder, .is_built = false});
  return all;
}

}  // namespace prs
