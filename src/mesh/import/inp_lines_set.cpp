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
    sound_ =
        (nodes ? only({name_key, "GENERATE", "UNSORTED", "INSTANCE", "INTERNAL", "TYPE", "ELSET"})
               : only({name_key, "GENERATE", "UNSORTED", "INSTANCE", "INTERNAL", "TYPE"})) &&
        needs(name_key, name);
    set_ = sound_ ? set_of(sets_, index_, name) : 0;
    const std::string* of = nodes ? key_.find("ELSET") : nullptr;
    if (sound_ && of != nullptr) {
      sets_[set_].element_sets.push_back(plain(*of));
    }
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
      if (const std::string_view text = fields.next_text(); !text.empty()) {
        member(text);
      }
    }
  }

protected:
  [[nodiscard]] bool sound() const { return sound_; }
  void member(std::string_view field) {
    InpLabelList& into = sets_[set_].members;
    if (const auto label = parse_inp_integer(field)) {
      into.append(*label);
      return;
    }
    const auto other = index_.find(upper_case(plain(field)));
    if (other == index_.end()) {
      complain_here(fmt::format("there is no set '{}' up to here", field));
      return;
    }
    const InpLabelList& members = sets_[other->second].members; // may be those of the set itself
    const std::vector<std::string> more = sets_[other->second].element_sets;
    shared_.included += members.ranges().size() + more.size();
    if (shared_.included > most_included) {
      complain_here("sets name each other over and over");
      return;
    }
    into.append(members);
    std::vector<std::string>& of = sets_[set_].element_sets;
    of.insert(of.end(), more.begin(), more.end());
  }

private:
  void generate(InpFieldReader& fields) {
    const auto first = fields.next_integer();
    const auto last = fields.next_integer();
    const std::string_view third = fields.next_text();
    const auto step = third.empty() && first && last
                          ? std::optional<Label>(*last < *first ? -1 : 1) // downwards, too
                          : parse_inp_integer(third);
    if (!first || !last || !step || *first <= 0 || *last <= 0 || *step == 0 || fields.has_more() ||
        (*first != *last && (*last > *first) != (*step > 0))) {
      complain_here("with GENERATE a line is first, last, step");
      return;
    }
    sets_[set_].members.append_range(*first, *last, *step);
  }

  static constexpr std::size_t most_included = 8'000'000;
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
      complain_or_leave_out(fmt::format("TYPE={}", *type),
                            fmt::format("*SURFACE: TYPE={} is not understood", *type));
      return;
    }
    sound_ = sound;
    if (sound) {
      set_ = data_.surfaces.size();
      data_.surfaces.push_back({plain(name), {}, key_.place});
    }
  }
  void read_line() override {
    if (!sound_) {
      return;
    }
    InpFieldReader fields(text_.data_line());
    const std::string_view what = fields.next_text();
    const std::string side = upper_case(fields.next_text());
    InpData::InpSurfaceSide entry;
    entry.place = text_.location();
    const bool numbered = side.size() == 2 && side[0] == 'S' && side[1] >= '1' && side[1] <= '6';
    const bool whole = side.empty() || side == "SPOS" || side == "SNEG";
    if ((!numbered && !whole) || fields.has_more()) {
      complain_here("a line of *SURFACE is element or set, side S1 to S6");
      return;
    }
    if (numbered) {
      entry.side = side[1] - '1';
    }
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
  bool sound_ = false;
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
