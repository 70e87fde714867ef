// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "archive/increment_store.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace spricka::archive {

/// Of an increment what a growth law needs to know: K of its fronts, at the steps and along load
/// paths. No mesh, no field, no contact.
results::CrackLengthResult copy_fronts_of_increment(const results::CrackLengthResult& increment);

/// Fronts of growths by one law after another, while the program runs.
class IncrementsInMemory final : public IncrementStore {
public:
  /// `stopped`: asked before each increment whether the run is to end there; may be empty.
  explicit IncrementsInMemory(std::function<bool()> stopped) : stopped_(std::move(stopped)) {}

  /// What a growth makes of the fronts that are kept.
  enum class GrowthOverFronts {
    goes_on,     ///< it is that of their law, and may go on behind them
    another_law, ///< they serve it as far as they can, then others take their places
    trial        ///< the same, but it ends where it would have to solve one: nothing is changed
  };
  void begin_growth(GrowthOverFronts use);
  /// The fronts of another path, for a growth that may go on from some of them.
  void copy_fronts(const IncrementsInMemory& other) { kept_ = other.kept_; }
  [[nodiscard]] std::size_t front_count() const { return kept_.size(); }
  /// Fronts that have served the growth, and those that it has solved.
  [[nodiscard]] std::size_t served_count() const { return served_; }
  [[nodiscard]] std::size_t solved_count() const { return solved_; }
  /// Why fronts that are kept did not serve the growth; empty: all that it reached did.
  [[nodiscard]] const std::string& rejection_reason() const { return rejection_; }

  [[nodiscard]] bool is_of_another_law() const override {
    return use_ != GrowthOverFronts::goes_on;
  }
  void begin_tolerance_round() override {}
  [[nodiscard]] bool has_stored_increment(int number) const override;
  [[nodiscard]] double requested_length_of_increment(int /*number*/) const override { return 0.0; }
  [[nodiscard]] StoredIncrement read_stored_increment(int number) const override;
  void accept_increment(int /*number*/) override {}
  void list_increment_of_another_law(int number, std::vector<results::LogLine> log) override;
  void store_last_of_another_law(SolvedIncrement again) override;
  void reject_increments_from(int number, const std::string& why) override;
  void store_increment(double asked, SolvedIncrement done) override;
  [[nodiscard]] bool would_exceed_time_limit() const override {
    return use_ == GrowthOverFronts::trial || (stopped_ && stopped_());
  }
  [[nodiscard]] std::string run_limit_text() const override { return "the user"; }

private:
  std::function<bool()> stopped_;
  std::vector<StoredIncrement> kept_; ///< by number, from 1
  GrowthOverFronts use_ = GrowthOverFronts::goes_on;
  std::size_t served_ = 0, solved_ = 0;
  std::string rejection_;
};

} // namespace spricka::archive
