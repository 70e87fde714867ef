// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/face_choice.hpp"

#include "grammar/lexeme.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace spricka::deck {

namespace {

using grammar::CardField;
using Kind = CardField::CardFieldKind;
using FaceList = std::vector<std::array<int, 2>>;

constexpr std::string_view row_form =
    "F3 F4 = NAME [size], or CYLINDER radius, PLANE X|-X.., (condition in x y z) = NAME [size]";
constexpr std::array<std::string_view, 6> face_kinds{"PLANE",  "CYLINDER", "CONE",
                                                     "SPHERE", "TORUS",    "CURVED"};

/// What a line asks of a face.
struct FaceCondition {
  std::string kind; ///< empty: any
  std::optional<double> radius;
  std::optional<base::Vec3> normal;
  std::optional<base::CompiledExpression> where;
};

bool holds(const FaceCondition& condition, const mesh::StepFace& face, double scale) {
  constexpr double equal = 1e-4; // of a radius, and of a unit vector
  if (!condition.kind.empty() && grammar::to_upper(face.kind) != condition.kind) {
    return false;
  }
  if (condition.radius &&
      std::abs(face.radius * scale - *condition.radius) > equal * *condition.radius) {
    return false;
  }
  if (condition.normal && (face.direction - *condition.normal).norm() > equal) {
    return false;
  }
  return !condition.where ||
         (!face.points.empty() && std::ranges::all_of(face.points, [&](const base::Vec3& x) {
           return (*condition.where)(scale * x) == 1.0;
         }));
}

std::optional<base::Vec3> axis_direction(const CardField& field) {
  const std::size_t axis = std::string_view("XYZ").find(field.text);
  if (field.text.size() != 1 || axis == std::string_view::npos) {
    return std::nullopt;
  }
  const double sign = field.kind == Kind::minus_name ? -1.0 : 1.0;
  return sign * base::Vec3::Unit(static_cast<Eigen::Index>(axis));
}

/// Reads the fields of a line in front of '=', one after another.
class ConditionReader {
public:
  ConditionReader(DeckContext& context, FaceCondition& condition)
      : c_(context), condition_(condition) {}

  bool take(const CardField& field) {
    if (field.is_name() && condition_.kind.empty() &&
        std::ranges::find(face_kinds, field.text) != face_kinds.end()) {
      condition_.kind = field.text;
      return true;
    }
    if (condition_.kind == "PLANE" && (field.is_name() || field.kind == Kind::minus_name)) {
      condition_.normal = axis_direction(field);
      return condition_.normal ? true : refuse(field);
    }
    if (field.kind == Kind::expression && grammar::is_condition(field.expression)) {
      condition_.where = grammar::compile_expression(
          field.expression, c_.scope, grammar::AllowedVariables::position, c_.diagnostics);
      return condition_.where.has_value();
    }
    const bool round = condition_.kind == "CYLINDER" || condition_.kind == "SPHERE";
    if (round && !condition_.radius && field.is_number_or_expression()) {
      condition_.radius = c_.read_number(field, grammar::QuantityKind::length, "a radius");
      return condition_.radius.has_value();
    }
    return refuse(field);
  }

private:
  bool refuse(const CardField& field) {
    c_.error(field.span, "E115", fmt::format("'{}' chooses no faces", c_.sources.text(field.span)),
             std::string(row_form));
    return false;
  }

  DeckContext& c_;
  FaceCondition& condition_;
};

} // namespace

std::string FaceChoices::radii_hint(const std::string& kind) const {
  std::set<std::string> radii;
  for (const int i : request_.solids) {
    for (const mesh::StepFace& face : contents_.solids[static_cast<std::size_t>(i)].faces) {
      if (grammar::to_upper(face.kind) == kind && face.radius > 0.0) {
        radii.insert(fmt::format("{:.6g}", scale_ * face.radius));
      }
    }
  }
  return radii.empty() ? "spricka check prints a table of all faces"
                       : fmt::format("there are radii {}", fmt::join(radii, ", "));
}

std::optional<FaceList> FaceChoices::faces_by_number(DeckContext& c, const Fields& fields) const {
  FaceList faces;
  for (const CardField& field : fields) {
    const auto group = std::ranges::find_if(request_.groups, [&](const auto& g) {
      return field.is_name() && g.solid < 0 && g.name == field.text;
    });
    if (group == request_.groups.end()) {
      std::vector<std::string> names;
      for (const mesh::StepMeshGroup& g : request_.groups) {
        if (g.solid < 0) {
          names.push_back(g.name);
        }
      }
      c.error(field.span, "E332", fmt::format("there is no face {}", c.sources.text(field.span)),
              base::make_spelling_hint(field.text, names));
      return std::nullopt;
    }
    for (const std::array<int, 2>& face : group->faces) {
      if (std::ranges::find(faces, face) == faces.end()) {
        faces.push_back(face);
      }
    }
  }
  return faces;
}

std::optional<FaceList> FaceChoices::faces_by_shape(DeckContext& c, const Fields& fields,
                                                    base::SourceSpan row) const {
  FaceCondition condition;
  ConditionReader reader(c, condition);
  if (!std::ranges::all_of(fields, [&](const CardField& field) { return reader.take(field); })) {
    return std::nullopt;
  }
  FaceList faces;
  for (const int i : request_.solids) {
    const std::vector<mesh::StepFace>& all = contents_.solids[static_cast<std::size_t>(i)].faces;
    for (std::size_t f = 0; f < all.size(); ++f) {
      if (holds(condition, all[f], scale_)) {
        faces.push_back({i, static_cast<int>(f)});
      }
    }
  }
  if (faces.empty()) {
    c.error(row, "E332", "no face is so",
            condition.radius ? radii_hint(condition.kind)
                             : "spricka check prints a table of all faces");
    return std::nullopt;
  }
  return faces;
}

std::optional<NamedFaces> FaceChoices::read_row(DeckContext& c, const grammar::DataRow& row) const {
  const auto equals = std::ranges::find_if(
      row.fields, [](const CardField& field) { return field.separator == '='; });
  const auto name = equals == row.fields.end() ? equals : equals + 1;
  const auto behind = name == row.fields.end() ? name : name + 1;
  if (behind == name || !name->is_name() || name->text.find('.') != std::string::npos ||
      row.fields.end() - behind > 1) {
    c.error(row.span, "E115", "a line is 'faces = NAME [size]'", std::string(row_form));
    return std::nullopt;
  }
  const Fields chosen(row.fields.begin(), name);
  const bool by_number = chosen.front().is_name() &&
                         std::ranges::find(face_kinds, chosen.front().text) == face_kinds.end();
  const std::optional<FaceList> faces =
      by_number ? faces_by_number(c, chosen) : faces_by_shape(c, chosen, row.span);
  if (!faces) {
    return std::nullopt;
  }
  NamedFaces named{.name = name->text, .faces = *faces};
  if (behind != row.fields.end()) {
    const auto size = c.read_number(*behind, grammar::QuantityKind::length, "a size");
    if (!size) {
      return std::nullopt;
    }
    if (*size <= 0.0) {
      c.error(behind->span, "E109", fmt::format("a size is above 0, not {:.6g}", *size));
      return std::nullopt;
    }
    named.size = *size;
  }
  return named;
}

} // namespace spricka::deck
