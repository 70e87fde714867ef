// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/answers.hpp"

#include "mesh/gmsh_elements.hpp"
#include "mesher/gmsh_session.hpp"
#include "mesher/gmsh_sizes.hpp"

#include <gmsh.h>

#include <algorithm>
#include <new>
#include <set>
#include <utility>

namespace spricka::mesher {
namespace {

using mesh::GmshElementBlock;
using mesh::GmshModel;
using mesh::GmshPhysicalGroup;

/// Elements on one entity, a block for each type.
void add_blocks(int dim, int entity, std::vector<GmshElementBlock>& blocks) {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags;
  std::vector<std::vector<std::size_t>> nodes;
  gmsh::model::mesh::getElements(types, tags, nodes, dim, entity);
  for (std::size_t t = 0; t < types.size(); ++t) {
    GmshElementBlock block{entity, types[t], {}, std::move(tags[t]), std::move(nodes[t])};
    if (!mesh::find_gmsh_element_type(types[t])) {
      int itself = 0;
      int order = 0;
      int count = 0;
      int primary = 0;
      std::vector<double> local;
      gmsh::model::mesh::getElementProperties(types[t], block.type_name, itself, order, count,
                                              local, primary);
    }
    blocks.push_back(std::move(block));
  }
}

/// The highest dimension that has elements, with their types; 0 without.
int find_dim(std::vector<int>& types) {
  for (int dim = 3; dim >= 2; --dim) {
    gmsh::model::mesh::getElementTypes(types, dim);
    if (!types.empty()) {
      return dim;
    }
  }
  return 0;
}

int make_mesh(const mesh::MesherImportRequest& import) {
  std::vector<int> types;
  int dim = find_dim(types);
  if (dim == 0 && import.script) {
    if (import.size) {
      apply_sizes_and_mesh_curves(import.size);
    }
    gmsh::model::mesh::generate(std::max(2, gmsh::model::getDimension()));
    dim = find_dim(types);
  }
  if (import.step && prepare_step_mesh(*import.step)) {
    gmsh::model::mesh::generate(3);
    gmsh::model::mesh::removeSizeCallback();
    dim = find_dim(types);
  }
  const bool linear = std::any_of(types.begin(), types.end(), [](int number) {
    const auto known = mesh::find_gmsh_element_type(number);
    return known && !base::element_info(known->type).quadratic;
  });
  if (import.quadratic && linear) {
    gmsh::model::mesh::setOrder(2);
  }
  return dim;
}

void take_groups(GmshModel& model) {
  gmsh::vectorpair physical;
  std::set<int> met;
  gmsh::model::getPhysicalGroups(physical);
  for (const auto& [dim, tag] : physical) {
    GmshPhysicalGroup group;
    group.dim = dim;
    group.tag = tag;
    gmsh::model::getPhysicalName(dim, tag, group.name);
    gmsh::model::getEntitiesForPhysicalGroup(dim, tag, group.entities);
    if (dim == model.dim - 1) {
      for (const int entity : group.entities) {
        if (met.insert(entity).second) {
          add_blocks(dim, entity, model.sides);
        }
      }
    } else if (dim != model.dim) {
      std::vector<double> x;
      gmsh::model::mesh::getNodesForPhysicalGroup(dim, tag, group.nodes, x);
    }
    model.groups.push_back(std::move(group));
  }
}

void take_mesh(GmshModel& model) {
  gmsh::vectorpair all;
  gmsh::model::getEntities(all, model.dim > 0 ? model.dim : 2);
  for (const auto& [dim, tag] : all) {
    add_blocks(dim, tag, model.elements);
  }
  std::vector<double> parametric;
  gmsh::model::mesh::getNodes(model.node_tags, model.x, parametric);
}

/// Their values at the end of the script, which has left them in gmsh's own parameters.
void take_constants(const mesh::MesherImportRequest& import, GmshModel& model) {
  for (const std::string& name : import.constants) {
    std::vector<double> value;
    gmsh::onelab::getNumber("spricka/" + name, value);
    if (value.size() == 1) {
      model.constants.emplace_back(name, value.front());
    }
  }
}

} // namespace

mesh::GmshModel read_gmsh_model(const mesh::MesherImportRequest& import, const std::string& path,
                                const std::function<void()>& meshing) {
  GmshModel model;
  const GmshSession session;
  // what it prints is its last words, if it crashes
  gmsh::option::setNumber("General.Verbosity", 2);
  gmsh::option::setNumber("General.Terminal", 1);
  if (import.quadratic) {
    gmsh::option::setNumber("Mesh.ElementOrder", 2);
  }
  try {
    gmsh::open(path);
    if (GmshSession::errors().empty()) {
      take_constants(import, model);
      meshing();
      model.dim = make_mesh(import);
    }
    if (GmshSession::errors().empty()) {
      take_groups(model);
      take_mesh(model);
    }
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) { // gmsh throws a string, or what its parts throw; the log has the words
    model.gave_up = true;
  }
  model.errors = GmshSession::errors();
  model.warnings = GmshSession::warnings();
  return model;
}

} // namespace spricka::mesher
