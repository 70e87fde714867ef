// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/interaction_terms.hpp"
#include "crack/k_layout.hpp"
#include "crack/supplementary_functions.hpp"
#include "fe/jacobian.hpp"
#include "shape/side_place.hpp"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

/// How the entries of K's rows are gathered, element by element, in the plane and in space.
namespace spricka::crack {

/// How nodes move with one point of the front, the mean over its domains per length of the front.
using PointMotion = std::map<base::NodeId, base::Vec3>;

/// Motion by node of one point of a front, the mean of its domains' extensions over the length that
/// belongs to the point; none without a domain.
inline PointMotion point_motion(const mesh::FrontPoint& point,
                                const std::vector<ExtensionField>& domains) {
  PointMotion motion;
  const double part = 1.0 / (static_cast<double>(domains.size()) * point.weight);
  for (const ExtensionField& field : domains) {
    for (const NodeMotion& moved : field.motion) {
      motion.try_emplace(moved.node, base::Vec3::Zero()).first->second +=
          part * moved.q * moved.along;
    }
  }
  return motion;
}

/// What a displacement is contracted with at a point: its gradient, and about an axis the strain
/// round it.
template <int dim> struct ContractionTensor {
  Tensor<dim> M = Tensor<dim>::Zero();
  double hoop = 0.0;
};

using RowEntries = std::vector<Eigen::Triplet<double>>;

/// One front with the motions of its points, and which points move an element. `Source` is
/// TipFields or FrontFields. Rows are made once for each builder.
template <class Source> class IntensityRowBuilder {
public:
  static constexpr int dim = Source::dim;

  /// domains: [point][domain]. Columns are by KLayout; of a half model those of the other modes than
  /// K1 are zero by symmetry.
  IntensityRowBuilder(const Source& source, const mesh::CrackFront& front,
                      const std::vector<std::vector<ExtensionField>>& domains)
      : source_(source), layout_(domains.size(), dim) {
    for (std::size_t mode = 1; mode <= (front.symmetric_half ? 1 : std::size_t{dim}); ++mode) {
      auxiliary_fields_.push_back(mode);
    }
    for (std::size_t i = 0; i < domains.size(); ++i) {
      motion_.push_back(point_motion(front.points[i], domains[i]));
      for (const ExtensionField& field : domains[i]) {
        for (const std::vector<base::ElementId>* elements : {&field.elements, &field.inside}) {
          for (const base::ElementId e : *elements) {
            points_of_[e].insert(i);
          }
        }
      }
    }
  }

  /// Rows of the nodal displacements, from the domains and the free sides that move with them.
  /// [dim * node, K]
  [[nodiscard]] SparseRows rows() {
    for (const base::ElementId e : contracted_elements()) {
      add_element(e);
    }
    for (const MovedFreeSide& side : source_.sides()) {
      add_side(side);
    }
    return made(dim * static_cast<Eigen::Index>(mesh().node_count()));
  }

  /// Rows of what multiplies other functions, in place of the nodal ones.
  /// [dim * count, K]
  [[nodiscard]] SparseRows supplementary_rows(const SupplementaryFunctions& others) {
    for (const base::ElementId e : contracted_elements()) {
      add_others(e, others);
    }
    for (const MovedFreeSide& side : source_.sides()) {
      add_others_on(side, others);
    }
    return made(dim * others.count);
  }

  /// Rows of forces at points on sides, in the order of `places`; forces on sides that no domain
  /// moves have zero rows. [dim * point of a side, K]
  [[nodiscard]] SparseRows force_rows(const std::vector<FacePointForces>& places) {
    Eigen::Index first = 0;
    for (const FacePointForces& place : places) {
      if (const std::optional<CrackFaceSide> known = source_.side_of(place.face)) {
        add_places(place, *known, first);
      }
      first += dim * static_cast<Eigen::Index>(place.points.size());
    }
    return made(first);
  }

  /// Elements in which a displacement is contracted: about an axis also those that a domain moves
  /// as one.
  [[nodiscard]] std::vector<base::ElementId> contracted_elements() const {
    std::vector<base::ElementId> all(source_.strained().begin(), source_.strained().end());
    if (source_.is_contracted_inside()) {
      all.insert(all.end(), source_.rigid().begin(), source_.rigid().end());
    }
    return all;
  }

  /// A point of an element with what a displacement is contracted with there.
  struct ContractionPoint {
    shape::Point<dim> r;
    std::size_t number = 0; ///< of the rule's points
    fe::Jacobian<fe::AnyElement<dim>> map;
    fe::NodeValues<fe::AnyElement<dim>> N;
    shape::Point<dim> x;
    /// [place among the points of the front that move the element, auxiliary field] with the weight
    /// of the point, but without the factor that makes K of it
    std::vector<ContractionTensor<dim>> tensors;
  };
  /// The points of a front that move an element, and how they move its nodes.
  using MovingPoints = std::vector<std::pair<std::size_t, fe::AnyNodeVectors<dim>>>;
  [[nodiscard]] MovingPoints moving_points(base::ElementId e) const {
    MovingPoints moved;
    for (const std::size_t i : points_of_.at(e)) {
      fe::AnyNodeVectors<dim> q;
      if (gather(i, mesh().element_nodes(e), q)) {
        moved.emplace_back(i, q);
      }
    }
    return moved;
  }
  /// Visits the points of the rule over an element (crack_space.10; in the plane s(u) : A + (H e1) .
  /// (s(v) grad q) with A = (H_v e1) (x) grad q - (div q) H_v is e1 . T grad q of the interaction).
  template <class Visit>
  void for_contractions(base::ElementId e, const MovingPoints& moved, const Visit& visit) const {
    const fe::AnyElement<dim>& element = shape_of(e);
    const fe::AnyNodeVectors<dim> X = fe::coordinates(element, mesh(), e);
    const auto& elasticity = source_.elasticity(e);
    ContractionPoint at;
    at.tensors.resize(moved.size() * auxiliary_fields_.size());
    for (const auto& point : source_.rule(e)) {
      at.r = point.r;
      at.map = fe::jacobian(element, X, point.r);
      at.N = element.N(point.r);
      at.x = X * at.N;
      const double weight = point.weight * at.map.det * source_.set().relative_depth(at.x);
      for (std::size_t k = 0; k < auxiliary_fields_.size(); ++k) {
        const AuxiliaryField<dim> v =
            source_.field(e, at.number, at.x, auxiliary_fields_[k], elasticity);
        for (std::size_t j = 0; j < moved.size(); ++j) {
          const Tensor<dim> grad = moved[j].second.lazyProduct(at.map.dNdx);
          const Vector q = moved[j].second * at.N;
          const ContractionTensor<dim> c =
              contracted(elasticity, v, grad, q, source_.set().hoop(q, at.x));
          at.tensors[auxiliary_fields_.size() * j + k] = {weight * c.M, weight * c.hoop};
        }
      }
      visit(at);
      ++at.number;
    }
  }

private:
  using Vector = shape::Point<dim>;
  /// Coefficients of functions. [dim, function]
  using Coefficients = Eigen::Matrix<double, dim, Eigen::Dynamic>;

  [[nodiscard]] const model::Mesh& mesh() const { return source_.set().mesh; }

  [[nodiscard]] SparseRows made(Eigen::Index count) const {
    SparseRows rows(count, layout_.count());
    rows.setFromTriplets(entries_.begin(), entries_.end());
    return rows;
  }

  [[nodiscard]] const fe::AnyElement<dim>& shape_of(base::ElementId e) const {
    return shape::reference_element<dim>(mesh().type[e.index()]);
  }

  // The motion of some nodes with a point of the front; false: they rest.
  template <class Motion>
  bool gather(std::size_t point, std::span<const base::NodeId> nodes, Motion& q) const {
    bool moves = false;
    q.setZero(dim, static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto at = motion_[point].find(nodes[n]);
      if (at != motion_[point].end()) {
        q.col(static_cast<Eigen::Index>(n)) = at->second.template head<dim>();
        moves = true;
      }
    }
    return moves;
  }

  void put(Eigen::Index row, std::size_t point, std::size_t column, const Vector& value) {
    const Eigen::Index at = layout_.at(point, static_cast<int>(auxiliary_fields_[column]));
    for (Eigen::Index c = 0; c < dim; ++c) {
      if (value[c] != 0.0) {
        entries_.emplace_back(row + c, at, value[c]);
      }
    }
  }

  // What the gradient H of a displacement is contracted with: s(A - (div q) H_v) + sigma_v (grad
  // q)^T + div sigma_v (x) q, A = H_v grad q, with the components round an axis (crack.37); `round`:
  // of q, round the axis. D is symmetric, so s(u) : A = H_u : s(A).
  template <class Elasticity>
  [[nodiscard]] static ContractionTensor<dim>
  contracted(const Elasticity& elasticity, const AuxiliaryField<dim>& v, const Tensor<dim>& grad,
             const Vector& q, double round) {
    const double div = grad.trace() + round;
    const DeformationState<dim> A =
        elasticity.state(v.H * grad - div * v.H, (round - div) * v.hoop);
    return {A.sigma + v.sigma * grad.transpose() + v.divergence * q.transpose(),
            A.sigma_hoop + v.sigma_hoop * round};
  }

  // Sums over the points of an element, for each point of the front that moves it and each
  // auxiliary field: add(point, its tensor, sum) adds to sums that begin with `zero`; take(point of
  // the front, column, sum).
  template <class Block, class Add, class Take>
  void contract(base::ElementId e, const Block& zero, const Add& add, const Take& take) const {
    const MovingPoints moved = moving_points(e);
    const std::size_t width = auxiliary_fields_.size();
    std::vector<Block> sums(moved.size() * width, zero);
    for_contractions(e, moved, [&](const ContractionPoint& at) { add(at, sums); });
    for (std::size_t j = 0; j < moved.size(); ++j) {
      for (std::size_t k = 0; k < width; ++k) {
        take(moved[j].first, k,
             source_.set().conversion_factor(auxiliary_fields_[k]) * sums[width * j + k]);
      }
    }
  }

  void add_element(base::ElementId e) {
    using Block = fe::AnyNodeVectors<dim>;
    const std::span<const base::NodeId> nodes = mesh().element_nodes(e);
    contract(
        e, Block(Block::Zero(dim, static_cast<Eigen::Index>(nodes.size()))),
        [](const ContractionPoint& at, std::vector<Block>& sums) {
          const Block slopes = at.map.dNdx.transpose();
          for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += at.tensors[i].M.lazyProduct(slopes);
            if (at.tensors[i].hoop != 0.0) {
              sums[i].row(0) += at.tensors[i].hoop / at.x[0] * at.N.transpose();
            }
          }
        },
        [&](std::size_t point, std::size_t column, const Block& values) {
          put_nodes(nodes, point, column, values);
        });
  }

  // The same of other functions.
  void add_others(base::ElementId e, const SupplementaryFunctions& others) {
    const auto count = static_cast<Eigen::Index>(others.of_element(e).size());
    const std::vector<Eigen::MatrixX3d>& table = slope_table(e, others);
    contract(
        e, Coefficients(Coefficients::Zero(dim, count)),
        [&](const ContractionPoint& at, std::vector<Coefficients>& sums) {
          const Tensor<dim> inverse = at.map.J.inverse();
          const Coefficients slopes = table[at.number].lazyProduct(inverse).transpose();
          for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] += at.tensors[i].M.lazyProduct(slopes);
          }
        },
        [&](std::size_t point, std::size_t column, const Coefficients& values) {
          put_others(e, point, column, values, others);
        });
  }

  // The auxiliary fields' tractions on a side times the slopes along the motion of some functions.
  // slopes_at(place r): [function, dim]; take(point of the front, column, [dim, function]).
  template <class SlopesAt, class Take>
  void contract_side(const MovedFreeSide& side, const geometry::ElementSide& own,
                     const SlopesAt& slopes_at, const Take& take) const {
    for (const std::size_t i : points_of_.at(side.face.element)) {
      SideVectors<dim> q;
      if (!gather(i, own.nodes, q)) {
        continue;
      }
      for (const auto& point : source_.side_rule(own)) {
        const std::optional<typename Source::Place> place = source_.place(own, point.r, side.on);
        if (!place) {
          continue;
        }
        const geometry::SideValues N = own.N(point.r);
        const Vector x = (own.X * N).template head<dim>();
        const Vector area = (point.weight * source_.set().relative_depth(x)) *
                            own.area_vector(point.r).template head<dim>();
        const Vector moved = q * N;
        const Eigen::RowVectorXd along = (slopes_at(point.r) * moved).transpose();
        for (std::size_t k = 0; k < auxiliary_fields_.size(); ++k) {
          const std::size_t auxiliary = auxiliary_fields_[k];
          const Vector t = source_.set().conversion_factor(auxiliary) *
                           source_.traction(*place, auxiliary, area);
          take(i, k, Coefficients(-t * along));
        }
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
      put(dim * static_cast<Eigen::Index>(nodes[n].index()), point, column,
          values.col(static_cast<Eigen::Index>(n)));
    }
  }

  // Rows of an element's other functions. [dim, function]
  void put_others(base::ElementId e, std::size_t point, std::size_t column,
                  const Coefficients& values, const SupplementaryFunctions& others) {
    const std::span<const std::int32_t> functions = others.of_element(e);
    const std::span<const double> signs = others.signs(e);
    for (std::size_t n = 0; n < functions.size(); ++n) {
      put(dim * static_cast<Eigen::Index>(functions[n]), point, column,
          signs[n] * values.col(static_cast<Eigen::Index>(n)));
    }
  }

  // Slopes of other functions at the points of the rule.
  const std::vector<Eigen::MatrixX3d>& slope_table(base::ElementId e,
                                                   const SupplementaryFunctions& others) {
    const base::ElementType type = mesh().type[e.index()];
    std::vector<Eigen::MatrixX3d>& table = slopes_[{type, source_.degree(e)}];
    if (table.empty()) {
      for (const auto& point : source_.rule(e)) {
        table.push_back(others.slopes(type, point.r));
      }
    }
    return table;
  }

  // Gradients in space of other functions at a place of a side. [function, dim]
  [[nodiscard]] Eigen::MatrixX3d slopes_on(const model::Face& face, const shape::Point<2>& r,
                                           const SupplementaryFunctions& others) const {
    const base::ElementType type = mesh().type[face.element.index()];
    const fe::AnyElement<dim>& element = shape_of(face.element);
    const shape::Point<3> at = shape::side_to_solid_point(type, face.side, r);
    const fe::AnyNodeVectors<dim> X = fe::coordinates(element, mesh(), face.element);
    const Tensor<dim> J = X.lazyProduct(element.dN(at));
    const Tensor<dim> inverse = J.inverse();
    return others.slopes(type, at).lazyProduct(inverse);
  }

  void add_places(const FacePointForces& on, CrackFaceSide side, Eigen::Index first) {
    const geometry::ElementSide own = model::element_side(mesh(), on.face);
    for (const std::size_t i : points_of_.at(on.face.element)) {
      SideVectors<dim> q;
      if (!gather(i, own.nodes, q)) {
        continue;
      }
      for (std::size_t p = 0; p < on.points.size(); ++p) {
        const base::Vec2 r = on.points[p].r.template head<2>();
        const std::optional<typename Source::Place> place = source_.place(own, r, side);
        if (!place) {
          continue; // the front itself, a line without an area
        }
        const Vector moved = q * own.N(r);
        for (std::size_t k = 0; k < auxiliary_fields_.size(); ++k) {
          const std::size_t auxiliary = auxiliary_fields_[k];
          put(first + dim * static_cast<Eigen::Index>(p), i, k,
              -source_.set().conversion_factor(auxiliary) *
                  (source_.side_gradient(*place, auxiliary) * moved));
        }
      }
    }
  }

  const Source& source_;
  KLayout layout_;
  std::vector<std::size_t> auxiliary_fields_; ///< of the modes that are not zero
  std::vector<PointMotion> motion_; ///< [point]
  std::map<base::ElementId, std::set<std::size_t>> points_of_;
  RowEntries entries_;
  /// [type, degree of the rule] of other functions
  std::map<std::pair<base::ElementType, int>, std::vector<Eigen::MatrixX3d>> slopes_;
};

} // namespace spricka::crack
