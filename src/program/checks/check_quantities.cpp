// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/checks/check_quantities.hpp"

#include "analysis/recover/closed_parts.hpp"
#include "analysis/scene/gone_nodes.hpp"
#include "program/checks/field_quantities.hpp"
#include "program/checks/growth_readings.hpp"
#include "program/checks/path_quantities.hpp"
#include "program/checks/place_quantities.hpp"
#include "results/growth_end.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace spricka::program {

namespace {

constexpr double full_circle = 6.2832; // [rad] as ANGLE of $CRACK

double tip_quantity(const std::string& quantity, Arguments& args, const results::Run& run) {
  const std::string tip = args.name("a crack");
  const std::string step = args.name("a step");
  const Place at = find_place(run, step, args.number());
  const results::TipResult* found = results::find_tip(*at.step, tip);
  if (found == nullptr) {
    const bool two = results::find_tip(*at.step, tip + ".1") != nullptr;
    throw Missing(two ? fmt::format("crack {0} has two tips: {0}.1 and {0}.2", tip)
                      : fmt::format("no tip {}", tip));
  }
  if (!found->doubt.empty() && !(found->two_materials && quantity == "G")) {
    throw Missing(found->doubt);
  }
  if (quantity.find('.') != std::string::npos) {
    if (!found->no_bar.empty()) {
      throw Missing("no error bar: " + found->no_bar);
    }
    const results::KBar& bar = found->bar[quantity.starts_with("K2") ? 1 : 0];
    return quantity.ends_with(".BEST") ? bar.best : bar.size();
  }
  if (quantity == "K2") {
    return found->K2;
  }
  if (quantity == "T") {
    return found->T;
  }
  return quantity == "G" ? found->G : found->K1;
}

// Faces of a crack that touch nowhere are no pair: they have no pressure and no closed part.
results::ContactResult open_faces(const model::Model& model, const std::string& contact) {
  for (const model::Crack& crack : model.cracks) {
    if (contact == crack.name + ".FACES" && crack.faces_in_contact) {
      results::ContactResult open;
      open.name = contact;
      open.sheared = open.rubs = crack.mu > 0.0;
      return open;
    }
  }
  throw Missing(fmt::format("no contact {}", contact));
}

results::ContactResult contact_of(const model::Model& model, const results::StepResult& step,
                                  const std::string& contact) {
  const results::ContactResult* found = results::find_contact(step, contact);
  return found != nullptr ? *found : open_faces(model, contact);
}

// The value at a point that a quantity is about.
using PointValue = double results::ContactPoint::*;

PointValue value_of(const std::string& quantity, bool consistent) {
  if (quantity.starts_with("SHEAR.")) {
    return consistent ? &results::ContactPoint::q_consistent : &results::ContactPoint::q_lumped;
  }
  return consistent ? &results::ContactPoint::p_consistent : &results::ContactPoint::p_lumped;
}

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

// Between the two points next to theta, or at a distance along a straight surface; lips are met
// from their own side.
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
  if (below == nullptr || above == nullptr || (round && up + down > 1.0)) {
    throw Missing(round ? "no contact surface at that angle"
                        : "no contact surface at that distance");
  }
  if (analysis::between_pieces(contact, place)) {
    return 0.0;
  }
  const double t = up + down > 0.0 ? down / (up + down) : 0.0;
  return (1.0 - t) * (below->*value) + t * (above->*value);
}

double friction_quantity(const std::string& quantity, const results::ContactResult& contact) {
  if (!contact.rubs) {
    throw Missing(fmt::format("contact {} has no friction in that step", contact.name));
  }
  if (quantity == "SLIP.MAX") {
    return contact.max_slip;
  }
  if (quantity == "FRICTION.WORK") {
    return contact.friction_work;
  }
  if (contact.sticking == 0) {
    throw Missing("nothing sticks");
  }
  return quantity == "STICK.FROM" ? contact.stick_from : contact.stick_to;
}

bool of_friction(const std::string& quantity) {
  return quantity.starts_with("STICK.") || quantity == "SLIP.MAX" || quantity == "FRICTION.WORK";
}

double contact_quantity(const model::Model& model, const std::string& quantity, Arguments& args,
                        const results::Run& run) {
  const std::string name = args.name("a contact");
  std::optional<base::Vec2> place;
  if (quantity == "CPRESS.NEAR") {
    const double x = args.needed("x");
    place = base::Vec2(x, args.needed("y"));
  }
  const std::string step = args.name("a step");
  std::optional<double> theta;
  int component = 0;
  if (quantity == "CPRESS.AT" || quantity == "SHEAR.AT") {
    theta = args.needed("an angle or a length");
  } else if (quantity.starts_with("ARC.PART.")) {
    theta = args.needed("a number");
  } else if (quantity == "SUM") {
    const std::string axis = args.name("X, Y or Z");
    component = axis == "Z" ? 2 : (axis == "Y" ? 1 : 0);
  }
  const Place at = find_place(run, step, args.number());
  const results::ContactResult contact = contact_of(model, *at.step, name);
  const auto card = std::find_if(model.contacts.begin(), model.contacts.end(),
                                 [&](const model::Contact& c) { return c.name == name; });
  const bool consistent =
      card != model.contacts.end() && card->recovery == model::Recovery::consistent;
  if (quantity.starts_with("SHEAR.") && !contact.sheared) {
    throw Missing(fmt::format("contact {} has no shear: neither MU nor TYPE=BONDED", name));
  }
  if (place) {
    return pressure_near(contact, value_of("CPRESS.AT", consistent), *place);
  }
  if (quantity.starts_with("ARC.PART.")) {
    return end_of_part(contact, quantity, *theta);
  }
  if (theta && std::abs(*theta) > full_circle) {
    throw Missing(fmt::format("{0:.6g} rad, {1:.6g} degrees, is more than a circle; an angle "
                              "without a unit is in radians, {0:.6g}[deg] in degrees",
                              *theta, *theta * 180.0 / std::numbers::pi));
  }
  if (theta) {
    return value_at(contact, value_of(quantity, consistent), *theta);
  }
  if (quantity == "SUM") {
    return contact.force_on_slave[component];
  }
  if (quantity != "CPRESS.MEAN" &&
      (quantity.starts_with("CPRESS.") || quantity.starts_with("SHEAR."))) {
    return extreme(contact, value_of(quantity, consistent), quantity.ends_with(".MAX"));
  }
  if (of_friction(quantity)) {
    return friction_quantity(quantity, contact);
  }
  if (quantity == "ARC.FROM") {
    return contact.arc_from;
  }
  if (quantity == "ARC.PARTS") {
    return static_cast<double>(analysis::closed_parts(contact).size());
  }
  return quantity == "ARC.TO" ? contact.arc_to : contact.mean_pressure;
}

double reaction(const model::Model& model, Arguments& args, const results::Run& run) {
  const std::string set = args.name("a set");
  const std::string step = args.name("a step");
  const Eigen::Index axis = axis_of(args.name("X, Y or Z"));
  const Place at = find_place(run, step, args.number());
  if (const auto lost = analysis::lost_reaction(model, at.increment->mesh, set)) {
    throw Missing(fmt::format("the patch of a crack has replaced node {} of the support: ask for a "
                              "set with the whole edge there",
                              model.mesh.node_label[lost->index()]));
  }
  std::vector<base::NodeId> nodes = nodes_of_set(at.increment->mesh, set);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  double sum = 0.0;
  for (const base::NodeId n : nodes) {
    sum += at.step->reaction[static_cast<Eigen::Index>(n.index()) * at.increment->mesh.dim + axis];
  }
  return sum;
}

double energy(Arguments& args, const results::Run& run) {
  const std::string net = args.name("a net or *");
  const std::string step = args.name("a step");
  const results::StepResult& at = *find_place(run, step, args.number()).step;
  if (net == "*") {
    return at.energy;
  }
  const auto found = std::ranges::find(at.nets, net, &results::Balance::body);
  if (found == at.nets.end()) {
    throw Missing(fmt::format("net {} has no elements", net));
  }
  return found->energy;
}

double estimated_error(Arguments& args, const results::Run& run) {
  const std::string net = args.name("a net or *");
  const std::string step = args.name("a step");
  const results::StepResult& at = *find_place(run, step, args.number()).step;
  const auto found = std::ranges::find(at.errors, net, &results::NetError::net);
  if (found == at.errors.end()) {
    throw Missing(fmt::format("net {} has no elements outside crack patches", net));
  }
  return found->part;
}

results::Cause cause_of(const std::string& quantity) {
  if (quantity.ends_with(".LOAD")) {
    return results::Cause::load;
  }
  if (quantity.ends_with(".FIT")) {
    return results::Cause::fit;
  }
  return quantity.ends_with(".E") ? results::Cause::modulus : results::Cause::length;
}

// Value times derivative. At a change of contact there are two derivatives and no answer.
double derivative(const std::string& quantity, Arguments& args, const results::Run& run) {
  const results::Cause cause = cause_of(quantity);
  const std::string tip = args.name("a crack");
  const std::string step = args.name("a step");
  const std::string name = cause == results::Cause::length ? tip : args.name("a name");
  const results::TipResult* found =
      results::find_tip(*find_place(run, step, args.number()).step, tip);
  if (found == nullptr) {
    throw Missing(fmt::format("no tip {}", tip));
  }
  if (!found->doubt.empty()) {
    throw Missing(found->doubt);
  }
  const results::Sensitivities& all = found->sensitivities;
  const auto it = std::ranges::find_if(
      all.of, [&](const results::Sensitivity& s) { return s.cause == cause && s.name == name; });
  if (it == all.of.end()) {
    throw Missing(all.notes.empty() ? fmt::format("{} has no value in that step", name)
                                    : all.notes.front());
  }
  const std::size_t k = quantity.starts_with("DK1") ? 0 : 1;
  if (!it->below || !it->above) {
    throw Missing("on one side of this state nothing holds a body");
  }
  if (!it->slope()) {
    throw Missing(fmt::format("the contact changes at this very state: {:.7g} below, {:.7g} above",
                              it->value * (*it->below)[k], it->value * (*it->above)[k]));
  }
  return it->value * (*it->slope())[k];
}

// Cycles until the first of the growing tips has a length, or to the end.
double cycles(const std::string& quantity, Arguments& args, const results::Run& run) {
  if (!run.growth) {
    throw Missing("no crack grows by a law");
  }
  if (results::ended_early(*run.growth)) {
    throw Missing("the growth ended early: " + run.growth->reason);
  }
  if (quantity == "LIFE") {
    return run.growth->cycles();
  }
  const std::optional<double> a = args.number();
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t tip = 0; a && tip < run.growth->tips.size(); ++tip) {
    const double at = results::cycles_at(*run.growth, tip, *a);
    first = at < first ? at : first;
  }
  if (!(first < std::numeric_limits<double>::infinity())) {
    throw Missing("no tip of the growth has that length");
  }
  return first;
}

double evaluate(const model::Model& model, const model::Check& check, const results::Run& run) {
  Arguments args(check);
  const std::string& q = check.quantity;
  if (q == "K" || q == "K1" || q == "K2" || q == "G" || q == "T" || q.starts_with("K1.") ||
      q.starts_with("K2.")) {
    return tip_quantity(q, args, run);
  }
  if (q.starts_with("DK1.") || q.starts_with("DK2.")) {
    return derivative(q, args, run);
  }
  if (q.starts_with("PATH.")) {
    return path_quantity(q, args, run);
  }
  if (q.starts_with("TEST.")) {
    return test_quantity(q, args, run);
  }
  if (q.starts_with("CPRESS.") || q.starts_with("ARC.") || q.starts_with("SHEAR.") ||
      of_friction(q) || q == "SUM") {
    return contact_quantity(model, q, args, run);
  }
  if (q == "N" || q == "LIFE") {
    return cycles(q, args, run);
  }
  if (q == "ENERGY") {
    return energy(args, run);
  }
  if (q == "ERROR") {
    return estimated_error(args, run);
  }
  if (q == "REACTION") {
    return reaction(model, args, run);
  }
  if (q.starts_with("U.") || q.starts_with("S.")) {
    return field_quantity(model, q, args, run);
  }
  throw Missing(fmt::format("{} is not available in this version", q));
}

std::string text_of(const model::Check& check) {
  std::string text = check.quantity + "(";
  for (std::size_t i = 0; i < check.arguments.size(); ++i) {
    text += i > 0 ? "," : "";
    text += std::holds_alternative<std::string>(check.arguments[i])
                ? std::get<std::string>(check.arguments[i])
                : fmt::format("{:.6g}", std::get<double>(check.arguments[i]));
  }
  return text + ")";
}

} // namespace

std::vector<results::CheckResult> evaluate_checks(const model::Model& model,
                                                  const results::Run& run) {
  std::vector<results::CheckResult> all;
  for (const model::Check& check : model.checks) {
    results::CheckResult result;
    result.text = text_of(check);
    result.wanted = check.value;
    result.tolerance = check.tolerance;
    result.relative = check.relative;
    result.source = check.source;
    try {
      result.found = evaluate(model, check, run);
      const double difference = result.found - result.wanted;
      result.error = check.relative ? difference / std::abs(check.value) : difference;
      result.passed = std::abs(result.error) <= check.tolerance;
    } catch (const Missing& missing) {
      result.trouble = missing.what();
    }
    all.push_back(std::move(result));
  }
  return all;
}

} // namespace spricka::program
