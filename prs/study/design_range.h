#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prs {

/// Designs [first, first + count) of a study.
struct DesignRange {
  std::size_t first = 0;
  std::size_t count = 0;

  std::size_t end() const { return first + count; }
  bool operator==(const DesignRange&) const = default;
};

/// One of `count` equal parts of a study, which run independently.
struct Shard {
  std::size_t index = 0;  ///< From 0; people and files count from 1.
  std::size_t count = 1;

  bool operator==(const Shard&) const = default;
};

inline constexpr std::size_t kMostShards = 1'000'000;

/// `3/8`, the third of eight, from 1/8 to 8/8. Absent where the text is not of this form.
std::optional<Shard> parse_shard(std::string_view text);

/// `3/8`
std::string name(Shard shard);

/// The designs of a shard: consecutive ones, as many as those of any other shard or one more.
DesignRange part(std::size_t designs, Shard shard);

/// The designs of `all` that are in none of the ranges. These may overlap and come in any order.
std::vector<DesignRange> missing(DesignRange all, std::vector<DesignRange> ranges);

/// Number of designs in disjoint ranges.
std::size_t count(const std::vector<DesignRange>& ranges);

}  // namespace prs
