// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/source_digest.hpp"

#include <spricka_source_digest.hpp>

namespace spricka::solve {

const char* source_digest() {
  return SPRICKA_SOURCE_DIGEST;
}

} // namespace spricka::solve
