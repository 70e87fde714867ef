// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/model.hpp"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace spricka::program {

/// The nets of a deck that the bodies of an imported file stand in: one for each element set that
/// holds whole bodies, if such sets divide all elements, else one for the file.
class InpNets {
public:
  struct InpNet {
    std::string name;
    std::string element_set; ///< of the file; empty: all elements
  };

  /// `name` is that of the one net.
  InpNets(const model::Model& model, std::string name);

  [[nodiscard]] const std::vector<InpNet>& nets() const { return nets_; }
  /// Bodies, parts of the mesh that share no node.
  [[nodiscard]] std::size_t body_count() const { return bodies_; }
  /// The net of an element, into nets().
  [[nodiscard]] std::size_t net_of(base::ElementId e) const { return net_[body_[e.index()]]; }

  // Names as the deck writes them outside of nets, NET.SET for each net that has members; empty
  // where the file has no such set or nothing of it is taken.
  [[nodiscard]] std::vector<std::string> node_set(const std::string& written) const;
  [[nodiscard]] std::vector<std::string> face_set(const std::string& written) const;
  [[nodiscard]] std::vector<std::string> element_set(const std::string& written) const;
  /// The net that has a node, into nets(); empty where no element has it.
  [[nodiscard]] std::optional<std::size_t> net_of_node(base::Label label) const;

private:
  void find_bodies();
  /// The smallest set of whole bodies that holds each body; false where one has none.
  bool choose_sets();
  [[nodiscard]] std::vector<std::string> in_nets(const std::string& set,
                                                 const std::vector<bool>& member) const;

  const model::Model& model_;
  std::vector<InpNet> nets_;
  std::vector<std::size_t> body_; ///< [element]
  std::size_t bodies_ = 0;
  std::vector<std::size_t> net_;                ///< [body]
  std::vector<std::vector<bool>> net_has_node_; ///< [net][node]
  std::unordered_map<base::Label, base::NodeId> node_of_label_;
};

} // namespace spricka::program
