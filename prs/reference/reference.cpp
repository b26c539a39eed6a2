#include "prs/reference/reference.h"

namespace prs {

double Spread::at(double number, double mean) const {
  return of == Of::value ? amount : 0.01 * amount * std::abs(of == Of::mean ? mean : number);
}

std::vector<double> ReferenceCurve::values() const {
  std::vector<double> all;
  for (const ReferenceReading& reading : readings) all.push_back(reading.value);
  return all;
}

double ReferenceCurve::mean_magnitude() const {
  double sum = 0.0;
  for (const ReferenceReading& reading : readings) sum += std::abs(reading.value);
  return sum / static_cast<double>(readings.size());
}

}  // namespace prs
