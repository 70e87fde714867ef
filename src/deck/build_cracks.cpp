// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/build_solid_cracks.hpp"
#include "deck/dimension_rules.hpp"
#include "deck/flaw_place.hpp"
#include "deck/sets.hpp"
#include "geometry/polyline.hpp"
#include "mesh/cut/existing_crack.hpp"
#include "mesh/cut/path_gap.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

// The path as ordered nodes; a face set has no order of its own.
void crack_path(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  const NameReference reference = card.name_reference("PATH");
  const auto path = resolve_node_set(c, reference);
  if (!path) {
    return;
  }
  crack.path = *path;
  const std::vector<base::NodeId>& nodes = c.model.mesh.set_with_id(*path).nodes;
  if (nodes.size() < 2) {
    c.error(reference.span, "E317", "a crack path has at least two nodes");
    return;
  }
  double length = 0.0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    length += (c.model.mesh.x[nodes[i].index()] - c.model.mesh.x[nodes[i - 1].index()]).norm();
  }
  if (resolve_set_kind(c, EntityKind::set, reference) == EntityKind::face_set) {
    c.error(reference.span, "E317", "a crack path needs nodes in order, not faces",
            "make an $NSET with FROM and ORDER");
  } else if (crack.a0 && *crack.a0 >= length) {
    c.error(card.find("A0")->span, "E317", fmt::format("A0: the path is only {} long", length));
  } else if (const auto gap = mesh::find_path_gap(c.model.mesh, nodes)) {
    const auto label = [&](std::size_t i) { return c.model.mesh.node_label[nodes[i].index()]; };
    c.error(reference.span, "E317",
            fmt::format("nodes {} and {} follow each other in the path, but no element edge joins "
                        "them",
                        label(*gap - 1), label(*gap)),
            "order the set from the mouth on: ORDER=(x) or the like on $NSET");
  }
}

// Empty where there are several, or where a mesh could not be made.
std::optional<base::NetId> net_of_all_elements(const model::Model& model) {
  if (model.nets.size() == 1) {
    return base::NetId(std::size_t{0});
  }
  const std::vector<base::NetId>& nets = model.mesh.element_net;
  const bool one = !nets.empty() &&
                   std::ranges::all_of(nets, [&](base::NetId net) { return net == nets.front(); });
  return one ? std::optional(nets.front()) : std::nullopt;
}

// The net that a drawn crack cuts.
void crack_net(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  if (card.has_key("NET")) {
    const NameReference reference = card.name_reference("NET");
    if (find_referenced_definition(c, EntityKind::net, reference) != nullptr) {
      crack.net = c.find_net(reference.name);
    }
  } else if (const std::optional<base::NetId> only = net_of_all_elements(c.model)) {
    crack.net = *only;
  } else {
    c.error(card.span, "E106", "$CRACK needs NET: the net a free crack cuts");
  }
}

void free_crack(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  crack.kind = model::CrackDefinitionKind::free;
  const bool sound = read_crack_points(c, card, 2, "a point of a free crack is x y", crack);
  if (sound && crack.points.empty()) {
    c.error(card.span, "E106", "$CRACK needs PATH, FRONT, or points as data lines",
            "PATH with A0; points x y; or one point with ANGLE and A0");
  } else if (sound && crack.points.size() == 1 && !(crack.angle && crack.a0)) {
    c.error(card.span, "E106", "a free crack of one point needs ANGLE and A0");
  } else if (sound && crack.points.size() > 1 && (crack.angle || crack.a0)) {
    c.error(card.find(crack.angle ? "ANGLE" : "A0")->span, "E110",
            "ANGLE and A0 belong to a free crack of one point");
  }
}

// A crack in the plane that the mesh has already is a path without a patch.
void existing_crack_path(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  mesh::CrackFaceNodes faces;
  const std::string why = mesh::find_existing_crack_path(
      c.model.mesh, c.model.mesh.set_with_id(crack.path).nodes, faces);
  if (!why.empty()) {
    c.error(card.name_reference("FRONT").span, "E439",
            fmt::format("crack {}: {}", crack.name, why));
    return;
  }
  std::vector<base::Vec3> points;
  for (const base::NodeId node : faces.left) {
    points.push_back(c.model.mesh.x[node.index()]);
  }
  const bool two_tips = faces.left.front() == faces.right.front();
  crack.kind = model::CrackDefinitionKind::path;
  crack.a0 = geometry::polyline_length(points) * (two_tips ? 0.5 : 1.0);
  crack.path = base::NodeSetId(c.model.mesh.node_sets.size());
  c.model.mesh.node_sets.push_back(
      {fmt::format("{}.PATH", crack.name), std::move(faces.left), crack.span});
  crack.right_face_nodes = std::move(faces.right);
}

// An empty face set for a crack face; what names it is the load, see build_loads.
base::FaceSetId crack_face(DeckContext& c, const model::CrackDefinition& crack,
                           std::string_view side) {
  std::vector<model::FaceSet>& sets = c.model.mesh.face_sets;
  sets.push_back({fmt::format("{}.{}", crack.name, side), {}, crack.span});
  return base::FaceSetId(sets.size() - 1);
}

// A flaw by words: a free crack of two points, of which ANGLE says the place.
void flaw_on_edge(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  crack.kind = model::CrackDefinitionKind::free;
  crack.angle.reset();
  if (const auto points = place_plane_flaw(c, card)) {
    crack.points.assign(points->begin(), points->end());
  }
}

// What is drawn by keys and points; where there is no mesh to tell, they tell plane from space.
void drawn_crack(DeckContext& c, const CheckedCard& card, model::CrackDefinition& crack) {
  const bool meshed = c.mesh_sound && c.model.mesh.element_count() > 0;
  const bool plane = c.is_certainly_plane();
  const char* of_space = card.has_key("A")    ? "A"
                         : card.has_key("AT") ? "AT"
                         : card.has_key("X0") ? "X0"
                                              : nullptr;
  const bool three = !card.rows.empty() && card.rows.front().fields.size() == 3;
  if (plane && card.has_key("AT")) {
    flaw_on_edge(c, card, crack);
  } else if (plane && of_space != nullptr) {
    c.error(card.find(of_space)->span, "E313",
            "an ellipse, or a front by its points, belongs to elements in space",
            "in the plane a crack has PATH and A0, or points x y");
  } else if (meshed ? plane : of_space == nullptr && !three) {
    free_crack(c, card, crack);
  } else {
    read_solid_crack(c, card, crack);
  }
}

void crack(DeckContext& c, const CheckedCard& card) {
  model::CrackDefinition crack;
  crack.name = card.word_value("NAME");
  crack.a0 = card.optional_number("A0");
  crack.angle = card.optional_number("ANGLE");
  crack.state = card.key_has_word("STATE", "STRESS")   ? model::CrackTipPlaneState::stress
                : card.key_has_word("STATE", "STRAIN") ? model::CrackTipPlaneState::strain
                                                       : model::CrackTipPlaneState::automatic;
  crack.smooth = card.key_has_word("LINE", "SMOOTH");
  crack.faces_in_contact = card.key_has_word("FACES", "CONTACT");
  crack.mu = card.number_value("MU");
  crack.span = card.span;
  if (card.has_key("PATH")) {
    crack_path(c, card, crack);
    if (c.mesh_sound && c.model.mesh.element_count() > 0 && !c.is_certainly_plane()) {
      c.error(card.find("PATH")->span, "E313", "a crack path belongs to elements in the plane",
              "in space a crack has FRONT, A and C of an ellipse, or points x y z");
    }
  } else if (card.has_key("FRONT")) {
    crack.kind = model::CrackDefinitionKind::front;
    crack.path = resolve_node_set(c, card.name_reference("FRONT")).value_or(base::NodeSetId());
    if (c.is_certainly_plane() && c.mesh_sound && crack.path.valid()) {
      existing_crack_path(c, card, crack);
    }
  } else {
    drawn_crack(c, card, crack);
    crack_net(c, card, crack);
  }
  if ((card.has_key("PATH") || card.has_key("FRONT")) && !card.rows.empty()) {
    c.error(card.rows.front().span, "E110", "points mean nothing with PATH or FRONT");
  }
  crack.left = crack_face(c, crack, "LEFT");
  crack.right = crack_face(c, crack, "RIGHT");
  c.model.cracks.push_back(std::move(crack));
}

// The crack a $TIPNET or $VCE belongs to; each crack has at most one of each.
base::CrackId crack_of(DeckContext& c, const CheckedCard& card, std::set<std::size_t>& seen) {
  const NameDefinition* found =
      find_referenced_definition(c, EntityKind::crack, card.name_reference("CRACK"));
  if (found == nullptr) {
    return {};
  }
  if (!seen.insert(found->index).second) {
    c.error(card.find("CRACK")->span, "E302",
            fmt::format("a second ${} for crack {}", card.spec->name, card.word_value("CRACK")));
  }
  return base::CrackId(found->index);
}

// A patch as fine as usual finds K to about a thousandth; its error falls with the cube of its
// sizes.
double finer_for(double tolerance) {
  constexpr double usual = 1e-3;
  return std::clamp(std::cbrt(usual / tolerance), 0.6, 1.0);
}

void tip_net(DeckContext& c, const CheckedCard& card, std::set<std::size_t>& seen) {
  model::TipMeshSettings tip;
  tip.crack = crack_of(c, card, seen);
  tip.radius = card.optional_number("RADIUS");
  tip.size = card.optional_number("SIZE");
  const DimensionRules& rules = dimension_rules.at(c.model.mesh.dim);
  const auto count = [&](std::string_view key, const std::optional<int>& usual) {
    const int given = card.integer_value(key); // or what the grammar has for a rosette
    return card.has_key(key) ? given : usual.value_or(given);
  };
  tip.rings = count("RINGS", rules.tip_rings);
  tip.sectors = count("SECTORS", rules.tip_sectors);
  tip.sizes_given = card.has_key("SIZE") || card.has_key("RINGS") || card.has_key("SECTORS");
  tip.quarter_point = card.key_has_word("QUARTER", "YES");
  tip.join = card.key_has_word("JOIN", "TRANSITION") ? model::PatchCoupling::transition
                                                     : model::PatchCoupling::conforming;
  tip.patch = card.key_has_word("PATCH", "YES");
  tip.tube = card.key_has_word("TUBE", "YES");
  if (!tip.tube && c.is_certainly_plane()) {
    c.error(card.find("TUBE")->span, "E313", "TUBE=NO means nothing in the plane",
            "round a tip in the plane stands a rosette; QUARTER=NO has ordinary elements in it");
  }
  tip.tolerance = card.optional_number("TOL");
  tip.finer = card.number_value("FINER");
  if (tip.tolerance && !rules.ends_in_fronts && !card.has_key("FINER") && !tip.sizes_given) {
    tip.finer = finer_for(*tip.tolerance);
  }
  tip.span = card.span;
  if (tip.radius && tip.size && *tip.size >= *tip.radius) {
    c.error(card.find("SIZE")->span, "E109", "SIZE: the tip elements are smaller than RADIUS");
  }
  c.model.tip_nets.push_back(tip);
}

void vce(DeckContext& c, const CheckedCard& card, std::set<std::size_t>& seen) {
  model::VirtualCrackExtensionSettings vce;
  vce.crack = crack_of(c, card, seen);
  vce.shift = card.optional_number("SHIFT");
  vce.opening = card.key_has_word("CHECK", "OPENING");
  vce.span = card.span;
  if (card.has_key("DOMAINS")) {
    for (const double rings : card.find("DOMAINS")->numbers) {
      if (rings < 1.0) {
        c.error(card.find("DOMAINS")->span, "E109", "DOMAINS: a domain has at least one ring");
        break;
      }
      vce.domains.push_back(static_cast<int>(rings));
    }
  }
  c.model.vces.push_back(std::move(vce));
}

// What the mesh has already stays as it is, with a $TIPNET of its own or without one.
void keep_meshes_of_existing_cracks(DeckContext& c) {
  for (std::size_t i = 0; i < c.model.cracks.size(); ++i) {
    if (c.model.cracks[i].right_face_nodes.empty()) {
      continue;
    }
    auto own =
        std::ranges::find(c.model.tip_nets, base::CrackId(i), &model::TipMeshSettings::crack);
    if (own == c.model.tip_nets.end()) {
      own = c.model.tip_nets.insert(own, model::TipMeshSettings());
      own->crack = base::CrackId(i);
      own->span = c.model.cracks[i].span;
    }
    own->patch = false;
  }
}

} // namespace

void build_cracks(DeckContext& context) {
  std::set<std::size_t> with_tip_net;
  std::set<std::size_t> with_vce;
  for (const CheckedCard& card : context.cards) {
    if (card.bad) {
      continue;
    }
    if (card.spec->name == "CRACK") {
      crack(context, card);
    } else if (card.spec->name == "TIPNET") {
      tip_net(context, card, with_tip_net);
    } else if (card.spec->name == "VCE") {
      vce(context, card, with_vce);
    }
  }
  keep_meshes_of_existing_cracks(context);
}

} // namespace spricka::deck
