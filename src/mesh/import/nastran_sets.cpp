// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_sets.hpp"

#include "mesh/set_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace spricka::mesh {
namespace {

using base::Label;

class NastranLoadSets {
public:
  NastranLoadSets(const NastranBulk& bulk, int dim, NastranModel& model,
                  std::vector<NastranIssue>& complaints)
      : bulk_(bulk), dim_(dim), model_(model), complaints_(complaints), sorted_(model.node) {
    std::sort(sorted_.begin(), sorted_.end());
  }

  std::vector<std::string> run() {
    std::map<Label, std::vector<Label>> sums; // sets of SPCADD by what they add
    for (const auto& [sum, parts] : bulk_.support_sums) {
      for (const Label part : parts) {
        sums[part].push_back(sum);
      }
    }
    for (const NastranBulk::NastranSupport& support : bulk_.supports) {
      const std::string freedoms = in_order(support.freedoms, support.place);
      std::vector<Label> sets{support.set};
      const auto also = sums.find(support.set);
      sets.insert(sets.end(), also == sums.end() ? sets.end() : also->second.begin(),
                  also == sums.end() ? sets.end() : also->second.end());
      for (const Label set : has_say(freedoms) ? sets : std::vector<Label>()) {
        add(fmt::format("SPC{}_{}", set, freedoms), support.nodes, support.place);
      }
    }
    for (const NastranBulk::NastranGrid& grid : bulk_.grids) {
      const std::string freedoms =
          in_order(grid.held.empty() ? bulk_.default_held : grid.held, grid.place);
      if (has_say(freedoms)) {
        add("PS_" + freedoms, {{grid.label, grid.label}}, grid.place);
      }
    }
    for (const NastranBulk::NastranForce& force : bulk_.forces) {
      add(fmt::format("FORCE_{}", force.set), {{force.node, force.node}}, force.place);
    }
    std::vector<std::string> names;
    for (const auto& surface : model_.surfaces) {
      if (surface.name.starts_with("PLOAD4_")) {
        names.push_back(surface.name);
      }
    }
    for (auto& [name, set] : sets_) {
      names.push_back(name);
      model_.node_sets.push_back(std::move(set));
    }
    return names;
  }

private:
  /// 321 is 123; what are no freedoms is complained of.
  std::string in_order(std::string freedoms, InpLocation at) {
    if (freedoms == "0") {
      return {};
    }
    if (freedoms.find_first_not_of("123456") != std::string::npos) {
      complaints_.push_back(
          {at, fmt::format("the freedoms '{}' are no digits from 1 to 6", freedoms), {}});
      return {};
    }
    std::sort(freedoms.begin(), freedoms.end());
    freedoms.erase(std::unique(freedoms.begin(), freedoms.end()), freedoms.end());
    return freedoms;
  }
  [[nodiscard]] bool has_say(const std::string& freedoms) const {
    return !freedoms.empty() && freedoms.front() - '0' <= dim_;
  }

  /// Of a range the nodes that are there; one by its number must be.
  void add(const std::string& name, const std::vector<NastranBulk::LabelRange>& ranges,
           InpLocation place) {
    auto& set = sets_.try_emplace(name, NastranModel::NastranSet{name, {}, place}).first->second;
    for (const auto& [first, last] : ranges) {
      if (first == last) {
        set.members.push_back(first);
        continue;
      }
      set.members.insert(set.members.end(), std::lower_bound(sorted_.begin(), sorted_.end(), first),
                         std::upper_bound(sorted_.begin(), sorted_.end(), last));
    }
  }

  const NastranBulk& bulk_;
  int dim_;
  NastranModel& model_;
  std::vector<NastranIssue>& complaints_;
  std::vector<Label> sorted_;
  std::map<std::string, NastranModel::NastranSet> sets_;
};

} // namespace

std::string name_of_nastran_list(const NastranBulk& bulk, const NastranBulk::NastranList& list) {
  const auto name = bulk.set_names.find(list.set);
  return name == bulk.set_names.end() ? fmt::format("SET{}", list.set) : name->second;
}

void add_nastran_lists(const NastranBulk& bulk, NastranModel& model) {
  std::vector<Label> nodes = model.node;
  std::vector<Label> elements = model.element;
  std::sort(nodes.begin(), nodes.end());
  std::sort(elements.begin(), elements.end());
  for (const NastranBulk::NastranList& list : bulk.lists) {
    const std::vector<Label>& known = list.elements ? elements : nodes;
    NastranModel::NastranSet set{name_of_nastran_list(bulk, list), {}, list.place};
    for (const auto& [first, last] : list.members) {
      set.members.insert(set.members.end(), std::lower_bound(known.begin(), known.end(), first),
                         std::upper_bound(known.begin(), known.end(), last));
    }
    std::vector<NastranModel::NastranSet>& sets =
        list.elements ? model.element_sets : model.node_sets;
    const bool taken = std::any_of(sets.begin(), sets.end(), [&](const auto& other) {
      return make_valid_set_name(other.name) == make_valid_set_name(set.name);
    });
    if (taken) { // a property has the name, or another list
      set.name = fmt::format("SET{}", list.set);
    }
    if (!set.members.empty()) {
      sets.push_back(std::move(set));
    }
  }
}

std::vector<std::string> add_nastran_load_sets(const NastranBulk& bulk, int dim,
                                               NastranModel& model,
                                               std::vector<NastranIssue>& complaints) {
  return NastranLoadSets(bulk, dim, model, complaints).run();
}

} // namespace spricka::mesh
