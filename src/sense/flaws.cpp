// SPDX-License-Identifier: GPL-3.0-or-later
#include "sense/flaws.hpp"

#include "fe/dof_map.hpp"
#include "mesh/tube/crack_extent.hpp"
#include "mesh/tube/solid_crack.hpp"
#include "model/model.hpp"
#include "sense/find_kink.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace spricka::sense {

namespace {

using base::Vec3;
using mesh::BodyFaceAtCrackMouth;
using mesh::CrackConfiguration;
using mesh::CrackExtentInBody;

constexpr double degree = 180.0 / std::numbers::pi;

std::string place_of(const Vec3& x) {
  const auto tidy = [](double v) { return std::abs(v) < 1e-12 ? 0.0 : v; };
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", tidy(x.x()), tidy(x.y()), tidy(x.z()));
}

std::string name_of_face(const BodyFaceAtCrackMouth& face) {
  return face.name.empty() ? "the face at " + place_of(face.at) : face.name;
}

std::string join(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return text;
}

class Flaws {
public:
  Flaws(const model::Model& model, base::Diagnostics& list)
      : model_(model), list_(list), host_(model.mesh),
        cls_(fe::classify_freedoms(model, model.mesh)) {}

  std::vector<std::string> tell() {
    std::vector<std::string> lines;
    for (const mesh::SolidCrack& cut : mesh::make_solid_cracks(model_)) {
      const model::CrackDefinition& crack = model_.cracks[cut.crack.index()];
      look_for_kinks(crack);
      const std::optional<CrackExtentInBody> extent = mesh::measure_crack_in_body(host_, cut);
      if (!extent) {
        continue;
      }
      lines.push_back(line_of(crack, *extent));
      compare_with_drawn(crack, *extent);
      look_for_edge(crack, *extent);
      look_at_section(crack, *extent);
      look_at_symmetry(crack, *extent);
      look_at_elements(crack, *extent);
    }
    return lines;
  }

private:
  [[nodiscard]] std::string length(double value) const {
    return fmt::format("{:.4g} {}", value, model_.units.length_name);
  }

  [[nodiscard]] std::string line_of(const model::CrackDefinition& crack,
                                    const CrackExtentInBody& extent) const {
    std::string text =
        fmt::format("crack {}: {} crack", crack.name, mesh::configuration_name(extent.kind));
    const std::string along = lengths_of(extent, " (held as a plane of symmetry)");
    text += along.empty() ? "" : ", " + along;
    if (extent.kind == CrackConfiguration::surface) {
      text += ", " + length(extent.depth) + " deep";
    } else if (extent.kind == CrackConfiguration::embedded) {
      text += fmt::format(", {} from {}", length(extent.depth),
                          extent.nearest.empty() ? "the surface" : extent.nearest);
    }
    text += fmt::format(", area {:.4g} {}^2", extent.area, model_.units.length_name);
    if (crack.kind == model::CrackDefinitionKind::ellipse &&
        extent.kind != CrackConfiguration::embedded) {
      text += fmt::format(", {:.3g} % of the ellipse drawn", 100.0 * extent.drawn);
    }
    return text;
  }

  // A face that cuts the ellipse off beside its centre: the flaw is none of the quarters and halves
  // that A and C tell. A through crack whose ends on both faces are as far is one with a bowed
  // front, and the longer the ellipse, the straighter that is.
  void compare_with_drawn(const model::CrackDefinition& crack, const CrackExtentInBody& extent) {
    if (crack.kind != model::CrackDefinitionKind::ellipse) {
      return;
    }
    constexpr double on_it = 0.05;           // of the ellipse: coarse facets lie off a round wall
    constexpr double nearly_straight = 0.25; // ends within 3 % of the axis on both faces
    constexpr double alike = 0.05;
    constexpr double opposite = 0.9; // cosine
    const bool through = extent.kind == CrackConfiguration::through;
    std::vector<std::string> off;
    std::vector<const BodyFaceAtCrackMouth*> cut;
    for (const BodyFaceAtCrackMouth& face : extent.open) {
      if (std::abs(face.offset) < (through ? nearly_straight : on_it) || held_across(face)) {
        continue;
      }
      cut.push_back(&face);
      off.push_back(
          fmt::format("{:.0f} % of the ellipse's radius {} {}", 100.0 * std::abs(face.offset),
                      face.offset > 0.0 ? "inside of" : "outside of", name_of_face(face)));
    }
    const bool bowed = through && cut.size() == 2 &&
                       cut[0]->normal.dot(cut[1]->normal) < -opposite && cut[0]->offset > 0.0 &&
                       std::abs(cut[0]->offset - cut[1]->offset) < alike;
    if (off.empty() || bowed) {
      return;
    }
    list_.warning(crack.span, "W460",
                  fmt::format("crack {}: its centre lies {}: neither on the surface nor so deep "
                              "that the body has all of the ellipse. The flaw is a {} crack of "
                              "{:.3g} % of the ellipse, {}",
                              crack.name, join(off), mesh::configuration_name(extent.kind),
                              100.0 * extent.drawn, lengths_of(extent, "")),
                  through ? "a through crack is drawn by its front, two points beyond the body, or "
                            "by an ellipse much longer than the body is thick"
                          : "put X0 Y0 Z0 on the edge of a corner crack, on the face of a surface "
                            "crack");
  }

  // `held`: what is said of faces that are held across.
  [[nodiscard]] std::string lengths_of(const CrackExtentInBody& extent, const char* held) const {
    std::vector<std::string> along;
    for (const BodyFaceAtCrackMouth& face : extent.open) {
      along.push_back(length(face.length) + " along " + name_of_face(face) +
                      (held_across(face) ? held : ""));
    }
    return join(along);
  }

  // A surface crack beside an edge, nearer than half its own length and nowhere near another one:
  // as a corner crack whose centre has missed its edge.
  void look_for_edge(const model::CrackDefinition& crack, const CrackExtentInBody& extent) {
    constexpr double eccentric = 2.0;
    if (crack.kind != model::CrackDefinitionKind::ellipse ||
        extent.kind != CrackConfiguration::surface) {
      return;
    }
    const std::size_t end = extent.to_edge[0] < extent.to_edge[1] ? 0 : 1;
    const double near = extent.to_edge.at(end);
    double mouth = 0.0;
    for (const BodyFaceAtCrackMouth& face : extent.open) {
      mouth += face.length;
    }
    if (near < 0.5 * mouth && extent.to_edge.at(1 - end) > eccentric * near) {
      list_.warning(crack.span, "W460",
                    fmt::format("crack {}: a surface crack {} long whose end is only {} from the "
                                "edge of the body at {}",
                                crack.name, length(mouth), length(near),
                                place_of(extent.edge.at(end))),
                    "a corner crack has X0 Y0 Z0 on that edge; where the body has another "
                    "thickness than before, the crack's place is another, too");
    }
  }

  void look_at_section(const model::CrackDefinition& crack, const CrackExtentInBody& extent) {
    constexpr double most = 0.75;
    if (extent.of_section > most) { // false where it is not a number
      list_.warning(crack.span, "W461",
                    fmt::format("crack {}: it is {:.3g} % of the section that its front divides",
                                crack.name, 100.0 * extent.of_section),
                    crack.kind == model::CrackDefinitionKind::drawn
                        ? "X0 Y0 Z0 is a point within the crack: it tells which side of the front "
                          "is cracked"
                        : "look at A and C, and at their unit");
    }
  }

  // Of the two faces at a corner crack one is a plane of symmetry. $SYMMETRY has found out that the
  // crack is drawn for the whole body; by supports alone nobody knows.
  void look_at_symmetry(const model::CrackDefinition& crack, const CrackExtentInBody& extent) {
    if (extent.kind != CrackConfiguration::corner || extent.open.size() != 2 ||
        !model_.mirrors.empty()) {
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const BodyFaceAtCrackMouth& face = extent.open[i];
      const BodyFaceAtCrackMouth& other = extent.open[1 - i];
      if (held_across(face) && !held_across(other)) {
        list_.warning(crack.span, "W462",
                      fmt::format("crack {}: {} is held across like a plane of symmetry. In the "
                                  "whole body this is no corner crack but a surface crack, {} "
                                  "long on {}",
                                  crack.name, name_of_face(face), length(2.0 * other.length),
                                  name_of_face(other)),
                      "draw a corner crack at the free face; $SYMMETRY makes the half of a "
                      "surface crack that is meant, without this warning");
      }
    }
  }

  void look_at_elements(const model::CrackDefinition& crack, const CrackExtentInBody& extent) {
    const base::ElementInfo& info = base::element_info(model_.mesh.type[extent.seed.index()]);
    if (!info.quadratic) {
      list_.warning(crack.span, "W426",
                    fmt::format("crack {}: the elements round it are linear ({}): they are too "
                                "stiff in bending, and K gets no error bar that would tell by how "
                                "much it is off",
                                crack.name, info.name),
                    "quadratic elements: Mesh.ElementOrder = 2 in gmsh, HEXEC20, TET10");
    }
  }

  /// Whether all nodes of a plane face across an axis are held along that axis.
  [[nodiscard]] bool held_across(const BodyFaceAtCrackMouth& face) const {
    constexpr double along_it = 1.0 - 1e-6;
    Eigen::Index axis = 0;
    if (face.normal.cwiseAbs().maxCoeff(&axis) < along_it) {
      return false;
    }
    return std::ranges::all_of(face.faces, [&](const model::Face& side) {
      const mesh::FaceNodes nodes = mesh::face_nodes(model_.mesh, side);
      return std::ranges::all_of(nodes.all, [&](base::NodeId n) {
        return cls_[3 * n.index() + static_cast<std::size_t>(axis)] ==
               model::FreedomRole::suppressed;
      });
    });
  }

  void look_for_kinks(const model::CrackDefinition& crack) {
    if (crack.kind != model::CrackDefinitionKind::drawn) {
      return;
    }
    if (const std::optional<MisplacedFrontPoint> kink =
            find_misplaced_front_point(crack.points, crack.plane.closed)) {
      list_.warning(
          crack.span, "W463",
          fmt::format("crack {}: point {} of its front, {}, lies off the others: the "
                      "front turns by {:.0f} degrees in all, without that point by {:.0f}",
                      crack.name, kink->point + 1, place_of(crack.points[kink->point]),
                      kink->turning * degree, kink->without * degree),
          "is a coordinate mistyped? A front with a corner has more points beside it");
    }
  }

  const model::Model& model_;
  base::Diagnostics& list_;
  mesh::SolidHostMesh host_;
  std::vector<model::FreedomRole> cls_; ///< [3 * node]
};

} // namespace

std::vector<std::string> describe_solid_cracks(const model::Model& model, base::Diagnostics& list) {
  const bool any = std::ranges::any_of(model.cracks, [](const model::CrackDefinition& crack) {
    return crack.kind == model::CrackDefinitionKind::ellipse ||
           crack.kind == model::CrackDefinitionKind::drawn;
  });
  return any ? Flaws(model, list).tell() : std::vector<std::string>();
}

} // namespace spricka::sense
