#include "prs/losses/solve_analysis.h"
#include "prs/threads/threads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_analysis.h"
#include "prs/model/problems.h"
#include "prs/study/response.h"
#include "prs/threads/contacts.h"
#include "tests/contact/units.h"

namespace prs {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

using std::numbers::pi;

contact::Thread thread(double pitch_radius, double pitch, double lead, double flank_angle) {
  return {.pitch_radius = pitch_radius,
          .lead = lead,
          .pitch = pitch,
          .flank_angle = flank_angle,
          .plane = contact::ProfilePlane::axial,
          .addendum = 0.2 * pitch,
          .dedendum = 0.15 * pitch};
}

Mechanism read(const std::string& file, std::vector<std::string> overrides = {}) {
  return input::read_case_input(input::load_source(PRS_SOURCE_DIR "/validation/yao_2023/" + file, overrides),
                                Command::contact)
      .values.mechanism;
}

/// Table A1: h_S = h_N = 2 mm, h_R = 2.4 mm.
const std::vector<std::string> kThickness = {"mechanism.thread.screw.thickness=2 mm",
                                             "mechanism.thread.roller.thickness=2.4 mm",
                                             "mechanism.thread.nut.thickness=2 mm"};

/// Gap of the flanks above a roller's thread in the middle of the body's groove, over the point (x, y) from the body's
/// axis: the two surfaces z(r, theta) themselves.
struct Gap {
  const contact::MechanismGeometry& m;
  Interface interface;

  const contact::Thread& body() const { return interface == Interface::screw ? m.screw : m.nut; }
  double operator()(double x, double y) const {
    const contact::ThreadSurface b(body()), r(m.roller);
    const bool external = interface == Interface::screw;
    const double from_roller = x - m.centre_distance;
    const double turn = external ? std::atan2(-y, -from_roller) : std::atan2(y, from_roller);
    const double f = b.profile(std::hypot(x, y)).height;
    const double groove = (external ? f : 0.5 * b.pitch - f) + std::atan2(y, x) * b.reduced_lead;
    const double half_thread = 0.5 * r.pitch - r.profile(std::hypot(from_roller, y)).height;
    return groove - half_thread - turn * r.reduced_lead;
  }
};

/// Smallest gap along the edge of a crest, a circle about the body's axis or the roller's.
double least_along_edge(const Gap& gap, bool of_roller) {
  const contact::Thread& t = of_roller ? gap.m.roller : gap.body();
  const double radius = t.pitch_radius + (t.internal ? -*t.addendum : *t.addendum);
  const double facing = of_roller && gap.interface == Interface::screw ? pi : 0.0;
  const double centre = of_roller ? gap.m.centre_distance : 0.0;
  double least = 1.0;
  for (double turn = -0.3; turn <= 0.3; turn += 1e-4)
    least = std::min(least, gap(centre + radius * std::cos(facing + turn), radius * std::sin(facing + turn)));
  return least;
}

// Yao 2023, (52) to (54), at other flank angles than 45 deg.
TEST(ThreadWidths, AreThoseOfYaosClosedForms) {
  const double h = 2.1 * mm, p = 5 * mm, r = 8 * mm;
  for (const double beta : {38 * deg, 45 * deg, 52 * deg}) {
    contact::Thread screw = thread(r, p, 5 * p, beta), nut = screw, roller = screw;
    for (contact::Thread* t : {&screw, &nut, &roller}) t->thickness = h;
    nut.internal = true;
    roller.profile_curvature = std::sin(beta) / r;
    const double up = *screw.addendum, down = *screw.dedendum;

    for (const contact::Thread& straight : {screw, nut}) {
      const ThreadWidths w = thread_widths(straight).value();
      EXPECT_NEAR(w.crest.value(), h - 2.0 * up * std::tan(beta), 1e-17);
      EXPECT_NEAR(w.root.value(), h + 2.0 * down * std::tan(beta), 1e-17);
    }
    const auto of_arc = [&](double radius) {
      const double r_e = r / std::sin(beta);
      return h + std::sqrt(4.0 * r_e * r_e - 4.0 * radius * radius) - 2.0 * r / std::tan(beta);
    };
    const ThreadWidths w = thread_widths(roller).value();
    EXPECT_NEAR(w.crest.value(), of_arc(r + up), 1e-16);
    EXPECT_NEAR(w.root.value(), of_arc(r - down), 1e-16);
  }
}

// Any arc: the flanks' points lie on the circle in its plane, for both signs and both planes.
TEST(ThreadWidths, LeadToPointsOnTheArc) {
  for (const contact::ProfilePlane plane : {contact::ProfilePlane::normal, contact::ProfilePlane::axial})
    for (const bool internal : {false, true})
      for (const double r_b : {7 * mm, -9 * mm}) {
        contact::Thread t = thread(8 * mm, 2 * mm, 6 * mm, 40 * deg);
        t.plane = plane;
        t.internal = internal;
        t.profile_curvature = 1.0 / r_b;
        t.thickness = 0.9 * mm;
        const double to_plane = plane == contact::ProfilePlane::normal ? std::cos(std::atan(3.0 / (8.0 * pi))) : 1.0;
        const double outwards = internal ? -1.0 : 1.0;
        // Centre of the arc from the pitch point: into the material by r_B along the normal.
        const double centre_radial = -outwards * r_b * std::sin(t.flank_angle);
        const double centre_axial = 0.5 * to_plane * *t.thickness - r_b * std::cos(t.flank_angle);
        const ThreadWidths w = thread_widths(t).value();
        EXPECT_NEAR(std::hypot(outwards * *t.addendum - centre_radial, 0.5 * to_plane * w.crest.value() - centre_axial),
                    std::abs(r_b), 1e-17);
        EXPECT_NEAR(std::hypot(-outwards * *t.dedendum - centre_radial, 0.5 * to_plane * w.root.value() - centre_axial),
                    std::abs(r_b), 1e-17);
        EXPECT_LT(w.crest.value(), *t.thickness);
        EXPECT_GT(w.root.value(), *t.thickness);
      }
}

// (51): crests and gaps between roots vanish where the flanks meet.
TEST(ThreadWidths, VanishWhereFlanksMeet) {
  for (const bool internal : {false, true})
    for (const double curvature : {0.0, 60.0, -60.0}) {
      contact::Thread t = thread(8 * mm, 2 * mm, 6 * mm, 45 * deg);
      t.internal = internal;
      t.profile_curvature = curvature;
      t.thickness = 0.8 * mm;
      const contact::RadiusLimits sharp = contact::sharp_limits(t);
      t.addendum = internal ? t.pitch_radius - sharp.smallest : sharp.largest - t.pitch_radius;
      t.dedendum = internal ? sharp.largest - t.pitch_radius : t.pitch_radius - sharp.smallest;
      const ThreadWidths w = thread_widths(t).value();
      EXPECT_NEAR(w.crest.value(), 0.0, 1e-17);
      EXPECT_NEAR(w.root.value(), t.pitch, 1e-17);
      *t.addendum += 0.01 * mm;
      *t.dedendum += 0.01 * mm;
      EXPECT_LT(thread_widths(t)->crest.value(), 0.0);
      EXPECT_GT(thread_widths(t)->root.value(), t.pitch);
    }
}

TEST(ThreadWidths, AreAbsentWithoutHeightsAndBeyondTheArc) {
  contact::Thread t = thread(8 * mm, 2 * mm, 6 * mm, 45 * deg);
  t.profile_curvature = 1.0 / (1 * mm);  // the arc turns radial 0.29 mm above the pitch radius
  EXPECT_FALSE(thread_widths(t)->crest);
  EXPECT_TRUE(thread_widths(t)->root);
  t.addendum.reset();
  EXPECT_FALSE(thread_widths(t));
}

// (57), (58) for straight bodies, a roller's arc about its axis and axes of the pitch radii.
TEST(ThreadClearance, OfCrestsIsThatOfYaosClosedForms) {
  for (const std::string file : {"initial.yaml", "optimum.yaml"}) {
    const Contacts contacts = find_contacts(read(file, kThickness), std::nullopt);
    const contact::MechanismGeometry& m = contacts.threads;
    const double p = m.roller.pitch, beta_r = m.roller.flank_angle;
    const double r_e = m.roller.pitch_radius / std::sin(beta_r);
    const auto phi_r = [&](double r) {
      return r_e * std::cos(beta_r) + 0.5 * (p - *m.roller.thickness) - std::sqrt(r_e * r_e - r * r);
    };
    for (const Interface i : kInterfaces) {
      const contact::Thread& body = i == Interface::screw ? m.screw : m.nut;
      const ThreadClearance c = contacts.interfaces[i].clearance.value();
      const double tan_body = std::tan(body.flank_angle);
      const double c_body = *body.thickness - 2.0 * *body.addendum * tan_body;
      const double c_roller = p - 2.0 * phi_r(m.roller.pitch_radius + *m.roller.addendum);
      // The profile's radius has 16 digits in the file.
      EXPECT_NEAR(c.body_crest.value(), phi_r(m.roller.pitch_radius - *body.addendum) - 0.5 * c_body, 1e-16);
      EXPECT_NEAR(c.roller_crest.value(), 0.5 * (p - c_roller - *body.thickness) - *m.roller.addendum * tan_body,
                  1e-16);
    }
  }
}

// (55) is the smallest gap of the two surfaces, half the backlash; crests lie on these surfaces, and none is nearer
// than the contact point.
TEST(ThreadClearance, IsTheGapOfTheSurfaces) {
  std::vector<Mechanism> mechanisms = {read("initial.yaml", kThickness), read("optimum.yaml", kThickness)};
  std::vector<std::string> normal = kThickness;
  normal.insert(normal.end(), {"mechanism.profile_plane=normal", "mechanism.profile.screw={convex: 40 mm}",
                               "mechanism.profile.nut={concave: 90 mm}"});
  mechanisms.push_back(read("initial.yaml", normal));
  for (const Mechanism& mechanism : mechanisms) {
    const Contacts contacts = find_contacts(mechanism, std::nullopt);
    const contact::MechanismGeometry& m = contacts.threads;
    for (const Interface i : kInterfaces) {
      const contact::ContactPoint& point = contacts.interfaces[i].geometry.point;
      const ThreadClearance c = contacts.interfaces[i].clearance.value();
      const Gap gap{m, i};
      EXPECT_DOUBLE_EQ(c.flank, 0.5 * point.backlash);
      // I1J2 loads the roller's top face at the screw and its bottom face at the nut.
      const double outwards = i == Interface::screw ? 1.0 : -1.0;
      EXPECT_NEAR(gap(point.position.x, outwards * point.position.y), c.flank, 1e-16);
      const double of_body = gap.body().pitch_radius + outwards * *gap.body().addendum;
      const double of_roller = m.roller.pitch_radius + *m.roller.addendum;
      EXPECT_NEAR(gap(of_body, 0.0), c.body_crest.value(), 1e-16);
      EXPECT_NEAR(gap(m.centre_distance - outwards * of_roller, 0.0), c.roller_crest.value(), 1e-16);
      // Over the whole overlap of the two threads.
      double least = 1.0;
      for (double y = -4 * mm; y <= 4 * mm; y += 0.02 * mm)
        for (double x = point.position.x - 1 * mm; x <= point.position.x + 1 * mm; x += 0.02 * mm)
          least = std::min(least, gap(x, y));
      EXPECT_GE(least, c.flank - 1e-16);
      EXPECT_LT(least, c.flank + 1e-8);
      for (const bool roller : {false, true}) {
        const double edge = least_along_edge(gap, roller);
        EXPECT_GT(edge, c.flank);
        EXPECT_LE(edge, (roller ? c.roller_crest : c.body_crest).value() + 1e-16);
      }
    }
  }
}

// Either of two external threads may be called the body.
TEST(ThreadClearance, OfTwoExternalThreadsIsMutual) {
  contact::MechanismGeometry m;
  m.screw = thread(9 * mm, 2 * mm, 10 * mm, 45 * deg);
  m.roller = thread(4 * mm, 2 * mm, -2 * mm, 42 * deg);
  m.roller.profile_curvature = 1.0 / (6 * mm);
  m.roller.addendum = 0.3 * mm;
  m.centre_distance = 13.02 * mm;
  contact::MechanismGeometry swapped = m;
  std::swap(swapped.screw, swapped.roller);
  const auto clearance = [](const contact::MechanismGeometry& g) {
    const contact::ContactPoint point = contact::find_contact_point(contact::screw_pair(g), contact::RollerFace::top);
    return thread_clearance(g, Interface::screw, point).value();
  };
  const ThreadClearance a = clearance(m), b = clearance(swapped);
  EXPECT_NEAR(a.flank, b.flank, 1e-16);
  EXPECT_NEAR(a.body_crest.value(), b.roller_crest.value(), 1e-17);
  EXPECT_NEAR(a.roller_crest.value(), b.body_crest.value(), 1e-17);
}

TEST(ThreadClearance, IsAbsentWhereItHasNoMeaning) {
  const auto clearance = [](const std::vector<std::string>& overrides) {
    return find_contacts(read("initial.yaml", overrides), std::nullopt).interfaces.nut.clearance;
  };
  EXPECT_TRUE(clearance({}));
  EXPECT_FALSE(clearance({"mechanism.thread={}"}));
  EXPECT_FALSE(clearance({"mechanism.pitch.roller=5.001 mm"}));
  // Both flanks straight: no contact point.
  EXPECT_FALSE(clearance({"mechanism.profile.roller=straight"}));
}

// A thread that is thinner by d on each flank leaves the contact in place and adds d of play.
TEST(ThreadThickness, AddsPlayAndMovesNothing) {
  const Contacts sharp = find_contacts(read("initial.yaml"), std::nullopt);
  const Contacts thin = find_contacts(read("initial.yaml", kThickness), std::nullopt);
  for (const Interface i : kInterfaces) {
    const contact::ContactPoint &a = sharp.interfaces[i].geometry.point, &b = thin.interfaces[i].geometry.point;
    EXPECT_NEAR(b.backlash - a.backlash, (5.0 - 2.0 - 2.4) * mm, 1e-16);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(sharp.interfaces[i].geometry.relative.first, thin.interfaces[i].geometry.relative.first);
  }
  const Contacts half = find_contacts(
      read("initial.yaml", {"mechanism.thread.screw.thickness=2.5 mm", "mechanism.thread.roller.thickness=2.5 mm",
                            "mechanism.thread.nut.thickness=2.5 mm"}),
      std::nullopt);
  EXPECT_EQ(half.interfaces.screw.geometry.point.backlash, sharp.interfaces.screw.geometry.point.backlash);
  EXPECT_EQ(half.warnings, sharp.warnings);
}

// The heights of table A1 fit the thicknesses of table A1: no sharpened crown, no meeting roots.
TEST(ThreadThickness, OfYaosTableFitsItsHeights) {
  EXPECT_THAT(testing::PrintToString(sentences(find_contacts(read("initial.yaml"), std::nullopt).warnings)),
              HasSubstr("its flanks meet"));
  EXPECT_TRUE(find_contacts(read("initial.yaml", kThickness), std::nullopt).warnings.empty());
}

TEST(ThreadThickness, IsRefusedOutsideItsPitch) {
  const Mechanism m = read("initial.yaml", {"mechanism.thread.nut.thickness=5 mm"});
  try {
    find_contacts(m, std::nullopt);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_EQ(error.path(), "mechanism.thread.nut.thickness");
    EXPECT_THAT(error.what(), HasSubstr("got 5 mm; expected less than the axial pitch of 5 mm"));
  }
  EXPECT_ANY_THROW(read("initial.yaml", {"mechanism.thread.nut.thickness=0 mm"}));
  EXPECT_ANY_THROW(read("initial.yaml", {"mechanism.thread.nut.thickness=2"}));
}

// Yao's constraints (61) with the right sign in (52).
TEST(YaosConstraints, HoldBeforeAndAfterTheOptimization) {
  for (const std::string file : {"initial.yaml", "optimum.yaml"}) {
    const Contacts contacts = find_contacts(read(file, kThickness), std::nullopt);
    for (const Part p : kParts) {
      const ThreadWidths w = thread_widths(thread_of(contacts.threads, p)).value();
      EXPECT_GT(w.crest.value(), 0.0) << file << " " << name(p);
      EXPECT_LT(w.root.value(), 5 * mm) << file << " " << name(p);
    }
    for (const Interface i : kInterfaces) {
      const ThreadClearance c = contacts.interfaces[i].clearance.value();
      EXPECT_GT(c.flank, 0.0) << file << " " << name(i);
      EXPECT_GT(c.body_crest.value(), c.flank) << file << " " << name(i);
      EXPECT_GT(c.roller_crest.value(), c.flank) << file << " " << name(i);
    }
  }
  // (52) as printed makes the screw's crest 3.43 mm wide, more than its groove.
  const Contacts contacts = find_contacts(read("initial.yaml", kThickness), std::nullopt);
  const double right = thread_widths(contacts.threads.screw)->crest.value();
  const double printed = (2.0 + 49.43 - 48.0) * mm;
  EXPECT_NEAR(right, 0.57 * mm, 1e-16);
  EXPECT_LT(*contacts.interfaces.screw.clearance->body_crest + 0.5 * (right - printed), 0.0);
}

TEST(YaosConstraints, AreNumbersOfDocumentsAndResponses) {
  Case c = input::read_case_input(input::load_source(PRS_SOURCE_DIR "/validation/yao_2023/initial.yaml", kThickness),
                                  Command::contact)
               .values;
  const Result result = analyze(c);
  const auto json = document_of(solve_analysis(), result, {"1", "1", ""});
  EXPECT_NEAR(json.at("threads").at("screw").at("crest_width_mm"), 0.57, 1e-12);
  EXPECT_NEAR(json.at("threads").at("nut").at("root_width_mm"), 4.62, 1e-12);
  for (const std::string key : {"flank_clearance_mm", "body_crest_clearance_mm", "roller_crest_clearance_mm"}) {
    const std::optional<ResultNumber> number = result_number("contact.screw." + key);
    ASSERT_TRUE(number) << key;
    EXPECT_EQ(number->value(Answer{result.contacts}).value(), json.at("contact").at("screw").at(key));
  }
  c.mechanism.thread = {};
  const auto bare = document_of(solve_analysis(), analyze(c), {"1", "1", ""});
  EXPECT_FALSE(bare.contains("threads"));
  EXPECT_FALSE(bare.at("contact").at("screw").contains("flank_clearance_mm"));
}

}  // namespace
}  // namespace prs
