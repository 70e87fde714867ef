// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "fe/heat.hpp"
#include "fe/load_points.hpp"
#include "fe/load_rule.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <optional>
#include <vector>

/// What acts on the elements and faces round a front.
namespace spricka::crack {

/// A load of the deck with the factor it has: TRACTION and PRESSURE act on `faces`, the others on
/// `elements` (force per volume; a temperature is in FrontLoads). The load must outlive it.
struct ActingLoad {
  const model::Load* load = nullptr;
  double factor = 0.0;
  std::vector<base::ElementId> elements; ///< ascending
  std::vector<model::Face> faces;
};

/// Forces on a side at its points.
struct FacePointForces {
  model::Face face;
  std::vector<fe::LoadPoint> points;
};

/// Forces between the faces of a crack in the plane, given at their nodes.
struct ForcesBetweenCrackFaces {
  std::vector<model::Face> faces; ///< element sides that make the faces, each with its body
  base::Vector force;             ///< [dim * node] on the faces; other nodes count as free
  double at_tip = 0.0;            ///< stress across the faces at a closed tip [stress]
};

/// What acts on a front and the domains round it.
struct FrontLoads {
  std::vector<ActingLoad> loads; ///< of the deck, in space its elements as a whole
  base::Vector temperature;      ///< of elements [connectivity index], see fe/thermal.hpp; or empty
  std::vector<fe::ScaledTemperature> heat = {}; ///< of the same; empty: elements take all of it
  std::optional<ForcesBetweenCrackFaces> crack_faces =
      std::nullopt; ///< of a tip; empty: there are none
  /// In space: on faces of the body that has the crack, of pressure and friction between surfaces
  /// in contact.
  std::vector<FacePointForces> contact = {};
  /// Of contact, the normal stress across the crack's faces at the front [point]; empty: none.
  std::vector<double> across = {};

  /// Whether some element feels a force per volume or a temperature.
  [[nodiscard]] bool has_element_loads() const;
};

/// Force of one load on a place x of a face [force], per unit thickness in the plane; `area` is the
/// face's normal as long as the area or length that the place stands for.
base::Vec3 load_force_on_face(const ActingLoad& acting, const base::Vec3& x,
                              const base::Vec3& area);

/// Scale of a load on faces, for fe::load_rule.
fe::FieldMagnitude face_load_scale(const model::Mesh& mesh, const ActingLoad& acting);

/// Forces of the deck's loads on sides round the front, at points; of the deck's own rules. About
/// an axis what stands behind a point is not in them.
std::vector<FacePointForces> load_forces_on_faces(const model::Mesh& mesh, const FrontLoads& loads);

} // namespace spricka::crack
