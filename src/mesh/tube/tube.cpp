// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/tube/tube.hpp"

#include "mesh/plane.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace spricka::mesh {
namespace {

using base::Vec2;
using base::Vec3;

// Measured on pennies and ellipses, a/c down to 0.2: K within 0.7 % everywhere.
constexpr double radius_of_width = 0.1;
constexpr double radius_of_curvature = 0.5;
// Layers of tetrahedra reach as far as 2 radii: all within the centre of curvature.
constexpr double free_of_curvature = 0.33;
constexpr double radius_of_room = 0.4;
/// Domains of K reach over the tetrahedra beside the tube, and faces are straight in them.
constexpr double radius_of_straight = 0.5;
/// Of a square of the length over radius and radius of curvature: wedges at the front, a third of
/// the radius wide with nodes at a quarter of that, hold what the front bends by between corners.
constexpr double length_of_arc = 0.2;
constexpr double length_of_width = 0.15;
constexpr double length_of_curvature = 0.25;
constexpr double shortest = 0.5; // element over radius of the tube
constexpr double longest = 3.0;
constexpr double steepest = 0.2; // change of a size for each length along the front
// Where a front leaves the body K varies over short ways: corner cracks at bores, 0.5 % at 10 and
// 80 degrees.
constexpr double length_at_surface = 0.05; // of width and radius of curvature
constexpr double growth_from_surface = 0.3;
constexpr double shortest_at_surface = 0.2;

// Sections run together by the curvature and by the shear at leaning ends; this part of a length
// along the front they may lose, together.
constexpr double most_run_together = 0.85;
constexpr double steepest_shear = 1.5; // of the shear over its reach
constexpr double fewest_radii = 3.0;   // of that reach

constexpr std::size_t samples = 1024;
constexpr std::size_t fewest_of_closed = 8; // elements round a closed front
/// Of an open one, so that it has a point inside the body: K has no limit where a front leaves it.
constexpr std::size_t fewest_of_open = 2;

/// No size changes faster along the front than `steepest`.
void smooth(std::vector<double>& size, double step, bool closed, double slope = steepest) {
  const double most = slope * step;
  const std::size_t n = size.size();
  for (int round = 0; round < (closed ? 2 : 1); ++round) {
    for (std::size_t i = 1; i < n; ++i) {
      size[i] = std::min(size[i], size[i - 1] + most);
    }
    for (std::size_t i = n - 1; i-- > 0;) {
      size[i] = std::min(size[i], size[i + 1] + most);
    }
    if (closed) {
      size.front() = size.back() = std::min(size.front(), size.back());
    }
  }
}

/// Length along the front over which the shear of an end fades, `sheared` at most; its steepest
/// slope is 3/2 of the shear over it.
double shear_fade_length(double radius, double sheared, double front_length) {
  return std::min(fewest_radii * std::max(radius, sheared), 0.5 * front_length);
}

/// Of an open front near the end `from_end` away, for sections not to meet; no limit farther in.
double radius_by_shear(double lean, double from_end, double bend, double length) {
  const double most = most_run_together - steepest_shear / fewest_radii * std::min(1.0, lean);
  const double radius = std::min(bend > 0.0 ? most / bend : std::numeric_limits<double>::max(),
                                 most_run_together / (bend + 2.0 * steepest_shear * lean / length));
  return from_end < shear_fade_length(radius, lean * radius, length)
             ? radius
             : std::numeric_limits<double>::max();
}

} // namespace

double TubeSizes::radius_at(double at) const {
  const double step = s[1] - s[0];
  const double place = std::clamp((at - s[0]) / step, 0.0, static_cast<double>(s.size() - 1));
  const auto i = std::min(static_cast<std::size_t>(place), s.size() - 2);
  const double part = place - static_cast<double>(i);
  return (1.0 - part) * radius[i] + part * radius[i + 1];
}

std::vector<double> TubeSizes::cumulative_element_counts() const {
  std::vector<double> number{0.0};
  for (std::size_t i = 1; i < s.size(); ++i) {
    number.push_back(number.back() +
                     0.5 * (s[i] - s[i - 1]) * (1.0 / length[i] + 1.0 / length[i - 1]));
  }
  return number;
}

std::vector<double> TubeSizes::stations(bool closed) const {
  const std::vector<double> number = cumulative_element_counts();
  const auto wanted = static_cast<std::size_t>(std::ceil(number.back() - coordinate_tolerance));
  const std::size_t elements =
      std::max<std::size_t>(wanted, closed ? fewest_of_closed : fewest_of_open);
  std::vector<double> result{s.front()};
  std::size_t i = 1;
  for (std::size_t k = 1; k < elements; ++k) {
    const double at = number.back() * static_cast<double>(k) / static_cast<double>(elements);
    while (number[i] < at) {
      ++i;
    }
    result.push_back(s[i - 1] +
                     (s[i] - s[i - 1]) * (at - number[i - 1]) / (number[i] - number[i - 1]));
  }
  if (!closed) {
    result.push_back(s.back());
  }
  return result;
}

TubeSizes choose_tube_sizes(const FrontCurve& curve, const TubeClearanceAlongFront& room,
                            const TubeMeshParameters& given) {
  TubeSizes sizes;
  const double step = curve.length() / static_cast<double>(samples);
  for (std::size_t i = 0; i <= samples; ++i) {
    const FrontFrame frame = curve.at(static_cast<double>(i) * step);
    const double width = room.width(frame.s);
    const double bend = std::abs(frame.curvature());
    const double round = bend > 0.0 ? 1.0 / bend : std::numeric_limits<double>::max();
    sizes.s.push_back(static_cast<double>(i) * step);
    sizes.room.push_back(room.free(frame.s));
    double radius = given.radius;
    if (radius <= 0.0) {
      radius = given.size > 0.0 ? given.size * given.rings : radius_of_width * width;
      const double bent = given.tube ? radius_of_curvature : free_of_curvature;
      radius = std::min({radius, bent * round, radius_of_room * sizes.room.back()});
      if (room.straight) {
        radius = std::min(radius, radius_of_straight * room.straight(frame.s));
      }
      for (const std::size_t end : {0U, 1U}) {
        const double from_end = end == 0 ? frame.s : curve.length() - frame.s;
        if (given.tube && !curve.closed()) {
          radius =
              std::min(radius, radius_by_shear(room.lean[end], from_end, bend, curve.length()));
        }
      }
    }
    sizes.radius.push_back(radius / given.finer);
    double length = std::min(length_of_width * width, length_of_curvature * round);
    if (!curve.closed()) {
      const double from_end = std::min(frame.s, curve.length() - frame.s);
      length = std::min(length, length_at_surface * std::min(width, round) +
                                    growth_from_surface * std::max(from_end, 0.0));
    }
    sizes.length.push_back((given.length > 0.0 ? given.length : length) / given.finer);
  }
  smooth(sizes.radius, step, curve.closed());
  smooth(sizes.length, step, curve.closed(), curve.closed() ? steepest : growth_from_surface);
  if (given.length <= 0.0) {
    const double least = curve.closed() ? shortest : shortest_at_surface;
    for (std::size_t i = 0; i < sizes.s.size(); ++i) {
      sizes.length[i] =
          std::clamp(sizes.length[i], least * sizes.radius[i], longest * sizes.radius[i]);
      if (room.straight) { // thin for its bends
        const double all_bends = curve.at(sizes.s[i]).dt.norm();
        sizes.length[i] =
            std::min(sizes.length[i], std::sqrt(length_of_arc * sizes.radius[i] /
                                                std::max(all_bends, coordinate_tolerance)));
      }
    }
  }
  return sizes;
}

namespace {

/// Radii of the rings, 1 outside: the first as wide as given, the others linearly wider or
/// narrower.
std::vector<double> rings_of(const TubeMeshParameters& given, double radius) {
  const double n = given.rings;
  // All of one width if nothing is given; a ring keeps some width.
  const double first =
      given.size > 0.0 && n > 1 ? std::clamp(given.size / radius, 0.2 / n, 1.6 / n) : 1.0 / n;
  std::vector<double> result{0.0};
  for (int k = 1; k <= given.rings; ++k) {
    const double more = n > 1 ? (1.0 - n * first) * k * (k - 1) / (n * (n - 1)) : 0.0;
    result.push_back(first * k + more);
  }
  result.back() = 1.0;
  return result;
}

/// Cosine of the angle between normals of a crack that lies in one plane.
constexpr double in_one_plane = 1.0 - 1e-12;

/// Nodes stand on a lattice: station, angle and ring, the odd ones between elements' corners.
class TubeBuilder {
public:
  TubeBuilder(const FrontCurve& curve, const TubeSizes& sizes, const TubeMeshParameters& given,
              const DistanceToSurface& to_surface)
      : curve_(curve), given_(given), to_surface_(to_surface) {
    tube_.closed = curve.closed();
    const std::vector<double> at = sizes.stations(curve.closed());
    for (const double s : at) {
      tube_.stations.push_back(curve.at(s));
      tube_.radius.push_back(sizes.radius_at(s));
      rings_.push_back(rings_of(given, tube_.radius.back()));
      tube_.size.push_back(rings_.back()[1] * tube_.radius.back());
    }
    segments_ = static_cast<int>(tube_.closed ? at.size() : at.size() - 1);
    for (int i = 0; i < segments_; ++i) {
      const double end = station(i + 1) == 0 ? curve.length() : at[station(i + 1)];
      between_.push_back(curve.at(0.5 * (at[station(i)] + end)));
    }
    twisted_ = std::ranges::any_of(tube_.stations, [&](const FrontFrame& frame) {
      return frame.b.dot(tube_.stations.front().b) < in_one_plane;
    });
  }

  Tube build() {
    for (int i = 0; i < segments_; ++i) {
      for (int j = 0; j < given_.sectors; ++j) {
        wedge(2 * i, 2 * j);
        for (int k = 1; k < given_.rings; ++k) {
          brick(2 * i, 2 * j, 2 * k);
        }
        outer(2 * i, 2 * j);
      }
    }
    lines();
    return std::move(tube_);
  }

private:
  using Key = std::array<int, 3>;

  [[nodiscard]] std::size_t station(int i) const {
    return static_cast<std::size_t>(i) % tube_.stations.size();
  }
  /// Place of a corner of the lattice across the front.
  [[nodiscard]] Vec2 corner(std::size_t at, int sector, int ring) const {
    const double r = tube_.radius[at] * rings_[at][static_cast<std::size_t>(ring)];
    if (sector == 0 || sector == given_.sectors) { // the crack: no round-off leads off its plane
      return {-r, 0.0};
    }
    const double angle = std::numbers::pi * (2.0 * sector / given_.sectors - 1.0);
    return {r * std::cos(angle), r * std::sin(angle)};
  }
  /// At a station, between corners of which one or none of the two is odd.
  [[nodiscard]] Vec2 across(std::size_t at, int j, int l) const {
    if (j % 2 != 0) { // on the chord
      return 0.5 * (corner(at, j / 2, l / 2) + corner(at, j / 2 + 1, l / 2));
    }
    if (l == 1) {
      return (given_.quarter_point ? 0.25 : 0.5) * corner(at, j / 2, 1);
    }
    return l % 2 == 0 ? corner(at, j / 2, l / 2)
                      : Vec2(0.5 * (corner(at, j / 2, l / 2) + corner(at, j / 2, l / 2 + 1)));
  }

  int node(int i, int j, int l) {
    if (tube_.closed) {
      i %= 2 * segments_;
    }
    const Key key{i, l == 0 ? 0 : j, l};
    const auto [at, fresh] = known_.try_emplace(key, static_cast<int>(tube_.x.size()));
    if (fresh) {
      const bool middle = i % 2 != 0;
      if (middle && l == 2 && twisted_) {
        tube_.x.push_back(beside_front(i, j));
        return at->second;
      }
      const FrontFrame& frame =
          middle ? between_[static_cast<std::size_t>(i / 2)] : tube_.stations[station(i / 2)];
      const Vec2 yz =
          middle ? Vec2(0.5 * (across(station(i / 2), j, l) + across(station(i / 2 + 1), j, l)))
                 : across(station(i / 2), j, l);
      tube_.x.emplace_back(frame.x + yz.x() * frame.m + yz.y() * frame.b +
                           shift(frame.s, j, l) * frame.t);
    }
    return at->second;
  }

  /// Of a crack that has turned, half way along the first ring: as far from the front as at both
  /// ends on the mean. Wedges with nodes at a quarter of it would else fold at the front, by what
  /// axes that turn about it do to the third order.
  Vec3 beside_front(int i, int j) {
    Vec3 offset = Vec3::Zero();
    for (const int end : {i - 1, i + 1}) {
      const FrontFrame& frame = tube_.stations[station(end / 2)];
      const Vec2 yz = across(station(end / 2), j, 2);
      offset += 0.5 * (yz.x() * frame.m + yz.y() * frame.b + shift(frame.s, j, 2) * frame.t);
    }
    return between_[static_cast<std::size_t>(i / 2)].x + offset;
  }

  /// How far a node is moved along the front, for the ends to lie on the surface.
  double shift(double s, int j, int l) {
    if (tube_.closed || l == 0) {
      return 0.0;
    }
    double sum = 0.0;
    for (const std::size_t end : {0U, 1U}) {
      const std::size_t at = end == 0 ? 0 : tube_.stations.size() - 1;
      const double reach = shear_fade_length(tube_.radius[at], most_sheared(end), curve_.length());
      const double u = std::abs(s - tube_.stations[at].s) / reach;
      if (u < 1.0) {
        sum += (1.0 - u) * (1.0 - u) * (1.0 + 2.0 * u) * end_shift(end, j, l);
      }
    }
    return sum;
  }
  /// Of all places of the outside.
  double most_sheared(std::size_t end) {
    double most = 0.0;
    for (int j = 0; j <= 2 * given_.sectors; ++j) {
      most = std::max(most, std::abs(end_shift(end, j, 2 * given_.rings)));
    }
    return most;
  }
  double end_shift(std::size_t end, int j, int l) {
    const auto [known, fresh] = end_shift_.try_emplace({static_cast<int>(end), j, l}, 0.0);
    if (fresh) {
      const std::size_t at = end == 0 ? 0 : tube_.stations.size() - 1;
      const FrontFrame& frame = tube_.stations[at];
      const Vec2 yz = across(at, j, l);
      const Vec3 place = frame.x + yz.x() * frame.m + yz.y() * frame.b;
      const auto along = to_surface_(place, frame.t);
      if (!along) {
        tube_.off_surface = place;
      }
      known->second = along.value_or(0.0);
    }
    return known->second;
  }

  void wedge(int i, int j) {
    const auto n = [&](int di, int dj, int dl) { return node(i + di, j + dj, dl); };
    tube_.elements.push_back({base::ElementType::pentac15,
                              {n(0, 0, 0), n(0, 0, 2), n(0, 2, 2), n(2, 0, 0), n(2, 0, 2),
                               n(2, 2, 2), n(0, 0, 1), n(0, 1, 2), n(0, 2, 1), n(2, 0, 1),
                               n(2, 1, 2), n(2, 2, 1), n(1, 0, 0), n(1, 0, 2), n(1, 2, 2)}});
    faces(i, j, 2);
  }
  void brick(int i, int j, int l) {
    const auto n = [&](int di, int dj, int dl) { return node(i + di, j + dj, l + dl); };
    tube_.elements.push_back(
        {base::ElementType::hexec20,
         {n(0, 0, 0), n(0, 0, 2), n(0, 2, 2), n(0, 2, 0), n(2, 0, 0), n(2, 0, 2), n(2, 2, 2),
          n(2, 2, 0), n(0, 0, 1), n(0, 1, 2), n(0, 2, 1), n(0, 1, 0), n(2, 0, 1), n(2, 1, 2),
          n(2, 2, 1), n(2, 1, 0), n(1, 0, 0), n(1, 0, 2), n(1, 2, 2), n(1, 2, 0)}});
    faces(i, j, 2);
  }
  /// Sides of the element just made that lie on the crack: `low` where the angle is lower, two more
  /// where it is higher; and those on ends: 0 and 1, of wedges and bricks alike.
  void faces(int i, int j, int low) {
    const std::size_t element = tube_.elements.size() - 1;
    if (j == 0) {
      tube_.lower_sides.push_back({element, low});
    }
    if (j == 2 * (given_.sectors - 1)) {
      tube_.upper_sides.push_back({element, low + 2});
    }
    if (!tube_.closed && i == 0) {
      tube_.ends[0].sides.push_back({element, 0});
    }
    if (!tube_.closed && i == 2 * (segments_ - 1)) {
      tube_.ends[1].sides.push_back({element, 1});
    }
  }
  void outer(int i, int j) {
    const int l = 2 * given_.rings;
    tube_.outer.push_back(
        {{node(i, j, l), node(i, j + 2, l), node(i + 2, j + 2, l), node(i + 2, j, l)},
         {node(i, j + 1, l), node(i + 1, j + 2, l), node(i + 2, j + 1, l), node(i + 1, j, l)}});
  }

  void lines() {
    const int l = 2 * given_.rings;
    const int end = 2 * given_.sectors;
    for (int i = 0; i < static_cast<int>(tube_.stations.size()); ++i) {
      tube_.front.push_back(node(2 * i, 0, 0));
      tube_.upper.push_back(node(2 * i, end, l));
      tube_.lower.push_back(node(2 * i, 0, l));
    }
    for (const std::size_t e : {0U, 1U}) {
      const int i = e == 0 ? 0 : 2 * segments_;
      for (int j = 0; j < end && !tube_.closed; j += 2) {
        tube_.ends[e].corner.push_back(node(i, j, l));
      }
    }
    // All nodes at the first angle, and those at the last.
    for (const auto& [key, n] : known_) {
      const auto& [i, j, ring] = key;
      if (j == 0) {
        twins_.emplace_back(ring == 0 ? n : known_.at({i, end, ring}), n);
      }
    }
    tube_.twins = std::move(twins_);
  }

  const FrontCurve& curve_;
  const TubeMeshParameters& given_;
  const DistanceToSurface& to_surface_;
  Tube tube_;
  int segments_ = 0;
  std::vector<std::vector<double>> rings_; ///< [station]
  std::vector<FrontFrame> between_;        ///< [segment]
  bool twisted_ = false;                   ///< the crack does not lie in one plane there
  std::map<Key, int> known_;
  std::map<Key, double> end_shift_; ///< end, angle, ring
  std::vector<std::pair<int, int>> twins_;
};

} // namespace

Tube make_tube(const FrontCurve& curve, const TubeSizes& sizes, const TubeMeshParameters& given,
               const DistanceToSurface& to_surface) {
  assert(given.rings >= 1 && given.sectors >= 4);
  return TubeBuilder(curve, sizes, given, to_surface).build();
}

} // namespace spricka::mesh
