// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/measure_title.hpp"
#include "results/results.hpp"

#include <string>

namespace spricka::report {

/// A crack in space and the front to be drawn.
struct CrackView {
  const results::CrackLengthResult* increment = nullptr;
  const results::LoadStepResult* step = nullptr;
  const results::FrontResult* front = nullptr;
  base::OutputUnit length; ///< of how far faces are apart
  double width = 420.0;    ///< [px]
};

/// The crack seen along its normal: how far its faces are apart as colours, the front with its
/// points. Empty where the crack is not plane.
std::string draw_crack_opening(const CrackView& view);

} // namespace spricka::report
