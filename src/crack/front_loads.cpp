// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/front_loads.hpp"

#include "model/loads.hpp"
#include "model/mesh_side.hpp"

#include <algorithm>

namespace spricka::crack {

bool FrontLoads::has_element_loads() const {
  return temperature.size() > 0 ||
         std::ranges::any_of(loads, [](const ActingLoad& a) { return !a.elements.empty(); });
}

base::Vec3 load_force_on_face(const ActingLoad& acting, const base::Vec3& x,
                              const base::Vec3& area) {
  const base::Vec3 value = fe::load_value(*acting.load, x);
  return acting.load->type == model::LoadType::pressure
             ? base::Vec3(-acting.factor * value.x() * area)
             : base::Vec3(acting.factor * area.norm() * value);
}

fe::FieldMagnitude face_load_scale(const model::Mesh& mesh, const ActingLoad& acting) {
  return acting.faces.empty() || !acting.load->faces.valid() ? fe::FieldMagnitude()
                                                             : fe::load_scale(mesh, *acting.load);
}

std::vector<FacePointForces> load_forces_on_faces(const model::Mesh& mesh,
                                                  const FrontLoads& loads) {
  std::vector<FacePointForces> forces;
  for (const ActingLoad& acting : loads.loads) {
    const fe::FieldMagnitude scale = face_load_scale(mesh, acting);
    for (const model::Face& face : acting.faces) {
      const geometry::ElementSide side = model::element_side(mesh, face);
      FacePointForces on{face, {}};
      for (const auto& point : fe::load_rule(side, *acting.load, scale).points) {
        fe::LoadPoint& at = on.points.emplace_back();
        at.r.head<2>() = point.r;
        at.force = point.weight *
                   load_force_on_face(acting, side.X * side.N(point.r), side.area_vector(point.r));
      }
      forces.push_back(std::move(on));
    }
  }
  return forces;
}

} // namespace spricka::crack
