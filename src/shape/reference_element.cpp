// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/reference_element.hpp"

#include "shape/quadrature.hpp"
#include "shape/solid.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace spricka::shape {

namespace {

template <Shape S> ReferenceElement<S::dim> describe() {
  using Element = ReferenceElement<S::dim>;
  Element element;
  element.domain = S::domain;
  element.nodes = S::nodes;
  element.N = [](const Point<S::dim>& r) { return typename Element::Values(S::N(r)); };
  element.dN = [](const Point<S::dim>& r) { return typename Element::ShapeDerivatives(S::dN(r)); };
  element.coordinates = S::coordinates;
  return element;
}

// The linear element with the same corners.
template <ElementShape S> const ReferenceElement<S::dim>& linear_relative() {
  const auto* const linear =
      std::ranges::find_if(base::element_infos, [](const base::ElementInfo& info) {
        return info.domain == S::domain && !info.quadratic;
      });
  return reference_element<S::dim>(base::element_type_by_name(linear->name));
}

template <ElementShape S> const ReferenceElement<S::dim>& element_of() {
  static const ReferenceElement<S::dim> element = [] {
    ReferenceElement<S::dim> described = describe<S>();
    described.corners = base::element_info(S::type).corners;
    described.degree = S::degree;
    described.quadratic = base::element_info(S::type).quadratic;
    described.relative = described.quadratic ? &linear_relative<S>() : nullptr;
    return described;
  }();
  return element;
}

template <Shape S> const ReferenceElement<1>& line_of() {
  static const ReferenceElement<1> line = [] {
    ReferenceElement<1> described = describe<S>();
    described.corners = 2;
    described.quadratic = S::nodes == 3;
    return described;
  }();
  return line;
}

} // namespace

template <int dim> const ReferenceElement<dim>& reference_element(base::ElementType type) {
  return with_element_shape(type, []<ElementShape S>(S) -> const ReferenceElement<dim>& {
    if constexpr (S::dim == dim) {
      return element_of<S>();
    } else {
      assert(false && "reference_element: a type of another dimension");
      std::abort();
    }
  });
}
template const ReferenceElement<2>& reference_element<2>(base::ElementType);
template const ReferenceElement<3>& reference_element<3>(base::ElementType);

template <int dim>
std::span<const ShapeFunctionValues<dim>>
shape_functions_at_quadrature_points(const ReferenceElement<dim>& element, int degree) {
  static std::mutex mutex;
  static std::map<std::pair<const ReferenceElement<dim>*, int>,
                  std::vector<ShapeFunctionValues<dim>>>
      tables;
  const std::lock_guard<std::mutex> guard(mutex);
  std::vector<ShapeFunctionValues<dim>>& table = tables[{&element, degree}];
  if (table.empty()) {
    for (const QuadraturePoint<dim>& point : quadrature<dim>(element.domain, degree)) {
      table.push_back({element.N(point.r), element.dN(point.r)});
    }
  }
  return table;
}
template std::span<const ShapeFunctionValues<2>>
shape_functions_at_quadrature_points(const ReferenceElement<2>&, int);
template std::span<const ShapeFunctionValues<3>>
shape_functions_at_quadrature_points(const ReferenceElement<3>&, int);

const ReferenceElement<1>& reference_line(int nodes) {
  assert(nodes == 2 || nodes == 3);
  return nodes == 2 ? line_of<Line2>() : line_of<Line3>();
}

} // namespace spricka::shape
