// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/enrichment.hpp"

#include "shape/topology.hpp"

namespace spricka::estimate {

namespace {

/// Calls f(S{}, e) for all elements, which have modes, in their order.
template <class F> void for_elements(const model::Mesh& mesh, F&& f) {
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    with_mode_shape(mesh.type[e],
                    [&]<shape::PlaneShape S>(S shape) { f(shape, base::ElementId(e)); });
  }
}

} // namespace

std::string not_enriched(const model::Model& model, const model::Mesh& mesh) {
  if (mesh.dim != 2) {
    return "the model is no plane one";
  }
  if (model::axisymmetric(model)) {
    return "the model is axisymmetric";
  }
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId id(e);
    if (!has_modes(mesh.type[e])) {
      return "some elements are linear";
    }
    if (fe::law_of(model, mesh, id).projected) {
      return "a material is nearly incompressible";
    }
  }
  return {};
}

double enrichment_bytes(const model::Mesh& mesh) {
  std::size_t numbers = 0;
  for_elements(mesh, [&]<shape::PlaneShape S>(S, base::ElementId /*e*/) {
    constexpr std::size_t m = mode_freedoms<S>;
    numbers += m * m + m * 2 * S::nodes + m;
  });
  return static_cast<double>(numbers * sizeof(double));
}

Enrichment::Enrichment(const model::Model& model, const model::Mesh& mesh, EdgeTable edges,
                       std::vector<bool> framed)
    : model_(model), mesh_(mesh), edges_(std::move(edges)), framed_(std::move(framed)) {
  auto next = static_cast<std::int32_t>(2 * edges_.edges.size());
  first_.reserve(mesh.element_count() + 1);
  first_.push_back(0);
  std::size_t freedoms = 0;
  std::size_t ee = 0;
  std::size_t ep = 0;
  for_elements(mesh, [&]<shape::PlaneShape S>(S, base::ElementId /*e*/) {
    constexpr std::size_t m = mode_freedoms<S>;
    freedoms += m;
    ee += m * m;
    ep += m * 2 * S::nodes;
  });
  freedom_.reserve(freedoms);
  ee_.reserve(ee);
  ep_.reserve(ep);
  for_elements(mesh, [&]<shape::PlaneShape S>(S, base::ElementId e) {
    using M = Modes<S>;
    for (int s = 0; s < M::sides; ++s) {
      const auto edge = static_cast<std::int32_t>(edges_.edge(e, s));
      freedom_.push_back(2 * edge);
      freedom_.push_back(2 * edge + 1);
    }
    for (int i = 2 * M::sides; i < mode_freedoms<S>; ++i) {
      freedom_.push_back(next++);
    }
    first_.push_back(freedom_.size());
    at_ee_.push_back(ee_.size());
    at_ep_.push_back(ep_.size());
    const EnrichedStiffness<S> K(fe::coordinates<S>(mesh, e), fe::law_of(model, mesh, e), sides(e));
    ee_.insert(ee_.end(), K.ee.data(), K.ee.data() + K.ee.size());
    ep_.insert(ep_.end(), K.ep.data(), K.ep.data() + K.ep.size());
  });
  freedoms_ = next;
  sum_diagonal();
}

SideState Enrichment::sides(base::ElementId e) const {
  const base::ElementType type = mesh_.type[e.index()];
  const std::span<const base::NodeId> nodes = mesh_.nodes_of(e);
  SideState state;
  const int corners = base::info(type).corners;
  for (int s = 0; s < corners; ++s) {
    const auto at = static_cast<std::size_t>(s);
    state.sign[at] = side_sign(nodes[at], nodes[static_cast<std::size_t>((s + 1) % corners)]);
    state.framed[at] = framed_[edges_.edge(e, s)];
  }
  return state;
}

base::Vector Enrichment::product(const base::Vector& x) const {
  base::Vector y = base::Vector::Zero(freedoms_);
  for_elements(mesh_, [&]<shape::PlaneShape S>(S, base::ElementId e) {
    constexpr int m = mode_freedoms<S>;
    const Eigen::Map<const Eigen::Matrix<double, m, m>> K(ee_.data() + at_ee_[e.index()]);
    const std::span<const std::int32_t> freedom = of_element(e);
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

void Enrichment::sum_diagonal() {
  diagonal_.assign(static_cast<std::size_t>(freedoms_ / 2), base::Vec3::Zero());
  for_elements(mesh_, [&]<shape::PlaneShape S>(S, base::ElementId e) {
    constexpr int m = mode_freedoms<S>;
    const Eigen::Map<const Eigen::Matrix<double, m, m>> K(ee_.data() + at_ee_[e.index()]);
    const std::span<const std::int32_t> freedom = of_element(e);
    for (int i = 0; i < m; i += 2) {
      diagonal_[static_cast<std::size_t>(freedom[static_cast<std::size_t>(i)]) / 2] +=
          base::Vec3(K(i, i), K(i + 1, i), K(i + 1, i + 1));
    }
  });
}

void Enrichment::take_nodal(const base::Matrix& u, base::Matrix& r) const {
  for_elements(mesh_, [&]<shape::PlaneShape S>(S, base::ElementId e) {
    constexpr int m = mode_freedoms<S>;
    constexpr int p = 2 * S::nodes;
    const Eigen::Map<const Eigen::Matrix<double, m, p>> K(ep_.data() + at_ep_[e.index()]);
    const std::span<const std::int32_t> freedom = of_element(e);
    const std::span<const base::NodeId> nodes = mesh_.nodes_of(e);
    for (Eigen::Index k = 0; k < u.cols(); ++k) {
      Eigen::Matrix<double, p, 1> local;
      for (int n = 0; n < S::nodes; ++n) {
        local.template segment<2>(2 * n) = u.col(k).segment<2>(
            2 * static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(n)].index()));
      }
      const Eigen::Matrix<double, m, 1> force = K * local;
      for (int i = 0; i < m; ++i) {
        r(freedom[static_cast<std::size_t>(i)], k) -= force[i];
      }
    }
  });
}

base::Matrix Enrichment::functional(const std::vector<crack::IntensityPoint>& points) const {
  base::Matrix g = base::Matrix::Zero(freedoms_, 2);
  for (const crack::IntensityPoint& point : points) {
    const base::ElementId e = point.element;
    const std::span<const std::int32_t> freedom = of_element(e);
    with_mode_shape(mesh_.type[e.index()], [&]<shape::PlaneShape S>(S) {
      const fe::NodeVectors<S> X = fe::coordinates<S>(mesh_, e);
      const Eigen::Matrix2d J = X * S::dN(point.r);
      const ModeGradients<S> G = mode_gradients<S>(X, point.r, J, sides(e));
      for (int mode = 0; mode < 2; ++mode) {
        const Eigen::Matrix2d& M = point.M[static_cast<std::size_t>(mode)];
        const Eigen::RowVector4d by_row(M(0, 0), M(0, 1), M(1, 0), M(1, 1));
        const Eigen::Matrix<double, 1, mode_freedoms<S>> value = by_row * G;
        for (int i = 0; i < mode_freedoms<S>; ++i) {
          g(freedom[static_cast<std::size_t>(i)], mode) += value[i];
        }
      }
    });
  }
  return g;
}

} // namespace spricka::estimate
