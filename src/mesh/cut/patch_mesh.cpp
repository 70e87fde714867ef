// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch_mesh.hpp"

#include "mesh/cut/patch_fill.hpp"
#include "mesh/cut/patch_sizes.hpp"
#include "mesh/cut/symmetry_line.hpp"
#include "shape/shape.hpp"

#include <algorithm>
#include <utility>

namespace spricka::mesh {

using base::Vec2;
using base::Vec3;

namespace {

class PlanePatchBuilder {
public:
  PlanePatchBuilder(const HostMesh& host, std::vector<PatchCrack> cracks, const Cavity& cavity)
      : host_(host), cracks_(std::move(cracks)), frame_(cracks_.front().place.frame),
        half_(cracks_.front().place.half), cavity_(cavity), net_(host.mesh(), frame_),
        fill_size_(patch_grading_without_sources(cracks_)), symmetry_line_(host.mesh(), frame_) {
    for (const PatchCrack& crack : cracks_) {
      transition_ = transition_ || crack.tip->transition;
    }
  }

  PlanePatch build(double fineness) {
    // Rims of rosettes ask for sizes, loops make the nodes of mouths, and cracks run from these to
    // the rims: in this order.
    for (PatchCrack& crack : cracks_) {
      for (const PlacedTip& at : crack.place.fronts) {
        crack.rosettes.push_back(add_rosette(net_, crack.place, at, *crack.tip));
      }
    }
    size_ = patch_curve_sizes(host_, cracks_, cavity_, net_, fineness);
    add_loops();
    for (const PatchCrack& crack : cracks_) {
      add_crack(crack);
    }
    if (patch_.trouble.empty()) {
      add_rims();
      patch_.trouble = triangulate_patch(net_, contours_, fill_size_);
    }
    net_.move_into_patch(patch_);
    return std::move(patch_);
  }

private:
  [[nodiscard]] Vec2 local(const EdgeEndAndMidNodes& edge, double xi) const {
    return point_on_edge(host_.mesh(), frame_, edge, xi);
  }

  /// The loops of the cavity, their free edges divided where the crack asks for it. The line of a
  /// half crack is left out and put in by add_crack.
  void add_loops() {
    for (const std::vector<CavityOutlineEdge>& loop : cavity_.loops) {
      std::vector<int> nodes;
      for (const CavityOutlineEdge& edge : loop) {
        nodes.push_back(net_.find_or_add_host_node(edge.edge.a));
        if (half_ != 0 && symmetry_line_.contains(edge)) {
          symmetry_line_.add_edge(edge);
          continue;
        }
        const std::vector<int> inner = add_edge(edge);
        nodes.insert(nodes.end(), inner.begin(), inner.end());
      }
      contours_.loops.push_back(std::move(nodes));
    }
    for (PatchCrack& crack : cracks_) {
      const auto& mouth = crack.place.mouth;
      if (mouth && mouth->node.valid() && crack.mouth < 0) {
        crack.mouth = net_.find_or_add_host_node(mouth->node);
      }
    }
  }

  /// Nodes inside one edge of the outline, after it has been divided.
  std::vector<int> add_edge(const CavityOutlineEdge& edge) {
    if (!edge.free) {
      return transition_ ? add_tied_parts(edge) : add_parts(edge, {-1.0, 1.0});
    }
    const auto curve = [&](double t) { return local(edge.edge, t); };
    std::vector<double> xi{-1.0};
    const auto divide_to = [&](double end) {
      const std::vector<double> part = divide_curve_by_size(curve, xi.back(), end, size_);
      xi.insert(xi.end(), part.begin() + 1, part.end());
    };
    // Divided from mouth to mouth, each of which so becomes a corner node.
    for (const auto& [at, crack] : mouths_on_edge(edge, cracks_)) {
      divide_to(at);
    }
    divide_to(1.0);
    return add_parts(edge, xi);
  }

  /// At least two parts, the middle node of the host's edge between them: the rim follows the
  /// host's displacements exactly, as both are parabolas on each part.
  std::vector<int> add_tied_parts(const CavityOutlineEdge& edge) {
    const auto curve = [&](double t) { return local(edge.edge, t); };
    std::vector<double> xi = divide_curve_by_size(curve, -1.0, 0.0, size_);
    const std::vector<double> rest = divide_curve_by_size(curve, 0.0, 1.0, size_);
    xi.insert(xi.end(), rest.begin() + 1, rest.end());
    std::vector<int> inner = add_parts(edge, xi);
    const std::vector<std::vector<int>>& pieces = patch_.faces.back().second;
    for (std::size_t i = 1; i < xi.size(); ++i) {
      const std::vector<int>& piece = pieces[i - 1];
      // (mesh.12) for middle nodes of the parts and for corners between them; the host's own middle
      // node, at 0, needs no tie.
      tie(net_.find_or_add_mid_node(piece[0], piece[1]), edge.edge, 0.5 * (xi[i - 1] + xi[i]));
      if (i + 1 < xi.size() && xi[i] != 0.0) {
        tie(piece[1], edge.edge, xi[i]);
      }
    }
    return inner;
  }

  void tie(int node, const EdgeEndAndMidNodes& edge, double xi) {
    const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(xi));
    net_.ties.push_back({node,
                         {net_.find_or_add_host_node(edge.a), net_.find_or_add_host_node(edge.b),
                          net_.find_or_add_host_node(edge.mid)},
                         {N[0], N[1], N[2]}});
  }

  std::vector<int> add_parts(const CavityOutlineEdge& edge, const std::vector<double>& xi) {
    const EdgeEndAndMidNodes& e = edge.edge;
    const auto mouths =
        edge.free ? mouths_on_edge(edge, cracks_) : decltype(mouths_on_edge(edge, cracks_))();
    std::vector<int> inner;
    std::vector<std::vector<int>> pieces;
    int from = net_.find_or_add_host_node(e.a);
    for (std::size_t i = 1; i < xi.size(); ++i) {
      const bool last = i + 1 == xi.size();
      int to = 0;
      if (last) {
        to = net_.find_or_add_host_node(e.b);
      } else if (xi[i] == 0.0) {
        to = net_.find_or_add_host_node(e.mid);
      } else {
        to = net_.add_node_at_position(point_on_edge(host_.mesh(), e, xi[i]));
      }
      // An edge in one piece keeps its middle node, which elements that stay may have as well.
      const bool whole = xi.size() == 2;
      const Vec3 half = point_on_edge(host_.mesh(), e, 0.5 * (xi[i - 1] + xi[i]));
      net_.set_mid_node(
          from, to, whole ? net_.find_or_add_host_node(e.mid) : net_.add_node_at_position(half));
      pieces.push_back({from, to});
      if (!last) {
        inner.push_back(to);
        for (const auto& [at, crack] : mouths) {
          // Equal to the last bit: the edge was divided up to the mouth's own xi.
          cracks_[crack].mouth = xi[i] == at ? to : cracks_[crack].mouth;
        }
      }
      from = to;
    }
    for (const std::vector<int>& piece : pieces) {
      add_edge_size(fill_size_, net_, piece[0], piece[1]);
    }
    patch_.faces.emplace_back(edge.face, std::move(pieces));
    return inner;
  }

  /// New nodes strictly inside a stretch of the crack's line, from s0 to s1 of its length.
  std::vector<int> add_interval(const Vec2& from, const Vec2& to) {
    const auto curve = [&](double t) { return Vec2(from + t * (to - from)); };
    const std::vector<double> t = divide_curve_by_size(curve, 0.0, 1.0, size_);
    std::vector<int> nodes;
    for (std::size_t i = 1; i + 1 < t.size(); ++i) {
      nodes.push_back(net_.add_node_at_local_position(base::embed_in_space(curve(t[i]))));
    }
    return nodes;
  }

  /// Corner nodes of the crack from the mouth, or out of the first rosette, to the last one, then
  /// through it to the tip.
  void add_crack(const PatchCrack& crack) {
    const CrackPlacement& place = crack.place;
    const Rosette& last_rosette = crack.rosettes.back();
    const auto rim_point = [&](const PlacedTip& tip) {
      return Vec2(tip.at - place.radius * tip.growth_direction());
    };
    std::vector<int> crack_face{place.mouth ? crack.mouth : crack.rosettes.front().behind.back()};
    Vec2 from = place.mouth ? place.line.front() : rim_point(place.fronts.front());
    for (std::size_t k = 1; k < place.line.size(); ++k) {
      const bool last = k + 1 == place.line.size();
      // From the rim to the tip the nodes are those of the rosette's first ray.
      const Vec2 to = last ? rim_point(place.fronts.back()) : place.line[k];
      const std::vector<int> inner = add_interval(from, to);
      crack_face.insert(crack_face.end(), inner.begin(), inner.end());
      crack_face.push_back(last ? last_rosette.behind.back()
                                : net_.add_node_at_local_position(base::embed_in_space(to)));
      from = to;
    }
    for (std::size_t i = 0; i + 1 < crack_face.size(); ++i) {
      add_edge_size(fill_size_, net_, crack_face[i], crack_face[i + 1]);
    }
    if (half_ != 0) {
      add_half_line(crack, crack_face);
    } else {
      contours_.embedded.push_back(crack_face);
    }
    std::vector<int> corners;
    if (!place.mouth) {
      const Rosette& first = crack.rosettes.front();
      corners.push_back(first.tip);
      corners.insert(corners.end(), first.behind.begin(), first.behind.end() - 1);
    }
    corners.insert(corners.end(), crack_face.begin(), crack_face.end());
    corners.insert(corners.end(), last_rosette.behind.rbegin() + 1, last_rosette.behind.rend());
    corners.push_back(last_rosette.tip);
    std::vector<int>& path = patch_.paths.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i > 0) {
        path.push_back(net_.find_or_add_mid_node(corners[i - 1], corners[i]));
      }
      path.push_back(corners[i]);
    }
  }

  /// A half: crack, rosette and ligament take the place of the host's edges on the line.
  void add_half_line(const PatchCrack& crack, const std::vector<int>& crack_face) {
    const Rosette& rosette = crack.rosettes.front();
    const SymmetryLine::SymmetryLineEnd end = symmetry_line_.farthest_end();
    if (end.x < 1.0 + crack.place.radius + coordinate_tolerance) {
      patch_.trouble = "the symmetry line ends inside the rosette";
      return;
    }
    std::vector<int> ligament{rosette.ahead.back()};
    const std::vector<int> inner =
        add_interval(net_.local_position(ligament[0]).head<2>(), {end.x, 0.0});
    ligament.insert(ligament.end(), inner.begin(), inner.end());
    ligament.push_back(net_.find_or_add_host_node(end.node));
    for (std::size_t i = 0; i + 1 < ligament.size(); ++i) {
      add_edge_size(fill_size_, net_, ligament[i], ligament[i + 1]);
    }
    // the whole line in the direction of growth, with the edges of the rosette on it
    std::vector<int> line = crack_face;
    line.insert(line.end(), rosette.behind.rbegin() + 1, rosette.behind.rend());
    line.push_back(rosette.tip);
    line.insert(line.end(), rosette.ahead.begin(), rosette.ahead.end());
    line.insert(line.end(), ligament.begin() + 1, ligament.end());
    const std::vector<HostFaceReplacement> pieces = symmetry_line_.edge_replacements(net_, line);
    patch_.faces.insert(patch_.faces.end(), pieces.begin(), pieces.end());
    // what the filling sees: over the rosette
    std::vector<int> contour(crack_face.begin(), crack_face.end() - 1);
    if (half_ > 0) { // rim runs from ahead to behind
      contour.insert(contour.end(), rosette.rim.rbegin(), rosette.rim.rend());
    } else {
      contour.insert(contour.end(), rosette.rim.begin(), rosette.rim.end());
    }
    contour.insert(contour.end(), ligament.begin() + 1, ligament.end());
    if (half_ < 0) {
      std::reverse(contour.begin(), contour.end());
    }
    if (!insert_contour_into_loop(contours_.loops, contour)) {
      patch_.trouble = "the symmetry line is not a straight part of the boundary";
    }
  }

  /// Rosettes are holes in what is to be filled, but for those of halves: there the contour runs
  /// over them.
  void add_rims() {
    for (const PatchCrack& crack : cracks_) {
      for (const Rosette& rosette : crack.rosettes) {
        for (std::size_t j = 0; j + 1 < rosette.rim.size(); ++j) {
          add_edge_size(fill_size_, net_, rosette.rim[j], rosette.rim[j + 1]);
        }
        if (half_ == 0) {
          contours_.loops.emplace_back(rosette.rim.rbegin(), rosette.rim.rend());
        }
      }
    }
  }

  const HostMesh& host_;
  std::vector<PatchCrack> cracks_;
  CrackFrame frame_;
  int half_;
  const Cavity& cavity_;
  PatchMeshBuilder net_;
  PlanePatch patch_;
  Grading size_;      ///< along curves, before they are divided
  Grading fill_size_; ///< in the region, from the edges that were made
  PatchContours contours_;
  SymmetryLine symmetry_line_;
  bool transition_ = false;
};

} // namespace

PlanePatch mesh_plane_cavity(const HostMesh& host, const std::vector<PatchCrack>& cracks,
                             const Cavity& cavity, double fineness) {
  return PlanePatchBuilder(host, cracks, cavity).build(fineness);
}

} // namespace spricka::mesh
