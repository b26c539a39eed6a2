#include "validation/extensions.h"

namespace prs {

std::vector<SourceExtension> extensions() {
  return {abevi_2015::extension(), jung_2017::extension(),       reference_fe::extension(),
          sandu_2018::extension(), standard_screws::extension(), yao_2023::extension()};
}

}  // namespace prs
