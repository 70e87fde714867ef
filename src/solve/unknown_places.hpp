// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"

#include <cstdint>
#include <vector>

namespace spricka::solve {

/// Where the unknowns of a net are: an engine that coarsens a body by nodes must know its rigid
/// motions, which no matrix tells.
struct UnknownPlaces {
  std::vector<std::int32_t> node; ///< [n] of the net, from 0
  std::vector<std::int8_t> axis;  ///< [n] along which the unknown moves it
  base::Matrix position;          ///< [dim, nodes]
};

} // namespace spricka::solve
