// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/space/auxiliary_table.hpp"
#include "crack/space/face_forces.hpp"
#include "crack/space/front_forces.hpp"
#include "crack/space/front_rule.hpp"
#include "crack/space/other_functions.hpp"
#include "model/mesh_side.hpp"
#include "shape/side_place.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

/// How the entries of K's rows are gathered, element by element.
namespace spricka::crack {

/// How nodes move with one point of the front, the mean over its domains per length of the front.
using PointMotion = std::map<base::NodeId, base::Vec3>;

/// Motion by node of one point of a front, the mean of its domains' extensions over the length that
/// belongs to the point.
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

/// Which auxiliary fields, and where their rows go.
struct AuxiliaryFieldColumns {
  std::vector<std::size_t> auxiliary_fields;

  [[nodiscard]] Eigen::Index count() const {
    return static_cast<Eigen::Index>(auxiliary_fields.size());
  }
};

using RowEntries = std::vector<Eigen::Triplet<double>>;

/// One front with the motions of its points, and which points move an element.
class IntensityRowBuilder {
public:
  IntensityRowBuilder(const FrontSetting& set, const mesh::CrackFront& front,
                      const FrontExtensions& fields, AuxiliaryFieldColumns columns)
      : set_(set), fields_(fields), columns_(std::move(columns)) {
    for (std::size_t i = 0; i < fields.points.size(); ++i) {
      motion_.push_back(fields.points[i].empty() ? PointMotion()
                                                 : point_motion(front.points[i], fields.points[i]));
      for (const ExtensionField& field : fields.points[i]) {
        for (const base::ElementId e : field.elements) {
          points_of_[e].insert(i);
        }
      }
    }
  }

  /// Rows of the nodal displacements, from the domains and the free sides that move with them.
  /// [3 * node, columns * points] Once for each builder.
  [[nodiscard]] SparseRows rows() {
    auxiliary_table_ = cached_auxiliary_table(set_, fields_);
    for (const base::ElementId e : fields_.elements()) {
      add_element(e);
    }
    for (const MovedFreeSide& side : fields_.sides) {
      add_side(side);
    }
    return made(3 * static_cast<Eigen::Index>(set_.mesh.node_count()));
  }

  /// Rows of what multiplies other functions, in place of the nodal ones.
  /// [3 * count, columns * points] Once for each builder.
  [[nodiscard]] SparseRows supplementary_rows(const SupplementaryFunctions& others) {
    auxiliary_table_ = cached_auxiliary_table(set_, fields_);
    for (const base::ElementId e : fields_.elements()) {
      add_others(e, others);
    }
    for (const MovedFreeSide& side : fields_.sides) {
      add_others_on(side, others);
    }
    return made(3 * others.count);
  }

  /// Rows of forces at points on sides, in the order of `places`; forces on sides that no domain
  /// moves have zero rows. [3 * point of a side, columns * points] Once for each builder.
  [[nodiscard]] SparseRows force_rows(const std::vector<FacePointForces>& places) {
    std::map<model::Face, CrackFaceSide> moved;
    for (const MovedFreeSide& side : fields_.sides) {
      moved.emplace(side.face, side.on);
    }
    Eigen::Index first = 0;
    for (const FacePointForces& place : places) {
      const auto known = moved.find(place.face);
      if (known != moved.end()) {
        add_places(place, known->second, first);
      }
      first += 3 * static_cast<Eigen::Index>(place.points.size());
    }
    return made(first);
  }

private:
  using ElementMap = fe::Jacobian<fe::AnyElement<3>>;

  [[nodiscard]] SparseRows made(Eigen::Index count) const {
    SparseRows rows(count, columns_.count() * static_cast<Eigen::Index>(motion_.size()));
    rows.setFromTriplets(entries_.begin(), entries_.end());
    return rows;
  }

  [[nodiscard]] const fe::AnyElement<3>& shape_of(base::ElementId e) const {
    return shape::reference_element<3>(set_.mesh.type[e.index()]);
  }

  // The motion of some nodes with a point of the front; false: they rest.
  template <class Motion>
  bool gather(std::size_t point, std::span<const base::NodeId> nodes, Motion& q) const {
    bool moves = false;
    q.setZero(3, static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const auto at = motion_[point].find(nodes[n]);
      if (at != motion_[point].end()) {
        q.col(static_cast<Eigen::Index>(n)) = at->second;
        moves = true;
      }
    }
    return moves;
  }

  void put(Eigen::Index row, std::size_t point, std::size_t column, const base::Vec3& value) {
    const Eigen::Index at =
        columns_.count() * static_cast<Eigen::Index>(point) + static_cast<Eigen::Index>(column);
    for (Eigen::Index c = 0; c < 3; ++c) {
      if (value[c] != 0.0) {
        entries_.emplace_back(row + c, at, value[c]);
      }
    }
  }

  // What the gradients of some functions of an element are contracted with, at each point of its
  // rule (crack_space.10). slopes_at(number of the point, Jacobian): [3, function], of type Values;
  // take(point of the front, auxiliary field's column, [3, function]).
  template <class Values, class SlopesAt, class Take>
  void contract(base::ElementId e, const Values& zero, const SlopesAt& slopes_at,
                const Take& take) const {
    const fe::AnyElement<3>& element = shape_of(e);
    const fe::AnyNodeVectors<3> X = fe::coordinates(element, set_.mesh, e);
    std::vector<std::pair<std::size_t, fe::AnyNodeVectors<3>>> moved;
    for (const std::size_t i : points_of_.at(e)) {
      fe::AnyNodeVectors<3> q;
      if (gather(i, set_.mesh.element_nodes(e), q)) {
        moved.emplace_back(i, q);
      }
    }
    const std::size_t width = columns_.auxiliary_fields.size();
    std::vector<Values> sums(moved.size() * width, zero);
    std::size_t number = 0;
    for (const auto& point : auxiliary_table_->quadrature_rule(element, e)) {
      const ElementMap at = fe::jacobian(element, X, point.r);
      const fe::AnyElement<3>::Values N = element.N(point.r);
      const Values slopes = slopes_at(number, at);
      for (std::size_t j = 0; j < moved.size(); ++j) {
        const Tensor<3> grad = moved[j].second.lazyProduct(at.dNdx);
        const base::Vec3 q = moved[j].second * N;
        for (std::size_t k = 0; k < width; ++k) {
          const FrontAuxiliaryField w =
              auxiliary_table_->at(e, number, columns_.auxiliary_fields[k]);
          const Tensor<3> M = point.weight * at.det * contracted(w, grad, q);
          sums[width * j + k] += M.lazyProduct(slopes);
        }
      }
      ++number;
    }
    for (std::size_t j = 0; j < moved.size(); ++j) {
      for (std::size_t k = 0; k < width; ++k) {
        take(moved[j].first, k,
             set_.conversion_factor(columns_.auxiliary_fields[k]) * sums[width * j + k]);
      }
    }
  }

  void add_element(base::ElementId e) {
    using Values = fe::AnyNodeVectors<3>;
    const std::span<const base::NodeId> nodes = set_.mesh.element_nodes(e);
    contract(
        e, Values(Values::Zero(3, static_cast<Eigen::Index>(nodes.size()))),
        [](std::size_t, const ElementMap& at) -> Values { return at.dNdx.transpose(); },
        [&](std::size_t point, std::size_t column, const Values& values) {
          put_nodes(nodes, point, column, values);
        });
  }

  // The same of other functions.
  void add_others(base::ElementId e, const SupplementaryFunctions& others) {
    const auto count = static_cast<Eigen::Index>(others.of_element(e).size());
    const std::vector<Eigen::MatrixX3d>& table = slope_table(e, others);
    contract(
        e, Eigen::Matrix3Xd(Eigen::Matrix3Xd::Zero(3, count)),
        [&](std::size_t number, const ElementMap& at) -> Eigen::Matrix3Xd {
          const Tensor<3> inverse = at.J.inverse();
          return table[number].lazyProduct(inverse).transpose();
        },
        [&](std::size_t point, std::size_t column, const Eigen::Matrix3Xd& values) {
          put_others(e, point, column, values, others);
        });
  }

  // The auxiliary fields' tractions on a side times the slopes along the motion of some functions.
  // slopes_at(place r): [function, 3]; take as in contract.
  template <class SlopesAt, class Take>
  void contract_side(const MovedFreeSide& side, const geometry::ElementSide& own,
                     const SlopesAt& slopes_at, const Take& take) const {
    for (const std::size_t i : points_of_.at(side.face.element)) {
      fe::SpaceNodes<2> q;
      if (!gather(i, own.nodes, q)) {
        continue;
      }
      for (const auto& point : shape::quadrature<2>(own.domain(), front_degree)) {
        const fe::AnyElement<2>::Values N = own.N(point.r);
        const TurningAxes axes(set_.axes.locate_point(own.X * N, side.on));
        const base::Vec3 area = point.weight * own.area_vector(point.r);
        const base::Vec3 moved = q * N;
        const Eigen::RowVectorXd along = (slopes_at(point.r) * moved).transpose();
        for (std::size_t k = 0; k < columns_.auxiliary_fields.size(); ++k) {
          const std::size_t auxiliary = columns_.auxiliary_fields[k];
          const base::Vec3 t = set_.conversion_factor(auxiliary) *
                               (front_auxiliary_field(auxiliary, axes, set_.body).sigma * area);
          take(i, k, Eigen::Matrix3Xd(-t * along));
        }
      }
    }
  }

  void add_side(const MovedFreeSide& side) {
    const geometry::ElementSide own = model::element_side(set_.mesh, side.face);
    contract_side(
        side, own, [&](const shape::Point<2>& r) { return surface_gradients(own, r); },
        [&](std::size_t point, std::size_t column, const Eigen::Matrix3Xd& values) {
          put_nodes(own.nodes, point, column, values);
        });
  }

  // The motion runs along the side, so that the element's own gradient serves.
  void add_others_on(const MovedFreeSide& side, const SupplementaryFunctions& others) {
    contract_side(
        side, model::element_side(set_.mesh, side.face),
        [&](const shape::Point<2>& r) { return slopes_on(side.face, r, others); },
        [&](std::size_t point, std::size_t column, const Eigen::Matrix3Xd& values) {
          put_others(side.face.element, point, column, values, others);
        });
  }

  // Rows of nodes. [3, node]
  template <class Values>
  void put_nodes(std::span<const base::NodeId> nodes, std::size_t point, std::size_t column,
                 const Values& values) {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      put(3 * static_cast<Eigen::Index>(nodes[n].index()), point, column,
          values.col(static_cast<Eigen::Index>(n)));
    }
  }

  // Rows of an element's other functions. [3, function]
  void put_others(base::ElementId e, std::size_t point, std::size_t column,
                  const Eigen::Matrix3Xd& values, const SupplementaryFunctions& others) {
    const std::span<const std::int32_t> functions = others.of_element(e);
    const std::span<const double> signs = others.signs(e);
    for (std::size_t n = 0; n < functions.size(); ++n) {
      put(3 * static_cast<Eigen::Index>(functions[n]), point, column,
          signs[n] * values.col(static_cast<Eigen::Index>(n)));
    }
  }

  // Slopes of other functions at the points of the rule.
  const std::vector<Eigen::MatrixX3d>& slope_table(base::ElementId e,
                                                   const SupplementaryFunctions& others) {
    const base::ElementType type = set_.mesh.type[e.index()];
    std::vector<Eigen::MatrixX3d>& table = slopes_[{type, fields_.degree.at(e)}];
    if (table.empty()) {
      for (const auto& point : auxiliary_table_->quadrature_rule(shape_of(e), e)) {
        table.push_back(others.slopes(type, point.r));
      }
    }
    return table;
  }

  // What the gradient H of a displacement is contracted with: s(A - q_k,k H_w) + sigma_w (grad q)^T
  // + div sigma_w (x) q, A = H_w grad q (crack_space.10).
  [[nodiscard]] Tensor<3> contracted(const FrontAuxiliaryField& w, const Tensor<3>& grad,
                                     const base::Vec3& moved) const {
    return isotropic_stress(set_.body, w.H * grad - grad.trace() * w.H) +
           w.sigma * grad.transpose() + w.divergence * moved.transpose();
  }

  // Gradients in space of other functions at a place of a side. [function, 3]
  [[nodiscard]] Eigen::MatrixX3d slopes_on(const model::Face& face, const shape::Point<2>& r,
                                           const SupplementaryFunctions& others) const {
    const base::ElementType type = set_.mesh.type[face.element.index()];
    const fe::AnyElement<3>& element = shape_of(face.element);
    const shape::Point<3> at = shape::side_to_solid_point(type, face.side, r);
    const fe::AnyNodeVectors<3> X = fe::coordinates(element, set_.mesh, face.element);
    const Tensor<3> J = X.lazyProduct(element.dN(at));
    const Tensor<3> inverse = J.inverse();
    return others.slopes(type, at).lazyProduct(inverse);
  }

  void add_places(const FacePointForces& on, CrackFaceSide side, Eigen::Index first) {
    const geometry::ElementSide own = model::element_side(set_.mesh, on.face);
    for (const std::size_t i : points_of_.at(on.face.element)) {
      fe::SpaceNodes<2> q;
      if (!gather(i, own.nodes, q)) {
        continue;
      }
      for (std::size_t p = 0; p < on.points.size(); ++p) {
        const fe::AnyElement<2>::Values N = own.N(on.points[p].r.head<2>());
        const FrontCoordinates place = set_.axes.locate_point(own.X * N, side);
        if (!(place.r > 0.0)) {
          continue; // the front itself, a line without an area
        }
        const TurningAxes axes(place);
        for (std::size_t k = 0; k < columns_.auxiliary_fields.size(); ++k) {
          const std::size_t auxiliary = columns_.auxiliary_fields[k];
          put(first + 3 * static_cast<Eigen::Index>(p), i, k,
              -set_.conversion_factor(auxiliary) *
                  (front_auxiliary_field(auxiliary, axes, set_.body).H * (q * N)));
        }
      }
    }
  }

  const FrontSetting& set_;
  const FrontExtensions& fields_;
  AuxiliaryFieldColumns columns_;
  std::shared_ptr<const AuxiliaryFieldTable> auxiliary_table_;
  std::vector<PointMotion> motion_; ///< [point]
  std::map<base::ElementId, std::set<std::size_t>> points_of_;
  RowEntries entries_;
  /// [type, degree of the rule] of other functions
  std::map<std::pair<base::ElementType, int>, std::vector<Eigen::MatrixX3d>> slopes_;
};

} // namespace spricka::crack
