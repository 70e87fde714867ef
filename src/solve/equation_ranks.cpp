// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/equation_ranks.hpp"
#include "base/clock.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "solve/rank_messages.hpp"

#include <algorithm>
#include <cassert>
#include <new>
#include <numeric>
#include <utility>

namespace spricka::solve {

using base::at;

namespace {

EquationRanks* ranks_of_process = nullptr; // NOLINT: a process is in one run of mpirun
thread_local int rank_of_thread = 0;       // NOLINT: that condenses what this thread hands out

/// For its life this thread hands nets out to a rank.
class ThreadOfRank {
public:
  explicit ThreadOfRank(int rank) { rank_of_thread = rank; }
  ~ThreadOfRank() { rank_of_thread = 0; }
  ThreadOfRank(const ThreadOfRank&) = delete;
  ThreadOfRank& operator=(const ThreadOfRank&) = delete;
};

} // namespace

/// Equations whose factor another rank keeps.
class RemoteEquations final : public CondensedEquations {
public:
  RemoteEquations(EquationRanks& ranks, int rank, std::int64_t number, std::int64_t externals)
      : ranks_(ranks), rank_(rank), number_(number), externals_(externals) {}
  ~RemoteEquations() override {
    if (report_.status == FactorStatus::ok) {
      ranks_.release(rank_, number_, report_.kept_memory);
    }
  }
  RemoteEquations(const RemoteEquations&) = delete;
  RemoteEquations& operator=(const RemoteEquations&) = delete;

  void set_answer(FactorReport report, base::Matrix S) {
    report_ = std::move(report);
    S_ = std::move(S);
  }

  [[nodiscard]] const FactorReport& report() const override { return report_; }
  [[nodiscard]] base::Matrix take_schur() override { return std::exchange(S_, base::Matrix()); }

  [[nodiscard]] base::Matrix condense_load(const base::Matrix& f) const override {
    return ask(RankOrder::condense_load, f, nullptr);
  }

  [[nodiscard]] base::Matrix solve(const base::Matrix& f,
                                   const ExternalDisplacementSolver& displacement) const override {
    // The displacements may need other equations of the same rank, so it does not wait for them
    // with its first half done: that is done anew.
    base::Matrix u_external(0, f.cols());
    if (externals_ > 0) {
      u_external = displacement(condense_load(f));
    }
    return ask(RankOrder::recover, f, &u_external);
  }

  [[nodiscard]] RowCompliance
  compliance_with_externals_held(SparseRightHandSides F) const override {
    RowCompliance out;
    ranks_.converse(rank_, [&](RankMessages& other) {
      other.put(RankOrder::compliance);
      other.put(number_);
      other.put_list(F.start);
      other.put_list(F.row);
      other.put_list(F.value);
      throw_if_out_of_memory(other);
      out.W = other.get_matrix();
      out.condensed = other.get_matrix();
      out.flops = other.get<double>();
      ranks_.count_rows(rank_, other.get<double>());
    });
    return out;
  }

private:
  static void throw_if_out_of_memory(RankMessages& other) {
    if (!other.get<bool>()) {
      throw std::bad_alloc();
    }
  }

  [[nodiscard]] base::Matrix ask(RankOrder order, const base::Matrix& f,
                                 const base::Matrix* u_external) const {
    base::Matrix out;
    ranks_.converse(rank_, [&](RankMessages& other) {
      other.put(order);
      other.put(number_);
      other.put_matrix(f);
      if (u_external != nullptr) {
        other.put_matrix(*u_external);
      }
      throw_if_out_of_memory(other);
      out = other.get_matrix();
    });
    return out;
  }

  EquationRanks& ranks_;
  int rank_;
  std::int64_t number_;
  std::int64_t externals_;
  FactorReport report_;
  base::Matrix S_;
};

EquationRanks* equation_ranks() {
  return ranks_of_process;
}

void set_equation_ranks(EquationRanks* ranks) {
  ranks_of_process = ranks;
}

bool condenses_elsewhere() {
  return rank_of_thread > 0;
}

std::vector<int> distribute_by_cost(std::span<const double> cost, int ranks) {
  std::vector<std::size_t> order(cost.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return cost[a] > cost[b]; });
  std::vector<double> load(at(std::max(ranks, 1)), 0.0);
  std::vector<int> rank(cost.size(), 0);
  for (const std::size_t task : order) {
    const auto least = std::ranges::min_element(load);
    rank[task] = static_cast<int>(least - load.begin());
    *least += cost[task];
  }
  return rank;
}

void for_each_on_ranks(std::span<const double> cost, int threads,
                       const std::function<void(std::size_t)>& task) {
  if (ranks_of_process == nullptr) {
    base::parallel_for(cost.size(), threads, task);
    return;
  }
  const std::vector<int> rank_of = distribute_by_cost(cost, ranks_of_process->count());
  std::vector<std::vector<std::size_t>> of_rank(at(ranks_of_process->count()));
  for (std::size_t i = 0; i < cost.size(); ++i) {
    of_rank[at(rank_of[i])].push_back(i);
  }
  std::vector<int> lane; // each a thread's, by the rank that it works with
  for (int rank = 1; rank < ranks_of_process->count(); ++rank) {
    if (!of_rank[at(rank)].empty()) {
      lane.push_back(rank);
    }
  }
  const std::vector<std::size_t>& own = of_rank.front();
  lane.resize(lane.size() + std::min(own.size(), at(std::max(threads, 1))), 0);
  std::atomic<std::size_t> next_own = 0;
  base::parallel_for(lane.size(), static_cast<int>(lane.size()), [&](std::size_t k) {
    if (lane[k] == 0) {
      for (std::size_t i = next_own++; i < own.size(); i = next_own++) {
        task(own[i]);
      }
      return;
    }
    const ThreadOfRank works_with(lane[k]);
    for (const std::size_t i : of_rank[at(lane[k])]) {
      task(i);
    }
  });
}

double resident_beside(const FactorReport& report) {
  return static_cast<double>(base::resident_memory()) - report.kept_memory;
}

EquationRanks::EquationRanks(Communicator& communicator) : communicator_(communicator) {
  for (int rank = 0; rank < communicator.size(); ++rank) {
    Rank& entry = *ranks_.emplace_back(std::make_unique<Rank>());
    if (rank == 0) {
      entry.work.machine = communicator.machine_name();
      entry.memory_before = static_cast<double>(base::resident_memory());
    } else {
      // What serve_rank() says of itself when it begins.
      RankMessages other(communicator, rank);
      entry.work.machine = other.get_list<std::string>();
      entry.memory_before = other.get<double>();
    }
    entry.work.forecast_memory = entry.memory_before;
  }
}

EquationRanks::~EquationRanks() = default;

void EquationRanks::converse(int rank, const std::function<void(RankMessages&)>& talk) {
  const std::shared_lock apart(together_);
  const std::scoped_lock alone(ranks_[at(rank)]->asking);
  assert(!ended_);
  RankMessages other(communicator_, rank);
  talk(other);
}

std::unique_ptr<CondensedEquations>
EquationRanks::condense_elsewhere(const base::SymmetricCsc& K, std::int64_t externals,
                                  const CondensationSettings& settings) {
  const int rank = rank_of_thread;
  const std::int64_t number = next_++;
  auto equations = std::make_unique<RemoteEquations>(*this, rank, number, externals);
  converse(rank, [&](RankMessages& other) {
    other.put(RankOrder::condense);
    other.put(number);
    other.put(settings.ordering);
    other.put(settings.threads);
    other.put(externals);
    other.put(K.n);
    other.put_list(K.start);
    other.put_list(K.row);
    other.put_list(K.value);
    FactorReport report = get_report(other);
    base::Matrix S = other.get_matrix();
    if (report.status == FactorStatus::ok) {
      Rank& of = *ranks_[at(rank)];
      ++of.work.nets;
      of.work.unknowns += K.n;
      of.work.forecast_memory =
          std::max(of.work.forecast_memory, of.memory_before + of.kept + report.memory);
      of.kept += report.kept_memory;
    }
    report.engine_reason = settings.engine_reason;
    equations->set_answer(std::move(report), std::move(S));
  });
  return equations;
}

std::unique_ptr<CondensedEquations>
EquationRanks::condense_together(base::SymmetricCsc& K, std::int64_t externals,
                                 const CondensationSettings& settings) {
  const std::int64_t unknowns = K.n;
  std::unique_ptr<CondensedEquations> equations = communicator_.condense_together(
      K, externals, settings,
      [this](std::int64_t matrix, int job, const std::function<void()>& own_part) {
        take_step(matrix, job, own_part);
      });
  const FactorReport& report = equations->report();
  if (report.status == FactorStatus::ok) {
    count_own_net(unknowns, report, resident_beside(report));
    for (int rank = 0; rank < count(); ++rank) {
      const std::scoped_lock alone(ranks_[at(rank)]->asking);
      RankWork& work = ranks_[at(rank)]->work;
      work.nets += rank > 0 ? 1 : 0;
      work.unknowns += rank > 0 ? unknowns : 0;
      ++work.nets_of_all;
    }
  }
  return equations;
}

void EquationRanks::take_step(std::int64_t matrix, int job, const std::function<void()>& own_part) {
  const std::unique_lock alone(together_);
  if (ended_) {
    return; // nobody is there any more
  }
  for (int rank = 1; rank < count(); ++rank) {
    RankMessages other(communicator_, rank);
    other.put(RankOrder::step);
    other.put(matrix);
    other.put(static_cast<std::int64_t>(job));
  }
  own_part();
}

void EquationRanks::count_own_net(std::int64_t unknowns, const FactorReport& report,
                                  double others) {
  if (report.status != FactorStatus::ok) {
    return;
  }
  Rank& own = *ranks_.front();
  const std::scoped_lock alone(own.asking);
  ++own.work.nets;
  own.work.unknowns += unknowns;
  // While the factor is made it takes more than what is kept, and contact will.
  own.work.forecast_memory =
      std::max(own.work.forecast_memory,
               others + std::max(report.memory, report.kept_memory + report.besides));
}

void EquationRanks::count_rows(int rank, double memory) {
  Rank& of = *ranks_[at(rank)]; // it is being asked
  of.work.forecast_memory = std::max(of.work.forecast_memory, of.memory_before + of.kept + memory);
}

void EquationRanks::count_own_rows(double resident, double memory) {
  Rank& own = *ranks_.front();
  const std::scoped_lock alone(own.asking);
  own.work.forecast_memory = std::max(own.work.forecast_memory, resident + memory);
}

void EquationRanks::release(int rank, std::int64_t number, double kept) {
  if (ended_) {
    return;
  }
  converse(rank, [&](RankMessages& other) {
    other.put(RankOrder::release);
    other.put(number);
    ranks_[at(rank)]->kept -= kept;
  });
}

std::vector<RankWork> EquationRanks::work() {
  std::vector<RankWork> out;
  for (int rank = 0; rank < count(); ++rank) {
    Rank& of = *ranks_[at(rank)];
    double peak = static_cast<double>(base::peak_memory());
    double cpu = base::cpu_seconds();
    double steps = 0.0; // what its parts of factors of all ranks take, beside those of its own
    if (rank > 0) {
      converse(rank, [&](RankMessages& other) {
        other.put(RankOrder::report_use);
        peak = other.get<double>();
        cpu = other.get<double>();
        steps = other.get<double>();
      });
    }
    const std::scoped_lock alone(of.asking);
    out.push_back(of.work);
    out.back().peak_memory = peak;
    out.back().cpu = cpu;
    out.back().forecast_memory += steps;
  }
  return out;
}

void EquationRanks::end(int exit_code) {
  const std::unique_lock alone(together_);
  if (ended_.exchange(true)) {
    return;
  }
  for (int rank = 1; rank < count(); ++rank) {
    RankMessages other(communicator_, rank);
    other.put(RankOrder::end);
    other.put(exit_code);
  }
}

} // namespace spricka::solve
