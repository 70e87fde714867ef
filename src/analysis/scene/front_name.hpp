// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <string>

namespace spricka::analysis {

/// What a front in space is called: NAME, or NAME.1 and NAME.2 where a crack has several.
inline std::string front_name(const model::Model& model, const Discretisation& scene,
                              const mesh::CrackFront& front) {
  const std::string& name = model.cracks[front.crack.index()].name;
  const auto of_crack = [&](const FrontWithDomains& f) { return f.front.crack == front.crack; };
  return std::ranges::count_if(scene.fronts, of_crack) > 1
             ? name + "." + std::to_string(front.number)
             : name;
}

} // namespace spricka::analysis
