#include "prs/figures/contact_figures_style.h"

#include <fmt/format.h>

#include <cmath>

#include "prs/model/units.h"

namespace prs {

std::string number(double value, int decimals) {
  const bool is_negative = value < -0.5 * std::pow(10.0, -decimals);
  return fmt::format("{}{:.{}f}", is_negative ? "−" : "", std::abs(value), decimals);
}

std::string mechanism_title(const Contacts& contacts) {
  const contact::MechanismGeometry& threads = contacts.threads;
  return fmt::format("{}{} screw {:.4g} × {:.4g} mm",
                     threads.screw.lead < 0.0 ? "left-handed " : "",
                     threads.type == contact::MechanismType::standard ? "standard" : "inverted",
                     2.0 * threads.screw.pitch_radius * per_si::millimetre,
                     std::abs(threads.screw.lead) * per_si::millimetre);
}

}  // namespace prs
