// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/flaw_edges.hpp"

#include "mesh/boundary.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include <Eigen/Geometry>

namespace spricka::deck {

using base::Vec3;
using geometry::CircleAboutAxis;

FlawFace flaw_face(const model::Mesh& mesh, const model::Face& face) {
  const mesh::FaceNodes nodes = mesh::face_nodes(mesh, face);
  FlawFace result;
  for (const base::NodeId n : nodes.corner_nodes()) {
    result.corners.push_back(mesh.x[n.index()]);
    result.centre += mesh.x[n.index()] / static_cast<double>(nodes.corners);
  }
  const std::vector<Vec3>& x = result.corners;
  if (x.size() > 2) {
    result.normal = (x[2] - x[0]).cross(x.back() - x[1]).normalized();
  }
  return result;
}

namespace {

FlawEdge edge_of_face(const model::Mesh& mesh, const model::Face& face,
                      const mesh::FaceNodes& nodes, std::size_t i) {
  const Vec3& a = mesh.x[nodes.edge(i).first.index()];
  const Vec3& b = mesh.x[nodes.edge(i).second.index()];
  const base::NodeId middle = nodes.mid_node(i);
  return {{a, b, middle.valid() ? mesh.x[middle.index()] : Vec3(0.5 * (a + b))},
          flaw_face(mesh, face)};
}

} // namespace

std::vector<FlawEdge> shared_edges(const model::Mesh& mesh, const model::FaceSet& first,
                                   const model::FaceSet& second) {
  std::set<std::pair<base::NodeId, base::NodeId>> of_first;
  for (const model::Face& face : first.faces) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, face);
    for (std::size_t i = 0; i < nodes.corners; ++i) {
      of_first.insert(std::minmax(nodes.edge(i).first, nodes.edge(i).second));
    }
  }
  std::vector<FlawEdge> edges;
  for (const model::Face& face : second.faces) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, face);
    for (std::size_t i = 0; i < nodes.corners; ++i) {
      if (of_first.contains(std::minmax(nodes.edge(i).first, nodes.edge(i).second))) {
        edges.push_back(edge_of_face(mesh, face, nodes, i));
      }
    }
  }
  return edges;
}

std::vector<FlawEdge> side_edges(const model::Mesh& mesh, const model::FaceSet& set) {
  std::vector<FlawEdge> edges;
  for (const model::Face& face : set.faces) {
    edges.push_back(edge_of_face(mesh, face, mesh::face_nodes(mesh, face), 0));
  }
  return edges;
}

std::vector<Vec3> points_of_edges(const std::vector<FlawEdge>& edges) {
  std::vector<Vec3> points;
  for (const FlawEdge& edge : edges) {
    points.insert(points.end(), edge.x.begin(), edge.x.end());
  }
  return points;
}

std::pair<const FlawEdge*, double>
find_least_point(const std::vector<FlawEdge>& edges,
                 const std::function<double(const Vec3&)>& cost) {
  std::pair<const FlawEdge*, double> best{&edges.front(), 0.0};
  double least = std::numeric_limits<double>::infinity();
  constexpr int parts = 16;
  for (const FlawEdge& edge : edges) {
    for (int k = 0; k <= parts; ++k) {
      const double r = -1.0 + 2.0 * k / parts;
      if (const double value = cost(edge.point(r)); value < least) {
        least = value;
        best = {&edge, r};
      }
    }
  }
  double step = 1.0 / parts;
  for (int halvings = 0; halvings < 40; ++halvings, step *= 0.5) {
    for (const double r : {best.second - step, best.second + step}) {
      const double inside = std::clamp(r, -1.0, 1.0);
      if (const double value = cost(best.first->point(inside)); value < least) {
        least = value;
        best.second = inside;
      }
    }
  }
  return best;
}

double diagonal_of_box(const std::vector<Vec3>& points) {
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).norm();
}

CircleAboutAxis find_flaw_circle(const std::vector<Vec3>& points) {
  // Facets of linear elements are as far off.
  constexpr double round_misfit = 0.01; // of the radius
  Vec3 mean = Vec3::Zero();
  for (const Vec3& x : points) {
    mean += x / static_cast<double>(points.size());
  }
  std::vector<Vec3> away = points;
  for (Vec3& x : away) {
    x -= mean;
  }
  const geometry::LeastSpread spread = geometry::least_spread(away);
  const bool flat = spread.smallest < round_misfit && spread.middle > round_misfit;
  const CircleAboutAxis circle =
      flat ? geometry::fit_circle_about_axis(points, spread.direction) : CircleAboutAxis{};
  return circle.misfit > round_misfit ? CircleAboutAxis{} : circle;
}

} // namespace spricka::deck
