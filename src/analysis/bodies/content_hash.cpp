// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/content_hash.hpp"

#include "base/hasher.hpp"
#include "model/model.hpp"

#include <algorithm>

namespace spricka::analysis {

namespace {

// Whether a tie has a part in a net: others may change and leave its factor as it is.
bool concerns(const fe::ConstraintTransformation::DependentRow& row,
              const std::vector<bool>& has_node, const Substructure& net, int dim) {
  const auto slave = static_cast<std::size_t>(row.freedom / dim);
  return has_node[slave] || std::ranges::any_of(row.terms, [&](const fe::FreedomTerm& t) {
           return net.map.row[static_cast<std::size_t>(t.freedom)] >= 0;
         });
}

} // namespace

HashKey hash_substructure(const model::Model& model, const model::Mesh& mesh,
                          const Substructure& net, const std::vector<HashKey>& parts) {
  base::Hasher hash;
  std::vector<bool> has_node(mesh.node_count(), false);
  for (const base::ElementId e : net.elements) {
    hash.value(mesh.type[e.index()]);
    const model::ElementProperty& property = model.element_property(mesh, e);
    const model::ElasticMaterial& material = model.element_material(mesh, e);
    hash.value(property.state);
    hash.value(property.thickness);
    hash.value(material.E);
    hash.value(material.nu);
    hash.value(material.alpha);
    for (const base::NodeId n : mesh.element_nodes(e)) {
      has_node[n.index()] = true;
      hash.value(n.value);
      hash.add_bytes(mesh.x[n.index()].data(), 3 * sizeof(double));
    }
  }
  if (net.map.ties) {
    for (const fe::ConstraintTransformation::DependentRow& row : net.map.ties->rows()) {
      if (!concerns(row, has_node, net, mesh.dim)) {
        continue;
      }
      hash.value(row.freedom);
      for (const fe::FreedomTerm& t : row.terms) {
        // Constants of ties are loads: they change no factor.
        hash.value(t.freedom);
        hash.value(t.coefficient);
      }
    }
  }
  // Order and number of locals tell the classes, too: held freedoms have no row.
  hash.add_bytes(net.map.freedom.data(), net.map.freedom.size() * sizeof(std::int32_t));
  hash.value(net.map.locals);
  hash.add_bytes(net.weighed.data(), net.weighed.size() * sizeof(Eigen::Index));
  for (const HashKey& part : parts) {
    // A region is another one where a part in it is.
    hash.value(part.first);
    hash.value(part.second);
  }
  return hash.digest();
}

} // namespace spricka::analysis
