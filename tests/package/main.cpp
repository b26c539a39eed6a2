#include <cstdio>

#include "all_headers.h"

// Solves a case by the installed library and prints its document; then work on two threads, by an
// installed module.
int main(int, char** arguments) {
  const prs::Result result = prs::analyze(prs::input::read_case(arguments[1], {}, prs::Command::solve));
  std::puts(prs::json_text(prs::document_of(prs::solve_analysis(), result, {"", "", "", {}})).c_str());
  std::size_t sum = 0;
  prs::run_in_order(3, 2, [&](std::size_t k) { return [&sum, k] { sum += k; }; });
  return sum == 3 ? 0 : 1;
}
