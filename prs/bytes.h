#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prs {

/// Appends numbers in this machine's order of bytes, and texts after their length.
inline void put(std::string& bytes, std::uint64_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

inline void put(std::string& bytes, std::string_view text) {
  put(bytes, text.size());
  bytes.append(text);
}

inline void put(std::string& bytes, std::span<const std::string> texts) {
  put(bytes, texts.size());
  for (const std::string& text : texts) put(bytes, text);
}

/// Reads values from untrusted bytes; past their end all is zero and `good` false.
class Cursor {
 public:
  explicit Cursor(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    std::memcpy(&value, text(sizeof value).data(), good_ ? sizeof value : 0);
    return value;
  }
  std::string_view text(std::uint64_t length) {
    good_ = good_ && length <= bytes_.size();
    const std::string_view taken = bytes_.substr(0, good_ ? length : 0);
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::string text() { return std::string(text(number())); }
  std::vector<std::string> texts() {
    std::vector<std::string> all;
    for (std::uint64_t left = number(); left > 0 && good_; --left) all.push_back(text());
    return all;
  }

  bool good() const { return good_; }
  bool at_end() const { return good_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool good_ = true;
};

}  // namespace prs
