// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <string>

namespace spricka::analysis {

/// What a tip is called: its crack's name, or NAME.1 and NAME.2 where the crack has two.
inline std::string tip_name(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::CrackFront& front) {
  const std::string& name = model.cracks[front.crack.index()].name;
  const auto of_crack = [&](const mesh::CrackFront& t) { return t.crack == front.crack; };
  return std::ranges::count_if(cracked.fronts, of_crack) > 1
             ? name + "." + std::to_string(front.number)
             : name;
}

} // namespace spricka::analysis
