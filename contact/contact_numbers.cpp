#include "contact/contact_numbers.h"

#include "contact/contact_kernel.h"
#include "contact/mechanism_geometry.h"
#include "simd/dispatch.h"

namespace contact {

MechanismNumbers<double> numbers_of(const MechanismGeometry& m) {
  return {numbers_of(m.screw), numbers_of(m.roller), numbers_of(m.nut), m.centre_distance, 0.0, 0.0};
}

void find_contacts(std::span<const MechanismNumbers<double>> mechanisms,
                   std::span<MechanismContactNumbers<double>> contacts, simd::InstructionSet set) {
  if (set == simd::InstructionSet::scalar) {
    for (std::size_t k = 0; k < mechanisms.size(); ++k) contacts[k] = contact_numbers(mechanisms[k]);
    return;
  }
  simd::run_kernel(set, ContactKernel{}, mechanisms, contacts);
}

void set_ellipses(const HertzConstants& constants, const std::vector<double>& normal_load,
                  std::vector<double>& semi_major, std::vector<double>& semi_minor, std::vector<double>& peak_pressure,
                  simd::InstructionSet set, const KnownApproach& known) {
  for (std::vector<double>* values : {&semi_major, &semi_minor, &peak_pressure}) values->resize(normal_load.size());
  if (set == simd::InstructionSet::scalar) {
    for (std::size_t k = 0; k < normal_load.size(); ++k) {
      const HertzContact at = at_load(constants, normal_load[k]);
      semi_major[k] = at.semi_major;
      semi_minor[k] = at.semi_minor;
      peak_pressure[k] = at.peak_pressure;
    }
    return;
  }
  simd::run_kernel(set, EllipseKernel{}, constants.semi_major_per_cbrt_load, constants.semi_minor_per_cbrt_load,
                   std::span<const double>(normal_load), known, semi_major.data(), semi_minor.data(),
                   peak_pressure.data());
}

}  // namespace contact
