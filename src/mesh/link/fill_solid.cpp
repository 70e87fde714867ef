// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/fill_solid.hpp"

#include "mesh/link/mesher_link.hpp"
#include "mesh/link/mesher_request.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::mesh {
namespace {

using base::Vec3;
using Triangle = SolidRegion::Triangle;

void write_point(ByteWriter& out, const Vec3& p) {
  for (const double c : p) {
    out.write_value(c);
  }
}

Vec3 read_solid_point(ByteReader& in) {
  Vec3 p;
  for (double& c : p) {
    c = in.read_value<double>();
  }
  return p;
}

void write_solid_points(ByteWriter& out, const std::vector<Vec3>& points) {
  out.write_value(points.size());
  for (const Vec3& p : points) {
    write_point(out, p);
  }
}

std::vector<Vec3> read_solid_points(ByteReader& in) {
  std::vector<Vec3> points;
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    points.push_back(read_solid_point(in));
  }
  return points;
}

template <std::size_t n>
bool within(const std::vector<std::array<int, n>>& cells, std::size_t points) {
  return std::ranges::all_of(cells, [&](const std::array<int, n>& cell) {
    return std::ranges::all_of(
        cell, [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < points; });
  });
}

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Counts how often triangles are sides of the tetrahedra.
class Sides {
public:
  explicit Sides(const TetrahedronFill& filling) {
    for (const std::array<int, 4>& t : filling.tetrahedra) {
      for (std::size_t i = 0; i < 4; ++i) {
        all_.push_back(sorted({t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]}));
      }
    }
    std::sort(all_.begin(), all_.end());
  }
  [[nodiscard]] std::ptrdiff_t count(const Triangle& t) const {
    const auto [low, high] = std::equal_range(all_.begin(), all_.end(), sorted(t));
    return high - low;
  }

private:
  std::vector<Triangle> all_;
};

/// What is wrong with a filling; empty if nothing.
std::string fault_of(const SolidRegion& region, const TetrahedronFill& filling) {
  if (filling.tetrahedra.empty()) {
    return "no tetrahedra were made";
  }
  const Sides sides(filling);
  std::size_t removed = 0;
  for (const std::vector<Triangle>& shell : region.shells) {
    removed += static_cast<std::size_t>(
        std::ranges::count_if(shell, [&](const Triangle& t) { return sides.count(t) != 1; }));
  }
  removed += static_cast<std::size_t>(std::ranges::count_if(
      region.embedded, [&](const Triangle& t) { return sides.count(t) != 2; }));
  return removed == 0
             ? std::string()
             : fmt::format("{} given triangles are no sides of the tetrahedra made", removed);
}

void turn_positive(const SolidRegion& region, TetrahedronFill& filling) {
  const auto at = [&](int n) -> const Vec3& {
    const auto i = static_cast<std::size_t>(n);
    return i < region.points.size() ? region.points[i] : filling.added[i - region.points.size()];
  };
  for (std::array<int, 4>& t : filling.tetrahedra) {
    const Vec3& a = at(t[0]);
    if ((at(t[1]) - a).cross(at(t[2]) - a).dot(at(t[3]) - a) < 0.0) {
      std::swap(t[1], t[2]);
    }
  }
}

} // namespace

double SolidGrading::operator()(const Vec3& p) const {
  double least = std::numeric_limits<double>::max();
  for (const SolidSizeSource& source : sources) {
    const double beyond = std::max(0.0, (p - source.at).norm() - source.radius);
    least = std::min(least, source.size + source.growth * beyond);
  }
  return least;
}

std::string fill_solid_request(const SolidRegion& region, const SolidGrading& size) {
  ByteWriter out;
  out.write_value(MesherFrameKind::fill_solid);
  write_solid_points(out, region.points);
  out.write_value(region.shells.size());
  for (const auto& shell : region.shells) {
    out.write_list(shell);
  }
  out.write_list(region.embedded);
  out.write_value(size.sources.size());
  for (const SolidGrading::SolidSizeSource& source : size.sources) {
    write_point(out, source.at);
    out.write_value(source.radius);
    out.write_value(source.size);
    out.write_value(source.growth);
  }
  return out.release();
}

bool read_fill_solid_request(ByteReader& in, SolidRegion& region, SolidGrading& size) {
  region.points = read_solid_points(in);
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    region.shells.push_back(in.read_list<Triangle>());
  }
  region.embedded = in.read_list<Triangle>();
  for (auto count = in.read_value<std::size_t>(); count > 0 && in.is_valid(); --count) {
    SolidGrading::SolidSizeSource source;
    source.at = read_solid_point(in);
    source.radius = in.read_value<double>();
    source.size = in.read_value<double>();
    source.growth = in.read_value<double>();
    size.sources.push_back(source);
  }
  return in.at_end() && within(region.embedded, region.points.size()) &&
         std::ranges::all_of(
             region.shells, [&](const auto& shell) { return within(shell, region.points.size()); });
}

std::string fill_solid_answer(const TetrahedronFill& filling) {
  ByteWriter out;
  out.write_value(MesherFrameKind::solid_filling);
  write_solid_points(out, filling.added);
  out.write_list(filling.tetrahedra);
  out.write_text(filling.trouble);
  return out.release();
}

bool read_fill_solid_answer(ByteReader& in, const SolidRegion& region, TetrahedronFill& filling) {
  filling.added = read_solid_points(in);
  filling.tetrahedra = in.read_list<std::array<int, 4>>();
  filling.trouble = in.read_text();
  return in.at_end() && within(filling.tetrahedra, region.points.size() + filling.added.size()) &&
         std::ranges::all_of(filling.added, [](const Vec3& p) { return p.allFinite(); });
}

TetrahedronFill fill_tetrahedra(const SolidRegion& region, const SolidGrading& size) {
  const MesherAnswer answer = ask_mesher(fill_solid_request(region, size));
  TetrahedronFill filling;
  if (answer.end != MesherOutcome::answered) {
    filling.trouble = answer.trouble;
    return filling;
  }
  ByteReader in(answer.frame);
  if (in.read_value<MesherFrameKind>() != MesherFrameKind::solid_filling ||
      !read_fill_solid_answer(in, region, filling)) {
    filling = {};
    filling.trouble = "gmsh gave no mesh";
  }
  if (filling.trouble.empty()) {
    filling.trouble = fault_of(region, filling);
    turn_positive(region, filling);
  }
  if (!filling.trouble.empty()) {
    filling.added.clear();
    filling.tetrahedra.clear();
  }
  return filling;
}

} // namespace spricka::mesh
