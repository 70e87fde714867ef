// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/by_dimension.hpp"
#include "model/model.hpp"
#include "model/property_points.hpp"
#include "report/drawing/mesh_picture.hpp"
#include "report/drawing/model_marks.hpp"
#include "report/drawing/picture_frame.hpp"
#include "report/drawing/round_off.hpp"
#include "report/drawing/solid_picture.hpp"
#include "report/topics/figures.hpp"
#include "results/shown_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace spricka::report {
namespace {

struct TipMeshPlace {
  base::NodeId node;
  base::NetId net;
  double element = 0.0; ///< largest extent of the elements that meet at the tip
};

TipMeshPlace find_tip_place(const model::Mesh& mesh, const base::Vec3& x) {
  TipMeshPlace place;
  place.node = nearest_node(mesh, x);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span<const base::NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    if (std::find(nodes.begin(), nodes.end(), place.node) == nodes.end()) {
      continue;
    }
    place.net = mesh.element_net[e];
    for (const base::NodeId n : nodes) {
      place.element = std::max(place.element, (mesh.x[n.index()] - x).norm());
    }
  }
  return place;
}

/// Shows displacements so that the largest is a round share, at most so much.
void magnify(MeshView& view, const results::LoadStepResult& step, double largest, double share) {
  if (largest > 0.0) {
    view.u = &step.u;
    view.magnify = displacement_magnification(largest, share);
  }
}

/// Shows the mesh as it is deformed, the tip held, so that the largest motion in the window takes
/// a twelfth of it.
void deform(MeshView& view, const results::LoadStepResult& step, base::NodeId tip) {
  const model::Mesh& mesh = *view.mesh;
  if (step.u.size() != static_cast<Eigen::Index>(2 * mesh.node_count())) {
    return;
  }
  view.rest = step.u.segment<2>(static_cast<Eigen::Index>(2 * tip.index()));
  double largest = 0.0;
  for (const base::NodeId n : mesh.nodes) {
    const base::Vec3& x = mesh.x[n.index()];
    const bool inside =
        x[0] > view.low.x && x[0] < view.high.x && x[1] > view.low.y && x[1] < view.high.y;
    if (inside && (!view.net.valid() || mesh.node_net[n.index()] == view.net)) {
      const base::Vec2 u = step.u.segment<2>(static_cast<Eigen::Index>(2 * n.index()));
      largest = std::max(largest, (u - view.rest).norm());
    }
  }
  magnify(view, step, largest, (view.high.x - view.low.x) / 12.0);
}

void set_window(MeshView& view, const base::Vec3& centre, double half) {
  view.low = {centre[0] - half, centre[1] - half};
  view.high = {centre[0] + half, centre[1] + half};
}

std::string tip_drawing(const model::Model& model, const results::CrackLengthResult& increment,
                        const results::LoadStepResult& step, const results::FrontResult& tip,
                        bool close) {
  const results::FrontPointResult& end = tip.single_point();
  const TipMeshPlace place = find_tip_place(increment.mesh, end.x);
  MeshView view;
  view.mesh = &increment.mesh;
  view.id = fmt::format("mesh-{}-{}-{}", tip.name, increment.number, close ? "tip" : "crack");
  view.net = place.net;
  view.length = model.units.output_length();
  view.title =
      fmt::format("{}{}, a = {}", tip.name, close ? ", the tip" : "", view.length.text(tip.a, 4));
  const base::Vec3 middle = end.x - 0.45 * tip.a * end.direction;
  set_window(view, close ? end.x : middle, close ? 5.0 * place.element : 0.85 * tip.a);
  deform(view, step, place.node);
  return draw_svg(view);
}

Figure whole_mesh(const model::Model& model, const results::RunResult& run) {
  const results::CrackLengthResult& increment = run.increments.back();
  const model::Mesh& mesh = increment.mesh;
  MeshView view = whole_mesh_view(model, mesh, {660.0, 480.0}); // room for arrows and hatches
  view.id = "mesh-whole";
  view.title = "Mesh";
  view.marks = &model;
  std::string cracks;
  if (const results::LoadStepResult* const step =
          results::shown_step_result(model, run.increments, increment)) {
    for (const results::FrontResult& tip : step->fronts) {
      if (const results::FrontPointResult& end = tip.single_point(); !end.direction.isZero()) {
        view.labels.push_back({{end.x[0], end.x[1]}, tip.name});
        cracks += fmt::format("{}{}: a = {}", cracks.empty() ? "; " : ", ", tip.name,
                              view.length.text(tip.a, 4));
      }
    }
  }
  return {{draw_svg(view)},
          model_marks_legend(model, 660.0),
          fmt::format("The mesh, {} elements, one tint for each part (net){}. Heavy lines are "
                      "edges of one element only: outlines and crack faces.{}",
                      mesh.element_count(), cracks,
                      model.rigids.empty() ? "" : " Hatched lines: rigid targets.")};
}

/// Elements beyond which a picture of a field is left to ParaView.
constexpr std::size_t most_coloured = 20000;

/// So that the largest displacement is a round share, at most a fifteenth, of the size.
void deform_all(MeshView& view, const results::LoadStepResult& step) {
  double largest = 0.0;
  for (Eigen::Index n = 0; n + 1 < step.u.size(); n += 2) {
    largest = std::max(largest, step.u.segment<2>(n).norm());
  }
  magnify(view, step, largest, std::max(view.high.x - view.low.x, view.high.y - view.low.y) / 15.0);
}

/// Values at the nodes of elements with their shares of the area: a crack tip would have all
/// colours for itself.
std::vector<std::pair<double, double>> values_by_area(const model::Mesh& mesh,
                                                      const std::vector<double>& field) {
  std::vector<std::pair<double, double>> values;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const std::span<const base::NodeId> nodes = mesh.element_nodes(base::ElementId(e));
    const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e]).corners);
    double area = 0.0;
    for (std::size_t i = 0; i < corners; ++i) {
      const base::Vec3& a = mesh.x[nodes[i].index()];
      const base::Vec3& b = mesh.x[nodes[(i + 1) % corners].index()];
      area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      values.emplace_back(field[static_cast<std::size_t>(mesh.first[e]) + i],
                          area / static_cast<double>(nodes.size()));
    }
  }
  return values;
}

constexpr double counted_area = 0.99;

/// What of a stress a picture shows.
struct StressPicture {
  const char* id;
  const char* title;
  const char* words; ///< in the legend
  double (*value)(const results::Stress&);
};
double largest_principal_stress(const results::Stress& stress) {
  return results::principal_stresses(stress).front();
}
constexpr std::array stress_pictures{
    StressPicture{"stress-whole", "Von Mises stress", "von Mises", results::von_mises},
    StressPicture{"principal-whole", "Largest principal stress", "largest principal",
                  largest_principal_stress}};

/// A stress, deformed.
std::string stress_drawing(const model::Model& model, const results::CrackLengthResult& increment,
                           const results::LoadStepResult& step, const StressPicture& picture) {
  MeshView view = whole_mesh_view(model, increment.mesh, {480.0, 480.0});
  view.id = picture.id;
  view.title = picture.title;
  const model::FieldPointsByProperty points = model::property_points(increment.mesh);
  for (const std::int32_t point : points.of) {
    view.field.push_back(picture.value(step.stress[static_cast<std::size_t>(point)]));
  }
  const auto [low, high] = std::ranges::minmax(view.field);
  const auto values = values_by_area(increment.mesh, view.field);
  const double top = value_above_share(values, counted_area);
  const double foot = low < 0.0 ? value_above_share(values, 1.0 - counted_area) : low;
  view.scale = make_colour_scale(foot, top > foot ? top : high);
  view.field_title = legend_title(picture.words, model.units.output_stress());
  deform_all(view, step);
  return draw_svg(view);
}

std::string displacement_drawing(const model::Model& model,
                                 const results::CrackLengthResult& increment,
                                 const results::LoadStepResult& step) {
  MeshView view = whole_mesh_view(model, increment.mesh, {480.0, 480.0});
  view.id = "displacement-whole";
  view.title = "Displacement";
  for (const base::NodeId n : increment.mesh.nodes) {
    view.field.push_back(step.u.segment<2>(static_cast<Eigen::Index>(2 * n.index())).norm());
  }
  view.scale = make_colour_scale(0.0, std::ranges::max(view.field));
  view.field_title = legend_title("|u|", model.units.output_length());
  deform_all(view, step);
  return draw_svg(view);
}

/// The shown step, or where its stresses are round-off that with the largest; null without
/// stresses.
const results::LoadStepResult* stressed(const model::Model& model, const results::RunResult& run,
                                        const results::CrackLengthResult& increment) {
  const results::LoadStepResult* best =
      results::shown_step_result(model, run.increments, increment);
  if (best == nullptr || has_significant_stress(model, increment, *best)) {
    return best == nullptr || best->stress.empty() ? nullptr : best;
  }
  for (const results::LoadStepResult& step : increment.steps) {
    best = largest_von_mises_stress(step) > largest_von_mises_stress(*best) ? &step : best;
  }
  return best->stress.empty() ? nullptr : best;
}

/// "step LOAD, a = 3.6 mm"
std::string place_words(const model::Model& model, const results::CrackLengthResult& increment,
                        const results::LoadStepResult& step) {
  return increment.a > 0.0 ? fmt::format("step {}, a = {}", step.step,
                                         model.units.output_length().text(increment.a, 4))
                           : fmt::format("step {}", step.step);
}

/// Stresses and displacements of the last length's shown step, where they were recovered.
std::optional<Figure> field_figure(const model::Model& model, const results::RunResult& run) {
  const results::CrackLengthResult& increment = run.increments.back();
  const results::LoadStepResult* const step = stressed(model, run, increment);
  const model::Mesh& mesh = increment.mesh;
  if (step == nullptr || mesh.element_count() > most_coloured ||
      step->u.size() != static_cast<Eigen::Index>(2 * mesh.node_count())) {
    return std::nullopt;
  }
  Figure figure;
  const std::string place = place_words(model, increment, *step);
  if (!has_significant_stress(model, increment, *step)) {
    figure.drawings.push_back(displacement_drawing(model, increment, *step));
    figure.caption =
        fmt::format("Displacement at the end of {}, deformed. The stresses are only round-off "
                    "there and are not drawn{}.",
                    place,
                    increment.steps.size() > 1
                        ? "; a card $OUTPUT FORMAT=VTU EVERY=STEP writes those of the other steps"
                        : "");
    return figure;
  }
  for (const StressPicture& picture : stress_pictures) {
    figure.drawings.push_back(stress_drawing(model, increment, *step, picture));
  }
  figure.drawings.push_back(displacement_drawing(model, increment, *step));
  base::OutputUnit stress = model.units.output_stress();
  stress.name = typeset_unit(stress.name);
  figure.caption = fmt::format(
      "Von Mises stress and largest principal stress, means of the elements that meet at a node, "
      "and "
      "displacement at the end of {}, deformed. The stress colours end at the value that 99 % of "
      "the area is below. The largest von Mises stress is {}; at a crack tip or a sharp "
      "corner it depends on the mesh.",
      place, stress.text(largest_von_mises_stress(*step), 4));
  return figure;
}

/// First and last length, then the last tip from near by.
std::optional<Figure> crack_figure(const model::Model& model, const results::RunResult& run,
                                   const std::string& name) {
  Figure figure;
  const results::CrackLengthResult* last = nullptr;
  const results::FrontResult* last_tip = nullptr;
  for (const results::CrackLengthResult* const increment : sample_increments(run, 2)) {
    const results::LoadStepResult* const step =
        results::shown_step_result(model, run.increments, *increment);
    const results::FrontResult* const tip =
        step == nullptr ? nullptr : results::find_front(*step, name);
    if (tip != nullptr && !tip->single_point().direction.isZero() && tip->a > 0.0) {
      figure.drawings.push_back(tip_drawing(model, *increment, *step, *tip, false));
      last = increment;
      last_tip = tip;
    }
  }
  if (last == nullptr) {
    return std::nullopt;
  }
  const results::LoadStepResult& last_step =
      *results::shown_step_result(model, run.increments, *last);
  figure.drawings.push_back(tip_drawing(model, *last, last_step, *last_tip, true));
  figure.caption = fmt::format("The mesh round crack {} at the end of step {}, deformed, the tip "
                               "held in its place; other bodies are left out.",
                               name, last_step.step);
  return figure;
}

/// The surface of the last length's shown step, or where to see it.
std::vector<Figure> solid_figures(const model::Model& model, const results::RunResult& run) {
  constexpr std::size_t most_faces_for_two = 8000;
  const results::CrackLengthResult& increment = run.increments.back();
  const results::LoadStepResult* const step = stressed(model, run, increment);
  if (step == nullptr || increment.surface.empty()) {
    return {};
  }
  if (increment.surface.size() > most_drawn_faces) {
    return {{{},
             "",
             fmt::format("The surface has {} faces, too many to draw here: open the .pvd file of "
                         "this folder in ParaView.",
                         increment.surface.size())}};
  }
  const bool significant = has_significant_stress(model, increment, *step);
  Figure figure;
  for (const StressPicture& picture : stress_pictures) {
    if (figure.drawings.empty() || (significant && increment.surface.size() < most_faces_for_two)) {
      figure.drawings.push_back(draw_svg(
          SolidView{.increment = &increment,
                    .step = step,
                    .value = picture.value,
                    .title = fmt::format("Surface, {}", picture.words),
                    .field_title = legend_title(picture.words, model.units.output_stress())}));
    }
  }
  figure.caption = fmt::format(
      "The outer surface at the end of {}, {} elements, deformed. Colours: von Mises stress{}, "
      "mean "
      "over the nodes of each face{}; they end at the value that 99 % of what is seen is below.",
      place_words(model, increment, *step), increment.mesh.element_count(),
      figure.drawings.size() > 1 ? " and largest principal stress" : "",
      significant ? "" : ": nothing but round-off");
  return {figure};
}

std::vector<Figure> plane_figures(const model::Model& model, const results::RunResult& run) {
  std::vector<Figure> figures;
  const results::CrackLengthResult& last = run.increments.back();
  if (last.mesh.nodes.empty()) {
    return figures;
  }
  figures.push_back(whole_mesh(model, run));
  add_figure(figures, field_figure(model, run));
  if (const results::LoadStepResult* const step =
          results::shown_step_result(model, run.increments, last)) {
    for (const results::FrontResult& tip : step->fronts) {
      add_figure(figures, crack_figure(model, run, tip.name));
    }
  }
  return figures;
}

} // namespace

std::vector<Figure> mesh_figures(const model::Model& model, const results::RunResult& run) {
  constexpr base::ByDimension figures{plane_figures, solid_figures};
  return run.increments.empty() ? std::vector<Figure>()
                                : figures.at(run.increments.back().mesh.dim)(model, run);
}

} // namespace spricka::report
