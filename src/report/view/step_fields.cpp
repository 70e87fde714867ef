// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view/step_fields.hpp"

#include "model/model.hpp"
#include "report/drawing/round_off.hpp"
#include "report/topics/figures.hpp"
#include "report/view/encoded_array.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace spricka::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

Json encode_displacements(const model::Mesh& mesh, const results::LoadStepResult& step,
                          const ShownSurface& surface, const base::OutputUnit& length) {
  Json components = Json::array();
  for (int c = 0; c < mesh.dim; ++c) {
    std::vector<double> values;
    values.reserve(surface.node.size());
    for (const base::NodeId n : surface.node) {
      values.push_back(
          length.from_deck(step.u[static_cast<Eigen::Index>(n.index()) * mesh.dim + c]));
    }
    components.push_back(encode_numbers(values));
  }
  return components;
}

void add_stresses(Json& fields, const results::LoadStepResult& step, const ShownSurface& surface,
                  bool significant, const base::OutputUnit& unit) {
  std::vector<double> mises;
  std::vector<double> largest;
  for (const std::size_t source : surface.source) {
    const results::Stress& stress = step.stress[source];
    mises.push_back(significant ? unit.from_deck(results::von_mises(stress)) : 0.0);
    largest.push_back(significant ? unit.from_deck(results::principal_stresses(stress)[0]) : 0.0);
  }
  fields["mises"] = encode_numbers(mises);
  fields["p1"] = encode_numbers(largest);
}

/// Values of nodes, at mid nodes that have none the mean of the corners beside them.
std::vector<double> at_points(const ShownSurface& surface, const std::vector<double>& of_node) {
  std::vector<double> values;
  for (const base::NodeId n : surface.node) {
    values.push_back(of_node[n.index()]);
  }
  std::size_t first = 0;
  for (const std::uint32_t kind : surface.kind) {
    const std::size_t n = kind % ShownSurface::has_mid_nodes;
    for (std::size_t i = 1; kind >= ShownSurface::has_mid_nodes && i < n; i += 2) {
      double& mid = values[surface.outline[first + i]];
      if (std::isnan(mid)) {
        mid = 0.5 * (values[surface.outline[first + i - 1]] +
                     values[surface.outline[first + (i + 1) % n]]);
      }
    }
    first += n;
  }
  return values;
}

/// Of few points: their numbers and their values.
Json encode_sparse(const std::vector<double>& values) {
  std::vector<std::uint32_t> at;
  std::vector<double> given;
  for (std::uint32_t p = 0; p < values.size(); ++p) {
    if (!std::isnan(values[p])) {
      at.push_back(p);
      given.push_back(values[p]);
    }
  }
  return {{"at", encode_counts(at)}, {"values", encode_numbers(given)}};
}

void add_contacts(Json& fields, const model::Model& model,
                  const results::CrackLengthResult& increment, const results::LoadStepResult& step,
                  const ShownSurface& surface) {
  constexpr double round_off = 1e-9;
  const base::OutputUnit length = model.units.output_length();
  const base::OutputUnit stress = model.units.output_stress();
  const double least = round_off * reference_elastic_stress(model, increment);
  std::vector<double> pressure(increment.mesh.node_count(), not_there);
  std::vector<double> gap = pressure;
  bool any = false;
  for (const results::ContactResult& contact : step.contacts) {
    const auto card = std::ranges::find(model.contacts, contact.name, &model::Contact::name);
    for (const results::ContactPoint& point : contact.points) {
      if (!contact.mounted || !point.node.valid() || point.node.index() >= pressure.size()) {
        continue;
      }
      const double p =
          card == model.contacts.end() ? point.p_lumped : recovered_pressure(*card, point);
      pressure[point.node.index()] = std::abs(p) > least ? stress.from_deck(p) : 0.0;
      gap[point.node.index()] = point.closed ? 0.0 : length.from_deck(point.gap);
      any = true;
    }
  }
  if (any) {
    fields["pressure"] = encode_sparse(at_points(surface, pressure));
    fields["gap"] = encode_sparse(at_points(surface, gap));
  }
}

} // namespace

Json encode_step(const model::Model& model, const results::CrackLengthResult& increment,
                 const results::LoadStepResult& step, const ShownSurface& surface) {
  Json fields = Json::object();
  if (!step.stress.empty()) {
    add_stresses(fields, step, surface, has_significant_stress(model, increment, step),
                 model.units.output_stress());
  }
  add_contacts(fields, model, increment, step, surface);
  const base::OutputUnit unit = model.units.output_stress_intensity();
  Json fronts = Json::array();
  for (const results::FrontResult& front : step.fronts) {
    Json K = Json::array();
    for (const results::FrontPointResult& point : front.points) {
      const bool of_mesh = point.at_surface && !front.is_tip(); // says nothing
      K.push_back(of_mesh ? Json() : Json(unit.from_deck(point.K1)));
    }
    fronts.push_back(std::move(K));
  }
  return {{"name", step.step},
          {"u", encode_displacements(increment.mesh, step, surface, model.units.output_length())},
          {"fields", std::move(fields)},
          {"K1", std::move(fronts)}};
}

} // namespace spricka::report
