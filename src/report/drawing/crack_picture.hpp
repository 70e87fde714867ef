// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "report/drawing/solid_picture.hpp"
#include "results/results.hpp"

#include <string>

namespace spricka::report {

/// A crack in space and the front to be drawn.
struct CrackView {
  const results::CrackLengthResult* increment = nullptr;
  const results::LoadStepResult* step = nullptr;
  const results::FrontResult* front = nullptr;
  std::string k_name;      ///< unit of K
  std::string length_name; ///< unit of length
  double width = 420.0;    ///< [px]
};

/// The front in its body, which is drawn by its edges, coloured by K1; the eye stands where the
/// mouth of the crack is seen. Empty where the surface is not known.
std::string draw_crack_front(const CrackView& view);

/// The crack seen along its normal: how far its faces are apart as colours, the front with its
/// points. Empty where the crack is not plane.
std::string draw_crack_opening(const CrackView& view);

} // namespace spricka::report
