// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/doubt.hpp"

#include <algorithm>
#include <array>

namespace spricka::base {

namespace {

constexpr std::array<std::string_view, 1> without_answer{"W508"};
constexpr std::array<std::string_view, 13> inexact{"W307", "W423", "W425", "W426", "W435",
                                                   "W436", "W501", "W503", "W504", "W505",
                                                   "W506", "W507", "W570"};

} // namespace

Doubt doubt_of(std::string_view code) {
  if (std::ranges::find(without_answer, code) != without_answer.end()) {
    return Doubt::no_answer;
  }
  return std::ranges::find(inexact, code) != inexact.end() ? Doubt::less_exact : Doubt::odd;
}

std::string_view word_of(Doubt doubt) {
  switch (doubt) {
  case Doubt::no_answer:
    return "no answer";
  case Doubt::less_exact:
    return "less exact";
  case Doubt::odd:
    break;
  }
  return "odd";
}

} // namespace spricka::base
