// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing/joint_picture.hpp"

#include "model/model.hpp"
#include "report/drawing/colour_scale.hpp"
#include "report/drawing/crack_opening.hpp"
#include "report/drawing/label_placer.hpp"
#include "report/drawing/model_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace spricka::report {
namespace {

constexpr std::array<const char*, 5> solid_tints{"#ccd8e6", "#ead9bd", "#cfe3d1", "#e3d2e3",
                                                 "#d9d9d9"};
constexpr const char* crack_tint = "#f0b27a";
constexpr double foot_of_axes = 32.0; // below the box [px]

/// Of slanted views with z up the one that sees most of the crack's face and its mouth.
PictureViewpoint eye_for(const FittedFrontPlane& frame) {
  PictureViewpoint best;
  double most = -std::numeric_limits<double>::infinity();
  for (const double first : {0.5, -0.5, 0.75, -0.75}) {
    for (const double up : {0.45, -0.45}) {
      for (const double side : {-1.0, 1.0}) {
        const base::Vec3 towards =
            base::Vec3(first, side * (1.25 - std::abs(first)), up).normalized();
        const double flat = std::min(std::abs(towards.dot(frame.normal)), 0.6);
        const double seen = flat - towards.dot(frame.growth) + (up > 0.0 ? 0.1 : 0.0);
        if (seen > most + 1e-9) {
          most = seen;
          best = PictureViewpoint::looking_from(towards, base::Vec3::UnitZ());
        }
      }
    }
  }
  return best;
}

/// No more of a box than `half` each way from a place.
void narrow(PictureBox& box, DrawingPoint middle, double half) {
  box.low = {std::max(box.low.x, middle.x - half), std::max(box.low.y, middle.y - half)};
  box.high = {std::min(box.high.x, middle.x + half), std::min(box.high.y, middle.y + half)};
}

base::NetId net_of_front(const results::CrackLengthResult& increment,
                         const results::FrontResult& front) {
  const model::Mesh& mesh = increment.mesh;
  const base::NodeId nearest = nearest_node(mesh, front.points.front().x);
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    const auto nodes = mesh.element_nodes(base::ElementId(e));
    if (std::ranges::find(nodes, nearest) != nodes.end()) {
      return mesh.element_net[e];
    }
  }
  return {};
}

/// K1 of the points, without those at a surface, where it is a number of the mesh.
ColourScale k_scale(const std::vector<const results::FrontResult*>& fronts) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const results::FrontResult* const front : fronts) {
    for (const results::FrontPointResult& p : front->points) {
      if (!p.at_surface) {
        low = std::min(low, p.K1);
        high = std::max(high, p.K1);
      }
    }
  }
  return high >= low ? make_colour_scale(low, high) : ColourScale{};
}

void add_line(SvgPathData& path, const std::vector<DrawingPoint>& points) {
  path.move(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    path.line(points[i]);
  }
}

class JointPainter {
public:
  JointPainter(const JointView& view, const std::optional<FittedFrontPlane>& plane)
      : view_(view), eye_(plane ? eye_for(*plane) : slanted_viewpoint()),
        facets_(facets_towards_eye(*view.increment,
                                   {.eye = eye_,
                                    .net = view.is_close && !view.fronts.empty()
                                               ? net_of_front(*view.increment, *view.fronts.front())
                                               : base::NetId()})),
        frame_(box(plane), view.width) {}

  [[nodiscard]] std::string draw() const {
    SvgDrawing svg = frame_.begin_drawing(view_.title);
    svg.clip(view_.id, {0.0, PictureFrame::head}, view_.width, frame_.height());
    const SurfaceSides sides(*view_.increment, eye_);
    draw_marks(svg, sides, false);
    draw_body(svg);
    draw_marks(svg, sides, true);
    draw_cracks(svg);
    draw_labels(svg);
    svg.unclip();
    draw_axes(svg, eye_, {34.0, frame_.foot() + foot_of_axes});
    if (!view_.fronts.empty()) {
      draw_colour_legend(svg, k_scale(view_.fronts), {0.3 * view_.width, frame_.foot() + 12.0},
                         0.6 * view_.width, view_.k_title);
    }
    return svg.svg_text();
  }

private:
  [[nodiscard]] PictureBox box(const std::optional<FittedFrontPlane>& plane) const {
    constexpr double surroundings = 4.0; // sizes of the crack
    PictureBox all;
    for (const DrawnFacet& facet : facets_) {
      std::ranges::for_each(facet.outline, [&](DrawingPoint p) { all.add(p); });
    }
    if (view_.is_close && plane) {
      narrow(all, eye_(plane->centre), surroundings * plane->size);
      return all;
    }
    const double margin = 0.05 * std::max(all.width(), all.height()); // for arrows, triangles
    all.low = {all.low.x - margin, all.low.y - margin};
    all.high = {all.high.x + margin, all.high.y + margin};
    return all;
  }

  [[nodiscard]] std::vector<DrawingPoint> pixels(std::vector<DrawingPoint> line) const {
    std::ranges::transform(line, line.begin(), frame_);
    return line;
  }
  [[nodiscard]] bool is_inside(const std::vector<DrawingPoint>& line) const {
    return std::ranges::any_of(line, [&](DrawingPoint p) {
      return p.x >= 0.0 && p.x <= view_.width && p.y >= PictureFrame::head && p.y <= frame_.foot();
    });
  }

  /// Facets of one colour that follow each other are one path: most of a flat face.
  void draw_body(SvgDrawing& svg) const {
    SvgPathData area;
    SvgPathData ridges;
    std::string fill;
    const auto paint = [&] {
      svg.path(area, {fill, 1.0, fill, ""}); // the stroke hides the seams
      svg.path(ridges, {"#223", 0.9, "none", ""});
      area = ridges = {};
    };
    for (const DrawnFacet& facet : facets_) {
      const std::vector<DrawingPoint> outline = pixels(facet.outline);
      if (!is_inside(outline)) {
        continue;
      }
      const base::NetId net = view_.increment->mesh.element_net[facet.face->element.index()];
      const std::size_t tint = net.valid() ? net.index() % solid_tints.size() : 0;
      const std::string own = shaded_colour(solid_tints[tint], facet.light);
      if (own != fill) {
        paint();
        fill = own;
      }
      add_line(area, outline);
      area.close();
      for (const std::vector<DrawingPoint>& ridge : facet.ridges) {
        add_line(ridges, pixels(ridge));
      }
    }
    paint();
  }

  void draw_marks(SvgDrawing& svg, const SurfaceSides& sides, bool before_the_body) const {
    if (view_.marks != nullptr) {
      draw_model_marks(svg, *view_.marks,
                       {.eye = eye_,
                        .project = [this](const DrawingPoint& p) { return frame_(p); },
                        .is_marked =
                            [&](const base::Vec3& x, const base::Vec3& normal) {
                              return sides.faces_eye(x, normal) == before_the_body;
                            }});
    }
  }

  // They lie within the body and are shown through it.
  void draw_cracks(SvgDrawing& svg) const {
    const ColourScale scale = k_scale(view_.fronts);
    for (const results::FrontResult* const front : view_.fronts) {
      const std::optional<FittedFrontPlane> plane = fit_front_plane(*front);
      const bool moved =
          view_.step->u.size() == static_cast<Eigen::Index>(3 * view_.increment->mesh.node_count());
      const auto faces = plane && moved ? crack_face_openings(*view_.increment, *view_.step, *plane)
                                        : std::vector<OpenedCrackFace>();
      for (const OpenedCrackFace& face : faces) {
        std::vector<DrawingPoint> outline;
        for (const base::NodeId n : face.outline) {
          outline.push_back(eye_(view_.increment->mesh.x[n.index()]));
        }
        svg.polygon(pixels(std::move(outline)), {crack_tint, 0.5, crack_tint, ""});
      }
      draw_front(svg, *front, scale);
    }
  }

  /// Piece by piece in the colour of the mean of K1 at its ends.
  void draw_front(SvgDrawing& svg, const results::FrontResult& front,
                  const ColourScale& scale) const {
    std::vector<DrawingPoint> line;
    for (const results::FrontPointResult& p : front.points) {
      line.push_back(frame_(eye_(p.x)));
    }
    if (front.is_loop) {
      line.push_back(line.front());
    }
    const double width = view_.is_close ? 4.0 : 3.0;
    svg.polyline(line, {"#fff", width + 2.0, "none", ""});
    const auto& points = front.points;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const results::FrontPointResult& a = points[i];
      const results::FrontPointResult& b = points[(i + 1) % points.size()];
      const double K = a.at_surface ? b.K1 : b.at_surface ? a.K1 : 0.5 * (a.K1 + b.K1);
      svg.line(line[i], line[i + 1], {band_colour(scale.band_index(K)), width, "none", ""});
    }
  }

  void draw_labels(SvgDrawing& svg) const {
    LabelPlacer placer({0.0, PictureFrame::head}, {view_.width, frame_.foot()});
    for (const results::FrontResult* const front : view_.fronts) {
      for (const results::FrontPointResult& p : front->points) {
        const DrawingPoint at = frame_(eye_(p.x));
        placer.keep_free({at.x - 3.0, at.y - 3.0}, 6.0, 6.0);
      }
    }
    for (const auto& [x, words] : view_.labels) {
      placer.write(svg, frame_(eye_(x)), words,
                   {TextAnchor::start, 12.0, "#a33c00", 0.0, true, true});
    }
  }

  const JointView& view_;
  PictureViewpoint eye_;
  std::vector<DrawnFacet> facets_;
  PictureFrame frame_;
};

} // namespace

std::string draw_svg(const JointView& view) {
  const std::vector<results::OuterSurfaceFace>& surface = view.increment->surface;
  if (surface.empty() || surface.size() > most_drawn_faces) {
    return {};
  }
  const std::optional<FittedFrontPlane> plane =
      view.fronts.empty() ? std::nullopt : fit_front_plane(*view.fronts.front());
  return JointPainter(view, plane).draw();
}

} // namespace spricka::report
