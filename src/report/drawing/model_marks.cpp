// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/model_marks.hpp"

#include "base/by_dimension.hpp"
#include "model/mesh_side.hpp"
#include "model/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace spricka::report {
namespace {

using model::LoadType;

constexpr std::size_t most_marks = 24; ///< of one set: more run into each other
constexpr double longest_arrow = 34.0; ///< [px]
constexpr double shortest_arrow = 1.0;
constexpr const char* held_colour = "#0072b2";
constexpr const char* moved_colour = "#009e73";
constexpr const char* load_colour = "#b00000";
constexpr const char* heat_colour = "#d55e00";
constexpr std::size_t most_dots = 150; ///< of one heated set

bool is_held(model::FreedomRole cls) {
  return cls == model::FreedomRole::suppressed || cls == model::FreedomRole::prescribed;
}

/// Every k-th index so that at most `most_marks` are left.
std::size_t stride(std::size_t count) {
  return std::max<std::size_t>(1, (count + most_marks - 1) / most_marks);
}

DrawingPoint pixel_of(const MarkWindow& window, const base::Vec3& x) {
  return window.project(window.eye(x));
}

bool is_marked(const MarkWindow& window, const base::Vec3& x, const base::Vec3& normal) {
  return !window.is_marked || window.is_marked(x, normal);
}

/// An arrow that ends at a place, with the value it stands for.
struct Arrow {
  base::Vec3 at;
  base::Vec3 value;
  base::Vec3 normal = base::Vec3::Zero(); ///< of the face it acts on
};

base::Vec3 vector_of(const model::Load& load, const base::Vec3& x) {
  base::Vec3 value = base::Vec3::Zero();
  for (std::size_t c = 0; c < std::min<std::size_t>(load.value.size(), 3); ++c) {
    value[static_cast<Eigen::Index>(c)] = load.value[c](x);
  }
  return value;
}

void add_on_faces(const model::Mesh& mesh, const model::Load& load, std::vector<Arrow>& arrows) {
  const std::vector<model::Face>& faces = mesh.set_with_id(load.faces).faces;
  for (std::size_t i = 0; i < faces.size(); i += stride(faces.size())) {
    const geometry::SidePoint middle =
        model::element_side(mesh, faces[i]).point(base::Vec2::Zero());
    const bool pressure = load.type == LoadType::pressure;
    const base::Vec3 value = pressure && !load.value.empty()
                                 ? base::Vec3(-load.value.front()(middle.x) * middle.normal())
                                 : vector_of(load, middle.x);
    arrows.push_back({middle.x, value, middle.normal()});
  }
}

/// The middle of what a total acts on.
base::Vec3 middle_of(const model::Mesh& mesh, const model::Load& load) {
  base::Vec3 sum = base::Vec3::Zero();
  double count = 0.0;
  const auto add = [&](const base::Vec3& x) {
    sum += x;
    count += 1.0;
  };
  if (load.faces.valid()) {
    for (const model::Face& face : mesh.set_with_id(load.faces).faces) {
      add(model::element_side(mesh, face).position(base::Vec2::Zero()));
    }
  } else if (load.elements.valid()) {
    for (const base::ElementId e : mesh.set_with_id(load.elements).elements) {
      for (const base::NodeId n : mesh.element_nodes(e)) {
        add(mesh.x[n.index()]);
      }
    }
  }
  return count > 0.0 ? base::Vec3(sum / count) : sum;
}

std::vector<Arrow> arrows_of(const model::Mesh& mesh, const model::Load& load) {
  std::vector<Arrow> arrows;
  const bool at_nodes = load.type == LoadType::force || load.type == LoadType::displacement;
  if (at_nodes && load.nodes.valid()) {
    const std::vector<base::NodeId>& nodes = mesh.set_with_id(load.nodes).nodes;
    for (std::size_t i = 0; i < nodes.size(); i += stride(nodes.size())) {
      const base::Vec3& x = mesh.x[nodes[i].index()];
      arrows.push_back({.at = x, .value = vector_of(load, x)});
    }
  } else if ((load.type == LoadType::traction || load.type == LoadType::pressure) &&
             load.faces.valid()) {
    add_on_faces(mesh, load, arrows);
  } else if (load.type == LoadType::resultant || load.type == LoadType::bearing ||
             load.type == LoadType::body) {
    const base::Vec3 x = middle_of(mesh, load);
    arrows.push_back({.at = x, .value = vector_of(load, x)});
  }
  return arrows;
}

void draw_arrow(SvgDrawing& svg, DrawingPoint tip, const base::Vec2& way, const char* colour) {
  const base::Vec2 along = way.normalized();
  const base::Vec2 across(-along.y(), along.x());
  const DrawingPoint tail{tip.x - way.x(), tip.y - way.y()};
  svg.line(tail, tip, {colour, 1.3, "none", ""});
  SvgPathData head;
  head.move(tip);
  for (const double side : {1.0, -1.0}) {
    const base::Vec2 back = -7.0 * along + side * 2.8 * across;
    head.line({tip.x + back.x(), tip.y + back.y()});
  }
  svg.path(head.close(), {colour, 0.5, colour, ""});
}

void draw_loads(SvgDrawing& svg, const model::Model& model, const MarkWindow& window) {
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      const std::vector<Arrow> arrows = arrows_of(model.mesh, load);
      double largest = 0.0;
      for (const Arrow& arrow : arrows) {
        const double size = arrow.value.norm();
        largest = std::isfinite(size) ? std::max(largest, size) : largest;
      }
      for (const Arrow& arrow : arrows) {
        const double part = largest > 0.0 ? arrow.value.norm() / largest : 0.0;
        if (!std::isfinite(part) || part <= 0.05 || !is_marked(window, arrow.at, arrow.normal)) {
          continue;
        }
        const DrawingPoint way = window.eye(arrow.value.normalized());
        const base::Vec2 up = longest_arrow * part * base::Vec2(way.x, -way.y);
        if (up.norm() > shortest_arrow) { // else it points to the eye
          draw_arrow(svg, pixel_of(window, arrow.at), up,
                     load.type == LoadType::displacement ? moved_colour : load_colour);
        }
      }
    }
  }
}

void draw_dot(SvgDrawing& svg, DrawingPoint at) {
  svg.circle(at, 1.7, {heat_colour, 0.5, heat_colour, ""});
}

/// Dots inside the elements that a case gives a temperature.
void draw_heated(SvgDrawing& svg, const model::Model& model, const MarkWindow& window) {
  for (const model::LoadCase& load_case : model.cases) {
    for (const model::Load& load : load_case.loads) {
      if (load.type != LoadType::temperature || !load.elements.valid()) {
        continue;
      }
      const std::vector<base::ElementId>& elements = model.mesh.set_with_id(load.elements).elements;
      const std::size_t step = std::max<std::size_t>(1, elements.size() / most_dots);
      for (std::size_t i = 0; i < elements.size(); i += step) {
        const auto corners = static_cast<std::size_t>(
            base::element_info(model.mesh.type[elements[i].index()]).corners);
        base::Vec3 sum = base::Vec3::Zero();
        for (const base::NodeId n : model.mesh.element_nodes(elements[i]).first(corners)) {
          sum += model.mesh.x[n.index()];
        }
        const base::Vec3 middle = sum / static_cast<double>(corners);
        if (is_marked(window, middle, base::Vec3::Zero())) {
          draw_dot(svg, pixel_of(window, middle));
        }
      }
    }
  }
}

/// A triangle before a node along each axis that is held: beside it for x, below it for y.
void draw_held(SvgDrawing& svg, DrawingPoint at, const std::array<bool, 3>& dof,
               const PictureViewpoint& eye) {
  for (std::size_t c = 0; c < dof.size(); ++c) {
    const DrawingPoint axis = eye(base::Vec3::Unit(static_cast<Eigen::Index>(c)));
    const base::Vec2 back(-axis.x, axis.y); // y runs down on the drawing
    if (!dof[c] || back.norm() < 0.2) {     // it points to the eye
      continue;
    }
    const base::Vec2 foot = 7.0 * back;
    const base::Vec2 half = 4.0 * base::Vec2(-back.y(), back.x()).normalized();
    SvgPathData path;
    path.move(at);
    path.line({at.x + foot.x() + half.x(), at.y + foot.y() + half.y()});
    path.line({at.x + foot.x() - half.x(), at.y + foot.y() - half.y()});
    svg.path(path.close(), {held_colour, 0.9, "#fff", ""});
  }
}

void draw_supports(SvgDrawing& svg, const model::Model& model, const MarkWindow& window) {
  for (const model::NodeSetFreedomRole& freedom : model.freedoms) {
    if (!is_held(freedom.cls) || !freedom.nodes.valid()) {
      continue;
    }
    const std::vector<base::NodeId>& nodes = model.mesh.set_with_id(freedom.nodes).nodes;
    for (std::size_t i = 0; i < nodes.size(); i += stride(nodes.size())) {
      const base::Vec3& x = model.mesh.x[nodes[i].index()];
      if (is_marked(window, x, base::Vec3::Zero())) {
        draw_held(svg, pixel_of(window, x), freedom.dof, window.eye);
      }
    }
  }
}

void draw_contacts(SvgDrawing& svg, const model::Model& model, const MarkWindow& window) {
  for (std::size_t c = 0; c < model.contacts.size(); ++c) {
    for (const base::FaceSetId set : {model.contacts[c].slave, model.contacts[c].master}) {
      SvgPathData path;
      for (const model::Face& face :
           set.valid() ? model.mesh.set_with_id(set).faces : std::vector<model::Face>()) {
        const geometry::ElementSide side = model::element_side(model.mesh, face);
        if (!side.is_edge()) {
          return; // a surface in space is no line
        }
        const base::Vec3 from = side.X.col(0);
        const base::Vec3 to = side.X.col(1);
        const base::Vec3 control = 2.0 * side.position(base::Vec2::Zero()) - 0.5 * (from + to);
        path.move(pixel_of(window, from));
        path.quadratic(pixel_of(window, control), pixel_of(window, to));
      }
      if (!path.empty()) {
        svg.path(path, {std::string(palette_colour(c)), 2.6, "none", ""});
      }
    }
  }
}

/// One entry of the legend: a sign and words.
struct MarkEntry {
  enum class Sign { held, load, moved, heated, contact } sign;
  std::string words;
  std::size_t number = 0; ///< of a contact
};

std::vector<MarkEntry> entries_of(const model::Model& model) {
  std::vector<MarkEntry> entries;
  const bool held = std::ranges::any_of(
      model.freedoms, [](const model::NodeSetFreedomRole& f) { return is_held(f.cls); });
  if (held) {
    constexpr base::ByDimension<const char*> words{"held in x (beside), in y (below)",
                                                   "held along the triangles' axes"};
    entries.push_back({MarkEntry::Sign::held, words.at(model.mesh.dim)});
  }
  for (const model::LoadCase& load_case : model.cases) {
    std::vector<bool> kinds(2, false);
    for (const model::Load& load : load_case.loads) {
      kinds[load.type == LoadType::displacement ? 1 : 0] =
          kinds[load.type == LoadType::displacement ? 1 : 0] || load.type != LoadType::temperature;
    }
    if (kinds[0]) {
      entries.push_back({MarkEntry::Sign::load, "load " + load_case.name});
    }
    if (kinds[1]) {
      entries.push_back({MarkEntry::Sign::moved, "displacement " + load_case.name});
    }
  }
  std::string heated;
  for (const model::LoadCase& load_case : model.cases) {
    if (std::ranges::any_of(load_case.loads, [](const model::Load& load) {
          return load.type == LoadType::temperature;
        })) {
      heated += (heated.empty() ? "temperature " : ", ") + load_case.name;
    }
  }
  if (!heated.empty()) {
    entries.push_back({MarkEntry::Sign::heated, heated});
  }
  constexpr base::ByDimension lines_of_contacts{true, false};
  for (std::size_t c = 0; c < model.contacts.size() && lines_of_contacts.at(model.mesh.dim); ++c) {
    entries.push_back({MarkEntry::Sign::contact, "contact " + model.contacts[c].name, c});
  }
  return entries;
}

} // namespace

void draw_model_marks(SvgDrawing& svg, const model::Model& model, const MarkWindow& window) {
  draw_heated(svg, model, window);
  draw_contacts(svg, model, window);
  draw_supports(svg, model, window);
  draw_loads(svg, model, window);
}

std::string model_marks_legend(const model::Model& model, double width) {
  constexpr double column = 220.0;
  constexpr double line = 17.0;
  const std::vector<MarkEntry> entries = entries_of(model);
  if (entries.empty()) {
    return {};
  }
  const auto across = static_cast<std::size_t>(std::max(1.0, std::floor(width / column)));
  const std::size_t down = (entries.size() + across - 1) / across;
  SvgDrawing svg(width, line * static_cast<double>(down) + 4.0,
                 "Signs in the picture of the model");
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = i / across;
    const DrawingPoint at{column * static_cast<double>(i % across),
                          line * (static_cast<double>(row) + 0.5)};
    const MarkEntry& entry = entries[i];
    if (entry.sign == MarkEntry::Sign::held) {
      draw_held(svg, {at.x + 14.0, at.y - 2.0}, {true, true, false}, {});
    } else if (entry.sign == MarkEntry::Sign::heated) {
      for (const double x : {6.0, 13.0, 20.0}) {
        draw_dot(svg, {at.x + x, at.y});
      }
    } else if (entry.sign == MarkEntry::Sign::contact) {
      svg.line({at.x, at.y}, {at.x + 26.0, at.y},
               {std::string(palette_colour(entry.number)), 2.6, "none", ""});
    } else {
      draw_arrow(svg, {at.x + 26.0, at.y}, {24.0, 0.0},
                 entry.sign == MarkEntry::Sign::load ? load_colour : moved_colour);
    }
    svg.text({at.x + 34.0, at.y + 4.0}, entry.words, {TextAnchor::start, 11.0});
  }
  return svg.svg_text();
}

} // namespace spricka::report
