#pragma once

#include <string>

namespace prs {

struct OutputFile {
  std::string name;  ///< Inside the output directory.
  std::string content;
};

}  // namespace prs
