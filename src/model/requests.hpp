// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/equation_engines.hpp"
#include "base/id.hpp"
#include "base/quantity.hpp"
#include "base/source.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What a deck asks for beside its answers: files, checks, restarts, sweeps, limits, what is shown.
namespace spricka::model {

enum class OutputFormat { vtu, csv, json };
enum class OutputFrequency { step, increment, end };

struct RequestedQuantity {
  std::string quantity; ///< U, S, CPRESS, K, REACTION
  std::string name;     ///< set, contact or crack
  base::SourceSpan span;
};
struct OutputFileRequest {
  std::string file;
  OutputFormat format = OutputFormat::csv;
  OutputFrequency every = OutputFrequency::step;
  std::vector<RequestedQuantity> requests;
  base::SourceSpan span;
};

/// One line of $CHECK: `quantity(arguments) = value REL|ABS tolerance SOURCE 'text'`.
struct ResultCheck {
  std::string quantity;                                     ///< upper case, "S.XX.MIN"
  std::vector<std::variant<std::string, double>> arguments; ///< names upper case, or numbers
  base::QuantityKind kind = base::QuantityKind::number;     ///< of the quantity
  double value = 0.0;
  double tolerance = 0.0; ///< of the value where `relative`
  bool relative = true;
  /// Whether value and tolerance were given as bare numbers, which are in units of output.
  bool is_value_in_output_unit = false;
  bool is_tolerance_in_output_unit = false;
  std::string source;
  base::SourceSpan span;
};

/// Files of the state of a run; each may be empty.
struct RestartFiles {
  std::string read;
  std::optional<int> at; ///< increment to continue from; empty: the last one
  std::string write;
  int every = 1; ///< increments between states
  base::SourceSpan span;
};

/// One $SWEEP card: the parameters that vary together and the values they take, row by row.
struct ParameterSweep {
  std::vector<std::string> parameters;     ///< one, or two with WITH; as the deck writes them
  std::vector<std::vector<double>> values; ///< [row][parameter]
  base::SourceSpan span;
};

struct SolverControl {
  int max_iterations = 100;
  base::EquationEngine engine = base::EquationEngine::automatic;
  double tolerance = 1e-8;
  int threads = 0;         ///< 0: as many as there are cores
  base::StepId shown_step; ///< whose state pictures show; invalid: results/shown_step.hpp
};

} // namespace spricka::model
