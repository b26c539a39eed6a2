#include "prs/sector/influence/matrix_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>

#include "prs/input/reader.h"
#include "prs/mechanism/full_influence.h"
#include "prs/sector/influence/influence_solver.h"
#include "prs/sha256.h"
#include "prs/threads/contacts.h"
#include "tests/fuzz/files.h"
#include "tests/fuzz/mutators.h"
#include "tests/fuzz/targets.h"
#include "tests/prs/input/abevi.h"

namespace prs::fuzz {
namespace {

constexpr double kForce = 2000.0;  // [N]

const std::string kMeshedCase = input::kAbeviThreads + R"(  rollers: 4
  contacts_per_roller: 2
structure:
  screw: {free_length: 10 mm}
  roller: {end_length: 5 mm, end_diameter: 5 mm}
  nut: {length: 20 mm, outer_diameter: 46 mm, thrust: {tension: 0 mm, compression: 20 mm},
        shoulder: {inner_diameter: 38 mm, outer_diameter: 44 mm}}
materials: {youngs_modulus: 209 GPa, poisson_ratio: 0.3}
model: {bodies: influence}
load_cases: [{axial_force: 2 kN, direction: tension, position: 9 mm}]
)";

struct Screw {
  Case values = input::read_case_text(kMeshedCase, "case.yaml", {}, Command::solve);
  Contacts contacts = find_contacts(values.mechanism, values.materials);
  PerInterface<ContactLaw> laws = contact_laws(values, contacts);
};

double sum(const std::vector<double>& loads) {
  for (const double load : loads) expect(std::isfinite(load) && load >= 0.0, "a load that cannot be");
  return std::accumulate(loads.begin(), loads.end(), 0.0);
}

/// Checks that, whatever the matrices, a converged result is an equilibrium of pushing forces.
void expect_equilibrium(const Screw& screw, const LoadDistribution& d) {
  if (!d.solve.converged()) return;
  for (const Interface i : kInterfaces) {
    const double axial = std::cos(screw.laws[i].normal_angle) * sum(d.normal_load[i]);
    const double force = kForce / screw.values.mechanism.rollers;
    expect(std::abs(axial - force) <= 1e-6 * force,
           fmt::format("the {} threads carry {} N of {} N", label(i), axial, force));
  }
  expect(std::isfinite(d.axial_displacement), "no displacement");
}

/// Solves the sector, then the full mechanism, with the matrices in the cache or computed ones. Throws NotKept.
void solve_both(MatrixCache& cache, std::size_t& solved) {
  static const Screw screw;
  const Case& c = screw.values;
  const LoadCase& load = c.load_cases.front();
  const InfluenceSolver sector =
      influence_solver(c, screw.contacts, screw.laws, *load.direction, *load.position, cache);
  expect_equilibrium(screw, sector.solve(kForce));
  solved = 1;
  const FullModel model =
      full_model(screw.contacts.mechanism, *c.structure, *c.materials, c.model, screw.laws, load, c.deviations);
  const FullDistribution full = solve(model, full_bodies(c, screw.contacts, screw.laws, model, cache));
  if (full.solve.converged())
    for (const Interface i : kInterfaces)
      for (const std::vector<double>& roller : full.normal_load[i]) sum(roller);
  solved = 2;
}

/// Solves with matrices that `next` gives for one key after the other; returns how many of the two were solved.
std::size_t solved_from(const std::function<std::optional<std::string>(const std::string& key)>& next) {
  const std::filesystem::path folder = scratch_folder() / "cache";
  std::filesystem::remove_all(folder);
  const CacheFolder files(folder);
  const MatrixCache whole(folder);
  std::string last;
  for (std::size_t solved = 0;;) try {
      MatrixCache kept(whole, MatrixCache::KeptOnly{});
      solve_both(kept, solved);
      return solved;
    } catch (const NotKept& missing) {
      const std::optional<std::string> matrices = next(missing.key());
      if (!matrices || missing.key() == last) return solved;  // The matrices were refused.
      last = missing.key();
      std::string content;
      put(content, last);
      content += *matrices;
      files.write(sha256(last), content + sha256(content));
    }
}

}  // namespace

std::size_t solved_with(std::string_view input) {
  const std::vector<std::string> contents = pieces(input, 16);
  std::size_t at = 0;
  return solved_from([&](const std::string&) -> std::optional<std::string> {
    if (at == contents.size()) return std::nullopt;
    return contents[at++];
  });
}

std::string whole_matrices() {
  const test::TemporaryDirectory folder;
  MatrixCache computing(folder.path());
  std::size_t solved = 0;
  solve_both(computing, solved);
  std::vector<std::string> contents;
  solved_from([&](const std::string& key) {
    const std::string file = *CacheFolder(folder.path()).read(sha256(key));
    const std::size_t head = 8 + key.size();
    return contents.emplace_back(file, head, file.size() - head - sha256("").size());
  });
  return joined(contents);
}

bool matrix_cache(std::string_view input) { return input.size() <= kLongest && solved_with(input) > 0; }

std::string mutated_cache(std::string_view input, std::size_t most, std::uint32_t seed) {
  Random random(seed);
  const auto below = [&](std::size_t count) { return fuzz::below(count, random); };
  std::vector<std::string> files = pieces(input, 16);
  if (files.empty()) return std::string(input);
  for (std::size_t left = 1 + below(3); left > 0; --left) {
    std::string& content = files[below(files.size())];
    if (content.size() < 8) continue;
    // Position of one of the numbers: number of matrices, then rows, columns, values of each.
    const std::size_t at = 8 * below(content.size() / 8);
    double value = 0.0;
    std::memcpy(&value, content.data() + at, 8);
    constexpr double kOdd[] = {0.0, 1.0, -1.0, 1e300, 1e-300, 1e-9, HUGE_VAL};
    switch (below(6)) {
      case 0:
        value = kOdd[below(std::size(kOdd))];
        break;
      case 1:
        value = -value;
        break;
      case 2:
        value *= std::pow(10.0, static_cast<double>(below(13)) - 6.0);
        break;
      case 3: {
        const std::uint64_t size = below(7);
        std::memcpy(&value, &size, 8);
        break;
      }
      case 4:
        content.resize(at);
        continue;
      default:
        content.insert(at, content.substr(at, 8 * (1 + below(4))));
        continue;
    }
    std::memcpy(content.data() + at, &value, 8);
  }
  const std::string text = joined(files);
  return text.size() <= most ? text : std::string(input);
}

}  // namespace prs::fuzz
