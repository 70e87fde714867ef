// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch_crack.hpp"

#include <algorithm>

namespace spricka::mesh {
namespace {

bool has_mouth(const CrackPlacement& place, const CavityOutlineEdge& edge) {
  return place.mouth && edge.face == place.mouth->face &&
         (!place.mouth->node.valid() || place.mouth->node == edge.edge.mid);
}

} // namespace

std::vector<std::pair<double, std::size_t>> mouths_on_edge(const CavityOutlineEdge& edge,
                                                           const std::vector<PatchCrack>& cracks) {
  std::vector<std::pair<double, std::size_t>> result;
  for (std::size_t i = 0; i < cracks.size(); ++i) {
    if (has_mouth(cracks[i].place, edge)) {
      const MouthPosition& mouth = *cracks[i].place.mouth;
      result.emplace_back(mouth.node.valid() ? 0.0 : mouth.xi, i);
    }
  }
  std::ranges::sort(result, {}, &std::pair<double, std::size_t>::first);
  return result;
}

} // namespace spricka::mesh
