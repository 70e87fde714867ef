// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/outer_products.hpp"
#include "crack/front_contractions.hpp"
#include "crack/interaction_terms.hpp"
#include "crack/k_layout.hpp"
#include "crack/supplementary_functions.hpp"
#include "shape/side_place.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

/// How the entries of K's rows are gathered, element by element, in the plane and in space.
namespace spricka::crack {

/// The rows of K of all points of a front, made once for each builder.
template <class Source> class IntensityFunctionalBuilder {
public:
  static constexpr int dim = Source::dim;

  /// Columns are by KLayout.
  explicit IntensityFunctionalBuilder(KFunctionalIntegrand<Source> front)
      : front_(std::move(front)), source_(front_.source()), layout_(front_.point_count(), dim) {}

  /// Rows of the nodal displacements, from the domains and the free sides that move with them.
  /// [dim * node, K]
  [[nodiscard]] SparseLinearFunctionals displacement_functionals() {
    reset_sums(static_cast<Eigen::Index>(mesh().node_count()));
    for (const base::ElementId e : front_.contracted_elements()) {
      add_element(e);
    }
    for (const MovedFreeSide& side : source_.moved_free_sides()) {
      add_side(side);
    }
    return assemble_functionals();
  }

  /// Rows of what multiplies other functions, in place of the nodal ones.
  /// [dim * count, K]
  [[nodiscard]] SparseLinearFunctionals
  supplementary_functionals(const SupplementaryFunctions& others) {
    reset_sums(others.count);
    for (const base::ElementId e : front_.contracted_elements()) {
      add_others(e, others);
    }
    for (const MovedFreeSide& side : source_.moved_free_sides()) {
      add_others_on(side, others);
    }
    return assemble_functionals();
  }

  /// Rows of forces at points on sides, in the order of `places`; forces on sides that no domain
  /// moves have zero rows. [dim * point of a side, K]
  [[nodiscard]] SparseLinearFunctionals
  face_force_functionals(const std::vector<FacePointForces>& places) {
    std::size_t count = 0;
    for (const FacePointForces& place : places) {
      count += place.points.size();
    }
    reset_sums(static_cast<Eigen::Index>(count));
    Eigen::Index first = 0;
    for (const FacePointForces& place : places) {
      if (const std::optional<UpperOrLowerFace> known =
              source_.crack_face_of_element_side(place.face)) {
        add_places(place, *known, first);
      }
      first += static_cast<Eigen::Index>(place.points.size());
    }
    return assemble_functionals();
  }

private:
  using Vector = shape::Point<dim>;
  using Point = typename KFunctionalIntegrand<Source>::ContractionPoint;

  [[nodiscard]] const model::Mesh& mesh() const { return source_.context().mesh; }

  /// Coefficients of functions. [dim, function]
  using Coefficients = Eigen::Matrix<double, dim, Eigen::Dynamic>;

  // For rows of so many functions. [dim * count, K]
  void reset_sums(Eigen::Index count) {
    slot_.assign(static_cast<std::size_t>(count), -1);
    sums_.clear();
  }

  // What has been added up.
  [[nodiscard]] SparseLinearFunctionals assemble_functionals() const {
    SparseLinearFunctionals rows(dim * static_cast<Eigen::Index>(slot_.size()), layout_.count());
    rows.reserve(std::ranges::count_if(sums_, [](double value) { return value != 0.0; }));
    for (Eigen::Index column = 0; column < layout_.count(); ++column) {
      rows.startVec(column);
      for (std::size_t f = 0; f < slot_.size(); ++f) {
        for (Eigen::Index c = 0; c < dim && slot_[f] >= 0; ++c) {
          if (const double value = sums_[sum_index(slot_[f], column) + static_cast<std::size_t>(c)];
              value != 0.0) {
            rows.insertBack(dim * static_cast<Eigen::Index>(f) + c, column) = value;
          }
        }
      }
    }
    rows.finalize();
    return rows;
  }

  [[nodiscard]] std::size_t sum_index(std::int32_t slot, Eigen::Index column) const {
    return static_cast<std::size_t>(dim * (slot * layout_.count() + column));
  }

  void add_coefficients(Eigen::Index function, std::size_t point, std::size_t column,
                        const Vector& value) {
    std::int32_t& slot = slot_[static_cast<std::size_t>(function)];
    if (slot < 0) {
      const std::size_t width = sum_index(1, 0);
      slot = static_cast<std::int32_t>(sums_.size() / width);
      sums_.resize(sums_.size() + width, 0.0);
    }
    const int mode = static_cast<int>(front_.auxiliary_fields()[column]);
    Eigen::Map<Vector>(sums_.data() + sum_index(slot, layout_.at(point, mode))) += value;
  }

  /// Coefficients of functions for several pairs of a point of the front and an auxiliary field,
  /// one below the other. [dim * pair, function]
  using StackedCoefficients = base::Matrix;

  // Sums over the points of an element, for each point of the front that moves it and each
  // auxiliary field: add(point, sums) adds to sums of `functions`; take(point of the front, column,
  // sum).
  template <class Add, class Take>
  void contract(base::ElementId e, std::size_t functions, const Add& add, const Take& take) const {
    const auto moved = front_.front_motions_of_element(e);
    const std::size_t width = front_.auxiliary_fields().size();
    StackedCoefficients sums =
        StackedCoefficients::Zero(dim * static_cast<Eigen::Index>(moved.size() * width),
                                  static_cast<Eigen::Index>(functions));
    front_.visit_contraction_points(e, moved, [&](const Point& at) { add(at, sums); });
    for (std::size_t j = 0; j < moved.size(); ++j) {
      for (std::size_t k = 0; k < width; ++k) {
        take(moved[j].first, k,
             Coefficients(
                 source_.context().intensity_conversion_factor(front_.auxiliary_fields()[k]) *
                 sums.middleRows<dim>(dim * static_cast<Eigen::Index>(width * j + k))));
      }
    }
  }

  void add_element(base::ElementId e) {
    const std::span<const base::NodeId> nodes = mesh().element_nodes(e);
    contract(
        e, nodes.size(),
        [](const Point& at, StackedCoefficients& sums) {
          base::add_outer_products(1.0, at.tensors.M, at.map.dNdx, sums);
          for (Eigen::Index i = 0; i < at.tensors.hoop.size(); ++i) {
            if (at.tensors.hoop[i] != 0.0) {
              sums.row(dim * i) += at.tensors.hoop[i] / at.x[0] * at.N.transpose();
            }
          }
        },
        [&](std::size_t point, std::size_t column, const Coefficients& values) {
          put_nodes(nodes, point, column, values);
        });
  }

  // The same of other functions.
  void add_others(base::ElementId e, const SupplementaryFunctions& others) {
    const std::vector<Eigen::MatrixX3d>& table = slope_table(e, others);
    contract(
        e, others.of_element(e).size(),
        [&](const Point& at, StackedCoefficients& sums) {
          const Tensor<dim> inverse = at.map.J.inverse();
          const Eigen::Matrix<double, Eigen::Dynamic, dim> slopes =
              table[at.number].lazyProduct(inverse);
          base::add_outer_products(1.0, at.tensors.M, slopes, sums);
        },
        [&](std::size_t point, std::size_t column, const Coefficients& values) {
          put_others(e, point, column, values, others);
        });
  }

  // A point of a side with the tractions of the auxiliary fields, as K takes them.
  template <class Slopes> struct TractionPoint {
    geometry::SideValues N;
    Slopes slopes;                ///< [function, dim]
    std::vector<Vector> traction; ///< [auxiliary field]
  };

  template <class SlopesAt>
  [[nodiscard]] auto traction_points(const MovedFreeSide& side, const geometry::ElementSide& own,
                                     const SlopesAt& slopes_at) const {
    std::vector<TractionPoint<std::invoke_result_t<const SlopesAt&, base::Vec2>>> points;
    for (const auto& point : source_.side_quadrature(own)) {
      const std::optional<typename Source::Place> place =
          source_.locate_on_side(own, point.r, side.on);
      if (!place) {
        continue;
      }
      auto& at = points.emplace_back();
      at.N = own.N(point.r);
      at.slopes = slopes_at(point.r);
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

  // The auxiliary fields' tractions on a side times the slopes along the motion of some functions,
  // summed over the side. slopes_at(place r): [function, dim]; take(point of the front, column,
  // [dim, function]).
  template <class SlopesAt, class Take>
  void contract_side(const MovedFreeSide& side, const geometry::ElementSide& own,
                     const SlopesAt& slopes_at, const Take& take) const {
    const auto points = traction_points(side, own, slopes_at);
    for (const std::size_t i : front_.front_points_moving_element(side.face.element)) {
      SideVectors<dim> q;
      if (points.empty() || !front_.gather_node_motions(i, own.nodes, q)) {
        continue;
      }
      std::vector<Coefficients> sums(front_.auxiliary_fields().size(),
                                     Coefficients::Zero(dim, points.front().slopes.rows()));
      for (const auto& point : points) {
        const Vector moved = q * point.N;
        const Eigen::RowVectorXd along = (point.slopes * moved).transpose();
        for (std::size_t k = 0; k < sums.size(); ++k) {
          sums[k] -= point.traction[k] * along;
        }
      }
      for (std::size_t k = 0; k < sums.size(); ++k) {
        take(i, k, sums[k]);
      }
    }
  }

  void add_side(const MovedFreeSide& side) {
    const geometry::ElementSide own = model::element_side(mesh(), side.face);
    contract_side(
        side, own, [&](const base::Vec2& r) { return surface_gradients<dim>(own, r); },
        [&](std::size_t point, std::size_t column, const Coefficients& values) {
          put_nodes(own.nodes, point, column, values);
        });
  }

  // The motion runs along the side, so that the element's own gradient serves.
  void add_others_on(const MovedFreeSide& side, const SupplementaryFunctions& others) {
    contract_side(
        side, model::element_side(mesh(), side.face),
        [&](const base::Vec2& r) { return slopes_on(side.face, r, others); },
        [&](std::size_t point, std::size_t column, const Coefficients& values) {
          put_others(side.face.element, point, column, values, others);
        });
  }

  // Rows of nodes. [dim, node]
  template <class Block>
  void put_nodes(std::span<const base::NodeId> nodes, std::size_t point, std::size_t column,
                 const Block& values) {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      add_coefficients(static_cast<Eigen::Index>(nodes[n].index()), point, column,
                       values.col(static_cast<Eigen::Index>(n)));
    }
  }

  // Rows of an element's other functions. [dim, function]
  void put_others(base::ElementId e, std::size_t point, std::size_t column,
                  const Coefficients& values, const SupplementaryFunctions& others) {
    const std::span<const std::int32_t> functions = others.of_element(e);
    const std::span<const double> signs = others.signs(e);
    for (std::size_t n = 0; n < functions.size(); ++n) {
      add_coefficients(static_cast<Eigen::Index>(functions[n]), point, column,
                       signs[n] * values.col(static_cast<Eigen::Index>(n)));
    }
  }

  // Slopes of other functions at the points of the rule.
  const std::vector<Eigen::MatrixX3d>& slope_table(base::ElementId e,
                                                   const SupplementaryFunctions& others) {
    const base::ElementType type = mesh().type[e.index()];
    std::vector<Eigen::MatrixX3d>& table = slopes_[{type, source_.quadrature_degree(e)}];
    if (table.empty()) {
      for (const auto& point : source_.element_quadrature(e)) {
        table.push_back(others.slopes(type, point.r));
      }
    }
    return table;
  }

  // Gradients in space of other functions at a place of a side. [function, dim]
  [[nodiscard]] Eigen::MatrixX3d slopes_on(const model::Face& face, const shape::Point<2>& r,
                                           const SupplementaryFunctions& others) const {
    const base::ElementType type = mesh().type[face.element.index()];
    const fe::AnyElement<dim>& element = shape::reference_element<dim>(type);
    const shape::Point<3> at = shape::side_to_solid_point(type, face.side, r);
    const fe::AnyNodeVectors<dim> X = fe::element_coordinates(element, mesh(), face.element);
    const Tensor<dim> J = X.lazyProduct(element.dN(at));
    const Tensor<dim> inverse = J.inverse();
    return others.slopes(type, at).lazyProduct(inverse);
  }

  void add_places(const FacePointForces& on, UpperOrLowerFace side, Eigen::Index first) {
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
          add_coefficients(first + static_cast<Eigen::Index>(p), i, k,
                           -source_.context().intensity_conversion_factor(auxiliary) *
                               (source_.auxiliary_side_gradient(*place, auxiliary) * moved));
        }
      }
    }
  }

  KFunctionalIntegrand<Source> front_;
  const Source& source_;
  KLayout layout_;
  std::vector<std::int32_t> slot_; ///< [function] among the sums, -1: nothing added yet
  std::vector<double> sums_;       ///< [slot][K][dim]
  /// [type, degree of the rule] of other functions
  std::map<std::pair<base::ElementType, int>, std::vector<Eigen::MatrixX3d>> slopes_;
};

} // namespace spricka::crack
