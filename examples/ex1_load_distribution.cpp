// Example 1: the load distribution of a case.
//
// A case is a YAML file, here lesson 5, a standard screw of 30 x 10 mm. `read_case` checks it for a
// command, `analyze` solves it. The result holds SI units, and in every list thread 1 stands first,
// next to the loaded end of the screw. In tension the nut's threads carry most at both ends, as the
// lesson says.
//
//     ex1_load_distribution configs/05_standard_screw.yaml
#include <prs/case.h>
#include <prs/solve.h>

#include <cstdio>
#include <exception>

int main(int count, char** arguments) try {
  const char* file = count > 1 ? arguments[1] : "configs/05_standard_screw.yaml";
  const prs::Result result = prs::analyze(prs::input::read_case(file, {}, prs::Command::solve));

  for (const prs::LoadCaseResult& answer : result.load_cases) {
    if (!answer.converged()) continue;
    std::printf("%s: %.2f um, %.1f N/um\n", answer.load_case.name.c_str(), 1e6 * *answer.axial_displacement,
                1e-6 * *answer.axial_stiffness);
    std::printf("  thread  screw, %%  nut, %%\n");
    const prs::InterfaceLoads& screw = answer.threads->screw;
    const prs::InterfaceLoads& nut = answer.threads->nut;
    const std::size_t last = screw.load_rate.size() - 1;
    for (const std::size_t k : {std::size_t{0}, last / 2, last})
      std::printf("  %6zu  %8.3f  %6.3f\n", k + 1, 100.0 * screw.load_rate[k], 100.0 * nut.load_rate[k]);
  }
} catch (const std::exception& error) {
  // The error of a wrong input contains file, line, key, what was found, what is allowed and how to fix it.
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}

// Prints:
//
//     tension: 36.68 um, 1635.9 N/um
//       thread  screw, %  nut, %
//            1     4.885   3.773
//           18     2.743   2.471
//           35     1.426   3.453
//     compression: 36.49 um, 1644.2 N/um
//       thread  screw, %  nut, %
//            1     5.654   2.451
//           18     2.613   3.060
//           35     1.786   2.319
