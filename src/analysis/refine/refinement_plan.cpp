// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/refine/refinement_plan.hpp"

#include "analysis/refine/contact_places.hpp"
#include "analysis/refine/wide_bars.hpp"
#include "mesh/plane_element.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/ranges.h>

namespace spricka::analysis {

namespace {

// The error of K falls with the q-th power of the element size: 3 to 4 away from the tip, where u
// and z are smooth; 3 asks for a little more than needed.
constexpr double q = 3.0;
constexpr double aim = 0.9;        // of what is allowed: a round more costs more than this margin
constexpr double most_finer = 2.0; // of a patch in one round
constexpr double no_change = 0.95; // of a size: not worth a new mesh
// Where few elements have most of an error it stems from places without bound, and falls with the
// first power of their size at worst (clamped ends, notches).
constexpr double peak = 0.04;        // of the host's error, in one element
constexpr double most_of_sum = 0.5;  // of all error, in the peaks together
constexpr double worth_a_mesh = 0.7; // of the size of single elements
// Bars along fronts in space fall with about the square of the sizes of tube and patch (manual,
// tolerance.5).
constexpr double order_along = 2.0;
constexpr double aim_along = 0.9;
constexpr double most_in_round = 1.6; // elements of a patch grow with its cube

/// Factors on the sizes of one increment's host elements and of the patches, from its bars.
struct ElementSizeFactors {
  std::vector<double> host;  ///< [kept host element] of its size
  std::vector<double> patch; ///< [crack] to be divided by
};

double power_sum(const std::vector<double>& error, std::size_t from, std::size_t to, double power) {
  return std::accumulate(error.begin() + static_cast<std::ptrdiff_t>(from),
                         error.begin() + static_cast<std::ptrdiff_t>(to), 0.0,
                         [&](double sum, double e) { return sum + std::pow(std::abs(e), power); });
}

// Elements of the host in which the error has peaks; none where it is spread.
std::vector<bool> peaks_of(const std::vector<double>& error, std::size_t kept, double sum) {
  const double host = power_sum(error, 0, kept, 1.0);
  std::vector<bool> peaks(kept, false);
  double inside = 0.0;
  for (std::size_t e = 0; e < kept; ++e) {
    peaks[e] = std::abs(error[e]) > peak * host;
    inside += peaks[e] ? std::abs(error[e]) : 0.0;
  }
  return inside > most_of_sum * sum ? peaks : std::vector<bool>(kept, false);
}

// Makes peaks as small as keeps half of what is allowed; what is left of the host and of what it
// may keep.
struct Rest {
  std::vector<double> error; ///< [kept host element] 0 in peaks
  double sum = 0.0, allowed = 0.0;
};
Rest share_peaks(const std::vector<double>& error, double sum, double allowed,
                 ElementSizeFactors& factors) {
  Rest rest{.error = error, .allowed = allowed};
  rest.error.resize(factors.host.size());
  const std::vector<bool> peaks = peaks_of(error, rest.error.size(), sum);
  double high = 0.0;
  for (std::size_t e = 0; e < peaks.size(); ++e) {
    high += peaks[e] ? std::abs(error[e]) : 0.0;
  }
  for (std::size_t e = 0; e < peaks.size(); ++e) {
    if (peaks[e]) {
      // Errors of peaks fall with the first power: this factor leaves half of what is allowed.
      const double f = std::clamp(0.5 * allowed / high, least_factor, 1.0);
      factors.host[e] = std::min(factors.host[e], f);
      rest.error[e] = 0.0;
    }
  }
  rest.sum = power_sum(rest.error, 0, rest.error.size(), 1.0);
  rest.allowed = allowed - std::min(high, 0.5 * allowed);
  return rest;
}

// Least freedoms sum f_e^-2 at a sum of |eta_e| f_e^q: f_e = c |eta_e|^(-1/(q + 2)).
void share_out(const ExcessiveErrorBar& wide, ElementSizeFactors& factors) {
  const std::vector<double>& error = wide.bar.of_element;
  const std::size_t kept = factors.host.size();
  const double patch = power_sum(error, kept, error.size(), 1.0);
  const double host = power_sum(error, 0, kept, 1.0);
  // (tolerance.1), with no more of the contacts' part taken off than they may keep.
  const double room =
      aim * (wide.allowed - wide.bar.floor - std::min(wide.bar.edge, most_of_bar * wide.allowed));
  // Where floor and contacts leave no room the mesh becomes as fine as one round allows.
  const double over = room > 0.0 ? wide.bar.mesh / room : 1.0 / std::pow(least_factor, q);
  const double sum = patch + host;
  if (over <= 1.0 || sum <= 0.0) {
    return;
  }
  // A patch of N elements has one factor: N f^-2 at S_p f^q, beside the host's sums.
  const double of_patch = std::pow(static_cast<double>(error.size() - kept), q / (q + 2.0)) *
                          std::pow(patch, 2.0 / (q + 2.0));
  const double share = of_patch / (of_patch + power_sum(error, 0, kept, 2.0 / (q + 2.0)));
  const double for_patch = std::clamp(share, least_share, 1.0 - least_share) * sum / over;
  const double for_host = sum / over - for_patch;
  if (patch > for_patch) {
    double& finer = factors.patch[wide.at.crack.index()];
    // (tolerance.3)
    finer = std::max(finer, std::min(std::pow(patch / for_patch, 1.0 / q), most_finer));
  }
  if (host <= for_host) {
    return;
  }
  const Rest rest = share_peaks(error, sum, for_host, factors);
  if (rest.sum <= rest.allowed) {
    return;
  }
  // (tolerance.2), on what is left beside the peaks.
  const double c =
      std::pow(rest.allowed / power_sum(rest.error, 0, kept, 2.0 / (q + 2.0)), 1.0 / q);
  for (std::size_t e = 0; e < kept; ++e) {
    const double own = std::abs(rest.error[e]);
    const double f = own == 0.0 ? 1.0 : c * std::pow(own, -1.0 / (q + 2.0));
    factors.host[e] = std::min(factors.host[e], std::clamp(f, least_factor, 1.0));
  }
}

std::string net_of(const model::Model& model, const model::Mesh& mesh, std::size_t e) {
  return model.nets[mesh.element_net[e].index()].name;
}

// What patches stand in for keeps its size: it is cut out again.
void add_cavities(const model::Model& model, const results::CrackLengthResult& increment,
                  SizeRequestsByNet& requests) {
  const model::Mesh& host = model.mesh;
  std::set<std::pair<std::int32_t, base::Label>> kept;
  for (std::size_t e = 0; e < increment.kept; ++e) {
    kept.emplace(increment.mesh.element_net[e].value, increment.mesh.element_label[e]);
  }
  for (std::size_t e = 0; e < host.element_count(); ++e) {
    if (!kept.contains({host.element_net[e].value, host.element_label[e]})) {
      requests[net_of(model, host, e)].push_back({mesh::element_centroid(host, base::ElementId(e)),
                                                  mesh::mean_side_length(host, base::ElementId(e)),
                                                  false});
    }
  }
}

// Part of a net's size that its errors ask for as a whole, for meshes that are refined evenly: as
// many elements as f_e^-2 of each.
double even_factor(const model::Mesh& mesh, const ElementSizeFactors& factors, base::NetId net) {
  double wanted = 0.0;
  double now = 0.0;
  for (std::size_t e = 0; e < factors.host.size(); ++e) {
    if (mesh.element_net[e] == net) {
      wanted += 1.0 / (factors.host[e] * factors.host[e]);
      now += 1.0;
    }
  }
  return now > 0.0 ? std::sqrt(now / wanted) : 1.0;
}

/// What all increments of a run ask for.
struct Demands {
  SizeRequestsByNet requests;
  PresentElementSizes elements;
  std::map<std::string, double> even;  ///< by net: of its size, for meshes refined evenly
  std::map<std::string, double> least; ///< by net: the smallest factor of its elements
  std::vector<RefinementPoint> places;
  std::vector<double> patch; ///< [crack] to be divided by
};

void add_elements(const model::Model& model, const results::CrackLengthResult& increment,
                  const ElementSizeFactors& factors, Demands& demands) {
  add_cavities(model, increment, demands.elements.cut);
  for (std::size_t e = 0; e < increment.kept; ++e) {
    const double f = factors.host[e];
    const std::string net = net_of(model, increment.mesh, e);
    const base::Vec2 centre = mesh::element_centroid(increment.mesh, base::ElementId(e));
    const double size = mesh::mean_side_length(increment.mesh, base::ElementId(e));
    demands.elements.kept[net].push_back({centre, size, false});
    demands.requests[net].push_back({centre, f * size, f < no_change});
    double& least = demands.least.try_emplace(net, 1.0).first->second;
    least = std::min(least, f);
  }
  for (std::size_t n = 0; n < model.nets.size(); ++n) {
    double& f = demands.even.try_emplace(model.nets[n].name, 1.0).first->second;
    f = std::min(f, even_factor(increment.mesh, factors, base::NetId(n)));
  }
}

Demands demands_of(const model::Model& model, const results::RunResult& run) {
  const std::vector<ExcessiveErrorBar> bars = find_excessive_error_bars(model, run);
  Demands demands;
  demands.patch.assign(model.cracks.size(), 1.0);
  for (const results::CrackLengthResult& increment : run.increments) {
    ElementSizeFactors factors{std::vector<double>(increment.kept, 1.0), demands.patch};
    for (const ExcessiveErrorBar& wide : bars) {
      if (&wide.at.increment != &increment) {
        continue;
      }
      if (wide.bar.edge <= wide.allowed) { // else eta, too, comes from contacts that are too coarse
        share_out(wide, factors);
      }
      add_points_that_widen_bar(model, wide, demands.places);
    }
    // Each length begins with what those before have asked of the patches.
    demands.patch = factors.patch;
    add_elements(model, increment, factors, demands);
  }
  return demands;
}

// By what sizes of each crack's tube and patch are to be divided, so that the part of its bars that
// the mesh makes comes below what is left of its tolerance. [crack], >= 1
std::vector<double> front_refinement(const model::Model& model, const results::RunResult& run) {
  std::vector<double> finer(model.cracks.size(), 1.0);
  for (const FrontWithTolerance& at : fronts_with_tolerance(model, run)) {
    for (const results::FrontPointResult& point : at.front.points) {
      for (std::size_t k = 0; k < 3 && !point.at_surface && at.front.has_error_bar(); ++k) {
        const results::KErrorBar& bar = point.bar[k];
        const double room = aim_along * (at.tolerance * at.K - bar.floor);
        const double over = room > 0.0 ? bar.mesh / room : std::pow(most_in_round, order_along);
        double& own = finer[at.crack.index()];
        own = std::clamp(std::pow(over, 1.0 / order_along), own, most_in_round);
      }
    }
  }
  return finer;
}

} // namespace

RefinementPlan::RefinementPlan(const model::Model& model) : finer_(model.cracks.size(), 1.0) {
  for (const model::TipMeshSettings& tip : model.tip_nets) {
    finer_[tip.crack.index()] = tip.finer;
  }
}

std::string RefinementPlan::refine_fronts(const model::Model& model,
                                          const results::RunResult& run) {
  std::vector<std::string> made;
  patch_growth_ = 1.0;
  const std::vector<double> finer = front_refinement(model, run);
  for (std::size_t c = 0; c < finer.size(); ++c) {
    if (finer[c] > 1.0 / no_change) {
      finer_[c] *= finer[c];
      patch_growth_ = std::max(patch_growth_, std::pow(finer[c], 3));
      made.push_back(
          fmt::format("tube and patch of {} {:.2f} times", model.cracks[c].name, finer[c]));
    }
  }
  return fmt::format("{}", fmt::join(made, "; "));
}

std::string RefinementPlan::refine_from_errors(const model::Model& model,
                                               const results::RunResult& run) {
  if (std::ranges::none_of(model.cracks, &model::CrackDefinition::is_line)) {
    return refine_fronts(model, run);
  }
  Demands demands = demands_of(model, run);
  const RefinedSizeRequests followers =
      request_sizes_near_points(demands.places, demands.elements, demands.patch.size());
  for (const SizeRequestsByNet* more : {&std::as_const(demands.elements.cut), &followers.nets}) {
    for (const auto& [net, list] : *more) {
      demands.requests[net].insert(demands.requests[net].end(), list.begin(), list.end());
    }
  }
  std::vector<std::string> moved;
  patch_growth_ = 1.0;
  for (std::size_t c = 0; c < demands.patch.size(); ++c) {
    const double finer = std::max(demands.patch[c], followers.patch[c]);
    if (finer > 1.0 / no_change) {
      finer_[c] *= finer;
      // Elements of a patch grow with the square of what its sizes are divided by.
      patch_growth_ = std::max(patch_growth_, finer * finer);
      moved.push_back(fmt::format("patch of {} {:.2f} times", model.cracks[c].name, finer));
    }
  }
  for (auto& [net, list] : demands.requests) {
    const bool near_ends = followers.nets.contains(net);
    const double f = demands.even[net];
    // A net that is fine on the whole may still have elements that are much too large.
    const bool in_places = demands.least[net] < worth_a_mesh;
    if (!near_ends && !in_places && f >= no_change) {
      continue;
    }
    deck::NetRefinement& net_refinement = nets_[net];
    net_refinement.size.map = std::make_shared<const mesh::SizeMap>(std::move(list));
    net_refinement.counts =
        static_cast<int>(std::ceil(net_refinement.counts / std::min(f, near_ends ? 0.7 : 1.0)));
    net_refinement.splits += 1;
    moved.push_back(fmt::format("{} {:.2f} times{}", net.empty() ? "the mesh" : "net " + net,
                                1.0 / f,
                                near_ends                     ? ", most where contact ends"
                                : in_places && f >= no_change ? ", most in single elements"
                                                              : ""));
  }
  return fmt::format("{}", fmt::join(moved, "; "));
}

void RefinementPlan::apply_to_model(model::Model& model) const {
  for (model::TipMeshSettings& tip : model.tip_nets) {
    tip.finer = finer_[tip.crack.index()];
  }
}

} // namespace spricka::analysis
