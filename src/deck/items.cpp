// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/items.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;

/// Lists the nodes or elements that the data lines of a card name.
class ItemReader {
public:
  ItemReader(DeckContext& context, const CheckedCard& card, EntityKind kind, const SetFinder& sets)
      : c_(context), card_(card), kind_(kind), sets_(sets),
        labels_((kind == EntityKind::node_set ? context.node_labels
                                              : context.element_labels)[card.net_id.index()]) {}

  bool read(OrderedIndexSet& collection) {
    for (const grammar::DataRow& row : card_.rows) {
      const auto equal =
          std::ranges::find_if(row.fields, [](const CardField& f) { return f.separator == '='; });
      if (equal != row.fields.end()) {
        c_.error(equal->span, "E115", "no '=' in a list of items",
                 std::string(card_.spec->data_form));
        ok_ = false;
        continue;
      }
      for (const CardField& field : row.fields) {
        item(field, collection);
      }
    }
    return ok_;
  }

private:
  void item(const CardField& field, OrderedIndexSet& collection) {
    if (!field.is_name() && field.kind != CardField::CardFieldKind::minus_name &&
        c_.remeshed.contains(card_.net)) {
      c_.error(field.span, "E303",
               fmt::format("{} numbers mean other places where the net is meshed finer", thing()),
               "name a set, or choose by WHERE");
      ok_ = false;
      return;
    }
    switch (field.kind) {
    case CardField::CardFieldKind::number:
    case CardField::CardFieldKind::expression:
      number(field, collection);
      break;
    case CardField::CardFieldKind::range:
      range(field, collection);
      break;
    case CardField::CardFieldKind::name:
    case CardField::CardFieldKind::minus_name:
      members(field, collection);
      break;
    default:
      c_.error(field.span, "E115", "a number, a range or the name of a set is expected",
               std::string(card_.spec->data_form));
      ok_ = false;
    }
  }

  [[nodiscard]] std::string_view thing() const {
    return kind_ == EntityKind::node_set ? "node" : "element";
  }

  void number(const CardField& field, OrderedIndexSet& collection) {
    const auto value =
        c_.read_number(field, grammar::QuantityKind::number, fmt::format("a {} number", thing()));
    if (!value) {
      ok_ = false;
      return;
    }
    const bool whole = *value == std::floor(*value) && std::abs(*value) < 1e18;
    const auto found = whole ? labels_.find(static_cast<base::Label>(*value)) : std::nullopt;
    if (found) {
      collection.add(*found);
    } else {
      missing(field, fmt::format("there is no {} {}", thing(), *value));
    }
  }

  // Numbers in a range may be missing, as long as there is one.
  void range(const CardField& field, OrderedIndexSet& collection) {
    const base::Label first = field.range[0];
    if (first < 1) {
      c_.error(field.span, "E103", fmt::format("a {} number is 1 or more", thing()));
      ok_ = false;
      return;
    }
    const base::Label last = std::min(field.range[1], labels_.highest());
    std::vector<std::size_t> found;
    if (last >= first) {
      const auto steps = static_cast<std::size_t>((last - first) / field.range[2]);
      found = steps > all_labels().size() ? sift(first, last, field.range[2])
                                          : walk(first, last, field.range[2]);
    }
    std::ranges::for_each(found, [&](std::size_t i) { collection.add(i); });
    if (found.empty()) {
      missing(field, fmt::format("there is no {} in this range", thing()));
    }
  }

  [[nodiscard]] const std::vector<base::Label>& all_labels() const {
    const model::Mesh& mesh = c_.model.mesh;
    return kind_ == EntityKind::node_set ? mesh.node_label : mesh.element_label;
  }

  // Asks for every number of the range.
  [[nodiscard]] std::vector<std::size_t> walk(base::Label first, base::Label last,
                                              base::Label step) const {
    std::vector<std::size_t> found;
    for (base::Label label = first;; label += step) {
      if (const auto index = labels_.find(label)) {
        found.push_back(*index);
      }
      if (label > last - step) {
        return found;
      }
    }
  }

  // Looks through the numbers there are: the way for `1 : 1000000000000`.
  [[nodiscard]] std::vector<std::size_t> sift(base::Label first, base::Label last,
                                              base::Label step) const {
    const std::vector<base::Label>& labels = all_labels();
    const model::Mesh& mesh = c_.model.mesh;
    const auto& net = kind_ == EntityKind::node_set ? mesh.node_net : mesh.element_net;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const bool inside = labels[i] >= first && labels[i] <= last && net[i] == card_.net_id;
      if (inside && (labels[i] - first) % step == 0) {
        found.push_back(i);
      }
    }
    std::ranges::sort(found, [&](std::size_t a, std::size_t b) { return labels[a] < labels[b]; });
    return found;
  }

  void missing(const CardField& field, std::string text) {
    ok_ = false;
    if (labels_.complete) {
      c_.error(field.span, "E303",
               card_.net.empty() ? std::move(text) : text + " in net " + card_.net,
               card_.net.empty() && c_.model.nets.size() > 1
                   ? "numbers of a net are used between $NET and $ENDNET"
                   : "");
    }
  }

  void members(const CardField& field, OrderedIndexSet& collection) {
    const NameReference reference{field.text, field.span, card_.net};
    const bool minus = field.kind == CardField::CardFieldKind::minus_name;
    const auto put = [&](std::size_t i) { minus ? collection.remove(i) : collection.add(i); };
    if (kind_ == EntityKind::node_set) {
      if (const auto id = sets_.nodes(reference)) {
        for (const base::NodeId n : c_.model.mesh.set_with_id(*id).nodes) {
          put(n.index());
        }
        return;
      }
    } else if (const auto id = sets_.elements(reference)) {
      for (const base::ElementId e : c_.model.mesh.set_with_id(*id).elements) {
        put(e.index());
      }
      return;
    }
    ok_ = false;
  }

  DeckContext& c_;
  const CheckedCard& card_;
  EntityKind kind_;
  const SetFinder& sets_;
  const LabelMap& labels_;
  bool ok_ = true;
};

} // namespace

bool read_listed_members(DeckContext& context, const CheckedCard& card, EntityKind kind,
                         const SetFinder& sets, OrderedIndexSet& collection) {
  return ItemReader(context, card, kind, sets).read(collection);
}

} // namespace spricka::deck
