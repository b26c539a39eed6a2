#pragma once

#include "prs/validation/validate.h"

// Code that adds to the `reference.yaml` of each source.

namespace prs {
/// Code of all sources; for those that a light program omits, only the folder.
std::vector<SourceExtension> extensions();
}  // namespace prs

namespace prs::abevi_2015 {
/// The statements in words.
SourceExtension extension();

}  // namespace prs::abevi_2015

namespace prs::jung_2017 {
/// Table 7.1 by the recipe as printed, table A1 by elliptic integrals, table 8.1 and the design points of tables 8.2
/// to 8.5; also both cases by the right formulas, the parts of a thread's compliance, and the fits (7.8) to (7.13).
SourceExtension extension();
}  // namespace prs::jung_2017

namespace prs::reference_fe {
/// The three models of the bodies against the curves of `data/curves.csv`: discrepancies of
/// stiffness and load rates, statements on them, pictures, and every number thread by thread.
SourceExtension extension();
}  // namespace prs::reference_fe

namespace prs::sandu_2018 {
/// Quantities that the JSON document lacks; the error of the ellipticity approximations of table 1.5; the statements of
/// chapters 2 and 3 on the reference example of table 3.2.
SourceExtension extension();
}  // namespace prs::sandu_2018

namespace prs::standard_screws {
/// 24 screws of a maker's catalogue, each completed by the rules of `complete_screw`: ratios of the computed to the
/// printed weights, inertias and capacities, and the dependence of capacities on the lead, with two profile radii of
/// the rollers.
SourceExtension extension();
}  // namespace prs::standard_screws

namespace prs::yao_2023 {
/// Quantities of tables 1 and 2 that the JSON document lacks, and the distance between the printed contact points of
/// the two parts.
SourceExtension extension();
}  // namespace prs::yao_2023
