// Example 2: a sector built by hand.
//
// One roller with its share of screw and nut: three rows of bars, joined by Hertz springs that push
// and never pull. The screw is pulled at the end where the nut is held:
//
//     nut     |=o===o===o===o      held here
//               |   |   |   |      springs, N = k delta^1.5
//     roller    o===o===o===o
//               |   |   |   |
//     screw F <=o===o===o===o
//
// The model (nodes, elements, supports) is constant, the state (displacements) is what Newton's
// method finds. Rigid bars share the load equally, u = 2 (F/(n k))^(2/3); of steel, the first
// thread carries most and the last one least.
#include <prs/fe/model.h>
#include <prs/fe/newton.h>

#include <cmath>
#include <cstdio>

constexpr int kThreads = 8;
constexpr double kPitch = 1e-3, kHertz = 2e10, kForce = 4000.0;  // [m], [N/m^1.5], [N]

void solve(const char* name, double rigidity) {
  fe::Model model;
  int screw[kThreads], roller[kThreads], nut[kThreads];
  for (int k = 0; k < kThreads; ++k) {
    for (int* body : {screw, roller, nut}) {
      body[k] = model.add_node();
      if (k > 0) model.bars.push_back({body[k - 1], body[k], {rigidity, kPitch}});
    }
    // Approach of the first point to the second, against x: the screw pulls the roller.
    model.springs.push_back({{screw[k]}, {roller[k]}, -1.0, 0.0, {kHertz}});
    model.springs.push_back({{roller[k]}, {nut[k]}, -1.0, 0.0, {kHertz}});
  }
  model.fixed_supports.push_back({nut[0], fe::Dof::u});

  const fe::Equations equations(model);
  const Eigen::VectorXd load = equations.load_vector({{screw[0], fe::Dof::u, -kForce}});
  fe::NewtonSolver solver(equations);
  fe::NewtonOptions options;
  options.force_scale = kForce;
  fe::State state(Eigen::VectorXd::Zero(equations.size()));
  const fe::NewtonSummary summary = solver.solve(load, options, state);

  std::printf("%s bars: %s, screw moves %.4f um\n ", name, fe::name(summary.status).data(),
              -1e6 * equations.displacement(state, screw[0], fe::Dof::u));
  double sum = 0.0;
  for (int k = 0; k < kThreads; ++k) {
    const double force = equations.response(state, 2 * k).force;
    sum += force;
    std::printf(" %6.2f", 100.0 * force / kForce);
  }
  std::printf(" %%, sum %.6f kN\n", 1e-3 * sum);
}

int main() {
  solve("rigid", 1e13);
  std::printf("  closed form: %.4f um, %.2f %% each\n", 2e6 * std::pow(kForce / (kThreads * kHertz), 2.0 / 3.0),
              100.0 / kThreads);
  solve("steel", 210e9 * 20e-6);  // E A of 20 mm^2
}

// Prints:
//
//     rigid bars: converged, screw moves 17.0998 um
//        12.50  12.50  12.50  12.50  12.50  12.50  12.50  12.50 %, sum 4.000000 kN
//       closed form: 17.0998 um, 12.50 % each
//     steel bars: converged, screw moves 20.8101 um
//        16.78  14.90  13.41  12.26  11.38  10.76  10.35  10.15 %, sum 4.000000 kN
