// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/serve_rank.hpp"
#include "base/clock.hpp"
#include "solve/condensed_equations.hpp"
#include "solve/rank_messages.hpp"
#include "solve/sparse_condensation.hpp"

#include <map>
#include <memory>
#include <new>
#include <optional>
#include <utility>

namespace spricka::solve {

namespace {

/// The factors that a rank keeps for rank 0.
class RankFactors {
public:
  explicit RankFactors(RankMessages& root) : root_(root) {}

  void condense() {
    const auto number = root_.get<std::int64_t>();
    CondensationSettings settings;
    settings.ordering = root_.get<OrderingMethod>();
    settings.threads = root_.get<int>();
    const auto externals = root_.get<std::int64_t>();
    base::SymmetricCsc K;
    K.n = root_.get<std::int64_t>();
    K.start = root_.get_list<std::vector<std::int64_t>>();
    K.row = root_.get_list<std::vector<std::int64_t>>();
    K.value = root_.get_list<std::vector<double>>();
    auto equations = std::make_unique<SparseCondensation>(std::move(K), externals, settings);
    put_report(root_, equations->report());
    root_.put_matrix(equations->take_schur());
    if (equations->report().status == FactorStatus::ok) {
      factor_.emplace(number, std::move(equations));
    }
  }

  void condense_load() {
    const CondensedEquations& of = asked();
    const base::Matrix f = root_.get_matrix();
    answer([&] { return of.condense_load(f); },
           [&](const base::Matrix& condensed) { root_.put_matrix(condensed); });
  }

  void recover() {
    const CondensedEquations& of = asked();
    const base::Matrix f = root_.get_matrix();
    const base::Matrix u_external = root_.get_matrix();
    answer([&] { return of.recover(u_external, f); },
           [&](const base::Matrix& u) { root_.put_matrix(u); });
  }

  void find_compliance() {
    const SparseCondensation& of = asked();
    SparseRightHandSides F;
    F.start = root_.get_list<std::vector<std::int64_t>>();
    F.row = root_.get_list<std::vector<std::int64_t>>();
    F.value = root_.get_list<std::vector<double>>();
    double memory = 0.0;
    answer(
        [&] {
          memory = of.compliance_memory(F);
          return of.compliance_with_externals_held(std::move(F));
        },
        [&](const RowCompliance& found) {
          root_.put_matrix(found.W);
          root_.put_matrix(found.condensed);
          root_.put(found.flops);
          root_.put(memory);
        });
  }

  void release() { factor_.erase(root_.get<std::int64_t>()); }

private:
  [[nodiscard]] const SparseCondensation& asked() const {
    return *factor_.at(root_.get<std::int64_t>());
  }

  // Whether there was memory for the answer, then the answer.
  template <typename Find, typename Put> void answer(const Find& find, const Put& put) {
    std::optional<decltype(find())> found;
    try {
      found.emplace(find());
    } catch (const std::bad_alloc&) {
      found.reset();
    }
    root_.put(found.has_value());
    if (found) {
      put(*found);
    }
  }

  RankMessages& root_;
  std::map<std::int64_t, std::unique_ptr<SparseCondensation>> factor_;
};

} // namespace

int serve_rank(Communicator& communicator) {
  RankMessages root(communicator, 0);
  root.put_list(communicator.machine_name());
  root.put(static_cast<double>(base::resident_memory()));
  RankFactors factors(root);
  for (;;) {
    switch (root.get<RankOrder>()) {
    case RankOrder::condense:
      factors.condense();
      break;
    case RankOrder::condense_load:
      factors.condense_load();
      break;
    case RankOrder::recover:
      factors.recover();
      break;
    case RankOrder::compliance:
      factors.find_compliance();
      break;
    case RankOrder::release:
      factors.release();
      break;
    case RankOrder::step: {
      const auto matrix = root.get<std::int64_t>();
      communicator.join_step(matrix, static_cast<int>(root.get<std::int64_t>()));
      break;
    }
    case RankOrder::report_use:
      root.put(static_cast<double>(base::peak_memory()));
      root.put(base::cpu_seconds());
      root.put(communicator.memory_of_steps());
      break;
    case RankOrder::end:
      return root.get<int>();
    }
  }
}

} // namespace spricka::solve
