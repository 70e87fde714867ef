// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// spricka in another program: a deck in, K, contact and life out, in the units of the deck.
/// Nothing else is needed to compile against it; find_package(spricka) gives the target
/// spricka::spricka (manual, library.md).
namespace spricka {

struct DeckToSolve {
  std::string file; ///< its includes and meshes are looked for beside it
  std::string text; ///< the deck itself, instead of what is in the file; empty: the file is read
  /// As -D NAME=EXPRESSION: {"F", "80[kN]"}.
  std::vector<std::pair<std::string, std::string>> parameters;
  int threads = -1; ///< below 0: as the deck says; 0: all cores
};

/// As the exit codes of the program (manual, exit_codes.md); there are results with the first two
/// alone, and in part with not_converged.
enum class SolutionStatus {
  solved = 0,
  check_failed = 1,
  invalid_request = 2,
  deck_error = 3,
  not_solvable = 4,
  not_converged = 5,
  file_trouble = 7,
  defect = 70
};

enum class MessageSeverity { note, warning, error };

struct SolutionMessage {
  MessageSeverity severity = MessageSeverity::error;
  std::string code, text, hint; ///< "E108"; a hint may be empty
  std::string file;             ///< empty: no place in a deck
  std::size_t line = 0, column = 0;
};

/// K at the end of a step at a point of a front; the tip of a crack in the plane is a front of one
/// point.
struct StressIntensityFactors {
  std::string step, crack;
  int increment = 1;              ///< number of the crack length
  double a = 0.0;                 ///< size of the crack
  int point = 1;                  ///< along the front
  std::array<double, 3> x{};      ///< where it is, before the load
  std::array<double, 3> K{};      ///< K1, K2, K3
  std::array<double, 3> bar{};    ///< half widths of their error bars; not a number: there is none
  double G = 0.0, T = 0.0;        ///< energy release rate, stress along the crack
  bool at_surface = false;        ///< the front leaves the body here: K is a number of the mesh
  bool closed = false;            ///< the faces touch, so that K1 is 0
  std::string invalid_reason;     ///< why K is no answer; empty: it is one
  std::string missing_bar_reason; ///< why there is no bar; empty: there is one within the body
};

/// A pair of surfaces at the end of a step, as sums over it.
struct ContactSum {
  std::string step, contact;
  int increment = 1;
  std::array<double, 3> force{}; ///< on the slave
  double max_pressure = 0.0, mean_pressure = 0.0;
  /// In the plane: the longest part in contact, on a circle [rad], else along the slave [length].
  double arc_from = 0.0, arc_to = 0.0;
  double area = 0.0; ///< between solids, in contact
};

struct CrackLife {
  std::string unit;    ///< "cycle", or "pass" of a spectrum; empty: the deck has no growth by a law
  double cycles = 0.0; ///< to the end of the growth
  std::string ended, reason;      ///< "AMAX", and the same in a sentence
  std::vector<std::string> names; ///< of the points that grow
  /// Cycles, and the size at each of those points.
  std::vector<std::pair<double, std::vector<double>>> curve;
};

struct DeckSolution {
  SolutionStatus status = SolutionStatus::defect;
  std::vector<SolutionMessage> messages; ///< in the order in which the program prints them
  std::string length_unit, stress_unit, K_unit;
  std::vector<StressIntensityFactors> K;
  std::vector<ContactSum> contacts;
  CrackLife life;
};

/// Solves a deck at the values of its parameters, as `spricka run` does, and writes no file; a
/// $SWEEP is refused. Throws nothing. One deck at a time: a second call waits. OpenBLAS of the
/// process is put on one thread, for equal digits.
[[gnu::visibility("default")]] DeckSolution solve_deck(const DeckToSolve& deck);

/// "0.1.0"
[[gnu::visibility("default")]] std::string version();

} // namespace spricka
