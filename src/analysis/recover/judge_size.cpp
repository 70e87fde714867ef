// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/judge_size.hpp"

#include "base/by_dimension.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// How the warnings go on and end.
constexpr std::array<std::string_view, 2> beginnings_of_judgement{" is strained by ",
                                                                  " is bent or turned by "};
constexpr std::string_view units_of_all = "; are moduli, loads and fits in the units meant?";
constexpr std::string_view units_of_loads = "; are moduli and loads in the units meant?";

/// How far a body reaches from its middle, and its displacements from their mean.
struct Reach {
  double size = 0.0;
  double motion = 0.0;
  double largest = 0.0; ///< displacement itself
};

Reach reach_of(const model::Mesh& mesh, const SubstructuredBody& body, const base::Vector& u) {
  const int dim = mesh.dim;
  base::Vec3 middle = base::Vec3::Zero();
  base::Vec3 mean = base::Vec3::Zero();
  const auto motion = [&](base::NodeId n) {
    base::Vec3 v = base::Vec3::Zero();
    v.head(dim) = u.segment(static_cast<Eigen::Index>(n.index()) * dim, dim);
    return v;
  };
  const double part = 1.0 / static_cast<double>(std::max<std::size_t>(body.body.nodes.size(), 1));
  for (const base::NodeId n : body.body.nodes) {
    middle += part * mesh.x[n.index()];
    mean += part * motion(n);
  }
  Reach reach;
  for (const base::NodeId n : body.body.nodes) {
    reach.size = std::max(reach.size, (mesh.x[n.index()] - middle).norm());
    // A shift of the whole body changes nothing: only what differs from the mean counts.
    reach.motion = std::max(reach.motion, (motion(n) - mean).norm());
    reach.largest = std::max(reach.largest, motion(n).norm());
  }
  return reach;
}

/// Tetrahedra between the corners of a solid element.
std::span<const std::array<std::size_t, 4>> tetrahedra(int corners) {
  static constexpr std::array<std::array<std::size_t, 4>, 1> tet{{{0, 1, 2, 3}}};
  static constexpr std::array<std::array<std::size_t, 4>, 3> wedge{
      {{0, 1, 2, 5}, {0, 1, 5, 4}, {0, 4, 5, 3}}};
  static constexpr std::array<std::array<std::size_t, 4>, 6> brick{
      {{0, 1, 2, 6}, {0, 2, 3, 6}, {0, 3, 7, 6}, {0, 7, 4, 6}, {0, 4, 5, 6}, {0, 5, 1, 6}}};
  switch (corners) {
  case 4:
    return tet;
  case 6:
    return wedge;
  default:
    return brick;
  }
}

double volume_of_solid(const model::Model& /*model*/, const model::Mesh& mesh, base::ElementId e) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  double volume = 0.0;
  for (const std::array<std::size_t, 4>& t :
       tetrahedra(base::element_info(mesh.type[e.index()]).corners)) {
    const base::Vec3& o = mesh.x[nodes[t[0]].index()];
    const auto edge = [&](std::size_t i) { return base::Vec3(mesh.x[nodes[t[i]].index()] - o); };
    volume += edge(1).cross(edge(2)).dot(edge(3)) / 6.0;
  }
  return volume;
}

/// Area times thickness, about an axis the whole ring.
double volume_of_plane(const model::Model& model, const model::Mesh& mesh, base::ElementId e) {
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  const auto corners = static_cast<std::size_t>(base::element_info(mesh.type[e.index()]).corners);
  double area = 0.0;
  double middle = 0.0;
  for (std::size_t i = 0; i < corners; ++i) {
    const base::Vec3& a = mesh.x[nodes[i].index()];
    const base::Vec3& b = mesh.x[nodes[(i + 1) % corners].index()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    middle += a.x() / static_cast<double>(corners);
  }
  return area * (model::is_axisymmetric(model) ? 2.0 * std::numbers::pi * middle
                                               : model.element_property(mesh, e).thickness);
}

/// What an element fills, its edges straight.
constexpr base::ByDimension<double (*)(const model::Model&, const model::Mesh&, base::ElementId)>
    volume_of{volume_of_plane, volume_of_solid};

/// The uniaxial strain that would hold a body's energy: no corner or crack tip counts by itself.
double mean_strain(const model::Model& model, const model::Mesh& mesh,
                   const SubstructuredBody& body, const std::vector<double>& energy) {
  double held = 0.0;
  double stiff = 0.0;
  for (const base::ElementId e : body.body.elements) {
    held += energy[e.index()];
    stiff += model.element_material(mesh, e).E * volume_of.at(mesh.dim)(model, mesh, e);
  }
  return stiff > 0.0 ? std::sqrt(std::max(0.0, 2.0 * held / stiff)) : 0.0;
}

/// The body that a warning of judge_size speaks of; empty: it is another note.
std::string_view body_judged(const results::Note& note) {
  for (const std::string_view words : beginnings_of_judgement) {
    const std::size_t at = note.text.find(words);
    if (results::is_warning(note) && at != std::string::npos) {
      return std::string_view(note.text).substr(0, at);
    }
  }
  return {};
}

/// What is off by so much, as a part of itself, is less exact or no answer.
results::Note by_size(double off, std::string text) {
  constexpr double most = 0.1;
  return off > most ? results::invalid_result_note(std::move(text))
                    : results::less_exact_note(std::move(text));
}

bool judges(const results::CrackLengthResult& increment, std::string_view step,
            std::string_view body) {
  const results::LoadStepResult* found = results::find_step(increment, step);
  return found == nullptr || std::ranges::any_of(found->notes, [&](const results::Note& note) {
           return body_judged(note) == body;
         });
}

} // namespace

void reword_notes_of_broken_ligaments(results::RunResult& run) {
  for (std::size_t i = 1; i < run.increments.size(); ++i) {
    for (results::LoadStepResult& step : run.increments[i].steps) {
      for (results::Note& note : step.notes) {
        const std::string_view body = body_judged(note);
        if (body.empty() || judges(run.increments.front(), step.step, body)) {
          continue;
        }
        for (const std::string_view units : {units_of_all, units_of_loads}) {
          if (note.text.ends_with(units)) {
            note.text.replace(
                note.text.size() - units.size(), units.size(),
                "; at the first length it was within that: the crack takes its ligament");
            break;
          }
        }
      }
    }
  }
}

void warn_of_large_deformation(const model::Model& model, const Discretisation& scene,
                               const std::vector<SubstructuredBody>& bodies, const StepState& state,
                               results::LoadStepResult& out) {
  constexpr double small_strain = 0.01;
  constexpr double small_turn = 0.1; // what it changes is of second order
  const model::Mesh& mesh = scene.cracked.mesh;
  for (const SubstructuredBody& body : bodies) {
    const double strain = mean_strain(model, mesh, body, state.energy);
    const Reach reach = reach_of(mesh, body, out.u);
    const double turn = reach.size > 0.0 ? reach.motion / reach.size : 0.0;
    if (strain > small_strain) {
      out.notes.push_back(
          by_size(strain, fmt::format("{} is strained by {:.3g} % on the whole: linear theory is "
                                      "off by about as much{}",
                                      body.name, 100.0 * strain, units_of_all)));
    } else if (turn > small_turn) {
      out.notes.push_back(by_size(
          turn * turn, fmt::format("{} is bent or turned by {:.3g} % of its size (largest "
                                   "displacement {:.3g}): linear theory is off by about {:.2g} %{}",
                                   body.name, 100.0 * turn, reach.largest, 100.0 * turn * turn,
                                   units_of_loads)));
    }
  }
}

} // namespace spricka::analysis
