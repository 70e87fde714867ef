// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/numbering.hpp"

#include "mesh/label_index.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace spricka::mesh {
namespace {

base::Label next(const std::vector<base::Label>& labels, const std::vector<base::NetId>& nets,
                 base::NetId net) {
  base::Label highest = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (nets[i] == net) {
      highest = std::max(highest, labels[i]);
    }
  }
  return highest + 1;
}

} // namespace

base::Label next_node_label(const model::Mesh& mesh, base::NetId net) {
  return next(mesh.node_label, mesh.node_net, net);
}

base::Label next_element_label(const model::Mesh& mesh, base::NetId net) {
  return next(mesh.element_label, mesh.element_net, net);
}

std::vector<base::Label> make_labels_unique(const std::vector<base::Label>& labels) {
  std::vector<base::Label> result = labels;
  if (LabelIndex(labels).has_duplicates()) {
    std::iota(result.begin(), result.end(), base::Label{1});
  }
  return result;
}

} // namespace spricka::mesh
