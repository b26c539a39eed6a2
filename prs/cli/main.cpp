#include <string_view>

#include "prs/cli/run_prs.h"

int main(int argc, char** argv) {
  const bool validates = argc > 1 && argv[1] == std::string_view("validate");
  return validates ? prs::cli::run_validate(argc - 1, argv + 1) : prs::cli::run_prs(argc, argv);
}
