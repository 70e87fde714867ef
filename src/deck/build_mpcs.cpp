// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/sets.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

/// Reads the data lines of an equation: coefficient node dof, again and again.
class EquationReader {
public:
  EquationReader(DeckContext& context, const CheckedCard& card) : c_(context), card_(card) {
    equation_.rhs = card.number_value("RHS");
    equation_.span = card.span;
  }

  model::ConstraintEquation run() {
    for (const grammar::DataRow& row : card_.rows) {
      if (row.fields.size() % 3 != 0) {
        c_.error(row.span, "E115", "an equation is coefficient node dof, again and again",
                 "as in  1 12 X  -1 17 X");
        continue;
      }
      for (std::size_t i = 0; i < row.fields.size(); i += 3) {
        term(row, i);
      }
    }
    if (card_.rows.empty() && !card_.rows_bad) {
      c_.error(card_.span, "E115", "TYPE=EQUATION needs data lines: coefficient node dof");
    }
    return std::move(equation_);
  }

private:
  void term(const grammar::DataRow& row, std::size_t first) {
    const auto coefficient =
        c_.read_number(row.fields[first], grammar::QuantityKind::number, "a coefficient");
    if (coefficient == 0.0) {
      c_.error(row.fields[first].span, "E109", "a coefficient is not 0");
    }
    const auto node = node_of(row.fields[first + 1]);
    const auto dof = dof_of(row.fields[first + 2]);
    if (!coefficient || !node || !dof) {
      return;
    }
    const auto same = [&](const model::ConstraintEquation::ConstraintTerm& t) {
      return t.node == *node && t.dof == *dof;
    };
    if (std::ranges::any_of(equation_.terms, same)) {
      const base::SourceSpan pair{row.span.file, row.fields[first + 1].span.begin,
                                  row.fields[first + 2].span.end};
      c_.error(pair, "E107", "this freedom stands twice in the equation",
               "add the coefficients up");
    }
    equation_.terms.push_back({*coefficient, *node, *dof});
  }

  // 12, or NET.12 for a node of another net.
  std::optional<base::NodeId> node_of(const CardField& field) {
    if (field.is_name()) {
      return node_of_net(field);
    }
    const auto value = c_.read_number(field, grammar::QuantityKind::number, "a node number");
    if (!value) {
      return std::nullopt;
    }
    const bool whole = *value == std::floor(*value) && std::abs(*value) < 1e18;
    return find(field, card_.net_id, whole ? static_cast<base::Label>(*value) : -1);
  }

  std::optional<base::NodeId> node_of_net(const CardField& field) {
    const std::size_t dot = field.text.rfind('.');
    base::Label label = -1;
    const char* const last = field.text.data() + field.text.size();
    const auto [end, failed] = dot == std::string::npos
                                   ? std::from_chars_result{last, std::errc::invalid_argument}
                                   : std::from_chars(field.text.data() + dot + 1, last, label);
    if (failed != std::errc{} || end != last) {
      c_.error(field.span, "E108", "a node number is expected",
               "12, or NET.12 for a node of another net");
      return std::nullopt;
    }
    const std::string net = field.text.substr(0, dot);
    if (find_referenced_definition(c_, EntityKind::net, {net, field.span, {}}) == nullptr) {
      return std::nullopt;
    }
    return find(field, c_.find_net(net), label);
  }

  std::optional<base::NodeId> find(const CardField& field, base::NetId net, base::Label label) {
    if (c_.remeshed.contains(c_.model.nets[net.index()].name)) {
      c_.error(field.span, "E303", "node numbers mean other places where the net is meshed finer");
      return std::nullopt;
    }
    const LabelMap& labels = c_.node_labels[net.index()];
    const auto found = labels.find(label);
    if (!found && labels.complete) {
      const bool several = card_.net.empty() && c_.model.nets.size() > 1;
      c_.error(field.span, "E303", fmt::format("there is no node {}", c_.sources.text(field.span)),
               several && !field.is_name() ? "write NET.12 for a node of a net" : "");
    }
    return found ? std::optional(base::NodeId(*found)) : std::nullopt;
  }

  std::optional<int> dof_of(const CardField& field) {
    if (!field.is_name() || (field.text != "X" && field.text != "Y" && field.text != "Z")) {
      c_.error(field.span, "E108",
               fmt::format("expected X, Y or Z, not '{}'", c_.sources.text(field.span)));
      return std::nullopt;
    }
    if (field.text == "Z" && c_.is_certainly_plane()) {
      c_.error(field.span, "E313", "a plane model has no freedoms along Z");
    }
    return field.text.front() - 'X';
  }

  DeckContext& c_;
  const CheckedCard& card_;
  model::ConstraintEquation equation_;
};

void tie(DeckContext& c, const CheckedCard& card) {
  if (!card.rows.empty()) {
    c.error(card.rows.front().span, "E115",
            fmt::format("TYPE={} takes no data lines", card.word_value("TYPE")));
  }
  const auto slave = resolve_node_set(c, card.name_reference("SLAVE")).value_or(base::NodeSetId());
  if (card.key_has_word("TYPE", "RIGID")) {
    c.model.mpcs.emplace_back(model::RigidTie{slave, card.span});
    return;
  }
  const auto master =
      resolve_face_set(c, card.name_reference("MASTER")).value_or(base::FaceSetId());
  c.model.mpcs.emplace_back(model::TransitionTie{slave, master, card.span});
}

} // namespace

void build_mpcs(DeckContext& context) {
  context.for_each_sound_card("MPC", [&](const CheckedCard& card) {
    if (card.key_has_word("TYPE", "EQUATION")) {
      context.model.mpcs.emplace_back(EquationReader(context, card).run());
    } else {
      tie(context, card);
    }
  });
}

} // namespace spricka::deck
