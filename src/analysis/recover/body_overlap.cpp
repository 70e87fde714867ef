// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/body_overlap.hpp"

#include "base/tidy.hpp"
#include "contact/surface_boundary.hpp"
#include "mesh/boundary.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using base::Vec3;

// Of the largest displacement: bodies that run into each other by less tell nothing wrong.
constexpr double least_overlap = 0.02;
constexpr double round_off = 1e-9; // of the bodies' extent

// The boundary of one body, as drawn and as it has moved.
struct DeformedBodyBoundary {
  std::vector<model::Face> faces;
  std::vector<base::NodeId> nodes;
  geometry::BodyBoundary moved;
  std::optional<geometry::BodyBoundary> drawn; ///< once it is asked for: most bodies never meet
  double displacement = 0.0;                   ///< largest of the nodes
};

class Overlaps {
public:
  Overlaps(const model::Model& model, const Discretisation& scene,
           const std::vector<SubstructuredBody>& bodies, const StepState& state)
      : model_(model), scene_(scene), bodies_(bodies), state_(state), mesh_(scene.cracked.mesh) {
    std::vector<int> body(mesh_.element_count(), -1);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      for (const base::ElementId e : bodies[b].body.elements) {
        body[e.index()] = static_cast<int>(b);
      }
    }
    std::vector<std::vector<model::Face>> faces(bodies.size());
    for (const model::Face& face : mesh::boundary_faces(mesh_)) {
      const int b = body[face.element.index()];
      if (b >= 0) {
        faces[static_cast<std::size_t>(b)].push_back(face);
      }
    }
    for (const std::vector<model::Face>& own : faces) {
      DeformedBodyBoundary rim{own, mesh::nodes_of_faces(mesh_, own),
                               contact::make_displaced_body_boundary(model, mesh_, own, state.u),
                               std::nullopt, 0.0};
      for (const base::NodeId n : rim.nodes) {
        rim.displacement = std::max(rim.displacement, shift(n).norm());
      }
      rims_.push_back(std::move(rim));
    }
    mark_held();
  }

  void tell(results::LoadStepResult& out) const {
    for (std::size_t a = 0; a < rims_.size(); ++a) {
      for (std::size_t b = a + 1; b < rims_.size(); ++b) {
        tell_pair(a, b, out);
      }
    }
  }

private:
  struct Worst {
    double depth = 0.0;
    base::NodeId node;
    bool drawn = false; ///< the bodies lie upon each other as drawn
  };

  [[nodiscard]] Vec3 shift(base::NodeId n) const {
    Vec3 u = Vec3::Zero();
    u.head(mesh_.dim) =
        state_.u.segment(static_cast<Eigen::Index>(n.index()) * mesh_.dim, mesh_.dim);
    return u;
  }
  const geometry::BodyBoundary& drawn(std::size_t b) const {
    DeformedBodyBoundary& rim = rims_[b];
    if (!rim.drawn) {
      rim.drawn = contact::make_displaced_body_boundary(model_, mesh_, rim.faces, base::Vector());
    }
    return *rim.drawn;
  }
  [[nodiscard]] const Vec3& place(base::NodeId n) const { return mesh_.x[n.index()]; }

  // Nodes that contacts or ties look after, whatever they let them do.
  void mark_held() {
    held_.assign(mesh_.node_count(), false);
    for (const contact::PairConstraints& pair : scene_.pairs) {
      for (const contact::ConstraintRow& row : pair.normal) {
        for (const contact::RowEntry& entry : row.entries) {
          held_[entry.node.index()] = true;
        }
      }
    }
    const auto dim = static_cast<std::size_t>(mesh_.dim);
    for (const fe::ConstraintTransformation::DependentRow& row : scene_.ties->rows()) {
      held_[static_cast<std::size_t>(row.freedom) / dim] = true;
      for (const fe::FreedomTerm& term : row.terms) {
        held_[static_cast<std::size_t>(term.freedom) / dim] = true;
      }
    }
  }

  // The node of body a that is deepest in body b.
  [[nodiscard]] Worst deepest(std::size_t a, std::size_t b) const {
    const DeformedBodyBoundary& other = rims_[b];
    const double moved = std::max(rims_[a].displacement, other.displacement);
    const double extent = std::max(rims_[a].moved.box().diagonal(), other.moved.box().diagonal());
    // No node gets deeper into the other body than both have moved.
    const double reach = 2.0 * moved + 1e-6 * extent;
    const double least = std::max(least_overlap * moved, round_off * extent);
    Worst worst;
    for (const base::NodeId n : rims_[a].nodes) {
      const Vec3 now = place(n) + shift(n);
      if (held_[n.index()] || !other.moved.box().contains(now)) {
        continue;
      }
      const std::optional<geometry::BoundaryDistance> there =
          other.moved.signed_distance(now, reach);
      if (!there || there->distance > -least) {
        continue;
      }
      const std::optional<geometry::BoundaryDistance> before =
          drawn(b).signed_distance(place(n), 3.0 * reach);
      const double first = before ? before->distance : 0.0;
      worst.drawn = worst.drawn || first < -(there->facet + 1e-6 * extent);
      // What lay inside as drawn, and what facets leave of a curve, is not of this step.
      const double depth = -there->distance - there->facet - std::max(0.0, -first);
      if (depth > std::max(least, worst.depth)) {
        worst.depth = depth;
        worst.node = n;
      }
    }
    return worst;
  }

  // Whether the body at this node of its boundary lies inside the other as drawn.
  [[nodiscard]] bool lies_upon(base::NodeId node, std::size_t a, std::size_t b) const {
    for (const base::ElementId e : bodies_[a].body.elements) {
      const std::span<const base::NodeId> nodes = mesh_.element_nodes(e);
      if (std::ranges::find(nodes, node) == nodes.end()) {
        continue;
      }
      Vec3 centre = Vec3::Zero();
      for (const base::NodeId n : nodes) {
        centre += place(n) / static_cast<double>(nodes.size());
      }
      const std::optional<geometry::BoundaryDistance> at =
          drawn(b).signed_distance(centre, drawn(b).box().diagonal());
      return at && at->distance < 0.0;
    }
    return false;
  }

  // The contact that stands between two bodies, if any.
  [[nodiscard]] std::optional<std::string> between(std::size_t a, std::size_t b) const {
    const auto touches = [&](const contact::ContactSurface& surface, std::size_t body) {
      return !surface.facets.empty() &&
             std::ranges::binary_search(bodies_[body].body.nodes,
                                        surface.facets.front().nodes.front());
    };
    for (std::size_t c = 0; c < scene_.pairs.size(); ++c) {
      const contact::PairConstraints& pair = scene_.pairs[c];
      if ((touches(pair.contact, a) && touches(pair.target, b)) ||
          (touches(pair.contact, b) && touches(pair.target, a))) {
        return scene_.contacts[c].name;
      }
    }
    return std::nullopt;
  }

  void tell_pair(std::size_t a, std::size_t b, results::LoadStepResult& out) const {
    if (!rims_[a].moved.box().meets(rims_[b].moved.box())) {
      return;
    }
    const Worst in_b = deepest(a, b);
    const Worst in_a = deepest(b, a);
    const bool first = in_b.depth >= in_a.depth;
    const Worst& worst = first ? in_b : in_a;
    // An overlap as drawn is a matter of the deck, not of this step.
    if (worst.depth <= 0.0 || in_a.drawn || in_b.drawn ||
        lies_upon(worst.node, first ? a : b, first ? b : a)) {
      return;
    }
    const std::optional<std::string> contact = between(a, b);
    out.notes.push_back(results::invalid_result_note(fmt::format(
        "bodies {} and {} run into each other by {:.3g} at {}: {}; forces and K are those of "
        "bodies "
        "that pass through each other",
        bodies_[a].name, bodies_[b].name, worst.depth,
        base::format_coordinates(place(worst.node), mesh_.dim),
        contact ? fmt::format("contact {} sees nothing there (surfaces farther apart than a fifth "
                              "of their extent, or not in its sets)",
                              *contact)
                : "no $CONTACT stands between them")));
  }

  const model::Model& model_;
  const Discretisation& scene_;
  const std::vector<SubstructuredBody>& bodies_;
  const StepState& state_;
  const model::Mesh& mesh_;
  mutable std::vector<DeformedBodyBoundary> rims_;
  std::vector<bool> held_; ///< [node]
};

} // namespace

void warn_of_body_overlaps(const model::Model& model, const Discretisation& scene,
                           const std::vector<SubstructuredBody>& bodies, const StepState& state,
                           results::LoadStepResult& out) {
  if (bodies.size() > 1) {
    Overlaps(model, scene, bodies, state).tell(out);
  }
}

} // namespace spricka::analysis
