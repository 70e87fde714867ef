// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/mesh.hpp"
#include "results/contact_result.hpp"
#include "results/front_result.hpp"
#include "results/growth.hpp"
#include "results/load_path.hpp"
#include "results/measured_growth.hpp"
#include "results/note.hpp"
#include "results/stress_invariants.hpp"
#include "results/tolerance_round.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a run has found, as plain records: the report and the checks read nothing else.
namespace spricka::results {

/// Force balance and energy of one body or of one net.
struct ForceBalance {
  std::string body; ///< net name, "LUG" or "LUG/2" for a second piece
  base::Vec3 applied = base::Vec3::Zero();
  base::Vec3 reaction = base::Vec3::Zero();
  base::Vec3 contact = base::Vec3::Zero();
  base::Vec3 tie = base::Vec3::Zero(); ///< what $MPC ties hand over to it
  double energy = 0.0;                 ///< strain energy [force * length]
};

/// What the mesh of one net, or of all together, is estimated to miss (fe/error_estimate.hpp).
struct NetErrorEstimate {
  std::string net;   ///< as in ForceBalance, "*": all
  double part = 0.0; ///< sqrt(error energy / (strain energy + error energy))
  /// Where most of it sits, at most three, and their share of the error's energy.
  std::vector<base::ElementId> worst;
  double worst_share = 0.0;
};

/// A face of the outer surface of a solid mesh: its outline, mid nodes between the corners.
struct OuterSurfaceFace {
  base::ElementId element;
  std::vector<base::NodeId> outline; ///< the outer normal by the right-hand rule
};

struct LoadStepResult {
  std::string step;
  base::Vector u;           ///< nodal vector [dim * node] of the increment's mesh
  base::Vector reaction;    ///< nodal vector of support forces [dim * node]
  base::Vector temperature; ///< [connectivity index], see fe/thermal.hpp; or empty
  /// At the nodes, then at further points where properties meet (model/property_points.hpp), the
  /// mean of the elements there; empty: not recovered. [point]
  std::vector<Stress> stress;
  std::vector<Stress> element_stress; ///< mean over the element [element]; empty as `stress`
  std::vector<FrontResult> fronts;    ///< of cracks, in the plane one for each tip
  std::vector<ContactResult> contacts;
  std::vector<ForceBalance> balance;    ///< by body
  std::vector<ForceBalance> nets;       ///< by net, in deck order, those with elements
  std::vector<NetErrorEstimate> errors; ///< by net, then "*"; empty: not estimated
  std::vector<ForceBalance>
      targets;                ///< by rigid target that a contact names: the reaction holds it
  bool tied = false;          ///< ties stand between freedoms
  double energy = 0.0;        ///< strain energy
  double friction_work = 0.0; ///< taken by friction so far [force * length]
  int increments = 1;         ///< solved in the step
  int iterations = 0;         ///< block iterations of the contact solution
  int pivots = 0;
  std::vector<Note> notes;

  /// How many of its fronts are tips, those of cracks in the plane.
  [[nodiscard]] std::size_t tip_count() const {
    return static_cast<std::size_t>(std::ranges::count_if(fronts, &FrontResult::is_tip));
  }
};

/// One crack length: the mesh with the crack in it, and its steps.
struct CrackLengthResult {
  int number = 0;
  double a = 0.0;           ///< of the first growing crack; 0 without cracks
  std::size_t unknowns = 0; ///< free displacements of the mesh with the crack in it
  model::Mesh mesh;
  std::size_t kept = 0;                  ///< elements of the host, before those of patches
  std::vector<OuterSurfaceFace> surface; ///< of solids; empty in the plane
  std::vector<LoadStepResult> steps;
  std::vector<LoadPathResult> paths; ///< in deck order
  std::vector<Note> notes;
};

/// Hands the record of each front of an increment to `use`: of all steps, then of all load paths.
template <class Use> void for_each_front(CrackLengthResult& increment, Use use) {
  for (LoadStepResult& step : increment.steps) {
    std::ranges::for_each(step.fronts, use);
  }
  for (LoadPathResult& path : increment.paths) {
    std::ranges::for_each(path.fronts, use, &LoadPathFront::front_without_points);
  }
}

/// One line of the processor log.
struct LogLine {
  std::string processor; ///< TOPOLOGY, STIFFNESS, CONDENSE, ...
  std::string text;
  double cpu = 0.0;  ///< [s]
  double wall = 0.0; ///< [s]
};

struct CheckResult {
  std::string text; ///< as written in the deck
  double wanted = 0.0;
  double found = 0.0;
  double error = 0.0; ///< found - wanted, relative or absolute as the check says
  double tolerance = 0.0;
  bool relative = true;
  bool passed = false;
  std::string source;
  std::string trouble; ///< why no value could be found; empty normally
  /// Half width of the error bar that the run prints for the quantity; not a number: it has none.
  double bar = std::numeric_limits<double>::quiet_NaN();
};

struct RunResult {
  std::vector<CrackLengthResult> increments;
  std::vector<LogLine> log;
  std::vector<CheckResult> checks;
  std::vector<Warning> warnings;       ///< when the run has ended, the worst first
  std::vector<ToleranceRound> rounds;  ///< where $TIPNET has TOL; this run is the last
  std::optional<GrowthResult> growth;  ///< where $GROW has a law
  std::vector<GrowthTestResult> tests; ///< one for each $TEST, in deck order
  double cpu = 0.0;
  double wall = 0.0;
  std::size_t peak_memory = 0; ///< [bytes]
};

/// The entry of that name, or null; names as the deck's, upper case.
const LoadStepResult* find_step(const CrackLengthResult& increment, std::string_view step);
/// The crack front or tip of that name in a step, or null.
const FrontResult* find_front(const LoadStepResult& step, std::string_view front);
/// The contact of that name in a step, or null.
const ContactResult* find_contact(const LoadStepResult& step, std::string_view contact);
/// The load path of that name in an increment, or null.
const LoadPathResult* find_path(const CrackLengthResult& increment, std::string_view path);

/// The front of that name at the end of that step where its crack has the length nearest to `a`
/// [length]; null if no increment has both.
const FrontResult* find_front_at_length(const RunResult& run, std::string_view step,
                                        std::string_view front, double a);

} // namespace spricka::results
