// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/fill.hpp"

#include "mesh/link/mesher_link.hpp"
#include "mesh/link/mesher_request.hpp"
#include "mesh/plane.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace spricka::mesh {
namespace {

using base::Vec2;

/// Triangles with no height, on three points of a straight boundary: the longest side goes over to
/// the other diagonal of the quadrilateral that it halves. Given edges stay.
class Reversals {
public:
  Reversals(const PlaneRegion& region, TriangleFill& filling) : region_(region), filling_(filling) {
    for (const auto* chains : {&region.boundaries, &region.embedded}) {
      for (const std::vector<int>& chain : *chains) {
        const std::size_t count = chain.size() - (chains == &region.embedded ? 1 : 0);
        for (std::size_t i = 0; i < count; ++i) {
          given_.insert(std::minmax(chain[i], chain[(i + 1) % chain.size()]));
        }
      }
    }
  }

  void run() {
    constexpr int passes = 20; // a row of flat ones takes one for each
    bool more = true;
    for (int pass = 0; pass < passes && more; ++pass) {
      more = false;
      for (std::size_t i = 0; i < filling_.cells.size(); ++i) {
        more = (is_flat(filling_.cells[i]) && reverse(i)) || more;
      }
    }
  }

private:
  using Triangle = std::array<int, 3>;
  static constexpr double flat = 1e-5; ///< height over longest side

  [[nodiscard]] Vec2 at(int n) const {
    const auto i = static_cast<std::size_t>(n);
    return i < region_.points.size() ? region_.points[i]
                                     : filling_.added[i - region_.points.size()];
  }
  /// The corner before the longest side.
  [[nodiscard]] std::size_t longest(const Triangle& t) const {
    std::size_t best = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      best = (at(t[(k + 1) % 3]) - at(t[k])).norm() > (at(t[(best + 1) % 3]) - at(t[best])).norm()
                 ? k
                 : best;
    }
    return best;
  }
  [[nodiscard]] bool is_flat(const Triangle& t) const {
    const std::size_t k = longest(t);
    const Vec2 side = at(t[(k + 1) % 3]) - at(t[k]);
    return cross(side, at(t[(k + 2) % 3]) - at(t[k])) < flat * side.squaredNorm();
  }
  bool reverse(std::size_t i) {
    Triangle& t = filling_.cells[i];
    const std::size_t k = longest(t);
    const int a = t[k];
    const int c = t[(k + 1) % 3];
    const int b = t[(k + 2) % 3];
    if (given_.contains(std::minmax(a, c))) {
      return false;
    }
    for (Triangle& other : filling_.cells) {
      for (std::size_t m = 0; m < 3; ++m) {
        if (other[m] == c && other[(m + 1) % 3] == a) {
          const int d = other[(m + 2) % 3];
          t = {a, d, b};
          other = {d, c, b};
          return true;
        }
      }
    }
    return false;
  }

  const PlaneRegion& region_;
  TriangleFill& filling_;
  std::set<std::pair<int, int>> given_;
};

} // namespace

template <int dim>
MeshFill<dim> request_mesh_fill(const FillRegion<dim>& region, const SizeGrading<dim>& size) {
  const MesherAnswer answer = request_from_mesher(encode_fill_request(region, size));
  MeshFill<dim> filling;
  if (answer.end != MesherOutcome::answered) {
    filling.trouble = answer.trouble;
    return filling;
  }
  ByteReader in(answer.frame);
  if (!decode_fill_answer(in, region, filling)) {
    filling = {};
    filling.trouble = "gmsh gave no mesh";
  }
  return filling;
}

template TriangleFill request_mesh_fill(const PlaneRegion&, const Grading&);
template TetrahedronFill request_mesh_fill(const SolidRegion&, const SolidGrading&);

TriangleFill fill_triangles(const PlaneRegion& region, const Grading& size) {
  TriangleFill filling = request_mesh_fill(region, size);
  if (filling.trouble.empty()) {
    Reversals(region, filling).run();
  }
  if (filling.trouble.empty() && filling.cells.empty()) {
    filling.trouble = "no triangles were made";
  }
  return filling;
}

} // namespace spricka::mesh
