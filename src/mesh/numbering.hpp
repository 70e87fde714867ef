// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/mesh.hpp"

#include <vector>

namespace spricka::mesh {

/// One above the highest node label of a net; 1 for an empty net.
base::Label next_node_label(const model::Mesh& mesh, base::NetId net);

/// One above the highest element label of a net; 1 for an empty net.
base::Label next_element_label(const model::Mesh& mesh, base::NetId net);

/// Labels by which a file can name things: the labels themselves, or where one stands twice, in
/// nets, numbers from 1 on.
std::vector<base::Label> make_labels_unique(const std::vector<base::Label>& labels);

} // namespace spricka::mesh
