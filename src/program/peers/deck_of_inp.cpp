// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/peers/deck_of_inp.hpp"

#include "mesh/boundary.hpp"
#include "mesh/set_name.hpp"
#include "mesh/surface/surface_geometry.hpp"
#include "model/model.hpp"
#include "program/peers/inp_nets.hpp"
#include "program/peers/inp_step_cards.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {
namespace {

using mesh::InpJointCards;

struct GuessedUnits {
  std::string length, force, remark;
};

/// Young's modulus tells in which units a file is written: steel has 2.1e5 MPa, 2.1e11 Pa, 3e7 psi.
GuessedUnits guess_units(const std::vector<model::ElasticMaterial>& materials) {
  double E = 0.0;
  for (const model::ElasticMaterial& material : materials) {
    E = std::max(E, material.E);
  }
  if (E == 0.0) {
    return {"mm", "N",
            "units are taken as mm and N: change LENGTH and FORCE of $DECK if they are "
            "others"};
  }
  const bool metres = E >= 1e9;
  const bool inches = !metres && E >= 2e6;
  GuessedUnits units{metres ? "m" : inches ? "in" : "mm", inches ? "lbf" : "N", ""};
  units.remark = fmt::format("units are guessed as {} and {}, as E = {:g}: change LENGTH and FORCE "
                             "of $DECK if they are others",
                             units.length, units.force, E);
  return units;
}

/// A text that may stand between quotes.
std::string plain_title(const std::string& title, const std::string& file) {
  std::string text;
  for (const char c : title.empty() ? "from " + file : title) {
    text += c < ' ' || c > '~' || c == '\'' ? ' ' : c;
  }
  constexpr std::size_t most = 70;
  return text.substr(0, most);
}

class DeckWriter {
public:
  DeckWriter(const model::Model& model, const InpJointCards& joint, std::string file,
             const std::string& name)
      : model_(model), joint_(joint), file_(std::move(file)), nets_(model, name) {}

  DeckOfInp run() {
    const GuessedUnits units = guess_units(model_.materials);
    remark(units.remark);
    text_ = fmt::format("$DECK VERSION=1 LENGTH={} FORCE={} TITLE='{}'\n", units.length,
                        units.force, plain_title(joint_.title, file_));
    InpStepCards steps = write_inp_step_cards(model_, joint_, nets_);
    write_nets(steps.node_sets);
    write_missing_properties();
    text_ += steps.supports;
    for (std::size_t i = 0; i < joint_.pairs.size(); ++i) {
      write_contact(joint_.pairs[i], i);
    }
    say_when_ties_come();
    text_ += steps.loads_and_steps + "$END\n";
    for (std::string& words : steps.remarks) {
      remark(std::move(words));
    }
    say_what_nothing_holds(steps.held_nets);
    return {std::move(text_), std::move(remarks_)};
  }

private:
  void remark(std::string words) {
    if (std::ranges::find(remarks_, words) == remarks_.end()) {
      remarks_.push_back(std::move(words));
    }
  }

  void write_nets(const std::vector<std::string>& node_sets) {
    for (std::size_t n = 0; n < nets_.nets().size(); ++n) {
      const InpNets::InpNet& net = nets_.nets()[n];
      const std::string own =
          net.element_set.empty() ? "" : fmt::format(" ESET='{}'", net.element_set);
      text_ += fmt::format("$NET NAME={}\n  $IMPORT FILE='{}' FORMAT=INP SKIP=ALL{}\n{}$ENDNET\n",
                           net.name, file_, own, node_sets[n]);
    }
    if (nets_.nets().size() == 1 && nets_.body_count() > 1) {
      remark(fmt::format("the {} bodies stand in one net, as no element sets tell them apart: for "
                         "a crack in space give each body a set of its own",
                         nets_.body_count()));
    }
  }

  void write_missing_properties() {
    const auto open = [&](std::size_t e) { return !model_.mesh.property[e].valid(); };
    std::size_t count = 0;
    for (std::size_t e = 0; e < model_.mesh.element_count(); ++e) {
      count += open(e) ? 1 : 0;
    }
    if (count == 0) {
      return;
    }
    remark(fmt::format("{} elements have no elastic material in the file: give $MATERIAL and "
                       "$PROPERTY",
                       count));
    text_ += "! $MATERIAL NAME=.. E=.. NU=..\n! $PROPERTY ESET=.. MATERIAL=.. STATE=..\n";
  }

  /// The name of a surface as a card wants it; of one in several nets a set is made of its parts.
  std::optional<std::string> surface(const std::string& written) {
    const std::vector<std::string> faces = nets_.face_set(written);
    const std::vector<std::string> parts = faces.empty() ? nets_.node_set(written) : faces;
    if (parts.size() < 2) {
      return parts.empty() ? std::nullopt : std::optional(parts.front());
    }
    const std::string name = mesh::make_valid_set_name(written);
    if (made_.insert(name).second) {
      text_ += fmt::format("${} NAME={}\n  {}\n", faces.empty() ? "NSET" : "FSET", name,
                           fmt::join(parts, "  "));
    }
    return name;
  }

  [[nodiscard]] const InpJointCards::InpSurfaceInteraction*
  interaction_of(const InpJointCards::InpContactPair& pair) const {
    const auto at = std::ranges::find_if(joint_.interactions, [&](const auto& interaction) {
      return mesh::upper_case(interaction.name) == mesh::upper_case(pair.interaction);
    });
    return pair.tie || at == joint_.interactions.end() ? nullptr : &*at;
  }

  std::string contact_name(const InpJointCards::InpContactPair& pair, std::size_t number) {
    std::string name = pair.tie && !pair.name.empty()
                           ? mesh::make_valid_set_name(pair.name)
                           : fmt::format("{}_{}", pair.tie ? "TIE" : "CONTACT", number + 1);
    while (!contacts_.insert(name).second) {
      name += "_2";
    }
    return name;
  }

  void write_contact(const InpJointCards::InpContactPair& pair, std::size_t number) {
    const auto slave = surface(pair.slave);
    const auto master = surface(pair.master);
    if (!slave || !master) {
      remark(fmt::format("line {}: {} of {} and {} is left out, as there is no surface {}",
                         pair.place.line, pair.tie ? "the tie" : "contact", pair.slave, pair.master,
                         slave ? pair.master : pair.slave));
      return;
    }
    const InpJointCards::InpSurfaceInteraction* law = interaction_of(pair);
    const bool bonded = pair.tie || (law != nullptr && law->tied);
    text_ += fmt::format("$CONTACT NAME={} SLAVE={} MASTER={}{}{}{}\n", contact_name(pair, number),
                         *slave, *master, bonded ? " TYPE=BONDED" : "", gap_of(pair, bonded),
                         !bonded && law != nullptr && law->friction > 0.0
                             ? fmt::format(" MU={:g}", law->friction)
                             : "");
    for (const auto* parts : {&pair.slave, &pair.master}) {
      for (const std::string& part : parts_of(*parts)) {
        joined_.insert(part.substr(0, part.find('.')));
      }
    }
    if (law != nullptr && !bonded) {
      say_how_contact_differs(*law);
    }
  }
  [[nodiscard]] std::vector<std::string> parts_of(const std::string& written) const {
    const std::vector<std::string> faces = nets_.face_set(written);
    return faces.empty() ? nets_.node_set(written) : faces;
  }

  void say_how_contact_differs(const InpJointCards::InpSurfaceInteraction& law) {
    if (law.soft) {
      remark(fmt::format("interaction {} has a contact stiffness: here surfaces do not overlap, "
                         "and no stiffness is needed",
                         law.name));
    }
    if (law.without_slip) {
      remark(fmt::format("interaction {} is ROUGH: here the contact has no friction; give a MU",
                         law.name));
    }
  }

  /// A tie is made without force; ADJUST moves what lies near onto the master.
  std::string gap_of(const InpJointCards::InpContactPair& pair, bool bonded) {
    if (bonded) {
      return " GAP=0";
    }
    if (pair.clearance) {
      return fmt::format(" GAP={:g}", *pair.clearance);
    }
    if (!pair.adjust) {
      return "";
    }
    const std::optional<double> apart = largest_distance(pair);
    if (apart && *apart <= std::max(*pair.adjust, 0.0)) {
      return " GAP=0";
    }
    remark(fmt::format("line {}: ADJUST={:g} of {} and {} is left out, as {}: the gap is that of "
                       "the geometry",
                       pair.place.line, *pair.adjust, pair.slave, pair.master,
                       apart ? fmt::format("they are up to {:.3g} apart", *apart)
                             : std::string("it is looked at between faces of solids only")));
    return "";
  }

  [[nodiscard]] bool are_edges(const model::FaceSet& set) const {
    return std::ranges::all_of(set.faces, [&](const model::Face& face) {
      return shape::is_plane_element_side(model_.mesh.type[face.element.index()], face.side);
    });
  }

  /// Between nodes of the slave and the master, along its normal; empty where there are no faces.
  std::optional<double> largest_distance(const InpJointCards::InpContactPair& pair) {
    const auto find = [&](const std::string& written) {
      return std::ranges::find_if(model_.mesh.face_sets, [&](const model::FaceSet& set) {
        return set.name == mesh::make_valid_set_name(written);
      });
    };
    const auto slave = find(pair.slave);
    const auto master = find(pair.master);
    const auto none = model_.mesh.face_sets.end();
    if (slave == none || master == none || are_edges(*slave) || are_edges(*master)) {
      return std::nullopt;
    }
    if (!geometry_) {
      geometry_.emplace(model_.mesh);
    }
    std::vector<std::size_t> faces;
    for (const model::Face& face : master->faces) {
      if (const std::size_t f = geometry_->face_index(face); f != mesh::nowhere) {
        faces.push_back(f);
      }
    }
    if (faces.empty()) {
      return std::nullopt;
    }
    constexpr std::size_t most_looked_at = 200;
    const std::vector<base::NodeId> nodes = mesh::nodes_of_faces(model_.mesh, slave->faces);
    double largest = 0.0;
    for (std::size_t i = 0; i < nodes.size(); i += 1 + nodes.size() / most_looked_at) {
      const base::Vec3& x = model_.mesh.x[nodes[i].index()];
      const mesh::SurfacePlace place = geometry_->nearest_place(x, faces);
      largest = std::max(largest, std::abs((x - place.x).dot(place.normal)));
    }
    return largest;
  }

  void say_when_ties_come() {
    const auto tie = [](const InpJointCards::InpContactPair& pair) { return pair.tie; };
    if (std::ranges::any_of(joint_.pairs, tie) && !std::ranges::all_of(joint_.pairs, tie)) {
      remark("ties hold from the first step on: one that begins where you let a fit be pressed in "
             "has to come after it, by MOUNT in a $STEP");
    }
  }

  void say_what_nothing_holds(const std::set<std::string>& held) {
    for (const InpNets::InpNet& net : nets_.nets()) {
      if (!held.contains(net.name) && !joined_.contains(net.name)) {
        remark(fmt::format("nothing holds {}: the file has no support, contact or tie of it",
                           net.name));
      }
    }
  }

  const model::Model& model_;
  const InpJointCards& joint_;
  std::string file_;
  InpNets nets_;
  std::string text_;
  std::vector<std::string> remarks_;
  std::set<std::string> made_, contacts_, joined_; ///< sets, names, nets in a contact
  std::optional<mesh::SurfaceGeometry> geometry_;
};

} // namespace

DeckOfInp deck_of_inp(const model::Model& model, const mesh::InpJointCards& joint,
                      const std::string& file, const std::string& name) {
  return DeckWriter(model, joint, file, name).run();
}

} // namespace spricka::program
