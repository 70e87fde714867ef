// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/recover/closed_parts.hpp"
#include "geometry/polyline.hpp"
#include "model/model.hpp"
#include "program/checks/check_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr double full_circle = 6.2832; // [rad] as ANGLE of $CRACK

// Faces of a crack that touch nowhere are no pair: they have no pressure and no closed part.
results::ContactResult open_faces(const model::Model& model, const std::string& contact) {
  for (const model::CrackDefinition& crack : model.cracks) {
    if (contact == crack.name + ".FACES" && crack.faces_in_contact) {
      results::ContactResult open;
      open.name = contact;
      open.sheared = open.rubs = crack.mu > 0.0;
      return open;
    }
  }
  throw MissingQuantity(fmt::format("no contact {}", contact));
}

results::ContactResult contact_of(const model::Model& model, const results::LoadStepResult& step,
                                  const std::string& contact) {
  const results::ContactResult* found = results::find_contact(step, contact);
  return found != nullptr ? *found : open_faces(model, contact);
}

// The value at a point that a word is about.
using PointValue = double results::ContactPoint::*;

double extreme(const results::ContactResult& contact, PointValue value, bool largest) {
  if (contact.points.empty()) {
    return 0.0; // open_faces
  }
  double found = contact.points.front().*value;
  for (const results::ContactPoint& p : contact.points) {
    found = largest ? std::max(found, p.*value) : std::min(found, p.*value);
  }
  return found;
}

// Between the two points next to theta, or at a distance along a straight surface; crack faces are
// met from their own side.
double value_at(const results::ContactResult& contact, PointValue value, double place) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const bool round = contact.round;
  const results::ContactPoint* below = nullptr;
  const results::ContactPoint* above = nullptr;
  double down = std::numeric_limits<double>::infinity();
  double up = down;
  for (const results::ContactPoint& p : contact.points) {
    const double d = round ? std::remainder(p.theta - place, turn) : p.arc - place;
    if (d <= 0.0 && -d < down) {
      down = -d;
      below = &p;
    }
    if (d >= 0.0 && d < up) {
      up = d;
      above = &p;
    }
  }
  // On a circle two points may be found for any angle: more than a radian apart they are the ends
  // of a gap.
  if (below == nullptr || above == nullptr || (round && up + down > 1.0)) {
    throw MissingQuantity(round ? "no contact surface at that angle"
                                : "no contact surface at that distance");
  }
  if (analysis::is_between_surface_pieces(contact, place)) {
    return 0.0;
  }
  const double t = up + down > 0.0 ? down / (up + down) : 0.0;
  return (1.0 - t) * (below->*value) + t * (above->*value);
}

// At the place of the surface that is nearest to a point, between two nodes that follow one
// another; in space at the nearest node.
double value_near(const results::ContactResult& contact, PointValue value, const base::Vec3& x) {
  if (contact.points.empty()) {
    throw MissingQuantity("the contact has no surface");
  }
  double best = std::numeric_limits<double>::infinity();
  double found = 0.0;
  if (contact.space) {
    for (const results::ContactPoint& p : contact.points) {
      if ((p.x - x).norm() < best) {
        best = (p.x - x).norm();
        found = p.*value;
      }
    }
    return found;
  }
  for (std::size_t i = 0; i < contact.points.size(); ++i) {
    const results::ContactPoint& a = contact.points[i];
    const bool ends = i + 1 == contact.points.size();
    const results::ContactPoint& next = ends ? a : contact.points[i + 1];
    const double run = (next.x - a.x).norm(); // a jump or a mouth is no edge
    const bool last = !(run > 0.0) || run > 1.6 * std::abs(next.arc - a.arc);
    const results::ContactPoint& b = last ? a : next;
    const auto [t, distance] =
        geometry::nearest_point(base::Vec2(x.head<2>()), a.x.head<2>(), b.x.head<2>());
    if (distance < best) {
      best = distance;
      found = (1.0 - t) * a.*value + t * b.*value;
    }
  }
  return found;
}

// ARC.PART.FROM (end 0) or ARC.PART.TO (1): of the closed part of that number, along the surface.
double arc_end(const results::ContactResult& contact, double number, std::size_t end) {
  const std::vector<std::array<double, 2>> parts = analysis::closed_contact_parts(contact);
  const auto count = static_cast<double>(parts.size());
  if (!(number >= 1.0 && number <= count) || number != std::floor(number)) {
    throw MissingQuantity(
        fmt::format("contact {} is closed in {} parts", contact.name, parts.size()));
  }
  return parts[static_cast<std::size_t>(number) - 1][end];
}

// What stands between contact and step, or behind the step.
enum class Argument { none, point, place, part, axis };

// A line of $CHECK with its arguments.
struct Question {
  const results::ContactResult& contact;
  PointValue value; // pressure or shear, as the contact recovers it
  base::Vec3 point = base::Vec3::Zero();
  double at = 0.0; // place or number of the part
  Eigen::Index axis = 0;
};

// A word that is no member of the record (results/contact_result.hpp has those).
struct Word {
  std::string_view word;
  Argument argument;
  double (*read)(const Question&);
};

double smallest(const Question& q) {
  return extreme(q.contact, q.value, false);
}
double largest(const Question& q) {
  return extreme(q.contact, q.value, true);
}
double at_place(const Question& q) {
  if (std::abs(q.at) > full_circle) {
    throw MissingQuantity(
        fmt::format("{0:.6g} rad, {1:.6g} degrees, is more than a circle; an angle "
                    "without a unit is in radians, {0:.6g}[deg] in degrees",
                    q.at, q.at * 180.0 / std::numbers::pi));
  }
  return value_at(q.contact, q.value, q.at);
}
double near_point(const Question& q) {
  return value_near(q.contact, q.value, q.point);
}
template <std::size_t end> double part_end(const Question& q) {
  return arc_end(q.contact, q.at, end);
}
double count_of_parts(const Question& q) {
  return static_cast<double>(analysis::closed_contact_parts(q.contact).size());
}
double force(const Question& q) {
  return q.contact.force_on_slave[q.axis];
}
double moment(const Question& q) {
  if (!q.contact.space) {
    throw MissingQuantity(
        fmt::format("contact {} is one of the plane: it has no moment", q.contact.name));
  }
  return q.contact.moment_on_slave[q.axis];
}

constexpr std::array words{
    Word{"CPRESS.MIN", Argument::none, smallest},
    Word{"CPRESS.MAX", Argument::none, largest},
    Word{"CPRESS.AT", Argument::place, at_place},
    Word{"CPRESS.NEAR", Argument::point, near_point},
    Word{"SHEAR.MIN", Argument::none, smallest},
    Word{"SHEAR.MAX", Argument::none, largest},
    Word{"SHEAR.AT", Argument::place, at_place},
    Word{"ARC.PARTS", Argument::none, count_of_parts},
    Word{"ARC.PART.FROM", Argument::part, part_end<0>},
    Word{"ARC.PART.TO", Argument::part, part_end<1>},
    Word{"SUM", Argument::axis, force},
    Word{"MOMENT", Argument::axis, moment},
};

const Word* find_word(std::string_view word) {
  const auto* const found = std::ranges::find(words, word, &Word::word);
  return found == words.end() ? nullptr : found;
}

const results::ContactQuantity* find_member(std::string_view word) {
  const auto* const found =
      std::ranges::find(results::contact_quantities, word, &results::ContactQuantity::check);
  return found == results::contact_quantities.end() ? nullptr : found;
}

bool plane_only(Argument argument, const std::string& word) {
  const results::ContactQuantity* const member = find_member(word);
  return argument == Argument::place || argument == Argument::part || word == "ARC.PARTS" ||
         (member != nullptr &&
          (member->given == results::ContactQuantityCondition::in_plane ||
           member->given == results::ContactQuantityCondition::where_it_sticks));
}

double member_of(const results::ContactResult& contact, const results::ContactQuantity& quantity) {
  const bool friction =
      quantity.given == results::ContactQuantityCondition::with_friction ||
      quantity.given == results::ContactQuantityCondition::with_friction_between_solids ||
      quantity.given == results::ContactQuantityCondition::where_it_sticks;
  if (friction && !contact.rubs) {
    throw MissingQuantity(fmt::format("contact {} has no friction in that step", contact.name));
  }
  if (quantity.given == results::ContactQuantityCondition::where_it_sticks &&
      contact.sticking == 0) {
    throw MissingQuantity("nothing sticks");
  }
  const bool space =
      quantity.given == results::ContactQuantityCondition::between_solids ||
      quantity.given == results::ContactQuantityCondition::with_friction_between_solids;
  if (space && !contact.space) {
    throw MissingQuantity(
        fmt::format("contact {} is one of the plane, which has arcs", contact.name));
  }
  return contact.*quantity.member;
}

PointValue value_of(const model::Model& model, const std::string& contact, bool shear) {
  const auto card = std::ranges::find(model.contacts, contact, &model::Contact::name);
  const bool consistent =
      card != model.contacts.end() && card->recovery == model::PressureRecovery::consistent;
  if (shear) {
    return consistent ? &results::ContactPoint::q_consistent : &results::ContactPoint::q_lumped;
  }
  return consistent ? &results::ContactPoint::p_consistent : &results::ContactPoint::p_lumped;
}

} // namespace

bool is_contact_quantity(std::string_view word) {
  return find_word(word) != nullptr || find_member(word) != nullptr;
}

double evaluate_contact_quantity(CheckLine& line) {
  auto& [model, run, word, args] = line;
  const Word* const asked = find_word(word);
  const Argument argument = asked != nullptr ? asked->argument : Argument::none;
  const bool shear = word.starts_with("SHEAR.");
  const std::string name = args.required_name("a contact");
  const base::Vec3 point =
      argument == Argument::point ? args.required_point(model.mesh.dim) : base::Vec3::Zero();
  const std::string step = args.required_name("a step");
  double at = 0.0;
  Eigen::Index axis = 0;
  if (argument == Argument::place) {
    at = args.required_number("an angle or a length");
  } else if (argument == Argument::part) {
    at = args.required_number("a number");
  } else if (argument == Argument::axis) {
    axis = axis_index(args.required_name("X, Y or Z"));
  }
  const results::LoadStepResult& found =
      *find_checked_increment_and_step(run, step, args.optional_number()).step;
  const results::ContactResult contact = contact_of(model, found, name);
  if (contact.space && plane_only(argument, word)) {
    throw MissingQuantity(
        fmt::format("contact {} is one of solids, which has no arc: ask CPRESS.NEAR "
                    "with x, y and z",
                    name));
  }
  if (shear && !contact.sheared) {
    throw MissingQuantity(fmt::format("contact {} has no shear: neither MU nor TYPE=BONDED", name));
  }
  if (asked == nullptr) {
    return member_of(contact, *find_member(word));
  }
  return asked->read({.contact = contact,
                      .value = value_of(model, name, shear),
                      .point = point,
                      .at = at,
                      .axis = axis});
}

} // namespace spricka::program
