// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/checks/check_quantities.hpp"

#include "analysis/scene/gone_nodes.hpp"
#include "model/model.hpp"
#include "program/checks/check_line.hpp"
#include "results/growth_end.hpp"
#include "results/result_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

namespace spricka::program {

namespace {

double reaction(CheckLine& line) {
  auto& [model, run, word, args] = line;
  const std::string set = args.required_name("a set");
  const std::string step = args.required_name("a step");
  const Eigen::Index axis = axis_index(args.required_name("X, Y or Z"));
  const CheckedStep at = find_checked_increment_and_step(run, step, args.optional_number());
  if (const auto missing = analysis::find_removed_held_node(model, at.increment->mesh, set)) {
    throw MissingQuantity(
        fmt::format("the patch of a crack has replaced node {} of the support: ask for a "
                    "set with the whole edge there",
                    model.mesh.node_label[missing->index()]));
  }
  std::vector<base::NodeId> nodes = nodes_of_named_set(at.increment->mesh, set);
  std::sort(nodes.begin(), nodes.end());
  // Elements of a set share nodes, whose reaction counts once.
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  double sum = 0.0;
  for (const base::NodeId n : nodes) {
    sum += at.step->reaction[static_cast<Eigen::Index>(n.index()) * at.increment->mesh.dim + axis];
  }
  return sum;
}

double energy(CheckLine& line) {
  const std::string net = line.args.required_name("a net or *");
  const results::LoadStepResult& at = *read_step_argument(line).step;
  if (net == "*") {
    return at.energy;
  }
  const auto found = std::ranges::find(at.nets, net, &results::ForceBalance::body);
  if (found == at.nets.end()) {
    throw MissingQuantity(fmt::format("net {} has no elements", net));
  }
  return found->energy;
}

double estimated_error(CheckLine& line) {
  const std::string net = line.args.required_name("a net or *");
  const results::LoadStepResult& at = *read_step_argument(line).step;
  const auto found = std::ranges::find(at.errors, net, &results::NetErrorEstimate::net);
  if (found == at.errors.end()) {
    throw MissingQuantity(fmt::format("net {} has no elements outside crack patches", net));
  }
  return found->part;
}

// Cycles until the first of the growing tips has a length, or to the end.
double cycles(CheckLine& line) {
  auto& [model, run, word, args] = line;
  if (!run.growth) {
    throw MissingQuantity("no crack grows by a law");
  }
  if (results::growth_could_not_continue(*run.growth)) {
    throw MissingQuantity("the growth ended early: " + run.growth->reason);
  }
  if (word == "LIFE") {
    return run.growth->final_cycles();
  }
  const std::optional<double> a = args.optional_number();
  double first = std::numeric_limits<double>::infinity();
  for (std::size_t tip = 0; a && tip < run.growth->point_names.size(); ++tip) {
    const double at = results::cycles_at_length(*run.growth, tip, *a);
    first = at < first ? at : first;
  }
  if (!(first < std::numeric_limits<double>::infinity())) {
    throw MissingQuantity("no tip of the growth has that length");
  }
  return first;
}

using Reader = double (*)(CheckLine&);

// Words that are not of a front or a contact, by what stands in front of their first point.
struct QuantityFamily {
  std::string_view name;
  Reader read;
};
constexpr std::array families{QuantityFamily{"PATH", evaluate_path_quantity},
                              QuantityFamily{"TEST", evaluate_growth_test_quantity},
                              QuantityFamily{"N", cycles},
                              QuantityFamily{"LIFE", cycles},
                              QuantityFamily{"ENERGY", energy},
                              QuantityFamily{"ERROR", estimated_error},
                              QuantityFamily{"REACTION", reaction},
                              QuantityFamily{"U", evaluate_field_quantity},
                              QuantityFamily{"S", evaluate_field_quantity}};

Reader reader_of(std::string_view word) {
  if (is_front_quantity(word)) {
    return evaluate_front_quantity;
  }
  if (is_contact_quantity(word)) {
    return evaluate_contact_quantity;
  }
  const auto* const found =
      std::ranges::find(families, word.substr(0, word.find('.')), &QuantityFamily::name);
  return found == families.end() ? nullptr : found->read;
}

double evaluate(const model::Model& model, const model::ResultCheck& check,
                const results::RunResult& run) {
  const Reader read = reader_of(check.quantity);
  if (read == nullptr) {
    throw MissingQuantity(fmt::format("{} is not available in this version", check.quantity));
  }
  CheckLine line{model, run, check.quantity, CheckArguments(check)};
  return read(line);
}

// Of K at one place.
double bar_of(const model::Model& model, const model::ResultCheck& check,
              const results::RunResult& run) {
  model::ResultCheck asked = check;
  asked.quantity = error_bar_part_quantity_word(check.quantity, "BAR");
  const bool one_place = !asked.quantity.ends_with(".MIN") && !asked.quantity.ends_with(".MAX");
  if (!asked.quantity.empty() && one_place) {
    try {
      return evaluate(model, asked, run);
    } catch (const MissingQuantity&) { // it has none here
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::string check_text(const model::ResultCheck& check) {
  std::string text = check.quantity + "(";
  for (std::size_t i = 0; i < check.arguments.size(); ++i) {
    text += i > 0 ? "," : "";
    text += std::holds_alternative<std::string>(check.arguments[i])
                ? std::get<std::string>(check.arguments[i])
                : fmt::format("{:.6g}", std::get<double>(check.arguments[i]));
  }
  return text + ")";
}

bool is_checkable_quantity(std::string_view word) {
  return reader_of(word) != nullptr;
}

results::CheckResult evaluate_check(const model::Model& model, const model::ResultCheck& check,
                                    const results::RunResult& run) {
  results::CheckResult result;
  result.text = check_text(check);
  result.wanted = results::wanted_value(model.units, check, run);
  result.tolerance = results::check_tolerance(model.units, check, run);
  result.relative = check.relative;
  result.source = check.source;
  try {
    result.found = evaluate(model, check, run);
    const double difference = result.found - result.wanted;
    result.error = check.relative ? difference / std::abs(result.wanted) : difference;
    result.passed = std::abs(result.error) <= result.tolerance;
    result.bar = bar_of(model, check, run);
  } catch (const MissingQuantity& missing) {
    result.trouble = missing.what();
  }
  return result;
}

std::vector<results::CheckResult> evaluate_checks(const model::Model& model,
                                                  const results::RunResult& run) {
  std::vector<results::CheckResult> all;
  for (const model::ResultCheck& check : model.checks) {
    all.push_back(evaluate_check(model, check, run));
  }
  return all;
}

} // namespace spricka::program
