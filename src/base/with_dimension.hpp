// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <type_traits>
#include <utility>

namespace spricka::base {

/// Calls f with a dimension, 2 or 3, as a constant, for what is compiled for each, and returns what
/// it returns; f is a generic lambda `[&](auto dim) { .. template_of<dim>() .. }`.
template <class F> decltype(auto) with_dimension(int dim, F&& f) {
  return dim == 2 ? std::forward<F>(f)(std::integral_constant<int, 2>())
                  : std::forward<F>(f)(std::integral_constant<int, 3>());
}

} // namespace spricka::base
