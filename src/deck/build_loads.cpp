// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/sets.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using model::LoadType;

/// What a load type acts on and how many values a line of it has.
struct LoadForm {
  std::string_view word;
  LoadType type;
  bool per_direction;                ///< one value for each direction, else a single one
  base::PhysicalDimension dimension; ///< of a value, in length, force and angle
  std::string_view values;
  bool of_crack = false; ///< acts on both faces of a crack
};

constexpr std::array<LoadForm, 10> forms{{
    {"FORCE", LoadType::force, true, {0, 1, 0}, "a force for each direction"},
    {"RESULTANT", LoadType::resultant, true, {0, 1, 0}, "the total force for each direction"},
    {"TRACTION", LoadType::traction, true, {-2, 1, 0}, "a stress for each direction"},
    {"PRESSURE", LoadType::pressure, false, {-2, 1, 0}, "a pressure against the outer normal"},
    {"BODY", LoadType::body, true, {-3, 1, 0}, "a force per volume for each direction"},
    {"BEARING", LoadType::bearing, true, {0, 1, 0}, "the resultant for each direction"},
    {"DISP", LoadType::displacement, true, {1, 0, 0}, "a displacement for each direction"},
    {"TEMPERATURE", LoadType::temperature, false, {}, "a temperature"},
    {"FACES", LoadType::pressure, false, {-2, 1, 0}, "a pressure", true},
    {"RESIDUAL", LoadType::pressure, false, {-2, 1, 0}, "a stress across the crack", true},
}};

const LoadForm& form_of(std::string_view word) {
  return *std::ranges::find_if(forms, [&](const LoadForm& f) { return f.word == word; });
}

const LoadForm& form_of(LoadType type) {
  return *std::ranges::find(forms, type, &LoadForm::type);
}

// The face set of CRACK.LEFT or CRACK.RIGHT, invalid where the name means a set as well; none: not
// of that form.
std::optional<base::FaceSetId> crack_face_set(DeckContext& c, const NameReference& reference) {
  const std::size_t dot = reference.name.rfind('.');
  const std::string side = dot == std::string::npos ? "" : reference.name.substr(dot + 1);
  if (side != "LEFT" && side != "RIGHT") {
    return std::nullopt;
  }
  const std::string name = reference.name.substr(0, dot);
  const NameDefinition* crack = c.names.find({EntityKind::crack}, name, {});
  if (crack == nullptr || crack->poisoned || crack->index >= c.model.cracks.size()) {
    return std::nullopt;
  }
  if (c.names.find(accepted_kinds(EntityKind::any_set), reference.name, reference.net) != nullptr) {
    c.error(reference.span, "E302",
            fmt::format("{} is a set as well as the face of crack {}", reference.name, name),
            "rename the crack");
    return base::FaceSetId();
  }
  const model::CrackDefinition& found = c.model.cracks[crack->index];
  return side == "LEFT" ? found.left : found.right;
}

bool load_set(DeckContext& c, const NameReference& reference, model::Load& load) {
  switch (load.type) {
  case LoadType::force:
  case LoadType::displacement:
    load.nodes = resolve_node_set(c, reference).value_or(base::NodeSetId());
    return load.nodes.valid();
  case LoadType::body:
  case LoadType::temperature:
    load.elements = resolve_element_set(c, reference).value_or(base::ElementSetId());
    return load.elements.valid();
  case LoadType::traction:
  case LoadType::pressure:
    if (const auto crack_face = crack_face_set(c, reference)) {
      load.faces = *crack_face;
      return crack_face->valid();
    }
    break;
  case LoadType::resultant: {
    const auto known =
        c.names.find({EntityKind::face_set, EntityKind::node_set, EntityKind::element_set},
                     reference.name, reference.net);
    if (known != nullptr && known->kind == EntityKind::element_set) {
      load.elements = resolve_element_set(c, reference).value_or(base::ElementSetId());
      return load.elements.valid();
    }
    break;
  }
  default:
    break;
  }
  load.faces = resolve_face_set(c, reference).value_or(base::FaceSetId());
  return load.faces.valid();
}

bool load_value(DeckContext& c, const LoadForm& form, const grammar::CardField& field,
                model::Load& load) {
  if (!field.is_number_or_expression()) {
    c.read_number(field, grammar::QuantityKind::number,
                  "a number or (expression)"); // says what is wrong
    return false;
  }
  auto value = grammar::compile_expression(field.expression, c.scope,
                                           grammar::AllowedVariables::position, c.diagnostics);
  if (value && !value->is_constant() &&
      (form.type == LoadType::resultant || form.type == LoadType::bearing)) {
    c.error(field.span, "E209", fmt::format("TYPE={} is a total, which has no place", form.word),
            "give a number; TRACTION, PRESSURE and BODY take fields of x y z");
    return false;
  }
  if (!value || !check_field_unit(field, form.dimension,
                                  fmt::format("does not fit: {} is expected", form.values), c.scope,
                                  c.diagnostics)) {
    return false;
  }
  load.value.push_back(std::move(*value));
  return true;
}

void load_row(DeckContext& c, const CheckedCard& card, const grammar::DataRow& row,
              model::LoadCase& load_case) {
  const LoadForm& form = form_of(card.word_value("TYPE"));
  model::Load load;
  load.type = form.type;
  load.shape = card.key_has_word("SHAPE", "UNIFORM") ? model::BearingShape::uniform
                                                     : model::BearingShape::cosine;
  load.span = row.span;
  const auto reference = read_set_name_field(c, card, row.fields.front());
  const NameDefinition* crack = reference && form.of_crack
                                    ? find_referenced_definition(c, EntityKind::crack, *reference)
                                    : nullptr;
  bool ok = reference && (form.of_crack ? crack != nullptr : load_set(c, *reference, load));
  const std::size_t given = row.fields.size() - 1;
  const auto most = static_cast<std::size_t>(form.per_direction ? c.model.mesh.dim : 1);
  if (given == 0 || (given > most && c.mesh_sound)) {
    const base::SourceSpan at = given == 0 ? row.span : row.fields[most + 1].span;
    c.error(at, "E312",
            fmt::format("TYPE={} takes {}{} value{}, not {}", form.word, most > 1 ? "1 to " : "",
                        most, most == 1 ? "" : "s", given),
            std::string(form.values));
    ok = false;
  }
  for (std::size_t i = 1; i < row.fields.size(); ++i) {
    ok = load_value(c, form, row.fields[i], load) && ok;
  }
  if (ok && crack != nullptr) {
    ok = crack->index < c.model.cracks.size(); // else its card is wrong
  }
  if (ok && crack != nullptr) {
    load.faces = c.model.cracks[crack->index].left;
    load_case.loads.push_back(load);
    load.faces = c.model.cracks[crack->index].right;
  }
  if (ok) {
    load_case.loads.push_back(std::move(load));
  }
}

/// What the deck says of a node's freedoms, in bits of x y z.
struct NodeConstraints {
  unsigned prescribed = 0;
  unsigned suppressed = 0;
};

// A body has no way to leave its axis.
bool on_axis(const model::Model& model, base::NodeId node, std::size_t direction) {
  return model::is_axisymmetric(model) && direction == 0 &&
         model.mesh.x[node.index()].x() <= model::axis_tolerance(model.mesh);
}

// Displacements belong to prescribed freedoms: elsewhere they would have no effect, and what is
// suppressed does not move.
void check_displacement(DeckContext& c, const model::Load& load,
                        const std::vector<NodeConstraints>& held) {
  const model::Mesh& mesh = c.model.mesh;
  for (const base::NodeId node : mesh.set_with_id(load.nodes).nodes) {
    for (std::size_t d = 0; d < load.value.size(); ++d) {
      const base::CompiledExpression& value = load.value[d];
      const double here = value(mesh.x[node.index()]);
      const unsigned bit = 1U << d;
      const NodeConstraints& is = held[node.index()];
      const base::Label label = mesh.node_label[node.index()];
      if ((here != 0.0 || !value.is_constant()) && (is.prescribed & bit) == 0) {
        c.error(load.span, "E319",
                fmt::format("node {} has no PRESCRIBED freedom along {}", label, "XYZ"[d]),
                "TYPE=DISP gives values to $FREEDOM CLASS=PRESCRIBED");
        return;
      }
      if (here != 0.0 && ((is.suppressed & bit) != 0 || on_axis(c.model, node, d))) {
        c.error(
            load.span, "E319",
            fmt::format("node {} {} and cannot be moved by {:.6g} along {}", label,
                        (is.suppressed & bit) != 0 ? "is SUPPRESSED as well" : "lies on the axis",
                        here, "XYZ"[d]),
            "leave it out of one of the two sets");
        return;
      }
    }
  }
}

/// What the lines for one set give a freedom.
struct Reported {
  std::size_t set = 0; ///< of the case, by its first line
  double value = 0.0;
  base::SourceSpan span; ///< of its last line
};
using ReportedFreedoms = std::map<std::size_t, std::vector<Reported>>; // by 3 * node + direction

ReportedFreedoms reported_displacements(const model::Mesh& mesh, const model::LoadCase& load_case) {
  ReportedFreedoms reported;
  std::vector<const model::NodeSet*> sets;
  for (const model::Load& load : load_case.loads) {
    if (load.type != LoadType::displacement) {
      continue;
    }
    const model::NodeSet& set = mesh.set_with_id(load.nodes);
    const auto at = std::ranges::find_if(
        sets, [&](const model::NodeSet* s) { return s == &set || s->nodes == set.nodes; });
    const auto number = static_cast<std::size_t>(at - sets.begin());
    sets.push_back(&set);
    for (const base::NodeId node : std::set(set.nodes.begin(), set.nodes.end())) {
      for (std::size_t d = 0; d < load.value.size(); ++d) {
        std::vector<Reported>& here = reported[3 * node.index() + d];
        const double value = load.value[d](mesh.x[node.index()]);
        if (!here.empty() && here.back().set == number) {
          here.back().value += value;
        } else if (const auto same = std::ranges::find(here, number, &Reported::set);
                   same != here.end()) {
          same->value += value;
        } else {
          here.push_back({number, value, load.span});
        }
      }
    }
  }
  return reported;
}

// Lines for one set add up. Where different sets meet, at corners, the same value counts once, and
// a zero gives way; two others say two things.
void displacements_agree(DeckContext& c, const model::LoadCase& load_case) {
  constexpr double equal = 1e-9;
  for (const auto& [freedom, here] : reported_displacements(c.model.mesh, load_case)) {
    const Reported* first = nullptr;
    for (const Reported& t : here) {
      if (t.value == 0.0) {
        continue;
      }
      if (first != nullptr && std::abs(t.value - first->value) > equal * std::abs(first->value)) {
        c.error(t.span, "E433",
                fmt::format("case {} moves node {} along {} by {:.6g} and, as part of another set, "
                            "by {:.6g}",
                            load_case.name, c.model.mesh.node_label[freedom / 3],
                            "XYZ"[freedom % 3], t.value, first->value),
                "lines for one set add up; where sets meet they must agree");
        return;
      }
      first = first == nullptr ? &t : first;
    }
  }
}

std::vector<NodeConstraints> held_nodes(const DeckContext& c) {
  std::vector<NodeConstraints> held(c.model.mesh.node_count());
  for (const model::NodeSetFreedomRole& freedom : c.model.freedoms) {
    for (const base::NodeId node : c.model.mesh.set_with_id(freedom.nodes).nodes) {
      for (std::size_t d = 0; d < 3; ++d) {
        const unsigned bit = freedom.dof[d] ? 1U << d : 0U;
        held[node.index()].prescribed |= freedom.cls == model::FreedomRole::prescribed ? bit : 0U;
        held[node.index()].suppressed |= freedom.cls == model::FreedomRole::suppressed ? bit : 0U;
      }
    }
  }
  return held;
}

void check_displacements(DeckContext& c, const std::vector<NodeConstraints>& held) {
  for (const model::LoadCase& load_case : c.model.cases) {
    displacements_agree(c, load_case);
  }
  for (const model::LoadCase& load_case : c.model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (load.type == LoadType::displacement) {
        check_displacement(c, load, held);
      }
    }
  }
}

// Whether a value along that direction would count: a displacement counts where it is prescribed.
bool counts_along(const model::Mesh& mesh, const model::Load& load, std::size_t direction,
                  const std::vector<NodeConstraints>& held) {
  return load.type != LoadType::displacement ||
         std::ranges::any_of(mesh.set_with_id(load.nodes).nodes, [&](base::NodeId node) {
           return (held[node.index()].prescribed & (1U << direction)) != 0;
         });
}

// Directions along which a line says nothing have zeros, told of where another value would count.
void fill_in(DeckContext& c, const std::vector<NodeConstraints>& held, bool sound,
             model::Load& load) {
  const LoadForm& form = form_of(load.type);
  const std::size_t given = load.value.size();
  const auto most = static_cast<std::size_t>(c.model.mesh.dim);
  if (!form.per_direction || given >= most) {
    return;
  }
  std::vector<char> unsaid;
  for (std::size_t d = given; d < most; ++d) {
    load.value.push_back(base::CompiledExpression::make_constant(0.0));
    if (sound && counts_along(c.model.mesh, load, d, held)) {
      unsaid.push_back("xyz"[d]);
    }
  }
  if (!unsaid.empty()) {
    c.warning(load.span, "W312",
              fmt::format("TYPE={} has {} of {} values: along {} it is taken as 0", form.word,
                          given, most, fmt::join(unsaid, " and ")),
              std::string(form.values));
  }
}

} // namespace

void build_loads(DeckContext& context) {
  std::vector<model::LoadCase>& cases = context.model.cases;
  context.for_each_sound_card("LOAD", [&](const CheckedCard& card) {
    const std::string name(card.word_value("CASE"));
    const NameDefinition* before = context.names.define(
        name,
        {.kind = EntityKind::load_case, .index = cases.size(), .span = card.find("CASE")->span});
    if (before == nullptr || before->poisoned) {
      cases.push_back({name, {}});
    }
    const std::size_t index =
        before == nullptr || before->poisoned ? cases.size() - 1 : before->index;
    for (const grammar::DataRow& row : card.rows) {
      load_row(context, card, row, cases[index]);
    }
  });
  const bool sound = context.freedom_sound && context.mesh_sound;
  const std::vector<NodeConstraints> held =
      sound ? held_nodes(context) : std::vector<NodeConstraints>();
  if (sound) {
    check_displacements(context, held);
  }
  for (model::LoadCase& load_case : cases) {
    for (model::Load& load : load_case.loads) {
      fill_in(context, held, sound, load);
    }
  }
}

} // namespace spricka::deck
