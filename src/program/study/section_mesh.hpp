// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "deck/deck_text.hpp"
#include "model/forward.hpp"
#include "model/mesh.hpp"

#include <map>
#include <string>
#include <vector>

/// A plane mesh as cards.
namespace spricka::program {

/// Writes a mesh out: nets with nodes and elements, and all sets that have members.
class MeshCards {
public:
  /// `mesh` are the model's nets, flat; both must outlive this.
  MeshCards(const model::Model& model, const model::Mesh& mesh);

  /// A card that stands in a net.
  void add_card(const deck::DeckCard& card);

  /// A node set of these nodes, by nets; the names that it has outside. `name`: new in every net.
  std::vector<std::string> add_node_set(const std::string& name,
                                        const std::vector<base::NodeId>& nodes);

  /// Nets first, then what stands outside.
  [[nodiscard]] deck::DeckText text() const;

private:
  using LabelsByNet = std::map<std::string, std::vector<std::string>>;

  void add_mesh(base::NetId net);
  void add_sets();
  void add_face_set(const model::FaceSet& set);
  /// A set of `kind`, NSET or ESET, in its net; of several nets by parts in each. Nothing without a
  /// name or members.
  void named_set(const char* kind, const std::string& name, const LabelsByNet& labels);
  std::vector<std::string> parts(const char* kind, const std::string& name,
                                 const LabelsByNet& labels);
  [[nodiscard]] LabelsByNet labels_of(const std::vector<base::NodeId>& nodes) const;
  [[nodiscard]] std::string net_name(base::NetId net) const;
  /// A name that no set has in any net.
  std::string new_name(const std::string& request);
  /// A card into the net of this name, upper case; empty: outside.
  void put(const std::string& net, deck::DeckCard card);

  const model::Model& model_;
  const model::Mesh& mesh_;
  std::vector<deck::DeckText> nets_; ///< [net] without $NET and $ENDNET
};

} // namespace spricka::program
