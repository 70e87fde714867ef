// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/gather_fronts.hpp"

#include "analysis/recover/judge_front.hpp"
#include "analysis/scene/front_name.hpp"
#include "analysis/scene/front_scene.hpp"
#include "base/tidy.hpp"
#include "contact/space_tractions.hpp"
#include "crack/space/front_intensity.hpp"
#include "mesh/tube/cracks_in_solids.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <set>

namespace spricka::analysis {

namespace {

const model::CrackExtensionSettings* request_of(const model::Model& model, base::CrackId crack) {
  const auto found = std::ranges::find(model.vces, crack, &model::CrackExtensionSettings::crack);
  return found == model.vces.end() ? nullptr : &*found;
}

// What contacts press on the free sides that domains move.
std::vector<crack::FacePointForces> contact_forces(const Discretisation& scene,
                                                   const crack::FrontExtensions& fields,
                                                   const StepState& state) {
  std::set<model::Face> moved;
  for (const crack::MovedFreeSide& side : fields.sides) {
    moved.insert(side.face);
  }
  std::vector<crack::FacePointForces> forces;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    for (const contact::FaceTraction& traction :
         contact::space_tractions(scene.pairs[c], state.pair_lambda[c],
                                  [&](const model::Face& face) { return moved.contains(face); })) {
      crack::FacePointForces& on_face = forces.emplace_back();
      on_face.face = traction.face;
      for (const contact::TractionPoint& point : traction.points) {
        on_face.points.push_back({{point.r.x(), point.r.y(), 0.0}, point.force});
      }
    }
  }
  return forces;
}

// Round-off of a coordinate that is zero would be printed as a number.
base::Vec3 without_round_off(const base::Vec3& x, double reach) {
  constexpr double round_off = 1e-14;
  return (x.array().abs() > round_off * reach).select(x, base::Vec3::Zero());
}

results::FrontPointResult place_of(const model::CrackDefinition& crack,
                                   const mesh::FrontPoint& point, const crack::StressIntensity& K) {
  results::FrontPointResult place;
  place.x = point.x;
  place.growth = point.growth;
  place.s = point.s;
  place.phi =
      crack.kind == model::CrackDefinitionKind::ellipse ? mesh::front_angle(crack, point.x) : 0.0;
  place.K1 = K.K1;
  place.K2 = K.K2;
  place.K3 = K.K3;
  place.G = K.G;
  place.G_from_K = K.G_from_K;
  place.T = K.T;
  place.spread = K.spread;
  place.at_surface = point.at_surface;
  if (K.front) {
    place.smooth = K.front->from_inside.value_or(K.front->smooth);
    if (K.opening && K.front->opening_K3) {
      place.opening = {(*K.opening)[0], (*K.opening)[1], *K.front->opening_K3};
    }
  }
  return place;
}

} // namespace

void evaluate_fronts(const model::Model& model, const Discretisation& scene, const StepState& state,
                     results::StepResult& out) {
  for (const FrontWithDomains& at : scene.fronts) {
    const mesh::CrackFront& front = at.front;
    const model::CrackDefinition& crack = model.cracks[front.crack.index()];
    const model::CrackExtensionSettings* vce = request_of(model, front.crack);
    crack::FrontIntensityRequest request;
    request.opening = vce != nullptr && vce->opening;
    crack::FrontLoads loads;
    loads.given = front_loads(model, scene, at.fields, state.case_factor);
    loads.contact = contact_forces(scene, at.fields, state);
    const std::vector<FrontFaces> faces = front_faces(scene, front, state);
    for (const FrontFaces& point : faces) {
      loads.across.push_back(0.0 - point.pressure);
    }
    const std::vector<crack::StressIntensity> K =
        crack::front_intensity(model, scene.cracked, front, at.fields, request, state.u, loads);
    results::FrontResult result;
    result.name = front_name(model, scene, front);
    result.a = base::remove_round_off(front.a);
    result.closed = at.fields.closed;
    result.length = result.closed ? front.curve->length() : front.points.back().s;
    result.angles = crack.kind == model::CrackDefinitionKind::ellipse;
    double reach = 0.0;
    for (const mesh::FrontPoint& point : front.points) {
      reach = std::max(reach, point.x.cwiseAbs().maxCoeff());
    }
    for (std::size_t i = 0; i < front.points.size(); ++i) {
      result.points.push_back(place_of(crack, front.points[i], K[i]));
      result.points.back().x = without_round_off(front.points[i].x, reach);
      result.points.back().number = static_cast<int>(i) + 1;
    }
    check_front_faces({model, scene, front, state, K, faces}, result, out);
    out.fronts.push_back(std::move(result));
  }
}

} // namespace spricka::analysis
