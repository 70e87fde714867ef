// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <optional>

namespace spricka::life {

/// Root of an increasing function between begin < end, to a few bits of x (Brent 1973). f may be
/// infinite at and near both ends. Nothing if f has one sign on both.
std::optional<double> root_of_increasing_function(const std::function<double(double)>& f,
                                                  double begin, double end);

} // namespace spricka::life
