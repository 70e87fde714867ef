// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/result_concern.hpp"

#include <algorithm>
#include <array>

namespace spricka::base {

namespace {

constexpr std::array<std::string_view, 1> without_answer{"W508"};
constexpr std::array<std::string_view, 14> inexact{"W307", "W423", "W425", "W426", "W435",
                                                   "W436", "W501", "W503", "W504", "W505",
                                                   "W506", "W507", "W509", "W570"};

} // namespace

ResultConcern concern_of_warning_code(std::string_view code) {
  if (std::ranges::find(without_answer, code) != without_answer.end()) {
    return ResultConcern::no_answer;
  }
  return std::ranges::find(inexact, code) != inexact.end() ? ResultConcern::less_exact
                                                           : ResultConcern::odd;
}

std::string_view display_word(ResultConcern kind) {
  switch (kind) {
  case ResultConcern::no_answer:
    return "no answer";
  case ResultConcern::less_exact:
    return "less exact";
  case ResultConcern::odd:
    break;
  }
  return "odd";
}

} // namespace spricka::base
