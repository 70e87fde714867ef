// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/flaw_place.hpp"

#include "base/tidy.hpp"
#include "deck/sets.hpp"
#include "geometry/circle_about_axis.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::deck {

namespace {

using base::Vec3;
using geometry::CircleAboutAxis;

constexpr double round_misfit = 0.01; // of the radius; facets of linear elements are as far off
constexpr double flat_spread = 1e-4;  // of normals
constexpr double round_spread = 0.02; // of their components along the axis
constexpr double place_misfit = 0.01; // of the size of the face or edge

/// A face of a set: corners, outward normal.
struct FlawFace {
  std::vector<Vec3> corners;
  Vec3 centre = Vec3::Zero();
  Vec3 normal = Vec3::Zero(); ///< unit
};

/// An edge of elements where two face sets meet, perhaps curved.
struct SharedEdge {
  std::array<Vec3, 3> x; ///< its ends and its middle
  FlawFace second;       ///< the face of the second set beside it

  [[nodiscard]] Vec3 point(double r) const { // -1 .. 1
    return 0.5 * r * (r - 1.0) * x[0] + 0.5 * r * (r + 1.0) * x[1] + (1.0 - r * r) * x[2];
  }
  [[nodiscard]] Vec3 tangent(double r) const {
    return ((r - 0.5) * x[0] + (r + 0.5) * x[1] - 2.0 * r * x[2]).normalized();
  }
};

FlawFace face_of(const model::Mesh& mesh, const model::Face& face) {
  const mesh::FaceNodes nodes = mesh::face_nodes(mesh, face);
  FlawFace result;
  for (const base::NodeId n : nodes.corner_nodes()) {
    result.corners.push_back(mesh.x[n.index()]);
    result.centre += mesh.x[n.index()] / static_cast<double>(nodes.corners);
  }
  const std::vector<Vec3>& x = result.corners;
  result.normal = (x[2] - x[0]).cross(x.back() - x[1]).normalized();
  return result;
}

std::vector<SharedEdge> shared_edges(const model::Mesh& mesh, const model::FaceSet& first,
                                     const model::FaceSet& second) {
  std::set<std::pair<base::NodeId, base::NodeId>> of_first;
  for (const model::Face& face : first.faces) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, face);
    for (std::size_t i = 0; i < nodes.corners; ++i) {
      of_first.insert(std::minmax(nodes.edge(i).first, nodes.edge(i).second));
    }
  }
  std::vector<SharedEdge> edges;
  for (const model::Face& face : second.faces) {
    const mesh::FaceNodes nodes = mesh::face_nodes(mesh, face);
    for (std::size_t i = 0; i < nodes.corners; ++i) {
      const auto [a, b] = nodes.edge(i);
      if (of_first.contains(std::minmax(a, b))) {
        const Vec3& x = mesh.x[a.index()];
        const Vec3& y = mesh.x[b.index()];
        const base::NodeId middle = nodes.mid_node(i);
        edges.push_back({{x, y, middle.valid() ? mesh.x[middle.index()] : Vec3(0.5 * (x + y))},
                         face_of(mesh, face)});
      }
    }
  }
  return edges;
}

/// The point of some edges where a function is least: an edge and its coordinate.
std::pair<const SharedEdge*, double> nearest(const std::vector<SharedEdge>& edges,
                                             const std::function<double(const Vec3&)>& cost) {
  std::pair<const SharedEdge*, double> best{&edges.front(), 0.0};
  double least = std::numeric_limits<double>::infinity();
  constexpr int parts = 16;
  for (const SharedEdge& edge : edges) {
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

double extent(const std::vector<Vec3>& points) {
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).norm();
}

/// Of points in a plane.
CircleAboutAxis circle_of(const std::vector<Vec3>& points) {
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
  return flat ? geometry::fit_circle_about_axis(points, spread.direction) : CircleAboutAxis{};
}

/// Without what round-off leaves of a zero.
std::string place_text(const Vec3& x) {
  const double least = 1e-9 * x.norm();
  return base::format_coordinates(
      x.unaryExpr([&](double v) { return std::abs(v) < least ? 0.0 : v; }), 3);
}

class FlawPlacer {
public:
  FlawPlacer(DeckContext& context, const CheckedCard& card)
      : c_(context), card_(card), mesh_(context.model.mesh), depth_(card.number_value("DEPTH")) {}

  std::optional<model::PlanarCrack> place() {
    const CheckedValue& at = *card_.find("AT");
    std::vector<base::FaceSetId> sets;
    for (NameReference name : at.names) {
      if (card_.has_key("NET") && name.name.find('.') == std::string::npos) {
        name.net = card_.word_value("NET"); // the sets are those of the net that is cut
      }
      const std::optional<base::FaceSetId> set = resolve_face_set(c_, name);
      if (!set) {
        return std::nullopt;
      }
      sets.push_back(*set);
    }
    if (sets.size() == 1) {
      return surface_flaw(mesh_.set_with_id(sets.front()));
    }
    if (sets.size() == 2) {
      return corner_flaw(mesh_.set_with_id(sets[0]), mesh_.set_with_id(sets[1]));
    }
    c_.error(at.span, "E115", "AT names one face, or two that meet in an edge");
    return std::nullopt;
  }

private:
  std::optional<model::PlanarCrack> fail(std::string_view key, const std::string& text,
                                         const std::string& hint = {}) {
    const CheckedValue* value = card_.find(key);
    c_.error(value != nullptr ? value->span : card_.span, "E328", text, hint);
    return std::nullopt;
  }

  /// Squared distance from the coordinates that the card gives; the others are free.
  [[nodiscard]] double off_coordinates(const Vec3& x) const {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const std::string key{"XYZ"[i], '0'};
      sum += card_.has_key(key) ? std::pow(x[i] - card_.number_value(key), 2) : 0.0;
    }
    return sum;
  }
  [[nodiscard]] bool has_coordinates() const {
    return card_.has_key("X0") || card_.has_key("Y0") || card_.has_key("Z0");
  }
  [[nodiscard]] double off_angle(const CircleAboutAxis& circle, const Vec3& x) const {
    return std::abs(
        std::remainder(circle.angle_of(x) - card_.number_value("ANGLE"), 2.0 * std::numbers::pi));
  }

  std::optional<model::PlanarCrack> corner_flaw(const model::FaceSet& first,
                                                const model::FaceSet& second) {
    const std::vector<SharedEdge> edges = shared_edges(mesh_, first, second);
    if (edges.empty()) {
      return fail("AT", fmt::format("{} and {} do not meet in an edge", first.name, second.name));
    }
    std::vector<Vec3> points;
    for (const SharedEdge& edge : edges) {
      points.insert(points.end(), edge.x.begin(), edge.x.end());
    }
    if (card_.has_key("ALONG")) {
      return fail("ALONG",
                  "a corner flaw is normal to its edge, so that ALONG means nothing there");
    }
    std::function<double(const Vec3&)> cost = [&](const Vec3& x) { return off_coordinates(x); };
    double allowed = std::pow(place_misfit * extent(points), 2);
    if (card_.has_key("ANGLE")) {
      const CircleAboutAxis circle = circle_of(points);
      if (circle.radius == 0.0 || circle.misfit > round_misfit) {
        return fail("ANGLE",
                    fmt::format("the edge of {} and {} is no circle, so that ANGLE means "
                                "nothing there",
                                first.name, second.name),
                    "give X0, Y0 or Z0 of a point of the edge");
      }
      cost = [this, circle](const Vec3& x) { return off_angle(circle, x); };
      allowed = place_misfit;
      if (has_coordinates()) { // neither may be passed over
        return fail("ANGLE", "ANGLE and coordinates both say where on the edge the flaw lies");
      }
    } else if (!has_coordinates()) {
      return fail("AT", "where on the edge the flaw lies is not said",
                  "ANGLE round a bore, or X0, Y0 or Z0 of a point of the edge");
    }
    const auto [edge, r] = nearest(edges, cost);
    const Vec3 x = edge->point(r);
    if (cost(x) > allowed) {
      return fail(card_.has_key("ANGLE") ? "ANGLE" : "X0",
                  fmt::format("the edge of {} and {} does not go there; its nearest point is "
                              "{}",
                              first.name, second.name, place_text(x)));
    }
    model::PlanarCrack plane;
    plane.place = x;
    plane.normal = edge->tangent(r);
    const Vec3 along = edge->second.normal.cross(plane.normal);
    plane.along = (along.dot(edge->second.centre - x) < 0.0 ? -1.0 : 1.0) * along.normalized();
    // angles of the front count from the face into the body
    if (plane.transverse_axis().dot(edge->second.normal) > 0.0) {
      plane.normal = -plane.normal;
    }
    plane.a = depth_;
    plane.c = card_.optional_number("LENGTH").value_or(depth_);
    return plane;
  }

  std::optional<model::PlanarCrack> surface_flaw(const model::FaceSet& set) {
    std::vector<Vec3> normals;
    std::vector<Vec3> points;
    std::vector<FlawFace> faces;
    for (const model::Face& face : set.faces) {
      faces.push_back(face_of(mesh_, face));
      normals.push_back(faces.back().normal);
      points.insert(points.end(), faces.back().corners.begin(), faces.back().corners.end());
    }
    const geometry::LeastSpread spread = geometry::least_spread(normals);
    if (spread.middle < flat_spread) {
      return flat_flaw(set, faces, points);
    }
    const CircleAboutAxis circle = spread.smallest < round_spread
                                       ? geometry::fit_circle_about_axis(points, spread.direction)
                                       : CircleAboutAxis{};
    if (circle.radius == 0.0 || circle.misfit > round_misfit) {
      return fail("AT", fmt::format("{} is neither flat nor round about one axis", set.name),
                  "give the ellipse: A, C, X0 Y0 Z0 and NORMAL, or X1 Y1 Z1");
    }
    return round_flaw(set, faces, circle);
  }

  std::optional<model::PlanarCrack> flat_flaw(const model::FaceSet& set,
                                              const std::vector<FlawFace>& faces,
                                              const std::vector<Vec3>& points) {
    if (!card_.has_key("ALONG")) {
      return fail("AT", "a surface flaw on a flat face needs ALONG, the direction of its mouth",
                  "ALONG=X|Y|Z");
    }
    if (card_.has_key("ANGLE")) {
      return fail("ANGLE", fmt::format("{} is flat, so that ANGLE means nothing there", set.name),
                  "give X0, Y0 or Z0 of the middle of the mouth");
    }
    Vec3 low = points.front();
    Vec3 high = low;
    for (const Vec3& x : points) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    Vec3 x = 0.5 * (low + high); // the middle of the face, where the card says nothing
    for (Eigen::Index i = 0; i < 3; ++i) {
      const std::string key{"XYZ"[i], '0'};
      x[i] = card_.has_key(key) ? card_.number_value(key) : x[i];
    }
    const Vec3 normal = faces.front().normal;
    x -= normal.dot(x - points.front()) * normal;
    if (std::sqrt(off_coordinates(x)) > place_misfit * extent(points)) {
      return fail("X0", fmt::format("the point lies off {}", set.name));
    }
    return flaw_on_face(set, faces, x, normal);
  }

  std::optional<model::PlanarCrack> round_flaw(const model::FaceSet& set,
                                               const std::vector<FlawFace>& faces,
                                               const CircleAboutAxis& circle) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const FlawFace& face : faces) {
      for (const Vec3& x : face.corners) {
        low = std::min(low, circle.height_of(x));
        high = std::max(high, circle.height_of(x));
      }
    }
    if (!card_.has_key("ANGLE")) {
      return fail("AT", fmt::format("where round {} the flaw lies is not said", set.name),
                  "ANGLE counts about the axis, and X0, Y0 or Z0 along it");
    }
    const double angle = card_.number_value("ANGLE");
    double height = 0.5 * (low + high);
    if (has_coordinates()) { // of the line at this angle the point nearest to them
      double least = std::numeric_limits<double>::infinity();
      constexpr int parts = 4096;
      for (int k = 0; k <= parts; ++k) {
        const double h = low + (high - low) * k / parts;
        if (const double off = off_coordinates(circle.point(angle, h)); off < least) {
          least = off;
          height = h;
        }
      }
      if (std::sqrt(least) > place_misfit * (high - low + circle.radius)) {
        const Vec3 x = circle.point(angle, height);
        return fail("X0", fmt::format("{} does not go there; at that angle its nearest point is "
                                      "{}",
                                      set.name, place_text(x)));
      }
    }
    const Vec3 x = circle.point(angle, height);
    const Vec3 radial = (x - circle.point(angle + std::numbers::pi, height)).normalized();
    const Vec3 away = faces.front().centre - circle.centre;
    const bool bore = faces.front().normal.dot(away) < 0.0;
    return flaw_on_face(set, faces, x, bore ? Vec3(-radial) : radial, circle.axis);
  }

  /// Half an ellipse on a face at a point of it.
  std::optional<model::PlanarCrack> flaw_on_face(const model::FaceSet& set,
                                                 const std::vector<FlawFace>& faces, const Vec3& x,
                                                 const Vec3& normal,
                                                 const Vec3& usual_mouth = Vec3::Zero()) {
    const bool on_face = std::ranges::any_of(faces, [&](const FlawFace& face) {
      return (face.centre - x).norm() <=
             1.5 * std::ranges::max((face.corners[0] - face.centre).norm(),
                                    (face.corners[1] - face.centre).norm());
    });
    if (!on_face) {
      return fail(card_.has_key("ANGLE") ? "ANGLE" : "X0",
                  fmt::format("the point {} lies beside {}", place_text(x), set.name));
    }
    const Vec3 mouth = card_.has_key("ALONG")
                           ? Vec3(Vec3::Unit(card_.word_value("ALONG").front() - 'X'))
                           : usual_mouth;
    const Vec3 flat = mouth - normal.dot(mouth) * normal;
    if (flat.norm() < 0.1) {
      return fail("ALONG", fmt::format("ALONG runs into {}, not along it", set.name));
    }
    model::PlanarCrack plane;
    plane.place = x;
    plane.along = flat.normalized();
    plane.normal = normal.cross(plane.along); // angles of the front count into the body
    plane.a = depth_;
    plane.c = 0.5 * card_.optional_number("LENGTH").value_or(2.0 * depth_);
    return plane;
  }

  DeckContext& c_;
  const CheckedCard& card_;
  const model::Mesh& mesh_;
  double depth_;
};

} // namespace

std::optional<model::PlanarCrack> place_flaw(DeckContext& context, const CheckedCard& card) {
  return FlawPlacer(context, card).place();
}

} // namespace spricka::deck
