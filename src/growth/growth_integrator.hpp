// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "growth/crack_kinematics.hpp"
#include "growth/growth_ends.hpp"
#include "growth/state.hpp"
#include "growth/trajectory.hpp"
#include "model/forward.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Growth by a law: from station to station, where the next crack lengths are to be solved and when
/// it is over (manual, growth.2 to growth.6).
namespace spricka::growth {

class GrowthIntegrator {
public:
  /// `law`: empty where the stations' rates are those of a spectrum. `kinematics`: of the cracks as
  /// they are first. `state`: of a run that goes on, else new; throws base::CorruptStoredField for
  /// one of other cracks. `extent_after_cycles`: where cycles are not what the rates make of them.
  GrowthIntegrator(const model::Model& model, GrowthRateFunction law,
                   std::unique_ptr<CrackKinematics> kinematics, GrowthState state,
                   ExtentAfterCycles extent_after_cycles = {});

  /// The cracks to be solved next; empty when the growth has ended.
  std::optional<CrackGeometry> propose_next_cracks(base::Diagnostics& diagnostics);
  /// The cracks with the size `a` as LAW=INCREMENT gives it, in place of propose_next_cracks().
  /// Empty, with errors: they are not on the way of this growth, or not ahead of the last station.
  std::optional<CrackGeometry> extend_cracks_to_size(double a, base::Diagnostics& diagnostics);
  /// Lengths of the tips there, or at first [length].
  [[nodiscard]] std::vector<double> trial_extents() const;
  /// Takes what was found there: K, rates, turns and plastic parts by tip. False: the advance was
  /// too long for the tolerance and does not count.
  bool accept_or_reject_station(std::vector<TipStation> found);
  /// The cracks at the last station of an earlier growth that began as this one, in place of
  /// propose_next_cracks(). Throws base::CorruptStoredField where they are not the deck's.
  CrackGeometry go_to_cracks_of(const GrowthState& earlier);
  /// Takes what was found at cracks that another law has led to, however long the advance was. If
  /// the law would have led elsewhere, so that the cycles would be off by more than the tolerance,
  /// it does not count, and the cracks are those of the last station: false.
  bool accept_station_of_another_law(std::vector<TipStation> found);
  /// Leaves the cracks that were gone to: those of the last station are there again.
  void go_back_to_last_station();
  /// The cracks of `next` could not be meshed: a shorter advance, or the end.
  void shorten_step(const std::string& why);

  [[nodiscard]] const std::vector<TrackedTip>& tips() const { return kinematics_->tips(); }
  [[nodiscard]] const GrowthState& growth_state() const { return state_; }
  [[nodiscard]] const std::optional<GrowthEvent>& growth_end() const { return end_; }
  /// Functions between the stations; a view of this object.
  [[nodiscard]] GrowthTrajectory trajectory() const { return {state_.stations, law_, 4}; }
  /// Estimated error of the cycles, as a part of them.
  [[nodiscard]] double cycle_error() const;
  /// Cracks straight on from the last station by so much at each growing tip, for a look ahead.
  [[nodiscard]] CrackGeometry extend_cracks_straight(double advance) const {
    return kinematics_->extend_cracks_straight(state_, advance);
  }

private:
  bool plan();
  void stop_at_last_length(bool planned);
  std::optional<double> next_advance(const std::vector<double>& share);
  void append_station(std::vector<TipStation> found);
  [[nodiscard]] bool judge_last_advance();
  void accept_last_station();
  [[nodiscard]] GrowthEndCriteria ends() const {
    return {model_, tips(), state_.stations, extent_after_cycles_};
  }
  void end_at_station(GrowthEvent end);

  const model::Model& model_;
  GrowthRateFunction law_;
  ExtentAfterCycles extent_after_cycles_;
  std::unique_ptr<CrackKinematics> kinematics_;
  std::vector<double> advance_;        ///< [tip] that leads to the state on trial
  std::optional<GrowthEvent> passage_; ///< that it leads through
  double lengthening_ = 1.0;           ///< larger where the last passage could not be meshed
  GrowthState state_;
  std::optional<GrowthEvent> end_; ///< never a passage
};

} // namespace spricka::growth
