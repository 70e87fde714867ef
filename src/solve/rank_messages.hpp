// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "solve/communicator.hpp"

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace spricka::solve {

/// What rank 0 asks of another rank.
enum class RankOrder : std::int64_t {
  condense,      ///< a matrix -> report, S; the factor stays there
  condense_load, ///< loads -> condensed loads
  recover,       ///< external displacements and loads -> all unknowns
  compliance,    ///< sparse columns -> their compliance
  release,       ///< a factor is wanted no more
  step,          ///< of a factorisation by all ranks
  report_use,    ///< -> largest resident set, CPU time
  end            ///< no more work
};

/// Numbers, lists and matrices to and from one other rank, read in the order of writing.
class RankMessages {
public:
  RankMessages(Communicator& communicator, int other)
      : communicator_(communicator), other_(other) {}

  template <typename T> void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    communicator_.send(other_, &value, sizeof(T));
  }
  template <typename T> T get() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    communicator_.receive(other_, &value, sizeof(T));
    return value;
  }

  template <typename List> void put_list(const List& list) {
    put(static_cast<std::int64_t>(list.size()));
    communicator_.send(other_, list.data(), list.size() * sizeof(*list.data()));
  }
  template <typename List> List get_list() {
    List list;
    list.resize(static_cast<std::size_t>(get<std::int64_t>()));
    communicator_.receive(other_, list.data(), list.size() * sizeof(*list.data()));
    return list;
  }

  void put_matrix(const base::Matrix& M) {
    put(static_cast<std::int64_t>(M.rows()));
    put(static_cast<std::int64_t>(M.cols()));
    communicator_.send(other_, M.data(), static_cast<std::size_t>(M.size()) * sizeof(double));
  }
  base::Matrix get_matrix() {
    const auto rows = get<std::int64_t>();
    const auto cols = get<std::int64_t>();
    base::Matrix M(rows, cols);
    communicator_.receive(other_, M.data(), static_cast<std::size_t>(M.size()) * sizeof(double));
    return M;
  }

private:
  Communicator& communicator_;
  int other_;
};

/// All that a report says, to another rank and from it.
void put_report(RankMessages& other, const FactorReport& report);
FactorReport get_report(RankMessages& other);

} // namespace spricka::solve
