// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generate/generate.hpp"
#include "mesh/generate/lattice.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace spricka::mesh {
namespace {

using base::Vec3;
using Point = Lattice::KeyedPoint;

constexpr int key_round_hole = 0, key_grid = 1;
constexpr double box_by_radius = 2.5;  // half side of the box of rays round the hole
constexpr double reaches_border = 1.6; // times that: no strip is left between box and border
constexpr double growth = 1.3;         // of elements from the box outwards

/// One direction of the grid that the plate beyond the box is meshed by.
struct GridLines {
  std::vector<double> x; ///< of lattice lines, two intervals for an element
  int before = 0;        ///< elements up to the box
  int inside = 0;        ///< along the box

  [[nodiscard]] int count() const { return static_cast<int>(x.size() / 2); }
};

/// The extents of the box about the hole's centre, one direction of it.
std::pair<double, double> box_extent(double low, double high, double centre, double radius) {
  const double half = box_by_radius * radius;
  const auto reach = [&](double border) { return border < reaches_border * half ? border : half; };
  return {centre - reach(centre - low), centre + reach(high - centre)};
}

/// Elements from the box to the border that grow from `first` on.
int strip_count(double length, double first) {
  return length <= 0.0
             ? 0
             : std::max(1, static_cast<int>(std::lround(
                               std::log1p((growth - 1.0) * length / first) / std::log(growth))));
}

GridLines grid_lines(double low, double high, const std::pair<double, double>& box, int inside,
                     double first) {
  GridLines lines;
  lines.inside = inside;
  lines.before = strip_count(box.first - low, first);
  const int after = strip_count(high - box.second, first);
  const auto append = [&](double from, double to, int n, double bias) {
    const std::vector<double> part =
        n > 0 ? graded_lattice_positions(n, bias) : std::vector<double>{1.0};
    for (std::size_t k = lines.x.empty() ? 0 : 1; k < part.size(); ++k) {
      lines.x.push_back(k + 1 == part.size() ? to : from + (to - from) * part[k]);
    }
  };
  append(low, box.first, lines.before, std::pow(growth, 1.0 - lines.before));
  append(box.first, box.second, inside, 1.0);
  if (after > 0) {
    append(box.second, high, after, std::pow(growth, after - 1.0));
  }
  return lines;
}

/// The plate: rays from the hole to a box about it, a grid beyond the box.
class HoledPlate {
public:
  explicit HoledPlate(const PlateSpec& spec) : spec_(spec) {
    const Vec3 high = spec.origin + spec.size;
    const auto box_x = box_extent(spec.origin.x(), high.x(), spec.hole.x(), spec.ri);
    const auto box_y = box_extent(spec.origin.y(), high.y(), spec.hole.y(), spec.ri);
    const double wide = box_x.second - box_x.first;
    const double tall = box_y.second - box_y.first;
    const int half_turn = std::max(4, (spec.nt + 1) / 2);
    const int across = std::clamp(static_cast<int>(std::lround(half_turn * wide / (wide + tall))),
                                  2, half_turn - 2);
    const double outer = 0.25 * (wide + tall);
    rays_ = graded_lattice_positions(spec.nr, std::pow(outer / spec.ri, (spec.nr - 1.0) / spec.nr));
    const double last = (outer - spec.ri) * (1.0 - rays_[rays_.size() - 3]);
    const double first = std::max(last, std::max(wide / across, tall / (half_turn - across)));
    x_ = grid_lines(spec.origin.x(), high.x(), box_x, across, first);
    y_ = grid_lines(spec.origin.y(), high.y(), box_y, half_turn - across, first);
  }

  [[nodiscard]] int round() const { return 2 * (x_.inside + y_.inside); }
  [[nodiscard]] double cells() const {
    return static_cast<double>(x_.count()) * y_.count() + static_cast<double>(spec_.nr) * round();
  }

  void build(Lattice& lattice, const std::string& prefix) {
    for (int j = 0; j < round(); ++j) {
      for (int i = 0; i < spec_.nr; ++i) {
        const auto side = lattice.add_cell(i, j, [&](int u, int v) { return ray_point(u, v); });
        if (i == 0) {
          bore_.push_back(side[3]);
        }
        if (i == spec_.nr - 1) {
          note_box_side(j, side[1]);
        }
      }
    }
    for (int j = 0; j < y_.count(); ++j) {
      for (int i = 0; i < x_.count(); ++i) {
        if (!inside(x_, i) || !inside(y_, j)) {
          const auto side = lattice.add_cell(i, j, [&](int u, int v) { return grid_point(u, v); });
          note(i, j, side);
        }
      }
    }
    lattice.add_body_set(prefix);
    lattice.add_face_set(prefix + "BORE", std::move(bore_));
    static constexpr std::array<const char*, 4> names{"YMIN", "XMAX", "YMAX", "XMIN"};
    for (const std::size_t s : {3U, 1U, 0U, 2U}) {
      lattice.add_face_set(prefix + names[s], std::move(borders_[s]));
    }
  }

private:
  static bool inside(const GridLines& lines, int k) {
    return k >= lines.before && k < lines.before + lines.inside;
  }

  void note(int i, int j, const std::array<model::Face, 4>& side) {
    const std::array<bool, 4> outside{j == 0, i == x_.count() - 1, j == y_.count() - 1, i == 0};
    for (std::size_t s = 0; s < 4; ++s) {
      if (outside[s]) {
        borders_[s].push_back(side[s]);
      }
    }
  }

  /// The side of a ray's last element, where the box reaches a border of the plate.
  void note_box_side(int j, model::Face face) {
    const auto [u, v] = on_box(2 * j + 1);
    const std::array<bool, 4> outside{v == 0, u == 2 * x_.count(), v == 2 * y_.count(), u == 0};
    for (std::size_t s = 0; s < 4; ++s) {
      if (outside[s]) {
        borders_[s].push_back(face);
      }
    }
  }

  /// Lattice lines of the grid through point j of the box: from its lower corner at +x up, then
  /// along the top, down at -x and along the bottom.
  [[nodiscard]] std::pair<int, int> on_box(int j) const {
    const int left = 2 * x_.before;
    const int low = 2 * y_.before;
    const int wide = 2 * x_.inside;
    const int tall = 2 * y_.inside;
    int k = j % (2 * round());
    if (k < tall) {
      return {left + wide, low + k};
    }
    k -= tall;
    if (k < wide) {
      return {left + wide - k, low + tall};
    }
    k -= wide;
    if (k < tall) {
      return {left, low + tall - k};
    }
    return {left + (k - tall), low};
  }

  [[nodiscard]] Point grid_point(int u, int v) const {
    return {{key_grid, u, v, 0},
            {x_.x[static_cast<std::size_t>(u)], y_.x[static_cast<std::size_t>(v)], 0.0}};
  }

  /// Elements round the hole are all of one size; those of the side at +x lie about its middle.
  [[nodiscard]] Point ray_point(int i, int j) const {
    const auto [u, v] = on_box(j);
    Point outer = grid_point(u, v);
    if (i == 2 * spec_.nr) {
      return outer;
    }
    const int k = j % (2 * round());
    const Vec3 bore = spec_.hole + spec_.ri * unit_direction(std::numbers::pi * (k - y_.inside) /
                                                             static_cast<double>(round()));
    const double s = rays_[static_cast<std::size_t>(i)];
    return {{key_round_hole, i, k, 0}, (1.0 - s) * bore + s * outer.x};
  }

  const PlateSpec& spec_;
  std::vector<double> rays_;
  GridLines x_, y_;
  std::vector<model::Face> bore_;
  std::array<std::vector<model::Face>, 4> borders_; ///< YMIN XMAX YMAX XMIN, as sides of a cell
};

} // namespace

void generate_plate(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                    const PlateSpec& spec) {
  Lattice lattice(mesh, net, spec.type);
  HoledPlate(spec).build(lattice, prefix);
}

double plate_cell_count(const PlateSpec& spec) {
  constexpr double most_laid_out = 1e8;
  const double round_hole = static_cast<double>(spec.nr) * spec.nt;
  return round_hole > most_laid_out ? round_hole : HoledPlate(spec).cells();
}

} // namespace spricka::mesh
