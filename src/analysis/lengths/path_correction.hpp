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

/// Takes the errors of K out of a path that its first and its last step have had taken out of
/// theirs; where none has K stays as it is.
void correct_path_K(const results::LoadStepResult& from, const results::LoadStepResult& to,
                    results::LoadPathResult& path);

} // namespace spricka::analysis
