// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/steps/missing_contact.hpp"

#include "contact/surface_boundary.hpp"
#include "mesh/boundary.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

constexpr double near_share = 0.05; // of the smaller body's extent: fits and clearances are less
constexpr double least_touch = 0.1; // of the smaller body's nodes

// The boundary of a body.
struct BodyBoundaryOutline {
  std::vector<model::Face> faces;
  geometry::BodyBoundary outline;
};

BodyBoundaryOutline rim_of(const model::Model& model, const model::Mesh& mesh,
                           const SubstructuredBody& body) {
  std::vector<bool> own(mesh.element_count(), false);
  for (const base::ElementId e : body.body.elements) {
    own[e.index()] = true;
  }
  std::vector<model::Face> faces;
  for (const model::Face& face : mesh::boundary_faces(mesh)) {
    if (own[face.element.index()]) {
      faces.push_back(face);
    }
  }
  geometry::BodyBoundary outline = contact::make_displaced_body_boundary(model, mesh, faces, {});
  return {std::move(faces), std::move(outline)};
}

// Faces of one body whose nodes lie next to another one.
std::vector<model::Face> near_faces(const model::Mesh& mesh, const BodyBoundaryOutline& rim,
                                    const geometry::BodyBoundary& other, double reach) {
  std::vector<model::Face> near;
  for (const model::Face& face : rim.faces) {
    const std::vector<base::NodeId> nodes = mesh::nodes_of_faces(mesh, {face});
    if (std::ranges::all_of(nodes, [&](base::NodeId n) {
          return other.signed_distance(mesh.x[n.index()], reach).has_value();
        })) {
      near.push_back(face);
    }
  }
  return near;
}

// The smallest named face set that holds most of these faces.
std::string set_of(const model::Mesh& mesh, const std::vector<model::Face>& faces) {
  std::string name;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const model::FaceSet& set : mesh.face_sets) {
    const auto there = std::ranges::count_if(faces, [&](const model::Face& f) {
      return std::ranges::find(set.faces, f) != set.faces.end();
    });
    if (!set.name.empty() && 2 * static_cast<std::size_t>(there) > faces.size() &&
        set.faces.size() < least) {
      name = set.name;
      least = set.faces.size();
    }
  }
  return name;
}

bool joined(const Discretisation& scene, const SubstructuredBody& a, const SubstructuredBody& b) {
  const auto of = [](const contact::ContactSurface& surface, const SubstructuredBody& body) {
    return !surface.facets.empty() &&
           std::ranges::binary_search(body.body.nodes, surface.facets.front().nodes.front());
  };
  return std::ranges::any_of(scene.pairs, [&](const contact::PairConstraints& pair) {
    return (of(pair.contact, a) && of(pair.target, b)) ||
           (of(pair.contact, b) && of(pair.target, a));
  });
}

} // namespace

std::string explain_unjoined_neighbour(const model::Model& model, const Discretisation& scene,
                                       const std::vector<SubstructuredBody>& bodies,
                                       std::size_t body) {
  const model::Mesh& mesh = scene.cracked.mesh;
  const BodyBoundaryOutline own = rim_of(model, mesh, bodies[body]);
  std::string found;
  std::size_t most = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (b == body || joined(scene, bodies[body], bodies[b])) {
      continue;
    }
    const BodyBoundaryOutline other = rim_of(model, mesh, bodies[b]);
    const double reach =
        near_share * std::min(own.outline.box().diagonal(), other.outline.box().diagonal());
    const std::vector<model::Face> mine = near_faces(mesh, own, other.outline, reach);
    const std::vector<model::Face> theirs = near_faces(mesh, other, own.outline, reach);
    const std::size_t count = std::min(mine.size(), theirs.size());
    const double least =
        least_touch * static_cast<double>(std::min(own.faces.size(), other.faces.size()));
    if (count > most && static_cast<double>(count) > least) {
      most = count;
      const std::string a = set_of(mesh, mine);
      const std::string c = set_of(mesh, theirs);
      found = fmt::format(
          ": no $CONTACT and no common node joins it with {}, which lies next to it{}",
          bodies[b].name, a.empty() || c.empty() ? "" : fmt::format(" ({} and {})", a, c));
    }
  }
  return found;
}

} // namespace spricka::analysis
