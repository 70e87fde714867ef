// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

namespace spricka::results {

/// How far K1, K2 or K3 may be off by the mesh, as estimated (manual, error_bar.md); all in units
/// of K.
struct KErrorBar {
  double eta = 0.0;        ///< estimated exact value less that of the mesh
  double sum = 0.0;        ///< of |eta_e| over the elements
  double set_change = 0.0; ///< largest change by one pair beside the end of a contact
  double mesh = 0.0;       ///< the bar's three parts
  double edge = 0.0;
  double floor = 0.0;
  double best = 0.0;    ///< K of the mesh with its estimated error taken out
  bool cancels = false; ///< errors of opposite sign cancel
  /// The bar is that of `best`, which is the K that counts; false: that of K as the mesh has it.
  bool of_best = false;
  std::vector<double> of_element; ///< eta_e [element], their sum is eta

  [[nodiscard]] double size() const { return mesh + edge + floor; }
};

} // namespace spricka::results
