#pragma once

#include <string>
#include <utility>
#include <vector>

#include "prs/input/reader.h"

namespace test {

/// The screw of a lesson under the given loads.
inline prs::Case contact_lesson(const std::string& file, std::vector<prs::LoadCase> load_cases = {}) {
  prs::Case c = prs::input::read_case(PRS_SOURCE_DIR "/configs/" + file, {}, prs::Command::contact);
  c.load_cases = std::move(load_cases);
  return c;
}

/// The Abevi screw of lesson 4.
inline prs::Case abevi_contacts(std::vector<prs::LoadCase> load_cases = {}) {
  return contact_lesson("04_contacts_from_geometry.yaml", std::move(load_cases));
}

inline prs::LoadCase equal_share(std::string name, double force) {
  prs::LoadCase load_case;
  load_case.name = std::move(name);
  load_case.axial_force = force;
  load_case.share = prs::LoadCase::Share::equal;
  return load_case;
}

}  // namespace test
