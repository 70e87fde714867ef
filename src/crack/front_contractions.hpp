// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "crack/configurational_forces.hpp"
#include "fe/jacobian.hpp"
#include "mesh/cut/cracked.hpp"

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

/// K as a functional of any displacement, in the plane and in space.
namespace spricka::crack {

/// How nodes move with one point of the front, the mean over its domains per length of the front.
using PointMotion = std::map<base::NodeId, base::Vec3>;

/// Motion by node of one point of a front, the mean of its domains' extensions over the length that
/// belongs to the point; none without a domain.
inline PointMotion domain_mean_node_motions(const mesh::FrontPoint& point,
                                            const std::vector<VirtualExtensionField>& domains) {
  PointMotion motion;
  const double part = 1.0 / (static_cast<double>(domains.size()) * point.weight);
  for (const VirtualExtensionField& field : domains) {
    for (const NodeMotion& moved : field.motion) {
      motion.try_emplace(moved.node, base::Vec3::Zero()).first->second +=
          part * moved.q * moved.along;
    }
  }
  return motion;
}

/// What displacements are contracted with at a point, of several: their gradients with the tensors
/// M, one below the other, and about an axis the strain round it.
template <int dim> struct GradientWeightTensors {
  Eigen::Matrix<double, Eigen::Dynamic, dim> M; ///< [dim * number, dim]
  base::Vector hoop;                            ///< [number]

  explicit GradientWeightTensors(std::size_t count = 0)
      : M(dim * static_cast<Eigen::Index>(count), dim), hoop(static_cast<Eigen::Index>(count)) {}
};

/// The points of a front with how they move nodes, and which of them move an element. `Source` is
/// TipAuxiliaryFields or FrontAuxiliaryFields.
template <class Source> class KFunctionalIntegrand {
public:
  static constexpr int dim = Source::dim;

  /// domains: [point][domain]. Of a half model the other modes than K1 are zero by symmetry.
  KFunctionalIntegrand(const Source& source, const mesh::CrackFront& front,
                       const std::vector<std::vector<VirtualExtensionField>>& domains)
      : source_(source) {
    for (std::size_t mode = 1; mode <= (front.symmetric_half ? 1 : std::size_t{dim}); ++mode) {
      auxiliary_fields_.push_back(mode);
    }
    for (std::size_t i = 0; i < domains.size(); ++i) {
      motion_.push_back(domain_mean_node_motions(front.points[i], domains[i]));
      for (const VirtualExtensionField& field : domains[i]) {
        for (const std::vector<base::ElementId>* elements : {&field.elements, &field.inside}) {
          for (const base::ElementId e : *elements) {
            points_of_[e].insert(i);
          }
        }
      }
    }
  }

  [[nodiscard]] const Source& source() const { return source_; }
  [[nodiscard]] std::size_t point_count() const { return motion_.size(); }
  /// The auxiliary fields of the modes that are not zero, 1 and on.
  [[nodiscard]] const std::vector<std::size_t>& auxiliary_fields() const {
    return auxiliary_fields_;
  }
  /// The points of the front that move an element of their domains, ascending.
  [[nodiscard]] const std::set<std::size_t>& front_points_moving_element(base::ElementId e) const {
    return points_of_.at(e);
  }

  /// Elements in which a displacement is contracted: about an axis also those that a domain moves
  /// as one.
  [[nodiscard]] std::vector<base::ElementId> contracted_elements() const {
    std::vector<base::ElementId> all(source_.strained_elements().begin(),
                                     source_.strained_elements().end());
    if (source_.contracts_rigid_elements()) {
      all.insert(all.end(), source_.rigid_elements().begin(), source_.rigid_elements().end());
    }
    return all;
  }

  /// The motion of some nodes [dim, node] with a point of the front; false: they rest.
  template <class Motion>
  [[nodiscard]] bool gather_node_motions(std::size_t point, std::span<const base::NodeId> nodes,
                                         Motion& q) const {
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

  /// A point of an element with what a displacement is contracted with there.
  struct ContractionPoint {
    shape::Point<dim> r;
    std::size_t number = 0; ///< of the rule's points
    fe::Jacobian<fe::AnyElement<dim>> map;
    fe::NodeValues<fe::AnyElement<dim>> N;
    shape::Point<dim> x;
    /// [place among the points of the front that move the element, auxiliary field] with the weight
    /// of the point, but without the factor that makes K of it
    GradientWeightTensors<dim> tensors;
  };
  /// The points of a front that move an element, and how they move its nodes.
  using MovingPoints = std::vector<std::pair<std::size_t, fe::AnyNodeVectors<dim>>>;
  [[nodiscard]] MovingPoints front_motions_of_element(base::ElementId e) const {
    MovingPoints moved;
    for (const std::size_t i : points_of_.at(e)) {
      fe::AnyNodeVectors<dim> q;
      if (gather_node_motions(i, mesh().element_nodes(e), q)) {
        moved.emplace_back(i, q);
      }
    }
    return moved;
  }
  /// Visits the points of the rule over an element (crack_space.10; in the plane s(u) : A + (H e1)
  /// . (s(v) grad q) with A = (H_v e1) (x) grad q - (div q) H_v is e1 . T grad q of the
  /// interaction).
  template <class Visit>
  void visit_contraction_points(base::ElementId e, const MovingPoints& moved,
                                const Visit& visit) const {
    const fe::AnyElement<dim>& element = shape::reference_element<dim>(mesh().type[e.index()]);
    const fe::AnyNodeVectors<dim> X = fe::element_coordinates(element, mesh(), e);
    const auto& elasticity = source_.elasticity(e);
    ContractionPoint at;
    at.tensors = GradientWeightTensors<dim>(moved.size() * auxiliary_fields_.size());
    std::vector<MotionAtPoint> motions(moved.size());
    for (const auto& point : source_.element_quadrature(e)) {
      at.r = point.r;
      const shape::ShapeFunctionValues<dim>& functions =
          source_.shape_functions(e, at.number, point.r);
      at.map = fe::jacobian_by_derivatives<fe::AnyElement<dim>>(X, functions.dN);
      at.N = functions.N;
      at.x = X * at.N;
      const double weight = point.weight * at.map.det * source_.context().relative_depth(at.x);
      for (std::size_t j = 0; j < moved.size(); ++j) {
        motions[j].gradient = moved[j].second.lazyProduct(at.map.dNdx);
        motions[j].q = moved[j].second * at.N;
        motions[j].hoop_strain = source_.context().hoop_strain(motions[j].q, at.x);
      }
      const AuxiliaryFields<dim> v = source_.auxiliary_fields(e, at.number, at.x, elasticity);
      for (std::size_t j = 0; j < moved.size(); ++j) {
        set_weight_tensors(elasticity, v, motions[j], weight, j, at.tensors);
      }
      visit(at);
      ++at.number;
    }
  }

private:
  using Vector = shape::Point<dim>;

  [[nodiscard]] const model::Mesh& mesh() const { return source_.context().mesh; }
  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

  // How a point of the front moves a point of an element.
  struct MotionAtPoint {
    Vector q;
    Tensor<dim> gradient;
    double hoop_strain = 0.0; ///< of q, round the axis
  };

  // What the gradient H of a displacement is contracted with: s(A - (div q) H_v) + sigma_v (grad
  // q)^T + div sigma_v (x) q, A = H_v grad q, with the components round an axis (crack.37), of all
  // auxiliary fields at once; those of the modes come first. D is symmetric, so s(u) : A = H_u :
  // s(A).
  template <class Elasticity>
  void set_weight_tensors(const Elasticity& elasticity, const AuxiliaryFields<dim>& v,
                          const MotionAtPoint& motion, double weight, std::size_t place,
                          GradientWeightTensors<dim>& tensors) const {
    const Tensor<dim>& grad = motion.gradient;
    const double round = motion.hoop_strain;
    const double div = grad.trace() + round;
    GradientStressStates<dim> A;
    for (std::size_t j = 0; j < dim; ++j) {
      for (std::size_t i = 0; i < dim; ++i) {
        A.H[j][i] = -div * v.H[j][i];
        for (std::size_t m = 0; m < dim; ++m) {
          A.H[j][i] += grad(index(m), index(j)) * v.H[m][i];
        }
      }
    }
    A.hoop = (round - div) * v.hoop;
    elasticity.set_stress(A);
    const Eigen::Index count = index(auxiliary_fields_.size());
    const Eigen::Index first = count * index(place);
    for (std::size_t j = 0; j < dim; ++j) {
      for (std::size_t i = 0; i < dim; ++i) {
        OfFields<dim> M = A.sigma[j][i] + motion.q[index(j)] * v.divergence[i];
        for (std::size_t m = 0; m < dim; ++m) {
          M += grad(index(j), index(m)) * v.sigma[m][i];
        }
        M *= weight;
        for (Eigen::Index k = 0; k < count; ++k) {
          tensors.M(dim * (first + k) + index(i), index(j)) = M[k];
        }
      }
    }
    tensors.hoop.segment(first, count) =
        (weight * (A.sigma_hoop + round * v.sigma_hoop)).matrix().head(count);
  }

  const Source& source_;
  std::vector<std::size_t> auxiliary_fields_;
  std::vector<PointMotion> motion_; ///< [point]
  std::map<base::ElementId, std::set<std::size_t>> points_of_;
};

} // namespace spricka::crack
