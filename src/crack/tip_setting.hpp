// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/auxiliary_field.hpp"
#include "crack/extension.hpp"
#include "crack/front_loads.hpp"
#include "fe/element.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/forward.hpp"
#include "model/materials.hpp"
#include "model/mesh.hpp"

#include <array>
#include <functional>
#include <map>
#include <optional>

/// What the terms of G, K and T of a tip in the plane have in common.
namespace spricka::crack {

/// An element of a section, and vectors and values at its nodes.
using PlaneElement = fe::AnyElement<2>;
using PlaneVectors = fe::NodeVectors<PlaneElement>;
using PlaneValues = fe::NodeValues<PlaneElement>;
/// The reference element of a plane mesh's element, known when run.
inline const PlaneElement& plane_reference_element(const model::Mesh& mesh, base::ElementId e) {
  return shape::reference_element<2>(mesh.type[e.index()]);
}

/// A temperature that is linear all over the domains, T = at_tip + slope . (x - tip). Where the
/// temperature is another one, auxiliary fields take this and the rest goes into
/// nonlinear_temperature_term.
struct AffineTemperature {
  double at_tip = 0.0;
  base::Vec2 slope = base::Vec2::Zero();

  [[nodiscard]] double operator()(const TipFrame& tip, const base::Vec2& x) const {
    return at_tip + slope.dot(x - tip.x);
  }
};

/// Everything the kernels need of one tip. Material and property are those of the auxiliary fields;
/// of a tip between two materials, which has none, the ones on one side.
struct TipContext {
  const model::Model& model;
  const model::Mesh& mesh;
  const model::ElasticMaterial& material;
  const model::ElementProperty& property;
  TipFrame tip;
  base::NodeId tip_node;
  const mesh::CrackFaceNodes* crack_faces; ///< of the tip's crack; null: unknown
  const FrontLoads& loads;
  std::optional<AffineTemperature> affine = std::nullopt;
  double halves = 1.0; ///< 2: one half of the body is in the mesh

  [[nodiscard]] model::StressState state() const { return property.state; }
  [[nodiscard]] bool is_axisymmetric() const { return state() == model::StressState::axisymmetric; }
  /// What stands behind a point of the section for a unit of the front: 1, and about an axis its
  /// radius over the front's (crack.36).
  [[nodiscard]] double relative_depth(const base::Vec2& x) const {
    return is_axisymmetric() ? x.x() / tip.x.x() : 1.0;
  }
  /// Of a displacement v at x the strain round the axis; 0 in the plane.
  [[nodiscard]] double hoop_strain(const base::Vec2& v, const base::Vec2& x) const {
    return is_axisymmetric() ? v.x() / x.x() : 0.0;
  }
  /// A stress round the axis at x as a force per volume: along the radius; 0 in the plane.
  [[nodiscard]] base::Vec2 hoop_body_force(double stress, const base::Vec2& x) const {
    return {is_axisymmetric() ? stress / x.x() : 0.0, 0.0};
  }
  /// Free strain along the crack by a unit of temperature, alpha' of (crack.26).
  [[nodiscard]] double section_expansion_coefficient() const {
    return state() == model::StressState::plane_stress ? material.alpha
                                                       : (1.0 + material.nu) * material.alpha;
  }
  /// Of an element's own, in the section.
  [[nodiscard]] fe::Elasticity<2> elasticity(base::ElementId e) const;
  /// What turns the product of an extension and the forces of an auxiliary field into G, K1, K2 and
  /// T (crack.11, crack.12, crack.26), K as that of the property's own E'.
  [[nodiscard]] double intensity_conversion_factor(std::size_t auxiliary) const {
    const double E = fe::effective_modulus(material, state());
    return halves * (auxiliary == 0 ? 1.0 : auxiliary == force_auxiliary<2> ? E : 0.5 * E);
  }
};
/// Gathers the material, axes, crack faces and loads of a tip. There must be a domain; the property
/// is that of its first element.
TipContext make_tip_context(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front,
                            const std::vector<VirtualExtensionField>& fields,
                            const FrontLoads& loads);

/// Whether the elements of a field have more than one material or state.
bool is_between_materials(const TipContext& set, const VirtualExtensionField& field);

/// Displacement gradient of auxiliary field 1 to 3 at a point off the tip.
Eigen::Matrix2d auxiliary_field_gradient(const TipContext& set, const PolarCoordinates& at,
                                         std::size_t auxiliary);
/// Its displacement. About an axis a motion along the radius is none of a rigid body: the tip of
/// auxiliary fields 1 and 2 rests, and auxiliary field 3 is zero in a distance of the front's
/// radius.
base::Vec2 auxiliary_field_displacement(const TipContext& set, const PolarCoordinates& at,
                                        std::size_t auxiliary);

/// The q of a node; 0 where it rests.
double extension_of_node(const std::map<base::NodeId, double>& q, base::NodeId n);
/// The q of a field at the nodes of an element.
PlaneValues extension_at_element_nodes(const model::Mesh& mesh, base::ElementId e,
                                       const std::map<base::NodeId, double>& q);

/// In the elements where q varies the auxiliary fields behave like r^-1/2 or r^-1 but are smooth;
/// degree 9 leaves 1e-7 of them.
inline constexpr int domain_degree = 9;

} // namespace spricka::crack
