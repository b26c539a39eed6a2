#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/temporary_directory.h"

namespace test {

/// Writes a case with a Monte Carlo study of this many samples: solves of a published screw, a few of them refused; two
/// responses, for few pictures.
inline void write_study_file(const std::filesystem::path& path, std::size_t samples) {
  std::string text = content_of(PRS_SOURCE_DIR "/configs/01_config_1_to_3.yaml");
  text += fmt::format(R"(
study:
  command: solve
  plan: monte_carlo
  samples: {}
  seed: 3
  responses: [axial_stiffness_N_per_um, screw.load_rate_percent.max]
  factors:
    - {{path: structure.nut.outer_diameter, uniform: {{from: 44 mm, to: 48 mm}}}}
    - {{path: structure.screw.bore, uniform: {{from: 0 mm, to: 21.01 mm}}}}
    - {{path: 'load_cases[0].axial_force', log_uniform: {{from: 1 kN, to: 100 kN}}}}
    - {{path: structure.roller.guidance, values: [both_end_nodes, outer_node]}}
)",
                      samples);
  std::ofstream(path) << text;
}

}  // namespace test
