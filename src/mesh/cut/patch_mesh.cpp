// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/cut/patch_mesh.hpp"

#include "mesh/cut/patch_gaps.hpp"
#include "mesh/link/fill.hpp"
#include "shape/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::mesh {

using base::NodeId;
using base::Vec2;
using base::Vec3;

namespace {

/// Size wanted at the mouth, in crack lengths; the host's own size if that is smaller. Where the
/// mouth is pressed K2 of short cracks hangs on the peaks of pressure beside it.
constexpr double mouth_size = 0.25;
constexpr double pressed_mouth_size = 0.05;

class Builder {
public:
  Builder(const Host& host, const std::vector<PatchCrack>& cracks, const Cavity& cavity)
      : host_(host), frame_(cracks.front().place.frame), half_(cracks.front().place.half),
        cavity_(cavity), net_(host.mesh(), frame_) {
    for (const PatchCrack& crack : cracks) {
      cracks_.push_back({&crack.place, crack.tip, {}, -1});
      transition_ = transition_ || crack.tip->transition;
    }
  }

  Patch build(double fineness) {
    for (Crack& crack : cracks_) {
      for (const TipPlace& at : crack.place->tips) {
        crack.rosettes.push_back(add_rosette(net_, *crack.place, at, *crack.tip));
      }
    }
    set_sizes(fineness);
    add_loops();
    for (const Crack& crack : cracks_) {
      add_crack(crack);
    }
    if (patch_.trouble.empty()) {
      fill_rest();
    }
    patch_.nodes = std::move(net_.nodes);
    patch_.elements = std::move(net_.elements);
    return std::move(patch_);
  }

private:
  using Pair = std::pair<int, int>;
  struct Crack {
    const Placement* place = nullptr;
    const TipMesh* tip = nullptr;
    std::vector<Rosette> rosettes; ///< [tip]
    int mouth = -1;
  };

  [[nodiscard]] Vec2 local(const Edge& edge, double xi) const {
    const Vec2 a = frame_.local(host_.mesh().x[edge.a.index()]);
    const Vec2 b = frame_.local(host_.mesh().x[edge.b.index()]);
    const Vec2 m = frame_.local(host_.mesh().x[edge.mid.index()]);
    const Eigen::Vector3d N = shape::Line3::N(shape::Point<1>(xi));
    return N[0] * a + N[1] * b + N[2] * m;
  }
  /// An edge of the host along which a half crack and its ligament run.
  [[nodiscard]] bool on_line(const OutlineEdge& edge) const {
    return half_ != 0 && edge.free && std::abs(local(edge.edge, -1.0).y()) < same &&
           std::abs(local(edge.edge, 0.0).y()) < same &&
           std::abs(local(edge.edge, 1.0).y()) < same &&
           std::max(local(edge.edge, -1.0).x(), local(edge.edge, 1.0).x()) > same;
  }
  [[nodiscard]] static bool has_mouth(const Placement& place, const OutlineEdge& edge) {
    return place.mouth && edge.face == place.mouth->face &&
           (!place.mouth->node.valid() || place.mouth->node == edge.edge.mid);
  }

  /// Where on an edge mouths are, in order, with the cracks they belong to.
  [[nodiscard]] std::vector<std::pair<double, Crack*>> mouths_on(const OutlineEdge& edge) {
    std::vector<std::pair<double, Crack*>> result;
    for (Crack& crack : cracks_) {
      if (has_mouth(*crack.place, edge)) {
        const Mouth& mouth = *crack.place->mouth;
        result.emplace_back(mouth.node.valid() ? 0.0 : mouth.xi, &crack);
      }
    }
    std::ranges::sort(result, {}, &std::pair<double, Crack*>::first);
    return result;
  }

  void set_sizes(double fineness) {
    double finer = 0.0;
    for (const Crack& crack : cracks_) {
      finer = std::max(finer, crack.tip->finer);
    }
    size_ = fill_size_ = Grading(Grading::usual_growth / finer);
    for (const Crack& crack : cracks_) {
      for (const Rosette& rosette : crack.rosettes) {
        const std::size_t rim = rosette.rim.size();
        for (std::size_t j = 0; j + (half_ != 0 ? 1 : 0) < rim; ++j) {
          add_source(size_, rosette.rim[j], rosette.rim[(j + 1) % rim]);
        }
      }
      if (crack.place->mouth) {
        const double part =
            crack.tip->pressed ? pressed_mouth_size / std::max(finer, 1.0) : mouth_size / finer;
        size_.add(crack.place->line.front(), part * own_length(*crack.place) / fineness);
      }
    }
    for (const auto& loop : cavity_.loops) {
      for (const OutlineEdge& edge : loop) {
        const double length = (local(edge.edge, 1.0) - local(edge.edge, -1.0)).norm();
        if (edge.free || !transition_) { // an edge that is tied asks for nothing
          size_.add(local(edge.edge, 0.0), edge.free ? length / fineness : length);
        }
        std::vector<double> ends{-1.0};
        for (const auto& [xi, crack] : mouths_on(edge)) {
          ends.push_back(xi);
        }
        ends.push_back(1.0);
        for (std::size_t i = 1; i < ends.size() && ends.size() > 2; ++i) {
          const double part = 0.5 * (ends[i] - ends[i - 1]); // may be short indeed
          size_.add(local(edge.edge, 0.5 * (ends[i - 1] + ends[i])), part * length);
        }
      }
    }
    add_gaps();
  }
  /// Between cracks and what runs beside them elements are no longer than the gap is wide.
  void add_gaps() {
    std::vector<const Placement*> places;
    for (const Crack& crack : cracks_) {
      places.push_back(crack.place);
    }
    std::vector<std::array<Vec2, 3>> boundary;
    for (const auto& loop : cavity_.loops) {
      for (const OutlineEdge& edge : loop) {
        if (edge.free && half_ == 0) {
          boundary.push_back(
              {local(edge.edge, -1.0), local(edge.edge, 0.0), local(edge.edge, 1.0)});
        }
      }
    }
    add_gap_sizes(places, boundary, size_);
  }
  void add_source(Grading& grading, int a, int b) const {
    const Vec2 p = net_.local(a);
    const Vec2 q = net_.local(b);
    grading.add(0.5 * (p + q), (q - p).norm());
  }

  /// The loops of the cavity, their free edges divided where the crack asks for it. The line of a
  /// half crack is left out and put in by add_crack.
  void add_loops() {
    for (const std::vector<OutlineEdge>& loop : cavity_.loops) {
      std::vector<int> nodes;
      for (const OutlineEdge& edge : loop) {
        nodes.push_back(net_.host_node(edge.edge.a));
        if (on_line(edge)) {
          line_.push_back(edge);
          continue;
        }
        const std::vector<int> inner = add_edge(edge);
        nodes.insert(nodes.end(), inner.begin(), inner.end());
      }
      loops_.push_back(std::move(nodes));
    }
    for (Crack& crack : cracks_) {
      const auto& mouth = crack.place->mouth;
      if (mouth && mouth->node.valid() && crack.mouth < 0) {
        crack.mouth = net_.host_node(mouth->node);
      }
    }
  }

  /// Nodes inside one edge of the outline, after it has been divided.
  std::vector<int> add_edge(const OutlineEdge& edge) {
    if (!edge.free) {
      return transition_ ? add_tied_parts(edge) : add_parts(edge, {-1.0, 1.0});
    }
    const auto curve = [&](double t) { return local(edge.edge, t); };
    std::vector<double> xi{-1.0};
    const auto divide_to = [&](double end) {
      const std::vector<double> part = divide(curve, xi.back(), end, size_);
      xi.insert(xi.end(), part.begin() + 1, part.end());
    };
    for (const auto& [at, crack] : mouths_on(edge)) {
      divide_to(at);
    }
    divide_to(1.0);
    return add_parts(edge, xi);
  }

  /// At least two parts, the middle node of the host's edge between them: the rim follows the
  /// host's displacements exactly, as both are parabolas on each part.
  std::vector<int> add_tied_parts(const OutlineEdge& edge) {
    const auto curve = [&](double t) { return local(edge.edge, t); };
    std::vector<double> xi = divide(curve, -1.0, 0.0, size_);
    const std::vector<double> rest = divide(curve, 0.0, 1.0, size_);
    xi.insert(xi.end(), rest.begin() + 1, rest.end());
    std::vector<int> inner = add_parts(edge, xi);
    const std::vector<Pair>& pieces = patch_.edges.back().second;
    for (std::size_t i = 1; i < xi.size(); ++i) {
      const Pair& piece = pieces[i - 1];
      patch_.tied.push_back(
          {net_.mid(piece.first, piece.second), edge.edge, 0.5 * (xi[i - 1] + xi[i])});
      if (i + 1 < xi.size() && xi[i] != 0.0) {
        patch_.tied.push_back({piece.second, edge.edge, xi[i]});
      }
    }
    return inner;
  }

  std::vector<int> add_parts(const OutlineEdge& edge, const std::vector<double>& xi) {
    const Edge& e = edge.edge;
    const auto mouths = edge.free ? mouths_on(edge) : std::vector<std::pair<double, Crack*>>();
    std::vector<int> inner;
    std::vector<Pair> pieces;
    int from = net_.host_node(e.a);
    for (std::size_t i = 1; i < xi.size(); ++i) {
      const bool last = i + 1 == xi.size();
      int to = 0;
      if (last) {
        to = net_.host_node(e.b);
      } else if (xi[i] == 0.0) {
        to = net_.host_node(e.mid);
      } else {
        to = net_.new_node(point_on(host_.mesh(), e, xi[i]));
      }
      const bool whole = xi.size() == 2;
      const Vec3 half = point_on(host_.mesh(), e, 0.5 * (xi[i - 1] + xi[i]));
      net_.set_mid(from, to, whole ? net_.host_node(e.mid) : net_.new_node(half));
      pieces.emplace_back(from, to);
      if (!last) {
        inner.push_back(to);
        for (const auto& [at, crack] : mouths) {
          crack->mouth = xi[i] == at ? to : crack->mouth;
        }
      }
      from = to;
    }
    for (const Pair& piece : pieces) {
      add_source(fill_size_, piece.first, piece.second);
    }
    patch_.edges.emplace_back(edge.face, std::move(pieces));
    return inner;
  }

  /// New nodes strictly inside a stretch of the crack's line, from s0 to s1 of its length.
  std::vector<int> add_stretch(const Vec2& from, const Vec2& to) {
    const auto curve = [&](double t) { return Vec2(from + t * (to - from)); };
    const std::vector<double> t = divide(curve, 0.0, 1.0, size_);
    std::vector<int> nodes;
    for (std::size_t i = 1; i + 1 < t.size(); ++i) {
      nodes.push_back(net_.new_node(curve(t[i])));
    }
    return nodes;
  }

  /// Corner nodes of the crack from the mouth, or out of the first rosette, to the last one, then
  /// through it to the tip.
  void add_crack(const Crack& crack) {
    const Placement& place = *crack.place;
    const Rosette& last_rosette = crack.rosettes.back();
    const auto rim_point = [&](const TipPlace& tip) {
      return Vec2(tip.at - place.radius * tip.ahead());
    };
    std::vector<int> lip{place.mouth ? crack.mouth : crack.rosettes.front().behind.back()};
    Vec2 from = place.mouth ? place.line.front() : rim_point(place.tips.front());
    for (std::size_t k = 1; k < place.line.size(); ++k) {
      const bool last = k + 1 == place.line.size();
      const Vec2 to = last ? rim_point(place.tips.back()) : place.line[k];
      const std::vector<int> inner = add_stretch(from, to);
      lip.insert(lip.end(), inner.begin(), inner.end());
      lip.push_back(last ? last_rosette.behind.back() : net_.new_node(to));
      from = to;
    }
    for (std::size_t i = 0; i + 1 < lip.size(); ++i) {
      add_source(fill_size_, lip[i], lip[i + 1]);
    }
    if (half_ != 0) {
      add_half_line(crack, lip);
    } else {
      lips_.push_back(lip);
    }
    std::vector<int> corners;
    if (!place.mouth) {
      const Rosette& first = crack.rosettes.front();
      corners.push_back(first.tip);
      corners.insert(corners.end(), first.behind.begin(), first.behind.end() - 1);
    }
    corners.insert(corners.end(), lip.begin(), lip.end());
    corners.insert(corners.end(), last_rosette.behind.rbegin() + 1, last_rosette.behind.rend());
    corners.push_back(last_rosette.tip);
    std::vector<int>& path = patch_.paths.emplace_back();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (i > 0) {
        path.push_back(net_.mid(corners[i - 1], corners[i]));
      }
      path.push_back(corners[i]);
    }
  }

  /// A half: crack, rosette and ligament take the place of the host's edges on the line.
  void add_half_line(const Crack& crack, const std::vector<int>& lip) {
    const Rosette& rosette = crack.rosettes.front();
    double x1 = 0.0;
    NodeId end;
    for (const OutlineEdge& edge : line_) {
      for (const NodeId n : {edge.edge.a, edge.edge.b}) {
        const double x = frame_.local(host_.mesh().x[n.index()]).x();
        if (x > x1) {
          x1 = x;
          end = n;
        }
      }
    }
    if (x1 < 1.0 + crack.place->radius + same) {
      patch_.trouble = "the symmetry line ends inside the rosette";
      return;
    }
    std::vector<int> ligament{rosette.ahead.back()};
    const std::vector<int> inner = add_stretch(net_.local(ligament[0]), {x1, 0.0});
    ligament.insert(ligament.end(), inner.begin(), inner.end());
    ligament.push_back(net_.host_node(end));
    for (std::size_t i = 0; i + 1 < ligament.size(); ++i) {
      add_source(fill_size_, ligament[i], ligament[i + 1]);
    }
    // the whole line in the direction of growth, with the edges of the rosette on it
    std::vector<int> line = lip;
    line.insert(line.end(), rosette.behind.rbegin() + 1, rosette.behind.rend());
    line.push_back(rosette.tip);
    line.insert(line.end(), rosette.ahead.begin(), rosette.ahead.end());
    line.insert(line.end(), ligament.begin() + 1, ligament.end());
    inherit_line(line);
    // what the filling sees: over the rosette
    std::vector<int> contour(lip.begin(), lip.end() - 1);
    if (half_ > 0) { // rim runs from ahead to behind
      contour.insert(contour.end(), rosette.rim.rbegin(), rosette.rim.rend());
    } else {
      contour.insert(contour.end(), rosette.rim.begin(), rosette.rim.end());
    }
    contour.insert(contour.end(), ligament.begin() + 1, ligament.end());
    if (half_ < 0) {
      std::reverse(contour.begin(), contour.end());
    }
    replace_line(contour);
  }

  /// Puts the contour of a half into the loop in the place of the host's nodes on the line.
  void replace_line(const std::vector<int>& contour) {
    for (std::vector<int>& loop : loops_) {
      const auto first = std::find(loop.begin(), loop.end(), contour.front());
      if (first == loop.end()) {
        continue;
      }
      std::rotate(loop.begin(), first, loop.end());
      const auto last = std::find(loop.begin(), loop.end(), contour.back());
      std::vector<int> whole(contour.begin(), contour.end() - 1);
      whole.insert(whole.end(), last, loop.end());
      loop = std::move(whole);
      return;
    }
    patch_.trouble = "the symmetry line is not a straight part of the boundary";
  }

  /// Each new edge on the line belongs to the host edge that its middle lies on.
  void inherit_line(const std::vector<int>& line) {
    for (const OutlineEdge& edge : line_) {
      const double x0 = local(edge.edge, -1.0).x();
      const double x1 = local(edge.edge, 1.0).x();
      std::vector<Pair> pieces;
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double x = 0.5 * (net_.local(line[i]).x() + net_.local(line[i + 1]).x());
        if (x >= std::min(x0, x1) - same && x < std::max(x0, x1) - same) {
          pieces.emplace_back(line[i], line[i + 1]);
        }
      }
      if (x1 < x0) { // in the direction of the host's edge
        std::reverse(pieces.begin(), pieces.end());
        for (Pair& piece : pieces) {
          std::swap(piece.first, piece.second);
        }
      }
      patch_.edges.emplace_back(edge.face, std::move(pieces));
    }
  }

  /// Triangles between the outline, the crack and the rosette.
  void fill_rest() {
    Region region;
    std::map<int, int> place; // patch node -> point
    std::vector<int> node;    // and back
    const auto point = [&](int n) {
      const auto [at, fresh] = place.try_emplace(n, static_cast<int>(node.size()));
      if (fresh) {
        node.push_back(n);
        region.points.push_back(net_.local(n));
      }
      return at->second;
    };
    const auto points = [&](const std::vector<int>& chain) {
      std::vector<int> result;
      std::transform(chain.begin(), chain.end(), std::back_inserter(result), point);
      return result;
    };
    for (const std::vector<int>& loop : loops_) {
      region.loops.push_back(points(loop));
    }
    for (const Crack& crack : cracks_) {
      for (const Rosette& rosette : crack.rosettes) {
        for (std::size_t j = 0; j + 1 < rosette.rim.size(); ++j) {
          add_source(fill_size_, rosette.rim[j], rosette.rim[j + 1]);
        }
        if (half_ == 0) {
          region.loops.push_back(points({rosette.rim.rbegin(), rosette.rim.rend()}));
        }
      }
    }
    for (const std::vector<int>& lip : lips_) {
      region.embedded.push_back(points(lip));
    }
    const Filling filling = fill(region, fill_size_);
    if (!filling.trouble.empty()) {
      patch_.trouble = filling.trouble;
      return;
    }
    for (const Vec2& p : filling.added) {
      node.push_back(net_.new_node(p));
    }
    for (const std::array<int, 3>& t : filling.triangles) {
      net_.add_triangle(node[static_cast<std::size_t>(t[0])], node[static_cast<std::size_t>(t[1])],
                        node[static_cast<std::size_t>(t[2])]);
    }
  }

  const Host& host_;
  CrackFrame frame_;
  int half_;
  const Cavity& cavity_;
  PatchNet net_;
  Patch patch_;
  std::vector<Crack> cracks_;
  Grading size_;      ///< along curves, before they are divided
  Grading fill_size_; ///< in the region, from the edges that were made
  std::vector<std::vector<int>> loops_;
  std::vector<OutlineEdge> line_;
  std::vector<std::vector<int>> lips_;
  bool transition_ = false;
};

} // namespace

Patch build_patch(const Host& host, const std::vector<PatchCrack>& cracks, const Cavity& cavity,
                  double fineness) {
  return Builder(host, cracks, cavity).build(fineness);
}

} // namespace spricka::mesh
