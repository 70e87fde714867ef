// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generate/generate.hpp"

#include "mesh/generate/lattice.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace spricka::mesh {
namespace {

using base::NodeId;
using base::Vec3;
using Key = Lattice::Key;
using Point = Lattice::KeyedPoint;

using std::numbers::pi;

double at(const std::vector<double>& lines, int k) {
  return lines[static_cast<std::size_t>(k)];
}

/// What the parts of a ring or disc share: angles of the 2 nt lattice rays.
struct Turn {
  Vec3 centre;
  double t0, angle;
  int nt;
  bool closed;

  explicit Turn(const RingSpec& spec)
      : centre(spec.x0, spec.y0, 0.0), t0(spec.t0), angle(spec.t1 - spec.t0), nt(spec.nt),
        closed(std::abs(angle - 2.0 * pi) < 1e-9) {
    assert(angle > 0.0 && angle < 2.0 * pi + 1e-9);
  }
  [[nodiscard]] Vec3 ray(int j) const { return unit_direction(t0 + angle * j / (2.0 * nt)); }
  [[nodiscard]] int wrap(int j) const { return closed ? j % (2 * nt) : j; }
};

constexpr int key_ring = 0, key_core = 1, key_ray = 2, key_centre = 3, key_edge = 4;

void add_annulus(Lattice& lattice, const RingSpec& spec, const std::string& prefix) {
  const Turn turn(spec);
  const std::vector<double> s = graded_lattice_positions(spec.nr, spec.bias);
  const auto map = [&](int i, int j) {
    const double r = i == 2 * spec.nr ? spec.ro : spec.ri + (spec.ro - spec.ri) * at(s, i);
    return Point{{key_ring, i, turn.wrap(j), 0}, turn.centre + r * turn.ray(j)};
  };
  std::vector<model::Face> inner;
  std::vector<model::Face> outer;
  for (int j = 0; j < spec.nt; ++j) {
    for (int i = 0; i < spec.nr; ++i) {
      const std::array<model::Face, 4> side = lattice.add_cell(i, j, map);
      if (i == 0) {
        inner.push_back(side[3]);
      }
      if (i == spec.nr - 1) {
        outer.push_back(side[1]);
      }
    }
  }
  lattice.add_face_set(prefix + "INNER", std::move(inner));
  lattice.add_face_set(prefix + "OUTER", std::move(outer));
}

/// Number of equal sectors into which a disc of quadrilaterals falls, each with a core of rhombic
/// shape and an even number of rim elements; 0 if the number of rim elements allows none.
int sector_count(const Turn& turn) {
  int best = 0;
  double best_off = 0.0;
  for (int m = 1; m <= 8; ++m) {
    const double off = std::abs(turn.angle / m - 0.5 * pi);
    if (turn.nt % (2 * m) == 0 && off < pi / 3.0 && (best == 0 || off < best_off)) {
      best = m;
      best_off = off;
    }
  }
  return best;
}

/// A disc or a sector of quadrilaterals: rhombic cores round the centre, rings outside them.
class QuadDisc {
public:
  QuadDisc(const RingSpec& spec, int sectors)
      : spec_(spec), turn_(spec), sectors_(sectors), n_(spec.nt / (2 * sectors)),
        lines_(graded_lattice_positions(spec.nr, spec.bias)) {
    // core so large that its elements are about as long as those of the rings
    core_ = std::clamp(1.0 / (1.0 + spec.nr / static_cast<double>(n_) / 1.2), 0.4, 0.75);
  }

  std::vector<model::Face> build(Lattice& lattice) const {
    for (int k = 0; k < sectors_; ++k) {
      for (int j = 0; j < n_; ++j) {
        for (int i = 0; i < n_; ++i) {
          lattice.add_cell(i, j, [&](int u, int v) { return core(k, u, v); });
        }
      }
    }
    std::vector<model::Face> outer;
    for (int j = 0; j < spec_.nt; ++j) {
      for (int i = 0; i < spec_.nr; ++i) {
        const auto side = lattice.add_cell(i, j, [&](int u, int v) { return ring(u, v); });
        if (i == spec_.nr - 1) {
          outer.push_back(side[1]);
        }
      }
    }
    return outer;
  }

private:
  [[nodiscard]] Vec3 corner(int k, double half) const { // on the rays of sector k: 0, 1/2, 1
    const bool mid = half == 0.5;
    return spec_.ro * core_ * (mid ? 1.15 : 1.0) *
           turn_.ray(static_cast<int>(std::lround((k + half) * 4 * n_)));
  }
  /// Core of sector k: u towards its first ray, v towards its last one.
  [[nodiscard]] Point core(int k, int u, int v) const {
    const double a = u / (2.0 * n_);
    const double b = v / (2.0 * n_);
    const Vec3 x = turn_.centre + a * (1.0 - b) * corner(k, 0.0) + a * b * corner(k, 0.5) +
                   (1.0 - a) * b * corner(k, 1.0);
    if (u == 0 && v == 0) {
      return {{key_centre, 0, 0, 0}, turn_.centre};
    }
    if (u == 2 * n_) {
      return {{key_ring, 0, turn_.wrap(4 * n_ * k + v), 0}, x};
    }
    if (v == 2 * n_) {
      return {{key_ring, 0, turn_.wrap(4 * n_ * (k + 1) - u), 0}, x};
    }
    if (v == 0) {
      return {{key_ray, k, u, 0}, x};
    }
    if (u == 0) {
      return {{key_ray, turn_.closed ? (k + 1) % sectors_ : k + 1, v, 0}, x};
    }
    return {{key_core, k, u, v}, x};
  }
  [[nodiscard]] Point ring(int i, int j) const {
    const int k = std::min(j / (4 * n_), sectors_ - 1);
    const int within = j - 4 * n_ * k;
    const Vec3 inner =
        within <= 2 * n_ ? core(k, 2 * n_, within).x : core(k, 4 * n_ - within, 2 * n_).x;
    const Vec3 outer = turn_.centre + spec_.ro * turn_.ray(j);
    const double s = at(lines_, i);
    return {{key_ring, i, turn_.wrap(j), 0},
            i == 2 * spec_.nr ? outer : Vec3((1.0 - s) * inner + s * outer)};
  }

  const RingSpec& spec_;
  Turn turn_;
  int sectors_;
  int n_; ///< elements along one side of a core
  double core_ = 0.5;
  std::vector<double> lines_;
};

/// A disc or a sector of triangles: circles with fewer and fewer nodes towards the centre, zipped
/// together.
class TriangleDisc {
public:
  explicit TriangleDisc(const RingSpec& spec)
      : spec_(spec), turn_(spec), lines_(graded_lattice_positions(spec.nr, spec.bias)) {
    const auto circles = static_cast<std::size_t>(spec.nr);
    count_.assign(circles + 1, spec.nt);
    for (std::size_t k = circles - 1; k >= 1; --k) {
      const double height =
          at(lines_, static_cast<int>(2 * k)) - at(lines_, static_cast<int>(2 * k - 2));
      const int even =
          static_cast<int>(std::lround(turn_.angle * at(lines_, static_cast<int>(2 * k)) / height));
      const int least = std::max((count_[k + 1] + 1) / 2, turn_.closed ? 3 : 1);
      count_[k] = std::clamp(even, least, count_[k + 1]);
    }
    count_[0] = 0;
  }

  std::vector<model::Face> build(Lattice& lattice) const {
    std::vector<model::Face> outer;
    for (int k = 1; k <= spec_.nr; ++k) {
      const int ni = count(k - 1);
      const int no = count(k);
      for (int i = 0, j = 0; i < ni || j < no;) {
        if (i == ni || (j < no && (2L * j + 1) * ni <= (2L * i + 1) * no)) {
          const base::ElementId e = add(lattice, {{{k - 1, i}, {k, j}, {k, j + 1}}});
          if (k == spec_.nr) {
            outer.push_back({e, 1});
          }
          ++j;
        } else {
          add(lattice, {{{k - 1, i}, {k, j}, {k - 1, i + 1}}});
          ++i;
        }
      }
    }
    return outer;
  }

private:
  using Place = std::pair<int, int>; ///< circle, number on it

  [[nodiscard]] int count(int k) const { return count_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] Vec3 on_rim(double part) const {
    return turn_.centre + spec_.ro * unit_direction(turn_.t0 + turn_.angle * part);
  }
  [[nodiscard]] Point point(const Place& p) const {
    const auto [k, i] = p;
    if (k == 0) {
      return {{key_centre, 0, 0, 0}, turn_.centre};
    }
    const double part = static_cast<double>(i) / count(k);
    const Vec3 rim = on_rim(part);
    const int number = turn_.closed ? i % count(k) : i;
    return {{key_ring, k, number, 0},
            k == spec_.nr ? rim : Vec3(turn_.centre + at(lines_, 2 * k) * (rim - turn_.centre))};
  }
  base::ElementId add(Lattice& lattice, const std::array<Place, 3>& p) const {
    std::array<NodeId, 3> corner;
    std::array<Point, 3> mid;
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = lattice.find_or_add_node(point(p[c]));
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3;
      const bool rim = p[c].first == spec_.nr && p[d].first == spec_.nr;
      const auto [low, high] = std::minmax(corner[c], corner[d]);
      mid[c].key = {key_edge, low.value, high.value, 0};
      mid[c].x = rim ? on_rim((p[c].second + 0.5) / spec_.nt)
                     : Vec3(0.5 * (point(p[c]).x + point(p[d]).x));
    }
    return lattice.add_triangle(corner, mid);
  }

  const RingSpec& spec_;
  Turn turn_;
  std::vector<double> lines_;
  std::vector<int> count_; ///< [circle] elements round it
};

} // namespace

void generate_block(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                    const BlockSpec& spec) {
  Lattice lattice(mesh, net, spec.type);
  const std::vector<double> sx = graded_lattice_positions(spec.nx, spec.bias);
  const std::vector<double> sy = graded_lattice_positions(spec.ny, 1.0);
  const auto map = [&](int i, int j) {
    return Point{{0, i, j, 0},
                 spec.origin + Vec3(spec.size.x() * at(sx, i), spec.size.y() * at(sy, j), 0.0)};
  };
  std::array<std::vector<model::Face>, 4> sets; // YMIN XMAX YMAX XMIN, as the sides of a cell
  for (int j = 0; j < spec.ny; ++j) {
    for (int i = 0; i < spec.nx; ++i) {
      const std::array<model::Face, 4> side = lattice.add_cell(i, j, map);
      const std::array<bool, 4> outside{j == 0, i == spec.nx - 1, j == spec.ny - 1, i == 0};
      for (std::size_t s = 0; s < 4; ++s) {
        if (outside[s]) {
          sets[s].push_back(side[s]);
        }
      }
    }
  }
  lattice.add_body_set(prefix);
  lattice.add_face_set(prefix + "XMIN", std::move(sets[3]));
  lattice.add_face_set(prefix + "XMAX", std::move(sets[1]));
  lattice.add_face_set(prefix + "YMIN", std::move(sets[0]));
  lattice.add_face_set(prefix + "YMAX", std::move(sets[2]));
}

void generate_ring(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                   const RingSpec& spec) {
  Lattice lattice(mesh, net, spec.type);
  if (spec.ri > 0.0) {
    add_annulus(lattice, spec, prefix);
  } else {
    const int sectors = base::element_info(spec.type).corners == 4 ? sector_count(Turn(spec)) : 0;
    std::vector<model::Face> outer =
        sectors > 0 ? QuadDisc(spec, sectors).build(lattice) : TriangleDisc(spec).build(lattice);
    lattice.add_face_set(prefix + "OUTER", std::move(outer));
  }
  lattice.add_body_set(prefix);
}

bool divides_into_quadrilaterals(const RingSpec& disc) {
  return sector_count(Turn(disc)) > 0;
}

} // namespace spricka::mesh
