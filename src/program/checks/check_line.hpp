// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "model/requests.hpp"
#include "results/results.hpp"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fmt/format.h>

/// A line of $CHECK while it is read, and the families of quantities that it may ask for.
namespace spricka::program {

/// Why a quantity has no value; caught where the line is evaluated.
struct MissingQuantity : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The arguments of one check, taken from the left.
class CheckArguments {
public:
  explicit CheckArguments(const model::ResultCheck& check) : check_(check) {}

  /// The next argument, which must be a name. Throws MissingQuantity "... expects `what` as
  /// argument n".
  std::string required_name(const char* what) {
    if (next_ >= check_.arguments.size() ||
        !std::holds_alternative<std::string>(check_.arguments[next_])) {
      throw MissingQuantity(
          fmt::format("{} expects {} as argument {}", check_.quantity, what, next_ + 1));
    }
    return std::get<std::string>(check_.arguments[next_++]);
  }
  /// The next argument if it is a number; empty, and nothing is taken, if it is not.
  std::optional<double> optional_number() {
    if (next_ < check_.arguments.size() &&
        std::holds_alternative<double>(check_.arguments[next_])) {
      return std::get<double>(check_.arguments[next_++]);
    }
    return std::nullopt;
  }
  /// The next argument, which must be a number. Throws MissingQuantity as required_name does.
  double required_number(const char* what) {
    const std::optional<double> value = optional_number();
    if (!value) {
      throw MissingQuantity(
          fmt::format("{} expects {} as argument {}", check_.quantity, what, next_ + 1));
    }
    return *value;
  }
  /// The next arguments, which must be as many coordinates; what is left of a point is 0.
  base::Vec3 required_point(int dim) {
    base::Vec3 x = base::Vec3::Zero();
    for (int d = 0; d < dim; ++d) {
      x[d] = required_number(std::array{"x", "y", "z"}.at(static_cast<std::size_t>(d)));
    }
    return x;
  }

private:
  const model::ResultCheck& check_;
  std::size_t next_ = 0;
};

/// A line of $CHECK: its word, and what is left of its arguments.
struct CheckLine {
  const model::Model& model;
  const results::RunResult& run;
  const std::string& word;
  CheckArguments args;
};

struct CheckedStep {
  const results::CrackLengthResult* increment = nullptr;
  const results::LoadStepResult* step = nullptr;
};

/// The increment whose length is `a` (to 1e-6), or the last one when no length is given.
CheckedStep find_checked_increment_and_step(const results::RunResult& run, const std::string& step,
                                            std::optional<double> a);

/// The same, of a step and length that come next among the arguments.
inline CheckedStep read_step_argument(CheckLine& line) {
  const std::string step = line.args.required_name("a step");
  return find_checked_increment_and_step(line.run, step, line.args.optional_number());
}

/// Nodes of the node, face or element set of that name, perhaps several times.
std::vector<base::NodeId> nodes_of_named_set(const model::Mesh& mesh, const std::string& name);

/// The number of a direction X, Y or Z.
Eigen::Index axis_index(const std::string& component);

/// U.X.MAX, S.XX.AT and their like.
double evaluate_field_quantity(CheckLine& line);

/// Whether a word of $CHECK is of a front, at the end of a step, on a load path or a derivative: in
/// the plane K1, DK1.LOAD, PATH.K1 and their like, of one tip; in space K1.AT, G.MAX and theirs.
bool is_front_quantity(std::string_view word);
/// Its value. What the front does not have is Missing.
double evaluate_front_quantity(CheckLine& line);

/// PATH.SLOPE, PATH.OPENING and their like, but for K itself (evaluate_front_quantity). What a path
/// does not cover is Missing: nothing is extrapolated.
double evaluate_path_quantity(CheckLine& line);
/// The path of that name with the place t on it.
const results::LoadPathResult& find_load_path(const results::RunResult& run,
                                              const std::string& name, double t,
                                              std::optional<double> a);
/// Why K along a front, at a place of a load path, is no answer: K1 < 0, as at the end of a step.
/// Empty: it is one.
std::string invalid_k1_reason(const results::FrontResult& front);

/// Whether $CHECK asks a contact for that word: CPRESS.MAX, ARC.FROM and their like.
bool is_contact_quantity(std::string_view word);
/// The value of such a word. Throws Missing where there is none.
double evaluate_contact_quantity(CheckLine& line);

/// TEST.K, TEST.RATIO and their like.
double evaluate_growth_test_quantity(CheckLine& line);

} // namespace spricka::program
