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

/// The lug about its bore's centre. Rays j = 0 .. 2 nt run from the bore to the outline: through
/// the head from -90 to 90 degrees, then along the top, the back of the eye and the bottom. What
/// lies behind the eye is a rectangle, the shank.
class Lug {
public:
  explicit Lug(const LugSpec& spec)
      : spec_(spec), nt_(std::max(spec.nt, 8)), head_((nt_ + 1) / 2),
        top_(std::max(1, static_cast<int>(std::lround((nt_ - head_) / 4.0)))),
        back_(nt_ - head_ - 2 * top_), b_(0.5 * spec.width),
        eye_(spec.length < 1.5 * b_ ? spec.length : b_) {
    assert(spec.ri > 0.0 && spec.ri < b_ && spec.ri < spec.length);
    // radial sizes in proportion to the radius: elements keep their shape from bore to edge
    const double ratio = b_ / spec.ri;
    lines_ = graded_lattice_positions(spec.nr, std::pow(ratio, (spec.nr - 1.0) / spec.nr));
    shank_ =
        eye_ == spec.length
            ? 0
            : std::max(1, static_cast<int>(std::lround((spec.length - eye_) * back_ / (2.0 * b_))));
  }

  void build(Lattice& lattice, const std::string& prefix) const {
    std::vector<model::Face> bore;
    std::vector<model::Face> head;
    std::vector<model::Face> end;
    for (int j = 0; j < nt_; ++j) {
      for (int i = 0; i < spec_.nr; ++i) {
        const auto side = lattice.add_cell(i, j, [&](int u, int v) { return eye(u, v); });
        if (i == 0) {
          bore.push_back(side[3]);
        }
        if (i == spec_.nr - 1 && j < head_) {
          head.push_back(side[1]);
        }
        if (i == spec_.nr - 1 && shank_ == 0 && j >= head_ + top_ && j < head_ + top_ + back_) {
          end.push_back(side[1]);
        }
      }
    }
    for (int j = 0; j < back_; ++j) {
      for (int i = 0; i < shank_; ++i) {
        const auto side = lattice.add_cell(i, j, [&](int u, int v) { return shank(u, v); });
        if (i == shank_ - 1) {
          end.push_back(side[1]);
        }
      }
    }
    lattice.add_body_set(prefix);
    lattice.add_face_set(prefix + "BORE", std::move(bore));
    lattice.add_face_set(prefix + "HEAD", std::move(head));
    lattice.add_face_set(prefix + "END", std::move(end));
  }

private:
  [[nodiscard]] Vec3 ray(int j) const { // uniform over the head, uniform over the rest
    const int left = nt_ - head_;
    return j <= 2 * head_ ? unit_direction(pi * (j - head_) / (2.0 * head_))
                          : unit_direction(0.5 * pi + pi * (j - 2 * head_) / (2.0 * left));
  }
  [[nodiscard]] Vec3 outline(int j) const {
    if (j <= 2 * head_) {
      return b_ * ray(j);
    }
    if (j % 2 == 1) { // the rest is straight
      return 0.5 * (outline(j - 1) + outline((j + 1) % (2 * nt_)));
    }
    const int top_end = 2 * (head_ + top_);
    const int back_end = top_end + 2 * back_;
    if (j <= top_end) {
      return {-eye_ * std::tan(0.25 * pi * (j - 2 * head_) / (2.0 * top_)), b_, 0.0};
    }
    if (j <= back_end) {
      return {-eye_, b_ * std::tan(0.25 * pi * (1.0 - (j - top_end) / static_cast<double>(back_))),
              0.0};
    }
    return {-eye_ * std::tan(0.25 * pi * (2 * nt_ - j) / (2.0 * top_)), -b_, 0.0};
  }
  [[nodiscard]] Vec3 place(const Vec3& x) const { return x + Vec3(spec_.x0, spec_.y0, 0.0); }

  [[nodiscard]] Point eye(int i, int j) const {
    const double s = lines_[static_cast<std::size_t>(i)];
    const int k = j % (2 * nt_);
    return {{key_eye, i, k, 0}, place((1.0 - s) * spec_.ri * ray(k) + s * outline(k))};
  }
  /// u along the shank from the eye, v along the back of the eye in the order of the rays.
  [[nodiscard]] Point shank(int u, int v) const {
    const int j = 2 * (head_ + top_) + v;
    if (u == 0) {
      return eye(2 * spec_.nr, j);
    }
    const double x = -eye_ - (spec_.length - eye_) * u / (2.0 * shank_);
    return {{key_shank, u, v, 0}, place({x, outline(j).y(), 0.0})};
  }

  const LugSpec& spec_;
  int nt_, head_;  ///< elements round the bore, round the head
  int top_, back_; ///< along the top (and the bottom), along the back of the eye
  double b_, eye_; ///< half width; from the centre to the back of the eye
  int shank_ = 0;  ///< elements along the shank
  std::vector<double> lines_;
};

} // namespace

void generate_lug(model::Mesh& mesh, base::NetId net, const std::string& prefix,
                  const LugSpec& spec) {
  Lattice lattice(mesh, net, spec.type);
  Lug(spec).build(lattice, prefix);
}

} // namespace spricka::mesh
