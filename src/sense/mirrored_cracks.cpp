// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/mirrored_cracks.hpp"

#include "fe/load_rule.hpp"
#include "geometry/polyline.hpp"
#include "model/model.hpp"
#include "sense/mirrored_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

constexpr double same_spot = 1e-6; // of the model's size
constexpr double same_axis = 1e-9;
constexpr double any_length = 1.0; // any second point tells the direction

double off_line(const base::Vec3& x, const std::vector<base::Vec3>& line) {
  return std::min((x - line.front()).norm(), geometry::nearest_point(x, line).distance);
}

// The order of points does not matter where both ends are tips, or a front ends on both sides.
bool mirrored_line(const Reflection& mirror, const std::vector<base::Vec3>& one,
                   const std::vector<base::Vec3>& other) {
  if (one.empty() || other.empty()) {
    return one.empty() == other.empty();
  }
  const double reach = same_spot * mirror.size;
  const auto at = [&](const base::Vec3& a, const base::Vec3& b) {
    return (mirror(a) - b).norm() <= reach;
  };
  const bool ends = (at(one.front(), other.front()) && at(one.back(), other.back())) ||
                    (at(one.front(), other.back()) && at(one.back(), other.front()));
  return ends && std::ranges::all_of(
                     one, [&](const base::Vec3& x) { return off_line(mirror(x), other) <= reach; });
}

bool mirrored_plane(const Reflection& mirror, const model::PlanarCrack& one,
                    const model::PlanarCrack& other) {
  const double reach = same_spot * mirror.size;
  const auto turned = [&](base::Vec3 v) {
    v[mirror.axis] = -v[mirror.axis];
    return v;
  };
  const bool round = std::abs(one.a - one.c) <= same_axis * one.a;
  return (mirror(one.place) - other.place).norm() <= reach &&
         turned(one.normal).cross(other.normal).norm() <= same_spot &&
         (round || turned(one.along).cross(other.along).norm() <= same_spot) &&
         std::abs(one.a - other.a) <= same_axis * one.a &&
         std::abs(one.c - other.c) <= same_axis * one.c;
}

bool grows(const model::Model& model, std::size_t crack) {
  return model.growth && model.growth->grows(base::CrackId(crack));
}

bool mirrored_shape(const model::Model& model, const Reflection& mirror,
                    const model::CrackDefinition& one, const model::CrackDefinition& other) {
  if (one.kind != other.kind || one.mu != other.mu || one.a0 != other.a0 ||
      one.faces_in_contact != other.faces_in_contact) {
    return false;
  }
  return one.kind == model::CrackDefinitionKind::ellipse
             ? mirrored_plane(mirror, one.plane, other.plane)
             : mirrored_line(mirror, crack_line_points(model, one, any_length),
                             crack_line_points(model, other, any_length));
}

// From the right face to the left one, in space from the lower to the upper; zero: not known.
base::Vec3 normal_of(const model::Model& model, const model::CrackDefinition& crack) {
  if (!crack.is_line()) {
    const bool drawn = crack.kind != model::CrackDefinitionKind::front;
    return drawn ? crack.plane.normal : base::Vec3(base::Vec3::Zero());
  }
  const std::vector<base::Vec3> points = crack_line_points(model, crack, any_length);
  const base::Vec3 along = points.back() - points.front();
  return {-along.y(), along.x(), 0.0};
}

// Points of a load on a crack's faces: along its line, or over its ellipse.
std::vector<fe::LoadEvaluationPoint> face_places(const model::Model& model,
                                                 const model::CrackDefinition& crack,
                                                 const model::Load& load) {
  std::vector<fe::LoadEvaluationPoint> places;
  if (crack.kind == model::CrackDefinitionKind::ellipse) {
    constexpr int sectors = 8;
    const auto at = [&](double r, double sector) {
      const double phi = sector * 2.0 * std::numbers::pi / sectors;
      return base::Vec3(crack.plane.place +
                        r * (crack.plane.c * std::cos(phi) * crack.plane.along +
                             crack.plane.a * std::sin(phi) * crack.plane.transverse_axis()));
    };
    fe::SpaceNodes<2> X(3, 6);
    for (int i = 0; i < sectors; ++i) {
      X << crack.plane.place, at(1.0, i), at(1.0, i + 1.0), at(0.5, i), at(1.0, i + 0.5),
          at(0.5, i + 1.0);
      fe::add_load_sample_points<2>(shape::reference_element<2>(base::ElementType::trimc6), X, load,
                                    places);
    }
    return places;
  }
  const std::vector<base::Vec3> points = crack_line_points(model, crack, any_length);
  fe::SpaceNodes<1> X(3, 2);
  for (std::size_t i = 1; i < points.size(); ++i) {
    X << points[i - 1], points[i];
    fe::add_load_sample_points<1>(shape::reference_line(2), X, load, places);
  }
  return places;
}

} // namespace

std::vector<base::Vec3> crack_line_points(const model::Model& model,
                                          const model::CrackDefinition& crack, double otherwise) {
  std::vector<base::Vec3> points = crack.points;
  if (crack.path.valid()) {
    for (const base::NodeId n : model.mesh.set_with_id(crack.path).nodes) {
      points.push_back(model.mesh.x[n.index()]);
    }
  }
  if (crack.angle && !points.empty()) {
    const double a = crack.a0.value_or(otherwise);
    points.push_back(points.front() +
                     a * base::Vec3(std::cos(*crack.angle), std::sin(*crack.angle), 0.0));
  }
  return points;
}

const model::CrackDefinition* find_loaded_crack(const model::Model& model,
                                                const model::Load& load) {
  const auto found = std::ranges::find_if(model.cracks, [&](const model::CrackDefinition& crack) {
    return load.faces.valid() && (load.faces == crack.left || load.faces == crack.right);
  });
  return found == model.cracks.end() ? nullptr : &*found;
}

bool is_mirrored_crack_face_load(const model::Model& model, const Reflection& mirror,
                                 const model::Load& one, const model::Load& other) {
  const model::CrackDefinition* const crack = find_loaded_crack(model, one);
  const model::CrackDefinition* const image = find_loaded_crack(model, other);
  if (crack == nullptr || image == nullptr || one.type != model::LoadType::pressure ||
      other.type != model::LoadType::pressure || !mirrored_shape(model, mirror, *crack, *image)) {
    return false;
  }
  base::Vec3 normal = normal_of(model, *crack);
  normal[mirror.axis] = -normal[mirror.axis];
  const double turned = normal.dot(normal_of(model, *image));
  const bool same_side = (one.faces == crack->left) == (other.faces == image->left);
  if ((turned < 0.0 && same_side) || (turned > 0.0 && !same_side)) {
    return false;
  }
  return load_values_are_mirrored(mirror, one, other, face_places(model, *crack, one)) &&
         load_values_are_mirrored(mirror, other, one, face_places(model, *image, other));
}

std::string crack_symmetry_obstacle(const model::Model& model, const Reflection& mirror) {
  const auto answers = [&](std::size_t i, std::size_t j) {
    return grows(model, i) == grows(model, j) &&
           mirrored_shape(model, mirror, model.cracks[i], model.cracks[j]);
  };
  const auto lone = find_item_without_image(model.cracks.size(), answers);
  return lone ? fmt::format("crack {} is not", model.cracks[*lone].name) : std::string();
}

} // namespace spricka::sense
