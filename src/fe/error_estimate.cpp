// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/error_estimate.hpp"

#include "base/parallel.hpp"
#include "fe/stress_kernel.hpp"
#include "fe/stress_patch.hpp"
#include "model/property_points.hpp"

#include <algorithm>
#include <optional>

namespace spricka::fe {

namespace {

using base::ElementId;
using base::Vec3;

// Square of 1e-8: smaller strains, as a part of displacement over element size, are round-off.
constexpr double noise_part = 1e-16;
constexpr int most_rings = 3;

/// Lists of numbers, one for each key, in one vector.
struct Lists {
  std::vector<std::size_t> first;
  std::vector<std::int32_t> entry;

  [[nodiscard]] std::span<const std::int32_t> of(std::size_t key) const {
    return {entry.data() + first[key], first[key + 1] - first[key]};
  }
};

std::size_t corner_count(const model::Mesh& mesh, std::size_t e) {
  return static_cast<std::size_t>(base::element_info(mesh.type[e]).corners);
}

/// What the patches are made from.
struct StressRecovery {
  const model::Mesh& mesh;
  model::FieldPointsByProperty points;
  std::vector<StressSample> samples;
  std::vector<std::size_t> first; ///< [element + 1] into samples
  Lists elements;                 ///< of a point, those with a corner there

  explicit StressRecovery(const model::Mesh& mesh_)
      : mesh(mesh_), points(model::property_points(mesh_)) {
    elements.first.assign(points.node.size() + 1, 0);
    for_corners([&](std::size_t point, std::size_t /*e*/) { ++elements.first[point + 1]; });
    for (std::size_t p = 0; p < points.node.size(); ++p) {
      elements.first[p + 1] += elements.first[p];
    }
    elements.entry.resize(elements.first.back());
    std::vector<std::size_t> next = elements.first;
    for_corners([&](std::size_t point, std::size_t e) {
      elements.entry[next[point]++] = static_cast<std::int32_t>(e);
    });
  }

  template <class Use> void for_corners(Use&& use) const {
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      for (std::size_t c = 0; c < corner_count(mesh, e); ++c) {
        use(point_of(e, c), e);
      }
    }
  }

  [[nodiscard]] std::size_t point_of(std::size_t e, std::size_t corner) const {
    return static_cast<std::size_t>(points.of[static_cast<std::size_t>(mesh.first[e]) + corner]);
  }
};

// Superconvergent points: the middle of linear elements, the reduced rule of quadratic ones.
template <shape::ElementShape S> std::span<const shape::QuadraturePoint<S::dim>> sample_rule() {
  return shape::quadrature<S>(base::element_info(S::type).quadratic ? 2 : 1);
}

// Lengths of the reference element along its coordinates.
template <shape::ElementShape S> shape::Point<S::dim> reference_lengths() {
  constexpr bool box = base::element_info(S::type).corners == 1 << S::dim;
  shape::Point<S::dim> lengths = shape::Point<S::dim>::Constant(box ? 2.0 : 1.0);
  if (S::domain == shape::ReferenceDomain::prism) {
    lengths[S::dim - 1] = 2.0;
  }
  return lengths;
}

void sample(const model::Model& model, const DisplacementTemperatureField& field,
            StressRecovery& recovery) {
  const model::Mesh& mesh = recovery.mesh;
  recovery.first.assign(1, 0);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    recovery.first.push_back(recovery.first.back() +
                             shape::with_element_shape(mesh.type[e], []<shape::ElementShape S>(S) {
                               return sample_rule<S>().size();
                             }));
  }
  recovery.samples.resize(recovery.first.back());
  base::for_each_element(mesh.element_count(), [&](std::size_t e) {
    shape::with_element_shape(mesh.type[e], [&]<shape::ElementShape S>(S) {
      const ElementStressEvaluator<S> element(model, mesh, ElementId(e), field);
      std::size_t at = recovery.first[e];
      for (const auto& point : sample_rule<S>()) {
        StressSample& s = recovery.samples[at++];
        s.x.template head<S::dim>() = element.X * S::N(point.r);
        s.stress = element.at(point.r);
        s.extent.template topLeftCorner<S::dim, S::dim>() =
            jacobian<S>(element.X, point.r).J * reference_lengths<S>().asDiagonal();
        s.longest = s.extent.colwise().norm().sum();
      }
    });
  });
}

/// Collects patches; holds what is needed anew for each.
class Patches {
public:
  explicit Patches(const StressRecovery& recovery)
      : r_(recovery), met_(recovery.mesh.element_count(), -1) {}

  // Elements round a point; where their samples do not determine the polynomial, as at the
  // boundary, the next rings of elements as well.
  FittedStressPolynomial patch(std::size_t point) {
    elements_.clear();
    samples_.clear();
    add(point, point);
    bool quadratic = true;
    for (const std::size_t e : elements_) {
      quadratic = quadratic && base::element_info(r_.mesh.type[e]).quadratic;
    }
    // Linear elements have one sample each, too few for terms of degree 2.
    const int degree = quadratic ? 2 : 1;
    FittedStressPolynomial fitted(samples_, r_.mesh.dim, degree);
    for (int ring = 1; ring < most_rings && !fitted.has_all_terms(); ++ring) {
      const std::size_t before = elements_.size();
      for (std::size_t i = 0; i < before; ++i) {
        for (std::size_t c = 0; c < corner_count(r_.mesh, elements_[i]); ++c) {
          add(r_.point_of(elements_[i], c), point);
        }
      }
      if (elements_.size() == before) {
        break;
      }
      fitted = FittedStressPolynomial(samples_, r_.mesh.dim, degree);
    }
    return fitted;
  }

private:
  void add(std::size_t round, std::size_t point) {
    for (const std::int32_t entry : r_.elements.of(round)) {
      const auto e = static_cast<std::size_t>(entry);
      if (met_[e] == static_cast<std::int64_t>(point)) {
        continue;
      }
      met_[e] = static_cast<std::int64_t>(point);
      elements_.push_back(e);
      for (std::size_t s = r_.first[e]; s < r_.first[e + 1]; ++s) {
        samples_.push_back(&r_.samples[s]);
      }
    }
  }

  const StressRecovery& r_;
  std::vector<std::int64_t> met_; ///< [element] the point whose patch it joined last
  std::vector<std::size_t> elements_;
  std::vector<const StressSample*> samples_;
};

// 1/2 s C s: all six components but in plane stress, where zz is zero and the reduced lambda
// belongs to two directions.
double complementary_energy(const Stress& s, const ConstitutiveLaw& law) {
  const double directions = law.plane_stress ? 2.0 : 3.0;
  const double trace = s.head<3>().sum();
  const double square = s.head<3>().squaredNorm() + 2.0 * s.tail<3>().squaredNorm();
  return (square - law.lambda / (directions * law.lambda + 2.0 * law.mu) * trace * trace) /
         (4.0 * law.mu);
}

} // namespace

ErrorEstimate estimate_error(const model::Model& model, const model::Mesh& mesh,
                             const DisplacementTemperatureField& field) {
  StressRecovery recovery(mesh);
  sample(model, field, recovery);
  std::vector<std::size_t> patched; // mid nodes have none
  std::vector<std::size_t> patch_of(recovery.points.node.size(), 0);
  for (std::size_t p = 0; p < patch_of.size(); ++p) {
    if (!recovery.elements.of(p).empty()) {
      patch_of[p] = patched.size();
      patched.push_back(p);
    }
  }
  std::vector<std::optional<FittedStressPolynomial>> smooth(patched.size());
  constexpr std::size_t portion = 2048; // patches by one collector, which marks all elements first
  base::parallel_for_ranges(patched.size(), portion, [&](std::size_t begin, std::size_t end) {
    Patches patches(recovery);
    for (std::size_t i = begin; i < end; ++i) {
      smooth[i] = patches.patch(patched[i]);
    }
  });
  ErrorEstimate estimate;
  estimate.energy.assign(mesh.element_count(), 0.0);
  estimate.noise.assign(mesh.element_count(), 0.0);
  base::for_each_element(mesh.element_count(), [&](std::size_t e) {
    shape::with_element_shape(mesh.type[e], [&]<shape::ElementShape S>(S) {
      const ElementStressEvaluator<S> element(model, mesh, ElementId(e), field);
      const AnyElement<S::dim>& corners = shape::as_reference_element<S>();
      double volume = 0.0;
      for (const auto& point : shape::quadrature<S>(std::max(S::degree, 2))) {
        const Jacobian<S> at = jacobian<S>(element.X, point.r);
        Vec3 x = Vec3::Zero();
        x.template head<S::dim>() = element.X * S::N(point.r);
        const double w = point.weight * at.det * element.law.depth(x.x());
        const CornerValues<S::dim> L = corners.linear_element().N(point.r);
        // s* - s, with s* blended from the polynomials of the corners (fe.37).
        Stress off = -element.stress_from_map(at, point.r);
        for (int c = 0; c < corners.corners; ++c) {
          off += L[c] * smooth[patch_of[recovery.point_of(e, static_cast<std::size_t>(c))]]->at(x);
        }
        // Half of e^2 of (fe.36).
        estimate.energy[e] += w * complementary_energy(off, element.law);
        volume += w;
      }
      const double size =
          (element.X.rowwise().maxCoeff() - element.X.rowwise().minCoeff()).maxCoeff();
      estimate.noise[e] =
          noise_part * element.law.mu * volume * element.U.cwiseAbs2().maxCoeff() / (size * size);
    });
  });
  return estimate;
}

} // namespace spricka::fe
