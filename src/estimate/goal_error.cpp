// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/goal_error.hpp"

#include <cmath>

namespace spricka::estimate {

namespace {

constexpr int most_steps = 8;
constexpr double small_change = 3e-3;

/// Inverse of the diagonal blocks of K_ee on the unknowns. Directions x and y of a mode go
/// together, so that the result does not depend on the axes; those of a frame turn with the body
/// anyhow.
class Preconditioner {
public:
  Preconditioner(const CubicEnrichment& enrichment, const ModeFreedomMap& map)
      : diagonal_(base::Vector::Zero(map.unknowns)) {
    const std::vector<base::Vec3>& blocks = enrichment.diagonal_blocks();
    const std::size_t edges = enrichment.edges().edges.size();
    std::vector<int> users(static_cast<std::size_t>(map.unknowns), 0);
    for (const std::int32_t u : map.unknown) {
      if (u >= 0) {
        ++users[static_cast<std::size_t>(u)];
      }
    }
    support_ = base::Vector::Zero(map.unknowns);
    for (const auto& [freedom, part] : map.support) {
      if (map.unknown[freedom] >= 0) {
        support_[map.unknown[freedom]] += part * blocks[freedom / 2][freedom % 2 == 0 ? 0 : 2];
      }
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const std::int32_t x = map.unknown[2 * i];
      const std::int32_t y = map.unknown[2 * i + 1];
      if (x >= 0) {
        diagonal_[x] += blocks[i][0];
      }
      if (y >= 0) {
        diagonal_[y] += blocks[i][2];
      }
      // Modes that two edges share take their diagonal only: the block of one edge is not theirs.
      const bool own = x >= 0 && y >= 0 && users[static_cast<std::size_t>(x)] == 1 &&
                       users[static_cast<std::size_t>(y)] == 1;
      if (own && !(i < edges && enrichment.has_edge_frame(i))) {
        pairs_.push_back({x, y, blocks[i][1]});
      }
    }
    diagonal_ += support_;
  }

  /// Diagonal stiffness of other bodies. [unknowns]
  [[nodiscard]] const base::Vector& support() const { return support_; }

  [[nodiscard]] base::Vector solve(const base::Vector& r) const {
    base::Vector y = r.cwiseQuotient(diagonal_);
    for (const CoupledFreedoms& p : pairs_) {
      const double a = diagonal_[p.x];
      const double c = diagonal_[p.y];
      const double determinant = a * c - p.off * p.off;
      y[p.x] = (c * r[p.x] - p.off * r[p.y]) / determinant;
      y[p.y] = (a * r[p.y] - p.off * r[p.x]) / determinant;
    }
    return y;
  }

private:
  struct CoupledFreedoms {
    std::int32_t x, y;
    double off;
  };
  base::Vector diagonal_;
  std::vector<CoupledFreedoms> pairs_;
  base::Vector support_;
};

bool settled(const base::Vector& change, const base::Vector& eta) {
  return (change.array().abs() <= small_change * eta.array().abs()).all();
}

// K_ee^-1 r as far as the functionals r_z see it.
base::Vector solve_modes(const CubicEnrichment& enrichment, const ModeFreedomMap& map,
                         const base::Vector& r_u, const base::Matrix& r_z) {
  const Preconditioner preconditioner(enrichment, map);
  // Conjugate gradients from zero.
  base::Vector x = base::Vector::Zero(map.unknowns);
  base::Vector r = r_u;
  base::Vector s = preconditioner.solve(r);
  base::Vector p = s;
  double rs = r.dot(s);
  base::Vector eta = base::Vector::Zero(r_z.cols());
  for (int step = 0; step < most_steps && rs > 0.0; ++step) {
    const base::Vector Kp = map.reduce(enrichment.stiffness_product(map.expand(p))).col(0) +
                            preconditioner.support().cwiseProduct(p);
    const double alpha = rs / p.dot(Kp);
    x += alpha * p;
    r -= alpha * Kp;
    // eta of (estimate.4) grows by this with the step; all goals look at one solution.
    const base::Vector change = alpha * (r_z.transpose() * p);
    eta += change;
    if (step > 0 && settled(change, eta)) {
      break;
    }
    s = preconditioner.solve(r);
    const double next = r.dot(s);
    p = s + (next / rs) * p;
    rs = next;
  }
  return x;
}

} // namespace

void GoalError::sum_element_errors() {
  eta = sum = 0.0;
  for (const double part : of_element) {
    eta += part;
    sum += std::abs(part);
  }
}

ModeResiduals mode_residuals(const CubicEnrichment& enrichment, const ModeFreedomMap& map,
                             const GoalErrorInput& request) {
  base::Matrix f = request.load;
  enrichment.subtract_nodal_coupling(request.u, f);
  base::Matrix g = request.goals;
  enrichment.subtract_nodal_coupling(request.z, g);
  ModeResiduals r{map.reduce(f).col(0), map.reduce(g), {}};
  r.users.assign(static_cast<std::size_t>(map.unknowns), 0);
  for (std::size_t e = 0; e < enrichment.mesh().element_count(); ++e) {
    for (const std::int32_t freedom : enrichment.element_freedoms(base::ElementId(e))) {
      const std::int32_t u = map.unknown[static_cast<std::size_t>(freedom)];
      if (u >= 0) {
        ++r.users[static_cast<std::size_t>(u)];
      }
    }
  }
  return r;
}

std::vector<GoalError> estimate_goal_errors(const CubicEnrichment& enrichment,
                                            const ModeFreedomMap& map,
                                            const GoalErrorInput& request) {
  const ModeResiduals r = mode_residuals(enrichment, map, request);
  const base::Vector x = solve_modes(enrichment, map, r.u, r.z);

  // An unknown's part of eta goes to all elements that have it, in equal shares.
  const std::size_t count = enrichment.mesh().element_count();
  std::vector<GoalError> errors(static_cast<std::size_t>(r.z.cols()));
  for (std::size_t k = 0; k < errors.size(); ++k) {
    errors[k].of_element.assign(count, 0.0);
    for (std::size_t e = 0; e < count; ++e) {
      for (const std::int32_t freedom : enrichment.element_freedoms(base::ElementId(e))) {
        const std::int32_t u = map.unknown[static_cast<std::size_t>(freedom)];
        if (u >= 0) {
          errors[k].of_element[e] +=
              r.z(u, static_cast<Eigen::Index>(k)) * x[u] / r.users[static_cast<std::size_t>(u)];
        }
      }
    }
    errors[k].sum_element_errors();
  }
  return errors;
}

} // namespace spricka::estimate
