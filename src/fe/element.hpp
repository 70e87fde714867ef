// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/with_dimension.hpp"
#include "fe/dilatation.hpp"
#include "fe/jacobian.hpp"
#include "fe/law.hpp"
#include "model/mesh.hpp"

#include <span>

/// Kernels of one element, on fixed-size matrices; nothing here allocates. Freedom c of local node
/// i is row dim * i + c of an element matrix.
namespace spricka::fe {

/// eps = B u with u by node [components(dim), dim * nodes].
template <shape::Shape S>
Eigen::Matrix<double, strain_components(S::dim), S::dim * S::nodes>
strain_matrix(const Gradients<S>& dNdx) {
  Eigen::Matrix<double, strain_components(S::dim), S::dim * S::nodes> B;
  B.setZero();
  for (int i = 0; i < S::nodes; ++i) {
    const int k = S::dim * i;
    for (int c = 0; c < S::dim; ++c) {
      B(c, k + c) = dNdx(i, c);
    }
    // Shear rows: xy, then yz and zx in space.
    for (int row = S::dim; row < strain_components(S::dim); ++row) {
      const int a = row - S::dim;
      const int b = (a + 1) % S::dim;
      B(row, k + a) = dNdx(i, b);
      B(row, k + b) = dNdx(i, a);
    }
  }
  return B;
}

/// Strain of a displacement gradient H = du/dx = U dNdx.
template <int dim> Strain<dim> strain(const Eigen::Matrix<double, dim, dim>& H) {
  Strain<dim> eps;
  eps.template head<dim>() = H.diagonal();
  for (int row = dim; row < strain_components(dim); ++row) {
    const int a = row - dim;
    const int b = (a + 1) % dim;
    eps[row] = H(a, b) + H(b, a);
  }
  return eps;
}

/// A stress vector as a symmetric tensor [dim, dim]: normal components first, then shear in the
/// order of strain().
template <int dim> Eigen::Matrix<double, dim, dim> stress_tensor(const Strain<dim>& sigma) {
  Eigen::Matrix<double, dim, dim> T;
  T.diagonal() = sigma.template head<dim>();
  for (int row = dim; row < strain_components(dim); ++row) {
    const int a = row - dim;
    const int b = (a + 1) % dim;
    T(a, b) = T(b, a) = sigma[row];
  }
  return T;
}

/// Ke = integral of B^T D B dV [force/length] from nodal coordinates X [dim, nodes]. With the
/// moments M the block of directions a, b is lambda M_ab + mu M_ba + mu delta_ab sum_p M_pp: a
/// quarter of the work of the triple product. Axisymmetric elements add the hoop strain, nearly
/// incompressible ones take lambda with the projected dilatation. Compiled
/// in element_stiffness.cpp for each element.
template <shape::ElementShape S>
ElementMatrix<S> element_stiffness(const NodeVectors<S>& X, const ConstitutiveLaw& law);

/// Volume change at each point: div u with the hoop strain, or its projection.
template <shape::Element S> struct VolumeChangeField {
  S element;
  const ConstitutiveLaw& law;
  typename ProjectedDilatation<S>::Modes projected;

  VolumeChangeField(const S& element_, const NodeVectors<S>& X, const ConstitutiveLaw& law_,
                    const NodeVectors<S>& U)
      : element(element_), law(law_) {
    projected.setZero();
    if (law.projected) {
      projected = ProjectedDilatation<S>(element, X, law).project_displacement_dilatation(U);
    }
  }
  /// The volume change at a reference point: the projected one where the law asks for it, else
  /// `plain`, the one that the displacements themselves have there.
  [[nodiscard]] double at(const shape::Point<S::dim>& r, double plain) const {
    return law.projected ? ProjectedDilatation<S>::phi(element, r).dot(projected) : plain;
  }
};

/// Nodal forces Ke U of displacements U, both [dim, nodes], without forming Ke. With H = (U dN)
/// J^-1 and F = w T J^-T dN^T no derivative with respect to x is formed at the nodes. Compiled in
/// element_force.cpp for each element, and for elements known when run.
template <shape::Element S>
NodeVectors<S> element_force(const S& element, const NodeVectors<S>& X, const ConstitutiveLaw& law,
                             const NodeVectors<S>& U);
/// The same for an element type known when compiled.
template <shape::ElementShape S>
NodeVectors<S> element_force(const NodeVectors<S>& X, const ConstitutiveLaw& law,
                             const NodeVectors<S>& U) {
  return element_force(S{}, X, law, U);
}

/// Calls f(type, block) for each run of equal element types in `elements`, in their order.
template <class F>
void for_type_runs(const model::Mesh& mesh, std::span<const base::ElementId> elements, F&& f) {
  std::size_t begin = 0;
  while (begin < elements.size()) {
    const base::ElementType type = mesh.type[elements[begin].index()];
    std::size_t end = begin + 1;
    while (end < elements.size() && mesh.type[elements[end].index()] == type) {
      ++end;
    }
    f(type, elements.subspan(begin, end - begin));
    begin = end;
  }
}

/// Calls f(S{}, block) for each run of equal element types in `elements`, in their order; f is a
/// generic lambda `[&]<shape::ElementShape S>(S, std::span<const base::ElementId> block)`.
template <class F>
void for_shape_blocks(const model::Mesh& mesh, std::span<const base::ElementId> elements, F&& f) {
  for_type_runs(
      mesh, elements, [&](base::ElementType type, std::span<const base::ElementId> block) {
        shape::with_element_shape(type, [&]<shape::ElementShape S>(S shape) { f(shape, block); });
      });
}

/// Calls f with the reference element of an element; f is a generic lambda
/// `[&]<int dim>(const AnyElement<dim>& element)`.
template <class F>
decltype(auto) with_any_element(const model::Mesh& mesh, base::ElementId e, F&& f) {
  const base::ElementType type = mesh.type[e.index()];
  return base::with_dimension(base::element_info(type).dim, [&](auto dim) -> decltype(auto) {
    return f(shape::reference_element<dim>(type));
  });
}

} // namespace spricka::fe
