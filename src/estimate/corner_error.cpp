// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/corner_error.hpp"

#include "base/dense_solve.hpp"
#include "fe/element.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace spricka::estimate {

namespace {

/// Modes and nodes inside the elements about a corner, on which nothing outside them acts.
class CornerPatch {
public:
  CornerPatch(const CornerErrorRequest& request, const ModeResiduals& residuals,
              const SingularCorner& corner)
      : request_(request), residuals_(residuals), corner_(corner) {
    count_modes();
    count_nodes();
  }

  /// What the corner's own elements have of each error. [corner.elements, goals]
  [[nodiscard]] base::Matrix errors() const {
    const auto size = static_cast<Eigen::Index>(modes_.size() + nodes_.size());
    base::Matrix K = base::Matrix::Zero(size, size);
    for (const base::ElementId e : corner_.around) {
      add_element(e, K);
    }
    add_support(K);
    // (estimate.16). Nodes have no residual: u and z solve their equations.
    base::Vector r = base::Vector::Zero(size);
    for (const auto& [unknown, at] : modes_) {
      r[at] = residuals_.u[unknown];
    }
    return shares(base::solve_semidefinite_system(K, r));
  }

private:
  [[nodiscard]] std::int32_t unknown(std::int32_t freedom) const {
    return request_.map.unknown[static_cast<std::size_t>(freedom)];
  }

  void count_modes() {
    std::map<std::int32_t, int> users;
    for (const base::ElementId e : corner_.around) {
      for (const std::int32_t freedom : request_.enrichment.element_freedoms(e)) {
        if (unknown(freedom) >= 0) {
          ++users[unknown(freedom)];
        }
      }
    }
    for (const auto& [u, count] : users) {
      // A mode that an element farther out has as well is held on the rim.
      if (count == residuals_.users[static_cast<std::size_t>(u)]) {
        modes_.emplace(u, static_cast<Eigen::Index>(modes_.size()));
      }
    }
  }

  // Nodes of the corner's elements are inside; of the others only those of no edge that goes on.
  void count_nodes() {
    const model::Mesh& mesh = request_.enrichment.mesh();
    const EdgeTable& edges = request_.enrichment.edges();
    std::map<std::size_t, int> sides;
    for (const base::ElementId e : corner_.around) {
      for (int s = 0; s < base::element_info(mesh.type[e.index()]).sides; ++s) {
        ++sides[edges.edge_at_side(e, s)];
      }
    }
    std::vector<base::NodeId> rim;
    for (const auto& [edge, count] : sides) {
      // An element outside shares this edge: its nodes are the rim, which is held.
      if (count < edges.edges[edge].elements) {
        rim.insert(rim.end(), edges.edges[edge].nodes.begin(), edges.edges[edge].nodes.end());
      }
    }
    std::ranges::sort(rim);
    std::vector<base::NodeId> inside;
    for (const base::ElementId e : corner_.around) {
      for (const base::NodeId n : mesh.element_nodes(e)) {
        if (!std::ranges::binary_search(rim, n)) {
          inside.push_back(n);
        }
      }
    }
    std::ranges::sort(inside);
    for (const base::NodeId n : inside) {
      for (std::size_t c = 0; c < 2; ++c) {
        const std::size_t freedom = 2 * n.index() + c;
        if (!request_.fixed[freedom] && !nodes_.contains(freedom)) {
          nodes_.emplace(freedom, static_cast<Eigen::Index>(modes_.size() + nodes_.size()));
        }
      }
    }
  }

  // The matrix of (estimate.2) of an element, modes first.
  [[nodiscard]] base::Matrix stiffness(base::ElementId e) const {
    const model::Mesh& mesh = request_.enrichment.mesh();
    const fe::ConstitutiveLaw law = fe::constitutive_law(request_.enrichment.model(), mesh, e);
    base::Matrix Ke;
    with_mode_shape(mesh.type[e.index()], [&]<shape::PlaneShape S>(S) {
      const fe::NodeVectors<S> X = fe::element_coordinates<S>(mesh, e);
      const EnrichedStiffness<S> modes(X, law, request_.enrichment.element_side_frames(e));
      const Eigen::Index m = modes.ee.rows();
      const Eigen::Index p = modes.ep.cols();
      Ke.resize(m + p, m + p);
      Ke.topLeftCorner(m, m) = modes.ee;
      Ke.topRightCorner(m, p) = modes.ep;
      Ke.bottomLeftCorner(p, m) = modes.ep.transpose();
      Ke.bottomRightCorner(p, p) = fe::element_stiffness<S>(X, law);
    });
    return Ke;
  }

  void add_element(base::ElementId e, base::Matrix& K) const {
    const std::span<const base::NodeId> nodes = request_.enrichment.mesh().element_nodes(e);
    const std::span<const std::int32_t> freedom = request_.enrichment.element_freedoms(e);
    const base::Matrix Ke = stiffness(e);
    const std::size_t m = freedom.size();
    std::vector<Eigen::Index> at(m + 2 * nodes.size(), -1);
    std::vector<double> factor(at.size(), 1.0);
    for (std::size_t i = 0; i < m; ++i) {
      const auto found = modes_.find(unknown(freedom[i]));
      at[i] = found == modes_.end() ? -1 : found->second;
      factor[i] = request_.map.factor[static_cast<std::size_t>(freedom[i])];
    }
    for (std::size_t i = 0; i < 2 * nodes.size(); ++i) {
      const auto found = nodes_.find(2 * nodes[i / 2].index() + i % 2);
      at[m + i] = found == nodes_.end() ? -1 : found->second;
    }
    for (std::size_t j = 0; j < at.size(); ++j) {
      for (std::size_t i = 0; i < at.size(); ++i) {
        if (at[i] >= 0 && at[j] >= 0) {
          K(at[i], at[j]) += factor[i] * factor[j] *
                             Ke(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
      }
    }
  }

  // Stiffness that other bodies add to modes of contact surfaces.
  void add_support(base::Matrix& K) const {
    const std::vector<base::Vec3>& blocks = request_.enrichment.diagonal_blocks();
    for (const auto& [freedom, part] : request_.map.support) {
      const auto found = modes_.find(request_.map.unknown[freedom]);
      if (found != modes_.end()) {
        // The part is one of the mode's own stiffness, of all elements that have it.
        K(found->second, found->second) += part * blocks[freedom / 2][freedom % 2 == 0 ? 0 : 2];
      }
    }
  }

  [[nodiscard]] base::Matrix shares(const base::Vector& x) const {
    base::Matrix errors =
        base::Matrix::Zero(static_cast<Eigen::Index>(corner_.elements.size()), residuals_.z.cols());
    for (std::size_t i = 0; i < corner_.elements.size(); ++i) {
      for (const std::int32_t freedom : request_.enrichment.element_freedoms(corner_.elements[i])) {
        const std::int32_t u = unknown(freedom);
        if (const auto found = modes_.find(u); found != modes_.end()) {
          errors.row(static_cast<Eigen::Index>(i)) +=
              x[found->second] / residuals_.users[static_cast<std::size_t>(u)] *
              residuals_.z.row(u);
        }
      }
    }
    return errors;
  }

  const CornerErrorRequest& request_;
  const ModeResiduals& residuals_;
  const SingularCorner& corner_;
  std::map<std::int32_t, Eigen::Index> modes_; ///< unknown to place
  std::map<std::size_t, Eigen::Index> nodes_;  ///< freedom of a node to place
};

} // namespace

// 1.75 at the end of a crack or a support, 1.25 at a clamped right corner: read off meshes of the
// calibration half (manual, error_bar.md). Cubics leave (2/3)^(4 lambda) of the error of quadratics
// there, on even meshes (Babuska and Suri 1994), which is the same to a tenth.
double corner_error_factor(double exponent) {
  const double short_of_1 = 1.0 - exponent;
  return 1.0 + 3.0 * short_of_1 * short_of_1;
}

namespace {

// Modes alone see less of an error without change of volume, the less the material changes it: by
// 8 % at nu = 0.4 in plane strain, by 32 % at 0.49, read off strips in bending and tension.
double volume_factor(const CornerErrorRequest& request, base::ElementId e) {
  constexpr double measured_at = 1.75; // nu = 0.3 in plane strain, that of the bar's constants
  const fe::ConstitutiveLaw law =
      fe::constitutive_law(request.enrichment.model(), request.enrichment.mesh(), e);
  const double stiffer = (law.lambda + 2.0 * law.mu) / (2.0 * law.mu) / measured_at;
  return stiffer > 1.0 ? 1.0 + 0.12 * std::log(stiffer) : 1.0;
}

// Whether a corner's elements have enough of some error to change it: what the modes alone see of
// it is less by what nodes take part in, most where the material hardly changes its volume.
bool counts(const CornerErrorRequest& request, const SingularCorner& corner,
            const std::vector<GoalError>& errors, const std::vector<double>& sums) {
  double most = 0.0;
  for (const base::ElementId e : corner.elements) {
    const fe::ConstitutiveLaw law =
        fe::constitutive_law(request.enrichment.model(), request.enrichment.mesh(), e);
    most = std::max(most, (law.lambda + 2.0 * law.mu) / law.mu);
  }
  for (std::size_t k = 0; k < errors.size(); ++k) {
    double own = 0.0;
    for (const base::ElementId e : corner.elements) {
      own += std::abs(errors[k].of_element[e.index()]);
    }
    if (most * own > 0.01 * sums[k]) {
      return true;
    }
  }
  return false;
}

} // namespace

void correct_corner_errors(const CornerErrorRequest& request,
                           const std::vector<SingularCorner>& corners,
                           std::vector<GoalError>& errors) {
  std::vector<double> sums;
  sums.reserve(errors.size());
  for (const GoalError& error : errors) {
    // As modes alone have found them: what one corner changes does not decide on the next.
    sums.push_back(error.sum);
  }
  std::optional<ModeResiduals> residuals;
  std::vector<bool> found_anew(request.enrichment.mesh().element_count(), false);
  for (const SingularCorner& corner : corners) {
    if (!counts(request, corner, errors, sums)) {
      continue;
    }
    if (!residuals) {
      residuals = mode_residuals(request.enrichment, request.map, request.goal);
    }
    const base::Matrix found = CornerPatch(request, *residuals, corner).errors();
    const double factor = corner_error_factor(corner.exponent);
    for (std::size_t k = 0; k < errors.size(); ++k) {
      for (std::size_t i = 0; i < corner.elements.size(); ++i) {
        errors[k].of_element[corner.elements[i].index()] =
            factor * found(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
        found_anew[corner.elements[i].index()] = true;
      }
    }
  }
  for (std::size_t e = 0; e < found_anew.size(); ++e) {
    const double factor = found_anew[e] ? 1.0 : volume_factor(request, base::ElementId(e));
    for (GoalError& error : errors) {
      error.of_element[e] *= factor;
    }
  }
  for (GoalError& error : errors) {
    error.sum_element_errors();
  }
}

} // namespace spricka::estimate
