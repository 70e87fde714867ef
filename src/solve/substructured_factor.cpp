// SPDX-License-Identifier: GPL-3.0-or-later
#include "solve/substructured_factor.hpp"
#include "base/index.hpp"

#include <cassert>
#include <utility>

namespace spricka::solve {

using base::at;
using base::index;

namespace {

SparseRightHandSides columns_from(const SparseRightHandSides& F, std::int64_t begin,
                                  std::int64_t end) {
  SparseRightHandSides out;
  const std::int64_t first = F.start[at(begin)];
  out.row.assign(F.row.begin() + first, F.row.begin() + F.start[at(end)]);
  out.value.assign(F.value.begin() + first, F.value.begin() + F.start[at(end)]);
  for (std::int64_t k = begin; k < end; ++k) {
    out.start.push_back(F.start[at(k + 1)] - first);
  }
  return out;
}

base::Matrix as_dense(const SparseRightHandSides& F, std::int64_t rows) {
  base::Matrix out = base::Matrix::Zero(rows, F.count());
  for (std::int64_t k = 0; k < F.count(); ++k) {
    for (std::int64_t p = F.start[at(k)]; p < F.start[at(k + 1)]; ++p) {
      out(F.row[at(p)], k) += F.value[at(p)];
    }
  }
  return out;
}

// F^T u [columns of F, columns of u].
base::Matrix sparse_product(const SparseRightHandSides& F, const base::Matrix& u) {
  base::Matrix out = base::Matrix::Zero(F.count(), u.cols());
  for (std::int64_t k = 0; k < F.count(); ++k) {
    for (std::int64_t p = F.start[at(k)]; p < F.start[at(k + 1)]; ++p) {
      out.row(k) += F.value[at(p)] * u.row(F.row[at(p)]);
    }
  }
  return out;
}

// Compliance by one factor. What the lasting columns have with the others is asked of solutions for
// these, so that nothing of the lasting ones needs to be kept but their own compliance.
RowCompliance compliance_of(const Condensation& factor, const SparseRightHandSides& F,
                            std::int64_t lasting, LastingColumns* kept) {
  if (lasting == 0) {
    return factor.compliance_with_externals_held(F);
  }
  RowCompliance out;
  SparseRightHandSides first = columns_from(F, 0, lasting);
  if (kept->F != first) {
    kept->own = factor.compliance_with_externals_held(first);
    out.flops += kept->own.flops;
    kept->F = std::move(first);
  }
  const SparseRightHandSides others = columns_from(F, lasting, F.count());
  const RowCompliance moving = factor.compliance_with_externals_held(others);
  out.flops += moving.flops;
  const auto externals = kept->own.condensed.rows();
  const base::Matrix u = factor.recover(base::Matrix::Zero(externals, others.count()),
                                        as_dense(others, factor.size()));
  const base::Matrix between = sparse_product(kept->F, u);
  out.W.resize(F.count(), F.count());
  out.W << kept->own.W, between, between.transpose(), moving.W;
  out.condensed.resize(externals, F.count());
  out.condensed << kept->own.condensed, moving.condensed;
  return out;
}

} // namespace

SubstructuredFactor::SubstructuredFactor(std::vector<FactorisedPart> parts,
                                         std::shared_ptr<Condensation> region,
                                         std::int64_t region_unknowns)
    : parts_(std::move(parts)), region_(std::move(region)), region_unknowns_(region_unknowns) {
  for (const FactorisedPart& part : parts_) {
    first_.push_back(first_.back() + part.locals);
  }
}

SubstructuredFactor::ColumnsOfRange
SubstructuredFactor::columns_of_range(const SparseRightHandSides& F, std::int64_t begin,
                                      std::int64_t end) {
  ColumnsOfRange out;
  for (std::int64_t k = 0; k < F.count(); ++k) {
    const std::size_t before = out.F.row.size();
    for (std::int64_t p = F.start[at(k)]; p < F.start[at(k + 1)]; ++p) {
      if (F.row[at(p)] >= begin && F.row[at(p)] < end) {
        out.F.row.push_back(F.row[at(p)] - begin);
        out.F.value.push_back(F.value[at(p)]);
      }
    }
    if (out.F.row.size() > before) {
      out.column.push_back(k);
      out.F.start.push_back(index(out.F.row.size()));
    }
  }
  return out;
}

void SubstructuredFactor::solve_from(std::size_t part, const base::Matrix& f,
                                     base::Matrix& region_load,
                                     const ExternalDisplacementSolver& displacement,
                                     base::Matrix& u) const {
  if (part == parts_.size()) {
    u.bottomRows(region_unknowns_) = region_->solve(region_load, displacement);
    return;
  }
  const FactorisedPart& own = parts_[part];
  base::Matrix load = base::Matrix::Zero(own.locals + index(own.rows.size()), f.cols());
  load.topRows(own.locals) = f.middleRows(first_[part], own.locals);
  // Between the halves of the part's solution lies that of all the others.
  const base::Matrix found = own.factor->solve(load, [&](const base::Matrix& condensed) {
    for (std::size_t i = 0; i < own.rows.size(); ++i) {
      region_load.row(own.rows[i]) += condensed.row(index(i));
    }
    solve_from(part + 1, f, region_load, displacement, u);
    base::Matrix rim(index(own.rows.size()), f.cols());
    for (std::size_t i = 0; i < own.rows.size(); ++i) {
      rim.row(index(i)) = u.row(region_begin() + own.rows[i]);
    }
    return rim;
  });
  u.middleRows(first_[part], own.locals) = found.topRows(own.locals);
}

base::Matrix SubstructuredFactor::solve(const base::Matrix& f,
                                        const ExternalDisplacementSolver& displacement) const {
  assert(f.rows() == size());
  if (parts_.empty()) {
    return region_->solve(f, displacement);
  }
  base::Matrix u(f.rows(), f.cols());
  base::Matrix region_load = f.bottomRows(region_unknowns_);
  solve_from(0, f, region_load, displacement, u);
  return u;
}

RowCompliance SubstructuredFactor::compliance_with_externals_held(const SparseRightHandSides& F,
                                                                  std::int64_t lasting,
                                                                  LastingColumns* kept) const {
  assert(lasting == 0 || (kept != nullptr && lasting_unknowns() > 0));
  if (parts_.empty()) {
    return compliance_of(*region_, F, lasting, kept);
  }
  std::vector<ColumnsOfRange> columns;
  std::vector<RowCompliance> own;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    columns.push_back(columns_of_range(F, first_[p], first_[p + 1]));
    own.push_back(compliance_of(*parts_[p].factor, columns.back().F, lasting, kept));
  }
  RowCompliance out = region_->compliance_with_externals_held(on_region(F, columns, own));
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const std::vector<std::int64_t>& at_column = columns[p].column;
    out.W(at_column, at_column) += own[p].W;
    out.flops += own[p].flops;
  }
  return out;
}

// What the parts hand on acts on the region beside the columns' own entries there.
SparseRightHandSides SubstructuredFactor::on_region(const SparseRightHandSides& F,
                                                    const std::vector<ColumnsOfRange>& columns,
                                                    const std::vector<RowCompliance>& own) const {
  SparseRightHandSides out;
  std::vector<std::size_t> next(columns.size(), 0);
  for (std::int64_t k = 0; k < F.count(); ++k) {
    for (std::size_t p = 0; p < columns.size(); ++p) {
      if (next[p] == columns[p].column.size() || columns[p].column[next[p]] != k) {
        continue;
      }
      const auto from = own[p].condensed.col(index(next[p]++));
      for (std::size_t i = 0; i < parts_[p].rows.size(); ++i) {
        out.row.push_back(parts_[p].rows[i]);
        out.value.push_back(from[index(i)]);
      }
    }
    for (std::int64_t p = F.start[at(k)]; p < F.start[at(k + 1)]; ++p) {
      if (F.row[at(p)] >= region_begin()) {
        out.row.push_back(F.row[at(p)] - region_begin());
        out.value.push_back(F.value[at(p)]);
      }
    }
    out.start.push_back(index(out.row.size()));
  }
  return out;
}

} // namespace spricka::solve
