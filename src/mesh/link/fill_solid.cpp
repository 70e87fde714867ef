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
    out.one(c);
  }
}

Vec3 read_solid_point(ByteReader& in) {
  Vec3 p;
  for (double& c : p) {
    c = in.one<double>();
  }
  return p;
}

void write_solid_points(ByteWriter& out, const std::vector<Vec3>& points) {
  out.one(points.size());
  for (const Vec3& p : points) {
    write_point(out, p);
  }
}

std::vector<Vec3> read_solid_points(ByteReader& in) {
  std::vector<Vec3> points;
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
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
  explicit Sides(const SolidFilling& filling) {
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
std::string fault_of(const SolidRegion& region, const SolidFilling& filling) {
  if (filling.tetrahedra.empty()) {
    return "no tetrahedra were made";
  }
  const Sides sides(filling);
  std::size_t lost = 0;
  for (const std::vector<Triangle>& shell : region.shells) {
    lost += static_cast<std::size_t>(
        std::ranges::count_if(shell, [&](const Triangle& t) { return sides.count(t) != 1; }));
  }
  lost += static_cast<std::size_t>(std::ranges::count_if(
      region.embedded, [&](const Triangle& t) { return sides.count(t) != 2; }));
  return lost == 0 ? std::string()
                   : fmt::format("{} given triangles are no sides of the tetrahedra made", lost);
}

void turn_positive(const SolidRegion& region, SolidFilling& filling) {
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
  for (const Source& source : sources) {
    const double beyond = std::max(0.0, (p - source.at).norm() - source.radius);
    least = std::min(least, source.size + source.growth * beyond);
  }
  return least;
}

std::string fill_solid_request(const SolidRegion& region, const SolidGrading& size) {
  ByteWriter out;
  out.one(MesherFrame::fill_solid);
  write_solid_points(out, region.points);
  out.one(region.shells.size());
  for (const auto& shell : region.shells) {
    out.list(shell);
  }
  out.list(region.embedded);
  out.one(size.sources.size());
  for (const SolidGrading::Source& source : size.sources) {
    write_point(out, source.at);
    out.one(source.radius);
    out.one(source.size);
    out.one(source.growth);
  }
  return out.take();
}

bool read_fill_solid_request(ByteReader& in, SolidRegion& region, SolidGrading& size) {
  region.points = read_solid_points(in);
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    region.shells.push_back(in.list<Triangle>());
  }
  region.embedded = in.list<Triangle>();
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    SolidGrading::Source source;
    source.at = read_solid_point(in);
    source.radius = in.one<double>();
    source.size = in.one<double>();
    source.growth = in.one<double>();
    size.sources.push_back(source);
  }
  return in.at_end() && within(region.embedded, region.points.size()) &&
         std::ranges::all_of(
             region.shells, [&](const auto& shell) { return within(shell, region.points.size()); });
}

std::string fill_solid_answer(const SolidFilling& filling) {
  ByteWriter out;
  out.one(MesherFrame::solid_filling);
  write_solid_points(out, filling.added);
  out.list(filling.tetrahedra);
  out.text(filling.trouble);
  return out.take();
}

bool read_fill_solid_answer(ByteReader& in, const SolidRegion& region, SolidFilling& filling) {
  filling.added = read_solid_points(in);
  filling.tetrahedra = in.list<std::array<int, 4>>();
  filling.trouble = in.text();
  return in.at_end() && within(filling.tetrahedra, region.points.size() + filling.added.size()) &&
         std::ranges::all_of(filling.added, [](const Vec3& p) { return p.allFinite(); });
}

SolidFilling fill_solid(const SolidRegion& region, const SolidGrading& size) {
  const MesherAnswer answer = ask_mesher(fill_solid_request(region, size));
  SolidFilling filling;
  if (answer.end != MesherEnd::answered) {
    filling.trouble = answer.trouble;
    return filling;
  }
  ByteReader in(answer.frame);
  if (in.one<MesherFrame>() != MesherFrame::solid_filling ||
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
