#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prs/configurations/complete_screw.h"
#include "prs/size/requirement.h"

namespace prs {

/// A screw to choose from: a row of a catalogue or a design. SI units.
struct CandidateData {
  std::string name;
  bool is_row = false;     ///< Of a catalogue.
  std::size_t number = 0;  ///< Of the row or the design, from 1.
  ScrewData screw;
  std::optional<double> dynamic_capacity, static_capacity;  ///< C_a, C_0 of the row [N].
  std::optional<double> efficiency, back_driving_efficiency;

  std::string_view source() const { return is_row ? "catalogue" : "design"; }
};

/// Rows of the catalogue, then designs, numbered with starts fastest, then lead, diameter, type.
/// Unknown columns are warned of. Throws InputError.
std::vector<CandidateData> candidates_of(const SizeInput& in, std::vector<Warning>& warnings);

/// The screw of a candidate as its written case has it. The nut of an inverted one without a length
/// of its own is made as long as the rollers' threads travel. Throws CaseError where `prs new`
/// refuses the screw, or a nut is too short for the stroke.
CompleteScrew screw_of(const CandidateData& candidate, const std::optional<double>& stroke);

/// Rows of the standard screws in validation/standard_screws, which are part of the program.
std::string_view standard_screws();

}  // namespace prs
