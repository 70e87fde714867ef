// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/condense_bodies.hpp"

#include "analysis/bodies/locate_unknowns.hpp"
#include "analysis/bodies/net_work.hpp"
#include "base/clock.hpp"
#include "base/parallel.hpp"
#include "model/model.hpp"
#include "solve/engine_choice.hpp"
#include "solve/equation_ranks.hpp"
#include "solve/factor_checks.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <span>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Rows of a nodal matrix [dim * node, k] by freedom, those before `from` left out.
base::Matrix rows_of(const base::Matrix& nodal, const std::vector<std::int32_t>& freedom,
                     std::size_t from = 0) {
  base::Matrix out(static_cast<Eigen::Index>(freedom.size() - from), nodal.cols());
  for (std::size_t i = from; i < freedom.size(); ++i) {
    out.row(static_cast<Eigen::Index>(i - from)) = nodal.row(freedom[i]);
  }
  return out;
}

// Displacements within this are as good as round-off leaves those of slender bodies, whatever
// solves their equations: no word about them.
constexpr double exact_enough = 1e-6;

struct Task {
  Substructure* net = nullptr;
  results::NetCost work;
  std::vector<fe::Superelement> supers;
  HashKey key;
  bool layered = false; ///< its externals may stay a factor
  std::shared_ptr<const solve::FirstBlockFactor> early;
  double stiffness_wall = 0.0; ///< [s]
};

// Grows as the flops of nested dissection do: the cube of the largest separator (George 1973). Only
// to compare nets with each other.
double likely_cost(std::int64_t unknowns, int dim) {
  return std::pow(static_cast<double>(unknowns), 3.0 * (1.0 - 1.0 / dim));
}

// Threads of each net by its part of the cost of all, so that the largest does not keep one thread
// busy while the others wait.
std::vector<int> share_threads(const std::vector<double>& cost, int threads) {
  // Nets without unknowns cost nothing, and may be all there are.
  const double sum = std::max(1.0, std::accumulate(cost.begin(), cost.end(), 0.0));
  std::vector<int> share;
  share.reserve(cost.size());
  for (const double own : cost) {
    share.push_back(std::clamp(static_cast<int>(std::ceil(threads * own / sum)), 1, threads));
  }
  return share;
}

// Factorises the nets that the cache does not have; tasks write to their own slots only.
void factorise(const CondensationRequest& request, std::vector<Task>& tasks,
               CondensationCache& cache, CondensationStatistics& log) {
  std::vector<Task*> missing;
  for (Task& task : tasks) {
    const auto known = cache.nets.find(task.key);
    if (known != cache.nets.end()) {
      task.net->factor = known->second;
      task.work.reused = true;
      ++log.reused;
    } else {
      missing.push_back(&task);
    }
  }
  const std::thread::id main_thread = std::this_thread::get_id();
  // What takes longest is begun first.
  std::ranges::stable_sort(missing, std::greater{},
                           [](const Task* task) { return task->net->map.size(); });
  std::vector<double> cost;
  cost.reserve(missing.size());
  for (const Task* task : missing) {
    cost.push_back(likely_cost(task->net->map.size(), request.mesh.dim));
  }
  const std::vector<int> threads = share_threads(cost, request.threads);
  solve::for_each_on_ranks(cost, request.threads, [&](std::size_t i) {
    Task& task = *missing[i];
    const base::ThreadShare share(threads[i]);
    const base::Stopwatch watch;
    const double cpu = solve::thread_cpu_seconds();
    task.work.beside = std::this_thread::get_id() != main_thread;
    task.work.begin = watch.start_time();
    const fe::DofMap& map = task.net->map;
    std::vector<solve::CondensedNetBlock> blocks;
    for (const fe::Superelement& super : task.supers) {
      blocks.push_back({equation_numbers(map, super.freedom), super.stiffness});
    }
    const bool stacked = keeps_parts_as_dense_blocks(map, blocks);
    base::SymmetricCsc K =
        fe::assemble_stiffness(request.model, request.mesh, task.net->elements,
                               stacked ? std::span<const fe::Superelement>() : task.supers, map);
    task.stiffness_wall = watch.wall_time();
    task.work.stiffness_cpu = solve::thread_cpu_seconds() - cpu;
    task.work.assembled = base::steady_clock_seconds();
    solve::CondensationSettings settings = condensation_settings(request);
    settings.threads = threads[i];
    const solve::UnknownPlaces places = locate_unknowns(request.mesh, map);
    const base::Matrix loads = rows_of(request.case_load, map.freedom);
    settings.places = &places;
    settings.loads = &loads;
    task.net->factor =
        stacked
            ? std::make_shared<solve::Condensation>(K, map.external_count(), blocks,
                                                    task.layered ? &task.early : nullptr, settings)
            : std::make_shared<solve::Condensation>(std::move(K), map.external_count(), settings);
    task.work.end = base::steady_clock_seconds();
  });
  for (const Task* task : missing) {
    const solve::FactorReport& report = task->net->factor->report();
    log.stiffness_cpu += task->stiffness_wall;
    log.analysis_cpu += report.analysis_cpu;
    log.numeric_cpu += report.numeric_cpu;
    log.flops += report.flops;
    ++log.condensed;
    if (report.relative_error > exact_enough) {
      log.inexact.push_back(fmt::format("{} was solved by {} to {:.1g} of its displacements",
                                        task->work.name, solve::engine_text(report),
                                        report.relative_error));
    }
    if (report.status == solve::FactorStatus::ok) {
      cache.nets.emplace(task->key, task->net->factor);
    }
  }
  for (Task& task : tasks) {
    add_factor_sizes(task.net->map, task.net->factor->report(), task.work);
    log.nets.push_back(std::move(task.work));
  }
}

base::OptionalFailure trouble_of(const model::Mesh& mesh, const std::string& body,
                                 const Substructure& net) {
  const solve::FactorReport& report = net.factor->report();
  const auto not_solvable = [](std::string why) {
    return base::OperationFailure{.kind = base::ProgramOutcome::not_solvable,
                                  .why = std::move(why)};
  };
  switch (report.status) {
  case solve::FactorStatus::ok:
    return {};
  case solve::FactorStatus::out_of_memory:
    return not_solvable(fmt::format(
        "{}: its factor needs {:.0f} MB of memory ({} unknowns, {:.2g} entries){}, {:.0f} MB can "
        "be had{}",
        body, 1e-6 * report.memory, net.map.size(), report.factor_entries,
        report.besides > 0.02 * report.memory
            ? fmt::format(" and the rows of contact {:.0f} MB", 1e-6 * report.besides)
            : "",
        1e-6 * report.memory_left, report.trouble.empty() ? "" : "; " + report.trouble));
  case solve::FactorStatus::engine_failed:
    return not_solvable(fmt::format("{}: {}", body, report.trouble));
  case solve::FactorStatus::not_positive_definite:
    break;
  }
  if (report.failed_row < 0) {
    return not_solvable(fmt::format("{}: the stiffness is singular (a mechanism?)", body));
  }
  const auto freedom =
      static_cast<std::size_t>(net.map.freedom[static_cast<std::size_t>(report.failed_row)]);
  const auto dim = static_cast<std::size_t>(mesh.dim);
  return not_solvable(
      fmt::format("{}: the stiffness is singular at node {}, direction {} (a mechanism or a "
                  "part that hangs on one node)",
                  body, mesh.node_label[freedom / dim], "XYZ"[freedom % dim]));
}

std::span<const std::int32_t> external_freedoms(const fe::DofMap& map) {
  return std::span(map.freedom).subspan(static_cast<std::size_t>(map.locals));
}

// Externals of a part are unknowns of the region or follow some, by construction of split().
fe::Superelement super_of(const Substructure& part) {
  fe::Superelement super;
  const std::span<const std::int32_t> rim = external_freedoms(part.map);
  super.freedom.assign(rim.begin(), rim.end());
  super.stiffness = &part.factor->schur();
  return super;
}

// What this increment did not use, no later one will: its crack has grown on.
void forget_unused(const std::vector<Task>& parts, const std::vector<Task>& regions,
                   CondensationCache& cache) {
  // Keys of nets and bodies are one set: a body has that of its region, early rows that of their
  // part.
  std::set<HashKey> used;
  for (const std::vector<Task>* tasks : {&parts, &regions}) {
    for (const Task& task : *tasks) {
      used.insert(task.key);
    }
  }
  std::erase_if(cache.nets, [&](const auto& entry) { return !used.contains(entry.first); });
  std::erase_if(cache.bodies, [&](const auto& entry) { return !used.contains(entry.first); });
  std::erase_if(cache.early, [&](const auto& entry) { return !used.contains(entry.first); });
}

solve::SubstructuredFactor factor_of(const SubstructuredBody& body) {
  std::vector<solve::FactorisedPart> parts;
  for (const std::unique_ptr<Substructure>& part : body.parts) {
    parts.push_back({part->factor, part->map.locals,
                     equation_numbers(body.region.map, external_freedoms(part->map))});
  }
  return {std::move(parts), body.region.factor, body.region.map.size()};
}

void condense_loads(const CondensationRequest& request, SubstructuredBody& body) {
  CondensedLoad load = condense_load(body, *request.ties, request.case_load);
  body.part_load = std::move(load.part);
  body.region_load = std::move(load.region);
  body.external_load = std::move(load.external);
}

} // namespace

solve::CondensationSettings condensation_settings(const CondensationRequest& request) {
  // Stress intensity factors need a solution for each place of a front, contact one for each row.
  constexpr int modes_in_space = 6;
  const bool few_solutions = fe::rigid_mode_count(request.model) == modes_in_space &&
                             request.rows.empty() && request.model.contacts.empty() &&
                             request.model.cracks.empty();
  return {.engine = request.engine,
          .besides = contact_solution_memory(request.rows),
          .solutions = few_solutions ? static_cast<double>(request.model.cases.size()) : 0.0};
}

double contact_solution_memory(const std::vector<const contact::ConstraintRow*>& rows) {
  const bool rubs =
      std::ranges::any_of(rows, [](const contact::ConstraintRow* row) { return row->tangential; });
  const auto n = static_cast<double>(rows.size());
  return (rubs ? 4.0 : 3.0) * 8.0 * n * n;
}

std::vector<std::int64_t> equation_numbers(const fe::DofMap& map,
                                           std::span<const std::int32_t> freedom) {
  std::vector<std::int64_t> rows;
  rows.reserve(freedom.size());
  for (const std::int32_t f : freedom) {
    rows.push_back(map.row[static_cast<std::size_t>(f)]);
  }
  return rows;
}

bool keeps_parts_as_dense_blocks(const fe::DofMap& map,
                                 std::span<const solve::CondensedNetBlock> blocks) {
  return !map.ties && solve::is_two_level_cheaper(blocks, map.size(), map.external_count());
}

bool externals_can_stay_factorised(const SubstructuredBody& body) {
  return body.parts.size() == 1 && body.free_rigid_modes.cols() == 0 && !body.is_uncondensed() &&
         body.region.map.external_count() > 0;
}

CondensedLoad condense_load(const SubstructuredBody& body, const fe::ConstraintTransformation& ties,
                            const base::Matrix& nodal) {
  CondensedLoad out;
  if (body.is_uncondensed()) {
    out.external = rows_of(nodal, body.contact_freedoms());
    return out;
  }
  out.region = rows_of(nodal, body.region.map.freedom);
  const auto add = [&](std::int32_t freedom, double c, const Eigen::RowVectorXd& load) {
    const std::int32_t row = body.region.map.row[static_cast<std::size_t>(freedom)];
    if (row >= 0) {
      out.region.row(row) += c * load;
    }
  };
  for (const std::unique_ptr<Substructure>& part : body.parts) {
    // What the part's locals hand over to its externals; their own loads are in already.
    const base::Matrix& load = out.part.emplace_back(rows_of(nodal, part->map.freedom));
    const base::Matrix condensed = part->factor->condense_load(load);
    const std::vector<std::int32_t>& freedom = part->map.freedom;
    const auto locals = static_cast<std::size_t>(part->map.locals);
    for (std::size_t i = locals; i < freedom.size(); ++i) {
      const Eigen::RowVectorXd more = condensed.row(static_cast<Eigen::Index>(i - locals)) -
                                      load.row(static_cast<Eigen::Index>(i));
      const fe::ConstraintTransformation::DependentRow* tie = ties.find_row(freedom[i]);
      if (tie == nullptr) {
        add(freedom[i], 1.0, more);
        continue;
      }
      for (const fe::FreedomTerm& t : tie->terms) {
        add(t.freedom, t.coefficient, more);
      }
    }
  }
  out.external = body.region.factor->condense_load(out.region);
  return out;
}

std::vector<SubstructuredBody> condense_bodies(const CondensationRequest& request,
                                               CondensationCache& cache,
                                               CondensationStatistics& log) {
  std::vector<SubstructuredBody> bodies = partition_bodies(request);

  // All hashes first: what no net asks for is forgotten before memory for the new ones is needed.
  const std::vector<SubstructureHashes> keys = hash_bodies(request, bodies);
  std::vector<Task> parts;
  std::vector<Task> regions;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t p = 0; p < bodies[b].parts.size(); ++p) {
      Task& part = parts.emplace_back();
      part.net = bodies[b].parts[p].get();
      part.key = keys[b].parts[p];
      part.work.name = substructure_name(request.model, request.mesh, bodies[b].name,
                                         {part.net->elements, bodies[b].region.elements});
    }
    Task& region = regions.emplace_back();
    region.net = &bodies[b].region;
    region.key = keys[b].region;
    region.layered = externals_can_stay_factorised(bodies[b]);
    region.work.name = bodies[b].name + (bodies[b].parts.empty() ? "" : ": region");
  }
  forget_unused(parts, regions, cache);

  factorise(request, parts, cache, log);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const std::unique_ptr<Substructure>& part : bodies[b].parts) {
      log.trouble = log.trouble ? log.trouble : trouble_of(request.mesh, bodies[b].name, *part);
      if (!log.trouble) {
        // A part's Schur complement enters the region as an element does.
        regions[b].supers.push_back(super_of(*part));
      }
    }
  }
  if (log.trouble) {
    return bodies;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (regions[b].layered) {
      // Rows that only the part has are eliminated once; they last as long as it does, whatever the
      // region becomes.
      regions[b].early = cache.early[keys[b].parts.front()];
    }
  }
  factorise(request, regions, cache, log);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (regions[b].early) {
      cache.early[keys[b].parts.front()] = regions[b].early;
    }
  }
  for (const SubstructuredBody& body : bodies) {
    log.trouble = log.trouble ? log.trouble : trouble_of(request.mesh, body.name, body.region);
  }
  if (log.trouble) {
    return bodies;
  }

  base::parallel_for(bodies.size(), request.threads, [&](std::size_t b) {
    SubstructuredBody& body = bodies[b];
    condense_loads(request, body);
    if (body.contact_unknown_count() > 0) {
      // A factor from the cache has given its Schur complement away: what was made of that is kept
      // too.
      const auto known = cache.bodies.find(regions[b].key);
      if (known != cache.bodies.end()) {
        body.condensed = known->second;
        return;
      }
      if (body.is_uncondensed()) {
        const std::vector<std::int32_t> all = body.contact_freedoms();
        body.condensed = std::make_shared<contact::CondensedBody>(
            all, contact::UncondensedBody{factor_of(body), body.region.weighed},
            rows_of(body.free_rigid_modes, all));
        return;
      }
      const std::vector<std::int32_t>& freedom = body.region.map.freedom;
      const auto locals = static_cast<std::size_t>(body.region.map.locals);
      std::vector<std::int32_t> external(freedom.begin() + body.region.map.locals, freedom.end());
      if (std::optional<solve::FactoredSchurComplement> factor =
              body.region.factor->take_factored_schur()) {
        body.condensed =
            std::make_shared<contact::CondensedBody>(std::move(external), std::move(*factor));
        return;
      }
      body.condensed = std::make_shared<contact::CondensedBody>(
          std::move(external), body.region.factor->take_schur(),
          rows_of(body.free_rigid_modes, freedom, locals));
    }
  });
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].condensed) {
      if (!bodies[b].condensed->is_factorised() && !log.trouble) {
        log.trouble = base::OperationFailure{
            .kind = base::ProgramOutcome::not_solvable,
            .why = fmt::format("{}: the condensed stiffness is singular (a mechanism?)",
                               bodies[b].name)};
      }
      cache.bodies.emplace(regions[b].key, bodies[b].condensed);
    }
  }
  if (!log.trouble) {
    base::parallel_for(bodies.size(), request.threads, [&](std::size_t b) {
      SubstructuredBody& body = bodies[b];
      if (body.is_uncondensed()) {
        // A step adds these up, where a condensed body has a small matrix to ask.
        body.case_motion = body.condensed->displacements_under_forces(body.external_load);
      }
    });
  }
  return bodies;
}

void recover_body_displacements(const SubstructuredBody& body, const base::Matrix& u_external,
                                const CondensedLoad& load, double constant, base::Matrix& u) {
  const base::Matrix own =
      body.is_uncondensed() ? u_external : body.region.factor->recover(u_external, load.region);
  const std::vector<std::int32_t> freedoms =
      body.is_uncondensed() ? body.contact_freedoms() : body.region.map.freedom;
  for (std::size_t i = 0; i < freedoms.size(); ++i) {
    u.row(freedoms[i]) = own.row(static_cast<Eigen::Index>(i));
  }
  // Dependent freedoms as prescribed ones and constants alone move them: the loads of a part have
  // this in them already (reduced_case_loads).
  const bool parts_follow = !body.parts.empty() && !body.is_uncondensed();
  const base::Matrix given = parts_follow ? u : base::Matrix();
  if (body.region.map.ties) {
    for (Eigen::Index k = 0; k < u.cols(); ++k) {
      body.region.map.ties->set_dependent_displacements(u.col(k), constant);
    }
  }
  for (std::size_t p = 0; parts_follow && p < body.parts.size(); ++p) {
    const Substructure& part = *body.parts[p];
    const std::vector<std::int32_t>& freedom = part.map.freedom;
    const auto locals = static_cast<std::size_t>(part.map.locals);
    base::Matrix rim(static_cast<Eigen::Index>(freedom.size() - locals), u.cols());
    for (std::size_t i = locals; i < freedom.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i - locals);
      // Externals of the part as the region, and the ties, have moved them.
      rim.row(row) = u.row(freedom[i]);
      if (body.region.map.ties && body.region.map.ties->find_row(freedom[i]) != nullptr) {
        rim.row(row) -= given.row(freedom[i]);
      }
    }
    const base::Matrix all = part.factor->recover(rim, load.part[p]);
    for (std::size_t i = 0; i < locals; ++i) {
      u.row(freedom[i]) = all.row(static_cast<Eigen::Index>(i));
    }
  }
}

void recover_body_displacements(const SubstructuredBody& body, const base::Vector& u_external,
                                const base::Vector& case_factors, base::Vector& u) {
  CondensedLoad load;
  if (!body.is_uncondensed()) {
    load.region = body.region_load * case_factors;
  }
  for (const base::Matrix& part : body.part_load) {
    load.part.emplace_back(part * case_factors);
  }
  base::Matrix all = u;
  // Where ties have constants the last column is theirs; else there is nothing that it could scale.
  recover_body_displacements(body, u_external, load,
                             case_factors.size() > 0 ? case_factors.tail(1)[0] : 0.0, all);
  u = all.col(0);
}

} // namespace spricka::analysis
