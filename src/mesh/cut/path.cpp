// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/path.hpp"

#include "geometry/polyline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace spricka::mesh {
namespace {

using base::ElementId;
using base::NodeId;

/// Room for round-off in a length along a path, as a part of the crack's length.
constexpr double same_length = 1e-6;

bool is_corner(const HostMesh& host, NodeId n) {
  const auto around = host.elements_around(n);
  return std::any_of(around.begin(), around.end(), [&](ElementId e) {
    const auto nodes = host.mesh().element_nodes(e);
    const auto corners = base::element_info(host.mesh().type[e.index()]).corners;
    return std::find(nodes.begin(), nodes.begin() + corners, n) != nodes.begin() + corners;
  });
}

/// The first edge of the elements round a node that fits.
template <class Fits>
std::optional<EdgeEndAndMidNodes> find_edge(const HostMesh& host, NodeId node, Fits&& fits) {
  for (const ElementId e : host.elements_around(node)) {
    for (int s = 0; s < base::element_info(host.mesh().type[e.index()]).sides; ++s) {
      const EdgeEndAndMidNodes edge = element_edge_nodes(host.mesh(), {e, s});
      if (fits(edge)) {
        return edge;
      }
    }
  }
  return std::nullopt;
}

std::optional<EdgeEndAndMidNodes> edge_between(const HostMesh& host, NodeId from, NodeId to) {
  return find_edge(host, from, [&](const EdgeEndAndMidNodes& edge) {
    return (edge.a == from && edge.b == to) || (edge.a == to && edge.b == from);
  });
}

} // namespace

bool is_body_on_left(const HostMesh& host, NodeId from, NodeId to) {
  return find_edge(host, from,
                   [&](const EdgeEndAndMidNodes& edge) { return edge.a == from && edge.b == to; })
      .has_value();
}

std::optional<std::vector<NodeId>> find_crack_path_nodes(const HostMesh& host,
                                                         const CrackLine& line,
                                                         base::SourceSpan span,
                                                         base::Diagnostics& diagnostics) {
  const model::Mesh& mesh = host.mesh();
  const double a = geometry::polyline_length(line.points);
  std::vector<NodeId> corners;
  // Middle nodes are taken from the edges: the set may have them or not.
  std::copy_if(line.path.begin(), line.path.end(), std::back_inserter(corners),
               [&](NodeId n) { return is_corner(host, n); });
  if (corners.empty()) {
    diagnostics.error(span, "E427", fmt::format("{}: PATH has no nodes", line.display_name()));
    return std::nullopt;
  }
  std::vector<NodeId> result{corners.front()};
  double s = 0.0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const auto edge = edge_between(host, corners[i - 1], corners[i]);
    if (!edge) {
      diagnostics.error(span, "E427",
                        fmt::format("{}: no element edge joins the nodes {} and {} of PATH",
                                    line.display_name(), mesh.node_label[corners[i - 1].index()],
                                    mesh.node_label[corners[i].index()]),
                        "order the set from the mouth, ORDER=(..) on $NSET");
      return std::nullopt;
    }
    const double before = s;
    if (edge->mid.valid()) {
      result.push_back(edge->mid);
      s += (mesh.x[edge->mid.index()] - mesh.x[corners[i - 1].index()]).norm() +
           (mesh.x[corners[i].index()] - mesh.x[edge->mid.index()]).norm();
    } else {
      s += (mesh.x[corners[i].index()] - mesh.x[corners[i - 1].index()]).norm();
    }
    result.push_back(corners[i]);
    if (std::abs(s - a) <= same_length * a) {
      return result;
    }
    if (s > a) {
      diagnostics.error(
          span, "E427",
          fmt::format("{}: without a patch the tip must be a node of PATH, a = {:.6g} lies between "
                      "node {} at {:.6g} and node {} at {:.6g}",
                      line.display_name(), a, mesh.node_label[corners[i - 1].index()], before,
                      mesh.node_label[corners[i].index()], s));
      return std::nullopt;
    }
  }
  diagnostics.error(span, "E427",
                    fmt::format("{}: PATH ends at {:.6g}, before the tip at a = {:.6g}",
                                line.display_name(), s, a));
  return std::nullopt;
}

} // namespace spricka::mesh
