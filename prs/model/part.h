#pragma once

#include <string_view>

namespace prs {

/// The three threaded parts of a planetary roller screw.
enum class Part { screw, roller, nut };

/// The two contact interfaces of a roller: `screw` is the roller-screw interface (I in Sandu 2018,
/// k in Abevi 2015), `nut` the roller-nut interface (J, g).
enum class Interface { screw, nut };

inline constexpr Interface kInterfaces[] = {Interface::screw, Interface::nut};
inline constexpr Part kParts[] = {Part::screw, Part::roller, Part::nut};

template <class T>
struct PerPart {
  T screw{};
  T roller{};
  T nut{};

  T& operator[](Part p) { return p == Part::screw ? screw : p == Part::roller ? roller : nut; }
  const T& operator[](Part p) const { return const_cast<PerPart&>(*this)[p]; }
  bool operator==(const PerPart&) const = default;
};

template <class T>
struct PerInterface {
  T screw{};
  T nut{};

  T& operator[](Interface i) { return i == Interface::screw ? screw : nut; }
  const T& operator[](Interface i) const { return const_cast<PerInterface&>(*this)[i]; }
  bool operator==(const PerInterface&) const = default;
};

/// The part that the roller touches at an interface.
constexpr Part body_of(Interface i) { return i == Interface::screw ? Part::screw : Part::nut; }

constexpr std::string_view name(Part p) {
  return p == Part::screw ? "screw" : p == Part::roller ? "roller" : "nut";
}

constexpr std::string_view name(Interface i) { return i == Interface::screw ? "screw" : "nut"; }

}  // namespace prs
