// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/library/spricka.hpp"

#include "base/exit_codes.hpp"
#include "deck/read_options.hpp"
#include "model/model.hpp"
#include "program/job/failures.hpp"
#include "program/job/job.hpp"
#include "results/results.hpp"
#include "solve/one_thread.hpp"

#include <exception>
#include <limits>
#include <mutex>

namespace spricka {

namespace {

std::array<double, 3> components(const base::Vec3& v) {
  return {v[0], v[1], v[2]};
}

SolutionMessage public_message(const program::LoggedMessage& message) {
  const MessageSeverity severity = message.severity == base::Severity::note ? MessageSeverity::note
                                   : message.severity == base::Severity::warning
                                       ? MessageSeverity::warning
                                       : MessageSeverity::error;
  return {.severity = severity,
          .code = message.code,
          .text = message.text,
          .hint = message.hint,
          .file = message.file,
          .line = message.begin.line,
          .column = message.begin.column};
}

StressIntensityFactors intensity_at(const results::FrontResult& front,
                                    const results::FrontPointResult& point) {
  StressIntensityFactors out;
  out.crack = front.name;
  out.a = front.a;
  out.point = point.number;
  out.x = components(point.x);
  out.K = point.K();
  out.bar.fill(std::numeric_limits<double>::quiet_NaN());
  if (front.has_error_bar() && !point.at_surface) {
    for (std::size_t mode = 0; mode < out.bar.size(); ++mode) {
      out.bar[mode] = point.bar[mode].size();
    }
  }
  out.G = point.G;
  out.T = point.T;
  out.at_surface = point.at_surface;
  out.closed = point.closed;
  out.invalid_reason =
      front.two_materials ? "between two materials there is G alone" : front.invalid_reason;
  out.missing_bar_reason = front.missing_bar_reason;
  return out;
}

ContactSum sum_of(const results::ContactResult& contact) {
  ContactSum out;
  out.contact = contact.name;
  out.force = components(contact.force_on_slave);
  out.max_pressure = contact.max_pressure;
  out.mean_pressure = contact.mean_pressure;
  out.arc_from = contact.arc_from;
  out.arc_to = contact.arc_to;
  out.area = contact.area;
  return out;
}

void add_step(const results::LoadStepResult& step, int increment, DeckSolution& solution) {
  for (const results::FrontResult& front : step.fronts) {
    for (const results::FrontPointResult& point : front.points) {
      StressIntensityFactors& added = solution.K.emplace_back(intensity_at(front, point));
      added.step = step.step;
      added.increment = increment;
    }
  }
  for (const results::ContactResult& contact : step.contacts) {
    if (contact.mounted) {
      ContactSum& added = solution.contacts.emplace_back(sum_of(contact));
      added.step = step.step;
      added.increment = increment;
    }
  }
}

CrackLife life_of(const results::GrowthResult& growth) {
  CrackLife life;
  life.unit = growth.unit;
  life.cycles = growth.final_cycles();
  life.ended = growth.ended;
  life.reason = growth.reason;
  life.names = growth.point_names;
  for (const results::LifeCurvePoint& point : growth.curve) {
    life.curve.emplace_back(point.cycles, point.a);
  }
  return life;
}

void add_results(const model::Model& model, const results::RunResult& run, DeckSolution& solution) {
  solution.length_unit = model.units.length_name;
  solution.stress_unit = model.units.stress_name();
  solution.K_unit = model.units.stress_intensity_name();
  for (const results::CrackLengthResult& increment : run.increments) {
    for (const results::LoadStepResult& step : increment.steps) {
      add_step(step, increment.number, solution);
    }
  }
  if (run.growth) {
    solution.life = life_of(*run.growth);
  }
}

// Files and memory may fail anywhere in here.
base::ProgramOutcome read_and_solve(const DeckToSolve& request, const program::Log& log,
                                    DeckSolution& solution) {
  program::RunOptions options;
  options.deck = request.file.empty() ? "deck" : request.file;
  options.threads = request.threads;
  options.quiet = true;
  deck::DeckReadOptions read{.defines = request.parameters};
  if (!request.text.empty()) {
    read.text = request.text;
  }
  const program::CheckedDeck deck = program::read_and_check_deck(options.deck, read, log);
  if (!deck.model) {
    return deck.refusal.kind;
  }
  if (!deck.model->sweeps.empty()) {
    log.report_message(base::Severity::error, "",
                       "the deck has $SWEEP: solve it without that card, once for each point with "
                       "its values as parameters");
    return base::ProgramOutcome::usage;
  }
  const program::RunOutcomeWithResults outcome =
      program::solve_and_write(options, deck, nullptr, nullptr, log);
  if (outcome.run) {
    add_results(*deck.model, *outcome.run, solution);
  }
  return outcome.kind;
}

} // namespace

DeckSolution solve_deck(const DeckToSolve& deck) {
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  DeckSolution solution;
  const program::Log log([&](const program::LoggedMessage& message) {
    solution.messages.push_back(public_message(message));
  });
  try {
    solve::end_idle_threads();
    solution.status =
        static_cast<SolutionStatus>(base::exit_code(program::run_reporting_file_failures(
            log, [&] { return read_and_solve(deck, log, solution); })));
  } catch (const std::exception& trouble) {
    const bool memory = program::is_out_of_memory(trouble);
    solution.status = memory ? SolutionStatus::not_solvable : SolutionStatus::defect;
    log.report_message(base::Severity::error, memory ? "E466" : "",
                       memory ? program::out_of_memory_message() : trouble.what());
  }
  return solution;
}

std::string version() {
  return SPRICKA_VERSION;
}

} // namespace spricka
