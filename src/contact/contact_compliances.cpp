// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_compliances.hpp"

#include "base/index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spricka::contact {

using base::at;
using base::index;

namespace {

// The rows of a body as columns [m, k].
base::Matrix as_columns(const std::vector<std::vector<RowCoefficient>>& rows,
                        std::size_t freedoms) {
  base::Matrix GT = base::Matrix::Zero(index(freedoms), index(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const RowCoefficient& share : rows[k]) {
      GT(share.at, index(k)) += share.weight;
    }
  }
  return GT;
}

// What a row opens by if all its freedoms move by one against it.
double row_size(const std::vector<RowCoefficient>& row) {
  double size = 0.0;
  for (const RowCoefficient& share : row) {
    size += std::abs(share.weight);
  }
  return size;
}

/// Adds one body after the other.
class ComplianceAssembly {
public:
  ComplianceAssembly(const std::vector<const CondensedBody*>& bodies,
                     const std::vector<std::vector<BodyRowEntry>>& entries)
      : bodies_(bodies), rows_(entries) {
    mode_start_.push_back(0);
    for (const CondensedBody* body : bodies) {
      mode_start_.push_back(mode_start_.back() + body->rigid_modes().cols());
    }
    const auto n = index(entries.size());
    made_.W = base::Matrix::Zero(n, n);
    made_.B = base::Matrix::Zero(n, mode_start_.back());
  }

  void add_body(std::size_t body, const PersistentRowSet& lasting,
                const std::vector<const ConstraintRow*>& rows);
  [[nodiscard]] ContactCompliances take() { return std::move(made_); }

private:
  [[nodiscard]] std::vector<std::vector<RowCoefficient>>
  shares_of(std::size_t body, const std::vector<std::size_t>& list, bool early) const;
  /// Whether a row can be among the kept ones of a body.
  [[nodiscard]] bool may_last(std::size_t body, std::size_t row) const;
  void add_compliance(const std::vector<std::size_t>& r, const std::vector<std::size_t>& c,
                      const base::Matrix& part);
  void add_modes(std::size_t body, const std::vector<std::size_t>& list,
                 const std::vector<std::vector<RowCoefficient>>& shares);

  const std::vector<const CondensedBody*>& bodies_;
  const std::vector<std::vector<BodyRowEntry>>& rows_;
  std::vector<Eigen::Index> mode_start_; ///< [body + 1]
  ContactCompliances made_;
};

// Of a layered factor only the early rows outlast a length, of an uncondensed body rows on its one
// part; a body with S of its own is kept as a whole or not at all.
bool ComplianceAssembly::may_last(std::size_t body, std::size_t row) const {
  if (bodies_[body]->is_uncondensed()) {
    return std::ranges::all_of(rows_[row], [&](const BodyRowEntry& e) {
      return e.body != body || e.at < bodies_[body]->factor().lasting_unknowns();
    });
  }
  const solve::FactoredSchurComplement* factor = bodies_[body]->external_block_factor();
  return factor == nullptr || std::ranges::all_of(rows_[row], [&](const BodyRowEntry& e) {
           return e.body != body || factor->row[at(e.at)] < factor->L.first_block_size();
         });
}

std::vector<std::vector<RowCoefficient>>
ComplianceAssembly::shares_of(std::size_t body, const std::vector<std::size_t>& list,
                              bool early) const {
  std::vector<std::vector<RowCoefficient>> out;
  for (const std::size_t r : list) {
    std::vector<RowCoefficient>& own = out.emplace_back();
    for (const BodyRowEntry& e : rows_[r]) {
      if (e.body == body) {
        own.push_back(
            {early ? bodies_[body]->external_block_factor()->row[at(e.at)] : e.at, e.weight});
      }
    }
  }
  return out;
}

void ComplianceAssembly::add_body(std::size_t body, const PersistentRowSet& lasting,
                                  const std::vector<const ConstraintRow*>& rows) {
  std::vector<std::size_t> stay; // rows of the body that last, and those that do not
  std::vector<std::size_t> move;
  const bool keeps = body < lasting.kept.size() && lasting.kept[body] != nullptr;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (std::ranges::any_of(rows_[r], [&](const BodyRowEntry& e) { return e.body == body; })) {
      (keeps && lasting.row[r] && may_last(body, r) ? stay : move).push_back(r);
    }
  }
  // By node, not as the chains run: these may begin elsewhere at another length, and then what is
  // kept would not be known again.
  std::ranges::stable_sort(
      stay, {}, [&](std::size_t r) { return std::pair(rows[r]->node, rows[r]->tangential); });
  const CondensedBody& own = *bodies_[body];
  if (own.is_uncondensed()) {
    std::vector<std::size_t> all = stay;
    all.insert(all.end(), move.begin(), move.end());
    const std::vector<std::vector<RowCoefficient>> shares = shares_of(body, all, false);
    const solve::RowCompliance found = own.compliance_with_externals_held(
        shares, index(stay.size()), keeps ? &lasting.kept[body]->columns : nullptr);
    made_.flops += found.flops;
    add_compliance(all, all, found.W);
    add_modes(body, all, shares);
    return;
  }
  const std::vector<std::vector<RowCoefficient>> moving = shares_of(body, move, false);
  const solve::FactoredSchurComplement* factor = own.external_block_factor();
  // Rows that do not last: half compliances anew; Y^T Y is symmetric to the last bit.
  const base::Matrix Y = own.compliance_root(as_columns(moving, own.external_freedoms().size()));
  add_compliance(move, move, solve::gram_matrix(Y));
  add_modes(body, move, moving);
  if (stay.empty()) {
    return;
  }
  PersistentRowCompliance& kept = *lasting.kept[body];
  std::vector<std::vector<RowCoefficient>> staying = shares_of(body, stay, factor != nullptr);
  // What is kept serves only if its rows weigh the same freedoms, number by number.
  if (kept.rows != staying) {
    if (factor != nullptr) {
      const solve::FirstBlockFactor& early = *factor->L.first_block();
      kept.Y = early.forward_substitute(
          as_columns(staying, static_cast<std::size_t>(early.early_row_count())));
      kept.late_load = early.second_block_load_reduction(kept.Y);
    } else {
      kept.Y = own.compliance_root(as_columns(staying, own.external_freedoms().size()));
    }
    kept.W = solve::gram_matrix(kept.Y);
    kept.rows = std::move(staying);
  }
  add_compliance(stay, stay, kept.W);
  add_modes(body, stay, kept.rows);
  // Lasting rows with the others. What the late rows add to either is of this length: their half
  // solves go into the compliances after the kept part.
  base::Matrix between = solve::transposed_product(kept.Y, Y.topRows(kept.Y.rows()));
  if (factor != nullptr) {
    const base::Matrix late = factor->L.forward_second_block(kept.late_load);
    add_compliance(stay, stay, solve::gram_matrix(late));
    between += solve::transposed_product(late, Y.bottomRows(late.rows()));
  }
  add_compliance(stay, move, between);
  add_compliance(move, stay, between.transpose());
}

void ComplianceAssembly::add_compliance(const std::vector<std::size_t>& r,
                                        const std::vector<std::size_t>& c,
                                        const base::Matrix& part) {
  for (std::size_t k = 0; k < c.size(); ++k) {
    auto column = made_.W.col(index(c[k]));
    for (std::size_t i = 0; i < r.size(); ++i) {
      column[index(r[i])] += part(index(i), index(k));
    }
  }
}

void ComplianceAssembly::add_modes(std::size_t body, const std::vector<std::size_t>& list,
                                   const std::vector<std::vector<RowCoefficient>>& shares) {
  const base::Matrix& Q = bodies_[body]->rigid_modes();
  const double motion = Q.size() > 0 ? Q.cwiseAbs().maxCoeff() : 0.0;
  for (std::size_t k = 0; k < list.size() && Q.cols() > 0; ++k) {
    auto row = made_.B.block(index(list[k]), mode_start_[body], 1, Q.cols());
    for (const RowCoefficient& share : shares[k]) {
      row += share.weight * Q.row(share.at);
    }
    // By the motion of the whole body, not by what its modes open here: a mode that no row feels
    // must look small against it.
    made_.opening_scale = std::max(made_.opening_scale, motion * row_size(shares[k]));
  }
}

} // namespace

ContactCompliances assemble_compliances(const std::vector<const CondensedBody*>& bodies,
                                        const std::vector<std::vector<BodyRowEntry>>& entries,
                                        const std::vector<const ConstraintRow*>& rows,
                                        const PersistentRowSet& lasting) {
  ComplianceAssembly assembly(bodies, entries);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    assembly.add_body(b, lasting, rows);
  }
  return assembly.take();
}

} // namespace spricka::contact
