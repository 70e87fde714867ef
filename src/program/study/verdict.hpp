// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "program/study/convergence.hpp"
#include "program/study/deck_answers.hpp"
#include "program/study/settings.hpp"
#include "program/trials/child_run.hpp"

#include <optional>
#include <string>
#include <vector>

/// What the runs of a study say: errors of each, slopes, plateaus and the cheapest setting.
namespace spricka::program {

/// One setting that was run.
struct Trial {
  Setting setting;
  ChildEnd end;
  std::size_t unknowns = 0;
  std::vector<AnswerReading> readings; ///< [answer]; empty: the run has no results
  std::string trouble;                 ///< why not
};

/// What answers are compared with.
struct AnswerReference {
  double value = 0.0;
  double uncertainty = 0.0; ///< in the unit of the answer
  bool of_deck = false;     ///< the value of the deck's $CHECK; else of the finest setting
  double deck_is_off = 0.0; ///< a deck's value that is not used: by so much, in parts of the answer
  double scale = 0.0;       ///< what errors are parts of; 0: the answer is left out
};

/// Of one setting and group of answers: the largest, as parts of the answers. Not a number where
/// there is none.
struct GroupErrors {
  double plain = 0.0;
  double best = 0.0; ///< of the corrected values
  double bar = 0.0;
};

/// One series of a group.
struct SeriesVerdict {
  SettingFamily family = SettingFamily::whole;
  bool corrected = false;
  std::optional<ConvergenceRate> slope;
  std::optional<double> theory;        ///< the power that is expected
  std::optional<ErrorPlateau> plateau; ///< `first` counts the points
  std::string reason;                  ///< of the plateau
};

/// The cheapest setting for a tolerance.
struct CheapestSetting {
  double tolerance = 0.0;
  std::optional<std::size_t> trial;
  bool corrected = false;
  double error = 0.0; ///< lasting: of it and all finer ones of its family
  std::string words;  ///< the sentence
};

struct GroupVerdict {
  AnswerGroup group = AnswerGroup::K;
  std::vector<GroupErrors> errors; ///< [trial]
  double floor = 0.0; ///< how uncertain the references are: nothing below is told apart
  std::vector<SeriesVerdict> series;
  std::vector<CheapestSetting> cheapest;
  std::string peer; ///< CalculiX beside it, a sentence; empty: it was not run
};

struct StudyVerdict {
  std::vector<AnswerReference> references; ///< [answer]
  std::optional<std::size_t> finest;       ///< trial that others are compared with
  std::vector<GroupVerdict> groups;        ///< those with answers, in their order
};

} // namespace spricka::program
