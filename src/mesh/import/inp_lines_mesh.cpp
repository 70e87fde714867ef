// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_lines.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

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

class NodeLines : public InpKeywordReader {
public:
  NodeLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    sound_ = only({"NSET"}) && in_part(shared, key);
    set_ = sound_ ? set_named_by("NSET", data_.node_sets, shared.node_sets) : nullptr;
  }
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    const auto label = fields.next_integer();
    const auto x = fields.next_real();
    const auto y = fields.next_real();
    const auto z = fields.next_real();
    if (!label || *label <= 0 || !x || !y || !z || fields.has_more()) {
      complain_here("a line of *NODE is number, x, y, z");
      return;
    }
    if (sound_) {
      data_.node.push_back(*label);
      data_.x.emplace_back(*x, *y, *z);
      if (set_ != nullptr) {
        set_->members.push_back(*label);
      }
    }
  }

private:
  bool sound_ = false;
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
    if (is_bar(name_)) {
      start_bars();
      return;
    }
    const auto known = find_inp_element_type(name_);
    if (!known) {
      complain(key_.place, fmt::format("elements of type {} are not known", name_),
               "known: CPS, CPE and CAX with 3, 4, 6, 8 nodes; C3D with 4, 6, 8, 10, 15, 20");
      return;
    }
    sound_ = true;
    type_ = *known;
    count_ = static_cast<std::size_t>(base::element_info(type_.type).nodes);
    if (type_.special) {
      data_.special.try_emplace(name_, key_.place);
    }
    set_ = set_named_by("ELSET", data_.element_sets, shared.element_sets);
  }
  /// One line of an element; those with many nodes go on over several.
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    if (bars_ != nullptr) {
      const auto label = fields.next_integer();
      bars_->count += label ? 1 : 0;
      data_.bar.insert(label.value_or(0));
      if (set_ != nullptr && label) {
        set_->members.push_back(*label);
      }
    }
    if (!sound_) {
      return;
    }
    if (wanted_ == 0 && !start(fields)) {
      complain_here("a line of *ELEMENT is number, nodes");
      return;
    }
    while (fields.has_more()) {
      const auto node = fields.next_integer();
      if (!node || wanted_ == 0) {
        complain_here(fmt::format("{} takes {} nodes", name_, count_));
        drop();
        return;
      }
      data_.connectivity.push_back(*node);
      if (--wanted_ == 0) {
        close();
      }
    }
  }
  void finish_keyword() override {
    if (wanted_ > 0) {
      complain(start_, fmt::format("{} takes {} nodes; the element ends early", name_, count_));
      drop();
    }
  }

private:
  // gmsh writes the curves of a mesh so. Whether they are meant to carry load says their section.
  static bool is_bar(std::string_view name) {
    return name == "T2D2" || name == "T2D3" || name == "T3D2" || name == "T3D3";
  }
  void start_bars() {
    InpData::InpSkippedItems& left = data_.bars[name_];
    left.first = left.count == 0 ? key_.place : left.first;
    bars_ = &left;
    set_ = set_named_by("ELSET", data_.element_sets, shared_.element_sets);
  }
  bool start(InpFieldReader& fields) {
    const auto label = fields.next_integer();
    start_ = text_.location();
    label_ = label.value_or(0);
    wanted_ = label_ > 0 ? count_ : 0;
    return label_ > 0;
  }
  void close() {
    data_.element.push_back(label_);
    data_.type.push_back(type_);
    data_.element_place.push_back(start_);
    data_.first.push_back(data_.connectivity.size());
    if (set_ != nullptr) {
      set_->members.push_back(label_);
    }
  }
  void drop() {
    data_.connectivity.resize(data_.first.back());
    wanted_ = 0;
  }

  bool sound_ = false;
  InpData::InpSkippedItems* bars_ = nullptr; ///< these lines are bars
  std::string name_;
  InpElementType type_;
  std::size_t count_ = 0;
  InpLabelSet* set_ = nullptr;
  InpLocation start_;
  Label label_ = 0;
  std::size_t wanted_ = 0; ///< nodes of the element that are still to come
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
