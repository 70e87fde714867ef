// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/peers/inp_step_cards.hpp"

#include "mesh/set_name.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace spricka::program {
namespace {

using mesh::InpJointCards;
using InpLoadKind = InpJointCards::InpLoadKind;
using InpTarget = InpJointCards::InpTarget;
using Values = std::array<std::optional<double>, 3>;

/// What acts in a step, by what it acts on: a later line for the same replaces an earlier one.
struct ActiveLoads {
  std::map<InpTarget, Values> displacements, forces;
  std::map<InpTarget, double> pressures;
  std::map<std::pair<InpTarget, bool>, base::Vec3> body_forces; ///< and whether per mass
  bool operator==(const ActiveLoads&) const = default;
};

/// Names on data lines, several in a line.
std::string data_lines(const std::vector<std::string>& names) {
  std::string lines;
  std::size_t width = 0;
  constexpr std::size_t full = 90;
  for (const std::string& name : names) {
    const bool fresh = lines.empty() || width + name.size() > full;
    lines += fresh ? (lines.empty() ? "  " : "\n  ") : "  ";
    width = (fresh ? 0 : width) + name.size() + 2;
    lines += name;
  }
  return lines + "\n";
}

/// What a support or a force acts on: sets of the file, and nodes that it names one by one.
struct NamesAndNodes {
  std::vector<std::string> names;
  std::vector<base::Label> nodes;
};

/// Finds what cards name, and makes sets of nodes that have none.
class TargetNames {
public:
  TargetNames(const InpNets& nets, InpStepCards& cards) : nets_(nets), cards_(cards) {
    cards_.node_sets.resize(nets.nets().size());
  }

  void remark(std::string words) {
    if (std::ranges::find(cards_.remarks, words) == cards_.remarks.end()) {
      cards_.remarks.push_back(std::move(words));
    }
  }
  void add_target(const InpTarget& target, NamesAndNodes& into) {
    const std::vector<std::string> names =
        target.node > 0 ? std::vector<std::string>() : nets_.node_set(target.set);
    if (target.node > 0 && nets_.net_of_node(target.node)) {
      into.nodes.push_back(target.node);
    } else if (names.empty()) {
      remark(target.node > 0
                 ? "nodes of no element are held or loaded in the file: that is left out"
                 : fmt::format("set {} has no node of an element: what holds or loads it is left "
                               "out",
                               target.set));
    }
    into.names.insert(into.names.end(), names.begin(), names.end());
  }

  /// The names of all, with a set in each net of nodes named one by one.
  std::vector<std::string> names_of(NamesAndNodes of, const std::string& set) {
    std::vector<std::vector<std::string>> numbers(nets_.nets().size());
    for (const base::Label node : of.nodes) {
      numbers[*nets_.net_of_node(node)].push_back(std::to_string(node));
    }
    for (std::size_t net = 0; net < numbers.size(); ++net) {
      if (!numbers[net].empty()) {
        cards_.node_sets[net] +=
            fmt::format("  $NSET NAME={}\n  {}", set, data_lines(numbers[net]));
        of.names.push_back(nets_.nets()[net].name + "." + set);
      }
    }
    return of.names;
  }

private:
  const InpNets& nets_;
  InpStepCards& cards_;
};

class StepWriter {
public:
  StepWriter(const model::Model& model, const InpJointCards& joint, const InpNets& nets)
      : model_(model), joint_(joint), nets_(nets), targets_(nets, cards_) {}

  InpStepCards run() {
    std::vector<ActiveLoads> steps = active_loads();
    find_freedoms(steps);
    write_supports();
    write_steps(steps);
    return std::move(cards_);
  }

private:
  void remark(std::string words) { targets_.remark(std::move(words)); }

  /// Of the static steps; of what holds outside of steps, if there is none.
  std::vector<ActiveLoads> active_loads() {
    std::vector<ActiveLoads> steps;
    ActiveLoads active;
    add(joint_.steps.front(), active);
    for (std::size_t s = 1; s < joint_.steps.size(); ++s) {
      const InpJointCards::InpStepContent& step = joint_.steps[s];
      if (step.procedure != "STATIC") {
        remark(fmt::format("line {}: the step of *{} is left out", step.place.line,
                           step.procedure.empty() ? "STEP alone" : step.procedure));
        continue;
      }
      if (step.large_displacements) {
        remark("the file reckons with large displacements (NLGEOM): here they are small");
      }
      add(step, active);
      steps.push_back(active);
    }
    if (steps.empty()) {
      steps.push_back(active);
    }
    return steps;
  }

  static void add(const InpJointCards::InpStepContent& step, ActiveLoads& active) {
    if (step.new_supports) {
      active.displacements.clear();
    }
    if (step.new_forces) {
      active.forces.clear();
    }
    if (step.new_pressures) {
      active.pressures.clear();
      active.body_forces.clear();
    }
    for (const InpJointCards::InpDisplacement& d : step.displacements) {
      active.displacements[of_name(d.of)][static_cast<std::size_t>(d.dof)] = d.value;
    }
    std::set<std::pair<InpTarget, std::size_t>> met; // forces of one step add up
    for (const InpJointCards::InpLoad& load : step.loads) {
      const InpTarget on = of_name(load.on);
      if (load.kind == InpLoadKind::pressure) {
        active.pressures[on] = load.value.x();
      } else if (load.kind == InpLoadKind::body) {
        active.body_forces[{on, load.per_mass}] = load.value;
      } else {
        for (std::size_t dof = 0; dof < 3; ++dof) {
          const double force = load.value[static_cast<int>(dof)];
          if (force != 0.0) {
            const bool more = !met.insert({on, dof}).second;
            active.forces[on][dof] = force + (more ? active.forces[on][dof].value_or(0.0) : 0.0);
          }
        }
      }
    }
  }
  static InpTarget of_name(const InpTarget& target) {
    return {target.set.empty() ? "" : mesh::make_valid_set_name(target.set), target.node};
  }

  /// Held where the value is zero in every step, else prescribed. A freedom that is free in some
  /// step is held in all of them.
  void find_freedoms(const std::vector<ActiveLoads>& steps) {
    for (const ActiveLoads& step : steps) {
      for (const auto& [target, values] : step.displacements) {
        for (std::size_t dof = 0; dof < 3; ++dof) {
          if (values[dof]) {
            std::array<bool, 3>& moved = moved_[target];
            moved[dof] = moved[dof] || *values[dof] != 0.0;
            freedoms_[target][dof] = true;
          }
        }
      }
    }
    for (const ActiveLoads& step : steps) {
      for (const auto& [target, held] : freedoms_) {
        const auto at = step.displacements.find(target);
        for (std::size_t dof = 0; dof < 3; ++dof) {
          if (held[dof] && (at == step.displacements.end() || !at->second[dof])) {
            remark("a support that is not there in every step holds in all of them here");
          }
        }
      }
    }
  }

  [[nodiscard]] std::size_t dimension() const { return static_cast<std::size_t>(model_.mesh.dim); }

  void write_supports() {
    std::map<std::pair<bool, std::string>, NamesAndNodes> targets; // by class and DOF
    for (const auto& [target, held] : freedoms_) {
      for (const bool moves : {false, true}) {
        std::string dofs;
        for (std::size_t dof = 0; dof < dimension(); ++dof) {
          dofs += held[dof] && moved_[target][dof] == moves ? std::string(1, "XYZ"[dof]) : "";
        }
        if (!dofs.empty()) {
          targets_.add_target(target, targets[{moves, dofs}]);
        }
      }
    }
    for (auto& [kind, of] : targets) {
      const std::vector<std::string> names =
          targets_.names_of(std::move(of), (kind.first ? "MOVED_" : "HELD_") + kind.second);
      if (names.empty()) {
        continue;
      }
      cards_.supports +=
          fmt::format("$FREEDOM CLASS={} DOF={}\n{}", kind.first ? "PRESCRIBED" : "SUPPRESSED",
                      kind.second, data_lines(names));
      for (const std::string& name : names) {
        cards_.held_nets.insert(name.substr(0, name.find('.')));
      }
    }
  }
  void write_steps(const std::vector<ActiveLoads>& steps) {
    std::string loads;
    std::string cards;
    std::string before; // the case that acts
    for (std::size_t s = 0; s < steps.size(); ++s) {
      const bool same = s > 0 && steps[s] == steps[s - 1];
      const std::string name = fmt::format("STEP_{}", s + 1);
      const std::string text = same ? "" : load_cards(name, steps[s]);
      loads += text;
      cards += fmt::format("$STEP NAME={}\n", name);
      if (!same && !before.empty()) {
        cards += fmt::format("  LOAD {} 0\n", before);
      }
      if (!text.empty()) {
        cards += fmt::format("  LOAD {} 1\n", name);
      }
      before = same ? before : text.empty() ? "" : name;
    }
    cards_.loads_and_steps = loads + cards;
  }

  std::string load_cards(const std::string& name, const ActiveLoads& active) {
    std::map<std::string, NamesAndNodes> forced, moved; // by their values
    std::string pressures;
    std::string bodies;
    for (const auto& [target, values] : active.forces) {
      if (const std::string row = row_of(values, {true, true, true}); !row.empty()) {
        targets_.add_target(target, forced[row]);
      }
    }
    for (const auto& [target, values] : active.displacements) {
      if (const std::string row = row_of(values, moved_[target]); !row.empty()) {
        targets_.add_target(target, moved[row]);
      }
    }
    const std::string forces = lines_of(forced, name + "_F");
    const std::string moves = lines_of(moved, name + "_U");
    for (const auto& [target, value] : active.pressures) {
      const std::vector<std::string> faces = nets_.face_set(target.set);
      if (faces.empty()) {
        remark(fmt::format("there is no surface {}: the pressure on it is left out", target.set));
      }
      for (const std::string& set : faces) {
        pressures += fmt::format("  {} {:.12g}\n", set, value);
      }
    }
    for (const auto& [of, value] : active.body_forces) {
      bodies += body_lines(of.first.set, of.second, value);
    }
    std::string text;
    const auto card = [&](std::string_view type, const std::string& lines) {
      text += lines.empty() ? "" : fmt::format("$LOAD CASE={} TYPE={}\n{}", name, type, lines);
    };
    card("FORCE", forces);
    card("DISP", moves);
    card("PRESSURE", pressures);
    card("BODY", bodies);
    return text;
  }

  std::string lines_of(std::map<std::string, NamesAndNodes>& of_values, const std::string& set) {
    std::string lines;
    std::size_t number = 0;
    for (auto& [row, of] : of_values) {
      for (const std::string& name :
           targets_.names_of(std::move(of), fmt::format("{}{}", set, ++number))) {
        lines += fmt::format("  {}{}\n", name, row);
      }
    }
    return lines;
  }

  /// " 0 2 0"; empty where no value differs from zero.
  [[nodiscard]] std::string row_of(const Values& values, const std::array<bool, 3>& which) const {
    std::string row;
    bool any = false;
    for (std::size_t dof = 0; dof < dimension(); ++dof) {
      const double value = which[dof] ? values[dof].value_or(0.0) : 0.0;
      any = any || value != 0.0;
      row += fmt::format(" {:.12g}", value);
    }
    return any ? row : "";
  }

  std::string body_lines(const std::string& set, bool per_mass, const base::Vec3& value) {
    const std::vector<std::string> of = nets_.element_set(set);
    const std::optional<double> density = per_mass ? density_of(set) : std::optional(1.0);
    if (of.empty() || !density) {
      remark(of.empty()
                 ? fmt::format("there is no element set {}: the force on it is left out", set)
                 : fmt::format("elements of {} have no density, or several: their weight is left "
                               "out",
                               set));
      return "";
    }
    Values values;
    for (std::size_t dof = 0; dof < 3; ++dof) {
      values[dof] = *density * value[static_cast<int>(dof)];
    }
    const std::string row = row_of(values, {true, true, true});
    std::string lines;
    for (const std::string& name : of) {
      lines += row.empty() ? "" : fmt::format("  {}{}\n", name, row);
    }
    return lines;
  }

  [[nodiscard]] std::optional<double> density_of(const std::string& set) const {
    const auto at = std::ranges::find_if(model_.mesh.element_sets,
                                         [&](const auto& other) { return other.name == set; });
    std::optional<double> density;
    for (std::size_t i = 0; at != model_.mesh.element_sets.end() && i < at->elements.size(); ++i) {
      const base::PropertyId property = model_.mesh.property[at->elements[i].index()];
      const double rho =
          property.valid()
              ? model_.materials[model_.properties[property.index()].material.index()].rho
              : 0.0;
      if (rho == 0.0 || (density && *density != rho)) {
        return std::nullopt;
      }
      density = rho;
    }
    return density;
  }

  const model::Model& model_;
  const InpJointCards& joint_;
  const InpNets& nets_;
  std::map<InpTarget, std::array<bool, 3>> freedoms_, moved_;
  InpStepCards cards_;
  TargetNames targets_;
};

} // namespace

InpStepCards write_inp_step_cards(const model::Model& model, const mesh::InpJointCards& joint,
                                  const InpNets& nets) {
  return StepWriter(model, joint, nets).run();
}

} // namespace spricka::program
