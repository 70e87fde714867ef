// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "mesh/cut/cracked.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <string>

namespace spricka::analysis {

/// What a tip is called: its crack's name, or NAME.1 and NAME.2 where the crack has two.
inline std::string tip_name(const model::Model& model, const mesh::CrackedMesh& cracked,
                            const mesh::Tip& tip) {
  const std::string& name = model.cracks[tip.crack.index()].name;
  const auto of_crack = [&](const mesh::Tip& t) { return t.crack == tip.crack; };
  return std::ranges::count_if(cracked.tips, of_crack) > 1 ? name + "." + std::to_string(tip.number)
                                                           : name;
}

} // namespace spricka::analysis
