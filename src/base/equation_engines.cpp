// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/equation_engines.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

namespace spricka::base {

namespace {

constexpr std::array<std::string_view, 4> engine_words{"auto", "cholesky", "mumps", "multigrid"};

} // namespace

std::string_view equation_engine_word(EquationEngine engine) {
  return engine_words.at(static_cast<std::size_t>(engine));
}

std::optional<EquationEngine> equation_engine_of_word(std::string_view word) {
  for (std::size_t i = 0; i < engine_words.size(); ++i) {
    if (std::ranges::equal(engine_words.at(i), word, {}, {},
                           [](unsigned char c) { return std::tolower(c); })) {
      return static_cast<EquationEngine>(i);
    }
  }
  return {};
}

} // namespace spricka::base
