// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/slips.hpp"

#include <array>
#include <cstddef>

namespace spricka::grammar {

namespace {

struct Slip {
  std::string_view sign;
  std::string_view remedy;
};

constexpr std::string_view blank = "a no-break space stands here: write a plain blank";
constexpr std::string_view minus = "a long dash stands here: the minus sign is -";
constexpr std::string_view quote = "a text stands in single quotes";
constexpr std::string_view comment = "a comment starts with !";

constexpr std::array slips{
    Slip{"\xC2\xA0", blank},
    Slip{"\xE2\x80\xAF", blank},
    Slip{"\xE2\x80\x89", blank},
    Slip{"\xE2\x80\x87", blank},
    Slip{"\xE2\x88\x92", minus},
    Slip{"\xE2\x80\x90", minus},
    Slip{"\xE2\x80\x91", minus},
    Slip{"\xE2\x80\x93", minus},
    Slip{"\xE2\x80\x94", minus},
    Slip{"\xE2\x80\x98", quote},
    Slip{"\xE2\x80\x99", quote},
    Slip{"\xE2\x80\x9C", quote},
    Slip{"\xE2\x80\x9D", quote},
    Slip{"\xE2\x80\x9E", quote},
    Slip{"\xC3\x97", "times is *"},
    Slip{"\xC2\xB7", "times is *"},
    Slip{"\xC2\xB2", "the square is ^2"},
    Slip{"\xC2\xB3", "the cube is ^3"},
    Slip{"\xC2\xB0", "degrees are written 45[deg]"},
    Slip{"#", comment},
    Slip{"//", comment},
    Slip{"%", comment},
};

} // namespace

std::string_view foreign_syntax_hint(const char* begin, const char* p, const char* last) {
  if (p > begin && p < last && p[-1] == '*' && *p == '*') {
    return "a power is written ^: 5^2";
  }
  const std::string_view rest(p, static_cast<std::size_t>(last - p));
  for (const Slip& slip : slips) {
    if (rest.starts_with(slip.sign)) {
      return slip.remedy;
    }
  }
  const bool beyond_ascii = p<last&& static_cast<unsigned char>(*p)> 127;
  return beyond_ascii ? "letters and signs beyond ASCII stand in comments and texts only" : "";
}

} // namespace spricka::grammar
