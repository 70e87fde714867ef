// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/contact_limits.hpp"

#include "analysis/recover/closing_motion.hpp"
#include "contact/slide.hpp"
#include "contact/surface_boundary.hpp"
#include "mesh/boundary.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double most_unsupported = 0.01; // of the force
constexpr double most_slide = 0.01;       // of the pressed length
constexpr double most_misfit = 0.25;      // of what the pressure moves the surfaces by
constexpr double no_strain = 1e-12;       // pressure over modulus: nothing but round-off
constexpr double worth_a_word = 5e-3; // of the largest contact force: what meshes leave K off by
constexpr double most_off = 0.1;      // of the same: more is no answer

// How far pressure moves the surfaces: p L / E of both.
double elastic_way(const contact::PairConstraints& pair, double pressure, double pressed) {
  const auto soft = [](const contact::ContactSurface& s) {
    return s.stiffness > 0.0 ? 1.0 / s.stiffness : 0.0;
  };
  return pressure * pressed * (soft(pair.contact) + soft(pair.target));
}

double largest_pressure(const contact::PairConstraints& pair, const base::Vector& lambda) {
  const auto normals = static_cast<Eigen::Index>(pair.normal.size());
  return normals > 0 ? lambda.head(normals).maxCoeff() : 0.0;
}

// What straight edges on circles leave of the circle; nothing worth telling on curved ones.
double facets(const contact::PairConstraints& pair, double facet) {
  const contact::ContactSurface& surface = pair.contact;
  const std::optional<contact::AnalyticShape>& round = surface.rounds.front();
  const bool curved = surface.circle || (round && round->kind != contact::AnalyticShapeKind::plane);
  const double radius = surface.circle ? surface.circle->radius : round ? round->radius : 0.0;
  return curved && !surface.facets.front().is_quadratic() ? facet * facet / (4.0 * radius) : 0.0;
}

/// What contact of the bodies as drawn leaves out of one pair, as it has moved.
struct PairMotionError {
  std::size_t pair = 0; ///< in scene.pairs
  std::string contact;
  contact::SlideMeasures slide;
  bool far = false;    ///< by more than an element
  double turned = 0.0; ///< gap that no row counts, in elastic ways of its pressure; 0: little

  [[nodiscard]] bool matters() const {
    return slide.unsupported_part > most_unsupported || far || turned > 0.0;
  }

  // As a part of its force: what slides off an edge has nothing to act on, what slides far acts
  // that far off, and a gap that no row counts is pressed shut, or opens, by its share of the
  // pressure.
  [[nodiscard]] double off() const {
    const double way = slide.pressed > 0.0 ? std::min(1.0, slide.way / slide.pressed) : 1.0;
    return std::max({slide.unsupported_part > most_unsupported ? slide.unsupported_part : 0.0,
                     far ? way : 0.0, turned});
  }
};

// Gap that no row counts, in elastic ways of the largest pressure; 0: little.
double turned_by(const contact::PairConstraints& pair, double pressure,
                 const contact::SlideMeasures& slide) {
  const double turned =
      (slide.misfit - facets(pair, slide.facet)) / elastic_way(pair, pressure, slide.pressed);
  return turned > most_misfit ? turned : 0.0;
}

// The body of a pair's contact side where displacements have taken it.
std::optional<geometry::BodyBoundary> moved_body(const model::Model& model,
                                                 const Discretisation& scene,
                                                 const std::vector<SubstructuredBody>& bodies,
                                                 const StepState& state,
                                                 const contact::PairConstraints& pair) {
  const base::NodeId node = pair.contact.facets.front().nodes.front();
  const auto body = std::ranges::find_if(bodies, [&](const SubstructuredBody& one) {
    return std::ranges::binary_search(one.body.nodes, node);
  });
  if (body == bodies.end()) {
    return std::nullopt;
  }
  const std::set<base::ElementId> own(body->body.elements.begin(), body->body.elements.end());
  std::vector<model::Face> faces = mesh::boundary_faces(scene.cracked.mesh);
  std::erase_if(faces, [&](const model::Face& face) { return !own.contains(face.element); });
  return contact::make_displaced_body_boundary(model, scene.cracked.mesh, faces, state.u);
}

// The part of the thrust that acts on places of the target which the contact side's body has left.
// Where a body slides along one that goes on beyond the sets, or out of one end and into the other,
// the surfaces that press are the same as before: nothing is lost from the other side.
double left_alone(const geometry::BodyBoundary& body, const contact::SlideMeasures& slide) {
  constexpr double beside = 0.02; // of the slide: how near a body is opposite
  double left = 0.0;
  double all = 0.0;
  for (const contact::DisplacedContactPoint& place : slide.places) {
    const double near = std::abs(place.gap) + slide.misfit + beside * slide.way;
    const std::optional<geometry::BoundaryDistance> at = body.signed_distance(place.x, 2.0 * near);
    all += place.thrust;
    left += at && std::abs(at->distance) <= near + at->facet ? 0.0 : place.thrust;
  }
  return all > 0.0 ? left / all : slide.unsupported_part;
}

std::optional<PairMotionError> look_at(const model::Model& model, const Discretisation& scene,
                                       const std::vector<SubstructuredBody>& bodies,
                                       const StepState& state, std::size_t c) {
  const contact::PairConstraints& pair = scene.pairs[c];
  const bool bonded = scene.contacts[c].type == model::ContactType::bonded;
  if (!state.mounted[c] || bonded || pair.faces || !pair.found || pair.contact.facets.empty()) {
    return std::nullopt;
  }
  const double pressure = largest_pressure(pair, state.pair_lambda[c]);
  if (!(pressure > no_strain * pair.contact.stiffness)) {
    return std::nullopt;
  }
  PairMotionError found{.pair = c,
                        .contact = scene.contacts[c].name,
                        .slide = contact::measure_slide(pair, state.pair_lambda[c], state.u)};
  contact::SlideMeasures& slide = found.slide;
  if (slide.unsupported_part > most_unsupported && !pair.rigid && !pair.rigid_shape) {
    if (const auto body = moved_body(model, scene, bodies, state, pair)) {
      slide.unsupported_part = std::min(slide.unsupported_part, left_alone(*body, slide));
    }
  }
  found.far = slide.way > slide.facet && slide.way > most_slide * slide.pressed;
  found.turned = turned_by(pair, pressure, slide);
  return found;
}

// Takes out of the gaps that no row counts what rigid motions of bodies that only contact holds
// close: a pin that keeps its direction in a lug that bends moves across it at no cost.
void close_by_rigid_motions(const Discretisation& scene,
                            const std::vector<SubstructuredBody>& bodies, const StepState& state,
                            std::vector<PairMotionError>& all) {
  const std::vector<const base::Matrix*> motions = unresisted_rigid_motions(scene, bodies);
  std::vector<contact::DisplacedContactPoint> points;
  std::vector<std::size_t> pair_of_point;
  double largest_slide = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const PairMotionError& one = all[i];
    largest_slide = std::max(largest_slide, one.slide.way);
    for (contact::DisplacedContactPoint& point :
         contact::measure_slide(scene.pairs[one.pair], state.pair_lambda[one.pair], state.u,
                                motions)
             .places) {
      points.push_back(std::move(point));
      pair_of_point.push_back(i);
    }
  }
  const base::Vector closing = fit_gap_closing_motion(points, largest_slide);
  std::vector<double> left(all.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].unseen) {
      const double gap =
          *points[k].unseen + points[k].normal.dot(points[k].relative_motions * closing);
      left[pair_of_point[k]] = std::max(left[pair_of_point[k]], std::abs(gap));
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const contact::PairConstraints& pair = scene.pairs[all[i].pair];
    all[i].slide.misfit = std::min(all[i].slide.misfit, left[i]);
    all[i].turned =
        turned_by(pair, largest_pressure(pair, state.pair_lambda[all[i].pair]), all[i].slide);
  }
}

std::string what_moves(const PairMotionError& one) {
  const contact::SlideMeasures& slide = one.slide;
  std::string text = fmt::format(
      "contact {}: the bodies slide by {:.3g} ({:.2g} element lengths) along {:.3g} "
      "that is pressed",
      one.contact, slide.way, slide.facet > 0.0 ? slide.way / slide.facet : 0.0, slide.pressed);
  if (slide.unsupported_part > most_unsupported) {
    text += fmt::format(", and {:.0f} % of the force acts where nothing stands opposite any more",
                        100.0 * slide.unsupported_part);
  }
  if (one.turned > 0.0) {
    text += fmt::format(", and their gap changes by {:.2g} that small displacements do not see",
                        slide.misfit);
  }
  return text + "; contact pairs bodies as drawn";
}

// `part` is that of the step's largest contact force which is out of place.
results::Note judged(const PairMotionError& one, double part) {
  const std::string text = what_moves(one);
  if (part > most_off) {
    return results::invalid_result_note(
        text + ": forces, pressures and K of this state answer nothing; draw "
               "the bodies where they end up");
  }
  if (part > worth_a_word) {
    return results::less_exact_note(
        fmt::format("{}: forces and K are off by about {:.1g} %, its pressures by more; draw the "
                    "bodies where they end up to be rid of it",
                    text, 100.0 * part));
  }
  return results::make_note(
      fmt::format("{}: that is less than {:.1g} % of the contact forces of the "
                  "step; pressures at the edges of this contact are off by more",
                  text, 100.0 * worth_a_word));
}

} // namespace

void warn_of_large_slip(const model::Model& model, const Discretisation& scene,
                        const std::vector<SubstructuredBody>& bodies, const StepState& state,
                        results::LoadStepResult& out) {
  std::vector<PairMotionError> all;
  double largest = 0.0;
  for (std::size_t c = 0; c < scene.pairs.size(); ++c) {
    if (std::optional<PairMotionError> one = look_at(model, scene, bodies, state, c)) {
      largest = std::max(largest, one->slide.thrust);
      all.push_back(*std::move(one));
    }
  }
  if (std::ranges::any_of(all, [](const PairMotionError& one) { return one.turned > 0.0; })) {
    close_by_rigid_motions(scene, bodies, state, all);
  }
  for (const PairMotionError& one : all) {
    if (one.matters()) {
      out.notes.push_back(judged(one, one.off() * one.slide.thrust / largest));
    }
  }
}

} // namespace spricka::analysis
