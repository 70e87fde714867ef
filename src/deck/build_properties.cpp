// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/sets.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

void material(DeckContext& c, const CheckedCard& card) {
  model::ElasticMaterial material;
  material.name = card.word_value("NAME");
  material.E = card.number_value("E");
  material.nu = card.number_value("NU");
  material.rho = card.number_value("RHO");
  material.alpha = card.number_value("ALPHA");
  material.span = card.span;
  constexpr double absurd = 1e100; // in any unit; squares of it are still numbers
  if (material.E > absurd || material.E < 1.0 / absurd) {
    c.error(card.find("E")->span, "E109",
            fmt::format("E: {:.6g} cannot be computed with", material.E),
            "a modulus between 1e-100 and 1e100, in whatever unit");
  }
  c.model.materials.push_back(material);
}

model::StressState state_of(std::string_view word) {
  if (word == "STRESS") {
    return model::StressState::plane_stress;
  }
  if (word == "STRAIN") {
    return model::StressState::plane_strain;
  }
  return word == "AXI" ? model::StressState::axisymmetric : model::StressState::solid;
}

void property(DeckContext& c, const CheckedCard& card) {
  model::Mesh& mesh = c.model.mesh;
  const auto elements = resolve_element_set(c, card.name_reference("ESET"));
  const NameDefinition* material_name =
      find_referenced_definition(c, EntityKind::material, card.name_reference("MATERIAL"));
  if (!elements || material_name == nullptr) {
    c.property_sound = false;
    return;
  }
  model::ElementProperty property;
  property.elements = *elements;
  property.material = base::MaterialId(material_name->index);
  property.state = state_of(card.word_value("STATE"));
  property.thickness = card.number_value("THICK");
  property.span = card.span;
  const base::PropertyId id(c.model.properties.size());
  for (const base::ElementId e : mesh.set_with_id(*elements).elements) {
    if (mesh.property[e.index()].valid()) {
      c.error(card.find("ESET")->span, "E306",
              fmt::format("element {} has a property already", mesh.element_label[e.index()]),
              "one $PROPERTY for each element");
      c.property_sound = false;
      break;
    }
    if (base::element_info(mesh.type[e.index()]).dim != model::element_dimension(property.state)) {
      c.error(card.find("STATE")->span, "E313",
              fmt::format("STATE={} does not fit element {}, a {}", card.word_value("STATE"),
                          mesh.element_label[e.index()],
                          base::element_info(mesh.type[e.index()]).name),
              "SOLID is for elements in space, the others for those in the plane");
      c.property_sound = false;
      break;
    }
    mesh.property[e.index()] = id;
  }
  if (!card.has_key("THICK") && model::has_thickness(property.state)) {
    c.default_thickness.insert(c.model.properties.size());
  }
  c.model.properties.push_back(property);
}

void freedom(DeckContext& c, const CheckedCard& card) {
  auto nodes = collect_listed_nodes(c, card);
  if (!nodes || card.bad) {
    c.freedom_sound = false;
    return;
  }
  const std::string_view dof = card.word_value("DOF");
  model::NodeSetFreedomRole freedom;
  freedom.cls = card.key_has_word("CLASS", "SUPPRESSED")   ? model::FreedomRole::suppressed
                : card.key_has_word("CLASS", "PRESCRIBED") ? model::FreedomRole::prescribed
                                                           : model::FreedomRole::external;
  freedom.dof = {dof.find('X') != std::string_view::npos, dof.find('Y') != std::string_view::npos,
                 dof.find('Z') != std::string_view::npos};
  freedom.nodes = base::NodeSetId(c.model.mesh.node_sets.size());
  freedom.span = card.span;
  if (freedom.dof[2] && c.is_certainly_plane()) {
    c.error(card.find("DOF")->span, "E313", "DOF: a plane model has no freedoms along Z");
  }
  c.model.mesh.node_sets.push_back({{}, std::move(*nodes), card.span});
  c.model.freedoms.push_back(freedom);
}

void symmetry(DeckContext& c, const CheckedCard& card) {
  model::MirrorPlane plane;
  plane.axis = card.word_value("NORMAL").front() - 'X';
  plane.above = card.key_has_word("KEEP", "ABOVE");
  plane.span = card.span;
  const base::SourceSpan at = card.find("NORMAL")->span;
  if (plane.axis == 2 && c.is_certainly_plane()) {
    c.error(at, "E313", "NORMAL: a plane model has no side across Z");
  }
  if (std::ranges::any_of(c.model.mirrors, [&](const model::MirrorPlane& other) {
        return other.axis == plane.axis;
      })) {
    c.error(at, "E302",
            fmt::format("a second $SYMMETRY with NORMAL={}", card.word_value("NORMAL")));
  }
  c.model.mirrors.push_back(plane);
}

} // namespace

void build_properties(DeckContext& context) {
  context.for_each_sound_card("MATERIAL",
                              [&](const CheckedCard& card) { material(context, card); });
  for (const mesh::ImportedMaterialsAndEquations& physics : context.imported) {
    mesh::append_materials_and_equations(context.model, physics);
  }
  for (const CheckedCard& card : context.cards) {
    if (card.spec->name == "PROPERTY" && !card.bad) {
      property(context, card);
    } else if (card.spec->name == "FREEDOM") {
      freedom(context, card);
    } else if (card.spec->name == "SYMMETRY" && !card.bad) {
      symmetry(context, card);
    }
  }
}

} // namespace spricka::deck
