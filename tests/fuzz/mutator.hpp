// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

namespace spricka::fuzz {

/// Changes decks as slips, bad transfers and malice do. The same seed gives the same decks
/// everywhere.
class Mutator {
public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  /// One to four changes to `text`; pieces may come from `other`.
  std::string mutate(std::string text, std::string_view other);

  /// A number from 0 to n-1; n is not 0.
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

private:
  void once(std::string& text, std::string_view other);
  void bytes(std::string& text);
  void lines(std::string& text, std::string_view other);
  void tokens(std::string& text, std::string_view other);
  void numbers(std::string& text);
  void nesting(std::string& text);

  std::mt19937_64 random_;
};

} // namespace spricka::fuzz
