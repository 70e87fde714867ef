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

template <int dim>
Bound bound_of(const AnyElement<dim>& element, const SpaceNodes<dim>& X, const model::Load& load) {
  Bound b;
  double size = 0.0;
  for (const auto& point : shape::quadrature<dim>(element.domain, load_degree)) {
    const double value = load_value(load, X * element.N(point.r)).norm();
    b.seen = std::max(b.seen, value);
    b.mean += point.weight * value;
    size += point.weight;
  }
  b.mean /= size;
  const base::PlaceCell cell = place_cell<dim>(element, X, {}, {1.0, 1.0, 1.0});
  b.bound = b.seen +
            hidden_value(load, cell, {base::Vec3::Constant(-b.seen), base::Vec3::Constant(b.seen)});
  return b;
}

// Calls f(element, X) for the part-th face or element of a load.
template <class F>
void with_part(const model::Mesh& mesh, const model::Load& load,
               const std::vector<base::ElementId>& elements, std::size_t part, F&& f) {
  if (load.faces.valid()) {
    with_any_side(mesh, mesh.set(load.faces).faces[part], f);
  } else {
    with_any_element(mesh, elements[part], [&]<int dim>(const AnyElement<dim>& element) {
      f(element, in_space<dim>(coordinates(element, mesh, elements[part])));
    });
  }
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
    with_part(mesh, load, elements, i,
              [&]<int dim>(const AnyElement<dim>& element, const SpaceNodes<dim>& X) {
                const Bound b = bound_of<dim>(element, X, load);
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
    with_part(mesh, load, elements, bounds[k].second,
              [&]<int dim>(const AnyElement<dim>& element, const SpaceNodes<dim>& X) {
                const AdaptedRule<dim> rule = load_rule<dim>(element, X, load, scale);
                if (rule.largest > scale.largest) {
                  scale.largest = rule.largest;
                  scale.mean +=
                      rule.amount / (reference_size(element.domain) * static_cast<double>(parts));
                }
              });
  }
  if (scale.largest == 0.0 && !bounds.empty() && std::isfinite(bounds.front().first)) {
    scale.largest = -bounds.front().first; // nothing was found of what the bounds promise
  }
  return scale;
}

void end_at_sides(const SpaceNodes<3>& X, base::PlaceCell& cell) {
  constexpr double round_off = 1e-9;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double low = X.row(k).minCoeff();
    const double high = X.row(k).maxCoeff();
    const double off = round_off * (high - low);
    if (high > low && (X.row(k).array() <= low + off).count() > 1) {
      cell.least[k] = low + 2.0 * off;
    }
    if (high > low && (X.row(k).array() >= high - off).count() > 1) {
      cell.most[k] = high - 2.0 * off;
    }
  }
  cell.least = cell.least.cwiseMin(cell.centre);
  cell.most = cell.most.cwiseMax(cell.centre);
}

template <int dim>
base::PlaceCell place_cell(const AnyElement<dim>& element, const SpaceNodes<dim>& X,
                           std::array<double, 3> low, std::array<double, 3> high) {
  constexpr double border = 1e-9; // to round-off
  for (std::size_t k = 0; k < dim; ++k) {
    if (low[k] < high[k]) {
      low[k] = std::max(low[k], border);
      high[k] = std::min(high[k], 1.0 - border);
    }
  }
  const auto at = [&](const std::array<double, 3>& s) { // s in [-1, 1]
    std::array<double, 3> t{};
    for (std::size_t k = 0; k < dim; ++k) {
      t[k] = 0.5 * (low[k] + high[k]) + 0.5 * s[k] * (high[k] - low[k]);
    }
    return base::Vec3(X * element.N(unit_cube_point<dim>(element.domain, t).r));
  };
  base::PlaceCell cell;
  cell.centre = at({});
  end_at_sides(X, cell);
  for (std::size_t k = 0; k < dim; ++k) {
    std::array<double, 3> s{};
    s[k] = 1.0;
    const base::Vec3 ahead = at(s);
    s[k] = -1.0;
    cell.axes.col(static_cast<Eigen::Index>(k)) = 0.5 * (ahead - at(s));
  }
  constexpr int corners = dim == 1 ? 3 : (dim == 2 ? 9 : 27);
  for (int c = 0; c < corners; ++c) { // what is curved leaves the straight cell most at these
    std::array<double, 3> s{};
    for (int k = 0, rest = c; k < dim; ++k, rest /= 3) {
      s[static_cast<std::size_t>(k)] = rest % 3 - 1;
    }
    const base::Vec3 straight = cell.centre + cell.axes * base::Vec3(s[0], s[1], s[2]);
    cell.bulge = cell.bulge.cwiseMax((at(s) - straight).cwiseAbs());
  }
  return cell;
}

template <int dim>
AdaptedRule<dim> load_rule(const AnyElement<dim>& element, const SpaceNodes<dim>& X,
                           const model::Load& load, const FieldScale& scale) {
  if (is_constant(load)) {
    const auto usual = shape::quadrature<dim>(element.domain, load_degree);
    return {{usual.begin(), usual.end()}, 0.0, 0.0, 0.0};
  }
  return adapted_rule<dim>(
      element.domain, load_degree,
      [&](const shape::Point<dim>& r) { return load_value(load, X * element.N(r)); },
      [&](const UnitBox& box, const SeenValues& seen) {
        return hidden_value(load, place_cell<dim>(element, X, box.low, box.high), seen);
      },
      {load_tolerance(dim), scale, is_smooth(load)});
}

#define LOAD_RULE(dim)                                                                             \
  template base::PlaceCell place_cell<dim>(const AnyElement<dim>&, const SpaceNodes<dim>&,         \
                                           std::array<double, 3>, std::array<double, 3>);          \
  template AdaptedRule<dim> load_rule<dim>(const AnyElement<dim>&, const SpaceNodes<dim>&,         \
                                           const model::Load&, const FieldScale&);
LOAD_RULE(1)
LOAD_RULE(2)
LOAD_RULE(3)

} // namespace spricka::fe
