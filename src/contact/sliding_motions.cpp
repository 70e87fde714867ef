// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/sliding_motions.hpp"

#include "base/dense_solve.hpp"
#include "base/index.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace spricka::contact {

using base::index;

namespace {

constexpr double slides = 1e-4;   // as near as nodes must lie to a shape for it to be theirs
constexpr double believed = 1e-2; // of a row's area: what a surface that slides may seem to open
// So many contacts of a body are looked at in all combinations.
constexpr std::size_t most_combined = 8;

/// What a surface does under the modes of its body: sums over its points.
struct SurfaceMotionSums {
  std::size_t contact = 0;
  base::Matrix opening; ///< [mode, mode] of squares along the normals
  base::Matrix motion;  ///< [mode, mode] of squares of all that they move
  double points = 0.0;
};

/// The motions of one body by which its surfaces slide on themselves. A motion that several
/// surfaces let pass is the same for all of them to the last digit: else one would hold a bush in
/// whose other one it turns.
class SlidingBody {
public:
  explicit SlidingBody(const std::vector<SurfaceMotionSums>& surfaces)
      : surfaces_(surfaces), size_(surfaces.front().motion.rows()) {
    base::Matrix metric = base::Matrix::Zero(size_, size_);
    for (const SurfaceMotionSums& s : surfaces_) {
      metric += s.motion / s.points;
    }
    // Motions that move no point of the body's surfaces count by a little.
    metric += 1e-12 * metric.trace() * base::Matrix::Identity(size_, size_);
    LT_ = Eigen::LLT<base::Matrix>(metric).matrixU();
    find_motions();
  }

  /// B of the rows of a surface [row, mode] without its motions.
  void remove(std::size_t surface, const std::vector<double>& area,
              Eigen::Ref<base::Matrix> B) const {
    base::Matrix own(size_, 0); // scaled by the metric
    for (const SelfSlidingMotion& m : motions_) {
      if (m.passes[surface] && seems_to_slide(surface, area, B, m.direction)) {
        own.conservativeResize(Eigen::NoChange, own.cols() + 1);
        own.rightCols(1) = m.direction;
      }
    }
    if (own.cols() > 0) {
      const base::Matrix Q = orthonormal(own);
      const base::Matrix opened = B * unscaled(Q);
      B -= opened * (Q.transpose() * LT_);
    }
  }

private:
  struct SelfSlidingMotion {
    base::Vector direction;   ///< [mode] scaled by the metric, of length 1
    std::vector<bool> passes; ///< [surface]
  };

  static base::Matrix orthonormal(const base::Matrix& A) {
    const Eigen::HouseholderQR<base::Matrix> qr(A);
    return qr.householderQ() * base::Matrix::Identity(A.rows(), A.cols());
  }

  [[nodiscard]] base::Matrix unscaled(const base::Matrix& y) const {
    return LT_.triangularView<Eigen::Upper>().solve(y);
  }

  [[nodiscard]] bool lets_pass(const SurfaceMotionSums& s, const base::Vector& v) const {
    constexpr double round_off = 1e-20;
    const double moved = v.dot(s.motion * v);
    return v.dot(s.opening * v) <= slides * slides * moved + round_off * s.points;
  }

  // Where the other side has quite another shape its normals may hold what this surface does not.
  [[nodiscard]] bool seems_to_slide(std::size_t surface, const std::vector<double>& area,
                                    const base::Matrix& B, const base::Vector& y) const {
    const base::Vector v = unscaled(y);
    const SurfaceMotionSums& s = surfaces_[surface];
    const double moved = std::sqrt(std::max(0.0, v.dot(s.motion * v)) / s.points);
    const Eigen::Map<const base::Vector> of_rows(area.data(), index(area.size()));
    return (B * v).norm() <= believed * moved * of_rows.norm();
  }

  void find_motions() {
    for (const std::vector<bool>& some : combinations()) {
      base::Matrix known(size_, 0);
      for (const SelfSlidingMotion& m : motions_) {
        bool all = true;
        for (std::size_t s = 0; s < some.size(); ++s) {
          all = all && (!some[s] || m.passes[s]);
        }
        if (all) {
          known.conservativeResize(Eigen::NoChange, known.cols() + 1);
          known.rightCols(1) = m.direction;
        }
      }
      add_motions_of(some, known);
    }
  }

  // All motions that some surfaces let pass, besides the known ones.
  void add_motions_of(const std::vector<bool>& some, const base::Matrix& known) {
    const base::Matrix across = known.cols() > 0
                                    ? base::orthogonal_complement(known, 1e-6)
                                    : base::Matrix(base::Matrix::Identity(size_, size_));
    if (across.cols() == 0) {
      return;
    }
    base::Matrix opening = base::Matrix::Zero(size_, size_);
    for (std::size_t s = 0; s < some.size(); ++s) {
      if (some[s]) {
        opening += surfaces_[s].opening / surfaces_[s].points;
      }
    }
    const base::Matrix basis = unscaled(across);
    const base::SingularVectors found =
        base::right_singular_vectors(basis.transpose() * opening * basis);
    for (Eigen::Index k = 0; k < found.vectors.cols(); ++k) {
      const base::Vector direction = across * found.vectors.col(k);
      const base::Vector v = unscaled(direction);
      SelfSlidingMotion motion{.direction = direction, .passes = {}};
      bool all = true;
      for (std::size_t s = 0; s < some.size(); ++s) {
        motion.passes.push_back(lets_pass(surfaces_[s], v));
        all = all && (!some[s] || motion.passes.back());
      }
      if (all) {
        motions_.push_back(std::move(motion));
      }
    }
  }

  // Of the surfaces, the largest first.
  [[nodiscard]] std::vector<std::vector<bool>> combinations() const {
    const std::size_t n = surfaces_.size();
    std::vector<std::vector<bool>> all;
    if (n > most_combined) {
      all.emplace_back(n, true);
      for (std::size_t s = 0; s < n; ++s) {
        all.emplace_back(n, false)[s] = true;
      }
      return all;
    }
    std::vector<std::uint32_t> bits((std::size_t{1} << n) - 1);
    std::iota(bits.begin(), bits.end(), 1U);
    std::ranges::stable_sort(bits, std::greater<>(),
                             [](std::uint32_t b) { return std::popcount(b); });
    for (const std::uint32_t b : bits) {
      std::vector<bool>& some = all.emplace_back(n);
      for (std::size_t s = 0; s < n; ++s) {
        some[s] = (b >> s & 1U) != 0;
      }
    }
    return all;
  }

  const std::vector<SurfaceMotionSums>& surfaces_;
  Eigen::Index size_;
  base::Matrix LT_; ///< upper factor of the metric: squares of what all surfaces move
  std::vector<SelfSlidingMotion> motions_;
};

// The surface of each body on one side of a contact.
std::map<std::size_t, SurfaceMotionSums> motions_on(std::size_t contact,
                                                    const std::vector<SurfaceNodeNormal>& points,
                                                    const RigidModesLookup& modes_at) {
  std::map<std::size_t, SurfaceMotionSums> found;
  for (const SurfaceNodeNormal& point : points) {
    const std::optional<RigidModesAtNode> at = modes_at(point.node);
    if (!at || at->motion.cols() == 0) {
      continue;
    }
    SurfaceMotionSums& own = found[at->body];
    if (own.points == 0.0) {
      own.contact = contact;
      own.opening = own.motion = base::Matrix::Zero(at->motion.cols(), at->motion.cols());
    }
    const base::Vector opening = at->motion.transpose() * point.normal.head(at->motion.rows());
    own.opening += opening * opening.transpose();
    own.motion += at->motion.transpose() * at->motion;
    own.points += 1.0;
  }
  return found;
}

} // namespace

std::vector<SurfaceNodeNormal> surface_node_normals(const ContactSurface& surface) {
  std::vector<SurfaceNodeNormal> points;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const geometry::ElementSide& face = surface.facets[f];
    for (std::size_t i = 0; i < face.nodes.size(); ++i) {
      const geometry::SidePoint at = face.point(face.node_local_coordinates(static_cast<int>(i)));
      points.push_back({face.nodes[i], surface_normal(surface, f, at)});
    }
  }
  return points;
}

void remove_self_sliding_openings(const std::vector<ContactRowSurfaces>& contacts,
                                  const std::vector<Eigen::Index>& first_mode,
                                  const RigidModesLookup& modes_at, base::Matrix& B) {
  std::map<std::size_t, std::vector<SurfaceMotionSums>> bodies;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    auto own = motions_on(c, contacts[c].surface[0], modes_at);
    auto other = motions_on(c, contacts[c].surface[1], modes_at);
    for (auto* side : {&own, &other}) {
      auto& opposite = side == &own ? other : own;
      for (auto& [body, surface] : *side) {
        // A body that touches itself moves both sides alike.
        if (!opposite.contains(body)) {
          bodies[body].push_back(surface);
        }
      }
    }
  }
  for (const auto& [body, surfaces] : bodies) {
    const SlidingBody sliding(surfaces);
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      const ContactRowSurfaces& contact = contacts[surfaces[s].contact];
      sliding.remove(s, contact.area,
                     B.block(index(contact.first), first_mode[body], index(contact.area.size()),
                             surfaces[s].motion.cols()));
    }
  }
}

} // namespace spricka::contact
