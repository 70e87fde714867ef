// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/open_surface.hpp"

#include "mesh/surface/remesh_surface.hpp"
#include "mesh/tube/solid_front.hpp"
#include "shape/topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

namespace spricka::mesh {
namespace {

using base::Vec3;

/// How far the borders of sets move where faces of the body are meshed anew without them.
class BorderShiftFinder {
public:
  /// `faces`: those meshed anew, ascending; `least`: a shift that counts.
  BorderShiftFinder(const BodySurface& body, const SurfaceGeometry& geometry,
                    const std::vector<std::size_t>& faces, double least)
      : body_(body), geometry_(geometry), faces_(faces), least_(least) {}

  /// What is in the sets of a face lies on faces of the same sets, or borders are moved as far.
  void add_place(const Vec3& x, std::size_t face) {
    const std::vector<std::size_t>& sets = geometry_.face_sets(face);
    const SurfacePlace here = geometry_.nearest_place(x, faces_);
    if (geometry_.face_sets(here.face) == sets) {
      return;
    }
    std::vector<std::size_t> alike;
    std::ranges::copy_if(faces_, std::back_inserter(alike),
                         [&](std::size_t f) { return geometry_.face_sets(f) == sets; });
    const double by = (geometry_.nearest_place(x, alike).x - here.x).norm();
    if (by > least_) {
      add_shifts(sets, geometry_.face_sets(here.face), by, x);
    }
  }

  /// A face at a border that no triangle stands for: the border may have passed over it.
  void add_removed_face(std::size_t face) {
    const geometry::ElementSide& own = geometry_.face(face);
    const double edge = (own.X.col(1) - own.X.col(0)).norm();
    for (int s = 0; s < own.corner_count(); ++s) {
      const SurfaceEdge& side = geometry_.edges()[geometry_.face_edge_index(face, s)];
      const std::size_t other = side.faces[0] == face ? side.faces[1] : side.faces[0];
      if (!side.feature && other != nowhere) {
        add_shifts(geometry_.face_sets(face), geometry_.face_sets(other), edge, own.X.col(0));
      }
    }
  }

  /// By set, each by the most that its border was moved.
  [[nodiscard]] const std::vector<SetBorderShift>& shifts() const { return shifts_; }

private:
  /// The border between faces of some sets and faces of others is moved.
  void add_shifts(const std::vector<std::size_t>& one, const std::vector<std::size_t>& two,
                  double by, const Vec3& at) {
    std::vector<std::size_t> moved;
    std::ranges::set_symmetric_difference(one, two, std::back_inserter(moved));
    for (const std::size_t set : moved) {
      if (!body_.is_face_set_used(set)) {
        continue;
      }
      const std::string& name = body_.name_of_surface_face_set(set);
      const auto known = std::ranges::find(shifts_, name, &SetBorderShift::set);
      if (known == shifts_.end()) {
        shifts_.push_back({name, by, at});
      } else if (by > known->by) {
        *known = {name, by, at};
      }
    }
  }

  const BodySurface& body_;
  const SurfaceGeometry& geometry_;
  const std::vector<std::size_t>& faces_;
  double least_;
  std::vector<SetBorderShift> shifts_;
};

class SurfaceOpener {
public:
  SurfaceOpener(const MouthSurfaceRequest& request, PatchMeshBuilder& net,
                std::unordered_map<int, int>& lower, std::vector<HostFaceReplacement>& pieces)
      : body_(request.body), borders_(request.borders), geometry_(body_.geometry(request.borders)),
        frame_(request.frame), cracks_(request.cracks), tubes_(request.tubes), net_(net),
        lower_(lower), pieces_(pieces) {}

  RemeshedMouthSurface open(const std::vector<CavityFace>& faces) {
    for (const CavityFace& face : faces) {
      region_.faces.push_back(body_.face_index(face.face));
      // Also those that no triangle will lie on are replaced.
      pieces_.emplace_back(face.face, std::vector<std::vector<int>>());
    }
    std::ranges::sort(region_.faces);
    region_.plane = {frame_.origin, frame_.axes.col(2), frame_.a, frame_.axes.col(0)};
    region_.size = [&](const Vec3& x) {
      double least = std::numeric_limits<double>::max();
      for (const PatchSolidCrack& crack : cracks_) {
        least = std::min(
            least, crack.fill.size_at(crack.reach.distance(frame_.rounded_local_coordinates(x))));
      }
      return frame_.a * least;
    };
    region_.growth = TubeMeshParameters::wide_growth;
    for (const PatchSolidCrack& crack : cracks_) {
      region_.growth = std::min(region_.growth, crack.fill.growth);
    }
    describe();
    surface_ = remesh_surface(geometry_, region_);
    if (surface_.trouble) {
      made_.trouble =
          fmt::format("{}, at {}", surface_.trouble.why, coordinate_text(surface_.trouble.at));
      made_.at_border = has_borders();
      return std::move(made_);
    }
    take_points();
    take_edges();
    take_triangles();
    if (borders_ == SetBorderPreservation::none) { // else kept by their lines
      shifts_.emplace(body_, geometry_, region_.faces, 1e-6 * frame_.a);
    }
    take_ends();
    take_removed_edges();
    if (shifts_) {
      find_shifts();
    }
    return std::move(made_);
  }

private:
  struct CapPlace {
    std::size_t crack = 0, tube = 0, end = 0;
  };

  void describe() {
    for (std::size_t c = 0; c < cracks_.size(); ++c) {
      std::vector<std::array<int, 2>> cap_of; // [tube][end]
      for (std::size_t t = 0; t < cracks_[c].tubes.size(); ++t) {
        const Tube& tube = cracks_[c].tubes[t];
        cap_of.push_back({-1, -1});
        for (std::size_t e = 0; e < 2 && !tube.closed && !tube.free; ++e) {
          cap_of.back()[e] = static_cast<int>(region_.caps.size());
          caps_.push_back({c, t, e});
          std::vector<Vec3>& cap = region_.caps.emplace_back();
          for (const int n : tube.ends[e].corner) {
            cap.push_back(net_.position(node_of(c, t, n)));
          }
        }
      }
      for (const CrackMouth& mouth : cracks_[c].mouths) {
        region_.mouths.push_back(
            {mouth.line, {MouthEnd{cap_of[mouth.from][1], 0}, MouthEnd{cap_of[mouth.to][0], 0}}});
      }
      for (const DividedTrace& hole : cracks_[c].holes) {
        region_.mouths.push_back({hole, {}, true});
      }
    }
  }

  [[nodiscard]] int node_of(std::size_t c, std::size_t t, int n) const {
    return tubes_[c][t].node[static_cast<std::size_t>(n)];
  }

  void take_points() {
    node_.assign(surface_.points.size(), -1);
    for (std::size_t k = 0; k < caps_.size(); ++k) {
      const auto& [c, t, e] = caps_[k];
      const Tube& tube = cracks_[c].tubes[t];
      for (std::size_t i = 0; i < surface_.caps[k].size(); ++i) {
        // The first corner lies on the crack: its upper node until the fill is split.
        const int corner = i > 0    ? tube.ends[e].corner[i]
                           : e == 0 ? tube.upper.front()
                                    : tube.upper.back();
        node_[static_cast<std::size_t>(surface_.caps[k][i])] = node_of(c, t, corner);
      }
    }
    std::size_t m = 0;
    for (std::size_t c = 0; c < cracks_.size(); ++c) {
      const PatchSolidCrack& crack = cracks_[c];
      auto& mouths = made_.mouths.emplace_back();
      for (std::size_t k = 0; k < crack.mouths.size(); ++k, ++m) {
        take_free_ends(c, crack.mouths[k], surface_.mouths[m]);
        mouths.push_back(doubled(surface_.mouths[m], 1));
      }
      auto& holes = made_.holes.emplace_back();
      for (std::size_t k = 0; k < crack.holes.size(); ++k, ++m) {
        holes.push_back(doubled(surface_.mouths[m], 0));
      }
    }
    for (std::size_t i = 0; i < surface_.points.size(); ++i) {
      const RemeshedPoint& point = surface_.points[i];
      if (node_[i] < 0) {
        node_[i] = point.host.valid() ? net_.find_or_add_host_node(point.host)
                                      : net_.add_node_at_position(point.place.x);
      }
    }
  }

  /// Where no tube is a mouth ends at the front itself.
  void take_free_ends(std::size_t c, const CrackMouth& mouth, const std::vector<int>& points) {
    const Tube& from = cracks_[c].tubes[mouth.from];
    const Tube& to = cracks_[c].tubes[mouth.to];
    if (from.free) {
      node_[static_cast<std::size_t>(points.front())] = node_of(c, mouth.from, from.front.back());
    }
    if (to.free) {
      node_[static_cast<std::size_t>(points.back())] = node_of(c, mouth.to, to.front.front());
    }
  }

  /// New nodes on either lip of a mouth, from one of its points up to the last but one.
  std::vector<int> doubled(const std::vector<int>& points, std::size_t first) {
    std::vector<int> nodes;
    for (std::size_t i = first; i + 1 < points.size(); ++i) {
      const int n = net_.add_node_at_position(place_of(points[i]));
      node_[static_cast<std::size_t>(points[i])] = n;
      lower_[n] = net_.duplicate_node(n);
      nodes.push_back(n);
    }
    return nodes;
  }

  [[nodiscard]] const Vec3& place_of(int point) const {
    return surface_.points[static_cast<std::size_t>(point)].place.x;
  }
  [[nodiscard]] int node(int point) const { return node_[static_cast<std::size_t>(point)]; }
  [[nodiscard]] int below(int n) const {
    const auto at = lower_.find(n);
    return at == lower_.end() ? n : at->second;
  }

  void take_edges() {
    for (const RemeshedEdge& edge : surface_.edges) {
      const int a = node(edge.points[0]);
      const int b = node(edge.points[1]);
      if (edge.kind == RemeshedEdgeKind::outline || net_.find_mid_node(a, b)) {
        continue; // the tube's, the host's
      }
      const int mid = edge.host_mid.valid() ? net_.find_or_add_host_node(edge.host_mid)
                                            : net_.add_node_at_position(edge.mid.x);
      net_.set_mid_node(a, b, mid);
      if (edge.kind == RemeshedEdgeKind::mouth) {
        net_.set_mid_node(below(a), below(b), net_.duplicate_node(mid));
      } else if (below(a) != a || below(b) != b) { // on one side of the crack, whichever
        net_.set_mid_node(below(a), below(b), mid);
      }
      if (edge.kind == RemeshedEdgeKind::feature && !geometry_.node_sets(edge.host_edge).empty()) {
        made_.edges.push_back({host_nodes(edge.host_edge), {a, b, below(a), below(b)}, mid});
      }
    }
  }

  [[nodiscard]] std::array<base::NodeId, 3> host_nodes(std::size_t edge) const {
    const SurfaceEdge& e = geometry_.edges()[edge];
    return {e.ends[0], e.ends[1], e.mid};
  }

  /// Edges that went as parts of longer ones are replaced too.
  void take_removed_edges() {
    std::set<std::size_t> removed;
    for (const std::size_t face : region_.faces) {
      for (int s = 0; s < geometry_.face(face).corner_count(); ++s) {
        const std::size_t e = geometry_.face_edge_index(face, s);
        if (geometry_.edges()[e].feature && !geometry_.node_sets(e).empty()) {
          removed.insert(e);
        }
      }
    }
    for (const std::size_t e : removed) {
      made_.edges.push_back({host_nodes(e), {}, -1});
    }
  }

  void take_triangles() {
    for (const RemeshedTriangle& t : surface_.triangles) {
      PatchTriangle triangle{};
      std::ranges::transform(t.points, triangle.begin(), [&](int p) { return node(p); });
      made_.triangles.push_back(triangle);
      std::vector<int> upper(triangle.begin(), triangle.end());
      std::vector<int> lower;
      std::ranges::transform(triangle, std::back_inserter(lower), [&](int n) { return below(n); });
      HostFaceReplacement& pieces =
          pieces_.emplace_back(body_.face(t.face), std::vector<std::vector<int>>{upper});
      if (lower != upper) {
        pieces.second.push_back(std::move(lower));
      }
    }
  }

  /// Sides of the tubes' elements that are part of the surface.
  void take_ends() {
    for (const auto& [c, t, e] : caps_) {
      const Tube& tube = cracks_[c].tubes[t];
      for (const Tube::TubeElementSide& side : tube.ends[e].sides) {
        const PatchElement& element = net_.elements[tubes_[c][t].element + side.element];
        std::vector<int> corners;
        Vec3 middle = Vec3::Zero();
        const std::size_t count = shape::side_corner_count(element.type, side.side);
        for (const int i : shape::side_nodes(element.type, side.side).first(count)) {
          corners.push_back(element.nodes[static_cast<std::size_t>(i)]);
          middle += net_.position(corners.back()) / static_cast<double>(count);
        }
        const SurfacePlace place = geometry_.nearest_place(middle, region_.faces);
        for (std::size_t i = 0; i < corners.size() && shifts_; ++i) {
          shifts_->add_place(net_.position(corners[i]), place.face);
        }
        pieces_.emplace_back(body_.face(place.face),
                             std::vector<std::vector<int>>{std::move(corners)});
      }
    }
  }

  /// Edges of the region that are features only as borders of sets.
  [[nodiscard]] bool has_borders() const {
    return std::ranges::any_of(region_.faces, [&](std::size_t face) {
      for (int s = 0; s < geometry_.face(face).corner_count(); ++s) {
        if (geometry_.edges()[geometry_.face_edge_index(face, s)].border) {
          return true;
        }
      }
      return false;
    });
  }

  void find_shifts() {
    std::set<std::size_t> left(region_.faces.begin(), region_.faces.end());
    for (const RemeshedTriangle& t : surface_.triangles) {
      left.erase(t.face);
      for (const int p : t.points) {
        shifts_->add_place(place_of(p), t.face);
      }
    }
    for (const std::size_t face : left) {
      shifts_->add_removed_face(face);
    }
    made_.shifts = shifts_->shifts();
  }

  const BodySurface& body_;
  SetBorderPreservation borders_;
  const SurfaceGeometry& geometry_;
  const CrackFrame& frame_;
  std::span<const PatchSolidCrack> cracks_;
  const std::vector<std::vector<TubeNodesInPatch>>& tubes_;
  PatchMeshBuilder& net_;
  std::unordered_map<int, int>& lower_;
  std::vector<HostFaceReplacement>& pieces_;
  SurfaceRegion region_{};
  std::vector<CapPlace> caps_; ///< of the region's
  RemeshedSurface surface_;
  std::vector<int> node_; ///< [point of the surface]
  std::optional<BorderShiftFinder> shifts_;
  RemeshedMouthSurface made_;
};

} // namespace

RemeshedMouthSurface mesh_mouth_surface(const MouthSurfaceRequest& request, PatchMeshBuilder& net,
                                        std::unordered_map<int, int>& lower,
                                        std::vector<HostFaceReplacement>& pieces) {
  return SurfaceOpener(request, net, lower, pieces).open(request.faces);
}

void choose_edge_ends_by_crack_side(std::span<const PatchElement> elements,
                                    std::vector<HeldSetEdgeReplacement>& edges) {
  std::unordered_map<int, std::set<int>> beside; // nodes of the elements at the middle of an edge
  for (const HeldSetEdgeReplacement& edge : edges) {
    if (edge.mid >= 0) {
      beside[edge.mid];
    }
  }
  for (std::size_t e = 0; e < elements.size() && !beside.empty(); ++e) {
    const std::vector<int>& nodes = elements[e].nodes;
    for (const int n : nodes) {
      if (const auto at = beside.find(n); at != beside.end()) {
        at->second.insert(nodes.begin(), nodes.end());
      }
    }
  }
  for (HeldSetEdgeReplacement& edge : edges) {
    std::erase_if(edge.ends, [&](int n) { return !beside.at(edge.mid).contains(n); });
  }
}

} // namespace spricka::mesh
