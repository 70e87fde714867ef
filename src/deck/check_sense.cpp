// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "deck/dimension_rules.hpp"
#include "deck/residual_balance.hpp"
#include "deck/unit_warnings.hpp"
#include "geometry/polyline.hpp"
#include "mesh/cut/host.hpp"
#include "mesh/cut/mouth.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

/// Values that the language allows and hardly anybody means: said, not refused.
namespace spricka::deck {

namespace {

void angles(DeckContext& c) {
  for (const CheckedCard& card : c.cards) {
    for (const CheckedValue& value : card.values) {
      if (value.given && value.key != nullptr &&
          value.key->quantity == grammar::QuantityKind::angle) {
        warn_of_whole_radians(c, value.span, value.key->name, value.number);
      }
    }
  }
}

bool is_power_of_ten(double value) {
  return std::pow(10.0, std::round(std::log10(value))) == value;
}

// Whether the deck works a modulus out, as 1000 times that of another body.
bool is_worked_out(const DeckContext& c, const model::ElasticMaterial& material) {
  const CheckedCard* card = c.find_sound_card_named("MATERIAL", material.name);
  return card != nullptr &&
         c.sources.text(card->find("E")->span).find('*') != std::string_view::npos;
}

// Nothing is stiffer than diamond, E = 1.2e12 Pa; bodies that stand for rigid ones may be a
// thousand times as stiff as others. Linear elasticity ends with rubber, at some 1e6 Pa. A modulus
// of 1, 1000 or 1e9 is that of a problem without dimensions.
void moduli(DeckContext& c) {
  constexpr double stiffest = 5e12;
  constexpr double rigid = 1.2e15;
  constexpr double softest = 3e5;
  const base::UnitSystem& units = c.model.units;
  const double pascal = units.newton_per_force / std::pow(units.metre_per_length, 2);
  const bool all_stiff =
      std::ranges::all_of(c.model.materials, [&](const model::ElasticMaterial& other) {
        return other.E * pascal > stiffest;
      });
  for (const model::ElasticMaterial& material : c.model.materials) {
    const double E = material.E * pascal;
    const bool stiff = E > rigid || (E > stiffest && !is_power_of_ten(material.E) &&
                                     (all_stiff || !is_worked_out(c, material)));
    if (stiff || (E < softest && !is_power_of_ten(material.E))) {
      c.warning(
          material.span, "W343",
          fmt::format("material {}: E = {:.4g} {} is {:.3g} {}Pa, {}", material.name, material.E,
                      units.stress_name(), stiff ? E / 1e9 : E / 1e3, stiff ? 'G' : 'k',
                      stiff ? "stiffer than anything there is" : "softer than any rubber"),
          stiff ? "a number without a unit counts in the deck's; write E=210[GPa]; what is to be "
                  "rigid is $RIGID"
                : "a number without a unit counts in the deck's; write E=210[GPa]");
    }
  }
}

std::string_view word_of(model::StressState state) {
  return state == model::StressState::plane_stress ? "STRESS" : "STRAIN";
}

// K belongs to G by E or by E/(1 - nu^2): that of another state than the elements' is off by
// 1 - nu^2 under a root.
void crack_states(DeckContext& c) {
  const model::Mesh& mesh = c.model.mesh;
  for (const model::CrackDefinition& crack : c.model.cracks) {
    if (crack.state == model::CrackTipPlaneState::automatic) {
      continue;
    }
    const base::NetId net = crack.kind == model::CrackDefinitionKind::free ? crack.net
                            : crack.path.valid() && !mesh.set_with_id(crack.path).nodes.empty()
                                ? mesh.node_net[mesh.set_with_id(crack.path).nodes.front().index()]
                                : base::NetId();
    const model::StressState own = crack.state == model::CrackTipPlaneState::stress
                                       ? model::StressState::plane_stress
                                       : model::StressState::plane_strain;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      const model::StressState state = c.model.element_property(mesh, base::ElementId(e)).state;
      if (mesh.element_net[e] != net || state == own || !model::has_thickness(state)) {
        continue;
      }
      c.warning(
          crack.span, "W344",
          fmt::format("crack {} has STATE={}, the elements round it STATE={}: K is found from G by "
                      "another modulus than the stresses have",
                      crack.name, word_of(own), word_of(state)),
          "leave STATE of $CRACK away: it follows the elements");
      break;
    }
  }
}

double length_of(const model::CrackDefinition& crack) {
  return crack.a0 ? *crack.a0 : geometry::polyline_length(crack.points);
}

// A start inside, but by a small part of the length: of an edge crack whose mouth missed the edge.
void crack_starts(DeckContext& c) {
  constexpr double missed = 0.1;
  const auto drawn = [](const model::CrackDefinition& crack) {
    return crack.kind == model::CrackDefinitionKind::free && !crack.points.empty();
  };
  if (std::ranges::none_of(c.model.cracks, drawn)) { // free ones are of the plane
    return;
  }
  const mesh::HostMesh host(c.model.mesh);
  for (const model::CrackDefinition& crack : c.model.cracks) {
    if (!drawn(crack) || mesh::locate_crack_start(host, crack.points.front(), crack.net) !=
                             mesh::CrackStartLocation::inside) {
      continue;
    }
    const mesh::NearestMouth edge = mesh::find_crack_mouth(host, crack.points.front(), crack.net);
    if (edge.distance < missed * length_of(crack)) {
      c.warning(
          crack.span, "W345",
          fmt::format("crack {} starts inside the body, only {:.3g} from its surface: it has two "
                      "tips and a ligament there",
                      crack.name, edge.distance),
          fmt::format("a crack from the surface starts on it, at ({:.9g}, {:.9g})", edge.at.x(),
                      edge.at.y()));
    }
  }
}

// Pressure and traction act on whole faces of the mesh.
void cut_sets(DeckContext& c) {
  for (const model::LoadCase& load_case : c.model.cases) {
    for (const model::Load& load : load_case.loads) {
      const bool by_area =
          load.type == model::LoadType::pressure || load.type == model::LoadType::traction;
      const auto border = load.faces.valid() && by_area ? c.set_borders.find(load.faces.index())
                                                        : c.set_borders.end();
      if (border == c.set_borders.end()) {
        continue;
      }
      const FaceSetConditionAreas& area = border->second;
      const std::string unit =
          unit_name(c.model.units, dimension_rules.at(c.model.mesh.dim).side_measure);
      c.warning(
          load.span, "W372",
          fmt::format("load case {}: the border of {} runs through faces: the load acts on whole "
                      "ones, {:.4g} {} in all, and its condition holds on {:.4g} {}",
                      load_case.name, c.model.mesh.set_with_id(load.faces).name, area.taken, unit,
                      area.meant, unit),
          "divide the mesh at the border, or load the whole side by an expression that has the "
          "condition as a factor, as in (10*(x > 0.5))");
    }
  }
}

} // namespace

void check_plausibility(DeckContext& context) {
  angles(context);
  if (context.diagnostics.has_errors()) {
    return;
  }
  cut_sets(context);
  moduli(context);
  crack_states(context);
  crack_starts(context);
  check_residual_balance(context);
}

} // namespace spricka::deck
