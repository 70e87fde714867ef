// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

#include <xxhash.h>

namespace spricka::base {

/// 128-bit hash of what it is fed, in order (XXH3, Collet).
class Hasher {
public:
  Hasher() : state_(XXH3_createState()) { XXH3_128bits_reset(state_.get()); }

  /// Feeds raw bytes, without their number.
  void add_bytes(const void* data, std::size_t bytes) {
    XXH3_128bits_update(state_.get(), data, bytes);
  }
  /// Feeds the bytes of a value that has no padding and no pointers.
  template <class T> void value(const T& v) { add_bytes(&v, sizeof v); }
  /// With its length, so that no two lists of texts are alike.
  void add_text(std::string_view t) {
    value(t.size());
    add_bytes(t.data(), t.size());
  }
  /// The hash of all that was fed so far, high and low half; more may be fed afterwards.
  [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> digest() const {
    const XXH128_hash_t h = XXH3_128bits_digest(state_.get());
    return {h.high64, h.low64};
  }

private:
  struct HashStateDeleter {
    void operator()(XXH3_state_t* s) const { XXH3_freeState(s); }
  };
  std::unique_ptr<XXH3_state_t, HashStateDeleter> state_;
};

} // namespace spricka::base
