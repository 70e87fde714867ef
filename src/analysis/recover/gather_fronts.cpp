// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/gather_fronts.hpp"

#include "analysis/recover/judge_faces.hpp"
#include "analysis/scene/front_name.hpp"
#include "analysis/scene/front_surroundings.hpp"
#include "analysis/steps/crack_face_contact.hpp"
#include "base/tidy.hpp"
#include "contact/space_tractions.hpp"
#include "crack/front_intensity.hpp"
#include "crack/load_jumps.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

const model::VirtualCrackExtensionSettings* request_of(const model::Model& model,
                                                       base::CrackId crack) {
  const auto found =
      std::ranges::find(model.vces, crack, &model::VirtualCrackExtensionSettings::crack);
  return found == model.vces.end() ? nullptr : &*found;
}

// What contacts press on the free sides that domains move.
std::vector<crack::FacePointForces> contact_forces(const Discretisation& scene,
                                                   const crack::FrontIntegralDomains& fields,
                                                   const StepState& state) {
  std::set<model::Face> moved;
  for (const crack::MovedFreeSide& side : fields.sides) {
    moved.insert(side.face);
  }
  std::vector<crack::FacePointForces> forces;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    for (const contact::FaceTraction& traction : contact::solid_pair_tractions(
             scene.pairs[c], state.pair_lambda[c],
             [&](const model::Face& face) { return moved.contains(face); })) {
      crack::FacePointForces& on_face = forces.emplace_back();
      on_face.face = traction.face;
      for (const contact::FacePointForce& point : traction.points) {
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

results::FrontPointResult point_of(const mesh::FrontPoint& point, const crack::StressIntensity& K) {
  results::FrontPointResult result;
  result.x = point.x;
  result.direction = point.growth;
  result.s = point.s;
  result.K1 = K.K1;
  result.K2 = K.K2;
  result.K3 = K.K3;
  result.G = K.G;
  result.G_from_K = K.G_from_K;
  result.T = K.T;
  result.spread = K.spread;
  result.at_surface = point.at_surface;
  result.smooth =
      K.front ? K.front->from_inside.value_or(K.front->smooth) : std::array{K.K1, K.K2, K.K3};
  result.opening = K.opening;
  return result;
}

// A front with what is found at its points. K: [point].
results::FrontResult front_of(const model::Model& model, const Discretisation& scene,
                              const mesh::CrackFront& front,
                              const std::vector<crack::StressIntensity>& K) {
  results::FrontResult result;
  result.name = front_name(model, scene, front);
  result.a = base::restore_short_decimal(front.a);
  result.length = front.points.back().s;
  result.two_materials = std::ranges::any_of(K, &crack::StressIntensity::two_materials);
  for (std::size_t i = 0; i < front.points.size(); ++i) {
    result.points.push_back(point_of(front.points[i], K[i]));
    result.points.back().number = static_cast<int>(i) + 1;
  }
  return result;
}

// [domain] whether K of a domain of a tip is no measure of the others'.
std::vector<bool> discontinuous_domains(const model::Model& model, const Discretisation& scene,
                                        std::size_t f, const crack::FrontLoads& loads,
                                        const crack::StressIntensity& K) {
  if (scene.domains[f].empty()) {
    return {};
  }
  const std::vector<crack::VirtualExtensionField>& fields = scene.domains[f].points.front();
  return crack::domains_with_load_jumps(
      crack::make_tip_context(model, scene.cracked, scene.cracked.fronts[f], fields, loads), fields,
      std::hypot(K.K1, K.K2));
}

// K1 of the domains of a tip that are a measure of each other; notes where the shift of nodes or
// jumps of loads leave G less exact.
void compare_domains(const std::vector<bool>& discontinuous, const crack::StressIntensity& K,
                     results::FrontResult& result, results::LoadStepResult& out) {
  for (std::size_t d = 0; d < K.domains.size(); ++d) {
    if (!discontinuous[d]) { // others are no measure of each other
      result.single_point().K1_domain.push_back(K.domains[d].K1);
    }
  }
  if (K.shift_error && std::abs(*K.shift_error) > 2e-5) { // of G; 1e-5 of K (crack.15)
    out.notes.push_back(
        results::less_exact_note(fmt::format("{}: G by the finite shift is {:+.2g} of the analytic "
                                             "one off, and K by half of that: the shift is too "
                                             "large or lost in round-off; leave SHIFT of $VCE out",
                                             result.name, *K.shift_error)));
  }
  if (!K.domains.empty() && std::ranges::all_of(K.domains, [](const crack::DomainIntensity& d) {
        return std::isnan(d.G);
      })) {
    out.notes.push_back(
        results::make_note(fmt::format("{}: loads or temperatures jump within all domains of K, "
                                       "which leave G to K: it is (K1^2 + K2^2)/E'",
                                       result.name)));
  }
}

// What loads, contacts and the crack's own faces do to a front. faces: [point] in space.
crack::FrontLoads loads_on(const model::Model& model, const Discretisation& scene, std::size_t f,
                           const std::vector<FrontFaceContact>& faces, const StepState& state) {
  const mesh::CrackFront& front = scene.cracked.fronts[f];
  crack::FrontLoads loads = collect_front_loads(model, scene, scene.domains[f], state.case_factor);
  if (front.is_tip()) {
    loads.crack_faces = crack_face_forces(scene, front, state);
    return loads;
  }
  loads.contact = contact_forces(scene, scene.domains[f], state);
  for (const FrontFaceContact& point : faces) {
    loads.across.push_back(0.0 - point.pressure);
  }
  return loads;
}

// What the results of a front in space have beside those of a tip.
void place_points(const model::Model& model, const Discretisation& scene, std::size_t f,
                  results::FrontResult& result) {
  const mesh::CrackFront& front = scene.cracked.fronts[f];
  const model::CrackDefinition& crack = model.cracks[front.crack.index()];
  result.is_loop = scene.domains[f].closed;
  result.length = result.is_loop ? front.curve->length() : result.length;
  result.has_angles = crack.kind == model::CrackDefinitionKind::ellipse;
  double reach = 0.0;
  for (const mesh::FrontPoint& point : front.points) {
    reach = std::max(reach, point.x.cwiseAbs().maxCoeff());
  }
  for (results::FrontPointResult& point : result.points) {
    point.phi = result.has_angles ? mesh::ellipse_parametric_angle(crack, point.x) : 0.0;
    point.x = without_round_off(point.x, reach);
  }
}

void gather_front(const model::Model& model, const Discretisation& scene, std::size_t f,
                  const StepState& state, results::LoadStepResult& out) {
  const mesh::CrackFront& front = scene.cracked.fronts[f];
  crack::FrontIntensityOptions request;
  request.state = model.cracks[front.crack.index()].state;
  if (const model::VirtualCrackExtensionSettings* vce = request_of(model, front.crack)) {
    request.shift = vce->shift;
    request.opening = vce->opening;
  }
  const std::vector<FrontFaceContact> faces =
      front.is_tip() ? std::vector<FrontFaceContact>() : front_face_contact(scene, front, state);
  const crack::FrontLoads loads = loads_on(model, scene, f, faces, state);
  const std::vector<crack::StressIntensity> K = crack::front_intensity(
      model, scene.cracked, front, scene.domains[f], request, state.u, loads);
  results::FrontResult result = front_of(model, scene, front, K);
  if (front.is_tip()) {
    compare_domains(discontinuous_domains(model, scene, f, loads, K.front()), K.front(), result,
                    out);
  } else {
    place_points(model, scene, f, result);
  }
  judge_K_by_faces_and_materials({model, scene, front, state, K, faces}, result, out);
  out.fronts.push_back(std::move(result));
}

} // namespace

void evaluate_fronts(const model::Model& model, const Discretisation& scene, const StepState& state,
                     results::LoadStepResult& out) {
  for (std::size_t f = 0; f < scene.cracked.fronts.size(); ++f) {
    gather_front(model, scene, f, state, out);
  }
}

} // namespace spricka::analysis
