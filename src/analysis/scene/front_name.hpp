// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "model/model.hpp"

#include <string>

namespace spricka::analysis {

/// What a front is called, in the plane a tip: its crack's name, or NAME.1 and NAME.2 where the
/// crack has several.
inline std::string front_name(const model::Model& model, const Discretisation& scene,
                              const mesh::CrackFront& front) {
  const std::string& name = model.cracks[front.crack.index()].name;
  std::size_t of_crack = 0;
  for (const mesh::CrackFront& other : scene.cracked.fronts) {
    of_crack += other.crack == front.crack ? 1 : 0;
  }
  return of_crack > 1 ? name + "." + std::to_string(front.number) : name;
}

} // namespace spricka::analysis
