// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_lines.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

namespace spricka::mesh {
namespace {

using base::Label;

/// Lines that fill a set of nodes or elements.
class SetLines : public InpKeywordReader {
public:
  SetLines(InpReaderContext& shared, const InpKeyword& key, bool nodes, std::string_view name_key)
      : InpKeywordReader(shared, key), sets_(nodes ? data_.node_sets : data_.element_sets),
        index_(nodes ? shared.node_sets : shared.element_sets),
        generate_(key_.find("GENERATE") != nullptr) {
    std::string name;
    sound_ = only({name_key, "GENERATE", "UNSORTED", "INSTANCE", "INTERNAL", "TYPE"}) &&
             needs(name_key, name);
    set_ = sound_ ? set_of(sets_, index_, name) : 0;
  }
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    if (!sound_) {
      return;
    }
    if (generate_) {
      generate(fields);
      return;
    }
    while (fields.has_more()) {
      member(fields.next_text());
    }
  }

protected:
  [[nodiscard]] bool sound() const { return sound_; }
  void member(std::string_view field) {
    auto& into = sets_[set_].members;
    if (const auto label = parse_inp_integer(field)) {
      into.push_back(*label);
      return;
    }
    const auto other = index_.find(upper_case(plain(field)));
    if (other == index_.end()) {
      complain_here(fmt::format("there is no set '{}' up to here", field));
      return;
    }
    const std::vector<Label> members = sets_[other->second].members; // may be the set itself
    into.insert(into.end(), members.begin(), members.end());
  }

private:
  void generate(InpFieldReader& fields) {
    const auto first = fields.next_integer();
    const auto last = fields.next_integer();
    const auto step = fields.has_more() ? fields.next_integer() : std::optional<Label>(1);
    const bool ok = first && last && step && *first > 0 && *step > 0 && *last >= *first;
    if (!ok || *last - *first > most || fields.has_more()) {
      complain_here("with GENERATE a line is first, last, step");
      return;
    }
    for (Label label = *first; label <= *last; label += *step) {
      sets_[set_].members.push_back(label);
    }
  }

  static constexpr Label most = 1'000'000'000;
  std::vector<InpLabelSet>& sets_;
  std::map<std::string, std::size_t>& index_;
  std::size_t set_ = 0;
  bool sound_ = false;
  bool generate_;
};

/// *SURFACE, TYPE=NODE: nodes or sets, each with an area that says nothing about the mesh.
class NodeSurfaceLines : public SetLines {
public:
  NodeSurfaceLines(InpReaderContext& shared, const InpKeyword& key)
      : SetLines(shared, key, true, "NAME") {}
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    const std::string_view what = fields.next_text();
    if ((fields.has_more() && !fields.next_real()) || fields.has_more()) {
      complain_here("a line of *SURFACE, TYPE=NODE is a node or node set");
    } else if (sound()) {
      member(what);
    }
  }
};

class SurfaceLines : public InpKeywordReader {
public:
  SurfaceLines(InpReaderContext& shared, const InpKeyword& key) : InpKeywordReader(shared, key) {
    std::string name;
    const bool sound = only({"NAME", "TYPE", "INTERNAL"}) && needs("NAME", name);
    if (const std::string* type = key_.find("TYPE"); type && upper_case(*type) != "ELEMENT") {
      complain(key_.place, fmt::format("*SURFACE: TYPE={} is not understood", *type));
    } else if (sound) {
      set_ = data_.surfaces.size();
      data_.surfaces.push_back({name, {}, key_.place});
    }
  }
  void read_line() override {
    InpFieldReader fields(text_.data_line());
    const std::string_view what = fields.next_text();
    const std::string side = upper_case(fields.next_text());
    InpData::InpSurfaceSide entry;
    entry.place = text_.location();
    if (side.size() != 2 || side[0] != 'S' || side[1] < '1' || side[1] > '6' || fields.has_more()) {
      complain_here("a line of *SURFACE is element or set, side S1 to S6");
      return;
    }
    entry.side = side[1] - '1';
    if (const auto label = parse_inp_integer(what)) {
      entry.element = *label;
    } else {
      entry.elements = plain(what);
    }
    if (set_) {
      data_.surfaces[*set_].members.push_back(std::move(entry));
    }
  }

private:
  std::optional<std::size_t> set_;
};

} // namespace

std::unique_ptr<InpKeywordReader> make_inp_set_reader(InpReaderContext& shared,
                                                      const InpKeyword& key) {
  if (key.name == "NSET" || key.name == "ELSET") {
    return std::make_unique<SetLines>(shared, key, key.name == "NSET", key.name);
  }
  if (key.name != "SURFACE") {
    return nullptr;
  }
  const std::string* type = key.find("TYPE");
  if (type != nullptr && upper_case(*type) == "NODE") {
    return std::make_unique<NodeSurfaceLines>(shared, key);
  }
  return std::make_unique<SurfaceLines>(shared, key);
}

} // namespace spricka::mesh
