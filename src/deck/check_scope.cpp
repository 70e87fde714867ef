// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/dimension_rules.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

/// What the cards ask for together: combinations that make no sense, and those whose analysis this
/// version does not have.
namespace spricka::deck {

namespace {

using model::StressState;

// A plane mesh is a section through bodies about an axis as a whole, or not at all.
void one_symmetry(DeckContext& c) {
  const auto first = std::ranges::find_if(
      c.model.properties, [](const auto& p) { return p.state == StressState::axisymmetric; });
  if (first == c.model.properties.end()) {
    return;
  }
  for (const model::ElementProperty& property : c.model.properties) {
    if (property.state != StressState::axisymmetric) {
      c.error(property.span, "E313", "STATE=AXI and other states in one model",
              "a mesh about an axis has STATE=AXI everywhere");
      return;
    }
  }
  const model::Mesh& mesh = c.model.mesh;
  const double reach = model::axis_tolerance(mesh);
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    if (mesh.x[n].x() < -reach) {
      c.error(
          first->span, "E313",
          fmt::format("STATE=AXI, but node {} has x = {:.6g}", mesh.node_label[n], mesh.x[n].x()),
          "x is the radius, y the axis: bodies lie at x >= 0");
      return;
    }
  }
}

// What growth in space does not have in this version.
void solid_growth_in_reach(DeckContext& c) {
  const model::CrackGrowthSettings& growth = *c.model.growth;
  const auto no = [&](const char* what) {
    c.record_unavailable_analysis(fmt::format("$GROW {} with a crack in space", what), growth.span);
  };
  for (std::size_t i = 0; i < c.model.cracks.size(); ++i) {
    if (growth.law == model::CrackGrowthLaw::increment && growth.grows(base::CrackId(i)) &&
        c.model.cracks[i].kind != model::CrackDefinitionKind::ellipse) {
      c.record_unavailable_analysis("$GROW LAW=INCREMENT with a crack in space that is no ellipse",
                                    growth.span);
    }
  }
  const bool turns = growth.direction != model::GrowthDirection::path;
  if (turns && growth.shape == model::FrontShapeRule::ellipse) {
    no("SHAPE=ELLIPSE and DIRECTION other than PATH");
  }
  if (turns && growth.law == model::CrackGrowthLaw::increment) {
    no("LAW=INCREMENT and DIRECTION other than PATH");
  }
  if (turns && growth.flow_stress) {
    no("SFLOW and DIRECTION other than PATH");
  }
}

// What cracks in space do not have in this version.
void solid_cracks_in_reach(DeckContext& c) {
  if (c.model.growth && !c.model.cracks.empty()) {
    solid_growth_in_reach(c);
  }
  for (const model::TipMeshSettings& tip : c.model.tip_nets) {
    const bool found = c.model.cracks[tip.crack.index()].kind == model::CrackDefinitionKind::front;
    if ((!tip.patch && !found) || tip.join == model::PatchCoupling::transition) {
      c.record_unavailable_analysis(
          fmt::format("$TIPNET {} in space", !tip.patch ? "PATCH=NO" : "JOIN=TRANSITION"),
          tip.span);
    }
  }
  for (const model::VirtualCrackExtensionSettings& vce : c.model.vces) {
    if (vce.shift) {
      c.record_unavailable_analysis("$VCE SHIFT in space", vce.span);
    }
  }
  for (const model::CrackDefinition& crack : c.model.cracks) {
    if (crack.state == model::CrackTipPlaneState::stress) {
      c.record_unavailable_analysis(
          "$CRACK STATE=STRESS in space, where a front is in plane strain,", crack.span);
    }
  }
}

void cracks_in_reach(DeckContext& c) {
  const bool axial = model::is_axisymmetric(c.model);
  for (const model::CrackDefinition& crack : c.model.cracks) {
    if (axial && crack.state == model::CrackTipPlaneState::stress) {
      c.record_unavailable_analysis(
          "$CRACK STATE=STRESS about an axis, where a front is in plane strain,", crack.span);
    }
  }
  if (dimension_rules.at(c.model.mesh.dim).ends_in_fronts) {
    solid_cracks_in_reach(c);
  }
  if (c.model.cracks.empty()) {
    return;
  }
  // Such elements carry a projected dilatation, whose derivative with respect to the shape the
  // virtual crack extension does not have.
  const model::Mesh& mesh = c.model.mesh;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const base::ElementId id(e);
    const model::ElasticMaterial& material = c.model.element_material(mesh, id);
    const model::ElementProperty& property = c.model.element_property(mesh, id);
    if (model::is_nearly_incompressible(material, property.state,
                                        base::element_info(mesh.type[e]).quadratic)) {
      c.record_unavailable_analysis(
          fmt::format("$CRACK with {} elements and nu = {:.6g}, nearly incompressible,",
                      base::element_info(mesh.type[e]).name, material.nu),
          c.model.cracks.front().span);
      return;
    }
  }
}

void loads_in_reach(DeckContext& c) {
  const bool axial = model::is_axisymmetric(c.model);
  c.for_each_sound_card("LOAD", [&](const CheckedCard& card) {
    if (card.key_has_word("TYPE", "BEARING") && axial) {
      c.error(card.span, "E313",
              "TYPE=BEARING pushes to one side: it means nothing with STATE=AXI");
    }
  });
}

// Heat that nothing feels is a forgotten key.
void heated_materials_expand(DeckContext& c) {
  std::vector<bool> reported(c.model.materials.size(), false);
  for (const model::LoadCase& load_case : c.model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (load.type != model::LoadType::temperature) {
        continue;
      }
      for (const base::ElementId e : c.model.mesh.set_with_id(load.elements).elements) {
        const std::size_t m = c.model.element_property(c.model.mesh, e).material.index();
        const model::ElasticMaterial& material = c.model.materials[m];
        if (material.alpha == 0.0 && !reported[m]) {
          reported[m] = true;
          c.warning(material.span, "W313",
                    fmt::format("material {} is heated, but has no ALPHA: it does not "
                                "expand",
                                material.name),
                    "ALPHA is the thermal expansion per degree");
        }
      }
    }
  }
}

} // namespace

void check_model_consistency(DeckContext& context) {
  if (context.diagnostics.has_errors()) { // elements may lack a property
    return;
  }
  one_symmetry(context);
  cracks_in_reach(context);
  loads_in_reach(context);
  heated_materials_expand(context);
  check_thickness(context);
}

} // namespace spricka::deck
