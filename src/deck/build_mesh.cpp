// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/by_dimension.hpp"
#include "deck/context.hpp"
#include "deck/import_card.hpp"
#include "deck/mesh_limits.hpp"
#include "deck/mesh_shapes.hpp"
#include "grammar/bulk_table.hpp"
#include "mesh/generate/generate.hpp"
#include "mesh/generate/swept_solid.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

constexpr double more_than_a_turn = 6.29; // radians

/// The set of a kind that a table adds to, made at its first use. Null after an error.
template <class Set>
Set* table_set(DeckContext& c, const CheckedCard& card, std::string_view key,
               std::vector<Set>& sets) {
  if (!card.has_key(key)) {
    return nullptr;
  }
  const CheckedValue& value = *card.find(key);
  const NameDefinition definition{
      .kind = value.key->kind, .index = sets.size(), .span = value.span};
  const std::string full = qualified_name(card.net, value.text);
  const NameDefinition* before = c.names.define(full, definition);
  if (before == nullptr) {
    return &sets.emplace_back(Set{full, {}, value.span});
  }
  if (before->card) {
    c.report_duplicate_name(definition, value.text, *before);
    return nullptr;
  }
  return before->poisoned ? nullptr : &sets[before->index];
}

grammar::BulkRowFormat coordinate_form(const CheckedCard& card) {
  const std::string columns = card.key_has_word("SYSTEM", "CYL") ? "r theta" : "x y";
  grammar::BulkRowFormat form;
  form.columns = static_cast<std::size_t>(card.integer_value("DIM"));
  form.missing = form.columns == 3 ? fmt::format("a line is id {} z; DIM=2 has no z", columns)
                                   : fmt::format("a line is id {}", columns);
  form.surplus = form.columns == 2 ? fmt::format("with DIM=2 a line is id {}", columns)
                                   : fmt::format("a line is id {} z", columns);
  return form;
}

void coordinates(DeckContext& c, const CheckedCard& card) {
  const bool polar = card.key_has_word("SYSTEM", "CYL");
  const grammar::BulkRowFormat form = coordinate_form(card);
  LabelMap& labels = c.node_labels[card.net_id.index()];
  model::Mesh& mesh = c.model.mesh;
  model::NodeSet* const set = table_set(c, card, "NSET", mesh.node_sets);
  const std::size_t errors = c.diagnostics.error_count();
  std::size_t twice = 0;
  bool turned = false;
  const auto take = [&](const grammar::BulkTableBlock<double>& table) {
    for (std::size_t i = 0; i < table.label.size(); ++i) {
      const double* v = &table.value[i * form.columns];
      if (polar && !turned && std::abs(v[1]) > more_than_a_turn) {
        turned = true; // once for a table
        c.warning(grammar::table_field_span(c.sources, card.data, table.offset[i], 2), "W355",
                  fmt::format("theta = {:.6g} of node {} is in radians, more than a turn", v[1],
                              table.label[i]),
                  fmt::format("degrees are written {:.6g}[deg]", v[1]));
      }
      const base::Vec3 x(polar ? v[0] * std::cos(v[1]) : v[0], polar ? v[0] * std::sin(v[1]) : v[1],
                         form.columns == 3 ? v[2] : 0.0);
      if (!labels.insert(table.label[i], mesh.node_count())) {
        c.error(grammar::table_field_span(c.sources, card.data, table.offset[i], 0), "E304",
                fmt::format("node {} is defined twice", table.label[i]));
        ++twice;
        continue;
      }
      const base::NodeId node = model::add_node(mesh, x, table.label[i], card.net_id);
      if (set != nullptr) {
        set->nodes.push_back(node);
      }
    }
  };
  grammar::parse_node_lines(form, card.data, c.scope, c.diagnostics, take);
  // a number that stands twice is known all the same
  labels.complete = labels.complete && c.diagnostics.error_count() == errors + twice;
}

// Node indices of one row; false if a number is unknown or stands twice.
bool resolve(const LabelMap& labels, std::span<const base::Label> row,
             std::vector<base::NodeId>& nodes) {
  bool ok = true;
  for (std::size_t k = 0; k < row.size(); ++k) {
    const auto found = labels.find(row[k]);
    nodes[k] = found ? base::NodeId(*found) : base::NodeId();
    ok = ok && found;
    for (std::size_t j = 0; j < k; ++j) {
      ok = ok && nodes[j] != nodes[k];
    }
  }
  return ok;
}

// Says what is wrong with a row that could not be resolved.
void report_row(DeckContext& c, const CheckedCard& card,
                const grammar::BulkTableBlock<base::Label>& table, std::size_t row) {
  const LabelMap& labels = c.node_labels[card.net_id.index()];
  const base::Label* of_row = &table.value[row * table.columns];
  for (std::size_t k = 0; k < table.columns; ++k) {
    const bool twice = std::find(of_row, of_row + k, of_row[k]) != of_row + k;
    if (twice || (labels.complete && !labels.find(of_row[k]))) {
      c.error(grammar::table_field_span(c.sources, card.data, table.offset[row], k + 1), "E303",
              twice ? fmt::format("node {} stands twice in element {}", of_row[k], table.label[row])
                    : fmt::format("there is no node {}{}", of_row[k],
                                  card.net.empty() ? "" : " in net " + card.net));
    }
  }
}

void elements(DeckContext& c, const CheckedCard& card) {
  const base::ElementType type = element_type_of_card(card);
  const base::ElementInfo& info = base::element_info(type);
  grammar::BulkRowFormat form;
  form.columns = static_cast<std::size_t>(info.nodes);
  form.row = "element number";
  form.missing =
      fmt::format("{} takes {} nodes; continue a line with a leading &", info.name, info.nodes);
  form.surplus = fmt::format("{} takes {} nodes", info.name, info.nodes);
  model::Mesh& mesh = c.model.mesh;
  model::ElementSet* const set = table_set(c, card, "ESET", mesh.element_sets);
  const LabelMap& node_labels = c.node_labels[card.net_id.index()];
  LabelMap& labels = c.element_labels[card.net_id.index()];
  ElementOrigin origin{mesh.element_count(), 0, card.span, card.data};
  std::vector<base::NodeId> nodes(form.columns);
  const auto take = [&](const grammar::BulkTableBlock<base::Label>& table) {
    for (std::size_t i = 0; i < table.label.size(); ++i) {
      if (!resolve(node_labels, {&table.value[i * form.columns], form.columns}, nodes)) {
        report_row(c, card, table, i);
        labels.complete = false;
        continue;
      }
      if (!labels.insert(table.label[i], mesh.element_count())) {
        c.error(grammar::table_field_span(c.sources, card.data, table.offset[i], 0), "E304",
                fmt::format("element {} is defined twice", table.label[i]));
        continue;
      }
      const base::ElementId e = model::add_element(mesh, type, nodes, table.label[i], card.net_id);
      if (set != nullptr) {
        set->elements.push_back(e);
      }
    }
  };
  grammar::parse_element_lines(form, card.data, c.scope, c.diagnostics, take);
  origin.count = mesh.element_count() - origin.first;
  c.origins.push_back(origin);
}

constexpr base::ByDimension block_generators{&mesh::generate_block, &mesh::generate_solid_block};

void generate_block(model::Mesh& mesh, const CheckedCard& card, const std::string& prefix,
                    int times) {
  mesh::BlockSpec spec = block_spec(card);
  spec.nx *= times;
  spec.ny *= times;
  spec.nz *= times;
  block_generators.at(base::element_info(spec.type).dim)(mesh, card.net_id, prefix, spec);
}

/// A mesh of a shape other than a block, of plane elements of a type; sizes times as fine.
void generate_outline(model::Mesh& mesh, const CheckedCard& card, const std::string& prefix,
                      base::ElementType type, int times) {
  const auto finer = [&](auto spec) {
    spec.type = type;
    spec.nr *= times;
    spec.nt *= times;
    return spec;
  };
  if (card.key_has_word("SHAPE", "RING")) {
    mesh::generate_ring(mesh, card.net_id, prefix, finer(ring_spec(card)));
  } else if (card.key_has_word("SHAPE", "PLATE")) {
    mesh::generate_plate(mesh, card.net_id, prefix, finer(plate_spec(card)));
  } else {
    mesh::generate_lug(mesh, card.net_id, prefix, finer(lug_spec(card)));
  }
}

void generate_plane(model::Mesh& mesh, const CheckedCard& card, const std::string& prefix,
                    int times) {
  generate_outline(mesh, card, prefix, element_type_of_card(card), times);
}

void generate_solid(model::Mesh& mesh, const CheckedCard& card, const std::string& prefix,
                    int times) {
  const mesh::SweepSpec spec{.type = element_type_of_card(card),
                             .z0 = card.number_value("Z0"),
                             .depth = card.number_value("LZ"),
                             .layers = times * card.integer_value("NZ")};
  model::Mesh plane;
  generate_outline(plane, card, "", mesh::swept_plane_type(spec.type), times);
  mesh::sweep_plane_mesh(mesh, card.net_id, prefix, plane, spec);
}

constexpr base::ByDimension outline_generators{&generate_plane, &generate_solid};

void generate(DeckContext& c, const CheckedCard& card) {
  const std::string prefix = card.net.empty() ? "" : card.net + ".";
  const NetRefinement* finer = c.net_refinement(card.net);
  const int times = finer == nullptr ? 1 : finer->counts;
  if (times > 1) {
    c.remeshed.insert(card.net);
  }
  if (card.key_has_word("SHAPE", "BLOCK")) {
    generate_block(c.model.mesh, card, prefix, times);
  } else {
    outline_generators.at(base::element_info(element_type_of_card(card)).dim)(c.model.mesh, card,
                                                                              prefix, times);
  }
}

// Names of the sets that came with a generated or imported mesh. False after an error: one name
// that is taken stands for all of them.
template <class Set>
bool adopt_sets(DeckContext& c, const CheckedCard& card, EntityKind kind, std::vector<Set>& sets,
                std::size_t first) {
  const auto of_net = [&](const model::NetDefinition& net) { return net.name == card.net; };
  for (std::size_t i = first; i < sets.size(); ++i) {
    if (!sets[i].span.valid()) {
      sets[i].span = card.span;
    }
    const NameDefinition* before =
        c.names.define(sets[i].name, {.kind = kind, .index = i, .span = card.span});
    if (before == nullptr || before->poisoned) {
      continue;
    }
    const std::vector<model::NetDefinition>& nets = c.model.nets;
    if (std::ranges::count_if(nets, of_net) < 2) { // else the net is said to be double
      c.error(card.span, "E302", fmt::format("there is a set {} already", sets[i].name),
              "put each mesh into a $NET of its own");
    }
    return false;
  }
  return true;
}

void adopt_labels(DeckContext& c, const CheckedCard& card, std::size_t node, std::size_t element) {
  const model::Mesh& mesh = c.model.mesh;
  for (; node < mesh.node_count(); ++node) {
    c.node_labels[card.net_id.index()].insert(mesh.node_label[node], node);
  }
  c.origins.push_back({element, mesh.element_count() - element, card.span, {}});
  for (; element < mesh.element_count(); ++element) {
    c.element_labels[card.net_id.index()].insert(mesh.element_label[element], element);
  }
}

// A whole mesh from one card.
void mesh_card(DeckContext& c, const CheckedCard& card) {
  model::Mesh& mesh = c.model.mesh;
  const std::array<std::size_t, 5> before{mesh.node_count(), mesh.element_count(),
                                          mesh.node_sets.size(), mesh.element_sets.size(),
                                          mesh.face_sets.size()};
  const std::size_t errors = c.diagnostics.error_count();
  if (card.spec->name == "IMPORT") {
    import_mesh_file(c, card);
  } else if (check_mesh_shape(c, card) && check_requested_mesh_size(c, card)) {
    generate(c, card);
  }
  adopt_labels(c, card, before[0], before[1]);
  const bool fresh = adopt_sets(c, card, EntityKind::node_set, mesh.node_sets, before[2]) &&
                     adopt_sets(c, card, EntityKind::element_set, mesh.element_sets, before[3]) &&
                     adopt_sets(c, card, EntityKind::face_set, mesh.face_sets, before[4]);
  if (!fresh || c.diagnostics.error_count() != errors || mesh.element_count() == before[1]) {
    c.names.poison_net(card.net);
    c.node_labels[card.net_id.index()].complete = false;
    c.element_labels[card.net_id.index()].complete = false;
  }
}

// Room for every table of the deck at once: arrays of millions that grow by doubling would take
// three times their size on the way.
void reserve_tables(DeckContext& c) {
  std::size_t nodes = 0;
  std::size_t elements = 0;
  std::size_t entries = 0;
  for (const CheckedCard& card : c.cards) {
    if (card.spec->name == "COOR") {
      nodes += grammar::count_lines(c.sources, card.data);
    } else if (card.spec->name == "ELEMENT" && !card.bad) {
      const std::size_t lines = grammar::count_lines(c.sources, card.data);
      elements += lines;
      entries +=
          lines * static_cast<std::size_t>(base::element_info(element_type_of_card(card)).nodes);
    }
  }
  model::reserve(c.model.mesh, nodes, elements, entries);
}

} // namespace

void build_mesh(DeckContext& context) {
  reserve_tables(context);
  const std::size_t nets = context.model.nets.size();
  context.node_labels.resize(nets);
  context.element_labels.resize(nets);
  const std::size_t errors = context.diagnostics.error_count();
  for (const CheckedCard& card : context.cards) {
    if (card.bad &&
        (card.spec->name == "COOR" || card.spec->name == "MESH" || card.spec->name == "IMPORT")) {
      context.node_labels[card.net_id.index()].complete = false;
    }
    if (card.bad && (card.spec->name == "ELEMENT" || card.spec->name == "MESH" ||
                     card.spec->name == "IMPORT")) {
      context.element_labels[card.net_id.index()].complete = false;
    }
  }
  // Nodes before the elements that use them, wherever they stand; tables before meshes, which
  // number on from the highest label of their net.
  context.for_each_sound_card("COOR", [&](const CheckedCard& card) { coordinates(context, card); });
  context.for_each_sound_card("ELEMENT", [&](const CheckedCard& card) { elements(context, card); });
  for (const CheckedCard& card : context.cards) {
    if (!card.bad && (card.spec->name == "MESH" || card.spec->name == "IMPORT")) {
      mesh_card(context, card);
    }
  }
  // of the space the deck means, though a bad mesh in space was not made
  model::Mesh& mesh = context.model.mesh;
  mesh.dim = 2;
  for (const std::string_view name : {"MESH", "ELEMENT"}) {
    context.for_each_sound_card(name, [&](const CheckedCard& card) {
      mesh.dim = std::max(mesh.dim, base::element_info(element_type_of_card(card)).dim);
    });
  }
  for (const base::ElementType type : mesh.type) {
    mesh.dim = std::max(mesh.dim, base::element_info(type).dim);
  }
  context.mesh_sound = context.mesh_sound && context.diagnostics.error_count() == errors;
}

} // namespace spricka::deck
