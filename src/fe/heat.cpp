// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/heat.hpp"

#include "fe/corner_rule.hpp"
#include "fe/thermal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::fe {

namespace {

using base::ElementId;
using base::Vec2;
using base::Vec3;

// Rules agree when their moments of a temperature, over an element's share of the largest one,
// differ by less; after so many subdivisions a jump is known to 1e-4 of an element.
constexpr double agree = 1e-7;
constexpr int most_depth = 5;
// More than so much is left by a jump, but not by a kink.
constexpr double jump = 1e-6;
// A rest below this part of the largest temperature is round-off of the linear part.
constexpr double round_off = 1e-9;

Vec3 in_space(const Vec2& x) {
  return {x.x(), x.y(), 0.0};
}

// Points of a temperature inside an element, as many as it takes.
template <shape::PlaneShape S, class Field> class Sampler {
public:
  Sampler(const NodeVectors<S>& X, const Field& field, double scale)
      : X_(X), field_(field), scale_(scale) {}

  [[nodiscard]] bool rough() const { return rough_; }

  std::vector<HeatPoint> points(ElementId e, int tip) {
    points_.clear();
    for (const Chart& chart : charts<S>(tip)) {
      chart_ = chart;
      split(take({0.0, 0.0, 1.0}), 0);
    }
    for (HeatPoint& p : points_) {
      p.element = e;
    }
    return std::move(points_);
  }

private:
  using Moments = Eigen::Matrix<double, 6, 1>;
  struct Cell {
    Vec3 at;
    std::vector<HeatPoint> points;
    std::vector<double> weight; ///< of the reference element
  };

  [[nodiscard]] Cell take(const Vec3& at) const {
    Cell cell{at, {}, {}};
    for_chart_points(chart_, at, [&](const shape::Point<2>& r, double weight) {
      const double det = (X_ * S::dN(r)).determinant();
      cell.points.push_back({{}, r, weight * det, field_(Vec2(X_ * S::N(r)))});
      cell.weight.push_back(weight);
    });
    return cell;
  }

  // With linear and quadratic functions of the reference coordinates.
  static Moments moments(const Cell& cell) {
    Moments m = Moments::Zero();
    for (std::size_t i = 0; i < cell.points.size(); ++i) {
      const double x = cell.points[i].r[0];
      const double y = cell.points[i].r[1];
      const Moments f{{1.0, x, y, x * x, x * y, y * y}};
      m += (cell.weight[i] * cell.points[i].T) * f;
    }
    return m;
  }

  void split(const Cell& cell, int depth) {
    const double h = 0.5 * cell.at[2];
    std::array<Cell, 4> parts;
    Moments sum = Moments::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 at(cell.at[0] + (i % 2 == 0 ? 0.0 : h), cell.at[1] + (i / 2 == 0 ? 0.0 : h), h);
      parts[i] = take(at);
      sum += moments(parts[i]);
    }
    const double off = (moments(cell) - sum).cwiseAbs().maxCoeff();
    if (off <= agree * scale_ || !std::isfinite(off)) {
      keep(cell);
      return;
    }
    rough_ = rough_ || (depth == most_depth && off > jump * scale_);
    for (const Cell& part : parts) {
      if (depth == most_depth) {
        keep(part);
      } else {
        split(part, depth + 1);
      }
    }
  }

  void keep(const Cell& cell) {
    points_.insert(points_.end(), cell.points.begin(), cell.points.end());
  }

  const NodeVectors<S>& X_;
  const Field& field_;
  double scale_;
  Chart chart_;
  std::vector<HeatPoint> points_;
  bool rough_ = false;
};

// The function that an element takes, nearest to the temperature at the points: linear in x where
// it does not hold quadratic functions, else in its reference coordinates (thermal_kernel.hpp).
template <shape::PlaneShape S>
CornerValues<S> nearest_to(const NodeVectors<S>& X, const Law& law,
                           std::span<const HeatPoint> points) {
  const Vec2 centre = X.template leftCols<corners<S>()>().rowwise().mean();
  const bool in_x = FreeExpansion<S>::wanted(X, law);
  const auto functions = [&](const Vec2& x, const shape::Point<2>& r) {
    CornerValues<S> f = CornerValues<S>::Zero();
    if (in_x) {
      f.template head<3>() << 1.0, x - centre;
    } else {
      f = Linear<S>::N(r);
    }
    return f;
  };
  const int terms = in_x ? 3 : corners<S>();
  base::Matrix G = base::Matrix::Zero(terms, terms);
  base::Vector right = base::Vector::Zero(terms);
  for (const HeatPoint& p : points) {
    const base::Vector f = functions(X * S::N(p.r), p.r).head(terms);
    G += p.area * f * f.transpose();
    right += p.area * p.T * f;
  }
  const base::Vector c = G.ldlt().solve(right);
  CornerValues<S> T;
  for (int n = 0; n < corners<S>(); ++n) {
    T[n] = c.dot(functions(X.col(n), shape::node<S>(n)).head(terms));
  }
  return T;
}

// Calls use(S{}, e, X, law, points) for all elements that have a rest.
template <class Use>
void for_rest(const model::Model& model, const model::Mesh& mesh, const CaseHeat& heat, Use&& use) {
  for (std::size_t i = 0; i < mesh.element_count() && !heat.first.empty(); ++i) {
    const ElementId e(i);
    const std::span<const HeatPoint> points = heat.of(e);
    if (points.empty()) {
      continue;
    }
    shape::with_plane_shape(mesh.type[i], [&]<shape::PlaneShape S>(S shape) {
      use(shape, e, coordinates<S>(mesh, e), law_of(model, mesh, e), points);
    });
  }
}

bool has_rest(const Law& law, base::ElementType type) {
  return base::info(type).dim == 2 && base::info(type).quadratic && !law.axisymmetric &&
         !law.projected;
}

void add_points(const model::Model& model, const PatchedMesh& patched, double scale,
                CaseHeat& heat) {
  const model::Mesh& mesh = patched.mesh;
  heat.first.assign(1, 0);
  for (std::size_t i = 0; i < mesh.element_count(); ++i) {
    const ElementId e(i);
    const Law law = law_of(model, mesh, e);
    if (has_rest(law, mesh.type[i]) && heat.field.varies(e)) {
      shape::with_plane_shape(mesh.type[i], [&]<shape::PlaneShape S>(S) {
        const NodeVectors<S> X = coordinates<S>(mesh, e);
        const auto field = [&](const Vec2& x) { return heat.field(e, x); };
        Sampler<S, decltype(field)> sampler(X, field, scale);
        std::vector<HeatPoint> points = sampler.points(e, corner_at<S>(mesh, e, patched.tips));
        if (sampler.rough()) {
          heat.rough.resize(mesh.element_count(), false);
          heat.rough[i] = true;
        }
        const CornerValues<S> T = nearest_to<S>(X, law, points);
        double most = 0.0;
        for (HeatPoint& p : points) {
          p.T -= taken_temperature<S>(X, law, T, p.r);
          most = std::max(most, std::abs(p.T));
        }
        if (most > round_off * scale) {
          heat.temperature.segment<corners<S>()>(mesh.first[i]) = T;
          heat.points.insert(heat.points.end(), points.begin(), points.end());
        }
      });
    }
    heat.first.push_back(heat.points.size());
  }
  if (heat.points.empty()) {
    heat.first.clear();
  }
}

} // namespace

HeatField::HeatField(const PatchedMesh& patched, const model::LoadCase& load_case) {
  const model::Mesh& mesh = patched.mesh;
  for (const model::Load& load : load_case.loads) {
    if (load.type != model::LoadType::temperature) {
      continue;
    }
    if (places_ == nullptr) {
      places_ = std::make_shared<HostPlaces>(patched);
      is_new_.resize(mesh.element_count());
      for (std::size_t e = 0; e < is_new_.size(); ++e) {
        is_new_[e] = patched.is_new(ElementId(e));
      }
    }
    Part part{load.value.front(), std::vector<bool>(mesh.element_count(), false), false};
    for (const ElementId e : mesh.set(load.elements).elements) {
      part.member[e.index()] = true;
    }
    std::vector<bool> host(patched.host_mesh.element_count(), false);
    if (!places_->taken().empty()) {
      for (const ElementId e : patched.host_mesh.set(load.elements).elements) {
        host[e.index()] = true;
      }
      const auto in = [&](ElementId e) { return host[e.index()]; };
      part.by_place =
          std::ranges::any_of(places_->taken(), in) && !std::ranges::all_of(places_->taken(), in);
    }
    parts_.push_back(std::move(part));
    host_member_.push_back(std::move(host));
  }
}

bool HeatField::cut() const {
  return std::ranges::any_of(parts_, [](const Part& part) { return part.by_place; });
}

bool HeatField::varies(ElementId e) const {
  return std::ranges::any_of(parts_, [&](const Part& part) {
    return (part.by_place && is_new_[e.index()]) ||
           (part.member[e.index()] && !part.value.is_constant());
  });
}

double HeatField::operator()(ElementId e, const Vec2& x) const {
  double T = 0.0;
  ElementId host;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    bool acts = part.member[e.index()];
    if (part.by_place && is_new_[e.index()]) {
      host = host.valid() ? host : places_->at(x);
      acts = host_member_[i][host.index()];
    }
    T += acts ? part.value(in_space(x)) : 0.0;
  }
  return T;
}

CaseHeat case_heat(const model::Model& model, const PatchedMesh& patched,
                   const model::LoadCase& load_case) {
  CaseHeat heat;
  heat.temperature = element_temperature(model, patched.mesh, load_case);
  if (heat.temperature.size() == 0) {
    return heat;
  }
  heat.field = HeatField(patched, load_case);
  const double scale = heat.temperature.cwiseAbs().maxCoeff();
  if (patched.mesh.dim == 2 && scale > 0.0) {
    add_points(model, patched, scale, heat);
  }
  return heat;
}

void add_rest_load(const model::Model& model, const model::Mesh& mesh, const ActingHeat& acting,
                   base::MaterialId only, base::Vector& f) {
  for_rest(model, mesh, *acting.heat,
           [&]<shape::PlaneShape S>(S, ElementId e, const NodeVectors<S>& X, const Law& law,
                                    std::span<const HeatPoint> points) {
             if (only.valid() && model.property_of(mesh, e).material != only) {
               return;
             }
             NodeVectors<S> F = NodeVectors<S>::Zero();
             const double beta = acting.factor * law.thickness * heat_modulus(law);
             for (const HeatPoint& p : points) {
               F += (beta * p.area * p.T) * jacobian<S>(X, p.r).dNdx.transpose();
             }
             Eigen::Index i = 0;
             for (const base::NodeId n : mesh.nodes_of(e)) {
               f.segment<2>(2 * static_cast<Eigen::Index>(n.index())) += F.col(i++);
             }
           });
}

// 1/2 (alpha T)^T D (alpha T) is half of alpha beta T^2 in each heated direction. Of two cases each
// has its own points, where the other one's rest is what its field leaves.
void add_rest_energy(const model::Model& model, const model::Mesh& mesh,
                     std::span<const ActingHeat> acting, const base::Vector& u,
                     std::vector<double>& energy) {
  for (const ActingHeat& one : acting) {
    for_rest(model, mesh, *one.heat,
             [&]<shape::PlaneShape S>(S, ElementId e, const NodeVectors<S>& X, const Law& law,
                                      std::span<const HeatPoint> points) {
               const NodeVectors<S> U = gather<S>(mesh, e, u);
               const double beta = one.factor * law.thickness * heat_modulus(law);
               const double square = 0.5 * law.expansion * law.heated_directions();
               for (const HeatPoint& p : points) {
                 const Vec2 x = X * S::N(p.r);
                 double all = 0.0;
                 for (const ActingHeat& other : acting) {
                   if (!other.heat->of(e).empty()) {
                     const CornerValues<S> T =
                         corner_temperature<S>(mesh, e, other.heat->temperature);
                     all += other.factor *
                            (other.heat->field(e, x) - taken_temperature<S>(X, law, T, p.r));
                   }
                 }
                 const double div = (U * jacobian<S>(X, p.r).dNdx).trace();
                 energy[e.index()] += beta * p.area * p.T * (square * all - div);
               }
             });
  }
}

} // namespace spricka::fe
