// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "model/requests.hpp"
#include "results/results.hpp"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

/// Displacements and stresses that $CHECK asks for, and what all its quantities share.
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
  std::string next_name(const char* what) {
    if (next_ >= check_.arguments.size() ||
        !std::holds_alternative<std::string>(check_.arguments[next_])) {
      throw MissingQuantity(
          fmt::format("{} expects {} as argument {}", check_.quantity, what, next_ + 1));
    }
    return std::get<std::string>(check_.arguments[next_++]);
  }
  /// The next argument if it is a number; empty, and nothing is taken, if it is not.
  std::optional<double> next_number() {
    if (next_ < check_.arguments.size() &&
        std::holds_alternative<double>(check_.arguments[next_])) {
      return std::get<double>(check_.arguments[next_++]);
    }
    return std::nullopt;
  }
  /// The next argument, which must be a number. Throws MissingQuantity as next_name does.
  double required_number(const char* what) {
    const std::optional<double> value = next_number();
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

struct CheckedStep {
  const results::Increment* increment = nullptr;
  const results::StepResult* step = nullptr;
};

/// The increment whose length is `a` (to 1e-6), or the last one when no length is given.
CheckedStep find_checked_step(const results::RunResult& run, const std::string& step,
                              std::optional<double> a);

/// Nodes of the node, face or element set of that name, perhaps several times.
std::vector<base::NodeId> nodes_of_named_set(const model::Mesh& mesh, const std::string& name);

/// The number of a direction X, Y or Z.
Eigen::Index axis_index(const std::string& component);

/// U.X.MAX, S.XX.AT and their like.
double evaluate_field_quantity(const model::Model& model, const std::string& quantity,
                               CheckArguments& args, const results::RunResult& run);

} // namespace spricka::program
