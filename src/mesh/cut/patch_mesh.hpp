// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cavity.hpp"
#include "mesh/cut/patch.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace spricka::mesh {

/// A node of a patch: one of the host's, or new.
struct PatchNode {
  base::Vec3 x = base::Vec3::Zero();
  base::Vec2 local = base::Vec2::Zero(); ///< in the crack's frame, rounded
  base::NodeId host;
};

struct PatchElement {
  base::ElementType type = base::ElementType::trimc6;
  std::vector<int> nodes;
};

/// What fills a cavity. The crack runs along element edges and is still closed: its nodes are not
/// doubled yet.
struct Patch {
  std::vector<PatchNode> nodes;
  std::vector<PatchElement> elements;
  /// [crack] its nodes from the mouth, or the first tip, to the (last) tip, mid nodes too.
  std::vector<std::vector<int>> paths;
  /// Edges of the cavity that belonged to its elements, and the edges (from, to) that take the
  /// place of each, in its direction.
  std::vector<std::pair<model::Face, std::vector<std::pair<int, int>>>> edges;
  /// Nodes inside edges that the host keeps, and where on them; their ties, with a transition.
  struct Tied {
    int node = 0;
    Edge edge;
    double xi = 0.0;
  };
  std::vector<Tied> tied;
  std::string trouble; ///< why there is no patch
};

/// A crack of a cavity, in the frame that all of them share, and its mesh.
struct PatchCrack {
  Placement place;
  const TipMesh* tip = nullptr;
};

/// Meshes a cavity round its cracks: rosettes at the tips, graded triangles in the rest. `fineness`
/// divides the wanted sizes along the boundary of the host.
Patch build_patch(const Host& host, const std::vector<PatchCrack>& cracks, const Cavity& cavity,
                  double fineness);

/// Collects nodes and quadratic elements of a patch; an edge gets its mid node when first met.
class PatchNet {
public:
  PatchNet(const model::Mesh& host, const CrackFrame& frame) : host_(host), frame_(frame) {}

  int host_node(base::NodeId n);
  int new_node(const base::Vec3& x);
  /// At a place in the crack's frame, which is not rounded.
  int new_node(const base::Vec2& place);
  /// The node in the middle of an edge, made half way if the edge has none.
  int mid(int a, int b);
  void set_mid(int a, int b, int node) { mid_[std::minmax(a, b)] = node; }
  void add_triangle(int a, int b, int c);
  void add_quadrilateral(int a, int b, int c, int d);

  [[nodiscard]] const base::Vec3& x(int n) const { return nodes[static_cast<std::size_t>(n)].x; }
  [[nodiscard]] const base::Vec2& local(int n) const {
    return nodes[static_cast<std::size_t>(n)].local;
  }

  std::vector<PatchNode> nodes;
  std::vector<PatchElement> elements;

private:
  const model::Mesh& host_;
  const CrackFrame& frame_;
  std::map<base::NodeId, int> of_host_;
  std::map<std::pair<int, int>, int> mid_;
};

/// The ring mesh round a tip.
struct Rosette {
  int tip = 0;
  std::vector<int> rim; ///< outer corner nodes, anticlockwise; closed but for a half
  /// Corner nodes outward from the tip on the crack's own ray, and ahead on a half's line.
  std::vector<int> behind;
  std::vector<int> ahead;
};
Rosette add_rosette(PatchNet& net, const Placement& placement, const TipPlace& at,
                    const TipMesh& tip);

} // namespace spricka::mesh
