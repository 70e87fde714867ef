// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>

namespace spricka::solve {

/// Numbers of a factor, not set at first: each thread sets those that it works on, where it runs.
class FactorValues {
public:
  [[nodiscard]] double* get() const { return memory_.get(); }
  /// Keeps the first of them. Throws std::bad_alloc.
  void resize(std::size_t count) {
    void* const moved =
        std::realloc(memory_.get(), std::max<std::size_t>(1, count) * sizeof(double)); // NOLINT
    if (moved == nullptr) {
      throw std::bad_alloc();
    }
    static_cast<void>(memory_.release());
    memory_.reset(static_cast<double*>(moved));
  }

private:
  struct Free {
    void operator()(double* memory) const { std::free(memory); } // NOLINT: it is realloc's
  };
  std::unique_ptr<double, Free> memory_;
};

} // namespace spricka::solve
