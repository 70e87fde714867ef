// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/contact_point.hpp"

namespace spricka::results {

const char* display_word(ContactState state) {
  switch (state) {
  case ContactState::open:
    return "open";
  case ContactState::closed:
    return "closed";
  case ContactState::stick:
    return "stick";
  case ContactState::slip:
    break;
  }
  return "slip";
}

} // namespace spricka::results
