// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::grammar {

/// What a letter of ResultQuantity::arguments stands for, in the deck's words.
constexpr const char* argument_word(char letter) {
  switch (letter) {
  case 'c':
    return "crack";
  case 'p':
    return "contact";
  case 's':
    return "step";
  case 'o':
    return "load case";
  case 'm':
    return "material";
  case 'l':
    return "load path";
  case 't':
    return "test";
  case 'n':
    return "set";
  case 'd':
    return "direction";
  case 'e':
    return "net";
  default:
    return "number";
  }
}

} // namespace spricka::grammar
