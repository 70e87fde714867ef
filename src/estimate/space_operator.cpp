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
constexpr int rule_degree(base::ElementType type) {
  return type == base::ElementType::tet10 ? 5 : 7;
}

/// The functions of an element type, nodes before modes, at the points of its rule.
struct FunctionTable {
  Eigen::Index nodes = 0, modes = 0;
  std::vector<shape::QuadraturePoint<3>> rule;
  /// [function, 3 * point + reference coordinate]
  base::Matrix slopes;

  [[nodiscard]] Eigen::Index functions() const { return nodes + modes; }
  [[nodiscard]] Eigen::Index points() const { return static_cast<Eigen::Index>(rule.size()); }

  static const FunctionTable& of(base::ElementType type) {
    static const FunctionTable tet = make(base::ElementType::tet10);
    static const FunctionTable penta = make(base::ElementType::pentac15);
    static const FunctionTable hexa = make(base::ElementType::hexec20);
    return type == base::ElementType::tet10      ? tet
           : type == base::ElementType::pentac15 ? penta
                                                 : hexa;
  }

private:
  static FunctionTable make(base::ElementType type) {
    FunctionTable table;
    const fe::AnyElement<3>& element = shape::reference_element<3>(type);
    const auto rule = shape::quadrature<3>(element.domain, rule_degree(type));
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

// Jacobians of a block at the points of its rule.
void add_geometry(const model::Model& model, const model::Mesh& mesh, ElementBlock& block) {
  const FunctionTable& table = FunctionTable::of(mesh.type[block.elements.front().index()]);
  const auto width = static_cast<std::size_t>(lanes);
  const auto points = static_cast<std::size_t>(table.points());
  block.lambda.assign(width, 0.0);
  block.mu.assign(width, 0.0);
  block.volume.assign(width * points, 0.0);
  block.inverse.assign(9 * width * points, 0.0);
  for (std::size_t b = 0; b < block.elements.size(); ++b) {
    const base::ElementId e = block.elements[b];
    const fe::ConstitutiveLaw law = fe::constitutive_law(model, mesh, e);
    block.lambda[b] = law.lambda;
    block.mu[b] = law.mu;
    const std::span<const base::NodeId> nodes = mesh.element_nodes(e);
    Eigen::Matrix3Xd X(3, table.nodes);
    for (Eigen::Index n = 0; n < table.nodes; ++n) {
      X.col(n) = mesh.x[nodes[static_cast<std::size_t>(n)].index()];
    }
    const Eigen::Matrix3Xd J = X * table.slopes.topRows(table.nodes);
    for (std::size_t p = 0; p < points; ++p) {
      const Eigen::Matrix3d at = J.middleCols<3>(3 * static_cast<Eigen::Index>(p));
      const Eigen::Matrix3d inverse = at.inverse();
      block.volume[width * p + b] = table.rule[p].weight * at.determinant();
      for (std::size_t k = 0; k < 9; ++k) {
        block.inverse[width * (9 * p + k) + b] =
            inverse(static_cast<Eigen::Index>(k / 3), static_cast<Eigen::Index>(k % 3));
      }
    }
  }
}

/// One component after the other: a number for each lane.
using Lanes = Eigen::Array<double, lanes, 1>;
using LanesIn = Eigen::Map<const Lanes>;
using LanesOut = Eigen::Map<Lanes>;

// Of gradients G = dU/dr in reference coordinates the forces weight det D(G J^-1) J^-T, in place.
// [component][lane] by [point][coordinate]
void gradients_to_forces(const ElementBlock& block, base::Matrix& G) {
  const LanesIn lambda(block.lambda.data());
  const LanesIn mu(block.mu.data());
  std::array<Lanes, 9> H; // [component, coordinate]
  for (Eigen::Index p = 0; p < G.cols() / 3; ++p) {
    const auto at = [&](std::size_t component, std::size_t coordinate) {
      return LanesOut(G.data() + (3 * p + static_cast<Eigen::Index>(coordinate)) * G.rows() +
                      static_cast<Eigen::Index>(component) * lanes);
    };
    const auto inverse = [&](std::size_t reference, std::size_t coordinate) {
      return LanesIn(block.inverse.data() +
                     (9 * p + static_cast<Eigen::Index>(3 * reference + coordinate)) * lanes);
    };
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        H[3 * i + k] =
            at(i, 0) * inverse(0, k) + at(i, 1) * inverse(1, k) + at(i, 2) * inverse(2, k);
      }
    }
    const LanesIn volume(block.volume.data() + p * lanes);
    const Lanes m = mu * volume;
    const Lanes pressure = lambda * volume * (H[0] + H[4] + H[8]);
    const std::array<Lanes, 6> s{pressure + 2.0 * m * H[0], m * (H[1] + H[3]),
                                 m * (H[2] + H[6]),         pressure + 2.0 * m * H[4],
                                 m * (H[5] + H[7]),         pressure + 2.0 * m * H[8]};
    for (std::size_t j = 0; j < 3; ++j) {
      at(0, j) = s[0] * inverse(j, 0) + s[1] * inverse(j, 1) + s[2] * inverse(j, 2);
      at(1, j) = s[1] * inverse(j, 0) + s[3] * inverse(j, 1) + s[4] * inverse(j, 2);
      at(2, j) = s[2] * inverse(j, 0) + s[4] * inverse(j, 1) + s[5] * inverse(j, 2);
    }
  }
}

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
      add_geometry(model, mesh, blocks_[i]);
    }
  });
}

void SolidModeStiffness::add_forces(const NodalAndModeDisplacements& motion,
                                    const NodalAndModeForces& forces) const {
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
        make_forces(blocks_[first + i], motion, forces, Z, G, made[i]);
      }
    });
    for (std::size_t i = 0; i < count; ++i) {
      const ElementBlock& block = blocks_[first + i];
      const FunctionTable& table = FunctionTable::of(mesh_.type[block.elements.front().index()]);
      BlockVectors(mesh_, numbers_, block, table)
          .scatter(made[i], run_of(table, forces.nodes != nullptr, forces.modes != nullptr),
                   forces);
    }
  }
}

// The forces F of one block [3 * lane + component, function]; Z, G: workspace.
void SolidModeStiffness::make_forces(const ElementBlock& block,
                                     const NodalAndModeDisplacements& motion,
                                     const NodalAndModeForces& wanted, base::Matrix& Z,
                                     base::Matrix& G, base::Matrix& F) const {
  const FunctionTable& table = FunctionTable::of(mesh_.type[block.elements.front().index()]);
  const FunctionRange from = run_of(table, motion.nodes != nullptr, motion.modes != nullptr);
  const FunctionRange to = run_of(table, wanted.nodes != nullptr, wanted.modes != nullptr);
  const int rows = 3 * static_cast<int>(lanes);
  const int columns = 3 * static_cast<int>(table.points());
  BlockVectors(mesh_, numbers_, block, table).gather(motion, from, Z);
  G.resize(rows, columns);
  blas::gemm({.m = rows, .n = columns, .k = static_cast<int>(from.count)}, blas::as_matrix_block(Z),
             slopes_of(table, from), blas::as_matrix_block(G));
  gradients_to_forces(block, G);
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
  const FunctionTable& table = FunctionTable::of(mesh_.type[block.elements.front().index()]);
  for (Eigen::Index m = 0; m < table.modes; ++m) {
    std::array<Lanes, 6> sum; // of volume times slopes' products
    sum.fill(Lanes::Zero());
    for (Eigen::Index p = 0; p < table.points(); ++p) {
      const auto inverse = [&](Eigen::Index j, std::size_t c) {
        return LanesIn(block.inverse.data() +
                       (9 * p + 3 * j + static_cast<Eigen::Index>(c)) * lanes);
      };
      const auto own = table.slopes.block<1, 3>(table.nodes + m, 3 * p);
      std::array<Lanes, 3> slope;
      for (std::size_t c = 0; c < 3; ++c) {
        slope[c] = own[0] * inverse(0, c) + own[1] * inverse(1, c) + own[2] * inverse(2, c);
      }
      const LanesIn volume(block.volume.data() + p * lanes);
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
