// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/joint_drawing.hpp"

#include "base/by_dimension.hpp"
#include "model/model.hpp"
#include "report/drawing/joint_picture.hpp"
#include "report/drawing/mesh_picture.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/front_places.hpp"
#include "results/shown_step.hpp"

namespace spricka::report {
namespace {

/// What is drawn: a crack length and the step that tells of its fronts.
struct DrawnState {
  const model::Model& model;
  const results::CrackLengthResult& increment;
  const results::LoadStepResult& step;
};

std::string draw_plane_joint(const DrawnState& state, const PictureLimits& limits) {
  const model::Mesh& mesh = state.increment.mesh;
  MeshView view = whole_mesh_view(state.model, mesh, limits);
  view.id = "joint";
  view.title = "The joint";
  view.marks = &state.model;
  view.inner_edges = false;
  for (const results::FrontResult& tip : state.step.fronts) {
    const base::Vec3& x = tip.single_point().x;
    view.labels.push_back({{x[0], x[1]}, tip.name});
  }
  for (const model::FaceSet& set : mesh.face_sets) {
    for (const model::CrackDefinition& crack : state.model.cracks) {
      if (set.name == crack.name + ".LEFT" || set.name == crack.name + ".RIGHT") {
        view.crack_faces.insert(view.crack_faces.end(), set.faces.begin(), set.faces.end());
      }
    }
  }
  return draw_svg(view);
}

std::string draw_solid_joint(const DrawnState& state, const PictureLimits& limits) {
  JointView view;
  view.increment = &state.increment;
  view.step = &state.step;
  view.marks = &state.model;
  view.id = "joint";
  view.title = "The joint";
  view.k_title = legend_title("K1", state.model.units.output_stress_intensity());
  view.width = limits.width;
  for (const results::FrontResult& front : state.step.fronts) {
    view.fronts.push_back(&front);
    view.labels.emplace_back(worst_point(front).x, front.name);
  }
  return draw_svg(view);
}

} // namespace

std::string draw_whole_joint(const model::Model& model, const results::RunResult& run, double width,
                             double height) {
  if (run.increments.empty() || run.increments.back().mesh.nodes.empty()) {
    return {};
  }
  const results::CrackLengthResult& increment = run.increments.back();
  const results::LoadStepResult* const step =
      results::shown_step_result(model, run.increments, increment);
  if (step == nullptr) {
    return {};
  }
  constexpr base::ByDimension draw{draw_plane_joint, draw_solid_joint};
  return draw.at(increment.mesh.dim)({model, increment, *step}, {width, height});
}

} // namespace spricka::report
