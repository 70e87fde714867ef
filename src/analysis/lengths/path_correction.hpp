// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/piecewise_linear.hpp"
#include "results/load_path.hpp"
#include "results/results.hpp"

#include <vector>

namespace spricka::analysis {

/// The estimated error of K at a place t of a path [K].
struct ErrorOnPath {
  double t = 0.0;
  double error = 0.0;
};

/// K on a path plus its estimated error, known at ascending places (two at least, the first where
/// the path begins), and linear in K from one to the next and beyond; in t, where K turns back on
/// the way or changes by less than the error does (growth.14). Where faces touch K stays 0.
base::PiecewiseLinear correct_K(const base::PiecewiseLinear& K,
                                const std::vector<ErrorOnPath>& errors);

/// Whether the faces of a crack touch on some part of a path: K1 is 0 there.
bool faces_touch_on_path(const base::PiecewiseLinear& K1);

/// Takes the errors of K out of a path that its first and its last step have had taken out of
/// theirs; where none has K stays as it is. Of a crack whose faces are open at one end and bear at
/// the other the error goes with K from the open end until they begin to bear.
void correct_path_K(const results::LoadStepResult& from, const results::LoadStepResult& to,
                    results::LoadPathResult& path);

} // namespace spricka::analysis
