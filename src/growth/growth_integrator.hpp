// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "growth/crack_kinematics.hpp"
#include "growth/state.hpp"
#include "growth/trajectory.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/forward.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// Growth by a law: from station to station, where the next crack lengths are to be solved and when
/// it is over (manual, growth.2 to growth.6).
namespace spricka::growth {

struct GrowthEnd {
  /// AMAX, CYCLES, KC, NET SECTION, EDGE, LINK-UP, THRESHOLD, CLOSED, ARREST, CURL, PATH END, MESH,
  /// STATIONS
  std::string word;
  std::string reason; ///< a sentence
  double s = 0.0;     ///< sum of the arms there
};

class GrowthIntegrator {
public:
  /// `law`: empty where the stations' rates are those of a spectrum. `ways`: of the cracks as they
  /// are first. `state`: of a run that goes on, else new.
  GrowthIntegrator(const model::Model& model, Law law, std::unique_ptr<CrackKinematics> kinematics,
                   GrowthState state);
  /// The same for cracks in the plane.
  GrowthIntegrator(const model::Model& model, Law law, std::vector<mesh::CrackLine> lines,
                   GrowthState state);

  /// The cracks to be solved next; empty when the growth has ended.
  std::optional<CrackGeometry> propose_step(base::Diagnostics& diagnostics);
  /// Takes what was found there: K, rates, turns and plastic parts by tip. False: the advance was
  /// too long for the tolerance and does not count.
  bool accept_station(std::vector<TipStation> found);
  /// The cracks of `next` could not be meshed: a shorter advance, or the end.
  void shorten_step(const std::string& why);

  [[nodiscard]] const std::vector<TrackedTip>& tips() const { return kinematics_->tips(); }
  [[nodiscard]] const GrowthState& growth_state() const { return state_; }
  [[nodiscard]] const std::optional<GrowthEnd>& end() const { return end_; }
  /// Functions between the stations; a view of this object.
  [[nodiscard]] GrowthTrajectory trajectory() const { return {state_.stations, law_, 4}; }
  /// Estimated error of the cycles, as a part of them.
  [[nodiscard]] double cycle_error() const;
  /// Cracks straight on from the last station by so much at each growing tip, for a look ahead.
  [[nodiscard]] CrackGeometry extend_straight(double advance) const {
    return kinematics_->extend_straight(state_, advance);
  }

private:
  [[nodiscard]] const model::CrackGrowthSettings& rules() const;
  [[nodiscard]] std::vector<double> shares() const;
  bool plan();
  void stop_at_last_length(bool planned);
  std::optional<double> next_advance(const std::vector<double>& share);
  [[nodiscard]] bool good_enough();
  [[nodiscard]] double cycles_missed() const;
  [[nodiscard]] double turn_missed() const;
  [[nodiscard]] double drift() const;
  void settle();
  [[nodiscard]] std::optional<GrowthEnd> crossing(const GrowthTrajectory& between, double s0,
                                                  double s1) const;
  void look_for_end();
  void look_for_no_end();
  void nothing_grows();
  [[nodiscard]] double turned(std::size_t tip) const;
  [[nodiscard]] std::size_t most_stations() const;
  void end_at_station(std::string word, std::string reason);

  const model::Model& model_;
  Law law_;
  std::unique_ptr<CrackKinematics> kinematics_;
  std::vector<double> advance_; ///< [tip] that leads to the state on trial
  std::size_t leaping_ = 0;     ///< the tip, from 1, that goes through a surface; 0: none
  std::size_t meets_ = 0;       ///< the crack, from 1, that its front joins on that way; 0: none
  double breakthrough_factor_ = 1.0; ///< larger where the last breakthrough could not be meshed
  GrowthState state_;
  std::optional<GrowthEnd> end_;
};

} // namespace spricka::growth
