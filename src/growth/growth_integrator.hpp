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
  /// one of other cracks.
  GrowthIntegrator(const model::Model& model, GrowthRateFunction law,
                   std::unique_ptr<CrackKinematics> kinematics, GrowthState state);

  /// The cracks to be solved next; empty when the growth has ended.
  std::optional<CrackGeometry> propose_next_cracks(base::Diagnostics& diagnostics);
  /// The cracks with such arms [tip], longer than those of the last station, in place of
  /// propose_next_cracks(); before the first station those they have. Empty, with errors: there are
  /// none.
  std::optional<CrackGeometry> extend_cracks_to(const std::vector<double>& arms,
                                                base::Diagnostics& diagnostics);
  /// Takes what was found there: K, rates, turns and plastic parts by tip. False: the advance was
  /// too long for the tolerance and does not count.
  bool accept_or_reject_station(std::vector<TipStation> found);
  /// Takes what was found there, however long the advance was.
  void accept_station(std::vector<TipStation> found);
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
  [[nodiscard]] GrowthEndCriteria ends() const { return {model_, tips(), state_.stations}; }
  void end_at_station(GrowthEvent end);

  const model::Model& model_;
  GrowthRateFunction law_;
  std::unique_ptr<CrackKinematics> kinematics_;
  std::vector<double> advance_;        ///< [tip] that leads to the state on trial
  std::optional<GrowthEvent> passage_; ///< that it leads through
  double lengthening_ = 1.0;           ///< larger where the last passage could not be meshed
  GrowthState state_;
  std::optional<GrowthEvent> end_; ///< never a passage
};

} // namespace spricka::growth
