// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/pairing.hpp"

#include "base/by_dimension.hpp"
#include "base/parallel.hpp"
#include "contact/make_rows.hpp"
#include "contact/node_pairing.hpp"
#include "contact/pair_points.hpp"
#include "contact/singular_edges.hpp"
#include "contact/space/rigid_round.hpp"
#include "contact/space/surface_projection.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::contact {

namespace {

// Whether two chains of the surface end in one place of one net: a crack opens there. Where nets
// meet a tie may join the ends, and two rows would ask the same of one displacement.
bool has_mouth(const model::Mesh& mesh, const ContactSurface& surface) {
  struct End {
    Vec2 x;
    base::NetId net;
  };
  std::vector<End> ends;
  for (const EdgeChain& chain : surface.plane.chains) {
    if (!chain.closed) {
      const Edge& first = surface.plane.edges_of_chain(chain).front();
      const Edge& last = surface.plane.edges_of_chain(chain).back();
      ends.push_back({first.x[0], mesh.node_net[first.nodes[0].index()]});
      ends.push_back({last.x[1], mesh.node_net[last.nodes[1].index()]});
    }
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t k = i + 1; k < ends.size(); ++k) {
      if (ends[i].net == ends[k].net && (ends[i].x - ends[k].x).norm() < 1e-9 * surface.extent) {
        return true;
      }
    }
  }
  return false;
}

// Sizes alike: within a factor 1.5. There the softer side carries the multipliers, because a finer
// and stiffer one makes the compliance of the rows lose rank; else the coarser side does.
constexpr double alike = 1.5;
// In space, where each function is met by more of the other side's, less difference tells.
constexpr double alike_in_space = 1.3;

struct MultiplierSideChoice {
  bool swap = false;
  std::string why;
};

// Of sides alike in size.
MultiplierSideChoice softer_side(const ContactSurface& slave, const ContactSurface& master) {
  if (slave.stiffness > master.stiffness) {
    return {true, "master side: softer, sizes alike"};
  }
  return {false, slave.stiffness < master.stiffness ? "slave side: softer, sizes alike"
                                                    : "slave side: alike in size and stiffness"};
}

// What of a surface in space lies opposite the other: the faces some triangle of which has its
// middle there.
struct MetFaces {
  std::size_t faces = 0;
  double area = 0.0;
  [[nodiscard]] double size() const { return std::sqrt(area / static_cast<double>(faces)); }
};

MetFaces met_faces(const FacetSurface& surface, const FacetSurface& target) {
  const SurfaceProjector projection(surface, target);
  const auto is_met = [&](const HatElement& t) {
    const geometry::ElementSide& face = surface.facets[t.facet];
    const Vec2 middle =
        (face.node_local_coordinates(t.node[0]) + face.node_local_coordinates(t.node[1]) +
         face.node_local_coordinates(t.node[2])) /
        3.0;
    const geometry::SidePoint at = face.point(middle);
    return projection.project_along_normal(at.x, surface_normal(surface, t.facet, at)).has_value();
  };
  std::vector<std::vector<const HatElement*>> triangles(surface.facets.size());
  for (const HatElement& t : surface.elements) {
    triangles[t.facet].push_back(&t);
  }
  std::vector<char> seen(surface.facets.size(), 0); // of one byte each, for threads
  base::for_each_element(seen.size(), [&](std::size_t f) {
    seen[f] = std::ranges::any_of(triangles[f], [&](const HatElement* t) { return is_met(*t); });
  });
  MetFaces found;
  for (std::size_t f = 0; f < seen.size(); ++f) {
    found.faces += seen[f] != 0 ? 1 : 0;
    found.area += seen[f] != 0 ? surface.facets[f].area() : 0.0;
  }
  return found;
}

// In space sizes are those of the faces that meet. A part smaller than a few faces of the coarser
// side would have few functions there: the finer side has them then.
MultiplierSideChoice choose_space_side(const model::Mesh& /*mesh*/, const ContactSurface& slave,
                                       const ContactSurface& master) {
  constexpr double few = 9.0; // faces, three each way
  const MetFaces own = met_faces(slave, master);
  const MetFaces other = met_faces(master, slave);
  if (own.faces == 0 || other.faces == 0) { // the other lies within one face
    return own.faces >= other.faces
               ? MultiplierSideChoice{false, "slave side: it lies within one face"}
               : MultiplierSideChoice{true, "master side: it lies within one face"};
  }
  const double ratio = own.size() / other.size();
  const double met = std::min(own.area, other.area);
  const double coarse = std::pow(std::max(own.size(), other.size()), 2);
  if ((ratio > alike_in_space || ratio < 1.0 / alike_in_space) && met < few * coarse) {
    return ratio < 1.0
               ? MultiplierSideChoice{false, "slave side: few faces of the coarser one are met"}
               : MultiplierSideChoice{true, "master side: few faces of the coarser one are met"};
  }
  if (ratio > alike_in_space) {
    return {false, "slave side: coarser where they meet"};
  }
  if (ratio < 1.0 / alike_in_space) {
    return {true, "master side: coarser where they meet"};
  }
  return softer_side(slave, master);
}

// The crack faces of a mouth are pressed each for itself: functions of the other side, which go
// across the mouth, know one pressure for both (K2 of short cracks then is off by some per cent of
// K1). Pressures of the stiffer side would go up and down where a coarse soft one can't follow its
// small elements.
MultiplierSideChoice choose_plane_side(const model::Mesh& mesh, const ContactSurface& slave,
                                       const ContactSurface& master) {
  const bool mouth = has_mouth(mesh, master);
  const double stiffer =
      mouth ? master.stiffness / slave.stiffness : slave.stiffness / master.stiffness;
  if (mouth != has_mouth(mesh, slave) && stiffer < alike) {
    return {mouth,
            mouth ? "master side: a crack opens into it" : "slave side: a crack opens into it"};
  }
  const double ratio = slave.mean_size / master.mean_size;
  if (ratio > alike) {
    return {false, "slave side: coarser"};
  }
  if (ratio < 1.0 / alike) {
    return {true, "master side: coarser"};
  }
  return softer_side(slave, master);
}

MultiplierSideChoice choose_node_side(const model::Mesh& mesh, const ContactSurface& slave,
                                      const ContactSurface& master) {
  // both crack faces of a mouth need their row
  return has_mouth(mesh, master) && !has_mouth(mesh, slave)
             ? MultiplierSideChoice{true, "master side: node pairs, a crack opens into it"}
             : MultiplierSideChoice{false, "slave side: node pairs"};
}

bool has_tangents(const model::Contact& contact) {
  return contact.type == model::ContactType::bonded || contact.mu > 0.0;
}

void add_rows(PairConstraints& pair, const model::Contact& contact) {
  if (contact.pairing == model::PairingMethod::node) {
    fill_node_pair_rows(pair, contact.gap, has_tangents(contact));
  } else {
    if (contact.multiplier == model::MultiplierNodes::corners) {
      pair.contact.elements = corner_triangles(pair.contact);
    }
    fill_mortar_rows(pair, make_target_projector(pair),
                     {.declared_gap = contact.gap, .tangents = has_tangents(contact)});
  }
  if (pair.found) {
    pair.sharp_ends = find_singular_edges(pair);
  }
}

// [facet] whether one of its nodes has moved.
std::vector<bool> moved_facets(const ContactSurface& surface, const std::vector<bool>& moved) {
  std::vector<bool> facets;
  for (const geometry::ElementSide& facet : surface.facets) {
    facets.push_back(std::ranges::any_of(
        facet.nodes, [&](base::NodeId node) -> bool { return moved[node.index()]; }));
  }
  return facets;
}

// The same faces where the nodes of a mesh are.
void take_places(const model::Mesh& mesh, ContactSurface& surface) {
  for (geometry::ElementSide& facet : surface.facets) {
    for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
      facet.X.col(static_cast<Eigen::Index>(i)) = mesh.x[facet.nodes[i].index()];
    }
  }
}

// [element] of the contact surface: whether it or what it has opposite has changed.
std::vector<bool> changed_elements(const PairConstraints& pair, const std::vector<bool>& moved) {
  const std::vector<bool> own = moved_facets(pair.contact, moved);
  const std::vector<bool> other = moved_facets(pair.target, moved);
  const SurfaceProjector projection(pair.contact, pair.target);
  std::vector<bool> changed;
  for (std::size_t e = 0; e < pair.contact.elements.size(); ++e) {
    const HatElement& element = pair.contact.elements[e];
    changed.push_back(own[element.facet] ||
                      std::ranges::any_of((*pair.opposite)[e],
                                          [&](const PairQuadraturePoint& point) -> bool {
                                            return !other.empty() && other[point.target];
                                          }) ||
                      projection.faces_any_of(element, other));
  }
  return changed;
}

} // namespace

PairConstraints build_moved_pair_constraints(const model::Model& model, const model::Mesh& mesh,
                                             const model::Contact& contact,
                                             const PairConstraints& pair,
                                             const std::vector<bool>& moved) {
  // In the plane segments would begin and end elsewhere.
  if (!pair.segments || !pair.contact.plane.edges.empty()) {
    return build_pair_constraints(model, mesh, contact);
  }
  PairConstraints renewed = pair;
  take_places(mesh, renewed.contact);
  take_places(mesh, renewed.target);
  return renew_mortar_rows(renewed, make_target_projector(renewed),
                           {.declared_gap = contact.gap, .tangents = has_tangents(contact)},
                           changed_elements(renewed, moved))
             ? renewed
             : build_pair_constraints(model, mesh, contact);
}

PairConstraints build_pair_constraints(const model::Model& model, const model::Mesh& mesh,
                                       const model::Contact& contact) {
  PairConstraints pair;
  const bool nodes = contact.pairing == model::PairingMethod::node;
  ContactSurface slave = make_contact_surface(model, mesh, contact.slave);
  if (contact.rigid.valid()) {
    pair.contact = std::move(slave);
    pair.target.thickness = pair.contact.thickness;
    pair.rigid = model.rigids[contact.rigid.index()];
    pair.rigid_shape = rigid_target_shape(*pair.rigid);
    pair.choice = "slave side: the master is rigid";
    add_rows(pair, contact);
    return pair;
  }
  ContactSurface master = make_contact_surface(model, mesh, contact.master);
  if (slave.facets.empty() || master.facets.empty()) {
    pair.trouble = "a surface has no edges";
    return pair;
  }
  constexpr base::ByDimension choose_side{choose_plane_side, choose_space_side};
  const auto choose = nodes ? choose_node_side : choose_side.at(slave.dim);
  const MultiplierSideChoice choice = choose(mesh, slave, master);
  pair.swapped = choice.swap;
  pair.choice = choice.why;
  if (choice.swap) {
    std::swap(slave, master);
  }
  pair.contact = std::move(slave);
  pair.target = std::move(master);
  add_rows(pair, contact);
  return pair;
}

std::vector<base::NodeId> pair_surface_nodes(const model::Mesh& mesh,
                                             const model::Contact& contact) {
  std::vector<model::Face> faces = mesh.set_with_id(contact.slave).faces;
  if (contact.master.valid()) {
    const std::vector<model::Face>& other = mesh.set_with_id(contact.master).faces;
    faces.insert(faces.end(), other.begin(), other.end());
  }
  return mesh::nodes_of_faces(mesh, faces);
}

} // namespace spricka::contact
