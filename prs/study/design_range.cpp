#include "prs/study/design_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace prs {
namespace {

/// Takes a whole number from the head of a text.
std::optional<std::size_t> take_number(std::string_view& text) {
  std::size_t number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return number;
}

}  // namespace

std::optional<Shard> parse_shard(std::string_view text) {
  const std::optional<std::size_t> index = take_number(text);
  if (!index || !text.starts_with('/')) return std::nullopt;
  text.remove_prefix(1);
  const std::optional<std::size_t> count = take_number(text);
  if (!count || !text.empty()) return std::nullopt;
  if (*index < 1 || *index > *count || *count > kMostShards) return std::nullopt;
  return Shard{*index - 1, *count};
}

std::string name(Shard shard) { return fmt::format("{}/{}", shard.index + 1, shard.count); }

DesignRange part(std::size_t designs, Shard shard) {
  const std::size_t share = designs / shard.count;
  const std::size_t longer = designs % shard.count;  // The first of the shards have one more.
  const std::size_t first = shard.index * share + std::min(shard.index, longer);
  return {first, share + (shard.index < longer ? 1 : 0)};
}

std::vector<DesignRange> missing(DesignRange all, std::vector<DesignRange> ranges) {
  std::ranges::sort(ranges, {}, &DesignRange::first);
  std::vector<DesignRange> gaps;
  std::size_t next = all.first;
  for (const DesignRange& range : ranges) {
    const std::size_t stop = std::min(range.first, all.end());
    if (stop > next) gaps.push_back({next, stop - next});
    next = std::max(next, range.end());
  }
  if (next < all.end()) gaps.push_back({next, all.end() - next});
  return gaps;
}

std::size_t count(const std::vector<DesignRange>& ranges) {
  std::size_t sum = 0;
  for (const DesignRange& range : ranges) sum += range.count;
  return sum;
}

}  // namespace prs
