// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/load_rule.hpp"
#include "sense/mirror.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace spricka::sense {

/// Whether a load has the values of another at the mirror images of some places: the integral of
/// the difference, over what the places stand for, is round-off of that of the load. Points of a
/// quadrature rule that follows the load (fe::load_sample_points) see what the solution sees; those
/// that stand at a jump to round-off weigh nothing. Both are of one type.
bool load_values_are_mirrored(const Reflection& mirror, const model::Load& one,
                              const model::Load& other,
                              const std::vector<fe::LoadEvaluationPoint>& places);

/// The first of `count` things that has no image among them: none is its own, or left to be its own
/// alone. `answers(i, j)`: whether j can be the image of i, and i that of j.
std::optional<std::size_t>
find_item_without_image(std::size_t count,
                        const std::function<bool(std::size_t, std::size_t)>& answers);

} // namespace spricka::sense
