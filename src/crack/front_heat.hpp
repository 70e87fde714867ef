// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"

#include <optional>
#include <vector>

namespace spricka::crack {

/// A temperature that is linear in space, at + slope . x.
struct LinearTemperature {
  double at = 0.0;
  base::Vec3 slope = base::Vec3::Zero();

  [[nodiscard]] double operator()(const base::Vec3& x) const { return at + slope.dot(x); }
};

/// The linear temperature that the corners of some elements have, `temperature` by connectivity
/// index; nothing where they have another one.
std::optional<LinearTemperature>
exact_linear_temperature(const model::Mesh& mesh, const std::vector<base::ElementId>& elements,
                         const base::Vector& temperature);

} // namespace spricka::crack
