// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dof_map.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <cmath>

namespace spricka::fe {

base::Matrix rigid_modes(const model::Mesh& mesh, const std::vector<base::NodeId>& nodes) {
  const Eigen::Index dim = mesh.dim;
  const Eigen::Index rotations = dim == 2 ? 1 : 3;
  base::Matrix modes =
      base::Matrix::Zero(dim * static_cast<Eigen::Index>(mesh.node_count()), dim + rotations);
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
      // In the plane the only axis is z.
      const base::Vec3 axis = base::Vec3::Unit(dim == 2 ? 2 : k);
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
  return modes;
}

base::Matrix free_modes(const model::Mesh& mesh, const base::Matrix& modes,
                        const std::vector<base::NodeId>& nodes,
                        const std::vector<model::FreedomClass>& cls) {
  const Eigen::Index dim = mesh.dim;
  std::vector<Eigen::Index> held;
  for (const base::NodeId n : nodes) {
    for (Eigen::Index c = 0; c < dim; ++c) {
      const Eigen::Index freedom = dim * static_cast<Eigen::Index>(n.index()) + c;
      const model::FreedomClass k = cls[static_cast<std::size_t>(freedom)];
      if (k == model::FreedomClass::suppressed || k == model::FreedomClass::prescribed) {
        held.push_back(freedom);
      }
    }
  }
  const Eigen::Index count = modes.cols();
  if (held.empty()) {
    return base::Matrix::Identity(count, count);
  }
  base::Matrix A(static_cast<Eigen::Index>(held.size()), count);
  for (std::size_t i = 0; i < held.size(); ++i) {
    A.row(static_cast<Eigen::Index>(i)) = modes.row(held[i]);
  }
  const Eigen::JacobiSVD<base::Matrix> svd(A, Eigen::ComputeFullV);

  base::Matrix free(count, 0);
  for (Eigen::Index k = 0; k < count; ++k) {
    const base::Vector v = svd.matrixV().col(k);
    const double largest = (modes * v).cwiseAbs().maxCoeff();
    if (largest > 0.0 && (A * v).cwiseAbs().maxCoeff() <= 1e-9 * largest) {
      free.conservativeResize(Eigen::NoChange, free.cols() + 1);
      free.rightCols(1) = v;
    }
  }
  return free;
}

} // namespace spricka::fe
