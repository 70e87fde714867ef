// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/piecewise_linear.hpp"
#include "results/load_path.hpp"
#include "results/results.hpp"

namespace spricka::analysis {

/// K on a path plus its estimated error, which is known at both ends of the path (`at_zero` at
/// t = 0, `at_one` at t = 1) and linear in K between and beyond; in t, where K turns back on the
/// way or changes by less than the error does (growth.14). Where faces touch K stays 0. All in
/// units of K.
base::PiecewiseLinear correct_K(const base::PiecewiseLinear& K, double at_zero, double at_one);

/// Whether the faces of a crack touch on some part of a path: K1 is 0 there.
bool faces_touch_on_path(const base::PiecewiseLinear& K1);

/// A path with the errors of K1, and of K2 at tips, taken out that the bars of its first and its
/// last step estimate; where they have none K is as computed.
results::LoadPathResult correct_path_K(results::LoadPathResult path,
                                       const results::LoadStepResult& from,
                                       const results::LoadStepResult& to);

/// The estimated error of K1 (mode 0), K2 or K3 at point i of a front, at the surface that of the
/// next point; 0 where there is no bar, or where faces touch. [K]
double estimated_K_error(const results::FrontResult& front, std::size_t i, std::size_t mode);

} // namespace spricka::analysis
