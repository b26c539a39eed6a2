#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include "prs/model/structure.h"
#include "prs/sector/influence/flexibility_options.h"
#include "prs/sector/influence/matrix_cache.h"
#include "prs/sector/influence/teeth.h"

namespace prs {

// All members of a type that a computation receives: one more does not compile until it is named.
inline auto members(const Groove& g) {
  const auto& [internal, pitch, radius, addendum, dedendum, backward, forward] = g;
  return std::tie(internal, pitch, radius, addendum, dedendum, backward, forward);
}
inline auto members(const HertzPatch& p) {
  const auto& [profile, circumference] = p;
  return std::tie(profile, circumference);
}
inline auto members(const LoadedFlank& f) {
  const auto& [ridge, side, patch, cells] = f;
  return std::tie(ridge, side, patch, cells);
}
inline auto members(const PlainEnd& e) {
  const auto& [length, radius] = e;
  return std::tie(length, radius);
}
inline auto members(const Collar& c) {
  const auto& [from, to, radius] = c;
  return std::tie(from, to, radius);
}
inline auto members(const std::pair<double, double>& p) { return std::tie(p.first, p.second); }
inline auto members(const GroovedShape& s) {
  const auto& [groove, start, end, ridge, ridges, far, plain_end, collars, sections, radii] = s;
  return std::tie(groove, start, end, ridge, ridges, far, plain_end, collars, sections, radii);
}
inline auto members(const MeshDensity& m) {
  const auto& [patch, growth, largest, step, plain_flank, split, depth] = m;
  return std::tie(patch, growth, largest, step, plain_flank, split, depth);
}
inline auto members(const FlexibilityOptions& o) {
  const auto& [mesh, largest_wave, tolerance, neighbour_cells, unilateral] = o;
  return std::tie(mesh, largest_wave, tolerance, neighbour_cells, unilateral);
}
inline auto members(const Material& m) {
  const auto& [modulus, poisson_ratio, density, expansion] = m;
  return std::tie(modulus, poisson_ratio, density, expansion);
}
inline auto members(const Guidance& g) {
  const auto& [kind, stiffness] = g;
  return std::tie(kind, stiffness);
}
inline auto members(const Teeth& t) {
  const auto& [groove, far, material, types, opposite, first, step, contacts, options] = t;
  return std::tie(groove, far, material, types, opposite, first, step, contacts, options);
}

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
/// else. The number in the key grows when the same numbers give other matrices.
template <class Given>
std::shared_ptr<const MatrixCache::Matrices> cached(
    MatrixCache& cache, std::string_view what, const Given& given,
    MatrixCache::Matrices (*compute)(const Given&)) {
  std::string key = "flexibility 3 ";
  key += what;
  append_bytes(key, given);
  return cache.get(key, [&] { return compute(given); });
}

}  // namespace prs
