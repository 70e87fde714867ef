// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_lines.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace spricka::mesh {
namespace {

using base::Label;

// Nodes and elements that stand in the assembly belong to no part.
bool in_part(const InpReaderContext& shared, const InpKeyword& key) {
  if (shared.in_assembly) {
    shared.complain(key.place, fmt::format("*{} in an *ASSEMBLY is not imported", key.shown), "");
  }
  return !shared.in_assembly;
}

/// Number, x, y, z, and perhaps the normal of a shell.
class NodeLines : public InpKeywordReader {
public:
  NodeLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    sound_ = only({"NSET"}) && in_part(shared, key);
    set_ = sound_ ? set_named_by("NSET", data_.node_sets, shared.node_sets) : nullptr;
  }
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    const auto label = fields.next_integer();
    const auto x = coordinates(fields, label.value_or(0));
    if (!label || *label <= 0 || !x) {
      complain_here("a line of *NODE is number, x, y, z");
      return;
    }
    if (sound_) {
      data_.node.push_back(*label);
      data_.x.push_back(*x);
      if (set_ != nullptr) {
        set_->members.append(*label);
      }
    }
  }

private:
  std::optional<base::Vec3> coordinates(InpFieldReader& fields, Label label) {
    std::vector<double> values;
    std::vector<double> written; // without those of empty fields
    while (fields.has_more()) {
      const std::string_view text = fields.next_text();
      const auto value = InpFieldReader(text).next_real();
      if (!value) {
        return std::nullopt;
      }
      values.push_back(*value);
      if (!text.empty()) {
        written.push_back(*value);
      }
    }
    if (values.size() == 4 && written.size() == 3) {
      say_once(label, written);
      values = written;
    }
    constexpr std::size_t with_normal = 6;
    if (values.size() > 3 && values.size() != with_normal) {
      return std::nullopt;
    }
    values.resize(3, 0.0);
    return base::Vec3(values[0], values[1], values[2]);
  }
  void say_once(Label label, const std::vector<double>& x) {
    if (!said_) {
      data_.remarks.push_back({text_.location(),
                               fmt::format("a double comma in a line of *NODE counts as one: node "
                                           "{} lies at ({:g}, {:g}, {:g})",
                                           label, x[0], x[1], x[2]),
                               {}});
    }
    said_ = true;
  }

  bool sound_ = false;
  bool said_ = false;
  InpLabelSet* set_ = nullptr; ///< no set is made while the lines are read
};

class ElementLines : public InpKeywordReader {
public:
  ElementLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    std::string type;
    if (!only({"TYPE", "ELSET"}) || !needs("TYPE", type) || !in_part(shared, key)) {
      return;
    }
    name_ = upper_case(type);
    const auto body = find_inp_element_type(name_);
    const auto side = find_inp_surface_element_type(name_);
    if (body) {
      type_ = *body;
      count_ = static_cast<std::size_t>(base::element_info(type_.type).nodes);
      if (type_.special) {
        data_.special.try_emplace(name_, key_.place);
      }
    } else if (side) {
      surface_type_ = kind_of(data_.surface_types);
      corners_ = side->corners;
      count_ = side->nodes;
    } else if (is_inp_connector(name_) && shared.lenient) {
      connector_ = kind_of(data_.connectors);
    } else {
      unknown_ = kind_of(data_.unknown);
    }
    set_ = set_named_by("ELSET", data_.element_sets, shared.element_sets);
  }
  /// One line of an element; those with many nodes go on over several.
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    if (unknown_) {
      ++data_.unknown[*unknown_].count;
    } else if (connector_) {
      read_connector(fields);
    } else if (count_ > 0) {
      read_nodes(fields);
    }
  }
  void finish_keyword() override {
    if (wanted_ > 0) {
      complain(start_, fmt::format("{} takes {} nodes; the element ends early", name_, count_));
      wanted_ = 0;
    }
  }

private:
  std::size_t kind_of(std::vector<InpData::InpElementKind>& kinds) {
    const auto at = std::find_if(kinds.begin(), kinds.end(),
                                 [&](const auto& kind) { return kind.name == name_; });
    const auto place = static_cast<std::size_t>(at - kinds.begin());
    if (at == kinds.end()) {
      kinds.push_back({name_, key_.place, 0});
    }
    return place;
  }
  void read_connector(InpFieldReader& fields) {
    if (const auto label = fields.next_integer()) {
      ++data_.connectors[*connector_].count;
      data_.connector.append(*label);
      if (set_ != nullptr) {
        set_->members.append(*label);
      }
    }
  }
  void read_nodes(InpFieldReader& fields) {
    if (wanted_ == 0 && !start(fields)) {
      complain_here("a line of *ELEMENT is number, nodes");
      return;
    }
    while (fields.has_more()) {
      const std::string_view text = fields.next_text();
      if (text.empty()) {
        continue; // a comma too many
      }
      const auto node = parse_inp_integer(text);
      if (!node || wanted_ == 0) {
        complain_here(fmt::format("{} takes {} nodes", name_, count_));
        wanted_ = 0;
        return;
      }
      nodes_.push_back(*node);
      --wanted_;
    }
    if (wanted_ == 0) {
      close();
    }
  }
  bool start(InpFieldReader& fields) {
    const auto label = fields.next_integer();
    start_ = text_.location();
    label_ = label.value_or(0);
    wanted_ = label_ > 0 ? count_ : 0;
    nodes_.clear();
    return label_ > 0;
  }
  void close() {
    if (surface_type_) {
      InpData::InpSurfaceElement side;
      side.label = label_;
      side.corners = corners_;
      side.type = *surface_type_;
      std::copy_n(nodes_.begin(), std::min(nodes_.size(), side.corner.size()), side.corner.begin());
      data_.surface_elements.push_back(side);
      ++data_.surface_types[*surface_type_].count;
    } else {
      data_.element.push_back(label_);
      data_.type.push_back(type_);
      data_.element_place.push_back(start_);
      data_.connectivity.insert(data_.connectivity.end(), nodes_.begin(), nodes_.end());
      data_.first.push_back(data_.connectivity.size());
    }
    if (set_ != nullptr) {
      set_->members.append(label_);
    }
  }

  std::string name_;
  InpElementType type_;
  std::optional<std::size_t> surface_type_, connector_, unknown_; ///< places of their kind
  std::size_t corners_ = 0;
  std::size_t count_ = 0; ///< nodes of an element
  InpLabelSet* set_ = nullptr;
  InpLocation start_;
  Label label_ = 0;
  std::size_t wanted_ = 0; ///< nodes of the element that are still to come
  std::vector<Label> nodes_;
};

} // namespace

std::unique_ptr<InpKeywordReader> make_inp_mesh_reader(InpReaderContext& shared,
                                                       const InpKeyword& key) {
  if (key.name == "NODE") {
    return std::make_unique<NodeLines>(shared, key);
  }
  if (key.name == "ELEMENT") {
    return std::make_unique<ElementLines>(shared, key);
  }
  return nullptr;
}

} // namespace spricka::mesh
