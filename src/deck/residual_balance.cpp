// SPDX-License-Identifier: GPL-3.0-or-later
#include "deck/residual_balance.hpp"

#include "base/element_type.hpp"
#include "deck/context.hpp"
#include "model/mesh_side.hpp"
#include "shape/topology.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace spricka::deck {

namespace {

using base::Vec3;

/// A flat section of a body.
struct FlatSection {
  Vec3 place = Vec3::Zero();
  Vec3 normal = Vec3::UnitY(); ///< unit
};

/// A piece of a section, small beside its element.
struct CrackSectionPiece {
  Vec3 x = Vec3::Zero();
  double area = 0.0; ///< in the plane its length
};

// That of a straight or flat crack; empty: of another.
std::optional<FlatSection> section_of_crack(const model::Model& model,
                                            const model::CrackDefinition& crack) {
  if (!crack.is_line()) {
    return crack.kind == model::CrackDefinitionKind::front
               ? std::nullopt
               : std::optional(FlatSection{crack.plane.place, crack.plane.normal});
  }
  std::vector<Vec3> line = crack.points;
  if (crack.kind == model::CrackDefinitionKind::path && crack.path.valid()) {
    for (const base::NodeId n : model.mesh.set_with_id(crack.path).nodes) {
      line.push_back(model.mesh.x[n.index()]);
    }
  }
  if (crack.angle && line.size() == 1) {
    line.emplace_back(line.front() + Vec3(std::cos(*crack.angle), std::sin(*crack.angle), 0.0));
  }
  if (line.size() < 2) {
    return std::nullopt;
  }
  const Vec3 along = line.back() - line.front();
  const FlatSection section{line.front(), Vec3(-along.y(), along.x(), 0.0).normalized()};
  constexpr double straight = 1e-6;
  const bool flat = std::ranges::all_of(line, [&](const Vec3& x) {
    return std::abs(section.normal.dot(x - section.place)) <= straight * along.norm();
  });
  return flat && along.norm() > 0.0 ? std::optional(section) : std::nullopt;
}

/// The pieces of a section, element by element of a net.
class CrackSectionCutter {
public:
  CrackSectionCutter(const model::Mesh& mesh, const FlatSection& section)
      : mesh_(mesh), section_(section) {}

  std::vector<CrackSectionPiece> cut(base::NetId net) {
    for (std::size_t i = 0; i < mesh_.element_count(); ++i) {
      if (mesh_.element_net[i] == net) {
        cut_element(base::ElementId(i));
      }
    }
    return std::move(pieces_);
  }

private:
  static constexpr int halvings = 3; // of the lines and triangles of an element

  // An edge that lies in the section counts to the element below it alone.
  void cross(const Vec3& a, const Vec3& b, std::vector<Vec3>& crossings) const {
    const double from = section_.normal.dot(a - section_.place);
    const double to = section_.normal.dot(b - section_.place);
    if ((from < 0.0) != (to < 0.0)) {
      crossings.emplace_back(a + from / (from - to) * (b - a));
    }
  }

  void cut_element(base::ElementId e) {
    std::vector<std::array<Vec3, 2>> lines; // of the section, one in each side
    std::vector<Vec3> ends;                 // in the plane: where it passes through the outline
    for (int s = 0; s < base::element_info(mesh_.type[e.index()]).sides; ++s) {
      const std::size_t corners = shape::side_corner_count(mesh_.type[e.index()], s);
      const std::vector<base::NodeId> nodes = model::side_nodes(mesh_, {e, s});
      const auto x = [&](std::size_t k) { return mesh_.x[nodes[k].index()]; };
      if (corners == 2) { // in the plane: corners, then the middle
        const Vec3 middle = nodes.size() > 2 ? x(2) : Vec3(0.5 * (x(0) + x(1)));
        cross(x(0), middle, ends);
        cross(middle, x(1), ends);
        continue;
      }
      std::vector<Vec3> crossings;
      for (std::size_t k = 0; k < corners; ++k) {
        cross(x(k), x((k + 1) % corners), crossings);
      }
      if (crossings.size() == 2) {
        lines.push_back({crossings[0], crossings[1]});
      }
    }
    add_intervals(ends);
    add_triangles(lines);
  }

  void add_intervals(std::vector<Vec3>& ends) {
    const Vec3 along = section_.normal.cross(Vec3::UnitZ());
    std::ranges::sort(ends, {}, [&](const Vec3& x) { return along.dot(x); });
    constexpr int parts = 1 << halvings;
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
      const Vec3 step = (ends[k + 1] - ends[k]) / parts;
      for (int i = 0; i < parts; ++i) {
        pieces_.push_back({ends[k] + (i + 0.5) * step, step.norm()});
      }
    }
  }

  void add_triangles(const std::vector<std::array<Vec3, 2>>& lines) {
    Vec3 middle = Vec3::Zero();
    for (const auto& [a, b] : lines) {
      middle += 0.5 * (a + b) / static_cast<double>(lines.size());
    }
    for (const auto& [a, b] : lines) {
      add_triangle(middle, a, b, halvings);
    }
  }

  void add_triangle(const Vec3& a, const Vec3& b, const Vec3& c, int more) {
    if (more == 0) {
      pieces_.push_back({(a + b + c) / 3.0, 0.5 * (b - a).cross(c - a).norm()});
      return;
    }
    const Vec3 ab = 0.5 * (a + b);
    const Vec3 bc = 0.5 * (b + c);
    const Vec3 ca = 0.5 * (c + a);
    add_triangle(a, ab, ca, more - 1);
    add_triangle(ab, b, bc, more - 1);
    add_triangle(ca, bc, c, more - 1);
    add_triangle(ab, bc, ca, more - 1);
  }

  const model::Mesh& mesh_;
  const FlatSection& section_;
  std::vector<CrackSectionPiece> pieces_;
};

/// What a stress across a section adds up to.
struct SectionBalance {
  double force = 0.0;
  double absolute_force = 0.0;
  Vec3 moment = Vec3::Zero(); ///< about the middle of the section
  double absolute_moment = 0.0;
  std::optional<Vec3> unknown = {}; ///< a place where the stress has no value
};

SectionBalance balance_over_section(const std::vector<CrackSectionPiece>& pieces,
                                    const FlatSection& section,
                                    const base::CompiledExpression& stress) {
  SectionBalance sum;
  Vec3 middle = Vec3::Zero();
  double area = 0.0;
  for (const CrackSectionPiece& piece : pieces) {
    middle += piece.area * piece.x;
    area += piece.area;
  }
  middle /= area;
  for (const CrackSectionPiece& piece : pieces) {
    const double force = stress(piece.x) * piece.area;
    if (!std::isfinite(force)) {
      sum.unknown = piece.x;
      return sum;
    }
    const Vec3 unit_moment = (piece.x - middle).cross(section.normal);
    sum.force += force;
    sum.absolute_force += std::abs(force);
    sum.moment += force * unit_moment;
    sum.absolute_moment += std::abs(force) * unit_moment.norm();
  }
  return sum;
}

void check_line(DeckContext& c, const model::LoadCase& load_case, const model::Load& load,
                const model::CrackDefinition& crack) {
  constexpr double noticed = 0.01;
  std::optional<FlatSection> section = section_of_crack(c.model, crack);
  if (!section || model::is_axisymmetric(c.model)) {
    return;
  }
  std::vector<CrackSectionPiece> pieces = CrackSectionCutter(c.model.mesh, *section).cut(crack.net);
  if (pieces.empty()) { // a half model, whose elements lie above it
    section->normal = -section->normal;
    pieces = CrackSectionCutter(c.model.mesh, *section).cut(crack.net);
  }
  if (pieces.empty()) {
    return;
  }
  const SectionBalance sum = balance_over_section(pieces, *section, load.value.front());
  const std::string what =
      fmt::format("load case {}, section of the body through crack {}", load_case.name, crack.name);
  if (sum.unknown) {
    c.warning(load.span, "W373",
              fmt::format("{}: the residual stress has no value at ({:.4g}, {:.4g}, {:.4g}): "
                          "whether it is in equilibrium is not known",
                          what, sum.unknown->x(), sum.unknown->y(), sum.unknown->z()),
              "give it all over the section, as by rho or abs(x)");
    return;
  }
  if (std::abs(sum.force) > noticed * sum.absolute_force ||
      sum.moment.norm() > noticed * sum.absolute_moment) {
    c.warning(load.span, "W373",
              fmt::format("{}: the residual stress is not in equilibrium: it has a force of {:.4g} "
                          "and a moment of {:.4g}{}, where its absolute values have {:.4g} and "
                          "{:.4g}",
                          what, sum.force, sum.moment.norm(),
                          crack.is_line() ? " for a unit of thickness" : "", sum.absolute_force,
                          sum.absolute_moment),
              "a residual stress has neither: correct it by its mean and its slope over the "
              "section; a pressure that acts on the faces alone is TYPE=FACES");
  }
}

} // namespace

void check_residual_balance(DeckContext& context) {
  context.for_each_sound_card("LOAD", [&](const CheckedCard& card) {
    if (!card.key_has_word("TYPE", "RESIDUAL")) {
      return;
    }
    for (const model::LoadCase& load_case : context.model.cases) {
      for (const model::Load& load : load_case.loads) {
        const bool of_card = std::ranges::any_of(card.rows, [&](const grammar::DataRow& row) {
          return row.span.file == load.span.file && row.span.begin == load.span.begin;
        });
        const auto crack =
            std::ranges::find_if(context.model.cracks, [&](const model::CrackDefinition& known) {
              return known.left == load.faces;
            });
        if (of_card && load.faces.valid() && crack != context.model.cracks.end()) {
          check_line(context, load_case, load, *crack);
        }
      }
    }
  });
}

} // namespace spricka::deck
