// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/enrichment.hpp"

#include "model/model.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cstddef>

namespace spricka::estimate {

namespace {

/// Calls f(S{}, e) for all elements, which have modes, in their order.
template <class F> void for_elements(const model::Mesh& mesh, F&& f) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    with_mode_shape(mesh.type[e],
                    [&]<shape::PlaneShape S>(S shape) { f(shape, base::ElementId(e)); });
  }
}

/// ee, then ep.
std::size_t matrix_numbers(base::ElementType type) {
  const int m = PlaneModes::for_type(type).freedoms();
  return static_cast<std::size_t>(m * (m + 2 * base::element_info(type).nodes));
}

// What the matrices of an element depend on, beside its type.
std::vector<double> all_that_counts(const fe::AnyNodeVectors<2>& X, const fe::ConstitutiveLaw& law,
                                    const SideModeFrames& side) {
  std::vector<double> of(X.data(), X.data() + X.size());
  of.insert(of.end(), {law.lambda, law.mu, law.thickness});
  of.insert(of.end(), side.sign.begin(), side.sign.end());
  of.insert(of.end(), side.framed.begin(), side.framed.end());
  return of;
}

} // namespace

std::string enrichment_obstacle(const model::Model& model, const model::Mesh& mesh) {
  if (mesh.dim != 2) {
    return "the model is no plane one";
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId id(e);
    if (!has_cubic_modes(mesh.type[e])) {
      return "some elements are linear";
    }
    if (fe::constitutive_law(model, mesh, id).projected) {
      return "a material is nearly incompressible";
    }
  }
  return {};
}

double enrichment_memory(const model::Mesh& mesh) {
  std::size_t numbers = 0;
  for (const base::ElementType type : mesh.type) {
    numbers +=
        matrix_numbers(type) + static_cast<std::size_t>(PlaneModes::for_type(type).freedoms());
  }
  return static_cast<double>(numbers * sizeof(double));
}

ModeMatrixCache::CachedModeMatrix& ModeMatrixCache::at(base::ElementId host) {
  if (host.index() >= entries_.size()) {
    entries_.resize(host.index() + 1);
  }
  return entries_[host.index()];
}

CubicEnrichment::CubicEnrichment(const model::Model& model, const model::Mesh& mesh,
                                 EdgeTable edges, std::vector<bool> framed, ModeMatrixLookup kept)
    : model_(model), mesh_(mesh), edges_(std::move(edges)), framed_(std::move(framed)) {
  auto next = static_cast<std::int32_t>(2 * edges_.edges.size());
  first_.reserve(mesh.element_count() + 1);
  first_.push_back(0);
  std::size_t freedoms = 0;
  std::size_t numbers = 0;
  // Counted first: what points into own_ must stay where it is.
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    freedoms += static_cast<std::size_t>(PlaneModes::for_type(mesh.type[e]).freedoms());
    numbers += kept.host_element(base::ElementId(e)).valid() ? 0 : matrix_numbers(mesh.type[e]);
  }
  freedom_.reserve(freedoms);
  matrix_.reserve(mesh.element_count());
  own_.resize(numbers);
  double* next_own = own_.data();
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    const PlaneModes& modes = PlaneModes::for_type(mesh.type[i]);
    for (int s = 0; s < modes.sides; ++s) {
      const auto edge = static_cast<std::int32_t>(edges_.edge_at_side(e, s));
      freedom_.push_back(2 * edge);
      freedom_.push_back(2 * edge + 1);
    }
    for (int k = 2 * modes.sides; k < modes.freedoms(); ++k) {
      freedom_.push_back(next++);
    }
    first_.push_back(freedom_.size());
    add_matrix(e, kept, next_own);
  }
  freedoms_ = next;
  sum_diagonal();
}

void CubicEnrichment::add_matrix(base::ElementId e, const ModeMatrixLookup& kept,
                                 double*& next_own) {
  const base::ElementType type = mesh_.type[e.index()];
  const fe::ConstitutiveLaw law = fe::constitutive_law(model_, mesh_, e);
  const SideModeFrames side = element_side_frames(e);
  const base::ElementId host = kept.host_element(e);
  double* at = next_own;
  if (host.valid()) {
    ModeMatrixCache::CachedModeMatrix& entry = kept.memory->at(host);
    std::vector<double> of = all_that_counts(
        fe::element_coordinates(shape::reference_element<2>(type), mesh_, e), law, side);
    matrix_.push_back(entry.numbers.data());
    // Equal to the last bit, so that a kept matrix is the one that would be made.
    if (entry.type == type && entry.of == of) {
      return;
    }
    entry = {type, std::move(of), std::vector<double>(matrix_numbers(type))};
    at = entry.numbers.data();
    matrix_.back() = at;
  } else {
    matrix_.push_back(at);
    next_own += matrix_numbers(type);
  }
  with_mode_shape(type, [&]<shape::PlaneShape S>(S) {
    const EnrichedStiffness<S> K(fe::element_coordinates<S>(mesh_, e), law, side);
    std::copy_n(K.ee.data(), K.ee.size(), at);
    std::copy_n(K.ep.data(), K.ep.size(), at + K.ee.size());
  });
}

SideModeFrames CubicEnrichment::element_side_frames(base::ElementId e) const {
  const base::ElementType type = mesh_.type[e.index()];
  const std::span<const base::NodeId> nodes = mesh_.element_nodes(e);
  SideModeFrames state;
  const int corners = base::element_info(type).corners;
  for (int s = 0; s < corners; ++s) {
    const auto at = static_cast<std::size_t>(s);
    state.sign[at] = side_mode_sign(nodes[at], nodes[static_cast<std::size_t>((s + 1) % corners)]);
    state.framed[at] = framed_[edges_.edge_at_side(e, s)];
  }
  return state;
}

base::Vector CubicEnrichment::stiffness_product(const base::Vector& x) const {
  base::Vector y = base::Vector::Zero(freedoms_);
  for_elements(mesh_, [&]<shape::PlaneShape S>(S, base::ElementId e) {
    constexpr int m = mode_freedoms<S>;
    const Eigen::Map<const Eigen::Matrix<double, m, m>> K(matrix_[e.index()]);
    const std::span<const std::int32_t> freedom = element_freedoms(e);
    Eigen::Matrix<double, m, 1> local;
    for (int i = 0; i < m; ++i) {
      local[i] = x[freedom[static_cast<std::size_t>(i)]];
    }
    const Eigen::Matrix<double, m, 1> force = K * local;
    for (int i = 0; i < m; ++i) {
      y[freedom[static_cast<std::size_t>(i)]] += force[i];
    }
  });
  return y;
}

void CubicEnrichment::sum_diagonal() {
  diagonal_.assign(static_cast<std::size_t>(freedoms_ / 2), base::Vec3::Zero());
  for_elements(mesh_, [&]<shape::PlaneShape S>(S, base::ElementId e) {
    constexpr int m = mode_freedoms<S>;
    const Eigen::Map<const Eigen::Matrix<double, m, m>> K(matrix_[e.index()]);
    const std::span<const std::int32_t> freedom = element_freedoms(e);
    for (int i = 0; i < m; i += 2) {
      diagonal_[static_cast<std::size_t>(freedom[static_cast<std::size_t>(i)]) / 2] +=
          base::Vec3(K(i, i), K(i + 1, i), K(i + 1, i + 1));
    }
  });
}

void CubicEnrichment::subtract_nodal_coupling(const base::Matrix& u, base::Matrix& r) const {
  for_elements(mesh_, [&]<shape::PlaneShape S>(S, base::ElementId e) {
    Eigen::Index k = 0;
    for (; k + 4 <= u.cols(); k += 4) { // each matrix is read once for four columns
      take_columns<S, 4>(e, k, u, r);
    }
    for (; k < u.cols(); ++k) {
      take_columns<S, 1>(e, k, u, r);
    }
  });
}

template <shape::PlaneShape S, int columns>
void CubicEnrichment::take_columns(base::ElementId e, Eigen::Index first, const base::Matrix& u,
                                   base::Matrix& r) const {
  constexpr int m = mode_freedoms<S>;
  constexpr int p = 2 * S::nodes;
  const Eigen::Map<const Eigen::Matrix<double, m, p>> K(matrix_[e.index()] + std::ptrdiff_t{m} * m);
  const std::span<const std::int32_t> freedom = element_freedoms(e);
  const std::span<const base::NodeId> nodes = mesh_.element_nodes(e);
  Eigen::Matrix<double, p, columns> local;
  for (int n = 0; n < S::nodes; ++n) {
    local.template middleRows<2>(2 * n) = u.template block<2, columns>(
        2 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(n)].index()), first);
  }
  Eigen::Matrix<double, m, columns> force;
  force.noalias() = K.lazyProduct(local);
  for (int i = 0; i < m; ++i) {
    r.template block<1, columns>(freedom[static_cast<std::size_t>(i)], first) -= force.row(i);
  }
}

base::Matrix CubicEnrichment::mode_functional(
    const std::vector<crack::KFunctionalQuadraturePoint>& points) const {
  base::Matrix g = base::Matrix::Zero(freedoms_, 2);
  for (const crack::KFunctionalQuadraturePoint& point : points) {
    const base::ElementId e = point.element;
    const std::span<const std::int32_t> freedom = element_freedoms(e);
    const fe::AnyElement<2>& element = shape::reference_element<2>(mesh_.type[e.index()]);
    const PlaneModes& modes = PlaneModes::for_type(mesh_.type[e.index()]);
    const fe::AnyNodeVectors<2> X = fe::element_coordinates(element, mesh_, e);
    const Eigen::Matrix2d J = X.lazyProduct(element.dN(point.r));
    const ModeGradients G = mode_gradients(modes, X, point.r, J, element_side_frames(e));
    for (int mode = 0; mode < 2; ++mode) {
      const Eigen::Matrix2d& M = point.M[static_cast<std::size_t>(mode)];
      // M : grad psi, in the order of the rows of ModeGradients.
      const Eigen::Vector4d by_row(M(0, 0), M(0, 1), M(1, 0), M(1, 1));
      ModeNumbers value = G.transpose() * by_row;
      if (const double hoop = point.hoop[static_cast<std::size_t>(mode)]; hoop != 0.0) {
        const double x = X.row(0) * element.N(point.r);
        value += hoop / x * mode_x_displacements(modes, X, point.r, element_side_frames(e));
      }
      for (int i = 0; i < modes.freedoms(); ++i) {
        g(freedom[static_cast<std::size_t>(i)], mode) += value[i];
      }
    }
  }
  return g;
}

} // namespace spricka::estimate
