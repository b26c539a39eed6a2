// Example 3: a sweep of designs.
//
// `read_case` takes `path=value` as --set does, so a design is a case with other values. Here the
// number of rollers of lesson 5 goes from 6 to 10. More rollers share the load, but each costs
// friction and weight. Thousands of designs go faster by `prs study`.
//
//     ex3_sweep configs/05_standard_screw.yaml
#include <prs/case.h>
#include <prs/solve.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

int main(int count, char** arguments) try {
  const char* file = count > 1 ? arguments[1] : "configs/05_standard_screw.yaml";
  std::printf("rollers  stiffness, N/um  peak pressure, GPa\n");
  for (int rollers = 6; rollers <= 10; ++rollers) {
    const prs::Case design =
        prs::input::read_case(file, {"mechanism.rollers=" + std::to_string(rollers)}, prs::Command::solve);
    const prs::Result result = prs::analyze(design, prs::kManyDesigns);
    const prs::LoadCaseResult& tension = result.load_cases.front();
    if (!tension.converged()) continue;
    double pressure = 0.0;
    for (const prs::InterfaceLoads* side : {&tension.threads->screw, &tension.threads->nut})
      pressure = std::max(pressure, *std::max_element(side->peak_pressure.begin(), side->peak_pressure.end()));
    std::printf("%7d  %15.1f  %18.3f\n", rollers, 1e-6 * *tension.axial_stiffness, 1e-9 * pressure);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}

// Prints:
//
//     rollers  stiffness, N/um  peak pressure, GPa
//           6           1327.0               3.477
//           7           1416.9               3.343
//           8           1497.1               3.234
//           9           1569.7               3.142
//          10           1635.9               3.063
