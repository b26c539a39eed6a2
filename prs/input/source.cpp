#include "prs/input/source.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <tuple>

#include "prs/file_descriptor.h"
#include "prs/indices.h"
#include "prs/text.h"

namespace prs::input {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 20;
constexpr std::size_t kMostErrors = 20;

InputError refusal(std::string_view name, std::string_view got, std::string_view fix) {
  return InputError(
      fmt::format("{}:1:1: error: got {}; expected a readable YAML file of at most 1 MiB; {}", name, got, fix));
}

}  // namespace

Source load_source(const std::string& file, std::vector<std::string> overrides) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  throw_if_scarce(error.value(), file);
  if (!fs::exists(status)) throw refusal(file, "no such file", "check the path");
  if (fs::is_directory(status)) throw refusal(file, "a folder", "name a file in it");
  if (!fs::is_regular_file(status))
    throw refusal(file, "no regular file", "copy it to a file first, or pipe it into `prs .. -`");

  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw_if_scarce(errno, file);
    throw refusal(file, "a file that cannot be opened", "check its permissions");
  }
  return read_source(in, file, std::move(overrides));
}

Source read_source(std::istream& in, std::string name, std::vector<std::string> overrides) {
  std::string text;
  for (std::array<char, 16'384> block{}; in && text.size() <= kLargestFile;) {
    in.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) throw refusal(name, "a file that cannot be read", "check the disk");
  if (text.size() > kLargestFile)
    throw refusal(name, "a file of more than 1 MiB",
                  "check that it is the right file; long force histories are CSV files (`life.history`)");
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);                    // Byte order mark.
  if (text.find('\n') == text.npos) std::ranges::replace(text, '\r', '\n');  // Line ends of old Macs.
  return {std::move(name), std::move(text), std::move(overrides)};
}

Source source_of_text(std::string name, std::string text, std::vector<std::string> overrides,
                      std::filesystem::path folder) {
  if (text.size() > kLargestFile)
    throw InputError(
        fmt::format("{}:1:1: error: got a text of {} bytes; expected a YAML text of at most 1 MiB; "
                    "check that it "
                    "is the right one",
                    name, text.size()));
  return {std::move(name), std::move(text), std::move(overrides), std::move(folder)};
}

std::string ErrorList::where(Place place) const { return place_in(source_.name, source_.text, place.offset); }

void ErrorList::add(Place place, std::string_view key, std::string_view message) {
  errors_.push_back({place, {shown(key), std::string(message)}});
}

void ErrorList::add_consequence(Place place, std::string_view key, std::string_view message) {
  consequences_.push_back({place, {shown(key), std::string(message)}});
}

void ErrorList::fail(Place place, std::string_view key, std::string_view message) {
  add(place, key, message);
  throw_if_any();
  std::abort();  // Unreachable: there is an error.
}

void ErrorList::take(const ErrorList& other, const std::function<Place(Place)>& move) {
  for (const Error* e : other.told()) {
    Error moved{move(e->place), e->problem};
    if (!contains(errors_, moved)) errors_.push_back(std::move(moved));
  }
}

std::vector<const ErrorList::Error*> ErrorList::told() const {
  std::vector<const Error*> order;
  for (const Error& e : errors_.empty() ? consequences_ : errors_) order.push_back(&e);
  std::stable_sort(order.begin(), order.end(), [](const Error* a, const Error* b) {
    return std::tie(a->place.argument, a->place.offset) < std::tie(b->place.argument, b->place.offset);
  });
  return order;
}

std::string ErrorList::first() const { return empty() ? std::string() : told().front()->problem.text(); }

void ErrorList::throw_if_any() const {
  if (empty()) return;
  std::vector<const Error*> order = told();
  if (order.size() > kMostErrors) order.resize(kMostErrors);
  std::string lines;
  for (const Error* e : order) {
    lines += fmt::format("{}{}: error: {}", lines.empty() ? "" : "\n", where(e->place), e->problem.text());
    if (e->place.argument >= 0)
      lines += fmt::format(" (from --set {})", shown(item_at(source_.overrides, e->place.argument)));
  }
  throw InputError(lines);
}

std::string place_in(std::string_view name, std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::string_view head = before.substr(before.rfind('\n') + 1);
  return fmt::format("{}:{}:{}", name, line, 1 + width(head));
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  if (text.size() <= kLongest) return printable(text);
  std::size_t end = kLongest;
  while (end > kLongest - 3 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return printable(text.substr(0, end)) + "...";
}

}  // namespace prs::input
