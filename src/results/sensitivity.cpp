// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sensitivity.hpp"

namespace spricka::results {

std::string display_word(SensitivityParameter cause) {
  switch (cause) {
  case SensitivityParameter::load:
    return "LOAD";
  case SensitivityParameter::fit:
    return "FIT";
  case SensitivityParameter::modulus:
    return "E";
  case SensitivityParameter::length:
    return "A";
  case SensitivityParameter::axis:
    break;
  }
  return "C";
}

} // namespace spricka::results
