// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/front_extension.hpp"
#include "crack/front_loads.hpp"
#include "crack/moving_field.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/forward.hpp"

#include <optional>
#include <span>
#include <vector>

/// What the terms of G, K and T along a front have in common.
namespace spricka::crack {

/// Everything the kernels need of one front. The material is that of all elements of its domains.
struct FrontContext {
  const model::Model& model;
  const model::Mesh& mesh;
  const model::ElasticMaterial& material;
  FrontBody body;
  FrontAxes axes;
  double halves = 1.0; ///< 2: one half of the body is in the mesh

  /// What turns the product of an extension, of length 1 along the front, and the forces of a
  /// auxiliary field into G, K1, K2, K3 and T (crack_space.7, crack_space.12).
  [[nodiscard]] double intensity_conversion_factor(std::size_t auxiliary) const;
  [[nodiscard]] double E_effective() const; ///< E / (1 - nu^2)
  /// What a tip in the plane has about an axis: nothing is there.
  [[nodiscard]] static double relative_depth(const base::Vec3& /*x*/) { return 1.0; }
  [[nodiscard]] static double hoop_strain(const base::Vec3& /*v*/, const base::Vec3& /*x*/) {
    return 0.0;
  }
  [[nodiscard]] static base::Vec3 hoop_body_force(double /*stress*/, const base::Vec3& /*x*/) {
    return base::Vec3::Zero();
  }
};
/// Of the fields of a front, of which there is one at least.
FrontContext make_front_context(const model::Model& model, const mesh::CrackedMesh& cracked,
                                const mesh::CrackFront& front, const FrontIntegralDomains& fields);

/// The strain along the front at each point, e_tt = sum of weight . u over its nodes, by the
/// point's hat (crack_space.13).
struct NodeWeight {
  base::NodeId node;
  base::Vec3 weight;
};
/// Weights of the nodal displacements [point][entry] in that strain, mid nodes included; a node may
/// stand in several entries of a point.
std::vector<std::vector<NodeWeight>> strain_along_front_weights(const mesh::CrackFront& front,
                                                                const model::Mesh& mesh,
                                                                const FrontIntegralDomains& fields);

} // namespace spricka::crack
