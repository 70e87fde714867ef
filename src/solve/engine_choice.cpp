// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/engine_choice.hpp"
#include "base/clock.hpp"
#include "base/memory.hpp"
#include "solve/engine_module.hpp"
#include "solve/equation_ranks.hpp"
#include "solve/multigrid_law.hpp"
#include "solve/scratch_folder.hpp"
#include "solve/sparse_condensation.hpp"
#include "solve/unsolved_equations.hpp"

#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <string>

#include <fmt/format.h>

namespace spricka::solve {

namespace {

/// Engines that need less memory than Cholesky in core, the next best first.
constexpr std::array engines_for_less_memory{EngineModule::mumps, EngineModule::multigrid};

// Of the memory in core what MUMPS takes with its factor on disk: measured on cubes of 1e5
// unknowns.
constexpr double share_out_of_core = 0.45;

// An operation of an iteration waits for memory, one of a factorisation does not: measured on cubes
// of 1e5 and 3e5 unknowns, 2.3 against 40 Gflop/s.
constexpr double factor_flops_of_iteration_flop = 16.0;
// Of fewer unknowns no engine takes long enough to be chosen.
constexpr std::int64_t fewest_unknowns_to_iterate = 30000;

EngineModule module_of(EquationEngine engine) {
  assert(engine == EquationEngine::mumps || engine == EquationEngine::multigrid);
  return engine == EquationEngine::mumps ? EngineModule::mumps : EngineModule::multigrid;
}

CondensationSettings with_scratch_folder(const CondensationSettings& settings,
                                         EngineModule module) {
  CondensationSettings own = settings;
  if (own.scratch_folder.empty() && module == EngineModule::mumps) {
    own.scratch_folder = scratch_folder();
  }
  return own;
}

std::string memory_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", 1e-6 * bytes)
                     : fmt::format("{:.1f} GB", 1e-9 * bytes);
}

bool fits(const FactorReport& report) {
  return report.memory + report.besides <= report.memory_left;
}

std::string why_not_in_core(const FactorReport& in_core) {
  return fmt::format("in core would need {}, {} can be had",
                     memory_text(in_core.memory + in_core.besides),
                     memory_text(in_core.memory_left));
}

std::string too_much_for_all(const FactorReport& in_core) {
  return fmt::format("too much, as {} can be had; {}", memory_text(in_core.memory_left),
                     in_core.trouble);
}

/// Why a further engine is no help either.
std::string why_not(const FactorReport& report, EngineModule module) {
  if (report.status == FactorStatus::out_of_memory) {
    const char* const engine = module == EngineModule::mumps ? "MUMPS out of core" : "multigrid";
    return report.memory == 0.0 ? fmt::format("{} has no memory to begin", engine)
                                : fmt::format("{} would need {}", engine,
                                              memory_text(report.memory + report.besides));
  }
  return report.trouble;
}

void add_reason(std::string& reasons, const std::string& more) {
  reasons += (reasons.empty() || more.empty() ? "" : "; ") + more;
}

// No other engine has what Cholesky has not: a matrix that is singular stays so.
bool may_another_engine_do(const FactorReport& report) {
  return report.status == FactorStatus::out_of_memory ||
         report.status == FactorStatus::engine_failed;
}

/// What a factorisation may take before iterations take less. Ranks do not iterate: which engine a
/// net has must not hang on which of them has the net.
double factor_flops_worth_iterating(const base::SymmetricCsc& K, std::int64_t externals,
                                    const CondensationSettings& settings) {
  if (settings.engine != EquationEngine::automatic || settings.solutions == 0.0 ||
      K.n < fewest_unknowns_to_iterate || equation_ranks() != nullptr ||
      !is_engine_module_installed(EngineModule::multigrid)) {
    return std::numeric_limits<double>::infinity();
  }
  return factor_flops_of_iteration_flop * estimate_multigrid(K, externals, settings, nullptr).flops;
}

std::string why_iterations(const FactorReport& factor) {
  return fmt::format("takes less time than a factor of {:.2g} operations", factor.flops);
}

/// Cholesky in core, on the rank that is to do it; K comes back where it has not the memory, or
/// takes too many operations.
std::unique_ptr<CondensedEquations> condense_in_core(base::SymmetricCsc& K, std::int64_t externals,
                                                     const CondensationSettings& settings) {
  EquationRanks* const ranks = equation_ranks();
  if (ranks != nullptr && condenses_elsewhere()) {
    return ranks->condense_elsewhere(K, externals, settings);
  }
  const std::int64_t unknowns = K.n;
  auto own = std::make_unique<SparseCondensation>(std::move(K), externals, settings);
  if (may_another_engine_do(own->report())) {
    K = own->give_back_matrix();
  }
  if (ranks != nullptr) {
    ranks->count_own_net(unknowns, own->report(), resident_beside(own->report()));
  }
  return own;
}

double memory_of(const base::SymmetricCsc& K) {
  return static_cast<double>(K.start.size() * sizeof(K.start[0]) + K.row.size() * sizeof(K.row[0]) +
                             K.value.size() * sizeof(K.value[0]));
}

/// By a module; MUMPS by all ranks together where the run has several.
std::unique_ptr<CondensedEquations> condense_by_other_engine(EngineModule module,
                                                             base::SymmetricCsc& K,
                                                             std::int64_t externals,
                                                             const CondensationSettings& settings) {
  EquationRanks* const ranks = equation_ranks();
  if (ranks != nullptr && module == EngineModule::mumps) {
    return ranks->condense_together(K, externals, settings);
  }
  const std::int64_t unknowns = K.n;
  const bool opened = why_engine_module_is_missing(module).empty(); // its libraries are no forecast
  const double others = opened ? static_cast<double>(base::resident_memory()) - memory_of(K) : 0.0;
  std::unique_ptr<CondensedEquations> own = condense_by_module(module, K, externals, settings);
  if (ranks != nullptr) {
    ranks->count_own_net(unknowns, own->report(), others);
  }
  return own;
}

/// Whether a body is still one for iterations; the reason of the settings says why it is not.
enum class Iterations { possible, refused };

/// Cholesky, or where it does not fit or takes too many operations what needs less.
std::unique_ptr<CondensedEquations>
condense_by_what_fits(base::SymmetricCsc K, std::int64_t externals,
                      const CondensationSettings& settings,
                      Iterations iterations = Iterations::possible) {
  std::unique_ptr<CondensedEquations> cholesky = condense_in_core(K, externals, settings);
  if (cholesky->report().status == FactorStatus::engine_failed) {
    CondensationSettings own = settings;
    own.engine_reason = why_iterations(cholesky->report());
    own.most_flops = std::numeric_limits<double>::infinity();
    cholesky.reset();
    std::unique_ptr<CondensedEquations> next =
        condense_by_module(EngineModule::multigrid, K, externals, own);
    if (!may_another_engine_do(next->report()) || K.n == 0) {
      return next;
    }
    // It has found that the body takes more iterations than others do; or its library is missing,
    // and that is no news.
    own.engine_reason = is_engine_module_installed(EngineModule::multigrid)
                            ? why_not(next->report(), EngineModule::multigrid)
                            : "";
    next.reset();
    return condense_by_what_fits(std::move(K), externals, own, Iterations::refused);
  }
  if (settings.engine == EquationEngine::cholesky ||
      cholesky->report().status != FactorStatus::out_of_memory) {
    return cholesky;
  }
  FactorReport in_core = cholesky->report();
  cholesky.reset();
  base::return_free_memory_to_system();
  for (const EngineModule module : engines_for_less_memory) {
    if (K.n == 0) {
      break; // none has given it back
    }
    if (module == EngineModule::multigrid && iterations == Iterations::refused) {
      add_reason(in_core.trouble, settings.engine_reason);
      continue;
    }
    CondensationSettings own = with_scratch_folder(settings, module);
    add_reason(own.engine_reason, why_not_in_core(in_core));
    add_reason(own.engine_reason, in_core.trouble);
    std::unique_ptr<CondensedEquations> next = condense_by_other_engine(module, K, externals, own);
    if (!may_another_engine_do(next->report())) {
      return next;
    }
    add_reason(in_core.trouble, why_not(next->report(), module));
  }
  return std::make_unique<UnsolvedEquations>(std::move(in_core));
}

} // namespace

std::unique_ptr<CondensedEquations> condense_equations(base::SymmetricCsc K, std::int64_t externals,
                                                       const CondensationSettings& settings) {
  if (settings.engine == EquationEngine::mumps || settings.engine == EquationEngine::multigrid) {
    const EngineModule module = module_of(settings.engine);
    return condense_by_other_engine(module, K, externals, with_scratch_folder(settings, module));
  }
  CondensationSettings own = settings;
  own.most_flops = factor_flops_worth_iterating(K, externals, settings);
  return condense_by_what_fits(std::move(K), externals, own);
}

FactorReport forecast_equations(const base::SymmetricCsc& pattern, std::int64_t externals,
                                const CondensationSettings& settings,
                                const SparseRightHandSides* rows) {
  if (settings.engine == EquationEngine::mumps || settings.engine == EquationEngine::multigrid) {
    base::SymmetricCsc given_up = pattern;
    return forecast_by_module(module_of(settings.engine), given_up, externals, settings, rows);
  }
  FactorReport in_core = SparseCondensation::forecast(pattern, externals, settings, rows);
  in_core.memory_left = base::available_memory();
  in_core.besides = settings.besides;
  if (in_core.flops > factor_flops_worth_iterating(pattern, externals, settings) &&
      why_engine_module_is_missing(EngineModule::multigrid).empty()) {
    FactorReport next = estimate_multigrid(pattern, externals, settings, rows);
    next.engine_reason = why_iterations(in_core);
    return next;
  }
  if (settings.engine == EquationEngine::cholesky ||
      (in_core.status == FactorStatus::ok && fits(in_core))) {
    return in_core;
  }
  base::return_free_memory_to_system();
  for (const EngineModule module : engines_for_less_memory) {
    base::SymmetricCsc given_up = pattern;
    FactorReport next = forecast_by_module(module, given_up, externals, settings, rows);
    if (!may_another_engine_do(next)) {
      next.engine_reason = why_not_in_core(in_core);
      return next;
    }
    add_reason(in_core.trouble, why_not(next, module));
  }
  in_core.engine_reason = too_much_for_all(in_core);
  return in_core;
}

void choose_engine_by_law(FactorReport& report, const CondensationSettings& settings) {
  report.besides = settings.besides;
  report.memory_left = base::available_memory();
  const bool asked = settings.engine == EquationEngine::mumps;
  const bool may_choose = settings.engine == EquationEngine::automatic;
  if ((!asked && !may_choose) || (may_choose && fits(report))) {
    return;
  }
  FactorReport on_disk = report;
  on_disk.engine = EquationEngine::mumps;
  if (!fits(report)) {
    on_disk.out_of_core = true;
    on_disk.engine_reason = why_not_in_core(report);
    on_disk.memory = share_out_of_core * report.memory;
    on_disk.kept_memory = 0.0;
    on_disk.disk = 8.0 * report.factor_entries;
  }
  report.trouble = why_engine_module_is_missing(EngineModule::mumps);
  if (report.trouble.empty()) {
    report = std::move(on_disk);
  } else {
    report.engine_reason = fits(report) ? report.trouble : too_much_for_all(report);
  }
}

double forecast_numeric_seconds(const FactorReport& report, const FlopRate& rate) {
  if (report.engine == EquationEngine::multigrid) {
    return factor_flops_of_iteration_flop * report.flops / rate.measured;
  }
  return report.factor_entries > 0.0 ? report.flops / rate.at(report.flops / report.factor_entries)
                                     : 0.0;
}

std::string engine_text(const FactorReport& report) {
  switch (report.engine) {
  case EquationEngine::mumps:
    return report.out_of_core ? "MUMPS out of core" : "MUMPS";
  case EquationEngine::multigrid:
    return fmt::format(
        "conjugate gradients with multigrid{}",
        report.relative_error > 0.0
            ? fmt::format(", error at most {:.0e} of the strain energy norm", report.relative_error)
            : "");
  case EquationEngine::automatic:
  case EquationEngine::cholesky:
    break;
  }
  return "Cholesky";
}

std::string explain_engine(const FactorReport& report) {
  if (report.engine == EquationEngine::cholesky && report.engine_reason.empty()) {
    return {};
  }
  return engine_text(report) + (report.engine_reason.empty() ? "" : ": ") + report.engine_reason;
}

} // namespace spricka::solve
