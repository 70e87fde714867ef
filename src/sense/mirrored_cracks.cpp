// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/mirrored_cracks.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

constexpr double same_spot = 1e-6; // of the model's size
constexpr double same_axis = 1e-9;

std::vector<base::Vec3> points_of(const model::Model& model, const model::Crack& crack) {
  std::vector<base::Vec3> points = crack.points;
  if (crack.path.valid()) {
    for (const base::NodeId n : model.mesh.set(crack.path).nodes) {
      points.push_back(model.mesh.x[n.index()]);
    }
  }
  if (crack.angle) { // any second point tells the direction
    const double a = crack.a0.value_or(1.0);
    points.push_back(points.front() +
                     a * base::Vec3(std::cos(*crack.angle), std::sin(*crack.angle), 0.0));
  }
  return points;
}

double off_line(const base::Vec3& x, const std::vector<base::Vec3>& line) {
  double least = (x - line.front()).norm();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const base::Vec3 d = line[i] - line[i - 1];
    const double t =
        std::clamp((x - line[i - 1]).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
    least = std::min(least, (x - line[i - 1] - t * d).norm());
  }
  return least;
}

// The order of points does not matter where both ends are tips, or a front ends on both sides.
bool mirrored_line(const Mirror& mirror, const std::vector<base::Vec3>& one,
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

bool mirrored_plane(const Mirror& mirror, const model::CrackPlane& one,
                    const model::CrackPlane& other) {
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
  return model.growth && (model.growth->cracks.empty() ||
                          std::ranges::find(model.growth->cracks, base::CrackId(crack)) !=
                              model.growth->cracks.end());
}

} // namespace

std::string against_cracks(const model::Model& model, const Mirror& mirror) {
  const auto answers = [&](std::size_t i, std::size_t j) {
    const model::Crack& one = model.cracks[i];
    const model::Crack& other = model.cracks[j];
    if (one.kind != other.kind || grows(model, i) != grows(model, j) || one.mu != other.mu ||
        one.a0 != other.a0 || one.faces_in_contact != other.faces_in_contact) {
      return false;
    }
    return one.kind == model::CrackKind::ellipse
               ? mirrored_plane(mirror, one.plane, other.plane)
               : mirrored_line(mirror, points_of(model, one), points_of(model, other));
  };
  for (std::size_t i = 0; i < model.cracks.size(); ++i) {
    bool answered = false;
    for (std::size_t j = 0; j < model.cracks.size() && !answered; ++j) {
      answered = answers(i, j);
    }
    if (!answered) {
      return fmt::format("crack {} is not", model.cracks[i].name);
    }
  }
  return {};
}

} // namespace spricka::sense
