// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "analysis/scene/scene.hpp"
#include "fe/locate.hpp"
#include "fe/stress.hpp"

#include <string_view>

/// Nodes of the net whose elements the patch of a crack has replaced. Their places are still in the
/// body: displacements and stresses there are those of the patch's elements, and sets keep them.
namespace spricka::analysis {

struct RemovedNodePlace {
  base::NodeId node; ///< of no element
  fe::PointElementGroup side;
};

/// Where such a node lies on a crack, the body has two sides there: a further node without element
/// stands for the second.
void add_second_side_nodes(const model::Mesh& host, model::Mesh& cracked);

/// The places of all such nodes in the mesh with cracks, ascending by node. Needs
/// add_second_side_nodes.
std::vector<RemovedNodePlace> locate_removed_nodes(const model::Mesh& host,
                                                   const model::Mesh& cracked);

/// Says in the listing how many of them named sets have.
void note_removed_nodes(const model::Model& model, Discretisation& scene);

/// Their displacements, in a nodal vector u [dim * node] of that mesh.
void fill_removed_node_displacements(const model::Mesh& cracked,
                                     const std::vector<RemovedNodePlace>& places, base::Vector& u);

/// Their stresses, in values at the mesh's property points.
void fill_removed_node_stresses(const model::Model& model, const model::Mesh& cracked,
                                const fe::DisplacementTemperatureField& field,
                                std::vector<fe::Stress>& nodal);

/// Lets them be members of their sets in the mesh of results, but where a node of the set with
/// elements has their place. May be done again.
void keep_removed_set_members(const model::Mesh& host, model::Mesh& cracked);

/// A node of the node set of that name that is gone and was held, with no edge of the set that
/// stands in for it: what the supports do there no longer belongs to one node.
std::optional<base::NodeId>
find_removed_held_node(const model::Model& model, const model::Mesh& cracked, std::string_view set);

} // namespace spricka::analysis
