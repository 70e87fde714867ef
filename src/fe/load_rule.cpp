// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/load_rule.hpp"

#include "fe/element.hpp"
#include "model/loads.hpp"
#include "model/mesh.hpp"

#include <cmath>
#include <limits>

namespace spricka::fe {

namespace {

/// Bound of the load's magnitude over a side or element, and its largest value at the usual points.
struct Bound {
  double bound = 0.0;
  double seen = 0.0;
  double mean = 0.0;
};

template <shape::Shape S>
Bound bound_of(const Eigen::Matrix<double, 3, S::nodes>& X, const model::Load& load) {
  Bound b;
  double size = 0.0;
  for (const auto& point : shape::quadrature<S>(load_degree)) {
    const double value = load_value(load, base::Vec3(X * S::N(point.r))).norm();
    b.seen = std::max(b.seen, value);
    b.mean += point.weight * value;
    size += point.weight;
  }
  b.mean /= size;
  const base::PlaceCell cell = place_cell<S>(X, {}, {1.0, 1.0, 1.0});
  b.bound = b.seen +
            hidden_value(load, cell, {base::Vec3::Constant(-b.seen), base::Vec3::Constant(b.seen)});
  return b;
}

template <shape::ElementShape S>
Eigen::Matrix<double, 3, S::nodes> in_space(const model::Mesh& mesh, base::ElementId e) {
  Eigen::Matrix<double, 3, S::nodes> X = Eigen::Matrix<double, 3, S::nodes>::Zero();
  X.template topRows<S::dim>() = coordinates<S>(mesh, e);
  return X;
}

// Calls f(S{}, X) for the part-th face or element of a load.
template <class F>
void with_part(const model::Mesh& mesh, const model::Load& load,
               const std::vector<base::ElementId>& elements, std::size_t part, F&& f) {
  if (load.faces.valid()) {
    const std::vector<model::Face> side{mesh.set(load.faces).faces[part]};
    for_faces(mesh, side, [&]<shape::Shape Side>(Side shape, const model::Face& face) {
      f(shape, side_coordinates<Side>(mesh, face));
    });
    return;
  }
  const std::array<base::ElementId, 1> element{elements[part]};
  for_blocks(mesh, element,
             [&]<shape::ElementShape S>(S shape, std::span<const base::ElementId> block) {
               f(shape, in_space<S>(mesh, block.front()));
             });
}

} // namespace

// Where bounds promise more than the usual points see, the few parts with the highest bounds are
// searched: a peak between the points of all others must not pass for the whole load.
FieldScale load_scale(const model::Mesh& mesh, const model::Load& load,
                      const std::vector<base::ElementId>& elements) {
  constexpr std::size_t searched = 64;
  if (is_constant(load)) {
    const double value = load_value(load, base::Vec3::Zero()).norm();
    return {value, value};
  }
  const std::size_t parts =
      load.faces.valid() ? mesh.set(load.faces).faces.size() : elements.size();
  std::vector<std::pair<double, std::size_t>> bounds;
  FieldScale scale;
  for (std::size_t i = 0; i < parts; ++i) {
    with_part(mesh, load, elements, i, [&]<shape::Shape S>(S, const auto& X) {
      const Bound b = bound_of<S>(X, load);
      scale.largest = std::max(scale.largest, b.seen);
      scale.mean += b.mean / static_cast<double>(parts);
      // With a minus sign, so that the highest bounds come first.
      bounds.emplace_back(-b.bound, i);
    });
  }
  const std::size_t most = std::min(searched, bounds.size());
  std::partial_sort(bounds.begin(), bounds.begin() + static_cast<std::ptrdiff_t>(most),
                    bounds.end());
  // Bounds descend: where one promises hardly more than was found, no later one does.
  for (std::size_t k = 0; k < most && -bounds[k].first > 1.02 * scale.largest; ++k) {
    with_part(mesh, load, elements, bounds[k].second, [&]<shape::Shape S>(S, const auto& X) {
      const AdaptedRule<S::dim> rule = load_rule<S>(X, load, scale);
      if (rule.largest > scale.largest) {
        scale.largest = rule.largest;
        scale.mean += rule.amount / (reference_size<S>() * static_cast<double>(parts));
      }
    });
  }
  if (scale.largest == 0.0 && !bounds.empty() && std::isfinite(bounds.front().first)) {
    scale.largest = -bounds.front().first; // nothing was found of what the bounds promise
  }
  return scale;
}

template <shape::Shape S>
AdaptedRule<S::dim> load_rule(const Eigen::Matrix<double, 3, S::nodes>& X, const model::Load& load,
                              const FieldScale& scale) {
  if (is_constant(load)) {
    const auto usual = shape::quadrature<S>(load_degree);
    return {{usual.begin(), usual.end()}, 0.0, 0.0, 0.0};
  }
  return adapted_rule<S>(
      load_degree,
      [&](const shape::Point<S::dim>& r) { return load_value(load, base::Vec3(X * S::N(r))); },
      [&](const UnitBox& box, const SeenValues& seen) {
        return hidden_value(load, place_cell<S>(X, box.low, box.high), seen);
      },
      {load_tolerance(S::dim), scale, is_smooth(load)});
}

#define LOAD_RULE(S)                                                                               \
  template AdaptedRule<S::dim> load_rule<S>(const Eigen::Matrix<double, 3, S::nodes>&,             \
                                            const model::Load&, const FieldScale&);
LOAD_RULE(shape::Line2)
LOAD_RULE(shape::Line3)
SPRICKA_EACH_SHAPE(LOAD_RULE)

} // namespace spricka::fe
