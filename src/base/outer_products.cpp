// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/outer_products.hpp"

#include <cassert>
#include <cstddef>
#include <cstring>

namespace spricka::base {

namespace {

// Numbers that are worked on at once, in several registers where one does not hold them.
using EightDoubles [[gnu::vector_size(64)]] = double;
using FourDoubles [[gnu::vector_size(32)]] = double;
using TwoDoubles [[gnu::vector_size(16)]] = double;

// C [.., n] with distances between columns, A and B [n, columns] likewise.
struct OuterProductOperands {
  double factor;
  double* C;
  const double* A;
  const double* B;
  std::ptrdiff_t C_stride, A_stride, B_stride, n;
};

// As many rows as a pack holds, from row i on: their part of A stays in registers for all columns
// of C. Products may not be contracted with sums: bits would depend on the processor.
template <class Pack, int columns>
[[gnu::always_inline]] inline void add_pack(const OuterProductOperands& of, std::ptrdiff_t i) {
  const auto load = [](const double* from, Pack& to) __attribute__((always_inline)) {
    std::memcpy(&to, from, sizeof to);
  };
  Pack a1{};
  Pack a2{};
  Pack a3{};
  Pack a4{};
  load(of.A + i, a1);
  if constexpr (columns > 1) {
    load(of.A + of.A_stride + i, a2);
  }
  if constexpr (columns > 2) {
    load(of.A + 2 * of.A_stride + i, a3);
  }
  if constexpr (columns > 3) {
    load(of.A + 3 * of.A_stride + i, a4);
  }
  for (std::ptrdiff_t j = 0; j < of.n; ++j) {
    const double* b = of.B + j;
    Pack sum = a1 * b[0];
    if constexpr (columns > 1) {
      sum += a2 * b[of.B_stride];
    }
    if constexpr (columns > 2) {
      sum += a3 * b[2 * of.B_stride];
    }
    if constexpr (columns > 3) {
      sum += a4 * b[3 * of.B_stride];
    }
    double* at = of.C + j * of.C_stride + i;
    Pack c;
    load(at, c);
    c += of.factor * sum;
    std::memcpy(at, &c, sizeof c);
  }
}

template <int columns>
[[gnu::always_inline]] inline void add_rows(const OuterProductOperands& of, std::ptrdiff_t m) {
  std::ptrdiff_t i = 0;
  for (; i + 8 <= m; i += 8) {
    add_pack<EightDoubles, columns>(of, i);
  }
  if (i + 4 <= m) {
    add_pack<FourDoubles, columns>(of, i);
    i += 4;
  }
  if (i + 2 <= m) {
    add_pack<TwoDoubles, columns>(of, i);
    i += 2;
  }
  if (i < m) {
    add_pack<double, columns>(of, i);
  }
}

[[gnu::always_inline]] inline void add_all(const OuterProductOperands& of, std::ptrdiff_t m,
                                           std::ptrdiff_t k) {
  switch (k) {
  case 1:
    return add_rows<1>(of, m);
  case 2:
    return add_rows<2>(of, m);
  case 3:
    return add_rows<3>(of, m);
  default:
    return add_rows<4>(of, m);
  }
}

void add_on_any(const OuterProductOperands& of, std::ptrdiff_t m, std::ptrdiff_t k) {
  add_all(of, m, k);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void add_on_avx2(const OuterProductOperands& of, std::ptrdiff_t m,
                                         std::ptrdiff_t k) {
  add_all(of, m, k);
}
#endif

auto addition_for_processor() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") != 0 ? add_on_avx2 : add_on_any;
#else
  return add_on_any;
#endif
}

} // namespace

void add_outer_products(double factor, const Eigen::Ref<const Matrix>& A,
                        const Eigen::Ref<const Matrix>& B, Eigen::Ref<Matrix> C) {
  static const auto add = addition_for_processor();
  assert(A.cols() == B.cols() && A.cols() >= 1 && A.cols() <= 4);
  assert(C.rows() == A.rows() && C.cols() == B.rows());
  const OuterProductOperands of{.factor = factor,
                                .C = C.data(),
                                .A = A.data(),
                                .B = B.data(),
                                .C_stride = C.outerStride(),
                                .A_stride = A.outerStride(),
                                .B_stride = B.outerStride(),
                                .n = C.cols()};
  add(of, C.rows(), A.cols());
}

} // namespace spricka::base
