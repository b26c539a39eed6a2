#pragma once

#include <tuple>

#include "prs/model/structure.h"
#include "prs/sector/influence/teeth.h"

namespace prs {

/// All members of a type that a computation receives: unless every one is named, it does not
/// compile.
#define PRS_MEMBERS(Type, ...)             \
  inline auto members(const Type& value) { \
    const auto& [__VA_ARGS__] = value;     \
    return std::tie(__VA_ARGS__);          \
  }
PRS_MEMBERS(Groove, internal, pitch, radius, addendum, dedendum, backward, forward)
PRS_MEMBERS(HertzPatch, profile, circumference)
PRS_MEMBERS(LoadedFlank, ridge, side, patch, cells, tangential)
PRS_MEMBERS(PlainEnd, length, radius)
PRS_MEMBERS(Collar, from, to, radius)
inline auto members(const std::pair<double, double>& p) { return std::tie(p.first, p.second); }
PRS_MEMBERS(GroovedShape, groove, start, end, ridge, ridges, far, plain_end, collars, sections,
            radii)
PRS_MEMBERS(MeshDensity, patch, growth, largest, step, plain_flank, split, depth)
PRS_MEMBERS(FlexibilityOptions, mesh, largest_wave, tolerance, neighbour_cells, unilateral)
/// Without what matrices do not depend on and flash temperatures do.
inline auto members(const Material& value) {
  const auto& [modulus, poisson_ratio, density, expansion, conductivity, specific_heat] = value;
  return std::tie(modulus, poisson_ratio, density, expansion);
}
PRS_MEMBERS(Guidance, kind, stiffness)
PRS_MEMBERS(Teeth, groove, far, material, types, opposite, first, step, contacts, options)

template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& values);
template <class T>
void append_bytes(std::string& bytes, const std::optional<T>& value);

/// The bytes of all numbers in a value, however deep.
template <class T>
void append_bytes(std::string& bytes, const T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  else
    std::apply([&](const auto&... member) { (append_bytes(bytes, member), ...); }, members(value));
}
template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& values) {
  append_bytes(bytes, values.size());
  for (const T value : values) append_bytes(bytes, value);
}
template <class T>
void append_bytes(std::string& bytes, const std::optional<T>& value) {
  append_bytes(bytes, value.has_value());
  if (value) append_bytes(bytes, *value);
}

/// compute(given), kept under the bytes of what it is given; being a plain function it sees nothing
/// else. `fits` says which matrices it can be. The number in the key grows when the same numbers
/// give other matrices.
template <class Given>
std::shared_ptr<const MatrixCache::Matrices> cached(MatrixCache& cache, std::string_view what,
                                                    const Given& given,
                                                    MatrixCache::Matrices (*compute)(const Given&),
                                                    bool (*fits)(const Given&,
                                                                 const MatrixCache::Matrices&)) {
  std::string key = "flexibility 3 ";
  key += what;
  append_bytes(key, given);
  return cache.get(
      key, [&] { return compute(given); },
      [&](const MatrixCache::Matrices& matrices) { return fits(given, matrices); });
}

}  // namespace prs
