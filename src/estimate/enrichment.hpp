// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "crack/tip_intensity.hpp"
#include "estimate/edges.hpp"
#include "estimate/mode_kernel.hpp"
#include "model/forward.hpp"

#include <deque>
#include <span>
#include <string>
#include <vector>

/// The cubic modes of a whole mesh and their stiffness, element by element (manual, estimate.5 to
/// 8). Nothing is assembled: products with element matrices are all that the estimate needs.
namespace spricka::estimate {

/// Why a model's mesh cannot be enriched ("it has linear elements"); empty: it can.
std::string enrichment_obstacle(const model::Model& model, const model::Mesh& mesh);

/// What an enrichment keeps of a mesh that can be enriched [bytes].
double enrichment_memory(const model::Mesh& mesh);

/// Matrices of the modes of host elements, kept from one crack length to the next. What an
/// element's depend on is kept along: where it is another they are made anew.
class ModeMatrixCache {
public:
  struct CachedModeMatrix {
    base::ElementType type{};
    std::vector<double> of;
    std::vector<double> numbers;
  };
  /// The entry of a host element, made empty at first use; it keeps its place while others are
  /// made.
  CachedModeMatrix& at(base::ElementId host);

private:
  std::deque<CachedModeMatrix> entries_; ///< [host element]
};

/// Where an enrichment finds and leaves matrices. `host` [element]: the host element that one is,
/// invalid: none.
struct ModeMatrixLookup {
  ModeMatrixCache* memory = nullptr;
  const std::vector<base::ElementId>* host = nullptr;

  /// The host element of an element; invalid where there is no memory or the element has no host.
  [[nodiscard]] base::ElementId host_element(base::ElementId e) const {
    return memory == nullptr ? base::ElementId() : (*host)[e.index()];
  }
};

/// Mode freedoms: 2 e + c of edge e of the edge table, then those inside the elements. c is the
/// direction: x and y, or outer normal and tangent on the edges that are `framed`.
class CubicEnrichment {
public:
  /// framed [edge]: edges of one element only. Model, mesh and memory must outlive the enrichment;
  /// one enrichment at a time may look into a memory.
  CubicEnrichment(const model::Model& model, const model::Mesh& mesh, EdgeTable edges,
                  std::vector<bool> framed, ModeMatrixLookup kept = {});

  [[nodiscard]] const model::Model& model() const { return model_; }
  [[nodiscard]] const model::Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const EdgeTable& edges() const { return edges_; }
  /// Whether the modes of an edge stand along its normal and tangent, not along x and y.
  [[nodiscard]] bool has_edge_frame(std::size_t edge) const { return framed_[edge]; }
  [[nodiscard]] Eigen::Index freedoms() const { return freedoms_; }
  /// Mode freedoms of an element, in the order of its kernels.
  [[nodiscard]] std::span<const std::int32_t> element_freedoms(base::ElementId e) const {
    return {freedom_.data() + first_[e.index()], freedom_.data() + first_[e.index() + 1]};
  }
  /// Signs of an element's side modes by the direction of its edges, and which of them are framed.
  [[nodiscard]] SideModeFrames element_side_frames(base::ElementId e) const;

  /// Stiffness of the modes times a vector, y = K_ee x, element by element. [freedoms]
  [[nodiscard]] base::Vector stiffness_product(const base::Vector& x) const;
  /// Diagonal blocks of K_ee: for each direction pair 2 i, 2 i + 1 the entries (0,0), (1,0), (1,1).
  /// [freedoms / 2]
  [[nodiscard]] const std::vector<base::Vec3>& diagonal_blocks() const { return diagonal_; }
  /// r - K_ep u, by columns. u [dim * node, k], r [freedoms, k]
  void subtract_nodal_coupling(const base::Matrix& u, base::Matrix& r) const;
  /// The functional of some points on the modes. [freedoms, 2]
  [[nodiscard]] base::Matrix
  mode_functional(const std::vector<crack::KFunctionalQuadraturePoint>& points) const;

private:
  /// Of an element: from the memory, or made anew there or at next_own, which goes on.
  void add_matrix(base::ElementId e, const ModeMatrixLookup& kept, double*& next_own);
  void sum_diagonal();
  template <shape::PlaneShape S, int columns>
  void take_columns(base::ElementId e, Eigen::Index first, const base::Matrix& u,
                    base::Matrix& r) const;

  const model::Model& model_;
  const model::Mesh& mesh_;
  EdgeTable edges_;
  std::vector<bool> framed_;
  Eigen::Index freedoms_ = 0;
  std::vector<std::size_t> first_;    ///< [element + 1] into freedom_
  std::vector<std::int32_t> freedom_; ///< of all elements
  std::vector<double> own_;           ///< matrices of elements that are not kept
  std::vector<const double*> matrix_; ///< [element] ee, then ep, here or in the memory
  std::vector<base::Vec3> diagonal_;
};

} // namespace spricka::estimate
