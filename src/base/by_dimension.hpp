// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spricka::base {

/// What differs between models of the plane and of space: headings, columns, axes.
template <class T> struct ByDimension {
  T plane, space;

  /// The one of a model of `dim` dimensions, 2 or 3.
  [[nodiscard]] constexpr const T& at(int dim) const { return dim == 3 ? space : plane; }
};

/// clang below 17 does not see it by itself.
template <class T> ByDimension(T, T) -> ByDimension<T>;

} // namespace spricka::base
