// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>

namespace spricka::fe {

enum class TieSeverity { error, warning, note };

/// What is wrong with an entry of Model::mpcs, or worth knowing.
struct TieFailure {
  std::size_t mpc = 0;
  std::string why;
  TieSeverity severity = TieSeverity::error;
};

} // namespace spricka::fe
