#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace prs {

/// Memory for a kernel, aligned for the widest batch; grows, never shrinks.
class Workspace {
 public:
  /// At least `numbers` numbers.
  double* reserve(std::size_t numbers) {
    if (numbers > size_) {
      memory_.reset(static_cast<double*>(::operator new(numbers * sizeof(double), kAlignment)));
      size_ = numbers;
    }
    return memory_.get();
  }

 private:
  static constexpr std::align_val_t kAlignment{64};
  struct Free {
    void operator()(double* p) const { ::operator delete(p, kAlignment); }
  };
  std::unique_ptr<double, Free> memory_;
  std::size_t size_ = 0;
};

}  // namespace prs
