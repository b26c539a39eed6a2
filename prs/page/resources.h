#pragma once

#include <string_view>

namespace prs {

// Files of prs/page/live and the engine, as they were when the program was built.
std::string_view page_style();
std::string_view page_script();
std::string_view worker_script();
std::string_view engine_loader();

}  // namespace prs
