#pragma once

#include <concepts>
#include <cstddef>
#include <iterator>

namespace prs {

/// The numbers 0, 1, .., count - 1, to loop over.
struct Counted {
  struct Iterator {
    std::size_t value;

    constexpr std::size_t operator*() const { return value; }
    constexpr Iterator& operator++() { return ++value, *this; }
    constexpr bool operator!=(const Iterator& other) const { return value != other.value; }
  };

  std::size_t count;

  constexpr Iterator begin() const { return {0}; }
  constexpr Iterator end() const { return {count}; }
};

constexpr Counted up_to(std::integral auto count) { return {static_cast<std::size_t>(count)}; }

/// Indices of a sequence as long as it is before the loop.
constexpr Counted indices(const auto& sequence) { return {std::size(sequence)}; }

/// Entry at an index of any integer or enumeration type.
constexpr decltype(auto) item_at(auto&& sequence, auto index) { return sequence[static_cast<std::size_t>(index)]; }

/// Appends the entries of `tail`.
void append(auto& to, const auto& tail) { to.insert(to.end(), std::begin(tail), std::end(tail)); }

/// Whether a sequence has an entry that equals `value`.
constexpr bool contains(const auto& sequence, const auto& value) {
  for (const auto& found : sequence)
    if (found == value) return true;
  return false;
}

}  // namespace prs
