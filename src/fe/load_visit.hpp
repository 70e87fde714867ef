// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"

#include <functional>
#include <span>

/// Forces at integration points of a load, and what is done with them.
namespace spricka::fe {

/// A force at a point of a side or an element.
struct LoadPoint {
  base::Vec3 r = base::Vec3::Zero(); ///< reference coordinates, as many as there are
  base::Vec3 force = base::Vec3::Zero();
};

/// What shall be done with the points of each side and of each element, one after the other.
struct LoadPointVisitor {
  using FaceVisit = std::function<void(const model::Face&, std::span<const LoadPoint>)>;
  using BodyVisit = std::function<void(base::ElementId, std::span<const LoadPoint>)>;
  FaceVisit on_face;
  BodyVisit on_body;
};

} // namespace spricka::fe
