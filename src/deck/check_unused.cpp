// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/context.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

/// What nothing uses, and what stands twice: a deck says both by mistake.
namespace spricka::deck {

namespace {

void unused_spectra(DeckContext& c) {
  for (std::size_t i = 0; i < c.model.spectra.size(); ++i) {
    if (!c.model.growth || c.model.growth->spectrum != i) {
      c.warning(
          c.model.spectra[i].span, "W357",
          fmt::format("no $GROW uses spectrum {}: it counts nowhere", c.model.spectra[i].name),
          fmt::format("$GROW LAW=.. SPECTRUM={} in place of KMAX and KMIN",
                      c.model.spectra[i].name));
    }
  }
}

void unused_interactions(DeckContext& c) {
  for (std::size_t i = 0; i < c.model.interactions.size(); ++i) {
    const model::LoadInteractionDefinition& unused = c.model.interactions[i];
    if (!c.model.growth || std::ranges::find(c.model.growth->interactions, std::optional(i)) ==
                               c.model.growth->interactions.end()) {
      c.warning(unused.span, "W357",
                fmt::format("no $GROW uses interaction {}: it counts nowhere", unused.name),
                fmt::format("$GROW SPECTRUM=.. INTERACTION={}", unused.name));
    }
  }
}

void unused_rigids(DeckContext& c) {
  for (std::size_t i = 0; i < c.model.rigids.size(); ++i) {
    const bool used = std::ranges::any_of(c.model.contacts, [&](const model::Contact& contact) {
      return contact.rigid == base::RigidId(i);
    });
    if (!used) {
      c.warning(c.model.rigids[i].span, "W357",
                fmt::format("no $CONTACT has {} as its MASTER: nothing can touch it",
                            c.model.rigids[i].name),
                fmt::format("$CONTACT SLAVE=.. MASTER={}", c.model.rigids[i].name));
    }
  }
}

bool same_value(const base::CompiledExpression& a, const base::CompiledExpression& b) {
  return std::ranges::equal(a.code, b.code, [](const auto& one, const auto& two) {
    return one.op == two.op && one.value == two.value;
  });
}

bool same_load(const model::Load& a, const model::Load& b) {
  return a.type == b.type && a.shape == b.shape && a.nodes == b.nodes && a.elements == b.elements &&
         a.faces == b.faces && std::ranges::equal(a.value, b.value, same_value);
}

// Without blanks: values that are alike by chance are written in different words.
std::string words_of(const DeckContext& c, base::SourceSpan span) {
  std::string words(c.sources.text(span));
  std::erase_if(words, [](char letter) { return letter == ' ' || letter == '\t'; });
  return words;
}

// Lines of one case add up, over several cards too.
void doubled_loads(DeckContext& c) {
  for (const model::LoadCase& load_case : c.model.cases) {
    const std::vector<model::Load>& loads = load_case.loads;
    for (std::size_t i = 1; i < loads.size(); ++i) {
      const bool none =
          std::ranges::all_of(loads[i].value, [](const base::CompiledExpression& value) {
            return value.is_constant() && value(base::Vec3::Zero()) == 0.0;
          });
      const auto last = loads.begin() + static_cast<std::ptrdiff_t>(i);
      const auto first = std::find_if(loads.begin(), last, [&](const model::Load& load) {
        return same_load(load, loads[i]) && words_of(c, load.span) == words_of(c, loads[i].span);
      });
      const bool reported =
          i > 1 && loads[i].span.begin == loads[i - 1].span.begin; // other crack face
      if (first != last && !none && !reported && first->span.begin != loads[i].span.begin) {
        c.warning(loads[i].span, "W358",
                  fmt::format("case {} has this load twice, first in line {}: it acts twice",
                              load_case.name, c.line_number(first->span)),
                  "lines of one case add up; take one of them away, or write twice the load");
      }
    }
  }
}

void doubled_points(DeckContext& c) {
  for (const model::ParameterSweep& sweep : c.model.sweeps) {
    for (std::size_t i = 1; i < sweep.values.size(); ++i) {
      const auto last = sweep.values.begin() + static_cast<std::ptrdiff_t>(i);
      if (std::find(sweep.values.begin(), last, sweep.values[i]) != last) {
        c.warning(sweep.span, "W361",
                  fmt::format("$SWEEP has {} = {:.6g} twice: the same point is solved "
                              "again",
                              sweep.parameters.front(), sweep.values[i].front()),
                  "");
        break;
      }
    }
  }
}

// Freedoms of a class that says that they are moved, and that no case moves: a clamp.
void unmoved_freedoms(DeckContext& c) {
  const model::Mesh& mesh = c.model.mesh;
  std::vector<bool> moved(mesh.node_count(), false);
  std::vector<unsigned> held(mesh.node_count(), 0);
  for (const model::LoadCase& load_case : c.model.cases) {
    for (const model::Load& load : load_case.loads) {
      for (const base::NodeId n : load.type == model::LoadType::displacement
                                      ? mesh.set_with_id(load.nodes).nodes
                                      : std::vector<base::NodeId>()) {
        moved[n.index()] = true;
      }
    }
  }
  const auto bits = [](const model::NodeSetFreedomRole& freedom) {
    return (freedom.dof[0] ? 1U : 0U) | (freedom.dof[1] ? 2U : 0U) | (freedom.dof[2] ? 4U : 0U);
  };
  for (const model::NodeSetFreedomRole& freedom : c.model.freedoms) {
    for (const base::NodeId n : freedom.cls == model::FreedomRole::suppressed
                                    ? mesh.set_with_id(freedom.nodes).nodes
                                    : std::vector<base::NodeId>()) {
      held[n.index()] |= bits(freedom);
    }
  }
  for (const model::NodeSetFreedomRole& freedom : c.model.freedoms) {
    if (freedom.cls != model::FreedomRole::prescribed) {
      continue;
    }
    const std::vector<base::NodeId>& nodes = mesh.set_with_id(freedom.nodes).nodes;
    const auto still = std::ranges::count_if(nodes, [&](base::NodeId n) {
      return !moved[n.index()] && (bits(freedom) & ~held[n.index()]) != 0;
    });
    if (still > 0) {
      c.warning(
          freedom.span, "W352",
          fmt::format("no $LOAD TYPE=DISP moves {} of these {} nodes with PRESCRIBED freedoms: "
                      "they are held fast",
                      still, nodes.size()),
          "a line `SET 0 0` below TYPE=DISP says that 0 is meant; a support is CLASS=SUPPRESSED");
    }
  }
}

} // namespace

void check_unused_entities(DeckContext& context) {
  if (context.diagnostics.has_errors()) {
    return;
  }
  unused_spectra(context);
  unused_interactions(context);
  unused_rigids(context);
  doubled_loads(context);
  doubled_points(context);
  unmoved_freedoms(context);
}

} // namespace spricka::deck
