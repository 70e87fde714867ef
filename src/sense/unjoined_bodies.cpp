// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/unjoined_bodies.hpp"

#include "base/by_dimension.hpp"
#include "contact/surface_boundary.hpp"
#include "fe/dof_map.hpp"
#include "mesh/boundary.hpp"
#include "mesh/cut/coincidence.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

constexpr double same_place = 1e-4; // of a side
constexpr double least_part = 0.04; // of the smaller body's boundary: a point touch is none
constexpr double beside = 0.1;      // of a side: there one body ends and the other begins

class Unjoined {
public:
  Unjoined(const model::Model& model, base::Diagnostics& list)
      : model_(model), mesh_(model.mesh), list_(list), bodies_(fe::find_bodies(model.mesh)),
        of_element_(model.mesh.element_count(), 0), of_node_(model.mesh.node_count(), nobody),
        cared_for_(model.mesh.node_count(), false), cls_(fe::classify_freedoms(model, model.mesh)) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      for (const base::ElementId e : bodies_[b].elements) {
        of_element_[e.index()] = b;
      }
      for (const base::NodeId n : bodies_[b].nodes) {
        of_node_[n.index()] = b;
      }
    }
  }

  void look() {
    if (bodies_.size() < 2) {
      return;
    }
    see_joints();
    constexpr base::ByDimension look_at_all{&Unjoined::look_at_outlines,
                                            &Unjoined::look_at_coincident_sides};
    (this->*look_at_all.at(mesh_.dim))();
  }

private:
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);

  struct TouchedLength {
    double length = 0.0;
    std::size_t first = 0; ///< side
  };

  void look_at_outlines() {
    draw();
    std::vector<std::size_t> order; // along x: only neighbours there can touch
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      if (!sides_[b].empty()) {
        order.push_back(b);
      }
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t b) { return outlines_[b].box().low.x(); });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const geometry::BodyBoundary& one = outlines_[order[i]];
      for (std::size_t k = i + 1; k < order.size(); ++k) {
        const geometry::BodyBoundary& two = outlines_[order[k]];
        // Bodies are in order of their left ends: no later one can touch either.
        if (two.box().low.x() > one.box().high.x() + slack_) {
          break;
        }
        if (two.box().low.y() <= one.box().high.y() + slack_ &&
            one.box().low.y() <= two.box().high.y() + slack_) {
          look_at(std::min(order[i], order[k]), std::max(order[i], order[k]));
        }
      }
    }
  }

  // Sides that lie on each other corner on corner, as bricks meshed alike have them.
  void look_at_coincident_sides() {
    struct Touching {
      std::size_t sides = 0;
      base::Vec3 at = base::Vec3::Zero();
    };
    std::map<std::pair<std::size_t, std::size_t>, Touching> found;
    for (const mesh::CoincidentFacePair& seam :
         mesh::find_coincident_faces(mesh_, mesh::boundary_faces(mesh_))) {
      const std::size_t a = of_element_[seam.first.element.index()];
      const std::size_t b = of_element_[seam.second.element.index()];
      const base::Vec3 at = middle(mesh::nodes_of_faces(mesh_, {seam.first}));
      // Ways from the common side into both elements: they must not lie on the same side of it.
      const base::Vec3 one = middle(mesh_.element_nodes(seam.first.element)) - at;
      const base::Vec3 two = middle(mesh_.element_nodes(seam.second.element)) - at;
      if (bodies_[a].net == bodies_[b].net || joined_.contains(std::minmax(a, b)) ||
          one.dot(two) >= 0.0 || mesh::face_has_all_nodes_inside(mesh_, seam.first, cared_for_) ||
          mesh::face_has_all_nodes_inside(mesh_, seam.second, cared_for_)) {
        continue; // within a net: W341
      }
      Touching& touching = found[std::minmax(a, b)];
      touching.at = touching.sides++ == 0 ? at : touching.at;
    }
    for (const auto& [pair, touching] : found) {
      list_.warning(place_of(bodies_[pair.second]), "W451",
                    fmt::format("{} and {} are drawn touching in {} sides of elements, near "
                                "({:.4g}, {:.4g}, {:.4g}), and nothing joins them there",
                                name(pair.first), name(pair.second), touching.sides,
                                touching.at.x(), touching.at.y(), touching.at.z()),
                    "tie them with $MPC; as they are they pass through each other or part without "
                    "a force");
    }
  }

  template <class Nodes> [[nodiscard]] base::Vec3 middle(const Nodes& nodes) const {
    base::Vec3 sum = base::Vec3::Zero();
    for (const base::NodeId n : nodes) {
      sum += mesh_.x[n.index()];
    }
    return sum / static_cast<double>(nodes.size());
  }

  // What contacts and ties join, and the nodes that they look after whatever for.
  void see_joints() {
    for (const model::Contact& contact : model_.contacts) {
      const std::set<std::size_t> slave = see_faces(contact.slave);
      const std::set<std::size_t> master = see_faces(contact.master);
      for (const std::size_t a : slave) {
        for (const std::size_t b : master) {
          joined_.insert(std::minmax(a, b));
        }
      }
    }
    // Bodies that share a tie of any kind are meant to be together.
    for (const model::Mpc& mpc : model_.mpcs) {
      std::set<std::size_t> tied;
      if (const auto* equation = std::get_if<model::ConstraintEquation>(&mpc)) {
        for (const model::ConstraintEquation::ConstraintTerm& term : equation->terms) {
          see_node(term.node, tied);
        }
      } else if (const auto* tie = std::get_if<model::TransitionTie>(&mpc)) {
        see_nodes(tie->slave, tied);
        tied.merge(see_faces(tie->master));
      } else if (const auto* rigid = std::get_if<model::RigidTie>(&mpc)) {
        see_nodes(rigid->slave, tied);
      }
      for (const std::size_t a : tied) {
        for (const std::size_t b : tied) {
          joined_.insert(std::minmax(a, b));
        }
      }
    }
  }

  void see_node(base::NodeId n, std::set<std::size_t>& seen) {
    cared_for_[n.index()] = true;
    if (of_node_[n.index()] != nobody) {
      seen.insert(of_node_[n.index()]);
    }
  }
  void see_nodes(base::NodeSetId set, std::set<std::size_t>& seen) {
    if (set.valid()) {
      for (const base::NodeId n : mesh_.set_with_id(set).nodes) {
        see_node(n, seen);
      }
    }
  }
  std::set<std::size_t> see_faces(base::FaceSetId set) {
    std::set<std::size_t> seen;
    if (set.valid()) {
      for (const base::NodeId n : mesh::nodes_of_faces(mesh_, mesh_.set_with_id(set).faces)) {
        see_node(n, seen);
      }
    }
    return seen;
  }

  void draw() {
    std::vector<std::vector<model::Face>> faces(bodies_.size());
    for (const model::Face& face : mesh::boundary_faces(mesh_)) {
      faces[of_element_[face.element.index()]].push_back(face);
    }
    sides_.resize(bodies_.size());
    length_.resize(bodies_.size(), 0.0);
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      const contact::ContactSurface surface =
          contact::make_contact_surface(model_, mesh_, faces[b]);
      outlines_.push_back(contact::make_displaced_plane_boundary(surface, base::Vector()));
      for (const contact::Edge& edge : surface.plane.edges) {
        sides_[b].push_back(edge);
        length_[b] += edge.length;
        slack_ = std::max(slack_, same_place * edge.length);
      }
    }
  }

  // A side that a contact or tie looks after, or that is held across.
  [[nodiscard]] bool settled(const contact::Edge& side) const {
    const base::Vec2 n = contact::outer_normal(side, 0.0);
    // Supports hold along x or y: the one that is nearer to the normal.
    const std::size_t across = std::abs(n.x()) > std::abs(n.y()) ? 0 : 1;
    bool cared = true;
    bool held = true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(side.count); ++i) {
      const std::size_t node = side.nodes[i].index();
      const model::FreedomRole cls = cls_[2 * node + across];
      cared = cared && cared_for_[node];
      held =
          held && (cls == model::FreedomRole::suppressed || cls == model::FreedomRole::prescribed);
    }
    return cared || held;
  }

  // How much of the boundary of a body lies on another one, which begins where it ends.
  [[nodiscard]] TouchedLength touch(std::size_t body, const geometry::BodyBoundary& other) const {
    // The middles of the four quarters of a side: divisions of the other body need not be the same.
    constexpr std::array places{-0.75, -0.25, 0.25, 0.75};
    TouchedLength found;
    for (std::size_t i = 0; i < sides_[body].size(); ++i) {
      const contact::Edge& side = sides_[body][i];
      if (settled(side)) {
        continue;
      }
      double part = 0.0;
      for (const double xi : places) {
        const base::Vec3 x = base::embed_in_space(contact::point_on_edge(side, xi));
        const base::Vec3 out =
            beside * side.length * base::embed_in_space(contact::outer_normal(side, xi));
        const std::optional<geometry::BoundaryDistance> on = other.signed_distance(x, side.length);
        if (!on || std::abs(on->distance) > same_place * side.length + 2.0 * on->facet) {
          continue;
        }
        const std::optional<geometry::BoundaryDistance> ahead =
            other.signed_distance(x + out, side.length);
        const std::optional<geometry::BoundaryDistance> behind =
            other.signed_distance(x - out, side.length);
        // One body ends where the other begins; sides of bodies that lie in each other touch as
        // well, but look the same way.
        if (ahead && behind && ahead->distance < 0.0 && behind->distance > 0.0) {
          part += 1.0 / static_cast<double>(places.size());
        }
      }
      if (part > 0.0) {
        found.first = found.length == 0.0 ? i : found.first;
        found.length += part * side.length;
      }
    }
    return found;
  }

  void look_at(std::size_t a, std::size_t b) {
    const bool reported = bodies_[a].net == bodies_[b].net && // side on side: W341
                          std::ranges::any_of(list_.messages(), [](const base::Diagnostic& d) {
                            return d.code == "W341";
                          });
    if (reported || joined_.contains({a, b})) {
      return;
    }
    // A touch is measured on the smaller body; seen from the larger one there must be some, too, as
    // a contact or support may settle its sides.
    const std::size_t small = length_[b] < length_[a] ? b : a;
    const std::size_t large = small == a ? b : a;
    const TouchedLength touching = touch(small, outlines_[large]);
    if (touching.length < least_part * length_[small] ||
        touch(large, outlines_[small]).length == 0.0) {
      return;
    }
    const base::Vec2 at = contact::point_on_edge(sides_[small][touching.first], 0.0);
    list_.warning(
        place_of(bodies_[b]), "W451",
        fmt::format("{} and {} are drawn touching along {:.4g} {} of their boundaries, near "
                    "({:.4g}, {:.4g}), and nothing joins them there",
                    name(a), name(b), touching.length, model_.units.length_name, at.x(), at.y()),
        "tie them with $MPC or pair the sides with $CONTACT; as they are they pass through each "
        "other or part without a force");
  }

  [[nodiscard]] base::SourceSpan place_of(const fe::Body& body) const {
    const model::ElementProperty& property =
        model_.properties[mesh_.property[body.elements.front().index()].index()];
    return property.span;
  }

  [[nodiscard]] std::string name(const fe::Body& body) const {
    return body.net.valid() ? model_.nets[body.net.index()].name : "";
  }
  [[nodiscard]] std::string name(std::size_t b) const {
    std::string net = name(bodies_[b]);
    const auto alike = std::ranges::count_if(
        bodies_, [&](const fe::Body& other) { return other.net == bodies_[b].net; });
    if (net.empty() || alike > 1) {
      return fmt::format("the body of element {}{}{}",
                         mesh_.element_label[bodies_[b].elements.front().index()],
                         net.empty() ? "" : " of ", net);
    }
    return net;
  }

  const model::Model& model_;
  const model::Mesh& mesh_;
  base::Diagnostics& list_;
  std::vector<fe::Body> bodies_;
  std::vector<std::size_t> of_element_, of_node_;
  std::vector<bool> cared_for_; ///< [node]
  std::vector<model::FreedomRole> cls_;
  std::set<std::pair<std::size_t, std::size_t>> joined_;
  std::vector<geometry::BodyBoundary> outlines_; ///< [body]
  std::vector<std::vector<contact::Edge>> sides_;
  std::vector<double> length_;
  double slack_ = 0.0;
};

} // namespace

void warn_of_unjoined_bodies(const model::Model& model, base::Diagnostics& list) {
  if (!list.has_errors()) {
    Unjoined(model, list).look();
  }
}

} // namespace spricka::sense
