// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/requests_without_target.hpp"

#include "model/model.hpp"

#include <variant>
#include <vector>

#include <fmt/format.h>

namespace spricka::sense {

std::set<std::string> existing_entity_names(const model::Model& model) {
  std::set<std::string> names;
  for (const model::Contact& contact : model.contacts) {
    names.insert(contact.name);
  }
  for (const model::CrackDefinition& crack : model.cracks) {
    names.insert(crack.name);
  }
  const auto add_sets = [&](const auto& sets, auto members) {
    for (const auto& set : sets) {
      if (!(set.*members).empty()) {
        names.insert(set.name);
      }
    }
  };
  add_sets(model.mesh.node_sets, &model::NodeSet::nodes);
  add_sets(model.mesh.element_sets, &model::ElementSet::elements);
  add_sets(model.mesh.face_sets, &model::FaceSet::faces);
  return names;
}

void drop_requests_without_target(model::Model& model, const std::set<std::string>& before,
                                  base::Diagnostics& list) {
  const std::set<std::string> now = existing_entity_names(model);
  const auto is_gone = [&](const std::string& name) {
    return before.contains(name) && !now.contains(name);
  };
  const auto warn = [&](base::SourceSpan span, const std::string& name) {
    list.warning(span, "W366", fmt::format("{} lies on the side that $SYMMETRY leaves away", name),
                 "ask for its mirror image");
  };
  for (model::OutputFileRequest& output : model.outputs) {
    for (const model::RequestedQuantity& request : output.requests) {
      if (is_gone(request.name)) {
        warn(request.span, request.name);
      }
    }
    std::erase_if(output.requests, [&](const auto& request) { return is_gone(request.name); });
  }
  for (const model::ResultCheck& check : model.checks) {
    for (const auto& argument : check.arguments) {
      const auto* const name = std::get_if<std::string>(&argument);
      if (name != nullptr && is_gone(*name)) {
        warn(check.span, *name);
      }
    }
  }
}

} // namespace spricka::sense
