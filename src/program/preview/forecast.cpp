// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/preview/forecast.hpp"

#include "base/clock.hpp"
#include "estimate/enrichment.hpp"
#include "model/model.hpp"
#include "program/preview/net_outline.hpp"
#include "solve/engine_choice.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <span>

#include <fmt/format.h>

namespace spricka::program {

namespace {

// Work per element and occasion in units of one element stiffness: internal forces, balance and
// pressures of a step; recovery, tables and pictures of a step that is shown. Ratios are those of
// QUAMC8 plates of 10 000 and 160 000 elements.
constexpr double step_share = 0.5;
constexpr double output_share = 2.5;
// Half solves touch each entry of the factor twice, each time for a product of blocks this wide.
constexpr double solve_width = 2.0;
// Block size of contact's dense algebra, in sizes that reach half the peak.
constexpr double contact_width = 0.25;
constexpr std::size_t sample_size = 4000;
// Stiffness by entries of element matrices [s]: 6 to 10 ns, by type.
constexpr double matrix_entry_time = 8.5e-9;
constexpr double number = 8.0; // bytes

double externals_of(const analysis::Substructure& net) {
  return static_cast<double>(net.map.external_count());
}

// What contact rows weigh of the unknowns of a net, without the weights.
solve::SparseRightHandSides rows_on_net(const analysis::CondensationRequest& request,
                                        const analysis::Substructure& net) {
  solve::SparseRightHandSides F;
  const int dim = request.mesh.dim;
  for (const contact::ConstraintRow* row : request.rows) {
    const std::size_t before = F.row.size();
    for (const contact::RowEntry& entry : row->entries) {
      for (int c = 0; c < dim; ++c) {
        const std::size_t freedom =
            static_cast<std::size_t>(dim) * entry.node.index() + static_cast<std::size_t>(c);
        if (entry.weight[c] != 0.0 && net.map.row[freedom] >= 0) {
          F.row.push_back(net.map.row[freedom]);
        }
      }
    }
    if (F.row.size() > before) {
      F.start.push_back(static_cast<std::int64_t>(F.row.size()));
    }
  }
  return F;
}

double nodal_vector(const model::Mesh& mesh) {
  return number * mesh.dim * static_cast<double>(mesh.node_count());
}

// Mesh, displacements and reactions of all steps, stresses of one: what the run keeps of a length.
double results_bytes(const model::Mesh& mesh, std::size_t steps) {
  const auto nodes = static_cast<double>(mesh.node_count());
  const double topology = 4.0 * static_cast<double>(mesh.nodes.size()) +
                          24.0 * static_cast<double>(mesh.element_count());
  return topology + 40.0 * nodes + 2.0 * static_cast<double>(steps) * nodal_vector(mesh) +
         6.0 * number * nodes;
}

} // namespace

/// What one length asks for.
struct CostForecast::Needs {
  double flops = 0.0;
  double row_flops = 0.0; ///< compliances of rows on bodies that stay whole
  double entries = 0.0;
  double solve_entries = 0.0; ///< of all factors that a step passes through
  double seconds = 0.0;
  double kept = 0.0;                ///< [bytes] factors and condensed stiffnesses
  std::vector<double> passing;      ///< [bytes] on top, net by net, while it is factorised
  std::vector<std::string> engines; ///< of nets that Cholesky does not do
  int condensed = 0;
  int reused = 0;
  std::size_t unknowns = 0;
};

// "LUG: MUMPS out of core, 3100 MB and 7400 MB of disk: in core would need 8.2 GB, 5.1 GB can be
// had"
std::string CostForecast::describe_engine(const NetToForecast& piece,
                                          const solve::FactorReport& report) {
  const std::string disk =
      report.disk > 0.0 ? fmt::format(" and {:.0f} MB of disk", 1e-6 * report.disk) : "";
  return fmt::format("{}: {}, {:.0f} MB{}{}{}",
                     piece.body != nullptr ? piece.body->name : std::string("a part"),
                     solve::engine_text(report), 1e-6 * report.memory, disk,
                     report.engine_reason.empty() ? "" : ": ", report.engine_reason);
}

// Unknowns of the net's condensed parts in the net.
std::vector<solve::CondensedNetBlock>
CostForecast::blocks_of(const NetToForecast& piece,
                        std::vector<std::vector<std::int32_t>>& freedoms) {
  std::vector<solve::CondensedNetBlock> blocks;
  for (std::size_t p = 0; piece.body != nullptr && p < piece.body->parts.size(); ++p) {
    const fe::DofMap& map = piece.body->parts[p]->map;
    freedoms.emplace_back(map.freedom.begin() + map.locals, map.freedom.end());
    blocks.push_back({analysis::equation_numbers(piece.net.map, freedoms.back())});
  }
  return blocks;
}

solve::FactorReport CostForecast::analyse(const analysis::CondensationRequest& request,
                                          const NetToForecast& piece) {
  const auto& [net, key, body, first_part] = piece;
  if (element_seconds_ == 0.0 && !net.elements.empty()) {
    const std::span<const base::ElementId> sample =
        std::span(net.elements).first(std::min(sample_size, net.elements.size()));
    fe::assemble_stiffness(request.model, request.mesh, sample, {}, net.map); // warms up
    const base::Stopwatch watch;
    fe::assemble_stiffness(request.model, request.mesh, sample, {}, net.map);
    element_seconds_ = watch.cpu_time() / static_cast<double>(sample.size());
  }
  std::vector<std::vector<std::int32_t>> supers;
  const std::vector<solve::CondensedNetBlock> blocks = blocks_of(piece, supers);
  const bool apart = analysis::keeps_parts_as_dense_blocks(net.map, blocks);
  if (apart) {
    supers.clear();
  }
  const solve::SparseRightHandSides rows =
      net.weighed.empty() ? solve::SparseRightHandSides() : rows_on_net(request, net);
  const solve::CondensationSettings settings = analysis::condensation_settings(request);
  const base::SymmetricCsc pattern =
      fe::stiffness_pattern(request.mesh, net.elements, supers, net.map);
  return apart
             ? solve::Condensation::forecast(
                   pattern, net.map.external_count(), blocks,
                   analysis::externals_can_stay_factorised(*body) ? &early_[*first_part] : nullptr,
                   settings)
             : solve::Condensation::forecast(pattern, net.map.external_count(), settings,
                                             net.weighed.empty() ? nullptr : &rows);
}

solve::FactorReport CostForecast::estimate(const analysis::CondensationRequest& request,
                                           const NetToForecast& piece) {
  const analysis::Substructure& net = piece.net;
  if (element_seconds_ == 0.0 && !net.elements.empty()) {
    element_seconds_ = matrix_entry_time * element_matrix_entries(request.mesh, net) /
                       static_cast<double>(net.elements.size());
  }
  std::vector<std::vector<std::int32_t>> freedoms;
  std::size_t condensed = 0;
  for (const solve::CondensedNetBlock& block : blocks_of(piece, freedoms)) {
    condensed += static_cast<std::size_t>(
        std::ranges::count_if(block.rows, [](std::int64_t row) { return row >= 0; }));
  }
  solve::NetOutline outline = outline_net(request.mesh, net, condensed);
  if (!net.weighed.empty()) {
    outline.rows = static_cast<double>(rows_on_net(request, net).count());
  }
  solve::FactorReport report = solve::estimate_factor(outline);
  solve::choose_engine_by_law(report, analysis::condensation_settings(request));
  return report;
}

const solve::FactorReport& CostForecast::report_of(const analysis::CondensationRequest& request,
                                                   const NetToForecast& piece, Needs& needs) {
  const auto at = known_.find(piece.key);
  if (at != known_.end()) {
    ++needs.reused;
    return at->second;
  }
  const analysis::Substructure& net = piece.net;
  const solve::FactorReport report =
      settings_.exact ? analyse(request, piece) : estimate(request, piece);
  ++needs.condensed;
  needs.unknowns += net.map.freedom.size();
  needs.flops += report.flops;
  needs.entries += report.factor_entries;
  needs.seconds += report.analysis_cpu +
                   element_seconds_ * static_cast<double>(net.elements.size()) +
                   solve::forecast_numeric_seconds(report, settings_.rate);
  if (report.engine != solve::EquationEngine::cholesky || !report.engine_reason.empty()) {
    needs.engines.push_back(describe_engine(piece, report));
  }
  needs.passing.push_back(report.memory - report.kept_memory);
  return known_.emplace(piece.key, report).first->second;
}

// What tells nets apart. By content it takes longer than the law: only where a later length may
// find one again.
std::vector<analysis::SubstructureHashes>
CostForecast::keys_of(const analysis::CondensationRequest& request,
                      const std::vector<analysis::SubstructuredBody>& bodies) const {
  if (settings_.exact || settings_.several_lengths) {
    return analysis::hash_bodies(request, bodies);
  }
  std::vector<analysis::SubstructureHashes> keys(bodies.size());
  std::uint64_t number = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    keys[b].region = {0, ++number};
    for (std::size_t p = 0; p < bodies[b].parts.size(); ++p) {
      keys[b].parts.emplace_back(0, ++number);
    }
  }
  return keys;
}

// Dense algebra of the condensed bodies: Cholesky of S, compliances of the rows, and a few
// factorisations of the closed rows for each step.
double CostForecast::contact_flops(const std::vector<analysis::SubstructuredBody>& bodies,
                                   const analysis::Discretisation& scene) const {
  const auto rows = static_cast<double>(scene.table.size());
  double flops = 0.0;
  for (const analysis::SubstructuredBody& body : bodies) {
    const double m = body.is_uncondensed() ? 0.0 : externals_of(body.region);
    flops += m * m * m / 3.0 + m * m * rows + m * rows * rows;
  }
  constexpr double factorisations = 4.0;
  return flops +
         factorisations * static_cast<double>(model_.steps.size()) * rows * rows * rows / 3.0;
}

void CostForecast::forecast_crack_length(const analysis::CondensationRequest& request,
                                         const std::vector<analysis::SubstructuredBody>& bodies,
                                         const analysis::Discretisation& scene, double scene_cpu,
                                         results::CrackLengthPreview& length) {
  if (resident_ == 0.0) {
    resident_ = static_cast<double>(base::resident_memory());
  }
  const std::vector<analysis::SubstructureHashes> keys = keys_of(request, bodies);
  Needs needs;
  double contact_solution_memory = 0.0;
  const auto rows = static_cast<double>(scene.table.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const analysis::SubstructuredBody& body = bodies[b];
    for (std::size_t p = 0; p < body.parts.size(); ++p) {
      const double m = externals_of(*body.parts[p]);
      const solve::FactorReport& part =
          report_of(request, {*body.parts[p], keys[b].parts[p], nullptr, nullptr}, needs);
      needs.kept += part.kept_memory + 2.0 * number * m * m; // its S, and the copy in the region
      needs.solve_entries += part.factor_entries;
    }
    const analysis::HashKey* first = keys[b].parts.empty() ? nullptr : &keys[b].parts.front();
    const solve::FactorReport& own =
        report_of(request, {body.region, keys[b].region, &body, first}, needs);
    const double m = externals_of(body.region);
    needs.kept += own.kept_memory + number * m * m;
    needs.solve_entries += own.factor_entries;
    needs.row_flops += own.row_flops;
    length.externals += static_cast<std::size_t>(m);
    const double others = body.is_uncondensed() ? own.row_memory : 3.0 * number * m * rows;
    // Those of all bodies so far, and of this one.
    contact_solution_memory =
        std::max(contact_solution_memory, others + 2.0 * number * rows * rows);
  }
  contact_solution_memory =
      std::max(contact_solution_memory, analysis::contact_solution_memory(request.rows));

  const double n = nodal_vector(scene.cracked.mesh);
  const auto steps = static_cast<double>(model_.steps.size());
  const auto elements = static_cast<double>(scene.cracked.mesh.element_count());
  std::sort(needs.passing.rbegin(), needs.passing.rend());
  const std::size_t at_once =
      std::min(needs.passing.size(), static_cast<std::size_t>(std::max(1, settings_.threads)));
  const double factorising = std::accumulate(
      needs.passing.begin(), needs.passing.begin() + static_cast<std::ptrdiff_t>(at_once), 0.0);
  // Error bars of K: element matrices of the modes, adjoints and what they are made of.
  const auto fronts = static_cast<double>(scene.cracked.fronts.size());
  const bool barred =
      fronts > 0.0 && estimate::enrichment_obstacle(request.model, scene.cracked.mesh).empty();
  const double modes = barred ? estimate::enrichment_memory(scene.cracked.mesh) : 0.0;
  const double estimating = barred ? modes + 8.0 * fronts * n : 0.0;
  const double solving = contact_solution_memory + 12.0 * n + estimating;
  kept_results_ += results_bytes(scene.cracked.mesh, model_.steps.size());

  length.engines = needs.engines;
  length.condensed = needs.condensed;
  length.reused = needs.reused;
  length.unknowns = needs.unknowns;
  length.flops = needs.flops;
  length.factor_entries = needs.entries;
  length.memory =
      resident_ + needs.kept + kept_results_ + std::max(kept_modes_ + factorising, solving);
  kept_modes_ = model_.growth ? modes : 0.0;
  length.seconds = needs.seconds + scene_cpu +
                   (contact_flops(bodies, scene) + needs.row_flops) /
                       settings_.rate.at(contact_width * settings_.rate.half + 1.0) +
                   steps * 4.0 * needs.solve_entries / settings_.rate.at(solve_width) +
                   element_seconds_ * elements * (step_share * steps + output_share);

  std::set<analysis::HashKey> used;
  for (const analysis::SubstructureHashes& key : keys) {
    used.insert(key.region);
    used.insert(key.parts.begin(), key.parts.end());
  }
  std::erase_if(known_, [&](const auto& entry) { return !used.contains(entry.first); });
  std::erase_if(early_, [&](const auto& entry) { return !used.contains(entry.first); });
}

} // namespace spricka::program
