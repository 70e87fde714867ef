// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "mesh/import/nastran_bulk.hpp"

#include <Eigen/Core>
#include <map>
#include <string>

namespace spricka::mesh {

/// The coordinate systems of bulk data (CORD2R, CORD2C, CORD2S), each defined in another one.
class NastranSystems {
public:
  explicit NastranSystems(const NastranBulk& bulk) : bulk_(bulk) {}

  /// A point of a system in the basic one, which is 0; angles of the point are in degrees.
  /// Otherwise `trouble` says what is wrong, without the number of the system.
  bool find_basic(base::Label system, const base::Vec3& at, base::Vec3& basic,
                  std::string& trouble);

private:
  struct BasicFrame {
    base::Vec3 origin;
    Eigen::Matrix3d axes; ///< columns, in the basic system
    std::string trouble;
  };
  const BasicFrame& frame(base::Label label);

  const NastranBulk& bulk_;
  std::map<base::Label, BasicFrame> frames_;
};

} // namespace spricka::mesh
