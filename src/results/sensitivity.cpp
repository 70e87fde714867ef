// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sensitivity.hpp"

namespace spricka::results {

std::string word_of(Cause cause) {
  switch (cause) {
  case Cause::load:
    return "LOAD";
  case Cause::fit:
    return "FIT";
  case Cause::modulus:
    return "E";
  case Cause::length:
    return "A";
  case Cause::axis:
    break;
  }
  return "C";
}

} // namespace spricka::results
