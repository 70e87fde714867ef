// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What happens to cracks that grow: one type of event, one policy each. Lengths of a policy are
/// parts of what lies behind the tip, unless it says otherwise.
///
/// | event           | when it happens                | limits the advance     | what becomes of it
/// | --------------- | ------------------------------ | ---------------------- | ------------------
/// | breakthrough    | hardly any way to a surface is | to a part of the way   | the front behind
/// |                 | left, and a front behind it    |                        | the surface
/// | coalescence     | hardly any gap to a crack in   | to a part of the gap   | one crack with the
/// |                 | the same plane is left         |                        | tips of both
/// | surface_reached | the ligament is lost: no front | to a part of the way   | EDGE
/// |                 | behind the surface, or edge    |                        |
/// | cracks_met      | the same gap, and no one crack | to a part of the gap   | LINK-UP
/// |                 | could be made of the two       |                        |
/// | path_end        | the path of the deck is over   | to the path's end      | PATH END
/// | last_length     | a tip has the length AMAX      | to that length         | AMAX
/// | last_cycle      | so many cycles are over        | -                      | CYCLES
/// | fracture        | K reaches KC                   | to a sure place of it  | KC
/// | net_section     | the ligament yields            | to a sure place of it  | NET SECTION
/// | threshold       | delta K falls to the threshold | -                      | THRESHOLD
/// | closed          | no crack opens                 | -                      | CLOSED
/// | arrest          | next to no growth any more     | -                      | ARREST
/// | curl            | a tip has turned too far       | -                      | CURL
/// | no_mesh         | no advance can be meshed       | -                      | MESH
/// | endless         | too many stations              | -                      | STATIONS
///
/// A passage (the first two) is told among `passages`, all others end the growth under their word.
namespace spricka::growth {

enum class GrowthEventKind {
  breakthrough,
  coalescence,
  surface_reached,
  cracks_met,
  path_end,
  last_length,
  last_cycle,
  fracture,
  net_section,
  threshold,
  closed,
  arrest,
  curl,
  no_mesh,
  endless
};

struct GrowthEvent {
  GrowthEventKind kind = GrowthEventKind::no_mesh;
  std::string reason{};  ///< of an end: a sentence
  double s = 0.0;        ///< of an end: sum of the arms there [length]
  double advance = 0.0;  ///< of a passage: sum of the advances that leads through [length]
  std::size_t tip = 0;   ///< of a passage: whose it is
  std::size_t crack = 0; ///< of a coalescence: that the tip's crack meets

  /// A passage, that the growth goes on behind.
  [[nodiscard]] bool is_passage() const {
    return kind == GrowthEventKind::breakthrough || kind == GrowthEventKind::coalescence;
  }
  /// Of an end: as listings and checks name it.
  [[nodiscard]] const char* word() const;
};

/// What the next advance of all may be, as far as one tip is asked.
struct AdvanceLimit {
  double ds = 0.0; ///< sum of the advances [length]
  /// The growth ends here, or the tip goes through all that is left before it in one go.
  std::optional<GrowthEvent> event{};
};

/// How a tip comes to an obstacle.
struct ObstaclePolicy {
  GrowthEventKind passage;   ///< if it goes on behind the obstacle
  GrowthEventKind end;       ///< if it does not
  double step = 0.0;         ///< longest advance, as a part of the way to it
  double end_gap = 0.0;      ///< what is left before an end
  double passed = 0.0;       ///< what is left before a passage; 0: there is none
  double passed_early = 0.0; ///< the same where nothing nearer can be meshed
  double own_way = 1.0;      ///< part of the way that the tip itself goes
};

/// An edge in the plane. K grows without bound in the last of a ligament; there is no crack behind.
inline constexpr ObstaclePolicy edge_policy{.passage = GrowthEventKind::breakthrough,
                                            .end = GrowthEventKind::surface_reached,
                                            .step = 0.6,
                                            .end_gap = 0.02};
/// Another crack in the plane, which may come the other way: the two together stay apart.
inline constexpr ObstaclePolicy plane_crack_policy{.passage = GrowthEventKind::coalescence,
                                                   .end = GrowthEventKind::cracks_met,
                                                   .step = 0.35,
                                                   .end_gap = 0.02};
/// A surface before a front, in parts of the way from behind the crack to it. A front so near to
/// it is hard to mesh and of no account for the life.
inline constexpr ObstaclePolicy surface_policy{.passage = GrowthEventKind::breakthrough,
                                               .end = GrowthEventKind::surface_reached,
                                               .step = 0.6,
                                               .end_gap = 0.03,
                                               .passed = 0.1,
                                               .passed_early = 0.45};
/// Another front, which comes nearer as well.
inline constexpr ObstaclePolicy front_policy{.passage = GrowthEventKind::coalescence,
                                             .end = GrowthEventKind::cracks_met,
                                             .step = 0.35,
                                             .end_gap = 0.1,
                                             .passed = 0.1,
                                             .passed_early = 0.45,
                                             .own_way = 0.5};
/// Of the way to the surface: where an advance cannot be meshed and less is left, that is why.
inline constexpr double surface_left_unmeshed = 0.2;

/// What a passage makes.
struct PassageParameters {
  /// One that cannot be meshed gets longer by this factor, up to so many times what it needs.
  double longer = 1.15, longest = 3.0;
  /// Logarithm of an arm's ratio of the first step behind it: rates before and behind it have
  /// nothing in common.
  double step_behind = 0.1;
  /// Part of its cycles that may be wrong, as K is known at both of its ends only.
  double uncertain_cycles = 0.5;
  /// Of an ellipse: its axis behind the surface over the way to it, so that the front meets the
  /// surface under an angle that a tube can be laid to (28 degrees of a circle; steeper the
  /// farther).
  double axis_behind = 1.15;
  /// Of a free front: points with less before them than so many times `passed` are left out of the
  /// front behind, which goes straight on from those that stay: it meets the surface under an angle
  /// that can be meshed.
  double left_out = 2.0;
  /// Of two free fronts: points are left out that are not farther from the other front than the gap
  /// and this part of the way behind. The notch between two fronts closes next to at once, and a
  /// narrow one has no smooth curve that could go on.
  double notch = 0.4;
};
inline constexpr PassageParameters passage_policy{};

/// When a growth that goes on leads nowhere.
struct FutilityPolicy {
  double rest = 1e-9; ///< it is this much slower than it was at its fastest
  /// Sine of the angle that a front may make with its first plane, 75 degrees: heights over that
  /// stand for it.
  double steepest = 0.966;
  /// So many stations: at the shortest step an arm grows by e^20 in as many.
  std::size_t stations = 1000;
};
inline constexpr FutilityPolicy futility_policy{};

/// What lies ahead of a tip.
struct ObstacleAhead {
  double distance = 0.0;              ///< [length]
  double part = 0.0;                  ///< of what the policy compares it with
  std::string reason;                 ///< why the growth ends there, if it does
  std::size_t crack = 0;              ///< another one, if it is that
  std::function<bool()> goes_on = {}; ///< whether there is a crack behind; asked where it matters
};

/// Limits an advance, of which the tip takes `share`, by what lies ahead of the tip. `early`:
/// nearer to it nothing can be meshed.
void limit_advance_by_obstacle(const ObstaclePolicy& policy, const ObstacleAhead& ahead,
                               double share, bool early, AdvanceLimit& limit);

/// From the last station to the next.
struct AdvanceToNextStation {
  std::vector<double> by;               ///< [tip] [length]
  std::optional<GrowthEvent> passage{}; ///< that it leads through
  double lengthening = 1.0;             ///< how much farther than needed a passage leads

  [[nodiscard]] bool leads_through(GrowthEventKind kind) const {
    return passage && passage->kind == kind;
  }
};

} // namespace spricka::growth
