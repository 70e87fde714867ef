// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mesh_picture.hpp"

#include "report/rigid_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace spricka::report {
namespace {

constexpr double title_height = 22.0;
constexpr double foot_height = 26.0;

constexpr std::array<const char*, 5> tints{"#dfe8f1", "#f5e9d8", "#e2efe3", "#efe4ef", "#ececec"};

/// From deck coordinates, moved by the magnified displacements, to pixels.
class Projection {
public:
  explicit Projection(const MeshView& view)
      : view_(view), scale_(view.width / (view.high.x - view.low.x)) {}

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double height() const { return scale_ * (view_.high.y - view_.low.y); }
  [[nodiscard]] Point operator()(const Point& p) const {
    return {scale_ * (p.x - view_.low.x), title_height + scale_ * (view_.high.y - p.y)};
  }
  [[nodiscard]] Point operator()(base::NodeId n) const {
    const base::Vec3& x = view_.mesh->x[n.index()];
    Point p{x[0], x[1]};
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

struct Edge {
  base::NodeId low; ///< the smaller of the two ends
  base::NodeId high;
  base::NodeId mid; ///< invalid on straight edges
  [[nodiscard]] auto key() const { return std::array{low.value, high.value, mid.value}; }
};

/// Adds the side s of an element to a path that stands at its first end.
void add_side(PathData& path, const Projection& project, std::span<const base::NodeId> nodes,
              const base::ElementInfo& info, std::size_t s) {
  const auto corners = static_cast<std::size_t>(info.corners);
  const Point a = project(nodes[s]);
  const Point b = project(nodes[(s + 1) % corners]);
  if (info.quadratic) {
    const Point m = project(nodes[corners + s]);
    path.quadratic({2.0 * m.x - 0.5 * (a.x + b.x), 2.0 * m.y - 0.5 * (a.y + b.y)}, b);
  } else {
    path.line(b);
  }
}

bool in_window(const MeshView& view, const Projection& project,
               std::span<const base::NodeId> nodes) {
  Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  for (const base::NodeId n : nodes) {
    const Point p = project(n);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return high.x >= 0.0 && low.x <= view.width && high.y >= title_height &&
         low.y <= title_height + project.height();
}

struct Drawn {
  std::vector<PathData> areas; ///< [net]
  std::vector<Edge> edges;     ///< of every element: inner ones twice
};

Drawn collect(const MeshView& view, const Projection& project) {
  const model::Mesh& mesh = *view.mesh;
  Drawn drawn;
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const base::ElementId e(i);
    const base::NetId net = mesh.element_net[i];
    const base::ElementInfo& info = base::info(mesh.type[i]);
    const std::span<const base::NodeId> nodes = mesh.nodes_of(e);
    if ((view.net.valid() && net != view.net) || !in_window(view, project, nodes)) {
      continue;
    }
    const std::size_t layer = net.valid() ? net.index() : 0;
    drawn.areas.resize(std::max(drawn.areas.size(), layer + 1));
    const auto corners = static_cast<std::size_t>(info.corners);
    PathData& area = drawn.areas[layer].move(project(nodes[0]));
    for (std::size_t s = 0; s < corners; ++s) {
      add_side(area, project, nodes, info, s);
      const auto [low, high] = std::minmax(nodes[s], nodes[(s + 1) % corners]);
      drawn.edges.push_back({low, high, info.quadratic ? nodes[corners + s] : base::NodeId()});
    }
    area.close();
  }
  std::sort(drawn.edges.begin(), drawn.edges.end(),
            [](const Edge& a, const Edge& b) { return a.key() < b.key(); });
  return drawn;
}

void draw_edges(Svg& svg, const Projection& project, const std::vector<Edge>& edges) {
  PathData inner;
  PathData outline;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next].key() == edges[i].key()) {
      ++next;
    }
    PathData& path = next == i + 1 ? outline : inner;
    const Point a = project(edges[i].low);
    const Point b = project(edges[i].high);
    path.move(a);
    if (edges[i].mid.valid()) {
      const Point m = project(edges[i].mid);
      path.quadratic({2.0 * m.x - 0.5 * (a.x + b.x), 2.0 * m.y - 0.5 * (a.y + b.y)}, b);
    } else {
      path.line(b);
    }
    i = next;
  }
  svg.path(inner, {"#445", 0.5, "none", ""});
  svg.path(outline, {"#000", 1.3, "none", ""});
}

/// A bar of a round length that takes about a quarter of the width.
void draw_bar(Svg& svg, const MeshView& view, const Projection& project) {
  const double length = round_down(0.25 * view.width / project.scale());
  const double y = title_height + project.height() + 14.0;
  const double right = 2.0 + length * project.scale();
  const Style style{"#000", 1.2, "none", ""};
  svg.line({2.0, y}, {right, y}, style);
  svg.line({2.0, y - 4.0}, {2.0, y + 4.0}, style);
  svg.line({right, y - 4.0}, {right, y + 4.0}, style);
  svg.text({right + 7.0, y + 4.0}, fmt::format("{:.3g} {}", length, view.length_name),
           {Anchor::start, 11.0});
  if (view.u != nullptr) {
    svg.text({view.width, y + 4.0}, fmt::format("displacements × {:.3g}", view.magnify),
             {Anchor::end, 11.0});
  }
}

} // namespace

std::string draw(const MeshView& view) {
  const Projection project(view);
  const Drawn drawn = collect(view, project);
  Svg svg(view.width, title_height + project.height() + foot_height, view.title);
  svg.text({0.5 * view.width, 14.0}, view.title, {Anchor::middle, 13.0, "#000", 0.0, false, true});
  svg.clip(view.id, {0.0, title_height}, view.width, project.height());
  for (std::size_t net = 0; net < drawn.areas.size(); ++net) {
    const char* const tint = tints[net % tints.size()];
    svg.path(drawn.areas[net], {tint, 0.6, tint, ""}); // the stroke hides the seams
  }
  draw_edges(svg, project, drawn.edges);
  for (const model::Rigid& rigid : view.rigids) {
    draw_rigid(svg, rigid,
               {view.low, view.high, project.scale(), [&](const Point& p) { return project(p); }});
  }
  for (const auto& [at, words] : view.labels) {
    const Point p = project(at);
    svg.circle(p, 2.6, {"#d55e00", 1.2, "#d55e00", ""});
    svg.text({p.x + 6.0, p.y - 6.0}, words, {Anchor::start, 12.0, "#d55e00", 0.0, true, true});
  }
  svg.unclip();
  svg.rectangle({0.5, title_height}, view.width - 1.0, project.height(), {"#999", 0.8, "none", ""});
  draw_bar(svg, view, project);
  return svg.finish();
}

} // namespace spricka::report
