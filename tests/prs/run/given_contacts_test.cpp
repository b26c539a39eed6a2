#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "prs/input/reader.h"
#include "prs/loads/load_analysis.h"
#include "prs/losses/life_analysis.h"
#include "prs/losses/preload_analysis.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"
#include "prs/measures/measures_analysis.h"
#include "prs/slip/slip.h"
#include "tests/prs/input/abevi.h"

namespace prs {
namespace {

template <class T>
concept HasMechanism = requires(T t) {
  t.mechanism;
};

// An analysis gets contacts and conditions: it has no other mechanism from which to find contacts.
static_assert(HasMechanism<Case> && HasMechanism<Contacts> && !HasMechanism<Conditions>);

/// A case for every analysis, with solved and equal thread loads.
Case complete_case(const std::vector<std::string>& overrides) {
  std::string text = input::kAbevi;
  text.resize(text.find("load_cases:"));
  text += R"(load_cases:
  - {name: solved, axial_force: 20 kN, direction: tension, position: 29.1666667 mm}
  - {name: equal, axial_force: 30 kN, direction: tension, share: equal}
friction: {model: {coulomb: 0.05}}
operation: {speed: 400 rpm}
preload:
  arrangement: single_nut
  force: 2 kN
  position: 29.1666667 mm
  load: {from: -10 kN, to: 10 kN, steps: 3}
life:
  position: 29.1666667 mm
  spectrum: [{force: 12 kN, direction: tension, share: 1}]
)";
  return input::read_case_text(text, "test.yaml", overrides, Command::slip);
}

/// Documents of all analyses on conditions and contacts, or on a whole case.
template <class... Given>
std::vector<nlohmann::ordered_json> documents(const Given&... given) {
  return {document_of(contact_analysis(), analyze_contacts(given...), {}),
          document_of(solve_analysis(), analyze(given...), {}),
          document_of(slip_analysis(), analyze_slip(given...), {}),
          document_of(preload_analysis(), analyze_preload(given...), {}),
          document_of(life_analysis(), analyze_life(given...), {}),
          document_of(measures_analysis(), analyze_measures(given...), {})};
}

TEST(GivenContacts, TellAnAnalysisAllThatItKnowsOfTheMechanism) {
  const Case c = complete_case({});
  const Case other = complete_case(
      {"mechanism.rollers=9", "mechanism.contacts_per_roller=17", "mechanism.profile.roller={convex: 6 mm}"});
  const auto expected = documents(other);
  EXPECT_EQ(documents(static_cast<const Conditions&>(c), checked_contacts(other, Detail::complete)), expected);
  EXPECT_NE(documents(c), expected);
}

}  // namespace
}  // namespace prs
