// Loaded into the program before the C library: limits memory allocated at once to PRS_LARGEST_ALLOCATION bytes.

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
}

namespace {

std::size_t largest = SIZE_MAX;

[[gnu::constructor]] void read_limit() {
  if (const char* bytes = std::getenv("PRS_LARGEST_ALLOCATION")) largest = std::strtoull(bytes, nullptr, 10);
}

bool is_refused(std::size_t bytes) {
  if (bytes <= largest) return false;
  errno = ENOMEM;
  return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t bytes) { return is_refused(bytes) ? nullptr : __libc_malloc(bytes); }

void* calloc(std::size_t count, std::size_t bytes) {
  return bytes > 0 && is_refused(count > SIZE_MAX / bytes ? SIZE_MAX : count * bytes) ? nullptr
                                                                                      : __libc_calloc(count, bytes);
}

void* realloc(void* memory, std::size_t bytes) { return is_refused(bytes) ? nullptr : __libc_realloc(memory, bytes); }

}  // extern "C"
