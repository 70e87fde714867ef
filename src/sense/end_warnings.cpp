// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/end_warnings.hpp"

#include "model/model.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

constexpr double no_pressure = 1e-12; // of a modulus: round-off
constexpr double endless = 1e12;      // cycles: at 100 a second some 300 years

// What a contact of the deck did in all steps of a run.
struct Doings {
  bool mounted = false;
  bool pressed = false;
  double nearest = 0.0; ///< the least gap of the steps
};

Doings doings_of(const results::RunResult& run, const std::string& name, double no_load) {
  Doings found;
  bool first = true;
  for (const results::CrackLengthResult& increment : run.increments) {
    // between its steps a path may close what they leave open
    const bool turns = std::ranges::any_of(
        increment.paths, [](const results::LoadPathResult& path) { return path.t.size() > 2; });
    found.pressed = found.pressed || turns;
    for (const results::LoadStepResult& step : increment.steps) {
      const results::ContactResult* contact = results::find_contact(step, name);
      if (contact == nullptr || !contact->mounted) {
        continue;
      }
      found.mounted = true;
      found.pressed = found.pressed || contact->max_pressure > no_load;
      for (const results::ContactPoint& point : contact->points) {
        found.nearest = first ? point.gap : std::min(found.nearest, point.gap);
        first = false;
      }
    }
  }
  return found;
}

void add_idle_contacts(const model::Model& model, const results::RunResult& run,
                       std::vector<RunWarning>& list) {
  double softest = 0.0;
  for (const model::ElasticMaterial& material : model.materials) {
    softest = softest > 0.0 ? std::min(softest, material.E) : material.E;
  }
  std::vector<Doings> all;
  for (const model::Contact& contact : model.contacts) {
    all.push_back(doings_of(run, contact.name, no_pressure * softest));
  }
  const bool others = std::ranges::any_of(all, &Doings::pressed);
  for (std::size_t c = 0; c < all.size(); ++c) {
    const model::Contact& contact = model.contacts[c];
    const Doings& found = all[c];
    // A seat that is drawn touching and lifts off while the joint is pressed elsewhere does what it
    // is meant to: no other sign of its fit presses it.
    const bool seat = others && contact.gap && *contact.gap == 0.0;
    if (contact.type == model::ContactType::bonded || !found.mounted || found.pressed || seat) {
      continue;
    }
    list.push_back(
        {"W571", fmt::format("contact {} is mounted and presses in no step of the run{}: it has no "
                             "effect on the results. Is its fit the one you mean (GAP keeps apart, "
                             "INTERFERENCE presses), and is a step missing?",
                             contact.name,
                             found.nearest > 0.0
                                 ? fmt::format(" (its surfaces stay {:.3g} {} apart or more)",
                                               found.nearest, model.units.length_name)
                                 : "")});
  }
}

void add_endless_life(const results::RunResult& run, std::vector<RunWarning>& list) {
  if (!run.growth) {
    return;
  }
  const results::GrowthResult& growth = *run.growth;
  // Passes of a spectrum count with all their cycles.
  const double cycles = growth.final_cycles() * growth.cycles_per_pass;
  if (cycles > endless) {
    list.push_back(
        {"W572", fmt::format("the life is {:.3g} {}: at 100 a second {:.2g} years. Are "
                             "the loads, C, KUNIT and AUNIT those you mean?",
                             growth.final_cycles(), growth.unit == "pass" ? "passes" : "cycles",
                             cycles / (100.0 * 3600.0 * 24.0 * 365.25))});
  }
}

void add_strange_tests(const model::Model& model, const results::RunResult& run,
                       std::vector<RunWarning>& list) {
  for (const results::GrowthTestResult& test : run.tests) {
    const bool outside =
        !test.readings.empty() && std::ranges::all_of(test.points, [](const auto& point) {
          return std::isnan(point.computed);
        });
    if (!outside || test.computed.empty()) {
      continue;
    }
    const auto [first, last] = std::ranges::minmax_element(
        test.readings, {}, [](const auto& reading) { return reading[1]; });
    list.push_back(
        {"W573", fmt::format("test {}: its lengths, {:.4g} to {:.4g} {unit}, lie all "
                             "outside those of {} that were computed, {:.4g} to {:.4g} "
                             "{unit}: nothing is compared. Are they in the unit meant, "
                             "and counted from the crack's mouth?",
                             test.name, (*first)[1], (*last)[1], test.tip, test.computed.front()[0],
                             test.computed.back()[0], fmt::arg("unit", model.units.length_name))});
  }
}

// Whether a crack has K, and K1 is 0 in all steps at all places.
bool never_opens(const results::RunResult& run, const std::string& crack) {
  const auto is_of_it = [&](const std::string& name) {
    return name == crack || name == crack + ".1" || name == crack + ".2";
  };
  bool any = false;
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      for (const results::FrontResult& front : step.fronts) {
        if (is_of_it(front.name) && !std::ranges::all_of(front.points, [](const auto& point) {
              return point.closed || point.at_surface;
            })) {
          return false;
        }
        any = any || is_of_it(front.name);
      }
    }
  }
  return any;
}

// The nets that press on another one.
std::vector<std::string> touching_nets(const model::Model& model, base::NetId net) {
  std::vector<std::string> names;
  const auto net_of = [&](base::FaceSetId set) {
    return set.valid() && !model.mesh.set_with_id(set).faces.empty()
               ? model.mesh.element_net[model.mesh.set_with_id(set).faces.front().element.index()]
               : base::NetId();
  };
  for (const model::Contact& contact : model.contacts) {
    const base::NetId slave = net_of(contact.slave);
    const base::NetId master = net_of(contact.master);
    const base::NetId other = slave == net ? master : master == net ? slave : base::NetId();
    if (other.valid() && other != net &&
        std::ranges::find(names, model.nets[other.index()].name) == names.end()) {
      names.push_back(model.nets[other.index()].name);
    }
  }
  return names;
}

// Where bodies touch, a crack that is drawn at their contact may have got into the wrong one: pins
// are pressed where lugs are pulled.
void add_closed_cracks(const model::Model& model, const results::RunResult& run,
                       std::vector<RunWarning>& list) {
  for (const model::CrackDefinition& crack : model.cracks) {
    const std::vector<std::string> joined_nets =
        crack.net.valid() ? touching_nets(model, crack.net) : std::vector<std::string>();
    if (!joined_nets.empty() && never_opens(run, crack.name)) {
      list.push_back(
          {"W575", fmt::format("crack {}: its faces touch all along its front in every step, K1 = "
                               "0. It lies in the net {}, which touches {}: is the cracked body "
                               "the one you mean (NET), and are the loads?",
                               crack.name, model.nets[crack.net.index()].name,
                               fmt::join(joined_nets, ", "))});
    }
  }
}

} // namespace

std::vector<RunWarning> find_run_warnings(const model::Model& model,
                                          const results::RunResult& run) {
  std::vector<RunWarning> list;
  add_idle_contacts(model, run, list);
  add_endless_life(run, list);
  add_strange_tests(model, run, list);
  add_closed_cracks(model, run, list);
  return list;
}

} // namespace spricka::sense
