// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/flaw_place.hpp"

#include "base/tidy.hpp"
#include "deck/flaw_edges.hpp"
#include "deck/sets.hpp"
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
    const std::vector<base::FaceSetId> sets = face_sets();
    if (sets.size() == 1) {
      return surface_flaw(mesh_.set_with_id(sets.front()));
    }
    if (sets.size() == 2) {
      return corner_flaw(mesh_.set_with_id(sets[0]), mesh_.set_with_id(sets[1]));
    }
    return sets.empty() ? std::nullopt
                        : fail("AT", "AT names one face, or two that meet in an edge");
  }

  std::optional<std::array<Vec3, 2>> place_in_plane() {
    const std::vector<base::FaceSetId> sets = face_sets();
    for (const char* key : {"LENGTH", "ALONG"}) {
      if (card_.has_key(key)) {
        fail(key, fmt::format("{} means nothing in the plane", key),
             "DEPTH is the length of the flaw, at right angles to the edge");
        return std::nullopt;
      }
    }
    if (sets.size() != 1) {
      if (!sets.empty()) {
        fail("AT", "in the plane AT names one edge of the body");
      }
      return std::nullopt;
    }
    const model::FaceSet& set = mesh_.set_with_id(sets.front());
    const std::vector<FlawEdge> edges = side_edges(mesh_, set);
    const auto found = place_on_edges(edges, set.name);
    if (!found) {
      return std::nullopt;
    }
    const auto [edge, r] = *found;
    const Vec3 x = edge->point(r);
    const Vec3 along = edge->tangent(r);
    Vec3 inward(-along.y(), along.x(), 0.0);
    if (const CircleAboutAxis circle = find_flaw_circle(points_of_edges(edges));
        circle.radius > 0.0) { // facets do not turn the flaw
      const Vec3 away = (x - circle.centre).normalized();
      inward = away.dot(inward) < 0.0 ? Vec3(-away) : away;
    }
    return std::array{x, Vec3(x + depth_ * inward)};
  }

private:
  std::optional<model::PlanarCrack> fail(std::string_view key, const std::string& text,
                                         const std::string& hint = {}) {
    const CheckedValue* value = card_.find(key);
    c_.error(value != nullptr ? value->span : card_.span, "E328", text, hint);
    return std::nullopt;
  }

  /// Those of AT, as many as are named; none after an error.
  std::vector<base::FaceSetId> face_sets() {
    std::vector<base::FaceSetId> sets;
    for (NameReference name : card_.find("AT")->names) {
      if (card_.has_key("NET") && name.name.find('.') == std::string::npos) {
        name.net = card_.word_value("NET"); // the sets are those of the net that is cut
      }
      const std::optional<base::FaceSetId> set = resolve_face_set(c_, name);
      if (!set) {
        return {};
      }
      sets.push_back(*set);
    }
    return sets;
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

  /// The point that ANGLE or coordinates say: an edge and its coordinate. `what` names the edges.
  std::optional<std::pair<const FlawEdge*, double>>
  place_on_edges(const std::vector<FlawEdge>& edges, const std::string& what) {
    const std::vector<Vec3> points = points_of_edges(edges);
    std::function<double(const Vec3&)> cost = [&](const Vec3& x) { return off_coordinates(x); };
    double allowed = std::pow(place_misfit * diagonal_of_box(points), 2);
    if (card_.has_key("ANGLE")) {
      const CircleAboutAxis circle = find_flaw_circle(points);
      if (circle.radius == 0.0) {
        fail("ANGLE", fmt::format("{} is no circle, so that ANGLE means nothing there", what),
             "give X0, Y0 or Z0 of a point of it");
        return std::nullopt;
      }
      cost = [this, circle](const Vec3& x) { return off_angle(circle, x); };
      allowed = place_misfit;
      if (has_coordinates()) { // neither may be passed over
        fail("ANGLE",
             fmt::format("ANGLE and coordinates both say where on {} the flaw lies", what));
        return std::nullopt;
      }
    } else if (!has_coordinates()) {
      fail("AT", fmt::format("where on {} the flaw lies is not said", what),
           "ANGLE round a bore, or X0, Y0 or Z0 of a point");
      return std::nullopt;
    }
    const auto found = find_least_point(edges, cost);
    const Vec3 x = found.first->point(found.second);
    if (cost(x) > allowed) {
      fail(card_.has_key("ANGLE") ? "ANGLE" : "X0",
           fmt::format("{} does not go there; its nearest point is {}", what, place_text(x)));
      return std::nullopt;
    }
    return found;
  }

  std::optional<model::PlanarCrack> corner_flaw(const model::FaceSet& first,
                                                const model::FaceSet& second) {
    const std::vector<FlawEdge> edges = shared_edges(mesh_, first, second);
    if (edges.empty()) {
      return fail("AT", fmt::format("{} and {} do not meet in an edge", first.name, second.name));
    }
    if (card_.has_key("ALONG")) {
      return fail("ALONG",
                  "a corner flaw is normal to its edge, so that ALONG means nothing there");
    }
    const auto found =
        place_on_edges(edges, fmt::format("the edge of {} and {}", first.name, second.name));
    if (!found) {
      return std::nullopt;
    }
    const auto [edge, r] = *found;
    const Vec3 x = edge->point(r);
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
      faces.push_back(flaw_face(mesh_, face));
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
    if (std::sqrt(off_coordinates(x)) > place_misfit * diagonal_of_box(points)) {
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

std::optional<std::array<base::Vec3, 2>> place_plane_flaw(DeckContext& context,
                                                          const CheckedCard& card) {
  return FlawPlacer(context, card).place_in_plane();
}

} // namespace spricka::deck
