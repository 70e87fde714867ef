// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/study/peer_answers.hpp"

#include "model/model.hpp"
#include "program/checks/check_quantities.hpp"
#include "results/stress_component.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace spricka::program {

namespace {

// "S.YY.MAX" -> "YY"; empty: no stress.
std::string component_of(const Answer& answer) {
  const std::string_view quantity = answer.check.quantity;
  const std::size_t end = quantity.rfind('.');
  return answer.group == AnswerGroup::stress && end > 1 ? std::string(quantity.substr(2, end - 2))
                                                        : std::string();
}

/// Evaluates lines of $CHECK on a run that is nothing but nodal values.
class NodalRun {
public:
  explicit NodalRun(const model::Model& model) : model_(model) {
    results::Increment& increment = run_.increments.emplace_back();
    increment.mesh = model.mesh;
    increment.steps.emplace_back().step = model.steps.front().name;
  }

  void set(base::Vector u) { run_.increments.front().steps.front().u = std::move(u); }

  // Not a number where a line has no value.
  double value(const model::ResultCheck& check) {
    model_.checks = {check};
    const results::CheckResult found = evaluate_checks(model_, run_).front();
    return found.trouble.empty() ? found.found : AnswerReading().value;
  }

private:
  model::Model model_;
  results::RunResult run_;
};

// A component of the stress in the place of the displacement in X. [dim * node]
base::Vector as_displacement(const NodalFields& fields, const std::string& component, int dim) {
  base::Vector u = base::Vector::Zero(fields.u.size());
  for (std::size_t n = 0; n < fields.stress.size(); ++n) {
    u[static_cast<Eigen::Index>(n) * dim] =
        results::stress_component(fields.stress[n], component).value_or(AnswerReading().value);
  }
  return u;
}

} // namespace

std::vector<AnswerReading> peer_answers(const model::Model& model,
                                        const std::vector<Answer>& answers,
                                        const NodalFields& fields) {
  std::vector<AnswerReading> readings(answers.size());
  std::map<std::string, std::vector<std::size_t>> stresses; // by component
  NodalRun run(model);
  run.set(fields.u);
  for (std::size_t a = 0; a < answers.size(); ++a) {
    if (answers[a].group == AnswerGroup::displacement) {
      readings[a].value = run.value(answers[a].check);
    } else if (const std::string component = component_of(answers[a]); !component.empty()) {
      stresses[component].push_back(a);
    }
  }
  for (const auto& [component, asked] : stresses) {
    run.set(as_displacement(fields, component, model.mesh.dim));
    for (const std::size_t a : asked) {
      model::ResultCheck check = answers[a].check;
      check.quantity = "U.X" + check.quantity.substr(check.quantity.rfind('.'));
      readings[a].value = run.value(check);
    }
  }
  return readings;
}

} // namespace spricka::program
