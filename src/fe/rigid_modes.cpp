// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/dense_solve.hpp"
#include "fe/dof_map.hpp"
#include "model/model.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace spricka::fe {

namespace {

// Writes the modes of one piece into its columns.
void add_piece(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes,
               Eigen::Ref<base::Matrix> modes) {
  const Eigen::Index dim = mesh.dim;
  const Eigen::Index rotations = dim * (dim - 1) / 2;
  base::Vec3 centre = base::Vec3::Zero();
  for (const base::NodeId n : nodes) {
    centre += mesh.x[n.index()];
  }
  centre /= static_cast<double>(nodes.size());

  const double unit = 1.0 / std::sqrt(static_cast<double>(nodes.size()));
  for (const base::NodeId n : nodes) {
    const Eigen::Index row = dim * static_cast<Eigen::Index>(n.index());
    const base::Vec3 x = mesh.x[n.index()] - centre;
    for (Eigen::Index c = 0; c < dim; ++c) {
      modes(row + c, c) = unit;
    }
    for (Eigen::Index k = 0; k < rotations; ++k) {
      // The last axes: in the plane only z (fe.28).
      const base::Vec3 axis = base::Vec3::Unit(3 - rotations + k);
      modes.block(row, dim + k, dim, 1) = axis.cross(x).head(dim);
    }
  }
  // About the centre rotations are orthogonal to translations; among themselves Gram-Schmidt makes
  // them so. A rotation that moves no node (all on its axis) stays zero.
  const double size = modes.rightCols(rotations).norm();
  for (Eigen::Index k = dim; k < dim + rotations; ++k) {
    for (Eigen::Index j = dim; j < k; ++j) {
      modes.col(k) -= modes.col(j).dot(modes.col(k)) * modes.col(j);
    }
    const double norm = modes.col(k).norm();
    if (norm > 1e-12 * size) {
      modes.col(k) /= norm;
    } else {
      modes.col(k).setZero();
    }
  }
}

// Along the axis.
void add_ring(const std::vector<base::NodeId>& nodes, Eigen::Ref<base::Vector> mode) {
  const double unit = 1.0 / std::sqrt(static_cast<double>(nodes.size()));
  for (const base::NodeId n : nodes) {
    mode[2 * static_cast<Eigen::Index>(n.index()) + 1] = unit;
  }
}

// What supports and ties forbid, as rows on the modes.
base::Matrix forbidden(const model::Mesh& mesh, const base::Matrix& modes,
                       std::span<const Body> pieces, const ConstraintTransformation& ties,
                       const std::vector<model::FreedomRole>& cls) {
  std::vector<double> values;
  const auto add = [&](const Eigen::RowVectorXd& row) {
    values.insert(values.end(), row.begin(), row.end());
  };
  for (const Body& piece : pieces) {
    for (const base::NodeId n : piece.nodes) {
      for (int c = 0; c < mesh.dim; ++c) {
        const auto freedom = static_cast<std::int32_t>(n.index()) * mesh.dim + c;
        if (model::is_suppressed_or_prescribed(cls[static_cast<std::size_t>(freedom)])) {
          add(modes.row(freedom));
        } else if (const ConstraintTransformation::DependentRow* row = ties.find_row(freedom)) {
          Eigen::RowVectorXd broken = modes.row(freedom);
          for (const FreedomTerm& t : row->terms) {
            broken -= t.coefficient * modes.row(t.freedom);
          }
          add(broken);
        }
      }
    }
  }
  // row by row, which is A^T column by column
  return Eigen::Map<const base::Matrix>(values.data(), modes.cols(),
                                        static_cast<Eigen::Index>(values.size()) / modes.cols())
      .transpose();
}

} // namespace

int rigid_mode_count(const model::Model& model) {
  const int dim = model.mesh.dim;
  return model::is_axisymmetric(model) ? 1 : dim * (dim + 1) / 2;
}

base::Matrix rigid_modes(const model::Model& model, const model::Mesh& mesh,
                         std::span<const Body> pieces) {
  const Eigen::Index count = rigid_mode_count(model);
  base::Matrix modes = base::Matrix::Zero(mesh.dim * static_cast<Eigen::Index>(mesh.node_count()),
                                          count * static_cast<Eigen::Index>(pieces.size()));
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const Eigen::Index first = count * static_cast<Eigen::Index>(p);
    if (count == 1) {
      add_ring(pieces[p].nodes, modes.col(first));
    } else {
      add_piece(mesh, pieces[p].nodes, modes.middleCols(first, count));
    }
  }
  Eigen::Index kept = 0;
  for (Eigen::Index k = 0; k < modes.cols(); ++k) {
    // Rotations that move no node are columns of zeros.
    if ((modes.col(k).array() != 0.0).any()) {
      modes.col(kept++) = modes.col(k);
    }
  }
  return modes.leftCols(kept);
}

base::Matrix free_rigid_modes(const model::Mesh& mesh, const base::Matrix& modes,
                              std::span<const Body> pieces, const ConstraintTransformation& ties,
                              const std::vector<model::FreedomRole>& cls) {
  const Eigen::Index count = modes.cols();
  const base::Matrix A = forbidden(mesh, modes, pieces, ties, cls);
  base::Matrix free(count, 0);
  const auto keep = [&](const base::Vector& v) {
    const double largest = (modes * v).cwiseAbs().maxCoeff();
    // (fe.29).
    if (largest > 0.0 && (A.rows() == 0 || (A * v).cwiseAbs().maxCoeff() <= 1e-9 * largest)) {
      free.conservativeResize(Eigen::NoChange, free.cols() + 1);
      free.rightCols(1) = v;
    }
  };
  const base::Matrix V = A.rows() == 0 ? base::Matrix(base::Matrix::Identity(count, count))
                                       : base::right_singular_vectors(A).vectors;
  for (Eigen::Index k = 0; k < count; ++k) {
    keep(V.col(k));
  }
  return free;
}

} // namespace spricka::fe
