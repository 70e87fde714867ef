// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/contact_sense.hpp"

#include "contact/outline.hpp"
#include "contact/segment.hpp"
#include "contact/survey.hpp"
#include "fe/dof_map.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

constexpr double most_mu = 2.0;        // of Coulomb's coefficients that are measured
constexpr double most_fit = 0.01;      // of a radius, or of half an extent: a strain
constexpr double most_gap = 0.015;     // of the same, declared wider than drawn
constexpr double corner = 0.6;         // turns of more between edges are no facets [rad]
constexpr double round_off = 1e-6;     // of an extent
constexpr double drawn_exactly = 1e-4; // of an extent: digits that people leave out
constexpr double near_share = 0.02;    // of an extent: faces that far off are next to a surface
constexpr double least_missing = 0.01; // of a surface
constexpr double most_shallow = 0.05;  // of an extent: what overlaps more is meant to

// How far straight edges leave the curve that they stand for: half a chord times half the turn
// between two of them, halved.
double facet_of(const contact::Surface& surface) {
  double most = 0.0;
  for (const contact::EdgeChain& chain : surface.plane.chains) {
    const std::span<const contact::Edge> edges = surface.plane.of(chain);
    const std::size_t n = edges.size();
    for (std::size_t e = 0; e < n && n > 1; ++e) {
      if (e + 1 == n && !chain.closed) {
        continue;
      }
      const contact::Edge& a = edges[e];
      const contact::Edge& b = edges[(e + 1) % n];
      const base::Vec2 s = contact::tangent_on(a, 1.0);
      const base::Vec2 t = contact::tangent_on(b, -1.0);
      const double turn = std::abs(std::atan2(s.x() * t.y() - s.y() * t.x(), s.dot(t)));
      most = std::max(most, turn < corner ? 0.125 * turn * std::max(a.length, b.length) : 0.0);
    }
  }
  return most;
}

double size_of(const contact::Surface& surface) {
  return surface.circle ? surface.circle->radius : 0.5 * surface.extent;
}

class Sense {
public:
  Sense(const model::Model& model, base::Diagnostics& list)
      : model_(model), mesh_(model.mesh), list_(list), bodies_(fe::find_bodies(model.mesh)),
        rim_(mesh::boundary_faces(model.mesh)), body_(model.mesh.element_count(), 0) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      for (const base::ElementId e : bodies_[b].elements) {
        body_[e.index()] = b;
      }
    }
  }

  void look() {
    for (const model::Contact& contact : model_.contacts) {
      const bool whole = contact.slave.valid() && (contact.master.valid() || contact.rigid.valid());
      const bool there = whole && !mesh_.set(contact.slave).faces.empty() &&
                         (!contact.master.valid() || !mesh_.set(contact.master).faces.empty());
      if (there) {
        look_at(contact);
      }
    }
    if (model_.mpcs.empty()) {
      look_at_overlaps();
    }
  }

private:
  void look_at(const model::Contact& contact) {
    const contact::Surface slave = contact::make_surface(model_, mesh_, contact.slave);
    if (contact.mu > most_mu) {
      list_.warning(contact.span, "W445",
                    fmt::format("contact {}: MU = {:.4g} is a coefficient that hardly any pair of "
                                "materials has",
                                contact.name, contact.mu),
                    fmt::format("MU is a number, not per cent: {:.4g} % is MU={:.4g}", contact.mu,
                                0.01 * contact.mu));
    }
    if (contact.rigid.valid()) {
      const contact::Survey seen = contact::survey(slave, model_.rigids[contact.rigid.index()]);
      look_at_gap(contact, seen, facet_of(slave), slave);
      return;
    }
    const contact::Surface master = contact::make_surface(model_, mesh_, contact.master);
    // Rays go out from the smaller surface: all of it should meet the other.
    const bool slave_smaller = slave.extent <= master.extent;
    const contact::Survey seen =
        slave_smaller ? contact::survey(slave, master) : contact::survey(master, slave);
    look_at_gap(contact, seen, facet_of(slave) + facet_of(master), slave_smaller ? slave : master);
    look_for_missing(contact, slave, contact.slave, master, contact.master);
    look_for_missing(contact, master, contact.master, slave, contact.slave);
  }

  // Of the smaller surface: how the declared fit goes with the drawing, and with the size.
  void look_at_gap(const model::Contact& contact, const contact::Survey& seen, double facets,
                   const contact::Surface& surface) {
    if (seen.facing == 0) {
      return; // E411
    }
    // Facets of both surfaces may make the drawn gap wider on one side and narrower on the other.
    const double slack = 2.0 * facets + round_off * surface.extent;
    const double drawn = std::max(std::abs(seen.gap_low), std::abs(seen.gap_high));
    const std::string& unit = model_.units.length_name;
    if (contact.gap && drawn > slack) { // drawn in contact, any fit may be declared
      const double off =
          std::max(std::abs(seen.gap_low - *contact.gap), std::abs(seen.gap_high - *contact.gap));
      if (off > slack + drawn_exactly * surface.extent + 0.05 * std::abs(*contact.gap)) {
        list_.warning(
            contact.span, "W442",
            fmt::format("contact {}: a gap of {:.4g} {} is declared, but the surfaces are "
                        "drawn {:.4g} to {:.4g} {} apart",
                        contact.name, *contact.gap, unit, seen.gap_low, seen.gap_high, unit),
            "the declared gap is taken everywhere, as if they were drawn with it; without "
            "GAP, INTERFERENCE and DIAMETRAL the drawn one is measured");
      }
    }
    look_at_clearance(contact, std::max(drawn, slack), surface);
    // A drawn overlap counts only beyond what facets make of surfaces that touch.
    const double overlap = contact.gap ? -*contact.gap : -seen.gap_low - slack;
    if (overlap > most_fit * size_of(surface)) {
      list_.warning(
          contact.span, "W444",
          fmt::format("contact {}: {} {:.4g} {}, {:.2g} % of {} of {:.4g} {}: strains of "
                      "that size are not small",
                      contact.name, contact.gap ? "an interference of" : "the surfaces overlap by",
                      overlap, unit, 100.0 * overlap / size_of(surface),
                      surface.circle ? "a radius" : "half an extent", size_of(surface), unit),
          "a fit is declared in units of length; look at the unit and at the drawing");
    }
  }

  // A declared gap counts along the normals of surfaces that are drawn closer: far from them they
  // would meet elsewhere, and in other directions.
  void look_at_clearance(const model::Contact& contact, double drawn,
                         const contact::Surface& surface) {
    const double gap = contact.gap.value_or(0.0);
    const double size = size_of(surface);
    const std::string& unit = model_.units.length_name;
    if (gap > most_gap * size && gap > 2.0 * drawn) {
      list_.warning(contact.span, "W444",
                    fmt::format("contact {}: a gap of {:.4g} {} is declared, {:.2g} % of {} of "
                                "{:.4g} {}, between surfaces that are drawn {}",
                                contact.name, gap, unit, 100.0 * gap / size,
                                surface.circle ? "a radius" : "half an extent", size, unit,
                                drawn > round_off * surface.extent * 10.0
                                    ? fmt::format("{:.3g} {} apart", drawn, unit)
                                    : std::string("touching")),
                    "INTERFERENCE and DIAMETRAL are positive where the parts overlap; a wide gap "
                    "is drawn, and measured where GAP is left out");
    } else if (contact.type == model::ContactType::bonded && gap > round_off * surface.extent &&
               gap > 2.0 * drawn) {
      list_.warning(contact.span, "W444",
                    fmt::format("contact {}: BONDED with a gap of {:.4g} {} draws the surfaces "
                                "together by it",
                                contact.name, gap, unit),
                    "GAP=0 bonds them as they are");
    }
  }

  // Faces of other bodies that lie next to a part of a surface that sees nothing of its partner.
  void look_for_missing(const model::Contact& contact, const contact::Surface& surface,
                        base::FaceSetId own, const contact::Surface& partner,
                        base::FaceSetId other) {
    std::vector<model::Face> rest;
    const std::vector<bool> mine = bodies_of(own);
    const std::vector<bool> theirs = bodies_of(other);
    for (const model::Face& face : rim_) {
      const std::size_t b = body_[face.element.index()];
      if (theirs[b] && !mine[b] && !in_a_contact(face)) {
        rest.push_back(face);
      }
    }
    if (rest.empty()) {
      return;
    }
    const contact::Surface left = contact::make_surface(model_, mesh_, rest);
    const std::vector<contact::Edge>& edges = surface.plane.edges;
    std::vector<double> seen(edges.size(), 0.0);
    std::vector<double> missed(edges.size(), 0.0);
    double low = 0.0;
    double high = 0.0;
    for (const contact::Segment& s : contact::find_segments(surface, partner)) {
      // Coordinates of an edge run from -1 to 1: half the stretch is its part of the edge.
      seen[s.contact_edge] += 0.5 * (s.to - s.from);
      const double gap = gap_at(surface, edges[s.contact_edge], partner, s);
      low = std::min(low, gap);
      high = std::max(high, gap);
    }
    for (const contact::Segment& s : contact::find_segments(surface, left)) {
      const double gap = gap_at(surface, edges[s.contact_edge], left, s);
      const double near = near_share * std::min(surface.extent, left.extent);
      if (gap > low - near && gap < high + near) {
        missed[s.contact_edge] += 0.5 * (s.to - s.from);
      }
    }
    double length = 0.0;
    double sum = 0.0;
    base::Vec2 place = base::Vec2::Zero();
    for (std::size_t e = 0; e < edges.size(); ++e) {
      // What also faces the partner is not missed.
      const double part = std::clamp(missed[e], 0.0, std::max(0.0, 1.0 - seen[e]));
      length += edges[e].length;
      place = sum == 0.0 && part > 0.1 ? contact::point_on(edges[e], 0.0) : place;
      sum += part > 0.1 ? part * edges[e].length : 0.0;
    }
    const bool whole = std::ranges::all_of(seen, [](double part) { return part == 0.0; });
    if (sum > least_missing * length && !whole) { // nothing at all: E411
      list_.warning(
          contact.span, "W443",
          fmt::format("contact {}: {:.0f} % of {} see nothing of {}, though its body lies "
                      "next to it there, from ({:.4g}, {:.4g}) on",
                      contact.name, 100.0 * sum / length, mesh_.set(own).name,
                      mesh_.set(other).name, place.x(), place.y()),
          "faces are missing in the set: there the bodies do not hold each other off");
    }
  }

  static double gap_at(const contact::Surface& surface, const contact::Edge& edge,
                       const contact::Surface& target, const contact::Segment& s) {
    const double xi = 0.5 * (s.from + s.to);
    const base::Vec2 x = contact::point_on(edge, xi);
    const base::Vec2 n = contact::surface_normal(surface, edge, xi);
    const contact::Edge& other = target.plane.edges[s.target_edge];
    const std::optional<double> eta = contact::hit_on(other, x, n);
    return eta ? (contact::point_on(other, *eta) - x).dot(n) : 0.0;
  }

  [[nodiscard]] std::vector<bool> bodies_of(base::FaceSetId set) const {
    std::vector<bool> in(bodies_.size(), false);
    for (const model::Face& face : mesh_.set(set).faces) {
      in[body_[face.element.index()]] = true;
    }
    return in;
  }

  [[nodiscard]] bool in_a_contact(const model::Face& face) const {
    const auto holds = [&](base::FaceSetId set) {
      return set.valid() &&
             std::ranges::find(mesh_.set(set).faces, face) != mesh_.set(set).faces.end();
    };
    return std::ranges::any_of(model_.contacts, [&](const model::Contact& c) {
      return holds(c.slave) || holds(c.master);
    });
  }

  [[nodiscard]] bool contact_between(std::size_t a, std::size_t b) const {
    return std::ranges::any_of(model_.contacts, [&](const model::Contact& c) {
      if (!c.slave.valid() || !c.master.valid()) {
        return false;
      }
      const std::vector<bool> one = bodies_of(c.slave);
      const std::vector<bool> two = bodies_of(c.master);
      return (one[a] && two[b]) || (one[b] && two[a]);
    });
  }

  // Boundary nodes of one body that lie inside another, not deep: pin and bore drawn with a press
  // fit, but without its card.
  void look_at_overlaps() {
    std::vector<std::vector<model::Face>> faces(bodies_.size());
    for (const model::Face& face : rim_) {
      faces[body_[face.element.index()]].push_back(face);
    }
    std::vector<contact::Outline> outlines;
    std::vector<double> extent;
    for (const std::vector<model::Face>& own : faces) {
      const contact::Surface surface = contact::make_surface(model_, mesh_, own);
      outlines.emplace_back(surface, base::Vector());
      extent.push_back(surface.extent);
    }
    for (std::size_t a = 0; a < bodies_.size(); ++a) {
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        // Each pair once: the smaller body first, of two alike the first.
        if (a != b && extent[a] <= extent[b] && !(a > b && extent[a] == extent[b])) {
          look_at_overlap(a, b, faces, outlines, std::min(extent[a], extent[b]));
        }
      }
    }
  }

  void look_at_overlap(std::size_t a, std::size_t b,
                       const std::vector<std::vector<model::Face>>& faces,
                       const std::vector<contact::Outline>& outlines, double extent) {
    const contact::Outline& one = outlines[a];
    const contact::Outline& two = outlines[b];
    if ((one.high() - two.low()).minCoeff() < 0.0 || (two.high() - one.low()).minCoeff() < 0.0) {
      return;
    }
    double depth = 0.0;
    base::Vec2 place = base::Vec2::Zero();
    // Nodes of both: a corner of one may stand in the middle of a side of the other.
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      for (const base::NodeId n : mesh::nodes_of_faces(mesh_, faces[from])) {
        const base::Vec2 x = mesh_.x[n.index()].head<2>();
        const std::optional<contact::OutlinePlace> at = outlines[to].nearest(x, extent);
        if (at && -at->distance - 2.0 * at->facet > depth) {
          // Facets of both bodies may cut into each other.
          depth = -at->distance - 2.0 * at->facet;
          place = x;
        }
      }
    }
    if (depth > drawn_exactly * extent && depth < most_shallow * extent && !contact_between(a, b)) {
      list_.warning(
          {}, "W446",
          fmt::format("bodies {} and {} overlap as drawn by {:.4g} {} at ({:.4g}, {:.4g}), "
                      "and no $CONTACT stands between them",
                      name(a), name(b), depth, model_.units.length_name, place.x(), place.y()),
          "they pass through each other; a $CONTACT presses them apart");
    }
  }

  [[nodiscard]] std::string name(std::size_t body) const {
    const base::NetId net = bodies_[body].net;
    return net.valid() && !model_.nets[net.index()].name.empty() ? model_.nets[net.index()].name
                                                                 : "(deck)";
  }

  const model::Model& model_;
  const model::Mesh& mesh_;
  base::Diagnostics& list_;
  std::vector<fe::Body> bodies_;
  std::vector<model::Face> rim_;
  std::vector<std::size_t> body_; ///< [element]
};

} // namespace

void warn_of_contacts(const model::Model& model, base::Diagnostics& list) {
  if (model.mesh.dim == 2 && !list.has_errors()) {
    Sense(model, list).look();
  }
}

} // namespace spricka::sense
