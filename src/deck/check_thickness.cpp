// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

/// Thickness and state of plane bodies: a forgotten THICK is 1, and nothing else of a model tells.
namespace spricka::deck {

namespace {

bool is_total(const model::Load& load) {
  return load.type == model::LoadType::force || load.type == model::LoadType::resultant ||
         load.type == model::LoadType::bearing;
}

// One of several properties without THICK is an oversight; with none of them, the thickness matters
// where whole forces are given.
void thickness_is_given(DeckContext& c) {
  const auto has = [&](std::size_t p) { return !c.default_thickness.contains(p); };
  const std::vector<model::ElementProperty>& properties = c.model.properties;
  std::optional<double> given;
  for (std::size_t p = 0; p < properties.size(); ++p) {
    if (model::has_thickness(properties[p].state) && has(p) && !given) {
      given = properties[p].thickness;
    }
  }
  for (const std::size_t p : c.default_thickness) {
    if (given) {
      c.error(properties[p].span, "E432",
              fmt::format("this $PROPERTY has no THICK and would be 1 thick; another has {:.6g}",
                          *given),
              "give all plane properties their THICK, or none");
    }
  }
  if (given || c.default_thickness.empty()) {
    return;
  }
  for (const model::LoadCase& load_case : c.model.cases) {
    if (std::ranges::any_of(load_case.loads, is_total)) {
      c.warning(
          properties[*c.default_thickness.begin()].span, "W432",
          fmt::format("no $PROPERTY has THICK, and load case {} gives forces: the body is taken "
                      "as 1 {} thick",
                      load_case.name, c.model.units.length_name),
          "give THICK; THICK=1 where forces are meant per unit of it");
      return;
    }
  }
}

/// Properties on both sides of a contact, a tie or a seam.
struct AdjoiningProperties {
  std::string what; ///< "contact PIN"
  base::SourceSpan span;
  std::set<std::size_t> one, other;
};

std::set<std::size_t> properties_of(const model::Mesh& mesh,
                                    const std::vector<model::Face>& faces) {
  std::set<std::size_t> result;
  for (const model::Face& face : faces) {
    result.insert(mesh.property[face.element.index()].index());
  }
  return result;
}

std::vector<AdjoiningProperties> meetings_of(const DeckContext& c) {
  const model::Mesh& mesh = c.model.mesh;
  std::vector<AdjoiningProperties> result;
  for (const model::Contact& contact : c.model.contacts) {
    if (contact.master.valid()) {
      result.push_back({"contact " + contact.name, contact.span,
                        properties_of(mesh, mesh.set_with_id(contact.slave).faces),
                        properties_of(mesh, mesh.set_with_id(contact.master).faces)});
    }
  }
  std::vector<std::set<std::size_t>> at_node(mesh.node_count());
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    for (const base::NodeId n : mesh.element_nodes(base::ElementId(e))) {
      at_node[n.index()].insert(mesh.property[e].index());
    }
  }
  for (const model::Mpc& mpc : c.model.mpcs) {
    if (const auto* tie = std::get_if<model::TransitionTie>(&mpc)) {
      AdjoiningProperties m{
          "a tie", tie->span, {}, properties_of(mesh, mesh.set_with_id(tie->master).faces)};
      for (const base::NodeId n : mesh.set_with_id(tie->slave).nodes) {
        m.one.insert(at_node[n.index()].begin(), at_node[n.index()].end());
      }
      result.push_back(std::move(m));
    }
  }
  std::set<std::set<std::size_t>> seams;
  for (const std::set<std::size_t>& here : at_node) {
    if (here.size() > 1 && seams.insert(here).second) {
      result.push_back({"a common edge", c.model.properties[*here.rbegin()].span, here, here});
    }
  }
  return result;
}

void bodies_that_meet_are_alike(DeckContext& c) {
  const std::vector<model::ElementProperty>& properties = c.model.properties;
  std::set<std::array<double, 2>> thicknesses; // each said once
  bool states = false;
  for (const AdjoiningProperties& m : meetings_of(c)) {
    std::set<std::size_t> all = m.one;
    all.insert(m.other.begin(), m.other.end());
    if (all.size() < 2) {
      continue;
    }
    const auto thin = [&](std::size_t a, std::size_t b) {
      return properties[a].thickness < properties[b].thickness;
    };
    const double least = properties[*std::ranges::min_element(all, thin)].thickness;
    const double most = properties[*std::ranges::max_element(all, thin)].thickness;
    if (most - least > 1e-9 * most && thicknesses.insert({least, most}).second) {
      c.warning(m.span, "W433",
                fmt::format("bodies of different thickness meet ({}): {:.6g} and "
                            "{:.6g} {}",
                            m.what, least, most, c.model.units.length_name),
                "meant only where they share their middle plane and the step in "
                "thickness may be smeared");
    }
    const bool mixed = std::ranges::any_of(
        all, [&](std::size_t p) { return properties[p].state != properties[*all.begin()].state; });
    if (mixed && !states) {
      states = true;
      c.warning(m.span, "W434", fmt::format("plane stress meets plane strain ({})", m.what),
                "give the bodies one STATE, unless a thick one holds a thin one");
    }
  }
}

} // namespace

void check_thickness(DeckContext& context) {
  const std::vector<model::ElementProperty>& properties = context.model.properties;
  if (properties.empty() ||
      !std::ranges::all_of(properties, model::has_thickness, &model::ElementProperty::state)) {
    return;
  }
  thickness_is_given(context);
  bodies_that_meet_are_alike(context);
}

} // namespace spricka::deck
