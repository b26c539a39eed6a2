#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prs/input/document.h"
#include "prs/input/units.h"

namespace prs::input {

struct CaseFile;

/// One value of the resolved input.
struct EchoEntry {
  std::string path;   ///< `mechanism.flank_angle`
  std::string value;  ///< With its unit, as it could stand in the file: `45 deg`.
  bool is_default = false;
  std::string origin = {};               ///< Of a default that a name stands for: `of iso-vg-100`.
  std::string written = {};              ///< As the file has it; empty for a default.
  std::optional<double> number = {};     ///< SI; of a range the end that is farther from 0.
  const Dimension* dimension = nullptr;  ///< Of the number, where it has one.
};

/// Every value of a case in the order of case_fields.cpp; absent ones without default are left out.
/// The case must have passed `check_case`.
/// `root` is the document that the case was read from: what it lacks is a default.
std::vector<EchoEntry> echo(CaseFile file, const Node& root);

}  // namespace prs::input
