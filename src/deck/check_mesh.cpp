// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/tidy.hpp"
#include "deck/context.hpp"
#include "deck/dimension_rules.hpp"
#include "deck/element_place.hpp"
#include "grammar/bulk_table.hpp"
#include "mesh/quality.hpp"
#include "model/model.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace spricka::deck {

const ElementOrigin& element_origin(const DeckContext& c, std::size_t element) {
  const auto after =
      std::upper_bound(c.origins.begin(), c.origins.end(), element,
                       [](std::size_t e, const ElementOrigin& origin) { return e < origin.first; });
  // cards that made no element start where the next one does; the last of them made this one
  return *(after - 1);
}

base::SourceSpan element_source_span(const DeckContext& c, std::size_t element) {
  const ElementOrigin& origin = element_origin(c, element);
  return origin.data.valid()
             ? grammar::table_label_span(c.sources, origin.data, element - origin.first)
             : origin.card;
}

namespace {

// One message for each card, with the count: a mesh may hold thousands.
void report_elements(DeckContext& c, const std::vector<std::size_t>& elements,
                     std::string_view code, std::string_view what, std::string_view hint) {
  for (std::size_t i = 0; i < elements.size();) {
    const ElementOrigin& origin = element_origin(c, elements[i]);
    std::size_t j = i;
    while (j < elements.size() && elements[j] < origin.first + origin.count) {
      ++j;
    }
    const std::string more = j - i > 1 ? fmt::format(" and {} more", j - i - 1) : "";
    c.error(element_source_span(c, elements[i]), std::string(code),
            fmt::format("element {}{} {}", c.model.mesh.element_label[elements[i]], more, what),
            std::string(hint));
    i = std::max(j, i + 1);
  }
}

std::string place(const model::Mesh& mesh, const base::Vec3& x) {
  return base::format_coordinates(x, mesh.dim);
}

// Elements that run the wrong way round by card, those that fold somewhere one by one.
void report_bad(DeckContext& c, const std::vector<mesh::InvalidElement>& bad) {
  const model::Mesh& mesh = c.model.mesh;
  std::vector<std::size_t> turned;
  for (const mesh::InvalidElement& b : bad) {
    if (b.turned) {
      turned.push_back(b.element.index());
      continue;
    }
    report_elements(
        c, {b.element.index()}, "E307",
        fmt::format("folds over: its Jacobian is {:.3g} at {}", b.jacobian, place(mesh, b.at)),
        "a corner lies too far inside, or a mid node too far off the middle");
  }
  report_elements(c, turned, "E307", "turned inside out: its Jacobian is negative everywhere",
                  std::string(dimension_rules.at(mesh.dim).corner_order));
}

// One message for each card, about its worst corner.
void tell_corners(DeckContext& c, const std::vector<mesh::FoldedCorner>& corners) {
  const model::Mesh& mesh = c.model.mesh;
  for (std::size_t i = 0; i < corners.size();) {
    const ElementOrigin& origin = element_origin(c, corners[i].element.index());
    std::size_t j = i;
    mesh::FoldedCorner worst = corners[i];
    for (; j < corners.size() && corners[j].element.index() < origin.first + origin.count; ++j) {
      worst = corners[j].part < worst.part ? corners[j] : worst;
    }
    c.warning(
        element_source_span(c, worst.element.index()), "W307",
        fmt::format("element {} folds over in its corner at node {}{}: its Jacobian there is "
                    "{:.2g} % of the mean, though positive at all integration points; stresses at "
                    "that node are those of the element's middle",
                    mesh.element_label[worst.element.index()], mesh.node_label[worst.node.index()],
                    j - i > 1 ? fmt::format(" (and {} more less so)", j - i - 1) : "",
                    100.0 * worst.part),
        "move the node away from the element's middle");
    i = std::max(j, i + 1);
  }
}

void one_space(DeckContext& c) {
  const model::Mesh& mesh = c.model.mesh;
  std::vector<std::size_t> plane;
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (base::element_info(mesh.type[e]).dim < mesh.dim) {
      plane.push_back(e);
    }
  }
  report_elements(c, plane, "E313", "of the plane in a model with elements in space", "");
  const auto it = std::ranges::find_if(
      mesh.x, [&](const base::Vec3& x) { return !x.tail(3 - mesh.dim).isZero(0.0); });
  if (it != mesh.x.end() && mesh.element_count() > 0) {
    const auto node = static_cast<std::size_t>(it - mesh.x.begin());
    c.error(element_origin(c, 0).card, "E313",
            fmt::format("elements of the plane, but node {} has z = {}", mesh.node_label[node],
                        it->z()));
  }
}

} // namespace

void check_elements(DeckContext& context) {
  if (!context.mesh_sound) {
    return;
  }
  const model::Mesh& mesh = context.model.mesh;
  if (mesh.element_count() == 0) {
    if (context.model.unavailable.empty() && !context.cards.empty()) {
      context.error(context.cards.front().span, "E318", "the deck has no elements");
    }
    return;
  }
  one_space(context);
  const mesh::MeshFaults faults = mesh::find_mesh_faults(mesh);
  report_bad(context, faults.bad);
  tell_corners(context, faults.corners);
  if (context.property_sound) {
    std::vector<std::size_t> open;
    for (std::size_t e = 0; e < mesh.element_count(); ++e) {
      if (!mesh.property[e].valid()) {
        open.push_back(e);
      }
    }
    report_elements(context, open, "E305", "without a $PROPERTY",
                    "$PROPERTY ESET=.. MATERIAL=.. STATE=..");
  }
}

} // namespace spricka::deck
