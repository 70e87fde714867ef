// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimate/space_operator.hpp"

#include "base/parallel.hpp"
#include "estimate/space_modes.hpp"
#include "fe/element.hpp"
#include "model/model.hpp"
#include "shape/quadrature.hpp"
#include "solve/blas.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <Eigen/LU>

namespace spricka::estimate {

namespace {

namespace blas = solve::blas;

constexpr Eigen::Index lanes = operator_lanes;

// Of straight tetrahedra exact; quarter points make rational functions of the others.
constexpr int rule_degree(base::ElementType type, ModeStiffnessRule rule) {
  return type == base::ElementType::tet10 || rule == ModeStiffnessRule::reduced ? 5 : 7;
}
bool has_reduced_rule(base::ElementType type) {
  return rule_degree(type, ModeStiffnessRule::reduced) < rule_degree(type, ModeStiffnessRule::full);
}

/// The functions of an element type, nodes before modes, at the points of its rule.
struct FunctionTable {
  Eigen::Index nodes = 0, modes = 0;
  std::vector<shape::QuadraturePoint<3>> rule;
  /// [function, 3 * point + reference coordinate]
  base::Matrix slopes;

  [[nodiscard]] Eigen::Index functions() const { return nodes + modes; }
  [[nodiscard]] Eigen::Index points() const { return static_cast<Eigen::Index>(rule.size()); }

  static const FunctionTable& of(base::ElementType type, ModeStiffnessRule rule) {
    using base::ElementType;
    static const FunctionTable tet = make(ElementType::tet10, ModeStiffnessRule::full);
    static const FunctionTable penta = make(ElementType::pentac15, ModeStiffnessRule::full);
    static const FunctionTable hexa = make(ElementType::hexec20, ModeStiffnessRule::full);
    static const FunctionTable few_penta = make(ElementType::pentac15, ModeStiffnessRule::reduced);
    static const FunctionTable few_hexa = make(ElementType::hexec20, ModeStiffnessRule::reduced);
    const bool full = rule == ModeStiffnessRule::full;
    return type == ElementType::tet10      ? tet
           : type == ElementType::pentac15 ? (full ? penta : few_penta)
                                           : (full ? hexa : few_hexa);
  }

private:
  static FunctionTable make(base::ElementType type, ModeStiffnessRule degree) {
    FunctionTable table;
    const fe::AnyElement<3>& element = shape::reference_element<3>(type);
    const auto rule = shape::quadrature<3>(element.domain, rule_degree(type, degree));
    table.rule.assign(rule.begin(), rule.end());
    const SolidModes& modes = SolidModes::for_type(type);
    table.nodes = element.nodes;
    table.modes = static_cast<Eigen::Index>(modes.modes().size());
    table.slopes.resize(table.functions(), 3 * table.points());
    for (Eigen::Index p = 0; p < table.points(); ++p) {
      const shape::Point<3>& r = table.rule[static_cast<std::size_t>(p)].r;
      table.slopes.block(0, 3 * p, table.nodes, 3) = element.dN(r);
      table.slopes.block(table.nodes, 3 * p, table.modes, 3) = modes.dpsi(r);
    }
    return table;
  }
};

const FunctionTable& table_of(const model::Mesh& mesh, ModeStiffnessRule rule,
                              const ElementBlock& block) {
  return FunctionTable::of(mesh.type[block.elements.front().index()], rule);
}

/// Functions that take part: a run of those of a table.
struct FunctionRange {
  Eigen::Index first = 0, count = 0;
};

FunctionRange run_of(const FunctionTable& table, bool nodes, bool modes) {
  const Eigen::Index first = nodes ? 0 : table.nodes;
  return {first, (modes ? table.functions() : table.nodes) - first};
}

blas::ConstMatrixBlock slopes_of(const FunctionTable& table, const FunctionRange& run) {
  return {table.slopes.data() + run.first, static_cast<int>(table.functions())};
}

void set_constants(const model::Model& model, const model::Mesh& mesh, ElementBlock& block) {
  block.lambda.assign(static_cast<std::size_t>(lanes), 0.0);
  block.mu = block.lambda;
  for (std::size_t b = 0; b < block.elements.size(); ++b) {
    const fe::ConstitutiveLaw law = fe::constitutive_law(model, mesh, block.elements[b]);
    block.lambda[b] = law.lambda;
    block.mu[b] = law.mu;
  }
}

// Jacobians of a block at the points of a rule.
BlockGeometry geometry_of(const model::Mesh& mesh, const ElementBlock& block,
                          ModeStiffnessRule rule) {
  const FunctionTable& table = table_of(mesh, rule, block);
  const auto width = static_cast<std::size_t>(lanes);
  const auto points = static_cast<std::size_t>(table.points());
  BlockGeometry geometry;
  geometry.volume.assign(width * points, 0.0);
  geometry.inverse.assign(9 * width * points, 0.0);
  for (std::size_t b = 0; b < block.elements.size(); ++b) {
    const std::span<const base::NodeId> nodes = mesh.element_nodes(block.elements[b]);
    Eigen::Matrix3Xd X(3, table.nodes);
    for (Eigen::Index n = 0; n < table.nodes; ++n) {
      X.col(n) = mesh.x[nodes[static_cast<std::size_t>(n)].index()];
    }
    const Eigen::Matrix3Xd J = X * table.slopes.topRows(table.nodes);
    for (std::size_t p = 0; p < points; ++p) {
      const Eigen::Matrix3d at = J.middleCols<3>(3 * static_cast<Eigen::Index>(p));
      const Eigen::Matrix3d inverse = at.inverse();
      geometry.volume[width * p + b] = table.rule[p].weight * at.determinant();
      for (std::size_t k = 0; k < 9; ++k) {
        geometry.inverse[width * (9 * p + k) + b] =
            inverse(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3));
      }
    }
  }
  return geometry;
}

/// One component after the other: a number for each lane.
using Lanes = Eigen::Array<double, lanes, 1>;
using LanesIn = Eigen::Map<const Lanes>;

// Displacements of an element's functions and forces on them: [3 * lane + component, function].
class BlockVectors {
public:
  BlockVectors(const model::Mesh& mesh, const SolidModeNumbers& numbers, const ElementBlock& block,
               const FunctionTable& table)
      : mesh_(mesh), numbers_(numbers), block_(block), table_(table) {}

  void gather(const SolidModeStiffness::NodalAndModeDisplacements& motion, const FunctionRange& run,
              base::Matrix& Z) const {
    Z.setZero(3 * lanes, run.count);
    for_each(run, [&](Eigen::Index b, Eigen::Index column, const FunctionFreedom& at) {
      const base::Vector& from = at.mode ? *motion.modes : *motion.nodes;
      for (Eigen::Index c = 0; c < 3; ++c) {
        Z(c * lanes + b, column) = at.sign * from[at.freedom + c];
      }
    });
  }

  void scatter(const base::Matrix& F, const FunctionRange& run,
               const SolidModeStiffness::NodalAndModeForces& forces) const {
    for_each(run, [&](Eigen::Index b, Eigen::Index column, const FunctionFreedom& at) {
      base::Vector& to = at.mode ? *forces.modes : *forces.nodes;
      for (Eigen::Index c = 0; c < 3; ++c) {
        to[at.freedom + c] += at.sign * F(c * lanes + b, column);
      }
    });
  }

private:
  struct FunctionFreedom {
    bool mode = false;
    Eigen::Index freedom = 0; ///< the first of three
    double sign = 1.0;
  };

  template <class F> void for_each(const FunctionRange& run, F&& f) const {
    for (std::size_t b = 0; b < block_.elements.size(); ++b) {
      const base::ElementId e = block_.elements[b];
      const auto lane = static_cast<Eigen::Index>(b);
      const std::span<const base::NodeId> nodes = mesh_.element_nodes(e);
      for (Eigen::Index n = run.first; n < std::min(table_.nodes, run.first + run.count); ++n) {
        const auto node = static_cast<Eigen::Index>(nodes[static_cast<std::size_t>(n)].index());
        f(lane, n - run.first, FunctionFreedom{false, 3 * node, 1.0});
      }
      const std::size_t first = numbers_.first[e.index()];
      for (Eigen::Index m = 0; m < table_.modes && run.first + run.count > table_.nodes; ++m) {
        const std::size_t at = first + static_cast<std::size_t>(m);
        f(lane, table_.nodes + m - run.first,
          FunctionFreedom{true, 3 * static_cast<Eigen::Index>(numbers_.mode[at]),
                          numbers_.sign[at]});
      }
    }
  }

  const model::Mesh& mesh_;
  const SolidModeNumbers& numbers_;
  const ElementBlock& block_;
  const FunctionTable& table_;
};

} // namespace

SolidModeStiffness::SolidModeStiffness(const model::Model& model, const model::Mesh& mesh,
                                       SolidModeNumbers numbers)
    : mesh_(mesh), numbers_(std::move(numbers)) {
  blas::force_single_blas_thread();
  std::map<base::ElementType, ElementBlock> open;
  const auto close = [&](ElementBlock& block) {
    blocks_.push_back(std::move(block));
    block = ElementBlock();
  };
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    ElementBlock& block = open[mesh.type[e]];
    block.elements.emplace_back(e);
    if (block.elements.size() == static_cast<std::size_t>(lanes)) {
      close(block);
    }
  }
  for (auto& [type, block] : open) {
    if (!block.elements.empty()) {
      close(block);
    }
  }
  base::parallel_for_ranges(blocks_.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      ElementBlock& block = blocks_[i];
      set_constants(model, mesh, block);
      block.full = geometry_of(mesh, block, ModeStiffnessRule::full);
      if (has_reduced_rule(mesh.type[block.elements.front().index()])) {
        block.reduced = geometry_of(mesh, block, ModeStiffnessRule::reduced);
      }
    }
  });
}

void SolidModeStiffness::add_forces(const NodalAndModeDisplacements& motion,
                                    const NodalAndModeForces& forces,
                                    ModeStiffnessRule rule) const {
  // Forces of several blocks side by side, then added in the order of the blocks.
  constexpr std::size_t batch = 512;
  constexpr std::size_t portion = 8;
  std::vector<base::Matrix> made(std::min(batch, blocks_.size()));
  for (std::size_t first = 0; first < blocks_.size(); first += batch) {
    const std::size_t count = std::min(batch, blocks_.size() - first);
    base::parallel_for_ranges(count, portion, [&](std::size_t begin, std::size_t end) {
      base::Matrix Z;
      base::Matrix G;
      for (std::size_t i = begin; i < end; ++i) {
        make_forces(blocks_[first + i], {motion, forces, rule}, Z, G, made[i]);
      }
    });
    for (std::size_t i = 0; i < count; ++i) {
      const ElementBlock& block = blocks_[first + i];
      const FunctionTable& table = table_of(mesh_, ModeStiffnessRule::full, block);
      BlockVectors(mesh_, numbers_, block, table)
          .scatter(made[i], run_of(table, forces.nodes != nullptr, forces.modes != nullptr),
                   forces);
    }
  }
}

// The forces F of one block [3 * lane + component, function]; Z, G: workspace.
void SolidModeStiffness::make_forces(const ElementBlock& block, const ForceRequest& asked,
                                     base::Matrix& Z, base::Matrix& G, base::Matrix& F) const {
  const FunctionTable& table = table_of(mesh_, asked.rule, block);
  const FunctionRange from =
      run_of(table, asked.motion.nodes != nullptr, asked.motion.modes != nullptr);
  const FunctionRange to =
      run_of(table, asked.wanted.nodes != nullptr, asked.wanted.modes != nullptr);
  const int rows = 3 * static_cast<int>(lanes);
  const int columns = 3 * static_cast<int>(table.points());
  BlockVectors(mesh_, numbers_, block, table).gather(asked.motion, from, Z);
  G.resize(rows, columns);
  blas::gemm({.m = rows, .n = columns, .k = static_cast<int>(from.count)}, blas::as_matrix_block(Z),
             slopes_of(table, from), blas::as_matrix_block(G));
  gradients_to_forces(block,
                      asked.rule == ModeStiffnessRule::full || block.reduced.volume.empty()
                          ? block.full
                          : block.reduced,
                      G);
  F.resize(rows, to.count);
  blas::gemm({.m = rows,
              .n = static_cast<int>(to.count),
              .k = columns,
              .b = blas::Transposition::transposed},
             blas::as_matrix_block(G), slopes_of(table, to), blas::as_matrix_block(F));
}

std::vector<Eigen::Matrix3d> SolidModeStiffness::diagonal_blocks() const {
  std::size_t modes = 0;
  for (const std::int32_t mode : numbers_.mode) {
    modes = std::max(modes, static_cast<std::size_t>(mode) + 1);
  }
  std::vector<Eigen::Matrix3d> diagonal(modes, Eigen::Matrix3d::Zero());
  for (const ElementBlock& block : blocks_) {
    add_diagonal(block, diagonal);
  }
  return diagonal;
}

void SolidModeStiffness::add_diagonal(const ElementBlock& block,
                                      std::vector<Eigen::Matrix3d>& diagonal) const {
  const FunctionTable& table = table_of(mesh_, ModeStiffnessRule::full, block);
  for (Eigen::Index m = 0; m < table.modes; ++m) {
    std::array<Lanes, 6> sum; // of volume times slopes' products
    sum.fill(Lanes::Zero());
    for (Eigen::Index p = 0; p < table.points(); ++p) {
      const auto inverse = [&](Eigen::Index j, std::size_t c) {
        return LanesIn(block.full.inverse.data() +
                       (9 * p + 3 * j + static_cast<Eigen::Index>(c)) * lanes);
      };
      const auto own = table.slopes.block<1, 3>(table.nodes + m, 3 * p);
      std::array<Lanes, 3> slope;
      for (std::size_t c = 0; c < 3; ++c) {
        slope[c] = own[0] * inverse(0, c) + own[1] * inverse(1, c) + own[2] * inverse(2, c);
      }
      const LanesIn volume(block.full.volume.data() + p * lanes);
      std::size_t k = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = i; j < 3; ++j) {
          sum[k++] += volume * slope[i] * slope[j];
        }
      }
    }
    for (std::size_t b = 0; b < block.elements.size(); ++b) {
      const auto at = static_cast<Eigen::Index>(b);
      Eigen::Matrix3d own;
      own << sum[0][at], sum[1][at], sum[2][at], sum[1][at], sum[3][at], sum[4][at], sum[2][at],
          sum[4][at], sum[5][at];
      const std::size_t first = numbers_.first[block.elements[b].index()];
      diagonal[static_cast<std::size_t>(numbers_.mode[first + static_cast<std::size_t>(m)])] +=
          (block.lambda[b] + block.mu[b]) * own +
          block.mu[b] * own.trace() * Eigen::Matrix3d::Identity();
    }
  }
}

} // namespace spricka::estimate
