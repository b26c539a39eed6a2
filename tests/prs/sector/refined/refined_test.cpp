#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>

#include "fe/cholesky.h"
#include "prs/model/problems.h"
#include "prs/sector/refined/local_compliance.h"
#include "prs/sector/refined/nut_shell.h"
#include "prs/sector/sector.h"
#include "support/count.h"
#include "support/sectors.h"
#include "support/sum.h"

namespace prs {
namespace {

using std::numbers::pi;
using test::abevi;
using test::SectorCase;
using test::sum;
using RollerContacts = ModelOptions::RollerContacts;

constexpr RefinedEffects kNone{false, false, false, false, false, false, false};

SectorCase refined(SectorCase c, const RefinedEffects& effects = {}) {
  c.options.bodies = &kRefined;
  c.options.refined = effects;
  return c;
}

SectorCase with_contacts(SectorCase c, RollerContacts contacts) {
  c.options.roller_contacts = contacts;
  return c;
}

/// CONFIG 1 to 3, tension and compression.
std::vector<SectorCase> six_cases() {
  std::vector<SectorCase> cases;
  for (const double position : {54.3333333e-3, 29.1666667e-3, 4e-3})
    for (const Direction direction : {Direction::tension, Direction::compression}) {
      SectorCase c = abevi();
      c.position = position;
      c.direction = direction;
      cases.push_back(c);
    }
  return cases;
}

LoadDistribution solve(const SectorCase& c, double force = 45e3) {
  SectorSolver solver(c.build());
  LoadDistribution r = solver.solve(force);
  EXPECT_TRUE(r.solve.converged()) << fe::name(r.solve.status) << r.solve.relative_residual;
  return r;
}

double largest_difference(const LoadDistribution& a, const LoadDistribution& b) {
  double d = 0.0;
  for (const Interface i : kInterfaces)
    for (std::size_t k = 0; k < a.normal_load[i].size(); ++k)
      d = std::max(d, std::abs(a.normal_load[i][k] - b.normal_load[i][k]));
  return d;
}

/// A random sector, refined, with some effects off; stated heights leave a wall and a core.
SectorCase random_refined(std::mt19937_64& random) {
  const auto flag = [&] { return std::uniform_int_distribution<int>(0, 3)(random) > 0; };
  SectorCase c = test::random_sector(random);
  const RefinedEffects effects{flag(), flag(), flag(), flag(), flag(), flag(), flag()};
  const double pitch = axial_pitch(c.mechanism);
  const double wall = c.structure.nut.outer_diameter - *c.mechanism.pitch_diameter.nut;
  if (flag())
    for (const Part p : kParts) c.mechanism.thread[p] = ThreadHeight{0.15 * pitch, std::min(0.18 * pitch, 0.1 * wall)};
  return refined(with_contacts(c, flag() ? RollerContacts::opposite : RollerContacts::half_pitch_apart), effects);
}

TEST(Refined, WithoutEffectsIsTheBarModel) {
  std::vector<SectorCase> cases = six_cases();
  std::mt19937_64 random(11);
  for (int k = 0; k < test::samples(50, 1000); ++k) cases.push_back(test::random_sector(random));
  for (const SectorCase& c : cases) {
    const double force = 2e3 * c.mechanism.rollers;
    const LoadDistribution bars = solve(c, force);
    const LoadDistribution same = solve(refined(with_contacts(c, RollerContacts::opposite), kNone), force);
    EXPECT_LE(largest_difference(bars, same), 1e-12 * force);
    EXPECT_NEAR(same.axial_displacement / bars.axial_displacement, 1.0, 1e-12);
    EXPECT_NEAR(*same.tangent_stiffness / *bars.tangent_stiffness, 1.0, 1e-12);
  }
}

TEST(Refined, EachEffectAloneHasItsSign) {
  for (const SectorCase& c : six_cases()) {
    const double bars = solve(c).axial_displacement;
    const auto increment = [&](bool RefinedEffects::*effect) {
      RefinedEffects effects = kNone;
      effects.*effect = true;
      return solve(refined(c, effects)).axial_displacement - bars;
    };
    EXPECT_GT(increment(&RefinedEffects::core), 0.5e-6);
    EXPECT_GT(increment(&RefinedEffects::shear), 0.5e-6);
    EXPECT_GT(increment(&RefinedEffects::hoop), 2e-6);
    EXPECT_GT(increment(&RefinedEffects::flange), 0.5e-6);
    EXPECT_GT(increment(&RefinedEffects::radial), 0.5e-6);
    EXPECT_LT(increment(&RefinedEffects::concentration), -0.5e-6);
  }
}

TEST(Refined, PoissonInTheScrewIsAnOffset) {
  // Without hoop the nut has nothing to couple with.
  RefinedEffects poisson = kNone;
  poisson.poisson = true;
  for (const SectorCase& c : six_cases()) {
    const LoadDistribution bars = solve(c), offset = solve(refined(c, poisson));
    EXPECT_LE(largest_difference(bars, offset), 1e-9);
    const double area = pi * (10.5e-3 * 10.5e-3 - 3e-3 * 3e-3);
    const double expected =
        -sense(c.direction) * 0.3 * std::tan(c.laws.screw.normal_angle) * 10.5e-3 / (209e9 * area) * 45e3;
    EXPECT_NEAR((offset.axial_displacement - bars.axial_displacement) / expected, 1.0, 1e-9);
    EXPECT_NEAR(1.0 / *offset.tangent_stiffness - 1.0 / *bars.tangent_stiffness, expected / 45e3,
                1e-9 * std::abs(expected / 45e3));
  }
}

TEST(Refined, PoissonOffsetIsThatOfCoupledDiscreteLoads) {
  // Axial and radial loads of a bar that shrinks by nu times its strain, load by load: half of a section's own force
  // acts on it.
  const double r = 10e-3, area = pi * r * r / 7.0, e = 209e9, nu = 0.3, psi = 0.7;
  const std::vector<double> n{300.0, 260.0, 250.0, 120.0, 310.0};
  double behind = 0.0, energy = 0.0;
  for (std::size_t k = n.size(); k-- > 0;) {
    const double own = n[k] * std::cos(psi);
    energy += n[k] * std::sin(psi) * nu * r / (e * area) * (behind + 0.5 * own);
    behind += own;
  }
  const double c = poisson_offset(-1.0, r, 0.0, {e, nu}, 7, psi);
  EXPECT_NEAR(0.5 * c * behind * behind / energy, 1.0, 1e-14);
  EXPECT_EQ(poisson_offset(1.0, r, 0.0, {e, nu}, 7, psi), -c);
}

/// Abevi's screw with its thrust on the inner face of the first flange and its contacts before the
/// idle end, from 87 mm to 88 mm of which a collar has this outer diameter.
SectorCase with_collar(double outer_diameter) {
  SectorCase c = abevi();
  c.structure.nut.flanges = {{0.0, 10e-3, 62e-3}, {87e-3, 88e-3, outer_diameter}};
  c.structure.nut.thrust = {.tension = 10e-3, .compression = 10e-3};
  c.position = 40e-3;
  return c;
}

TEST(Refined, AThinCollarOnTheIdleEndDoesNotStiffenTheNut) {
  for (const Direction direction : {Direction::tension, Direction::compression})
    for (const bool stated : {false, true}) {
      double before = 0.0;
      for (const double diameter : {46e-3, 40e-3, 37e-3, 36e-3, 35.4e-3}) {
        SectorCase c = with_collar(diameter);
        c.direction = direction;
        if (stated)
          for (const Part p : kParts) c.mechanism.thread[p] = ThreadHeight{0.25e-3, 0.30e-3};
        const double displacement = solve(refined(c)).axial_displacement;
        EXPECT_GE(displacement, before * (1.0 - 1e-12)) << diameter;
        before = displacement;
      }
    }
}

TEST(Refined, BarsOfTheNutDoNotFeelAThinCollarThatCarriesNothing) {
  RefinedEffects core = kNone;
  core.core = true;
  const LoadDistribution without = solve(refined(with_collar(46e-3), core));
  const LoadDistribution with = solve(refined(with_collar(36e-3), core));
  EXPECT_LE(largest_difference(without, with), 1e-9);
  EXPECT_NEAR(with.axial_displacement / without.axial_displacement, 1.0, 1e-12);
}

TEST(Refined, RootsUnderACollarLeaveAWall) {
  // Between the thrust section and the contacts, where all of the load passes: a bar between the
  // roots, 0.30 mm deep, 0.30 mm less a tenth of a pitch and half of the wall, and the collar.
  RefinedEffects core = kNone;
  core.core = true;
  const double pitch = 5e-3 / 3, wall[] = {5.5e-3, 0.5e-3, 0.4e-3, 0.2e-3};
  const double depth[] = {0.30e-3, 0.30e-3, 0.4e-3 - 0.1 * pitch, 0.1e-3};
  double without = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    SectorCase c = with_collar(46e-3);
    for (const Part p : kParts) c.mechanism.thread[p] = ThreadHeight{0.25e-3, 0.30e-3};
    const double outer = 17.5e-3 + wall[k];
    c.structure.nut.flanges[1] = {20e-3, 21e-3, 2.0 * outer};
    const auto compliance = [&](double inner, double radius) {
      return 1e-3 / (209e9 * pi * (radius * radius - inner * inner));
    };
    const double displacement = solve(refined(c, core)).axial_displacement;
    if (k == 0) without = displacement;
    const double expected = compliance(17.5e-3 + depth[k], outer) - compliance(17.8e-3, 23e-3);
    EXPECT_NEAR((displacement - without) / 45e3, expected, 1e-9 * expected + 1e-19) << k;
  }
}

TEST(Refined, AnInvertedScrewIsPlainBeforeItsContactsAStandardOneThreaded) {
  for (const auto type : {Mechanism::Type::inverted, Mechanism::Type::standard}) {
    SectorCase c = refined(abevi());
    c.mechanism.type = type;
    c.mechanism.thread.screw = ThreadHeight{0.25e-3, 0.30e-3};
    const LoadDistribution near = solve(c);
    c.structure.screw.free_length += 290e-3;
    const LoadDistribution far = solve(c);
    const double radius = type == Mechanism::Type::inverted ? 10.5e-3 : 10.2e-3;
    const double area = pi * (radius * radius - 3e-3 * 3e-3);
    EXPECT_NEAR((far.axial_displacement - near.axial_displacement) / (45e3 * 0.29 / (209e9 * area)), 1.0, 1e-9);
    EXPECT_LE(largest_difference(near, far), 1e-9 * 45e3);
  }
}

TEST(Refined, RandomSectorsConvergeAndCarryTheLoad) {
  std::mt19937_64 random(31);
  for (int k = 0; k < test::samples(200, 5000); ++k) {
    const SectorCase c = random_refined(random);
    const double force = test::random_force(c, random);
    SectorSolver solver(c.build());
    const LoadDistribution r = solver.solve(force);
    ASSERT_TRUE(r.solve.converged()) << k << ' ' << fe::name(r.solve.status) << ' ' << r.solve.relative_residual;
    for (const Interface i : kInterfaces)
      ASSERT_NEAR(sum(r.normal_load[i]) * std::cos(c.laws[i].normal_angle) * c.mechanism.rollers / force, 1.0, 1e-10)
          << k;
  }
}

TEST(Refined, RollerIsInMomentBalance) {
  const double p = 5e-3 / 3, radius = 3.5e-3, end = 5e-3, spring = 2e7;
  for (const RollerContacts contacts : {RollerContacts::opposite, RollerContacts::half_pitch_apart})
    for (SectorCase c : six_cases()) {
      c = refined(with_contacts(c, contacts));
      c.structure.roller.guidance = {Guidance::Kind::ring, spring};
      SectorSolver solver(c.build());
      const fe::Equations& equations = solver.equations();
      fe::NewtonSolver newton(equations);
      fe::State q = solver.equal_shares(45e3);
      ASSERT_TRUE(newton.solve(45e3 / 11 * solver.unit_load(), solver.newton_options(45e3), q).converged());
      const LoadDistribution r = solver.solve(45e3);
      const double s = sense(c.direction);
      const double apart = contacts == RollerContacts::opposite ? 0.0 : 0.25 * p;
      double radial = 0.0, moment = 0.0;
      for (std::size_t k = 0; k < 20; ++k) {
        const double x = static_cast<double>(k) * p;
        const double ns = r.normal_load.screw[k], nn = r.normal_load.nut[k];
        const double as = s * ns * std::cos(c.laws.screw.normal_angle);
        const double an = -s * nn * std::cos(c.laws.nut.normal_angle);
        const double rs = ns * std::sin(c.laws.screw.normal_angle);
        const double rn = -nn * std::sin(c.laws.nut.normal_angle);
        radial += rs + rn;
        // In tension the roller's flank at the screw faces along x.
        moment += (x - s * apart) * rs + (x + s * apart) * rn + radius * (as - an);
      }
      const double ends[] = {-p / 2 - end, -p / 2, 19.5 * p, 19.5 * p + end};
      for (std::size_t k = 0; k < 4; ++k) {
        const double v = equations.displacement(q, solver.sector().roller_end_nodes[k], fe::Dof::v);
        radial -= spring * v;
        moment -= spring * v * ends[k];
      }
      EXPECT_NEAR(radial, 0.0, 1e-9 * 45e3 / 11);
      EXPECT_NEAR(moment, 0.0, 1e-9 * 45e3 / 11 * radius);
    }
}

TEST(Refined, MirroredNutUnderTheOtherDirectionSharesInReverse) {
  for (const RollerContacts contacts : {RollerContacts::opposite, RollerContacts::half_pitch_apart}) {
    SectorCase c = refined(with_contacts(abevi(), contacts));
    c.materials.screw.youngs_modulus = 1e20;  // the screw has a loaded end
    c.structure.nut.flanges = {{0.0, 10e-3, 62e-3}, {70e-3, 90e-3, 55e-3}};
    c.structure.nut.thrust = {.tension = 10e-3, .compression = 80e-3};
    c.position = 12e-3;
    SectorCase mirrored = c;
    mirrored.direction = Direction::compression;
    mirrored.position = 90e-3 - 12e-3 - 19 * axial_pitch(c.mechanism);
    mirrored.structure.nut.flanges = {{0.0, 20e-3, 55e-3}, {80e-3, 90e-3, 62e-3}};
    const LoadDistribution a = solve(c);
    LoadDistribution b = solve(mirrored);
    for (const Interface i : kInterfaces) std::reverse(b.normal_load[i].begin(), b.normal_load[i].end());
    EXPECT_LT(largest_difference(a, b), 1e-8 * 45e3 / 11);
    EXPECT_NEAR(a.axial_displacement / b.axial_displacement, 1.0, 1e-9);
  }
}

/// A row of validation/reference_fe/data/curves.csv.
struct ReferenceRow {
  SectorCase sector;
  double force = 0.0;              ///< [N]
  double displacement = 0.0;       ///< [m]
  PerInterface<double> rates[20];  ///< Shares of the sector load.
};

std::vector<ReferenceRow> reference_rows() {
  std::ifstream in(PRS_SOURCE_DIR "/validation/reference_fe/data/curves.csv");
  SectorCase screw = abevi();
  for (const Part p : kParts) screw.mechanism.thread[p] = ThreadHeight{0.25e-3, 0.30e-3};
  std::vector<ReferenceRow> rows;
  std::string line;
  std::getline(in, line);
  EXPECT_TRUE(line.starts_with("config,direction,guidance,lever,load_kN,displacement_um,stiffness_N_per_um,screw_1_%"))
      << line;
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    int config = 0;
    std::string direction, guidance, lever;
    double force = 0.0, displacement = 0.0, stiffness = 0.0;
    fields >> config >> direction >> guidance >> lever >> force >> displacement >> stiffness;
    ReferenceRow r;
    r.sector = refined(
        with_contacts(screw, lever == "opposite" ? RollerContacts::opposite : RollerContacts::half_pitch_apart));
    r.sector.position = config == 1 ? 54.3333333e-3 : config == 2 ? 29.1666667e-3 : 4e-3;
    r.sector.direction = direction == "tension" ? Direction::tension : Direction::compression;
    if (guidance == "outer_node") r.sector.structure.roller.guidance.kind = Guidance::Kind::outer_node;
    r.force = 1e3 * force;
    r.displacement = 1e-6 * displacement;
    for (const Interface i : kInterfaces)
      for (PerInterface<double>& rate : r.rates) {
        fields >> rate[i];
        rate[i] *= 0.01;
      }
    EXPECT_TRUE(fields) << line;
    rows.push_back(r);
  }
  return rows;
}

TEST(Refined, IsWithinFivePercentOfCalculixAndOnePercentOfTheLoad) {
  const std::vector<ReferenceRow> rows = reference_rows();
  EXPECT_EQ(rows.size(), 3u * 2 * 2 * 2 * 13);
  for (const ReferenceRow& row : rows) {
    const LoadDistribution r = solve(row.sector, row.force);
    EXPECT_NEAR(row.displacement / r.axial_displacement, 1.0, 0.05) << row.force;
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < 20; ++k) {
        const double rate = r.normal_load[i][k] * std::cos(row.sector.laws[i].normal_angle) * 11 / row.force;
        EXPECT_NEAR(rate, row.rates[k][i], 0.010) << name(i) << ' ' << k + 1;
      }
  }
}

TEST(Refined, ApproachIsHertz) {
  const SectorCase c = refined(abevi());
  const LoadDistribution r = solve(c);
  for (const Interface i : kInterfaces)
    for (std::size_t k = 0; k < 20; ++k)
      EXPECT_NEAR(c.laws[i].hertz_constant * std::pow(r.approach[i][k], 1.5) / r.normal_load[i][k], 1.0, 1e-12);
}

TEST(Refined, ComplianceOfTheContactLawStandsInSeries) {
  // Two rigid bodies: the approach of equal contacts is Hertz's and the compliance's.
  SectorCase c = abevi();
  for (const Part p : kParts) c.materials[p].youngs_modulus = 1e18;
  c.options.roller = ModelOptions::Roller::rigid_bending;
  const double rigid = solve(c).axial_displacement;
  c.laws.screw.compliance = 3e-9;
  const double cosine = std::cos(c.laws.screw.normal_angle);
  EXPECT_NEAR((solve(c).axial_displacement - rigid) / (3e-9 * 45e3 / (220 * cosine * cosine)), 1.0, 1e-7);
}

TEST(LocalCompliance, RowsOnAHalfSpaceAreSumsOverTheirNeighbours) {
  // Boussinesq and Cerruti, 1/(|j| p) with (1 - nu^2)/(pi E) and 1/(2 pi G), against the line load
  // of the same density with its logarithm's zero at L.
  const Material steel{209e9, 0.3, {}};
  const double p = 1.7e-3, reach = 4e-3, psi = 0.6, rho = 1e-7;
  const int most = 2000000;
  double points = 0.0;
  for (int j = most; j > 0; --j) points += 2.0 / (j * p);
  const double line = 2.0 / p * std::asinh((most + 0.5) * p / rho);
  const double rest = 2.0 / p * std::log(reach / rho);
  const double normal = 0.91 / (pi * 209e9), tangential = 2.6 / (2.0 * pi * 209e9);
  const double expected =
      (std::pow(std::sin(psi), 2) * normal + std::pow(std::cos(psi), 2) * tangential) * (points - line + rest);
  EXPECT_NEAR(concentration_compliance<double>({reach, reach}, steel, p, std::sin(psi), std::cos(psi)) / expected, 1.0,
              1e-9);
}

TEST(LocalCompliance, ReachOfRowsRoundACylinder) {
  // Lines at equal angles, their mean taken away: ln(L/rho) = -ln(rho/r) - sum ln(chord/r).
  for (const double rows : {3.0, 11.0}) {
    double rest = 0.0;
    for (int k = 1; k < rows; ++k) rest -= std::log(2.0 * std::sin(pi * k / rows));
    EXPECT_NEAR(rows_around(0.01, rows).normal / (0.01 * std::exp(rest)), 1.0, 1e-12);
    EXPECT_EQ(rows_around(0.01, rows).tangential, rows_around(0.01, rows).normal);
  }
}

TEST(LocalCompliance, ReachOfOppositeRowsIsThatOfADisc) {
  // Fourier series of a disc, plane strain: under the pressure cos(n theta) a surface moves by
  // [2 (1 - nu) n - (1 - 2 nu)]/(n^2 - 1) r/(2 G); of two opposite lines n = 0 (half) and all even
  // n are left, of two opposed lines of shear 2/n for odd n, less n = 1. Logarithms are taken out
  // term by term: sum 2/n cos(n theta) over even n is -ln(2 sin theta), over odd n ln cot(theta/2).
  const double nu = 0.3;
  double normal = 0.5 * (1.0 - 2.0 * nu) / (1.0 - nu), tail = 0.0;
  for (int n = 2000000; n >= 2; n -= 2)
    tail += (2.0 * (1.0 - nu) * n - (1.0 - 2.0 * nu)) / (static_cast<double>(n) * n - 1.0) / (1.0 - nu) - 2.0 / n;
  normal += tail;  // ln(L/r) = this - ln(2 theta) + ln(theta)
  EXPECT_NEAR(opposite_rows(2e-3).normal / (2e-3 * std::exp(normal - std::log(2.0))), 1.0, 1e-5);
  EXPECT_NEAR(opposite_rows(2e-3).tangential / (2e-3 * std::exp(std::log(2.0) - 2.0)), 1.0, 1e-12);
}

TEST(LocalCompliance, CylindersAreLames) {
  // Solid: u = q r (1 - nu)/E with q = N sin(psi)/(2 pi r p).
  const Material steel{209e9, 0.3, {}};
  const double r = 10e-3, p = 1.5e-3, psi = 0.8, s = std::sin(psi);
  const double pressure = 9.0 * s / (2.0 * pi * r * p);
  EXPECT_NEAR(cylinder_compliance<double>(r, 0.0, steel, 9.0, p, s) / (pressure * r * 0.7 / 209e9 * s), 1.0, 1e-12);
  // Tube: inner displacement by Lame's stresses, less q r 2 pi/(E 2 pi ln(R/r)) of its shell.
  const double outer = 16e-3, a = r * r / (outer * outer - r * r) * pressure;
  const double hoop = a * (1.0 + outer * outer / (r * r));
  const double inner_displacement = r / 209e9 * (hoop + 0.3 * pressure);
  const double membrane = pressure * r / (209e9 * std::log(outer / r));
  EXPECT_NEAR(wall_compliance<double>(r, outer, steel, 9.0, p, s) / ((inner_displacement - membrane) * s), 1.0, 1e-12);
}

/// Share under a half-endless band of pressure at the distance x from its end, from Lur'e's
/// solution of the solid cylinder in waves cos(kz), r = 1:
///
///     u/q = 2 (1 - nu^2)/E/(k^2 (I_0/I_1)^2 - k^2 - 2 (1 - nu)).
double exact_band_share(double x, double nu) {
  const double dk = 2e-3;
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double k = (i + 0.5) * dk;
    double wave = 1.0 / k;  // asymptote, times (1 + nu)
    if (k < 50.0) {
      const double ratio = std::cyl_bessel_i(0.0, k) / std::cyl_bessel_i(1.0, k);
      wave = k < 0.05 ? 1.0 / (2.0 * (1.0 + nu)) : 1.0 / (k * k * (ratio * ratio - 1.0) - 2.0 * (1.0 - nu));
    }
    sum += std::sin(k * x) / k * 2.0 * (1.0 + nu) * wave * dk;
  }
  return 0.5 + sum / pi;
}

/// Shares at contacts of a band of pressure that ends half a pitch beyond them.
std::vector<double> band_shares(int contacts, double pitch, double radius, double nu) {
  const double decay = band_decay(radius, 0.0, nu);
  std::vector<double> shares;
  for (int k = 0; k < contacts; ++k)
    shares.push_back(1.0 - taken_by_end(decay, (k + 0.5) * pitch) - taken_by_end(decay, (contacts - k - 0.5) * pitch));
  return shares;
}

TEST(LocalCompliance, EndsOfABandTakeTheirShareAway) {
  const double r = 10.5e-3, p = 5e-3 / 3;
  const std::vector<double> shares = band_shares(60, p, r, 0.3);
  for (std::size_t k = 0; k < 30; ++k) EXPECT_NEAR(shares[k], shares[59 - k], 1e-14);
  EXPECT_NEAR(shares[30], 1.0, 1e-4);
  // The short waves at the very end are those of a half-plane, which the foundation approximates as softer.
  for (const std::size_t k : {0u, 1u, 2u, 4u, 7u})
    EXPECT_NEAR(shares[k], exact_band_share((static_cast<double>(k) + 0.5) * p / r, 0.3), 0.11);
  // Two bands that meet are one.
  EXPECT_NEAR(band_shares(1, 2e-9, r, 0.3)[0], 0.0, 1e-6);
}

TEST(SectorNumbers, AreAllVisited) {
  SectorNumbers<double> numbers;
  std::size_t count = 0;
  for_each_number([&](double&) { ++count; }, numbers);
  EXPECT_EQ(count * sizeof(double), sizeof numbers);
}

TEST(SectorModel, RefinedWithoutEffectsIsBars) {
  SectorCase c = test::abevi();
  const SectorModel bars = c.model();
  c.options.bodies = &kRefined;
  c.options.refined = {false, false, false, false, false, false, false};
  c.options.roller_contacts = ModelOptions::RollerContacts::opposite;
  const SectorModel refined = c.model();
  for_each_number([](const double& a, const double& b) { EXPECT_EQ(a, b); }, bars, refined);
  EXPECT_FALSE(refined.nut_shell);
  EXPECT_TRUE(refined.body_compliance.nut.empty());
}

TEST(NutShell, CentreOfPressureOfATiltedFace) {
  const double w = 8e-3, modulus = 2.3e11, force = 3e5, limit = 4.0 * force / (pi * modulus * w);
  const auto centre = [&](double tilt) { return centre_of_pressure(force, tilt, w, modulus); };
  EXPECT_NEAR(centre(0.0), 0.5 * w, 1e-15);
  EXPECT_NEAR(centre(limit), 0.25 * w, 1e-15);
  EXPECT_NEAR(centre(limit * (1.0 + 1e-9)), centre(limit), 1e-9 * w);
  EXPECT_NEAR(centre(-3.0 * limit), w - centre(3.0 * limit), 1e-15);
  // Pressure A sqrt((b - x)/x), A = E* theta/2, on the zone b at three times the smallest tilt, by Gauss's nodes for
  // the weight sqrt((1 - t)/(1 + t)), x = b (1 + t)/2, and between them the slope 2/(pi E*) int p/(y - x) dy of the
  // half-plane, which must equal the tilt.
  const double tilt = 3.0 * limit, b = 4.0 * centre(tilt), amplitude = 0.5 * modulus * tilt;
  const int n = 40;
  const double step = pi / (2 * n + 1);
  double resultant = 0.0, moment = 0.0, slope = 0.0;
  for (int j = 1; j <= n; ++j) {
    const double t = std::cos(2 * j * step), p = amplitude * 2.0 * step * (1.0 - t);
    resultant += 0.5 * b * p;
    moment += 0.5 * b * p * 0.5 * b * (1.0 + t);
    slope -= 2.0 / (pi * modulus) * p / (t - std::cos(25 * step));
  }
  EXPECT_NEAR(resultant / force, 1.0, 1e-12);
  EXPECT_NEAR(moment / (force * centre(tilt)), 1.0, 1e-12);
  EXPECT_NEAR(slope / tilt, 1.0, 1e-10);
}

NutLine plain_line() {
  NutLine line;
  line.sections = {0.0, 10e-3, 20e-3, 30e-3, 40e-3};
  line.outer_radius = {31e-3, 23e-3, 23e-3, 23e-3};
  line.contacts = {2, 3};
  line.thrust = 1;
  return line;
}

TEST(NutShell, ShoulderIsTheStepOrTheEndUnlessStated) {
  const NutBore bore{{17.8e-3, 17.8e-3, 17.8e-3, 17.7e-3}, 17.5e-3};
  Structure::Nut nut;
  NutLine line = plain_line();
  const auto ring = [&](int thrust) {
    line.thrust = thrust;
    const std::optional<ThrustRing> r = thrust_ring(line, nut, bore);
    return r ? std::pair(r->inner_radius, r->outer_radius) : std::pair(0.0, 0.0);
  };
  EXPECT_EQ(ring(1), std::pair(23e-3, 31e-3));
  EXPECT_EQ(ring(0), std::pair(17.8e-3, 31e-3));
  EXPECT_EQ(ring(4), std::pair(17.7e-3, 23e-3));
  EXPECT_EQ(ring(2), std::pair(0.0, 0.0));
  nut.shoulder = Structure::Shoulder{50e-3, 56e-3};
  EXPECT_EQ(ring(1), std::pair(25e-3, 28e-3));
  EXPECT_EQ(ring(2), std::pair(0.0, 0.0));
  nut.shoulder = Structure::Shoulder{44e-3, 70e-3};
  EXPECT_EQ(ring(1), std::pair(23e-3, 31e-3));
  nut.shoulder = Structure::Shoulder{36e-3, 44e-3};
  EXPECT_THROW(ring(1), CaseError);
}

/// Rotation of a node under loads (u, v, theta) at the nodes, u held at the thrust section.
double rotation(const NutLine& line, const NutShell& shell, int node, const std::vector<fe::NodalLoad>& loads) {
  fe::Model m;
  m.nodes = static_cast<int>(line.sections.size());
  int first = 0;
  for (const fe::ShellMatrix& k : shell.segments) {
    m.shells.push_back({first, first + 1, k});
    ++first;
  }
  m.fixed_supports.push_back({line.thrust, fe::Dof::u});
  const fe::Equations equations(m);
  fe::Cholesky cholesky(equations.linear_stiffness());
  EXPECT_EQ(cholesky.factorize(equations.linear_stiffness()), fe::FactorizationStatus::ok);
  Eigen::VectorXd q(equations.size());
  cholesky.solve(equations.load_vector(loads), q);
  return q[equations.number(node, fe::Dof::theta)];
}

TEST(NutShell, HousingPushesAtTheCentreOfPressure) {
  const NutLine line = plain_line();
  const ThrustRing ring{23e-3, 31e-3};
  const double psi = 0.785, cosine = std::cos(psi), modulus = 209e9;
  const NutBore bore{std::vector(4, 17.8e-3), 17.5e-3};
  const NutShell shell = nut_shell(line, ring, bore, {-1.0, psi}, {modulus, 0.3, {}}, 11, {});
  const double radius = 17.5e-3 - shell.contact_arm;
  std::vector<fe::NodalLoad> loads;
  for (const int node : line.contacts) {
    loads.push_back({node, fe::Dof::u, -cosine});
    loads.push_back({node, fe::Dof::v, std::sin(psi)});
    loads.push_back({node, fe::Dof::theta, cosine * shell.contact_arm});
  }
  const double tilt = -rotation(line, shell, line.thrust, loads);
  EXPECT_GT(tilt, 0.0);  // opens the outer edge
  const double force = 11 * 2.0 * cosine / (2.0 * pi * radius);
  EXPECT_NEAR(radius - ring.inner_radius, centre_of_pressure(force, tilt, 8e-3, modulus / (1.0 - 0.09)), 1e-9);
}

}  // namespace
}  // namespace prs
