// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "geometry/box_tree.hpp"
#include "geometry/element_side.hpp"
#include "model/mesh.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// No face, no edge.
inline constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

/// A place on the surface of a mesh of solids.
struct SurfacePlace {
  std::size_t face = nowhere;             ///< into SurfaceGeometry::faces
  base::Vec2 r = base::Vec2::Zero();      ///< reference coordinates on it
  base::Vec3 x = base::Vec3::Zero();      ///< on the true, curved face
  base::Vec3 normal = base::Vec3::Zero(); ///< unit, out of the body
};

/// An edge between boundary faces. t [-1,1] runs on it from `ends[0]`, the lower node, to ends[1].
struct SurfaceEdge {
  std::array<base::NodeId, 2> ends;
  base::NodeId mid; ///< invalid between corners of linear elements
  /// The face that runs round its corners from ends[0] to ends[1], and the other; of more than two
  /// those with the lowest numbers; `nowhere` if there is none.
  std::array<std::size_t, 2> faces{nowhere, nowhere};
  std::array<int, 2> side{-1, -1}; ///< the edge's number round the faces
  int count = 0;                   ///< faces that have it: 2 but where bodies touch in an edge
  bool feature = false;            ///< ends the smooth pieces beside it
  bool border = false;             ///< a feature only as the border of a set
};

/// Feature edges one after another, between two nodes where other than two of them meet, or round.
struct FeatureChain {
  std::vector<std::size_t> edges;
  std::vector<base::NodeId>
      nodes; ///< one more than edges; the first again at the end of a closed one
  [[nodiscard]] bool closed() const { return nodes.front() == nodes.back(); }
};

/// Some edges strung into chains, which end at `stops` too.
std::vector<FeatureChain> chain_edges(const std::vector<SurfaceEdge>& all,
                                      const std::vector<std::size_t>& which,
                                      const std::set<base::NodeId>& stops);

/// The boundary of the solids of a mesh, with its smooth pieces and the edges between them. Faces
/// are those of boundary_faces. Keeps no reference to the mesh.
class SurfaceGeometry {
public:
  /// Feature edges are those where the true normals of both faces turn by more than this [rad]: a
  /// bore of sixteen linear facets (22.5 degrees) is one piece.
  static constexpr double most_turn = 0.61; // 35 degrees

  /// Borders of the face sets in `kept` are feature edges too, however smooth the surface is there,
  /// and edges of which the node sets in `lines` have all nodes, but not a face beside them; but
  /// where only sharp edges are to be (`borders` false).
  explicit SurfaceGeometry(const model::Mesh& mesh, std::span<const base::FaceSetId> kept = {},
                           bool borders = true, std::span<const base::NodeSetId> lines = {});

  [[nodiscard]] const std::vector<geometry::ElementSide>& faces() const { return faces_; }
  /// A boundary face by its number.
  [[nodiscard]] const geometry::ElementSide& face(std::size_t f) const { return faces_[f]; }
  /// The number of a boundary face; `nowhere` if it is none.
  [[nodiscard]] std::size_t face_index(const model::Face& face) const;
  /// The place at local coordinates of a face, with position and unit normal out of the body.
  [[nodiscard]] SurfacePlace place_at_coordinates(std::size_t face, const base::Vec2& r) const;
  /// Length of the diagonal of the box round everything.
  [[nodiscard]] double diagonal() const { return extent_; }

  [[nodiscard]] const std::vector<SurfaceEdge>& edges() const { return edges_; }
  /// The edge from corner i of a face to the next.
  [[nodiscard]] std::size_t face_edge_index(std::size_t face, int i) const {
    return face_edges_[face][static_cast<std::size_t>(i)];
  }
  /// The place at t of an edge, on its first face (or its second, if it has no first).
  [[nodiscard]] SurfacePlace place_on_edge(std::size_t edge, double t) const;
  /// The smooth piece of a face, counted from 0 in the order of the faces.
  [[nodiscard]] std::size_t smooth_piece_index(std::size_t face) const { return piece_[face]; }
  [[nodiscard]] std::size_t piece_count() const { return pieces_; }
  /// Which of the sets kept have a face, ascending, by their place in `kept`.
  [[nodiscard]] const std::vector<std::size_t>& face_sets(std::size_t face) const {
    return sets_[face];
  }
  /// Which of the node sets in `lines` have all nodes of an edge, ascending, by their place there.
  [[nodiscard]] const std::vector<std::size_t>& node_sets(std::size_t edge) const {
    return lines_[edge];
  }
  /// Which of them have a node.
  [[nodiscard]] const std::vector<std::size_t>& node_sets(base::NodeId node) const;

  /// The place nearest to x; of several faces as near (an edge) that with the lowest number.
  [[nodiscard]] SurfacePlace nearest_place(const base::Vec3& x) const;
  /// The same among some faces only.
  [[nodiscard]] SurfacePlace nearest_place(const base::Vec3& x,
                                           std::span<const std::size_t> among) const;
  /// The boxes round the faces, by their numbers.
  [[nodiscard]] const geometry::BoxTree<3>& boxes() const { return boxes_; }

private:
  void find_edges();
  void find_sets(const model::Mesh& mesh, std::span<const base::FaceSetId> kept);
  void find_lines(const model::Mesh& mesh, std::span<const base::NodeSetId> lines);
  void find_pieces(bool borders);

  std::vector<geometry::ElementSide> faces_; ///< ascending by element and side
  std::vector<std::array<std::size_t, 4>> face_edges_;
  std::vector<SurfaceEdge> edges_;
  std::vector<std::size_t> piece_;
  std::vector<std::vector<std::size_t>> sets_;  ///< [face]
  std::vector<std::vector<std::size_t>> lines_; ///< [edge]
  std::map<base::NodeId, std::vector<std::size_t>> line_nodes_;
  std::vector<bool> bare_; ///< [edge] some set has it, but no face beside it
  std::size_t pieces_ = 0;
  double extent_ = 0.0;
  geometry::BoxTree<3> boxes_; ///< [face]
};

/// Faces divided into plane triangles by their own maps, which meet in the vertices of the edges
/// they share: linear faces into 1 or 2, quadratic ones into 16 or 32.
class FacetTriangulation {
public:
  static constexpr int divisions = 4; ///< of an edge of a quadratic face

  struct SurfaceFacet {
    std::size_t face = nowhere;
    std::array<int, 3> vertex{-1, -1, -1}; ///< round the outer normal
    std::array<base::Vec2, 3> r;           ///< on the face
  };
  /// A side of facets that is part of an edge of the surface, with its t at both vertices.
  struct FacetEdgeSegment {
    std::size_t edge = nowhere;
    std::array<double, 2> t{0.0, 0.0}; ///< at the lower vertex, at the higher
  };

  /// With so many times more divisions.
  FacetTriangulation(const SurfaceGeometry& surface, std::span<const std::size_t> faces,
                     int finer = 1);

  [[nodiscard]] const std::vector<base::Vec3>& vertices() const { return x_; } ///< [vertex]
  [[nodiscard]] const std::vector<SurfaceFacet>& facets() const { return facets_; }
  /// The places of the vertices of a facet.
  [[nodiscard]] std::array<base::Vec3, 3> corners(const SurfaceFacet& facet) const {
    const auto x = [&](std::size_t c) { return x_[static_cast<std::size_t>(facet.vertex[c])]; };
    return {x(0), x(1), x(2)};
  }
  /// The facets of the i-th face given: from first(i) up to first(i + 1).
  [[nodiscard]] std::size_t first_facet(std::size_t i) const { return first_[i]; }
  /// What lies between two vertices, if it is part of an edge.
  [[nodiscard]] const FacetEdgeSegment* edge_segment(int v, int w) const;

private:
  void add_face(const SurfaceGeometry& surface, std::size_t face);
  [[nodiscard]] int steps(const geometry::ElementSide& face) const; ///< along an edge
  int corner(const geometry::ElementSide& face, int i);
  int on_side(const SurfaceGeometry& surface, std::size_t face, int i, int k);

  int finer_ = 1;
  std::vector<base::Vec3> x_;
  std::vector<SurfaceFacet> facets_;
  std::vector<std::size_t> first_;
  std::map<base::NodeId, int> corner_;
  std::map<std::pair<std::size_t, int>, int> inner_; ///< edge and step from its first end
  std::map<std::pair<int, int>, FacetEdgeSegment> sides_;
};

} // namespace spricka::mesh
