// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/contact_sense.hpp"

#include "base/by_dimension.hpp"
#include "base/tidy.hpp"
#include "contact/surface_boundary.hpp"
#include "contact/survey.hpp"
#include "fe/dof_map.hpp"
#include "mesh/boundary.hpp"
#include "model/model.hpp"
#include "sense/surface_measures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

constexpr double most_mu = 2.0;        // of Coulomb's coefficients that are measured
constexpr double most_fit = 0.01;      // of a radius, or of half an extent: a strain
constexpr double most_gap = 0.015;     // of the same, declared wider than drawn
constexpr double round_off = 1e-6;     // of an extent
constexpr double drawn_exactly = 1e-4; // of an extent: digits that people leave out
constexpr double near_share = 0.02;    // of an extent: faces that far off are next to a surface
constexpr double least_missing = 0.01; // of a surface
constexpr double most_shallow = 0.05;  // of an extent: what overlaps more is meant to

class Sense {
public:
  Sense(const model::Model& model, std::vector<fe::Body> bodies, base::Diagnostics& list)
      : model_(model), mesh_(model.mesh), list_(list), bodies_(std::move(bodies)),
        rim_(mesh::boundary_faces(model.mesh)), body_(model.mesh.element_count(), 0) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      for (const base::ElementId e : bodies_[b].elements) {
        body_[e.index()] = b;
      }
    }
    for (const model::Contact& contact : model.contacts) {
      for (const base::FaceSetId set : {contact.slave, contact.master}) {
        if (set.valid()) {
          const std::vector<model::Face>& faces = mesh_.set_with_id(set).faces;
          in_contact_.insert(in_contact_.end(), faces.begin(), faces.end());
        }
      }
    }
    std::ranges::sort(in_contact_);
  }

  void look() {
    for (const model::Contact& contact : model_.contacts) {
      const bool whole = contact.slave.valid() && (contact.master.valid() || contact.rigid.valid());
      const bool there =
          whole && !mesh_.set_with_id(contact.slave).faces.empty() &&
          (!contact.master.valid() || !mesh_.set_with_id(contact.master).faces.empty());
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
    const contact::ContactSurface slave =
        contact::make_contact_surface(model_, mesh_, contact.slave);
    if (contact.mu > most_mu) {
      list_.warning(contact.span, "W445",
                    fmt::format("contact {}: MU = {:.4g} is a coefficient that hardly any pair of "
                                "materials has",
                                contact.name, contact.mu),
                    fmt::format("MU is a number, not per cent: {:.4g} % is MU={:.4g}", contact.mu,
                                0.01 * contact.mu));
    }
    if (contact.rigid.valid()) {
      const contact::GapSurvey seen =
          contact::survey_gaps(slave, model_.rigids[contact.rigid.index()]);
      look_at_gap(contact, seen, faceting_error(slave), slave);
      return;
    }
    const contact::ContactSurface master =
        contact::make_contact_surface(model_, mesh_, contact.master);
    // Rays go out from the smaller surface: all of it should meet the other.
    const bool slave_smaller = slave.extent <= master.extent;
    const contact::GapSurvey seen =
        slave_smaller ? contact::survey_gaps(slave, master) : contact::survey_gaps(master, slave);
    look_at_gap(contact, seen, faceting_error(slave) + faceting_error(master),
                slave_smaller ? slave : master);
    look_for_missing(contact, {slave, contact.slave, slave_smaller ? &seen : nullptr},
                     {master, contact.master});
    look_for_missing(contact, {master, contact.master, slave_smaller ? nullptr : &seen},
                     {slave, contact.slave});
  }

  // Of the smaller surface: how the declared fit goes with the drawing, and with the size.
  void look_at_gap(const model::Contact& contact, const contact::GapSurvey& seen, double facets,
                   const contact::ContactSurface& surface) {
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
    if (overlap > most_fit * surface_radius_or_half_extent(surface)) {
      list_.warning(
          contact.span, "W444",
          fmt::format("contact {}: {} {:.4g} {}, {:.2g} % of {} of {:.4g} {}: strains of "
                      "that size are not small",
                      contact.name, contact.gap ? "an interference of" : "the surfaces overlap by",
                      overlap, unit, 100.0 * overlap / surface_radius_or_half_extent(surface),
                      round_surface_radius(surface) ? "a radius" : "half an extent",
                      surface_radius_or_half_extent(surface), unit),
          "a fit is declared in units of length; look at the unit and at the drawing");
    }
  }

  // A declared gap counts along the normals of surfaces that are drawn closer: far from them they
  // would meet elsewhere, and in other directions.
  void look_at_clearance(const model::Contact& contact, double drawn,
                         const contact::ContactSurface& surface) {
    const double gap = contact.gap.value_or(0.0);
    const double size = surface_radius_or_half_extent(surface);
    const std::string& unit = model_.units.length_name;
    if (gap > most_gap * size && gap > 2.0 * drawn) {
      list_.warning(contact.span, "W444",
                    fmt::format("contact {}: a gap of {:.4g} {} is declared, {:.2g} % of {} of "
                                "{:.4g} {}, between surfaces that are drawn {}",
                                contact.name, gap, unit, 100.0 * gap / size,
                                round_surface_radius(surface) ? "a radius" : "half an extent", size,
                                unit,
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

  // A surface of a contact, and what it sees of the other where that is known.
  struct ContactSide {
    const contact::ContactSurface& surface;
    base::FaceSetId set;
    const contact::GapSurvey* seen = nullptr;
  };

  // Faces of other bodies that lie next to a part of a surface that sees nothing of its partner.
  void look_for_missing(const model::Contact& contact, const ContactSide& own,
                        const ContactSide& other) {
    const contact::ContactSurface& surface = own.surface;
    std::vector<model::Face> rest;
    const std::vector<bool> mine = bodies_of(own.set);
    const std::vector<bool> theirs = bodies_of(other.set);
    for (const model::Face& face : rim_) {
      const std::size_t b = body_[face.element.index()];
      if (theirs[b] && !mine[b] && !in_a_contact(face)) {
        rest.push_back(face);
      }
    }
    if (rest.empty()) {
      return;
    }
    const std::vector<double> measure = facet_lengths_or_areas(surface);
    std::vector<double> seen(measure.size(), 0.0);
    double low = 0.0;
    double high = 0.0;
    for (const contact::FacingFacetPart& part :
         own.seen != nullptr ? own.seen->parts
                             : contact::survey_gaps(surface, other.surface).parts) {
      seen[part.facet] += part.measure / measure[part.facet];
      low = std::min(low, part.gap);
      high = std::max(high, part.gap);
    }
    double length = 0.0;
    double unseen = 0.0;
    for (std::size_t e = 0; e < measure.size(); ++e) {
      length += measure[e];
      unseen += measure[e] * std::max(0.0, 1.0 - seen[e]);
    }
    if (unseen <= least_missing * length) {
      return; // whatever lies there
    }
    const contact::ContactSurface left = contact::make_contact_surface(model_, mesh_, rest);
    std::vector<double> missed(measure.size(), 0.0);
    const double near = near_share * std::min(surface.extent, left.extent);
    for (const contact::FacingFacetPart& part : contact::survey_gaps(surface, left).parts) {
      if (part.gap > low - near && part.gap < high + near) {
        missed[part.facet] += part.measure / measure[part.facet];
      }
    }
    double sum = 0.0;
    base::Vec3 place = base::Vec3::Zero();
    for (std::size_t e = 0; e < measure.size(); ++e) {
      // What also faces the partner is not missed.
      const double part = std::clamp(missed[e], 0.0, std::max(0.0, 1.0 - seen[e]));
      place = sum == 0.0 && part > 0.1 ? facet_midpoint(surface, e) : place;
      sum += part > 0.1 ? part * measure[e] : 0.0;
    }
    const bool whole = std::ranges::all_of(seen, [](double part) { return part == 0.0; });
    if (sum > least_missing * length && !whole) { // nothing at all: E411
      list_.warning(
          contact.span, "W443",
          fmt::format("contact {}: {:.0f} % of {} see nothing of {}, though its body lies "
                      "next to it there, from {} on",
                      contact.name, 100.0 * sum / length, mesh_.set_with_id(own.set).name,
                      mesh_.set_with_id(other.set).name,
                      base::format_coordinates(place, mesh_.dim)),
          "faces are missing in the set: there the bodies do not hold each other off");
    }
  }

  [[nodiscard]] std::vector<bool> bodies_of(base::FaceSetId set) const {
    std::vector<bool> in(bodies_.size(), false);
    for (const model::Face& face : mesh_.set_with_id(set).faces) {
      in[body_[face.element.index()]] = true;
    }
    return in;
  }

  [[nodiscard]] bool in_a_contact(const model::Face& face) const {
    return std::ranges::binary_search(in_contact_, face);
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
    std::vector<geometry::BodyBoundary> outlines;
    outlines.reserve(faces.size());
    for (const std::vector<model::Face>& own : faces) {
      outlines.push_back(contact::make_displaced_body_boundary(model_, mesh_, own, base::Vector()));
    }
    for (std::size_t a = 0; a < bodies_.size(); ++a) {
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        // Each pair once: the smaller body first, of two alike the first.
        const double one = outlines[a].box().diagonal();
        const double two = outlines[b].box().diagonal();
        if (a != b && one <= two && !(a > b && one == two) &&
            outlines[a].box().meets(outlines[b].box()) && !contact_between(a, b)) {
          look_at_overlap(a, b, faces, outlines);
        }
      }
    }
  }

  void look_at_overlap(std::size_t a, std::size_t b,
                       const std::vector<std::vector<model::Face>>& faces,
                       const std::vector<geometry::BodyBoundary>& outlines) {
    const double extent = std::min(outlines[a].box().diagonal(), outlines[b].box().diagonal());
    // In space places farther in than what is told are left alone: between them and the surface
    // there are others that are deep enough to say that the overlap is meant.
    constexpr base::ByDimension reaches{1.0, 2.0 * most_shallow};
    const double reach = reaches.at(mesh_.dim) * extent;
    double depth = 0.0;
    base::Vec3 place = base::Vec3::Zero();
    // Nodes of both: a corner of one may stand in the middle of a side of the other.
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      for (const base::NodeId n : mesh::nodes_of_faces(mesh_, faces[from])) {
        const base::Vec3& x = mesh_.x[n.index()];
        const std::optional<geometry::BoundaryDistance> at = outlines[to].signed_distance(x, reach);
        if (at && -at->distance - 2.0 * at->facet > depth) {
          // Facets of both bodies may cut into each other.
          depth = -at->distance - 2.0 * at->facet;
          place = x;
        }
      }
    }
    if (depth > drawn_exactly * extent && depth < most_shallow * extent) {
      list_.warning({}, "W446",
                    fmt::format("bodies {} and {} overlap as drawn by {:.4g} {} at {}, "
                                "and no $CONTACT stands between them",
                                name(a), name(b), depth, model_.units.length_name,
                                base::format_coordinates(place, mesh_.dim)),
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
  std::vector<std::size_t> body_;       ///< [element]
  std::vector<model::Face> in_contact_; ///< of all contacts, sorted
};

} // namespace

void warn_of_implausible_contacts(const model::Model& model, base::Diagnostics& list) {
  if (list.has_errors()) {
    return;
  }
  std::vector<fe::Body> bodies = fe::find_bodies(model.mesh);
  if (!model.contacts.empty() || bodies.size() > 1) {
    Sense(model, std::move(bodies), list).look();
  }
}

} // namespace spricka::sense
