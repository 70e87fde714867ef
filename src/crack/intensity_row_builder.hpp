// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outer_products.hpp"
#include "crack/front_contractions.hpp"
#include "crack/functional_sums.hpp"
#include "crack/interaction_terms.hpp"
#include "crack/k_layout.hpp"
#include "crack/supplementary_slopes.hpp"
#include "shape/side_place.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// How the entries of K's rows are gathered, element by element, in the plane and in space.
namespace spricka::crack {

/// Makes the rows of K of all points of a front.
template <class Source> class IntensityFunctionalBuilder {
public:
  static constexpr int dim = Source::dim;

  /// Columns are by KLayout.
  explicit IntensityFunctionalBuilder(KFunctionalIntegrand<Source> front)
      : front_(std::move(front)), source_(front_.source()), layout_(front_.point_count(), dim) {}

  /// Rows of the nodal displacements and of what multiplies other functions, from the domains and
  /// the free sides that move with them, all of which are visited once for both.
  [[nodiscard]] IntensityFunctionals
  displacement_functionals(const SupplementaryFunctions& others = {}) const {
    IntensityFunctionalSums of_nodes(static_cast<Eigen::Index>(mesh().node_count()), dim, layout_);
    IntensityFunctionalSums of_others(others.count, dim, layout_);
    SupplementarySlopes slopes(others);
    for (const base::ElementId e : front_.contracted_elements()) {
      add_element(e, slopes, of_nodes, of_others);
    }
    for (const MovedFreeSide& side : source_.moved_free_sides()) {
      add_side(side, slopes, of_nodes, of_others);
    }
    return {of_nodes.assemble(), of_others.assemble()};
  }

  /// Rows of forces at points on sides, in the order of `places`; forces on sides that no domain
  /// moves have zero rows. [dim * point of a side, K]
  [[nodiscard]] SparseLinearFunctionals
  face_force_functionals(const std::vector<FacePointForces>& places) const {
    std::size_t count = 0;
    for (const FacePointForces& place : places) {
      count += place.points.size();
    }
    IntensityFunctionalSums sums(static_cast<Eigen::Index>(count), dim, layout_);
    Eigen::Index first = 0;
    for (const FacePointForces& place : places) {
      if (const std::optional<UpperOrLowerFace> known =
              source_.crack_face_of_element_side(place.face)) {
        add_places(place, *known, first, sums);
      }
      first += static_cast<Eigen::Index>(place.points.size());
    }
    return sums.assemble();
  }

private:
  using Vector = shape::Point<dim>;
  using Point = typename KFunctionalIntegrand<Source>::ContractionPoint;

  [[nodiscard]] const model::Mesh& mesh() const { return source_.context().mesh; }

  /// Coefficients of functions. [dim, function]
  using Coefficients = Eigen::Matrix<double, dim, Eigen::Dynamic>;
  /// Gradients of an element's functions, nodal ones first, then others. [function, dim]
  using FunctionGradients = Eigen::Matrix<double, Eigen::Dynamic, dim>;
  /// Coefficients of functions for several pairs of a point of the front and an auxiliary field,
  /// one below the other. [dim * pair, function]
  using StackedCoefficients = base::Matrix;

  [[nodiscard]] int mode(std::size_t column) const {
    return static_cast<int>(front_.auxiliary_fields()[column]);
  }

  void add_element(base::ElementId e, SupplementarySlopes& slopes,
                   IntensityFunctionalSums& of_nodes, IntensityFunctionalSums& of_others) const {
    const std::span<const base::NodeId> nodes = mesh().element_nodes(e);
    const auto count = static_cast<Eigen::Index>(nodes.size());
    const Eigen::Index others = slopes.count(e);
    const auto moved = front_.front_motions_of_element(e);
    const std::size_t width = front_.auxiliary_fields().size();
    StackedCoefficients sums = StackedCoefficients::Zero(
        dim * static_cast<Eigen::Index>(moved.size() * width), count + others);
    FunctionGradients gradients(count + others, dim);
    const SupplementarySlopes::AtPoints* const table = slopes_in_element(e, slopes);
    front_.visit_contraction_points(e, moved, [&](const Point& at) {
      gradients.topRows(count) = at.map.dNdx;
      if (table != nullptr) {
        const Tensor<dim> inverse = at.map.J.inverse();
        gradients.bottomRows(others) =
            (*table)[at.number].template leftCols<dim>().lazyProduct(inverse);
      }
      base::add_outer_products(1.0, at.tensors.M, gradients, sums);
      for (Eigen::Index i = 0; i < at.tensors.hoop.size(); ++i) {
        if (at.tensors.hoop[i] != 0.0) {
          sums.row(dim * i).head(count) += at.tensors.hoop[i] / at.x[0] * at.N.transpose();
        }
      }
    });
    for (std::size_t j = 0; j < moved.size(); ++j) {
      for (std::size_t k = 0; k < width; ++k) {
        const Coefficients values =
            source_.context().intensity_conversion_factor(front_.auxiliary_fields()[k]) *
            sums.middleRows<dim>(dim * static_cast<Eigen::Index>(width * j + k));
        put_nodes(nodes, moved[j].first, mode(k), values.leftCols(count), of_nodes);
        put_others(e, moved[j].first, mode(k), values.rightCols(others), slopes, of_others);
      }
    }
  }

  // Of other functions in an element at the points of its rule; null: it has none.
  [[nodiscard]] const SupplementarySlopes::AtPoints*
  slopes_in_element(base::ElementId e, SupplementarySlopes& slopes) const {
    return slopes.count(e) == 0
               ? nullptr
               : &slopes.in_element<dim>(mesh().type[e.index()], source_.element_quadrature(e));
  }

  // A point of a side with the tractions of the auxiliary fields, as K takes them.
  struct TractionPoint {
    geometry::SideValues N;
    FunctionGradients slopes;     ///< along the side of the nodal ones [function, dim]
    std::vector<Vector> traction; ///< [auxiliary field]
  };

  // What adds to the sums on a side: its nodes' functions and the others of its element.
  [[nodiscard]] std::vector<TractionPoint> traction_points(const MovedFreeSide& side,
                                                           const geometry::ElementSide& own,
                                                           SupplementarySlopes& slopes) const {
    std::vector<TractionPoint> points;
    const auto count = static_cast<Eigen::Index>(own.nodes.size());
    const Eigen::Index others = slopes.count(own.element);
    const auto& rule = source_.side_quadrature(own);
    for (const auto& point : rule) {
      const std::optional<typename Source::Place> place =
          source_.locate_on_side(own, point.r, side.on);
      if (!place) {
        continue;
      }
      TractionPoint& at = points.emplace_back();
      at.N = own.N(point.r);
      at.slopes.resize(count + others, dim);
      at.slopes.topRows(count) = surface_gradients<dim>(own, point.r);
      if (others > 0) {
        const auto number = static_cast<std::size_t>(&point - rule.data());
        const Tensor<dim> inverse = element_jacobian(side.face, point.r).inverse();
        at.slopes.bottomRows(others) =
            slopes.on_side(mesh().type[own.element.index()], side.face.side, rule)[number]
                .template leftCols<dim>()
                .lazyProduct(inverse);
      }
      const Vector x = (own.X * at.N).template head<dim>();
      const Vector area = (point.weight * source_.context().relative_depth(x)) *
                          own.area_vector(point.r).template head<dim>();
      for (const std::size_t auxiliary : front_.auxiliary_fields()) {
        at.traction.push_back(source_.context().intensity_conversion_factor(auxiliary) *
                              source_.auxiliary_traction(*place, auxiliary, area));
      }
    }
    return points;
  }

  // The auxiliary fields' tractions on a side times the slopes along the motion of functions,
  // summed over the side. The motion runs along the side, so that the gradients of other functions
  // in the element serve.
  void add_side(const MovedFreeSide& side, SupplementarySlopes& slopes,
                IntensityFunctionalSums& of_nodes, IntensityFunctionalSums& of_others) const {
    const geometry::ElementSide own = model::element_side(mesh(), side.face);
    const std::vector<TractionPoint> points = traction_points(side, own, slopes);
    const auto count = static_cast<Eigen::Index>(own.nodes.size());
    for (const std::size_t i : front_.front_points_moving_element(side.face.element)) {
      SideVectors<dim> q;
      if (points.empty() || !front_.gather_node_motions(i, own.nodes, q)) {
        continue;
      }
      const Eigen::Index functions = points.front().slopes.rows();
      std::vector<Coefficients> sums(front_.auxiliary_fields().size(),
                                     Coefficients::Zero(dim, functions));
      for (const TractionPoint& point : points) {
        const Vector moved = q * point.N;
        const Eigen::RowVectorXd along = (point.slopes * moved).transpose();
        for (std::size_t k = 0; k < sums.size(); ++k) {
          sums[k] -= point.traction[k] * along;
        }
      }
      for (std::size_t k = 0; k < sums.size(); ++k) {
        put_nodes(own.nodes, i, mode(k), sums[k].leftCols(count), of_nodes);
        put_others(side.face.element, i, mode(k), sums[k].rightCols(functions - count), slopes,
                   of_others);
      }
    }
  }

  // Coefficients of nodes. [dim, node]
  template <class Block>
  static void put_nodes(std::span<const base::NodeId> nodes, std::size_t point, int mode,
                        const Block& values, IntensityFunctionalSums& sums) {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      sums.add(static_cast<Eigen::Index>(nodes[n].index()), point, mode,
               values.col(static_cast<Eigen::Index>(n)));
    }
  }

  // Coefficients of an element's other functions. [dim, function]
  template <class Block>
  static void put_others(base::ElementId e, std::size_t point, int mode, const Block& values,
                         const SupplementarySlopes& slopes, IntensityFunctionalSums& sums) {
    if (values.cols() == 0) {
      return;
    }
    const std::span<const std::int32_t> functions = slopes.functions().of_element(e);
    const std::span<const double> signs = slopes.functions().signs(e);
    for (std::size_t n = 0; n < functions.size(); ++n) {
      sums.add(static_cast<Eigen::Index>(functions[n]), point, mode,
               signs[n] * values.col(static_cast<Eigen::Index>(n)));
    }
  }

  // dx by the element's reference coordinates at a place of a side.
  [[nodiscard]] Tensor<dim> element_jacobian(const model::Face& face,
                                             const shape::Point<2>& r) const {
    const base::ElementType type = mesh().type[face.element.index()];
    const fe::AnyElement<dim>& element = shape::reference_element<dim>(type);
    const fe::AnyNodeVectors<dim> X = fe::element_coordinates(element, mesh(), face.element);
    return X.lazyProduct(
        element.dN(shape::side_to_solid_point(type, face.side, r).template head<dim>()));
  }

  void add_places(const FacePointForces& on, UpperOrLowerFace side, Eigen::Index first,
                  IntensityFunctionalSums& sums) const {
    const geometry::ElementSide own = model::element_side(mesh(), on.face);
    for (const std::size_t i : front_.front_points_moving_element(on.face.element)) {
      SideVectors<dim> q;
      if (!front_.gather_node_motions(i, own.nodes, q)) {
        continue;
      }
      for (std::size_t p = 0; p < on.points.size(); ++p) {
        const base::Vec2 r = on.points[p].r.template head<2>();
        const std::optional<typename Source::Place> place = source_.locate_on_side(own, r, side);
        if (!place) {
          continue; // the front itself, a line without an area
        }
        const Vector moved = q * own.N(r);
        for (std::size_t k = 0; k < front_.auxiliary_fields().size(); ++k) {
          const std::size_t auxiliary = front_.auxiliary_fields()[k];
          const Vector value = -source_.context().intensity_conversion_factor(auxiliary) *
                               (source_.auxiliary_side_gradient(*place, auxiliary) * moved);
          sums.add(first + static_cast<Eigen::Index>(p), i, mode(k), value);
        }
      }
    }
  }

  KFunctionalIntegrand<Source> front_;
  const Source& source_;
  KLayout layout_;
};

} // namespace spricka::crack
