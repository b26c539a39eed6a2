#include "prs/mechanism/nut_harmonics.h"

#include "fe/oval_shell.h"

namespace prs {

std::vector<NutHarmonic> nut_harmonics(const NutLine& line, const NutBore& bore,
                                       const Material& material, int rollers, int highest) {
  std::vector<NutHarmonic> harmonics;
  for (int n = 2; n <= highest; ++n) {
    if (n % rollers == 0) continue;
    NutHarmonic harmonic{n, {}};
    for (std::size_t i = 0; i < line.outer_radius.size(); ++i) {
      const auto same = [&](std::size_t k) {
        return line.outer_radius[k] == line.outer_radius[i] && bore.root[k] == bore.root[i] &&
               std::abs(line.length(k) - line.length(i)) <= 1e-12 * line.length(i);
      };
      std::size_t k = 0;
      while (k < i && !same(k)) ++k;
      harmonic.segments.push_back(
          k < i ? harmonic.segments[k]
                : fe::stiffness_matrix(
                      fe::oval_tube(n, bore.pitch, bore.root[i], line.outer_radius[i],
                                    material.youngs_modulus, material.poisson_ratio),
                      line.length(i)));
    }
    harmonics.push_back(std::move(harmonic));
  }
  return harmonics;
}

}  // namespace prs
