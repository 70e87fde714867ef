// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/mesh_picture.hpp"

#include "model/mesh_side.hpp"
#include "model/model.hpp"
#include "report/drawing/label_placer.hpp"
#include "report/drawing/model_marks.hpp"
#include "report/drawing/picture_frame.hpp"
#include "report/drawing/rigid_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace spricka::report {
namespace {

constexpr double title_height = 22.0;
constexpr double foot_height = 26.0;
constexpr double scale_height = 48.0;
constexpr const char* crack_colour = "#d55e00";

constexpr std::array<const char*, 5> tints{"#dfe8f1", "#f5e9d8", "#e2efe3", "#efe4ef", "#ececec"};

/// From deck coordinates, moved by the magnified displacements, to pixels.
class Projection {
public:
  explicit Projection(const MeshView& view)
      : view_(view), scale_(view.width / (view.high.x - view.low.x)) {}

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double height() const { return scale_ * (view_.high.y - view_.low.y); }
  [[nodiscard]] DrawingPoint operator()(const DrawingPoint& p) const {
    return {scale_ * (p.x - view_.low.x), title_height + scale_ * (view_.high.y - p.y)};
  }
  [[nodiscard]] DrawingPoint operator()(base::NodeId n) const {
    const base::Vec3& x = view_.mesh->x[n.index()];
    DrawingPoint p{x[0], x[1]};
    if (view_.u != nullptr) {
      const auto row = static_cast<Eigen::Index>(2 * n.index());
      p.x += view_.magnify * ((*view_.u)[row] - view_.rest[0]);
      p.y += view_.magnify * ((*view_.u)[row + 1] - view_.rest[1]);
    }
    return (*this)(p);
  }

private:
  const MeshView& view_;
  double scale_;
};

struct DrawnEdge {
  base::NodeId low; ///< the smaller of the two ends
  base::NodeId high;
  base::NodeId mid;    ///< invalid on straight edges
  base::NetId net;     ///< of its element
  bool upward = false; ///< the element runs it from low to high
  [[nodiscard]] base::NodeId from() const { return upward ? low : high; }
  [[nodiscard]] base::NodeId to() const { return upward ? high : low; }
  [[nodiscard]] auto key() const { return std::array{low.value, high.value, mid.value}; }
};

/// Goes on along an edge in a path that stands at its first end; mid: invalid on straight edges.
void add_edge(SvgPathData& path, const Projection& project, base::NodeId first, base::NodeId second,
              base::NodeId mid) {
  const DrawingPoint a = project(first);
  const DrawingPoint b = project(second);
  if (mid.valid()) {
    const DrawingPoint m = project(mid);
    path.quadratic({2.0 * m.x - 0.5 * (a.x + b.x), 2.0 * m.y - 0.5 * (a.y + b.y)}, b);
  } else {
    path.line(b);
  }
}

bool in_window(const MeshView& view, const Projection& project,
               std::span<const base::NodeId> nodes) {
  PictureBox box;
  for (const base::NodeId n : nodes) {
    box.add(project(n));
  }
  return box.high.x >= 0.0 && box.low.x <= view.width && box.high.y >= title_height &&
         box.low.y <= title_height + project.height();
}

/// More than so many elements are drawn by their outlines alone: a page of them would be slow.
constexpr std::size_t most_drawn_elements = 20000;

struct Drawn {
  std::vector<SvgPathData> areas; ///< [net], of a field [colour band]
  std::vector<DrawnEdge> edges;   ///< of every element: inner ones twice
  std::size_t elements = 0;
  [[nodiscard]] bool has_outlines_alone() const { return elements > most_drawn_elements; }
};

/// Leaves those of one element only; `edges` are sorted.
void remove_inner_edges(std::vector<DrawnEdge>& edges) {
  std::vector<DrawnEdge> outer;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool again = (i > 0 && edges[i - 1].key() == edges[i].key()) ||
                       (i + 1 < edges.size() && edges[i + 1].key() == edges[i].key());
    if (!again) {
      outer.push_back(edges[i]);
    }
  }
  edges = std::move(outer);
}

/// A corner of a cell: where it is drawn and the field there.
struct DrawnCorner {
  DrawingPoint at;
  double value = 0.0;
};

void add_cell(const std::vector<DrawnCorner>& corners, const ColourScale& scale,
              std::vector<SvgPathData>& bands) {
  double mean = 0.0;
  for (const DrawnCorner& s : corners) {
    mean += s.value / static_cast<double>(corners.size());
  }
  SvgPathData& path = bands[scale.band_index(mean)].move(corners.front().at);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    path.line(corners[i].at);
  }
  path.close();
}

/// The middle of a quadrilateral with eight nodes: its shape functions at the origin.
DrawnCorner middle_of(const std::vector<DrawnCorner>& nodes) {
  DrawnCorner sum;
  for (std::size_t i = 0; i < 8; ++i) {
    const double N = i < 4 ? -0.25 : 0.5;
    sum.at = {sum.at.x + N * nodes[i].at.x, sum.at.y + N * nodes[i].at.y};
    sum.value += N * nodes[i].value;
  }
  return sum;
}

/// A linear element is one cell, a quadratic one four.
void add_cells(const MeshView& view, const Projection& project, base::ElementId e,
               std::vector<SvgPathData>& bands) {
  const model::Mesh& mesh = *view.mesh;
  const base::ElementInfo& info = base::element_info(mesh.type[e.index()]);
  const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
  std::vector<DrawnCorner> at;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto k = static_cast<std::size_t>(mesh.first[e.index()]) + i;
    at.push_back({project(nodes[i]), view.field[k]});
  }
  const auto corners = static_cast<std::size_t>(info.corners);
  if (!info.quadratic) {
    add_cell(at, view.scale, bands);
    return;
  }
  const DrawnCorner middle = corners == 4 ? middle_of(at) : DrawnCorner();
  for (std::size_t s = 0; s < corners; ++s) {
    const DrawnCorner& before = at[corners + (s + corners - 1) % corners];
    std::vector<DrawnCorner> cell{before, at[s], at[corners + s]};
    if (corners == 4) {
      cell.push_back(middle);
    }
    add_cell(cell, view.scale, bands);
  }
  if (corners == 3) {
    add_cell({at[3], at[4], at[5]}, view.scale, bands);
  }
}

/// The bodies of each net by their outlines alone, which run round holes the other way. [net]
std::vector<SvgPathData> bodies_by_outlines(const std::vector<DrawnEdge>& edges,
                                            const Projection& project) {
  std::map<std::pair<base::NetId, base::NodeId>, std::vector<const DrawnEdge*>> next;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].key() == edges[i].key()) {
      ++end;
    }
    if (end == i + 1) {
      next[{edges[i].net, edges[i].from()}].push_back(&edges[i]);
    }
    i = end;
  }
  std::vector<SvgPathData> bodies;
  for (auto& [begin, first] : next) {
    while (!first.empty()) {
      const std::size_t layer = begin.first.valid() ? begin.first.index() : 0;
      bodies.resize(std::max(bodies.size(), layer + 1));
      SvgPathData& path = bodies[layer].move(project(begin.second));
      for (auto at = next.find(begin); at != next.end() && !at->second.empty();) {
        const DrawnEdge& edge = *at->second.back();
        at->second.pop_back();
        add_edge(path, project, edge.from(), edge.to(), edge.mid);
        at = next.find({begin.first, edge.to()});
      }
      path.close();
    }
  }
  return bodies;
}

Drawn collect(const MeshView& view, const Projection& project) {
  const model::Mesh& mesh = *view.mesh;
  Drawn drawn;
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    const base::NetId net = mesh.element_net[i];
    const base::ElementInfo& info = base::element_info(mesh.type[i]);
    const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
    if ((view.net.valid() && net != view.net) || !in_window(view, project, nodes)) {
      continue;
    }
    ++drawn.elements;
    const auto corners = static_cast<std::size_t>(info.corners);
    const auto mid = [&](std::size_t s) {
      return info.quadratic ? nodes[corners + s] : base::NodeId();
    };
    if (drawn.has_outlines_alone()) {
      drawn.areas.clear();
    } else if (view.field.empty() && view.inner_edges) {
      const std::size_t layer = net.valid() ? net.index() : 0;
      drawn.areas.resize(std::max(drawn.areas.size(), layer + 1));
      SvgPathData& area = drawn.areas[layer].move(project(nodes[0]));
      for (std::size_t s = 0; s < corners; ++s) {
        add_edge(area, project, nodes[s], nodes[(s + 1) % corners], mid(s));
      }
      area.close();
    } else if (!view.field.empty()) {
      drawn.areas.resize(colour_bands);
      add_cells(view, project, e, drawn.areas);
    }
    for (std::size_t s = 0; s < corners; ++s) {
      const auto [low, high] = std::minmax(nodes[s], nodes[(s + 1) % corners]);
      drawn.edges.push_back({low, high, mid(s), net, low == nodes[s]});
    }
  }
  std::sort(drawn.edges.begin(), drawn.edges.end(),
            [](const DrawnEdge& a, const DrawnEdge& b) { return a.key() < b.key(); });
  if (view.field.empty() && !view.inner_edges) {
    drawn.areas = bodies_by_outlines(drawn.edges, project);
  }
  if (drawn.has_outlines_alone()) {
    remove_inner_edges(drawn.edges);
  }
  return drawn;
}

void draw_edges(SvgDrawing& svg, const Projection& project, const std::vector<DrawnEdge>& edges,
                bool inside) {
  SvgPathData inner;
  SvgPathData outline;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next].key() == edges[i].key()) {
      ++next;
    }
    SvgPathData& path = next == i + 1 ? outline : inner;
    path.move(project(edges[i].low));
    add_edge(path, project, edges[i].low, edges[i].high, edges[i].mid);
    i = next;
  }
  if (inside) {
    svg.path(inner, {"#445", 0.5, "none", ""});
  }
  svg.path(outline, {"#000", 1.3, "none", ""});
}

void draw_crack_faces(SvgDrawing& svg, const MeshView& view, const Projection& project) {
  SvgPathData path;
  for (const model::Face& face : view.crack_faces) {
    const std::vector<base::NodeId> nodes = model::side_nodes(*view.mesh, face);
    path.move(project(nodes[0]));
    add_edge(path, project, nodes[0], nodes[1], nodes.size() > 2 ? nodes[2] : base::NodeId());
  }
  svg.path(path, {crack_colour, 2.6, "none", ""});
}

void draw_labels(SvgDrawing& svg, const MeshView& view, const Projection& project) {
  LabelPlacer placer({0.0, title_height}, {view.width, title_height + project.height()});
  for (const auto& [at, words] : view.labels) {
    const DrawingPoint p = project(at);
    placer.keep_free({p.x - 3.0, p.y - 3.0}, 6.0, 6.0);
    svg.circle(p, 2.6, {crack_colour, 1.2, crack_colour, ""});
  }
  for (const auto& [at, words] : view.labels) {
    placer.write(svg, project(at), words, {TextAnchor::start, 12.0, crack_colour, 0.0, true, true});
  }
}

/// A bar of a round length that takes about a quarter of the width.
void draw_bar(SvgDrawing& svg, const MeshView& view, const Projection& project) {
  const double shown =
      round_number_below(view.length.from_deck(0.25 * view.width / project.scale()));
  const double length = view.length.to_deck(shown);
  const double y = title_height + project.height() + 14.0;
  const double right = 2.0 + length * project.scale();
  const ShapeStyle style{"#000", 1.2, "none", ""};
  svg.line({2.0, y}, {right, y}, style);
  svg.line({2.0, y - 4.0}, {2.0, y + 4.0}, style);
  svg.line({right, y - 4.0}, {right, y + 4.0}, style);
  svg.text({right + 7.0, y + 4.0}, fmt::format("{:.3g} {}", shown, view.length.name),
           {TextAnchor::start, 11.0});
  if (view.u != nullptr) {
    svg.text({view.width, y + 4.0}, fmt::format("displacements × {:.3g}", view.magnify),
             {TextAnchor::end, 11.0});
  }
}

} // namespace

MeshView whole_mesh_view(const model::Model& model, const model::Mesh& mesh,
                         const PictureLimits& limits) {
  constexpr double beside = 0.06; // of the size, for arrows and hatches
  MeshView view;
  view.mesh = &mesh;
  view.length = model.units.output_length();
  PictureBox box;
  for (const base::NodeId n : mesh.nodes) {
    box.add({mesh.x[n.index()][0], mesh.x[n.index()][1]});
  }
  view.rigids = model.rigids;
  const double margin = beside * std::max(box.width(), box.height());
  view.low = {box.low.x - margin, box.low.y - margin};
  view.high = {box.high.x + margin, box.high.y + margin};
  const double slender = (view.high.y - view.low.y) / (view.high.x - view.low.x);
  view.width = std::min(limits.width, limits.height / slender);
  return view;
}

std::string draw_svg(const MeshView& view) {
  const Projection project(view);
  const Drawn drawn = collect(view, project);
  const bool coloured = !view.field.empty();
  const double foot = title_height + project.height() + foot_height;
  SvgDrawing svg(view.width, foot + (coloured ? scale_height : 0.0), view.title);
  svg.title({0.5 * view.width, 14.0}, view.title);
  svg.clip(view.id, {0.0, title_height}, view.width, project.height());
  for (std::size_t i = 0; i < drawn.areas.size(); ++i) {
    const std::string tint = coloured ? band_colour(i) : tints[i % tints.size()];
    svg.path(drawn.areas[i], {tint, 0.6, tint, ""}); // the stroke hides the seams
  }
  draw_edges(svg, project, drawn.edges, view.inner_edges && !coloured);
  draw_crack_faces(svg, view, project);
  const DrawingWindow window{view.low, view.high, project.scale(),
                             [&](const DrawingPoint& p) { return project(p); }};
  for (const model::RigidTarget& rigid : view.rigids) {
    if (rigid.shape == model::RigidTargetShape::line ||
        rigid.shape == model::RigidTargetShape::arc) {
      draw_rigid_target(svg, rigid, window);
    }
  }
  if (view.marks != nullptr) {
    draw_model_marks(svg, *view.marks, {.eye = {}, .project = window.project});
  }
  draw_labels(svg, view, project);
  svg.unclip();
  svg.rectangle({0.5, title_height}, view.width - 1.0, project.height(), {"#999", 0.8, "none", ""});
  draw_bar(svg, view, project);
  if (coloured) {
    draw_colour_legend(svg, view.scale, {0.1 * view.width, foot + 14.0}, 0.8 * view.width,
                       view.field_title);
  }
  return svg.svg_text();
}

} // namespace spricka::report
