// SPDX-License-Identifier: GPL-3.0-or-later
#include "fe/dependence.hpp"

#include "model/freedoms.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::fe {

namespace {

using model::FreedomRole;

// What is left of terms that cancel, over the sum of their sizes.
constexpr double round_off = 1e-12;
// A first term smaller than this share of the largest is not eliminated: everything that follows
// it would be blown up.
constexpr double least_pivot = 1e-6;

} // namespace

/// Terms and right-hand side being added up.
struct ConstraintTransformation::Sum {
  struct SummedTerm {
    double value = 0.0;
    /// The error of the value is some round-off of its size, which is carried along from tie to
    /// tie: of a product a b it is |a| size_b + |b| size_a, of a quotient likewise. What round-off
    /// left in one row must not pass for a coefficient that the next can be solved for.
    double size = 0.0;
    double parts = 0.0; ///< sum of the sizes of what was added here

    void add(double c, double its_size) {
      value += c;
      size += its_size;
      parts += std::abs(c);
    }
    [[nodiscard]] SummedTerm over(const SummedTerm& divisor) const {
      const double quotient = value / divisor.value;
      return {quotient, (size + std::abs(quotient) * divisor.size) / std::abs(divisor.value)};
    }
    [[nodiscard]] bool doubtful() const { return std::abs(value) <= round_off * size; }
    [[nodiscard]] bool cancelled() const { return std::abs(value) <= round_off * parts; }
  };
  std::map<std::int32_t, SummedTerm> terms;
  SummedTerm constant;

  void add(const DependentRow& row, const TermMagnitudes& sizes, const SummedTerm& factor) {
    // The error of a product, as Entry::size has it.
    const auto times = [&](double c, double size) {
      return SummedTerm{factor.value * c,
                        std::abs(factor.value) * size + factor.size * std::abs(c)};
    };
    for (std::size_t i = 0; i < row.terms.size(); ++i) {
      const SummedTerm part = times(row.terms[i].coefficient, sizes.terms[i]);
      terms[row.terms[i].freedom].add(part.value, part.size);
    }
    const SummedTerm part = times(row.constant, sizes.constant);
    constant.add(part.value, part.size);
  }
  void drop_cancelled() {
    std::erase_if(terms, [](const auto& term) { return term.second.cancelled(); });
    constant.value = constant.cancelled() ? 0.0 : constant.value;
  }
  void drop_doubtful() {
    std::erase_if(terms, [](const auto& term) { return term.second.doubtful(); });
    constant.value = constant.doubtful() ? 0.0 : constant.value;
  }
};

ConstraintTransformation::ConstraintTransformation(const std::vector<Tie>& ties,
                                                   const std::vector<FreedomRole>& cls)
    : row_of_(cls.size(), -1) {
  for (const Tie& tie : ties) {
    add(tie, cls);
  }
  std::ranges::sort(
      rows_, [](const DependentRow& a, const DependentRow& b) { return a.freedom < b.freedom; });
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    row_of_[static_cast<std::size_t>(rows_[i].freedom)] = static_cast<std::int32_t>(i);
  }
  users_.clear();
  sizes_.clear();
}

// sum c u + constant = 0, with dependent freedoms replaced, is solved for one of its free freedoms.
void ConstraintTransformation::add(const Tie& tie, const std::vector<FreedomRole>& cls) {
  Sum sum;
  // All on one side: sum of c u - rhs = 0.
  sum.constant.add(-tie.rhs, std::abs(tie.rhs));
  for (const FreedomTerm& t : tie.terms) {
    const Sum::SummedTerm c{t.coefficient, std::abs(t.coefficient)};
    const std::int32_t known = row_of_[static_cast<std::size_t>(t.freedom)];
    // Rows hold no dependent freedoms, so that replacing once is enough.
    if (known >= 0) {
      sum.add(rows_[static_cast<std::size_t>(known)], sizes_[static_cast<std::size_t>(known)], c);
    } else {
      sum.terms[t.freedom].add(c.value, c.size);
    }
  }
  sum.drop_cancelled();
  std::int32_t pivot = -1;
  double largest = 0.0;
  for (const auto& [freedom, entry] : sum.terms) {
    // What may be round-off as a whole is no coefficient to divide by.
    if (!model::is_suppressed_or_prescribed(cls[static_cast<std::size_t>(freedom)]) &&
        !entry.doubtful() && std::abs(entry.value) > largest) {
      largest = std::abs(entry.value);
      pivot = freedom;
    }
  }
  if (pivot < 0) {
    sum.drop_doubtful();
    if (sum.terms.empty() && sum.constant.value == 0.0) {
      ++redundant_;
      return;
    }
    // Only given freedoms are left: whether their values fulfil the tie is seen later.
    FullyGivenTie demand{{}, -sum.constant.value, sum.constant.parts, tie.mpc};
    for (const auto& [freedom, entry] : sum.terms) {
      demand.terms.push_back({freedom, entry.value});
    }
    demands_.push_back(std::move(demand));
    return;
  }
  const auto first = sum.terms.find(tie.terms.front().freedom);
  // The freedom that the tie names first shall follow, if dividing by its coefficient does no harm.
  if (first != sum.terms.end() &&
      !model::is_suppressed_or_prescribed(cls[static_cast<std::size_t>(first->first)]) &&
      !first->second.doubtful() && std::abs(first->second.value) >= least_pivot * largest) {
    pivot = first->first;
  }
  // Solved for the pivot all other terms change sides, and with that their signs.
  const Sum::SummedTerm divisor{-sum.terms.at(pivot).value, sum.terms.at(pivot).size};
  const Sum::SummedTerm constant = sum.constant.over(divisor);
  DependentRow row{pivot, {}, constant.value, tie.mpc};
  TermMagnitudes sizes{{}, constant.size};
  for (const auto& [freedom, entry] : sum.terms) {
    if (freedom != pivot) {
      const Sum::SummedTerm c = entry.over(divisor);
      row.terms.push_back({freedom, c.value});
      sizes.terms.push_back(c.size);
    }
  }
  const std::size_t number = rows_.size();
  for (const FreedomTerm& t : row.terms) {
    users_[t.freedom].push_back(number);
  }
  rows_.push_back(std::move(row));
  sizes_.push_back(std::move(sizes));
  row_of_[static_cast<std::size_t>(pivot)] = static_cast<std::int32_t>(number);
  eliminate(pivot, number);
}

// Rows that had the new dependent freedom as a master take its masters instead.
void ConstraintTransformation::eliminate(std::int32_t freedom, std::size_t by) {
  const auto found = users_.find(freedom);
  if (found == users_.end()) {
    return;
  }
  const std::vector<std::size_t> users = std::move(found->second);
  users_.erase(found);
  // So masters are never dependent: follow and reduce need one pass over the rows.
  for (const std::size_t user : users) {
    DependentRow& row = rows_[user];
    TermMagnitudes& sizes = sizes_[user];
    Sum sum;
    sum.constant.add(row.constant, sizes.constant);
    for (std::size_t i = 0; i < row.terms.size(); ++i) {
      const Sum::SummedTerm c{row.terms[i].coefficient, sizes.terms[i]};
      if (row.terms[i].freedom == freedom) {
        sum.add(rows_[by], sizes_[by], c);
      } else {
        sum.terms[row.terms[i].freedom].add(c.value, c.size);
      }
    }
    sum.drop_cancelled();
    for (const FreedomTerm& t : row.terms) {
      if (t.freedom != freedom) {
        // The masters of the row may be others now: it enters their lists anew below.
        std::erase(users_[t.freedom], user);
      }
    }
    row.terms.clear();
    sizes.terms.clear();
    row.constant = sum.constant.value;
    sizes.constant = sum.constant.size;
    for (const auto& [master, entry] : sum.terms) {
      row.terms.push_back({master, entry.value});
      sizes.terms.push_back(entry.size);
      users_[master].push_back(user);
    }
  }
}

bool ConstraintTransformation::has_constants() const {
  return std::ranges::any_of(rows_, [](const DependentRow& r) { return r.constant != 0.0; });
}

const ConstraintTransformation::DependentRow*
ConstraintTransformation::find_row(std::int32_t freedom) const {
  const std::int32_t at = row_of_[static_cast<std::size_t>(freedom)];
  return at < 0 ? nullptr : &rows_[static_cast<std::size_t>(at)];
}

void ConstraintTransformation::set_dependent_displacements(Eigen::Ref<base::Vector> u,
                                                           double scale) const {
  for (const DependentRow& row : rows_) {
    double sum = scale * row.constant;
    for (const FreedomTerm& t : row.terms) {
      sum += t.coefficient * u[t.freedom];
    }
    u[row.freedom] = sum;
  }
}

void ConstraintTransformation::transfer_forces_to_masters(base::Matrix& f) const {
  for (const DependentRow& row : rows_) {
    for (const FreedomTerm& t : row.terms) {
      f.row(t.freedom) += t.coefficient * f.row(row.freedom);
    }
    f.row(row.freedom).setZero();
  }
}

std::optional<ConstraintTransformation::BlockTransformation>
ConstraintTransformation::find_block_transformation(std::span<const std::int32_t> freedoms) const {
  if (std::ranges::none_of(freedoms, [&](std::int32_t f) { return find_row(f) != nullptr; })) {
    return std::nullopt;
  }
  BlockTransformation block;
  std::map<std::int32_t, int> column;
  const auto column_of = [&](std::int32_t freedom) {
    const auto [at, fresh] = column.emplace(freedom, static_cast<int>(block.freedom.size()));
    if (fresh) {
      block.freedom.push_back(freedom);
    }
    return at->second;
  };
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < freedoms.size(); ++i) {
    const auto at = static_cast<int>(i);
    const DependentRow* row = find_row(freedoms[i]);
    if (row == nullptr) {
      entries.emplace_back(at, column_of(freedoms[i]), 1.0);
      continue;
    }
    for (const FreedomTerm& t : row->terms) {
      entries.emplace_back(at, column_of(t.freedom), t.coefficient);
    }
  }
  // The rows of T in (fe.33) that this block needs.
  block.T.resize(static_cast<Eigen::Index>(freedoms.size()),
                 static_cast<Eigen::Index>(block.freedom.size()));
  block.T.setFromTriplets(entries.begin(), entries.end());
  return block;
}

} // namespace spricka::fe
