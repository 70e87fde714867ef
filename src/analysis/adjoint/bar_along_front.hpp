// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/adjoint/edge_changes.hpp"
#include "base/vec.hpp"
#include "estimate/error_bar.hpp"
#include "results/front_result.hpp"

#include <array>
#include <vector>

namespace spricka::analysis {

/// Gives the points of a front their bars (manual, estimate.24) from what cubic elements add to K1,
/// K2, K3, those of the front from `first` on, and the smooth values of K with that [point].
/// `coarse_contact`: part of the largest K that coarse surfaces of other bodies may make it off by.
/// `edges`: what the edges of contacts do to K.
void add_front_error_bars(const base::Vector& eta, const std::vector<std::array<double, 3>>& best,
                          const ContactEdgeKChange& edges, Eigen::Index first,
                          double coarse_contact, const estimate::ErrorBarUse& use,
                          results::FrontResult& front);

} // namespace spricka::analysis
