// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/generate/generate.hpp"
#include "mesh/generate/lattice.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace spricka::mesh {
namespace {

using base::Vec3;
using Point = Lattice::KeyedPoint;

using std::numbers::pi;
constexpr int key_eye = 0, key_shank = 1;

/// The lug about its bore's centre. Rays j = 0 .. 2 nt run from the bore to the outline: round the
/// head from where its one side ends to where the other begins, then along the top, the back of
/// the eye and the bottom. What lies behind the eye is the shank, between straight sides.
class Lug {
public:
  explicit Lug(const LugSpec& spec)
      : spec_(spec), nt_(std::max(spec.nt, 8)), centre_(spec.ex, spec.ey, 0.0),
        head_end_(angle_of_tangent(spec)) {
    assert(spec.ri > 0.0 && centre_.norm() + spec.ri < spec.ro && spec.ri < spec.length);
    head_ = static_cast<int>(std::lround(nt_ * (head_end_ / pi)));
    top_ = std::max(1, static_cast<int>(std::lround((nt_ - head_) / 4.0)));
    back_ = nt_ - head_ - 2 * top_;
    const double to_end = spec.length + spec.ex; // from the head's centre
    eye_ = to_end < 1.5 * spec.ro ? to_end : spec.ro;
    tangent_ = spec.ro * unit_direction(head_end_);
    half_end_ = 0.5 * spec.width;
    half_eye_ = half_width(-eye_);
    // radial sizes in proportion to the radius: elements keep their shape from bore to edge
    const double ratio = spec.ro / spec.ri;
    lines_ = graded_lattice_positions(spec.nr, std::pow(ratio, (spec.nr - 1.0) / spec.nr));
    shank_ = eye_ == to_end ? 0
                            : std::max(1, static_cast<int>(std::lround((to_end - eye_) * back_ /
                                                                       (2.0 * half_eye_))));
  }

  void build(Lattice& lattice, const std::string& prefix) const {
    std::vector<model::Face> bore;
    std::vector<model::Face> head;
    std::vector<model::Face> sides;
    std::vector<model::Face> end;
    for (int j = 0; j < nt_; ++j) {
      for (int i = 0; i < spec_.nr; ++i) {
        const auto side = lattice.add_cell(i, j, [&](int u, int v) { return eye(u, v); });
        if (i == 0) {
          bore.push_back(side[3]);
        }
        if (i == spec_.nr - 1) {
          const bool back = j >= head_ + top_ && j < head_ + top_ + back_;
          if (!back || shank_ == 0) {
            (j < head_ ? head : back ? end : sides).push_back(side[1]);
          }
        }
      }
    }
    for (int j = 0; j < back_; ++j) {
      for (int i = 0; i < shank_; ++i) {
        const auto side = lattice.add_cell(i, j, [&](int u, int v) { return shank(u, v); });
        if (i == shank_ - 1) {
          end.push_back(side[1]);
        }
        if (j == 0) {
          sides.push_back(side[0]);
        }
        if (j == back_ - 1) {
          sides.push_back(side[2]);
        }
      }
    }
    lattice.add_body_set(prefix);
    lattice.add_face_set(prefix + "BORE", std::move(bore));
    lattice.add_face_set(prefix + "HEAD", std::move(head));
    lattice.add_face_set(prefix + "SIDES", std::move(sides));
    lattice.add_face_set(prefix + "END", std::move(end));
  }

private:
  /// Of the line from the corner of END to the head, seen from the head's centre [rad].
  static double angle_of_tangent(const LugSpec& spec) {
    const double along = spec.length + spec.ex;
    const double up = 0.5 * spec.width;
    return up <= spec.ro ? 0.5 * pi
                         : std::atan2(up, -along) - std::acos(spec.ro / std::hypot(up, along));
  }
  /// Half the width of the shank, x from the head's centre.
  [[nodiscard]] double half_width(double x) const {
    const double to_end = spec_.length + spec_.ex;
    return tangent_.y() + (half_end_ - tangent_.y()) * (tangent_.x() - x) / (tangent_.x() + to_end);
  }

  [[nodiscard]] Vec3 ray(int j) const { // uniform over the head, uniform over the rest
    const int left = nt_ - head_;
    return j <= 2 * head_ ? unit_direction(2.0 * head_end_ * (j - head_) / (2.0 * head_))
                          : unit_direction(head_end_ + (2.0 * pi - 2.0 * head_end_) *
                                                           (j - 2 * head_) / (2.0 * left));
  }
  /// From the head's centre.
  [[nodiscard]] Vec3 outline(int j) const {
    if (j <= 2 * head_) {
      return spec_.ro * ray(j);
    }
    if (j % 2 == 1) { // the rest is straight
      return 0.5 * (outline(j - 1) + outline((j + 1) % (2 * nt_)));
    }
    const int top_end = 2 * (head_ + top_);
    const int back_end = top_end + 2 * back_;
    if (j > top_end && j <= back_end) {
      return {-eye_,
              half_eye_ * std::tan(0.25 * pi * (1.0 - (j - top_end) / static_cast<double>(back_))),
              0.0};
    }
    const int from_head = j <= top_end ? j - 2 * head_ : 2 * nt_ - j;
    const double part = std::tan(0.25 * pi * from_head / (2.0 * top_));
    const double up = j <= top_end ? 1.0 : -1.0;
    return {tangent_.x() - (eye_ + tangent_.x()) * part,
            up * (tangent_.y() + (half_eye_ - tangent_.y()) * part), 0.0};
  }
  [[nodiscard]] Vec3 place(const Vec3& x) const { return x + Vec3(spec_.x0, spec_.y0, 0.0); }

  [[nodiscard]] Point eye(int i, int j) const {
    const double s = lines_[static_cast<std::size_t>(i)];
    const int k = j % (2 * nt_);
    return {{key_eye, i, k, 0}, place((1.0 - s) * spec_.ri * ray(k) + s * (centre_ + outline(k)))};
  }
  /// u along the shank from the eye, v along the back of the eye in the order of the rays.
  [[nodiscard]] Point shank(int u, int v) const {
    const int j = 2 * (head_ + top_) + v;
    if (u == 0) {
      return eye(2 * spec_.nr, j);
    }
    const double x = -eye_ - (spec_.length + spec_.ex - eye_) * u / (2.0 * shank_);
    const double y = outline(j).y() * half_width(x) / half_eye_;
    return {{key_shank, u, v, 0}, place(centre_ + Vec3(x, y, 0.0))};
  }

  const LugSpec& spec_;
  int nt_;                            ///< elements round the bore
  Vec3 centre_;                       ///< of the head, from the bore's
  double head_end_;                   ///< angle at which the head becomes a side [rad]
  int head_ = 0, top_ = 0, back_ = 0; ///< elements round the head, along a side, along the back
  double eye_ = 0.0;                  ///< from the head's centre to the back of the eye
  Vec3 tangent_ = Vec3::Zero();       ///< where the head becomes the upper side, from its centre
  double half_end_ = 0.0, half_eye_ = 0.0; ///< half widths at END and at the back of the eye
  int shank_ = 0;                          ///< elements along the shank
  std::vector<double> lines_;
};

} // namespace

void generate_lug(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                  const LugSpec& spec) {
  Lattice lattice(mesh, net, spec.type);
  Lug(spec).build(lattice, prefix);
}

} // namespace spricka::mesh
