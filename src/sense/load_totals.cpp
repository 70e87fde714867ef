// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/load_totals.hpp"

#include "fe/assemble.hpp"
#include "fe/between_nodes.hpp"
#include "fe/heat.hpp"
#include "fe/load_rule.hpp"
#include "model/model.hpp"
#include "sense/mirrored_cracks.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

results::LoadTotal total_of(const model::Model& model, const model::Mesh& mesh,
                            const base::Vector& f) {
  results::LoadTotal total;
  const bool axial = model::is_axisymmetric(model);
  for (std::size_t n = 0; n < mesh.node_count(); ++n) {
    base::Vec3 force = base::Vec3::Zero();
    force.head(mesh.dim) = f.segment(mesh.dim * static_cast<Eigen::Index>(n), mesh.dim);
    total.magnitude_sum += force.norm();
    if (axial) { // what is radial balances round the circumference
      force.x() = 0.0;
    } else {
      total.moment += mesh.x[n].cross(force);
    }
    total.force += force;
  }
  return total;
}

void tidy(results::LoadTotal& total, const model::Mesh& mesh) {
  // Of the sum of all nodal forces: sums that cancel are told as 0.
  constexpr double round_off = 1e-12;
  double size = 0.0;
  for (const base::Vec3& x : mesh.x) {
    size = std::max(size, x.norm());
  }
  for (Eigen::Index k = 0; k < 3; ++k) {
    total.force[k] =
        std::abs(total.force[k]) < round_off * total.magnitude_sum ? 0.0 : total.force[k];
    total.moment[k] =
        std::abs(total.moment[k]) < round_off * total.magnitude_sum * size ? 0.0 : total.moment[k];
  }
}

bool is_number(const base::Vector& f, const model::LoadCase& load_case, const model::Load& load,
               base::Diagnostics& diagnostics) {
  if (f.allFinite()) {
    return true;
  }
  diagnostics.error(
      load.span, "E434",
      fmt::format("load case {}: this load is not a finite number everywhere", load_case.name),
      "a division by zero, a root or logarithm of a negative number, or a value "
      "beyond the range of numbers (1e308)");
  return false;
}

// Of the load's size: curved rims of sets are polygons, and what integration misses on either mesh
// is W435's concern.
double permitted_change(const model::Model& model, const model::Mesh& cracked,
                        const model::Load& load) {
  constexpr double polygons = 1e-6;
  return fe::is_constant(load)
             ? polygons
             : fe::adaptive_rule_limits_by_dim.at(static_cast<std::size_t>(cracked.dim) - 1)
                       .load_tolerance +
                   fe::unresolved_load_fraction(model, model.mesh, load) +
                   fe::unresolved_load_fraction(model, cracked, load);
}

// Whether the total [force] is the same with the crack in the mesh.
bool keeps_its_total(const model::Model& model, const model::Mesh& cracked,
                     const base::Vector& forces, const model::LoadCase& load_case,
                     const model::Load& load, base::Diagnostics& diagnostics) {
  const results::LoadTotal before = total_of(
      model, model.mesh, fe::consistent_load_vector(model, model.mesh, {load_case.name, {load}}));
  const results::LoadTotal after = total_of(model, cracked, forces);
  const double change = (after.force - before.force).norm();
  const double size = std::max(before.magnitude_sum, after.magnitude_sum);
  constexpr double round_off = 1e-9;
  if (change <= round_off * size || change <= permitted_change(model, cracked, load) * size) {
    return true;
  }
  diagnostics.error(
      load.span, "E435",
      fmt::format("load case {}: the mesh round a crack changes the total of this load, {:.6g}, by "
                  "{:.3g}",
                  load_case.name, before.force.norm(), change),
      "keep the crack's patch away from the rim of the set: a smaller RADIUS on $TIPNET");
  return false;
}

void warn_of_unresolved(const model::Model& model, const model::Mesh& mesh,
                        const model::LoadCase& load_case, const model::Load& load,
                        base::Diagnostics& diagnostics) {
  const auto reported = [&](const base::Diagnostic& d) {
    return d.code == "W435" && d.span.file == load.span.file && d.span.begin == load.span.begin;
  };
  if (fe::is_constant(load) || std::ranges::any_of(diagnostics.messages(), reported)) {
    return;
  }
  const double missed = load.type == model::LoadType::temperature
                            ? fe::unresolved_temperature_fraction(model, mesh, load)
                            : fe::unresolved_load_fraction(model, mesh, load);
  // Far below what bars of K are; jumps askew in solids and integrable poles are better known.
  constexpr double little = 5e-4;
  if (missed > little) {
    diagnostics.warning(load.span, "W435",
                        fmt::format("load case {}: this load changes too fast within an element to "
                                    "be integrated; up to {} % of its total may be missed",
                                    load_case.name,
                                    missed > 0.995 ? "100" : fmt::format("{:.2g}", 100.0 * missed)),
                        "refine the net where the load changes");
  }
}

// Displacements are taken at nodes; K and its bar know nothing else of them.
void warn_of_missing_displacement(const model::Mesh& mesh, double largest,
                                  const model::LoadCase& load_case, const model::Load& load,
                                  base::Diagnostics& diagnostics) {
  const fe::DisplacementInterpolationError missing =
      fe::displacement_interpolation_error(mesh, load);
  constexpr double little = 0.01;
  if (!(missing.off > little * std::max(largest, missing.off))) {
    return;
  }
  const std::span place(missing.place.data(), static_cast<std::size_t>(mesh.dim));
  diagnostics.warning(
      load.span, "W436",
      fmt::format("load case {}: between the nodes at ({:.4g}) this displacement differs "
                  "by {:.2g} from what the mesh can follow, {:.2g} % of the case's "
                  "largest; results and their error bars do not include this",
                  load_case.name, fmt::join(place, ", "), missing.off,
                  100.0 * missing.off / std::max(largest, missing.off)),
      "refine the net there, with nodes at kinks and steps");
}

double largest_displacement(const model::Model& model, const model::Mesh& mesh,
                            const model::LoadCase& load_case) {
  return fe::prescribed_displacement_vector(model, mesh, load_case).cwiseAbs().maxCoeff();
}

} // namespace

std::vector<results::LoadTotal> compute_load_totals(const model::Model& model) {
  std::vector<results::LoadTotal> totals;
  for (const model::LoadCase& load_case : model.cases) {
    model::LoadCase forces{load_case.name, {}};
    std::ranges::copy_if(load_case.loads, std::back_inserter(forces.loads), model::is_force_load);
    results::LoadTotal total =
        total_of(model, model.mesh, fe::consistent_load_vector(model, model.mesh, forces));
    if (total.magnitude_sum > 0.0) {
      total.load_case = load_case.name;
      tidy(total, model.mesh);
      totals.push_back(std::move(total));
    }
  }
  return totals;
}

bool check_load_on_cracked_mesh(const model::Model& model, const model::Mesh& cracked,
                                const model::LoadCase& load_case, const model::Load& load,
                                const base::Vector& values, base::Diagnostics& diagnostics) {
  if (!is_number(values, load_case, load, diagnostics)) {
    return false;
  }
  if (load.type == model::LoadType::displacement) {
    warn_of_missing_displacement(cracked, largest_displacement(model, cracked, load_case),
                                 load_case, load, diagnostics);
    return true;
  }
  // Faces of a crack are there once it is cut only.
  if (model::is_force_load(load) && !model.cracks.empty() &&
      find_loaded_crack(model, load) == nullptr &&
      !keeps_its_total(model, cracked, values, load_case, load, diagnostics)) {
    return false;
  }
  warn_of_unresolved(model, cracked, load_case, load, diagnostics);
  return true;
}

} // namespace spricka::sense
