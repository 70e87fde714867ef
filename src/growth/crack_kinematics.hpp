// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/diagnostics.hpp"
#include "growth/growth_events.hpp"
#include "growth/state.hpp"
#include "mesh/cut/cracked.hpp"
#include "model/cracks.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace spricka::growth {

/// A place of a crack that grows at a rate of its own: a tip in the plane, an end of an axis of an
/// ellipse or a point of a front in space.
struct TrackedTip {
  std::string name;      ///< "C1", "C1.2", "C1.A"
  std::size_t line = 0;  ///< of CrackState::lines in the plane, else of solids
  bool at_first = false; ///< in the plane: at the first point of its line, else at the last
};

/// All cracks as they are at one moment.
struct CrackGeometry {
  std::vector<mesh::CrackLine> lines;           ///< [crack] in the plane
  std::vector<model::CrackDefinition> solids{}; ///< [crack] in space
  /// [tip] in space: K is taken where the front is nearest to this place.
  std::vector<base::Vec3> aims{};
  /// [tip] in space: the crack whose front that is; not its first one where two have become one.
  std::vector<std::size_t> fronts{};

  /// In space: the crack of the front that a tip is on.
  [[nodiscard]] const model::CrackDefinition& solid_crack_at_tip(std::size_t tip) const {
    return solids[fronts[tip]];
  }
};

/// How fronts move, v(x) = sum of B_j(x) q_j over their shape modes j (manual, growth.11): the
/// arms of its tips are the amplitudes. A tip in the plane is one mode, an ellipse has its axes, a
/// free front a hat at each of its points. It tells how far it is to where a mode meets something,
/// and what cracks are after an advance; it knows nothing of cycles.
class CrackKinematics {
public:
  CrackKinematics() = default;
  CrackKinematics(const CrackKinematics&) = delete;
  CrackKinematics& operator=(const CrackKinematics&) = delete;
  virtual ~CrackKinematics() = default;

  [[nodiscard]] const std::vector<TrackedTip>& tips() const { return tips_; }
  /// Whether the way on follows from K.
  [[nodiscard]] virtual bool can_kink() const = 0;
  /// What headings scatter by from mesh to mesh [rad]: no advance is too long for that.
  [[nodiscard]] virtual double heading_mesh_scatter() const { return 0.0; }
  /// Goes on from the last station of an earlier run. Throws base::CorruptStoredField where its
  /// cracks are not those of the deck.
  virtual void resume_from(const GrowthState& state) = 0;
  /// The cracks as they are at the last station that counts; then the state on trial.
  [[nodiscard]] virtual CrackGeometry current_cracks() = 0;
  /// The arm of a tip before anything has grown [length].
  [[nodiscard]] virtual double initial_tip_extent(std::size_t tip) const = 0;
  /// The arms [tip] of cracks that are given the size `a` as LAW=INCREMENT gives it; empty: such
  /// cracks are not on the way of a growth by a law.
  [[nodiscard]] virtual std::vector<double> tip_extents_at_size(double /*a*/) const { return {}; }
  /// What a tip can grow from the last station on, at most [length].
  [[nodiscard]] virtual double remaining_growth_length(const GrowthState& state,
                                                       std::size_t tip) const = 0;
  /// How far all may go (`ds` at most) for the sake of a tip that takes `share` of it.
  [[nodiscard]] virtual AdvanceLimit advance_limit(const GrowthState& state, std::size_t tip,
                                                   double share, double ds) const = 0;
  /// Turns an advance [tip] into the one that a front makes which takes the shape it tends to;
  /// false: there is no such front.
  virtual bool smooth_advances(const GrowthState& /*state*/, std::vector<double>& /*by*/) const {
    return false;
  }
  /// What is left of `deferred_advance` [tip] when the last station's tips have advanced `by`
  /// [tip]: waves of such a front die away by themselves.
  virtual void damp_deferred_advance(std::vector<double>& /*owed*/,
                                     const std::vector<double>& /*by*/) const {}
  /// The cracks after an advance [tip] from the last station, then the state on trial; empty, with
  /// errors: there are none.
  virtual std::optional<CrackGeometry> advance_cracks(const GrowthState& state,
                                                      const AdvanceToNextStation& advance,
                                                      base::Diagnostics& diagnostics) = 0;
  /// What K at its places means for the tips of the state on trial: where they stand and head to
  /// (in the plane), how their arms grow with the rates found (TipStation::extent_rate_ratio).
  virtual void evaluate_trial_tips(std::vector<TipStation>& found) const = 0;
  /// The state on trial counts: it is the last station's from now on, kept in `state`.
  virtual void accept_trial(GrowthState& state) = 0;
  /// The advance asked for last, a `passage` or not, cannot be made, however short (a passage:
  /// however long); `why`. Empty: to be asked again, there is another way.
  [[nodiscard]] virtual std::optional<GrowthEvent>
  handle_unmeshable_advance(bool passage, const std::string& why) = 0;
  /// Cracks straight on from the last station by so much at each tip, for a look ahead; in space
  /// none, as nothing looks ahead there.
  [[nodiscard]] virtual CrackGeometry extend_cracks_straight(const GrowthState& /*state*/,
                                                             double /*advance*/) const {
    return {};
  }

protected:
  std::vector<TrackedTip> tips_;
};

} // namespace spricka::growth
