// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/export/write_msh.hpp"

#include "mesh/gmsh_elements.hpp"
#include "mesh/numbering.hpp"
#include "shape/topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace spricka::mesh {
namespace {

/// Members of overlapping sets, sorted into classes that the same sets hold: gmsh's entities, each
/// of which may belong to several physical groups, but each element to one entity only.
class Classes {
public:
  explicit Classes(std::size_t members) : of_(members, 0) {}

  void add(std::size_t member, int set) {
    const int before = of_[member];
    if (!sets_[static_cast<std::size_t>(before)].empty() &&
        sets_[static_cast<std::size_t>(before)].back() == set) {
      return; // twice in one set
    }
    const auto [at, fresh] = next_.try_emplace({before, set}, static_cast<int>(sets_.size()));
    if (fresh) {
      std::vector<int> sets = sets_[static_cast<std::size_t>(before)];
      sets.push_back(set);
      sets_.push_back(std::move(sets));
    }
    of_[member] = at->second;
  }
  /// Class of a member; 0 holds those of no set.
  [[nodiscard]] int of(std::size_t member) const { return of_[member]; }
  [[nodiscard]] std::size_t count() const { return sets_.size(); }
  /// Sets that hold a class.
  [[nodiscard]] std::vector<int>& sets(std::size_t c) { return sets_[c]; }

private:
  std::vector<int> of_;
  std::vector<std::vector<int>> sets_{{}};
  std::map<std::pair<int, int>, int> next_;
};

/// Elements of one dimension: gmsh's type, class and nodes of each.
struct Cells {
  int dim;
  Classes classes;
  std::vector<int> type;
  std::vector<base::Label> label; ///< empty: numbered on
  std::vector<std::size_t> first{0};
  std::vector<base::NodeId> nodes;

  void close(int gmsh_type) {
    type.push_back(gmsh_type);
    first.push_back(nodes.size());
  }
};

/// gmsh's number and order of an element type.
const GmshElementType& to_gmsh(base::ElementType type) {
  static const std::vector<GmshElementType> known = [] {
    std::vector<GmshElementType> all(base::element_infos.size());
    for (int number = 1; number < 32; ++number) {
      if (const auto element = find_gmsh_element_type(number)) {
        all[static_cast<std::size_t>(element->type)] = *element;
      }
    }
    return all;
  }();
  return known[static_cast<std::size_t>(type)];
}

/// Of a side; lines have our order.
GmshElementType side_to_gmsh(base::ElementType type, int side) {
  if (shape::side_domain(type, side) != base::ReferenceDomain::line) {
    return to_gmsh(shape::solid_side_type(type, side));
  }
  return {shape::side_nodes(type, side).size() == 2 ? 1 : 8, type, {}};
}

/// The nodes of an element or side as gmsh orders them.
template <class NodeOf>
void append(const GmshElementType& form, std::size_t count, const NodeOf& node, Cells& cells) {
  const std::size_t start = cells.nodes.size();
  cells.nodes.resize(start + count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = form.order.empty() ? i : static_cast<std::size_t>(form.order[i]);
    cells.nodes[start + place] = node(i);
  }
}

class MshText {
public:
  explicit MshText(const model::Mesh& mesh) : mesh_(mesh) {}

  std::string text() {
    number_nodes();
    std::array<Cells, 3> cells{bodies(), faces(), points()};
    std::string head = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    head += fmt::format("$PhysicalNames\n{}\n{}$EndPhysicalNames\n", groups_, names_);
    write_entities(cells);
    write_nodes();
    write_elements(cells);
    return head + text_;
  }

private:
  template <class... T> void put(fmt::format_string<T...> form, T&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<T>(values)...);
  }
  void name_group(int dim, int tag, const std::string& name) {
    ++groups_;
    names_ += fmt::format("{} {} \"{}\"\n", dim, tag, name);
  }

  /// Names what has a name and members, calls take(member, number of the set), and returns how many
  /// sets that are.
  template <class Set, class Member, class Take>
  std::size_t name_sets(int dim, const std::vector<Set>& sets, std::vector<Member> Set::*members,
                        Take&& take) {
    const std::size_t before = groups_;
    for (std::size_t s = 0; s < sets.size(); ++s) {
      if (sets[s].name.empty() || (sets[s].*members).empty()) {
        continue;
      }
      name_group(dim, static_cast<int>(s) + 1, sets[s].name);
      for (const Member& member : sets[s].*members) {
        take(member, static_cast<int>(s) + 1);
      }
    }
    return groups_ - before;
  }

  void number_nodes() {
    used_ = model::mark_nodes_in_use(mesh_);
    tag_ = make_labels_unique(mesh_.node_label);
  }

  Cells bodies() {
    Cells cells{mesh_.dim, Classes(mesh_.element_count()), {}, {}, {0}, {}};
    const std::size_t named =
        name_sets(mesh_.dim, mesh_.element_sets, &model::ElementSet::elements,
                  [&](base::ElementId e, int set) { cells.classes.add(e.index(), set); });
    bool rest = false;
    for (std::size_t e = 0; e < mesh_.element_count(); ++e) {
      const auto nodes = mesh_.element_nodes(base::ElementId(e));
      const GmshElementType& form = to_gmsh(mesh_.type[e]);
      append(
          form, nodes.size(), [&](std::size_t i) { return nodes[i]; }, cells);
      cells.close(form.number);
      rest = rest || cells.classes.of(e) == 0;
    }
    if (named > 0 && rest) { // else a reader would drop them
      const int tag = static_cast<int>(mesh_.element_sets.size()) + 1;
      name_group(mesh_.dim, tag, "REST");
      cells.classes.sets(0).push_back(tag);
    }
    cells.label = make_labels_unique(mesh_.element_label);
    return cells;
  }

  Cells faces() {
    std::vector<model::Face> all;
    for (const model::FaceSet& set : mesh_.face_sets) {
      all.insert(all.end(), set.faces.begin(), set.faces.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    Cells cells{mesh_.dim - 1, Classes(all.size()), {}, {}, {0}, {}};
    name_sets(cells.dim, mesh_.face_sets, &model::FaceSet::faces,
              [&](const model::Face& face, int set) {
                const auto at = std::lower_bound(all.begin(), all.end(), face);
                cells.classes.add(static_cast<std::size_t>(at - all.begin()), set);
              });
    for (const model::Face& face : all) {
      const base::ElementType type = mesh_.type[face.element.index()];
      const auto local = shape::side_nodes(type, face.side);
      const auto nodes = mesh_.element_nodes(face.element);
      const GmshElementType form = side_to_gmsh(type, face.side);
      append(
          form, local.size(),
          [&](std::size_t i) { return nodes[static_cast<std::size_t>(local[i])]; }, cells);
      cells.close(form.number);
    }
    return cells;
  }

  /// Node sets are sets of gmsh's point elements.
  Cells points() {
    static constexpr int point = 15;
    Classes classes(mesh_.node_count());
    name_sets(0, mesh_.node_sets, &model::NodeSet::nodes, [&](base::NodeId n, int set) {
      if (used_[n.index()]) {
        classes.add(n.index(), set);
      }
    });
    std::vector<std::size_t> members;
    for (std::size_t n = 0; n < mesh_.node_count(); ++n) {
      if (classes.of(n) != 0) {
        members.push_back(n);
      }
    }
    Cells cells{0, Classes(0), {}, {}, {0}, {}};
    Classes of_members(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (const int s : classes.sets(static_cast<std::size_t>(classes.of(members[i])))) {
        of_members.add(i, s);
      }
      cells.nodes.emplace_back(members[i]);
      cells.close(point);
    }
    cells.classes = std::move(of_members);
    return cells;
  }

  void write_entities(std::array<Cells, 3>& cells) {
    std::array<Cells*, 4> by_dim{};
    for (Cells& c : cells) {
      by_dim[static_cast<std::size_t>(c.dim)] = &c;
    }
    const auto count = [&](std::size_t d) { return by_dim[d] ? by_dim[d]->classes.count() : 0; };
    put("$Entities\n{} {} {} {}\n", count(0), count(1), count(2), count(3));
    for (std::size_t d = 0; d < 4; ++d) {
      for (std::size_t c = 0; c < count(d); ++c) {
        const std::vector<int>& sets = by_dim[d]->classes.sets(c);
        put("{}{} {}{}{}\n", c + 1, d == 0 ? " 0 0 0" : " 0 0 0 0 0 0", sets.size(),
            sets.empty() ? "" : " ", fmt::join(sets, " "));
        if (d > 0) { // no bounding entities: their count ends the line
          text_.insert(text_.size() - 1, " 0");
        }
      }
    }
    put("$EndEntities\n");
  }

  void write_nodes() {
    const auto count = std::count(used_.begin(), used_.end(), true);
    base::Label lowest = 0;
    base::Label highest = 0;
    for (std::size_t n = 0; n < used_.size(); ++n) {
      if (used_[n]) {
        lowest = lowest == 0 ? tag_[n] : std::min(lowest, tag_[n]);
        highest = std::max(highest, tag_[n]);
      }
    }
    put("$Nodes\n1 {} {} {}\n{} 1 0 {}\n", count, lowest, highest, mesh_.dim, count);
    for (std::size_t n = 0; n < used_.size(); ++n) {
      if (used_[n]) {
        put("{}\n", tag_[n]);
      }
    }
    for (std::size_t n = 0; n < used_.size(); ++n) {
      if (used_[n]) {
        put("{} {} {}\n", mesh_.x[n].x(), mesh_.x[n].y(), mesh_.x[n].z());
      }
    }
    put("$EndNodes\n");
  }

  void write_elements(std::array<Cells, 3>& cells) {
    std::size_t count = 0;
    base::Label last = 0;
    for (const base::Label label : cells[0].label) {
      last = std::max(last, label);
    }
    for (Cells& c : cells) {
      count += c.type.size();
      while (c.label.size() < c.type.size()) {
        c.label.push_back(++last);
      }
    }
    std::string body;
    std::swap(body, text_);
    std::size_t blocks = 0;
    for (const Cells& c : cells) {
      blocks += write_blocks(c);
    }
    std::swap(body, text_);
    put("$Elements\n{} {} 1 {}\n", blocks, count, std::max<base::Label>(last, 1));
    text_ += body;
    put("$EndElements\n");
  }

  std::size_t write_blocks(const Cells& c) {
    std::vector<std::size_t> order(c.type.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t i) { return std::pair(c.classes.of(i), c.type[i]); };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return key(i) < key(j); });
    std::size_t blocks = 0;
    for (std::size_t i = 0; i < order.size(); ++blocks) {
      std::size_t j = i;
      while (j < order.size() && key(order[j]) == key(order[i])) {
        ++j;
      }
      put("{} {} {} {}\n", c.dim, c.classes.of(order[i]) + 1, c.type[order[i]], j - i);
      for (; i < j; ++i) {
        put("{}", c.label[order[i]]);
        for (std::size_t n = c.first[order[i]]; n < c.first[order[i] + 1]; ++n) {
          put(" {}", tag_[c.nodes[n].index()]);
        }
        put("\n");
      }
    }
    return blocks;
  }

  const model::Mesh& mesh_;
  std::vector<bool> used_;
  std::vector<base::Label> tag_;
  std::size_t groups_ = 0;
  std::string names_;
  std::string text_;
};

} // namespace

std::string write_msh(const model::Mesh& mesh) {
  return MshText(mesh).text();
}

} // namespace spricka::mesh
