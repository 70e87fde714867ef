// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/vec.hpp"
#include "model/crack_growth.hpp"
#include "results/named_arrays.hpp"
#include "results/results.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace spricka::analysis {

struct LoadHistoryKResult;

/// What a reader of a growth must not miss, each once.
class GrowthWarnings {
public:
  /// The rules must outlive it.
  explicit GrowthWarnings(const model::CrackGrowthSettings& rules) : rules_(rules) {}

  /// All so far, with those of the K2 and K3 that were noted.
  [[nodiscard]] std::set<results::Warning> all() const;
  void add(const results::Warning& warning) { warnings_.insert(warning); }
  /// Keeps what was said of the mesh of a station, the first time of each code.
  void keep_first_mesh_warning(const std::string& code, const std::string& text,
                               std::size_t station);
  /// Of a tip or crack whose faces close at length `a`, with no K below that.
  void warn_of_closing_faces(const std::string& name, double a);
  /// Of a cycle, on a crack of length `a`, that a threshold measured at another R holds back; once
  /// a crack.
  void warn_of_constant_threshold(const std::string& crack, double a, double K_max, double K_min);
  /// Where CORRECT=YES asks for corrected K: `why` there is no error bar to correct it by; empty:
  /// there is one.
  void warn_of_missing_error_bar(const std::string& name, const std::string& why);
  /// The same of the ends of the spectrum's path.
  void warn_of_missing_error_bar(const results::FrontResult& end);
  /// Of K at KMAX, where K1 is open.
  void warn_of_invalid_result(const results::FrontResult& front, double K1);
  /// Of K2 at KMAX of a tip that grows along its path; K1 and K2.
  void warn_of_K2(const std::string& name, const base::Vec2& K);
  /// Notes K2 and K3 at KMAX that the growth of a crack does not follow; the largest part counts.
  void note_neglected_shear_K(const std::string& crack, const base::Vec3& K);
  /// Of loads that do not repeat themselves, and of K that is apart by two ways, at length `a`.
  void warn_of_load_history(const LoadHistoryKResult& loads, double a);

  /// As arrays "growth.warnings", "growth.shear" for a restart file.
  void save_state(results::NamedArrays& arrays) const;
  /// Back from a restart file. Throws base::CorruptStoredField where an array is missing.
  void restore_state(const results::NamedArrays& arrays);
  /// The same of keep_first_mesh_warning() alone: K has no part in them. None without the arrays.
  void restore_mesh_warnings(const results::NamedArrays& arrays);

private:
  [[nodiscard]] bool stays_on_path() const {
    return rules_.direction == model::GrowthDirection::path;
  }

  const model::CrackGrowthSettings& rules_;
  std::set<results::Warning> warnings_;
  /// The largest K2 or K3 that the growth of a crack does not follow, as a part of K1.
  struct NeglectedShearK {
    std::string what; ///< "K2", "K3"
    double part = 0.0;
  };
  std::map<std::string, NeglectedShearK> shear_; ///< [crack]
};

} // namespace spricka::analysis
