// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/section_cards.hpp"

#include "base/element_type.hpp"
#include "grammar/lexeme.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"
#include "program/study/deck_edits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace spricka::program {

namespace {

using base::Vec3;
using deck::DeckCard;
using deck::DeckCardList;

bool has_direction(model::LoadType type) {
  return type != model::LoadType::pressure && type != model::LoadType::temperature;
}

// The values of a load at a place, those with a direction by their parts in the section's frame: x,
// y and across it.
Vec3 in_frame(const model::Load& load, const sense::SectionPlane& plane, const Vec3& at,
              double along) {
  const Vec3 x = plane.space_point(at, along);
  Vec3 value = Vec3::Zero();
  for (std::size_t d = 0; d < load.value.size(); ++d) {
    value[static_cast<Eigen::Index>(d)] = load.value[d](x);
  }
  if (!has_direction(load.type)) {
    return {value[0], 0.0, 0.0};
  }
  const double u = value[plane.space_direction_index(0)];
  const double v =
      plane.round ? value[(plane.axis + 2) % 3] : value[plane.space_direction_index(1)];
  if (!plane.round) {
    return {u, v, value[plane.axis]};
  }
  return {u * std::cos(along) + v * std::sin(along), value[plane.axis],
          v * std::cos(along) - u * std::sin(along)};
}

// Whether it is the same all along the axis, or round it as well at angle 0, and acts in the
// section alone.
bool is_uniform(const model::Load& load, const sense::PlaneSectionMesh& section) {
  const sense::SectionPlane& plane = section.plane;
  constexpr std::array shares{0.0, 0.37, 1.0}; // of the depth
  constexpr double same = 1e-9;
  double largest = 0.0;
  double uneven = 0.0;
  for (const Vec3& x : section.mesh.x) {
    const Vec3 here = in_frame(load, plane, x, plane.round ? 0.0 : plane.first);
    largest = std::max(largest, here.norm());
    uneven = std::max(uneven, std::abs(here.z()));
    for (const double share : shares) {
      const Vec3 there = in_frame(load, plane, x, plane.first + share * plane.depth());
      uneven = std::max(uneven, (there - here).norm());
    }
  }
  return uneven <= same * largest;
}

std::string against(const model::Load& load, const sense::PlaneSectionMesh& section) {
  if (load.type == model::LoadType::force) {
    return "forces on single nodes";
  }
  if (!is_uniform(load, section)) {
    return section.plane.round ? "a load that is not the same all round"
                               : "a load that changes, or acts, along the thickness";
  }
  const model::Mesh& mesh = section.mesh;
  if (load.faces.valid() && !section.whole[load.faces.index()]) {
    return "a load on a flat face, or on a part of the thickness";
  }
  if (load.elements.valid() && !section.whole_elements[load.elements.index()]) {
    return "a load on a part of the thickness";
  }
  const bool gone = (load.nodes.valid() && mesh.set_with_id(load.nodes).nodes.empty()) ||
                    (load.elements.valid() && mesh.set_with_id(load.elements).elements.empty());
  return gone ? "a load away from the section" : "";
}

// A name of a field as the section has it; empty: it has not. What does not change along the axis,
// or round it, is taken in the section, or at angle 0.
std::string name_in_section(std::string_view word, const sense::SectionPlane& plane) {
  const std::string name = grammar::to_upper(word);
  if (name == "RHO" || name == "THETA") { // about z
    return plane.axis != 2 ? "" : !plane.round ? std::string(word) : name == "RHO" ? "x" : "0";
  }
  if (name != "X" && name != "Y" && name != "Z") {
    return std::string(word);
  }
  const int axis = name[0] - 'X';
  return axis == plane.space_direction_index(0)   ? "x"
         : axis == plane.space_direction_index(1) ? "y"
         : plane.round                            ? "0"
                                                  : fmt::format("({:.15g})", plane.first);
}

// Names of sets: all but values.
bool is_crack_face(const std::string& set) {
  const std::string name = grammar::to_upper(set);
  return name.ends_with(".LEFT") || name.ends_with(".RIGHT");
}

} // namespace

std::string describe_varying_load(const model::Model& model,
                                  const sense::PlaneSectionMesh& section) {
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (const std::string reason = against(load, section); !reason.empty()) {
        return fmt::format("load case {}: {}", load_case.name, reason);
      }
    }
  }
  return {};
}

void project_load_onto_section(DeckCard& card, const sense::SectionPlane& plane,
                               std::string& reason) {
  const std::string type = card.word_value("TYPE");
  const bool of_crack = type == "FACES" || type == "RESIDUAL";
  const bool directed = type != "PRESSURE" && type != "TEMPERATURE" && !of_crack;
  const bool whole_turn = plane.round && (type == "RESULTANT" || type == "BEARING");
  const auto refuse = [&](const char* why) {
    reason = reason.empty() ? fmt::format("load case {} {}", card.word_value("CASE"), why) : reason;
  };
  rewrite_data_lines(card, [&](const DataFields& fields, std::string& line) {
    const auto value = [&](std::size_t k) {
      return transform_names_in_text(
          k < fields.size() ? fields[k] : "0", [&](std::string_view word) {
            std::string name = name_in_section(word, plane);
            if (name.empty()) {
              refuse("depends on coordinates that the section does not have");
            }
            return name;
          });
    };
    if (!of_crack && is_crack_face(fields.front())) {
      refuse("acts on one face of a crack");
    }
    line = "  " + fields.front();
    if (!directed) {
      line += "  " + value(1) + "\n";
      return;
    }
    for (const int d : {0, 1}) {
      const std::string own = value(1 + static_cast<std::size_t>(plane.space_direction_index(d)));
      line += whole_turn
                  ? fmt::format("  ({:.15g}*{})", 2.0 * std::numbers::pi / plane.depth(), own)
                  : "  " + own;
    }
    line += "\n";
  });
}

bool support_holds_radius(const model::Model& model, const sense::PlaneSectionMesh& section,
                          const model::NodeSetFreedomRole& freedom) {
  const sense::SectionPlane& plane = section.plane;
  const auto one = static_cast<std::size_t>((plane.axis + 1) % 3);
  const auto other = static_cast<std::size_t>((plane.axis + 2) % 3);
  if (freedom.dof.at(one) && freedom.dof.at(other)) {
    return true;
  }
  if (!freedom.dof.at(one) && !freedom.dof.at(other)) {
    return false;
  }
  const auto held = static_cast<Eigen::Index>(freedom.dof.at(one) ? one : other);
  return std::ranges::any_of(model.mesh.set_with_id(freedom.nodes).nodes, [&](base::NodeId n) {
    const Vec3& x = model.mesh.x[n.index()];
    constexpr double across = 1e-6;
    const bool on_axis = plane.normal(x).squaredNorm() == 0.0;
    return !on_axis && std::abs(plane.normal(x)[held]) < 1.0 - across;
  });
}

bool ends_are_held(const model::Model& model, const sense::PlaneSectionMesh& section) {
  const sense::SectionPlane& plane = section.plane;
  std::vector<std::array<bool, 3>> held(model.mesh.node_count(), {false, false, false});
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
    for (const base::NodeId n : model.mesh.set_with_id(freedom.nodes).nodes) {
      for (std::size_t d = 0; d < 3; ++d) {
        held[n.index()].at(d) = held[n.index()].at(d) || freedom.dof.at(d);
      }
    }
  }
  const std::vector<bool> used = model::mark_nodes_in_use(model.mesh);
  for (std::size_t n = 0; n < model.mesh.node_count(); ++n) {
    const Vec3& x = model.mesh.x[n];
    const double along = plane.normal_coordinate(x);
    constexpr double reach = 1e-6; // of the thickness, or rad
    const auto lies_at = [&](double at) {
      return plane.round ? std::abs(std::remainder(along - at, 2.0 * std::numbers::pi)) <= reach
                         : std::abs(along - at) <= reach * plane.depth();
    };
    const Vec3 across = plane.normal(x);
    if (!used[n] || across.squaredNorm() == 0.0 ||
        (!lies_at(plane.first) && !lies_at(plane.last))) {
      continue;
    }
    for (Eigen::Index d = 0; d < 3; ++d) {
      if (std::abs(across[d]) > reach && !held[n].at(static_cast<std::size_t>(d))) {
        return false;
      }
    }
  }
  return true;
}

namespace {

/// Labels of nodes or elements as texts, by the net that has them, upper case.
using LabelsByNet = std::map<std::string, std::vector<std::string>>;

std::string local_name(const std::string& name) {
  const std::size_t point = name.find('.');
  return point == std::string::npos ? name : name.substr(point + 1);
}

// Ten items to a line.
DeckCard set_card(const char* kind, const std::string& name,
                  const std::vector<std::string>& items) {
  constexpr std::size_t wide = 10;
  std::string data;
  for (std::size_t i = 0; i < items.size(); ++i) {
    data += (i % wide == 0 ? "  " : " ") + items[i];
    data += i % wide == wide - 1 || i + 1 == items.size() ? "\n" : "";
  }
  return deck::make_card(kind, {{"NAME", name}}, data);
}

class MeshCards {
public:
  MeshCards(const model::Model& model, const model::Mesh& mesh) : model_(model), mesh_(mesh) {
    for (std::size_t n = 0; n < model.nets.size(); ++n) {
      add_mesh(base::NetId(n));
    }
    for (const model::NodeSet& set : mesh.node_sets) {
      add_set("NSET", set.name, node_labels(set.nodes));
    }
    for (const model::ElementSet& set : mesh.element_sets) {
      add_set("ESET", set.name, labels_of(set.elements, mesh.element_net, mesh.element_label));
    }
    for (const model::FaceSet& set : mesh.face_sets) {
      add_face_set(set);
    }
  }

  DeckCardList with(const DeckCardList& cards) && {
    for (const DeckCard& card : cards) {
      nets_[card.net].push_back(card);
    }
    DeckCardList all;
    for (const model::NetDefinition& net : model_.nets) {
      if (const std::string name = grammar::to_upper(net.name); !name.empty()) {
        all.push_back(deck::make_card("NET", {{"NAME", name}}));
        std::ranges::move(nets_[name], std::back_inserter(all));
        all.push_back(deck::make_card("ENDNET"));
      }
    }
    std::ranges::move(nets_[""], std::back_inserter(all));
    return all;
  }

private:
  [[nodiscard]] std::string net_name(base::NetId net) const {
    return grammar::to_upper(model_.nets[net.index()].name);
  }

  void add_mesh(base::NetId net) {
    DeckCard nodes = deck::make_card("COOR", {{"DIM", "2"}});
    for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
      if (mesh_.node_net[n] == net) {
        nodes.data +=
            fmt::format("  {}  {}  {}\n", mesh_.node_label[n], mesh_.x[n].x(), mesh_.x[n].y());
      }
    }
    if (nodes.data.empty()) {
      return;
    }
    std::map<base::ElementType, std::string> elements;
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      if (mesh_.element_net[e] == net) {
        std::vector<base::Label> labels;
        for (const base::NodeId n : mesh_.element_nodes(base::ElementId(e))) {
          labels.push_back(mesh_.node_label[n.index()]);
        }
        elements[mesh_.type[e]] +=
            fmt::format("  {}  {}\n", mesh_.element_label[e], fmt::join(labels, " "));
      }
    }
    DeckCardList& cards = nets_[net_name(net)];
    cards.push_back(std::move(nodes));
    for (auto& [type, lines] : elements) {
      cards.push_back(deck::make_card(
          "ELEMENT", {{"TYPE", std::string(base::element_info(type).name)}}, std::move(lines)));
    }
  }

  template <class Ids>
  [[nodiscard]] LabelsByNet labels_of(const Ids& ids, const std::vector<base::NetId>& nets,
                                      const std::vector<base::Label>& labels) const {
    LabelsByNet found;
    for (const auto id : ids) {
      found[net_name(nets[id.index()])].push_back(fmt::format("{}", labels[id.index()]));
    }
    return found;
  }
  [[nodiscard]] LabelsByNet node_labels(const std::vector<base::NodeId>& nodes) const {
    return labels_of(nodes, mesh_.node_net, mesh_.node_label);
  }

  void add_set(const char* kind, const std::string& name, const LabelsByNet& labels) {
    if (name.empty() || labels.empty()) {
      return;
    }
    const std::string local = local_name(name);
    const bool own = labels.size() == 1 && labels.begin()->first == net_prefix(name);
    const DeckCard set = set_card(
        kind, local, own ? labels.begin()->second : add_parts(kind, local + "_PART", labels));
    nets_[net_prefix(name)].push_back(set);
  }

  // Names of sets in each of the nets.
  std::vector<std::string> add_parts(const char* kind, const std::string& wanted,
                                     const LabelsByNet& labels) {
    const std::string name = unused_set_name(mesh_, wanted);
    std::vector<std::string> names;
    for (const auto& [net, numbers] : labels) {
      names.push_back(net.empty() ? name : fmt::format("{}.{}", net, name));
      nets_[net].push_back(set_card(kind, name, numbers));
    }
    return names;
  }

  // By their nodes.
  void add_face_set(const model::FaceSet& set) {
    if (set.name.empty() || set.faces.empty()) {
      return;
    }
    const std::string local = local_name(set.name);
    const std::string net = net_prefix(set.name);
    std::vector<std::string> items =
        add_parts("NSET", local + "_NODES", node_labels(mesh::nodes_of_faces(mesh_, set.faces)));
    if (!net.empty()) {
      std::ranges::transform(items, items.begin(), local_name);
    }
    nets_[net].push_back(set_card("FSET", local, items));
  }

  const model::Model& model_;
  const model::Mesh& mesh_;
  std::map<std::string, DeckCardList> nets_; ///< by name, upper case; what stands in none by ""
};

} // namespace

std::string unused_set_name(const model::Mesh& mesh, std::string wanted) {
  const auto taken = [&](const auto& sets) {
    return std::ranges::any_of(sets,
                               [&](const auto& set) { return local_name(set.name) == wanted; });
  };
  while (taken(mesh.node_sets) || taken(mesh.element_sets) || taken(mesh.face_sets)) {
    wanted += "_";
  }
  return wanted;
}

DeckCardList write_mesh_cards(const model::Model& model, const model::Mesh& mesh,
                              const DeckCardList& cards) {
  return MeshCards(model, mesh).with(cards);
}

} // namespace spricka::program
