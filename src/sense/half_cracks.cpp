// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/half_cracks.hpp"

#include "geometry/box.hpp"
#include "mesh/cut/path_gap.hpp"
#include "model/model.hpp"
#include "sense/mirrored_cracks.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

using base::Vec3;

constexpr double in_plane = 1e-7; // of the mesh's size

/// The depths of a crack: of its line or front, of an ellipse where it reaches farthest.
struct Depths {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void add(double depth) {
    least = std::min(least, depth);
    most = std::max(most, depth);
  }
};

Depths depths_of(const model::Model& model, const model::CrackDefinition& crack,
                 const HalfModelPlane& plane) {
  Depths depths;
  if (crack.kind == model::CrackDefinitionKind::ellipse) {
    const model::PlanarCrack& e = crack.plane;
    const double extent =
        std::hypot(e.a * e.transverse_axis()[plane.axis], e.c * e.along[plane.axis]);
    depths.add(plane.signed_distance(e.place) - extent);
    depths.add(plane.signed_distance(e.place) + extent);
    return depths;
  }
  for (const Vec3& x : crack_line_points(model, crack, 0.0)) {
    depths.add(plane.signed_distance(x));
  }
  return depths;
}

bool lies_in(const Depths& depths, const HalfModelPlane& plane) {
  return depths.most <= plane.reach && depths.least >= -plane.reach;
}

/// A straight drawn crack: its mouth, the way it runs, its length.
struct Straight {
  Vec3 mouth = Vec3::Zero();
  Vec3 way = Vec3::UnitX();
  double length = 0.0;
};

Straight straight_of(const model::CrackDefinition& crack) {
  if (crack.angle) {
    return {crack.points.front(), Vec3(std::cos(*crack.angle), std::sin(*crack.angle), 0.0),
            crack.a0.value_or(0.0)};
  }
  const Vec3 along = crack.points.back() - crack.points.front();
  return {crack.points.front(), along.normalized(), along.norm()};
}

// Nodes in the plane from the mouth of a crack that is drawn in it to the end of their line; empty:
// no line of the mesh begins there and goes beyond the tip.
std::vector<base::NodeId> nodes_along(const model::Model& model,
                                      const model::CrackDefinition& crack,
                                      const HalfModelPlane& plane) {
  const model::Mesh& mesh = model.mesh;
  const Straight line = straight_of(crack);
  const std::vector<bool> used = model::mark_nodes_in_use(mesh);
  std::vector<std::pair<double, base::NodeId>> places; // along the crack
  for (std::size_t n = 0; n < used.size(); ++n) {
    if (used[n] && mesh.node_net[n] == crack.net &&
        std::abs(plane.signed_distance(mesh.x[n])) <= plane.reach) {
      places.emplace_back((mesh.x[n] - line.mouth).dot(line.way), base::NodeId(n));
    }
  }
  std::ranges::sort(places);
  const auto mouth =
      std::ranges::lower_bound(places, -plane.reach, {}, &decltype(places)::value_type::first);
  if (mouth == places.end() || mouth->first > plane.reach) {
    return {};
  }
  const bool inside = mouth != places.begin() &&
                      !mesh::find_path_gap(mesh, {std::prev(mouth)->second, mouth->second});
  std::vector<base::NodeId> nodes;
  for (auto place = mouth; place != places.end(); ++place) {
    nodes.push_back(place->second);
  }
  nodes.resize(mesh::find_path_gap(mesh, nodes).value_or(nodes.size()));
  const double end = (mesh.x[nodes.back().index()] - line.mouth).dot(line.way);
  return inside || end <= line.length ? std::vector<base::NodeId>() : nodes;
}

std::string without_half(const model::Model& model, const model::CrackDefinition& crack,
                         const HalfModelPlane& plane) {
  const Depths depths = depths_of(model, crack, plane);
  if (lies_in(depths, plane) && crack.kind != model::CrackDefinitionKind::path) {
    return crack.kind != model::CrackDefinitionKind::free ? "lies in it"
           : nodes_along(model, crack, plane).empty()
               ? "lies in it and does not begin at a surface, with a line of the mesh to go along"
               : "";
  }
  const bool across = depths.most > plane.reach && depths.least < -plane.reach;
  if (across && crack.kind == model::CrackDefinitionKind::free && crack.smooth &&
      crack.points.size() > 2) {
    return "is a smooth curve across it";
  }
  if (across && (crack.kind == model::CrackDefinitionKind::path ||
                 crack.kind == model::CrackDefinitionKind::front)) {
    return "is a line of nodes across it";
  }
  return {};
}

// From its point in the plane to its end on the side that stays: both ends are tips. What was drawn
// as its left face keeps that name.
void cut_line(model::CrackDefinition& crack, const HalfModelPlane& plane) {
  std::vector<Vec3>& points = crack.points;
  if (plane.signed_distance(points.front()) > plane.signed_distance(points.back())) {
    std::ranges::reverse(points);
    std::swap(crack.left, crack.right);
  }
  std::size_t first = points.size() - 1;
  while (plane.signed_distance(points[first - 1]) > plane.reach) {
    --first;
  }
  const Vec3 a = points[first - 1];
  const Vec3 b = points[first];
  const double t = plane.signed_distance(a) / (plane.signed_distance(a) - plane.signed_distance(b));
  std::vector<Vec3> kept{a + t * (b - a)};
  kept.front()[plane.axis] = plane.at;
  kept.insert(kept.end(), points.begin() + static_cast<std::ptrdiff_t>(first), points.end());
  points = std::move(kept);
}

// The order of a list of things about cracks stays; those about a crack that goes go.
template <class T>
void keep_about(std::vector<T>& list, const std::vector<base::CrackId>& now,
                base::CrackId T::*crack) {
  std::erase_if(list, [&](T& about) {
    about.*crack = now[(about.*crack).index()];
    return !(about.*crack).valid();
  });
}

} // namespace

HalfModelPlane make_half_model_plane(const model::Mesh& mesh, const model::MirrorPlane& request,
                                     double at) {
  return {request.axis, at, request.above ? 1.0 : -1.0,
          in_plane * geometry::Box<3>::around(mesh.x).diagonal(), request.span};
}

std::string describe_crack_without_half(const model::Model& model, const HalfModelPlane& plane) {
  for (const model::CrackDefinition& crack : model.cracks) {
    if (const std::string why = without_half(model, crack, plane); !why.empty()) {
      return fmt::format("crack {} {}", crack.name, why);
    }
  }
  return {};
}

bool lies_on_removed_side(const model::Model& model, const model::CrackDefinition& crack,
                          const HalfModelPlane& plane) {
  return depths_of(model, crack, plane).most <= plane.reach &&
         depths_of(model, crack, plane).least < -plane.reach;
}

base::FaceSetId find_missing_crack_face(const model::Model& model,
                                        const model::CrackDefinition& crack,
                                        const HalfModelPlane& plane) {
  if (crack.kind != model::CrackDefinitionKind::free ||
      !lies_in(depths_of(model, crack, plane), plane)) {
    return {};
  }
  const Vec3 way = straight_of(crack).way;
  const Vec3 left(-way.y(), way.x(), 0.0);
  return plane.sign * left[plane.axis] > 0.0 ? crack.right : crack.left;
}

void remove_cracks_beyond_plane(model::Model& model, const HalfModelPlane& plane) {
  std::vector<base::CrackId> now(model.cracks.size());
  std::vector<model::CrackDefinition> kept;
  for (std::size_t i = 0; i < model.cracks.size(); ++i) {
    model::CrackDefinition& crack = model.cracks[i];
    if (lies_on_removed_side(model, crack, plane)) {
      continue;
    }
    const Depths depths = depths_of(model, crack, plane);
    const bool across = depths.least < -plane.reach;
    if (crack.kind == model::CrackDefinitionKind::free && lies_in(depths, plane)) {
      crack.a0 = straight_of(crack).length;
      crack.path = base::NodeSetId(model.mesh.node_sets.size());
      model.mesh.node_sets.push_back({{}, nodes_along(model, crack, plane), crack.span});
      crack.kind = model::CrackDefinitionKind::path;
      crack.points.clear();
      crack.angle.reset();
    } else if (across && crack.kind == model::CrackDefinitionKind::free) {
      cut_line(crack, plane);
    } else if (across && plane.signed_distance(crack.plane.place) < 0.0) {
      // a point within it, on the side that stays
      crack.plane.place[plane.axis] = 2.0 * plane.at - crack.plane.place[plane.axis];
    }
    now[i] = base::CrackId(kept.size());
    kept.push_back(std::move(crack));
  }
  model.cracks = std::move(kept);
  keep_about(model.tip_nets, now, &model::TipMeshSettings::crack);
  keep_about(model.vces, now, &model::VirtualCrackExtensionSettings::crack);
  keep_about(model.tests, now, &model::GrowthTestReadings::crack);
  if (model.growth) {
    for (base::CrackId& crack : model.growth->cracks) {
      crack = now[crack.index()];
    }
    std::erase_if(model.growth->cracks, [](base::CrackId crack) { return !crack.valid(); });
  }
}

} // namespace spricka::sense
