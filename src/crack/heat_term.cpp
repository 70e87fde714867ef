// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack/heat_term.hpp"

#include "fe/corner_rule.hpp"
#include "shape/topology.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::crack {

namespace {

using base::ElementId;
using base::Vec2;

std::vector<ElementId> all_elements(const VirtualExtensionField& field) {
  std::vector<ElementId> all = field.elements;
  all.insert(all.end(), field.inside.begin(), field.inside.end());
  std::ranges::sort(all);
  return all;
}

// Derivative along the crack of the volume change in the section of auxiliary field 1 to 3.
double section_slope(const TipContext& set, const PolarCoordinates& at, std::size_t auxiliary) {
  const SectionField w = section_field(section_field_number<2>(auxiliary), {at.r, at.theta},
                                       make_section_body(set.material, set.state()));
  return w.w_yy.x() + w.w_yz.y();
}

/// The volume change of a auxiliary field along the crack, and about an axis its strain round it.
struct Swelling {
  double slope = 0.0; ///< of the volume change, along the crack
  double hoop = 0.0;
};
Swelling swelling(const TipContext& set, const Vec2& x, std::size_t auxiliary) {
  const PolarCoordinates at = polar_coordinates(set.tip, x);
  Swelling s{section_slope(set, at, auxiliary), 0.0};
  if (set.is_axisymmetric()) {
    s.hoop = auxiliary_field_displacement(set, at, auxiliary).x() / x.x();
    // (v_x / x),1
    s.slope += (Vec2(auxiliary_field_gradient(set, at, auxiliary) * set.tip.e1).x() -
                s.hoop * set.tip.e1.x()) /
               x.x();
  }
  return s;
}

// One element of a domain.
class HeatTermElement {
public:
  HeatTermElement(const TipContext& set, ElementId e, const std::map<base::NodeId, double>& q,
                  const base::Vector& u)
      : set_(set), e_(e), element_(plane_reference_element(set.mesh, e)),
        X_(fe::element_coordinates(element_, set.mesh, e)),
        U_(fe::gather_element_values(element_, set.mesh, e, u)),
        law_(fe::constitutive_law(set.model, set.mesh, e)),
        T_(fe::gather_corner_temperatures(element_, set.mesh, e, set.loads.temperature)),
        carried_(fe::FreeExpansion::must_remove_beforehand(element_, X_, law_)),
        moved_(extension_at_element_nodes(set.mesh, e, q)),
        strained_((moved_.array() != 1.0).any()) {
    if (carried_) {
      free_ = fe::FreeExpansion(element_, X_, law_, T_);
    }
  }

  [[nodiscard]] ElementId id() const { return e_; }
  [[nodiscard]] Vec2 x(const shape::Point<2>& r) const { return X_ * element_.N(r); }
  [[nodiscard]] double beta() const { return fe::thermal_modulus(law_); }
  /// What the element takes of the temperature.
  [[nodiscard]] double taken(const shape::Point<2>& r) const {
    return carried_ ? free_.temperature(x(r)) : T_.dot(element_.linear_element().N(r));
  }
  [[nodiscard]] double extension(const shape::Point<2>& r) const {
    return moved_.dot(element_.N(r));
  }
  [[nodiscard]] double volume_change(const shape::Point<2>& r) const {
    return Eigen::Matrix2d(U_.lazyProduct(map(r).dNdx)).trace() + hoop(r);
  }
  [[nodiscard]] double hoop(const shape::Point<2>& r) const {
    return U_.row(0) * fe::HoopStrain<PlaneElement>(element_, X_, law_, r).h;
  }
  /// The point t of -1 .. 1 on a side.
  [[nodiscard]] shape::Point<2> on_side(int side, double t) const {
    return 0.5 * (1.0 - t) * element_.node_local_coordinates(side) +
           0.5 * (1.0 + t) * element_.node_local_coordinates(after(side));
  }
  /// dx/dt there.
  [[nodiscard]] Vec2 along_side(int side, const shape::Point<2>& r) const {
    const shape::Point<2> step = 0.5 * (element_.node_local_coordinates(after(side)) -
                                        element_.node_local_coordinates(side));
    return Eigen::Matrix2d(X_.lazyProduct(element_.dN(r))) * step;
  }
  [[nodiscard]] Vec2 middle() const { return x(element_.centre()); }
  /// Of q, round the axis.
  [[nodiscard]] double extension_round(const shape::Point<2>& r) const {
    return set_.is_axisymmetric() ? extension(r) * set_.tip.e1.x() / x(r).x() : 0.0;
  }

  // - beta D div(q v,1) of a auxiliary field v.
  void add_to_K(const shape::Point<2>& r, double area, double D,
                std::array<double, auxiliary_field_count<2>>& sum) const {
    const Vec2 at = x(r);
    const PolarCoordinates place = polar_coordinates(set_.tip, at);
    const double q = extension(r);
    const double round = extension_round(r);
    const Vec2 grad = strained_ ? Vec2(map(r).dNdx.transpose() * moved_) : Vec2(Vec2::Zero());
    for (std::size_t k = 1; k < auxiliary_field_count<2>; ++k) {
      const Swelling v = swelling(set_, at, k);
      double div = q * v.slope + round * v.hoop;
      if (strained_) {
        div += grad.dot(auxiliary_field_gradient(set_, place, k) * set_.tip.e1);
      }
      sum[k] -= beta() * area * set_.relative_depth(at) * D * div;
    }
  }

  // - beta D div(q u,1) of the displacements. Their second derivatives by central differences,
  // which are exact but for round-off as good as where shape functions are polynomials of x.
  [[nodiscard]] double of_G(const shape::Point<2>& r, double area, double D) const {
    const fe::Jacobian<PlaneElement> at = map(r);
    constexpr double h = 1e-5;
    Eigen::RowVector2d slope;
    for (int i = 0; i < 2; ++i) {
      const shape::Point<2> step = h * shape::Point<2>::Unit(i);
      slope[i] = (volume_change(r + step) - volume_change(r - step)) / (2.0 * h);
    }
    const double along = (slope * at.J.inverse()).dot(set_.tip.e1);
    const Vec2 grad = at.dNdx.transpose() * moved_;
    const Vec2 carried = Eigen::Matrix2d(U_.lazyProduct(at.dNdx)) * set_.tip.e1;
    return -beta() * area * set_.relative_depth(x(r)) * D *
           (grad.dot(carried) + extension(r) * along + extension_round(r) * hoop(r));
  }

  void add(const mesh::CrackFront& front, bool wants_G,
           std::array<double, auxiliary_field_count<2>>& sum) const {
    // What the element takes less the affine temperature, times auxiliary fields that are singular
    // at the tip: by collapsed charts. What it does not take follows at its own points.
    const std::array<base::NodeId, 1> tips{front.tip_point().node};
    for (const fe::ReferenceChart& chart :
         fe::reference_charts(element_, fe::find_tip_corner(set_.mesh, e_, tips))) {
      fe::for_chart_points(chart, {0.0, 0.0, 1.0}, [&](const shape::Point<2>& r, double weight) {
        const double area = weight * map(r).det;
        add_to_K(r, area, taken(r) - (*set_.affine)(set_.tip, x(r)), sum);
      });
    }
    for (const fe::ScaledTemperature& acting : set_.loads.heat) {
      for (const fe::ResidualTemperaturePoint& p : acting.heat->residual_points_in_element(e_)) {
        add_to_K(p.r, p.area, acting.factor * p.T, sum);
        sum[0] += wants_G ? of_G(p.r, p.area, acting.factor * p.T) : 0.0;
      }
    }
  }

private:
  /// The corner at which a side ends.
  [[nodiscard]] int after(int side) const { return (side + 1) % element_.corners; }
  [[nodiscard]] fe::Jacobian<PlaneElement> map(const shape::Point<2>& r) const {
    return fe::jacobian(element_, X_, r);
  }

  const TipContext& set_;
  ElementId e_;
  const PlaneElement& element_;
  PlaneVectors X_;
  PlaneVectors U_;
  fe::ConstitutiveLaw law_;
  fe::CornerValues<2> T_;
  bool carried_; ///< the nodes, through the free expansion
  fe::FreeExpansion free_;
  PlaneValues moved_;
  bool strained_;
};

double temperature_at(const FrontLoads& loads, ElementId e, const Vec2& x) {
  double T = 0.0;
  for (const fe::ScaledTemperature& acting : loads.heat) {
    T += acting.factor * acting.heat->field(e, x);
  }
  return T;
}

// Both elements of a side inside the domain, and its number in each.
struct Between {
  ElementId left, right;
  int of_left = 0, of_right = 0;
};

std::vector<Between> sides_between(const model::Mesh& mesh, const std::vector<ElementId>& all) {
  std::map<std::pair<base::NodeId, base::NodeId>, std::pair<ElementId, int>> open;
  std::vector<Between> found;
  for (const ElementId e : all) {
    const auto nodes = mesh.element_nodes(e);
    const base::ElementType type = mesh.type[e.index()];
    for (int s = 0; s < base::element_info(type).sides; ++s) {
      const auto side = shape::side_nodes(type, s);
      const base::NodeId a = nodes[static_cast<std::size_t>(side[0])];
      const base::NodeId b = nodes[static_cast<std::size_t>(side[1])];
      if (const auto met = open.find({b, a}); met != open.end()) {
        found.push_back({met->second.first, e, met->second.second, s});
      } else {
        open[{a, b}] = {e, s};
      }
    }
  }
  return found;
}

// Integral of f over [-1, 1], halved where two rules differ.
template <class F>
double line_integral(const F& f, double from, double to, double scale, int depth) {
  const auto rule = [&](double a, double b) {
    double sum = 0.0;
    for (const auto& p : shape::line_rule(9)) {
      sum += 0.5 * (b - a) * p.weight * f(0.5 * (a + b) + 0.5 * (b - a) * p.r[0]);
    }
    return sum;
  };
  const double middle = 0.5 * (from + to);
  const double halves = rule(from, middle) + rule(middle, to);
  if (depth == 0 || std::abs(halves - rule(from, to)) <= scale) {
    return halves;
  }
  return line_integral(f, from, middle, scale, depth - 1) +
         line_integral(f, middle, to, scale, depth - 1);
}

// beta (T - that of an element) eps_ii q n_1 of both sides of an edge: T is the mean of what
// stands on the left and on the right of it, a jump drives what it finds on both sides.
class EdgeTerm {
public:
  EdgeTerm(const TipContext& set, const std::map<base::NodeId, double>& q, const base::Vector& u)
      : set_(set), q_(q), u_(u), scale_(set.loads.temperature.cwiseAbs().maxCoeff()) {}

  [[nodiscard]] double operator()(const Between& edge) const {
    constexpr int most_halvings = 12;
    constexpr double exact = 1e-7;
    constexpr double nothing = 1e-11; // round-off
    const HeatTermElement left(set_, edge.left, q_, u_);
    const HeatTermElement right(set_, edge.right, q_, u_);
    double size = 0.0;
    const auto value = [&](double t) {
      const shape::Point<2> r = left.on_side(edge.of_left, t);
      // The same place: sides of neighbours run against each other.
      const shape::Point<2> s = right.on_side(edge.of_right, -t);
      const Vec2 tangent = left.along_side(edge.of_left, r);
      // Outer normal of the left element times the length per t.
      const double n = Vec2(tangent.y(), -tangent.x()).dot(set_.tip.e1);
      const double T = 0.5 * (temperature_beside(left, r) + temperature_beside(right, s));
      const double a = (T - left.taken(r)) * left.volume_change(r) * left.beta();
      const double b = (T - right.taken(s)) * right.volume_change(s) * right.beta();
      const double weight = left.extension(r) * n * set_.relative_depth(left.x(r));
      size = std::max(size, scale_ * std::abs(left.volume_change(r)) * left.beta() *
                                tangent.norm() * left.extension(r));
      return (a - b) * weight;
    };
    double most = 0.0;
    for (const auto& p : shape::line_rule(9)) { // how large it is
      most = std::max(most, std::abs(value(p.r[0])));
    }
    // Round-off would be halved to the end for nothing.
    return most <= nothing * size ? 0.0
                                  : line_integral(value, -1.0, 1.0, exact * size, most_halvings);
  }

private:
  // What stands on one side of an edge: where the element takes all of the temperature that it
  // knows, that, also where a sliver at its edge has another one that no point has seen.
  [[nodiscard]] double temperature_beside(const HeatTermElement& element,
                                          const shape::Point<2>& r) const {
    const ElementId e = element.id();
    const bool takes_all =
        std::ranges::all_of(set_.loads.heat, [&](const fe::ScaledTemperature& acting) {
          return acting.heat->residual_points_in_element(e).empty();
        });
    return takes_all ? element.taken(r)
                     : temperature_at(set_.loads, e, beside(element.x(r), element.middle()));
  }
  // Just inside an element, should the temperature jump on its side.
  static Vec2 beside(const Vec2& x, const Vec2& centre) { return x + 1e-9 * (centre - x); }

  const TipContext& set_;
  const std::map<base::NodeId, double>& q_;
  const base::Vector& u_;
  double scale_; ///< largest temperature
};

// Whether the temperature that the elements of a domain take is the same on both sides of all
// edges, and all that there is.
bool is_taken(const TipContext& set, const std::vector<ElementId>& all) {
  for (const fe::ScaledTemperature& acting : set.loads.heat) {
    if (std::ranges::any_of(all, [&](ElementId e) {
          return !acting.heat->residual_points_in_element(e).empty();
        })) {
      return false;
    }
  }
  const double scale = set.loads.temperature.cwiseAbs().maxCoeff();
  std::map<base::NodeId, double> of_node;
  for (const ElementId e : all) {
    const auto nodes = set.mesh.element_nodes(e);
    for (int c = 0; c < base::element_info(set.mesh.type[e.index()]).corners; ++c) {
      const double T = set.loads.temperature[set.mesh.first[e.index()] + c];
      const auto [met, fresh] = of_node.try_emplace(nodes[static_cast<std::size_t>(c)], T);
      if (!fresh && std::abs(met->second - T) > 1e-9 * scale) {
        return false;
      }
    }
  }
  return true;
}

} // namespace

std::optional<AffineTemperature>
fit_affine_temperature(const TipContext& set, const mesh::CrackFront& front,
                       const std::vector<VirtualExtensionField>& fields) {
  if (set.loads.temperature.size() == 0 || set.loads.heat.empty()) {
    return std::nullopt;
  }
  const std::vector<ElementId> all = all_elements(fields.back());
  if (is_taken(set, all)) {
    return std::nullopt;
  }
  AffineTemperature affine;
  Eigen::Matrix2d G = Eigen::Matrix2d::Zero();
  Vec2 right = Vec2::Zero();
  double weight = 0.0;
  for (const ElementId e : all) {
    const auto nodes = set.mesh.element_nodes(e);
    if (std::ranges::find(nodes, front.tip_point().node) != nodes.end()) {
      affine.at_tip += temperature_at(set.loads, e, set.tip.x);
      weight += 1.0;
    }
  }
  affine.at_tip /= std::max(weight, 1.0);
  for (const ElementId e : all) {
    const auto nodes = set.mesh.element_nodes(e);
    for (int c = 0; c < base::element_info(set.mesh.type[e.index()]).corners; ++c) {
      const Vec2 d = set.mesh.x[nodes[static_cast<std::size_t>(c)].index()].head<2>() - set.tip.x;
      const double T = set.loads.temperature[set.mesh.first[e.index()] + c] - affine.at_tip;
      G += d * d.transpose();
      right += T * d;
    }
  }
  // By least squares over the corners, through the temperature at the tip.
  affine.slope = G.ldlt().solve(right);
  return affine;
}

bool has_temperature_jump_in_element(const TipContext& set, const VirtualExtensionField& field) {
  return std::ranges::any_of(set.loads.heat, [&](const fe::ScaledTemperature& acting) {
    const std::vector<bool>& discontinuous = acting.heat->discontinuous;
    return !discontinuous.empty() && std::ranges::any_of(all_elements(field), [&](ElementId e) {
      return discontinuous[e.index()];
    });
  });
}

std::array<double, auxiliary_field_count<2>>
nonlinear_temperature_term(const TipContext& set, const mesh::CrackFront& front,
                           const VirtualExtensionField& field, const base::Vector& u) {
  std::array<double, auxiliary_field_count<2>> sum{};
  const std::map<base::NodeId, double> q = field.extension_by_node();
  const std::vector<ElementId> all = all_elements(field);
  const bool wants_G = !has_temperature_jump_in_element(set, field) && (u.array() != 0.0).any();
  for (const ElementId e : all) {
    HeatTermElement(set, e, q, u).add(front, wants_G, sum);
  }
  if (!wants_G) {
    return sum;
  }
  const EdgeTerm term(set, q, u);
  for (const Between& edge : sides_between(set.mesh, all)) {
    sum[0] += term(edge);
  }
  return sum;
}

} // namespace spricka::crack
