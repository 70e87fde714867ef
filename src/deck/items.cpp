// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/items.hpp"

#include "deck/sets.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::Field;

/// Lists the nodes or elements that the data lines of a card name.
class ItemReader {
public:
  ItemReader(Context& context, const BoundCard& card, Kind kind)
      : c_(context), card_(card), kind_(kind),
        labels_((kind == Kind::node_set ? context.node_labels
                                        : context.element_labels)[card.net_id.index()]) {}

  bool read(Collection& collection) {
    for (const grammar::Row& row : card_.rows) {
      for (const Field& field : row.fields) {
        if (field.separator == '=') {
          c_.error(field.span, "E115", "no '=' in a list of items",
                   std::string(card_.spec->data_form));
          ok_ = false;
        }
        item(field, collection);
      }
    }
    return ok_;
  }

private:
  void item(const Field& field, Collection& collection) {
    switch (field.kind) {
    case Field::Kind::number:
    case Field::Kind::expression:
      number(field, collection);
      break;
    case Field::Kind::range:
      range(field, collection);
      break;
    case Field::Kind::name:
    case Field::Kind::minus_name:
      members(field, collection);
      break;
    default:
      c_.error(field.span, "E115", "a number, a range or the name of a set is expected",
               std::string(card_.spec->data_form));
      ok_ = false;
    }
  }

  [[nodiscard]] std::string_view thing() const {
    return kind_ == Kind::node_set ? "node" : "element";
  }

  void number(const Field& field, Collection& collection) {
    const auto value = number_of(field, grammar::Quantity::number,
                                 fmt::format("a {} number", thing()), c_.scope, c_.diagnostics);
    if (!value) {
      ok_ = false;
      return;
    }
    const auto label = static_cast<base::Label>(*value);
    const auto found = static_cast<double>(label) == *value ? labels_.find(label) : std::nullopt;
    if (found) {
      collection.add(*found);
    } else {
      missing(field, fmt::format("there is no {} {}", thing(), *value));
    }
  }

  // Numbers in a range may be missing, as long as there is one.
  void range(const Field& field, Collection& collection) {
    const base::Label last = std::min(field.range[1], labels_.highest());
    bool any = false;
    for (base::Label label = field.range[0]; label <= last; label += field.range[2]) {
      if (const auto found = labels_.find(label)) {
        collection.add(*found);
        any = true;
      }
    }
    if (!any) {
      missing(field, fmt::format("there is no {} in this range", thing()));
    }
  }

  void missing(const Field& field, std::string text) {
    ok_ = false;
    if (labels_.complete) {
      c_.error(field.span, "E303",
               card_.net.empty() ? std::move(text) : text + " in net " + card_.net,
               card_.net.empty() && c_.model.nets.size() > 1
                   ? "numbers of a net are used between $NET and $ENDNET"
                   : "");
    }
  }

  void members(const Field& field, Collection& collection) {
    const Reference reference{field.text, field.span, card_.net};
    const bool minus = field.kind == Field::Kind::minus_name;
    const auto put = [&](std::size_t i) { minus ? collection.remove(i) : collection.add(i); };
    if (kind_ == Kind::node_set) {
      if (const auto id = use_node_set(c_, reference)) {
        for (const base::NodeId n : c_.model.mesh.set(*id).nodes) {
          put(n.index());
        }
        return;
      }
    } else if (const auto id = use_element_set(c_, reference)) {
      for (const base::ElementId e : c_.model.mesh.set(*id).elements) {
        put(e.index());
      }
      return;
    }
    ok_ = false;
  }

  Context& c_;
  const BoundCard& card_;
  Kind kind_;
  const Labels& labels_;
  bool ok_ = true;
};

} // namespace

bool read_items(Context& context, const BoundCard& card, Kind kind, Collection& collection) {
  return ItemReader(context, card, kind).read(collection);
}

std::optional<std::vector<base::NodeId>> node_items(Context& context, const BoundCard& card) {
  Collection collection(context.model.mesh.node_count());
  if (!read_items(context, card, Kind::node_set, collection)) {
    return std::nullopt;
  }
  const std::vector<std::size_t> indices = collection.take();
  return std::vector<base::NodeId>(indices.begin(), indices.end());
}

} // namespace spricka::deck
