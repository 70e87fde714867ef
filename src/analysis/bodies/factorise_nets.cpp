// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/factorise_nets.hpp"

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
#include <span>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

// Displacements within this are as good as round-off leaves those of slender bodies, whatever
// solves their equations: no word about them.
constexpr double exact_enough = 1e-6;

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

} // namespace

void factorise_nets(const CondensationRequest& request, std::vector<NetTask>& tasks,
                    CondensationCache& cache, CondensationStatistics& log) {
  std::vector<NetTask*> missing;
  for (NetTask& task : tasks) {
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
                           [](const NetTask* task) { return task->net->map.size(); });
  std::vector<double> cost;
  cost.reserve(missing.size());
  for (const NetTask* task : missing) {
    cost.push_back(likely_cost(task->net->map.size(), request.mesh.dim));
  }
  const std::vector<int> threads = share_threads(cost, request.threads);
  solve::for_each_on_ranks(cost, request.threads, [&](std::size_t i) {
    NetTask& task = *missing[i];
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
    const base::Matrix loads = rows_of_freedoms(request.case_load, map.freedom);
    settings.places = &places;
    settings.loads = &loads;
    task.net->factor =
        stacked
            ? std::make_shared<solve::Condensation>(K, map.external_count(), blocks,
                                                    task.layered ? &task.early : nullptr, settings)
            : std::make_shared<solve::Condensation>(std::move(K), map.external_count(), settings);
    task.work.end = base::steady_clock_seconds();
  });
  for (const NetTask* task : missing) {
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
  for (NetTask& task : tasks) {
    add_factor_sizes(task.net->map, task.net->factor->report(), task.work);
    log.nets.push_back(std::move(task.work));
  }
}

base::OptionalFailure factorisation_failure(const model::Mesh& mesh, const std::string& body,
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
    if (report.memory == 0.0) {
      return not_solvable(fmt::format("{}: no memory to begin with its factor ({} unknowns){}",
                                      body, net.map.size(),
                                      report.trouble.empty() ? "" : "; " + report.trouble));
    }
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

} // namespace spricka::analysis
