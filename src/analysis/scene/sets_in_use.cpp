// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/sets_in_use.hpp"

#include "model/model.hpp"

#include <set>
#include <string>
#include <utility>
#include <variant>

namespace spricka::analysis {

namespace {

class SetUses {
public:
  explicit SetUses(const model::Model& model) : model_(model) {
    use_.nodes.assign(model.mesh.node_sets.size(), false);
    use_.elements.assign(model.mesh.element_sets.size(), false);
    use_.faces.assign(model.mesh.face_sets.size(), false);
  }

  mesh::SetUsage all() {
    for (const model::ElementProperty& property : model_.properties) {
      mark(property.elements);
    }
    for (const model::NodeSetFreedomRole& freedom : model_.freedoms) {
      mark(freedom.nodes);
      if (freedom.cls != model::FreedomRole::external) {
        hold(freedom.nodes);
      }
    }
    for (const model::Mpc& mpc : model_.mpcs) {
      add(mpc);
    }
    for (const model::LoadCase& load_case : model_.cases) {
      for (const model::Load& load : load_case.loads) {
        mark(load.nodes);
        mark(load.elements);
        mark(load.faces);
        if (load.type == model::LoadType::displacement) {
          hold(load.nodes);
        }
      }
    }
    for (const model::Contact& contact : model_.contacts) {
      mark(contact.slave);
      mark(contact.master);
    }
    add_names();
    return std::move(use_);
  }

private:
  void mark(base::NodeSetId set) {
    if (set.valid()) {
      use_.nodes[set.index()] = true;
    }
  }
  void mark(base::ElementSetId set) {
    if (set.valid()) {
      use_.elements[set.index()] = true;
    }
  }
  void mark(base::FaceSetId set) {
    if (set.valid()) {
      use_.faces[set.index()] = true;
    }
  }
  void hold(base::NodeSetId set) {
    if (set.valid()) {
      use_.held.push_back(set);
    }
  }

  void add(const model::Mpc& mpc) {
    if (const auto* transition = std::get_if<model::TransitionTie>(&mpc)) {
      mark(transition->slave);
      mark(transition->master);
    } else if (const auto* rigid = std::get_if<model::RigidTie>(&mpc)) {
      mark(rigid->slave);
    }
  }

  /// Checks and outputs look for sets by their names.
  void add_names() {
    std::set<std::string> names;
    for (const model::ResultCheck& check : model_.checks) {
      for (const auto& argument : check.arguments) {
        if (const auto* name = std::get_if<std::string>(&argument)) {
          names.insert(*name);
        }
      }
    }
    for (const model::OutputFileRequest& output : model_.outputs) {
      for (const model::RequestedQuantity& request : output.requests) {
        names.insert(request.name);
      }
    }
    names.erase("");
    const auto take = [&](const auto& sets, std::vector<bool>& used) {
      for (std::size_t s = 0; s < sets.size(); ++s) {
        used[s] = used[s] || names.contains(sets[s].name);
      }
    };
    take(model_.mesh.node_sets, use_.nodes);
    take(model_.mesh.element_sets, use_.elements);
    take(model_.mesh.face_sets, use_.faces);
  }

  const model::Model& model_;
  mesh::SetUsage use_;
};

} // namespace

mesh::SetUsage sets_in_use(const model::Model& model) {
  return SetUses(model).all();
}

} // namespace spricka::analysis
