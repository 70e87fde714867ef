// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "growth/ahead.hpp"
#include "growth/state.hpp"
#include "growth/trajectory.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/forward.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Growth by a law: from station to station, where the next crack lengths are to be solved and when
/// it is over (manual, growth.2 to growth.6).
namespace spricka::growth {

/// A tip that grows: at the last point of its crack's line, or at the first of an embedded one.
struct GrowingTip {
  std::string name; ///< "C1", "C1.2"
  std::size_t line = 0;
  bool at_first = false;
};

/// Tips of the cracks that grow, in the order of the cracks.
std::vector<GrowingTip> growing_tips(const model::Model& model,
                                     const std::vector<mesh::CrackLine>& lines);

struct End {
  /// AMAX, CYCLES, KC, NET SECTION, EDGE, LINK-UP, THRESHOLD, CLOSED, ARREST, CURL, PATH END, MESH,
  /// STATIONS
  std::string word;
  std::string reason; ///< a sentence
  double s = 0.0;     ///< sum of the arms there
};

class March {
public:
  /// `law`: empty where the stations' rates are those of a spectrum. `lines`: the cracks as they
  /// are first. `state`: of a run that goes on, else new.
  March(const model::Model& model, Law law, std::vector<mesh::CrackLine> lines, State state);

  /// The cracks to be solved next; empty when the growth has ended.
  std::optional<std::vector<mesh::CrackLine>> next(base::Diagnostics& diagnostics);
  /// Takes what was found there: K, rates, turns and plastic parts by tip. False: the advance was
  /// too long for the tolerance and does not count.
  bool take(std::vector<TipStation> found);
  /// The cracks of `next` could not be meshed: a shorter advance, or the end.
  void shorten(const std::string& why);

  [[nodiscard]] const std::vector<GrowingTip>& tips() const { return tips_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const std::optional<End>& end() const { return end_; }
  /// Functions between the stations; a view of this object.
  [[nodiscard]] Trajectory trajectory() const { return {state_.stations, law_, 4}; }
  /// Estimated error of the cycles, as a part of them.
  [[nodiscard]] double error() const;
  /// Cracks straight on from the last station by so much at each growing tip, for a look ahead.
  [[nodiscard]] std::vector<mesh::CrackLine> straight_on(double advance) const;

private:
  [[nodiscard]] const model::Growth& rules() const;
  [[nodiscard]] bool turns() const;
  [[nodiscard]] Heading heading_of(std::size_t tip) const;
  [[nodiscard]] std::vector<double> shares() const;
  [[nodiscard]] double length_left(std::size_t tip) const;
  bool plan();
  bool limit(std::size_t tip, double share, double& ds);
  bool limit_by_obstacles(std::size_t tip, double share, double& ds);
  [[nodiscard]] std::optional<std::vector<mesh::CrackLine>>
  advanced_lines(base::Diagnostics& diagnostics) const;
  void extend(std::size_t tip, double by, mesh::CrackLine& line) const;
  [[nodiscard]] bool good_enough();
  [[nodiscard]] double cycles_missed() const;
  [[nodiscard]] double turn_missed() const;
  [[nodiscard]] double drift() const;
  void settle();
  [[nodiscard]] std::optional<End> crossing(const Trajectory& between, double s0, double s1) const;
  void look_for_end();
  void look_for_no_end();
  void nothing_grows();
  [[nodiscard]] double turned(std::size_t tip) const;
  [[nodiscard]] std::size_t most_stations() const;
  void end_at_station(std::string word, std::string reason);

  const model::Model& model_;
  Law law_;
  std::vector<mesh::CrackLine> lines_; ///< at the last station that counts
  std::vector<mesh::CrackLine> trial_; ///< to be solved
  std::vector<double> advance_;        ///< [tip] that leads to it
  std::vector<GrowingTip> tips_;
  Surroundings around_;
  State state_;
  std::optional<End> end_;
};

} // namespace spricka::growth
