// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "fe/element.hpp"

namespace spricka::crack {

/// Calls f(S{}, block) for each run of equal types, where all elements are solids; f as for
/// fe::for_blocks.
template <class F>
void for_solid_blocks(const model::Mesh& mesh, std::span<const base::ElementId> elements, F&& f) {
  fe::for_runs(mesh, elements, [&](base::ElementType type, std::span<const base::ElementId> block) {
    assert(base::info(type).dim == 3);
    shape::with_shape(type, [&]<shape::ElementShape S>(S shape) {
      if constexpr (S::dim == 3) {
        f(shape, block);
      }
    });
  });
}

} // namespace spricka::crack
