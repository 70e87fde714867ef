// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/checks/check_line.hpp"

#include <algorithm>
#include <cmath>

namespace spricka::program {

namespace {

const results::LoadPathResult& path_of(const results::RunResult& run, const std::string& name,
                                       std::optional<double> a) {
  for (auto it = run.increments.rbegin(); it != run.increments.rend(); ++it) {
    const results::LoadPathResult* path = results::find_path(*it, name);
    if (path == nullptr || (a && std::abs(it->a - *a) > 1e-6 * std::abs(*a))) {
      continue;
    }
    if (path->t.empty()) {
      throw MissingQuantity(fmt::format("load path {}: {}", name, path->stopped));
    }
    return *path;
  }
  throw MissingQuantity(a ? fmt::format("no increment of length {:.9g} with load path {}", *a, name)
                          : fmt::format("no results of load path {}", name));
}

const results::LoadPathFront& tip_of(const results::LoadPathResult& path, const std::string& name) {
  const results::LoadPathFront* tip = results::find_front(path, name);
  if (tip == nullptr || !tip->is_tip()) {
    throw MissingQuantity(fmt::format("no tip {}", name));
  }
  if (!tip->front_without_points.invalid_reason.empty()) {
    throw MissingQuantity(tip->front_without_points.invalid_reason);
  }
  return *tip;
}

void refuse_overlap(const results::LoadPathFront& tip, double t) {
  if (const std::string reason = invalid_k1_reason(tip.at(t)); !reason.empty()) {
    throw MissingQuantity(reason);
  }
}

// dK1/dt, at a knot that behind it.
double slope_at(CheckArguments& args, const results::RunResult& run) {
  const std::string tip_name = args.required_name("a crack");
  const std::string path_name = args.required_name("a load path");
  const double t = args.required_number("a place t");
  const results::LoadPathResult& path = find_load_path(run, path_name, t, args.optional_number());
  const results::LoadPathFront& tip = tip_of(path, tip_name);
  refuse_overlap(tip, t);
  const base::PiecewiseLinear& K1 = tip.single_point().K[0];
  std::size_t s = K1.find_segment(t);
  s += s + 1 < K1.segment_count() && K1.knots()[s + 1] <= t ? 1 : 0;
  return K1.slope(s);
}

double of_two(CheckArguments& args, const results::RunResult& run) {
  const std::string tip_name = args.required_name("a crack");
  const std::string path_name = args.required_name("a load path");
  const double from = args.required_number("a factor of FROM");
  const double to = args.required_number("a factor of TO");
  const results::LoadPathResult& path = path_of(run, path_name, args.optional_number());
  const results::LoadPathFront& tip = tip_of(path, tip_name);
  const std::optional<double> K1 =
      results::k_at_load_combination(path, tip.single_point(), 1, from, to);
  if (!K1) {
    throw MissingQuantity(
        path.homogeneous
            ? fmt::format("load path {} does not cover that ratio", path_name)
            : fmt::format("load path {}: gaps that no FIT scales are in it, so the two "
                          "factors must add up to 1",
                          path_name));
  }
  refuse_overlap(tip, to / (from + to));
  return *K1;
}

} // namespace

std::string invalid_k1_reason(const results::FrontResult& front) {
  const double of_mesh = front.is_tip() ? 1e-9 : 1e-2; // over K2 and K3
  const bool overlaps =
      std::ranges::any_of(front.points, [&](const results::FrontPointResult& place) {
        const double other = std::max(std::abs(place.K2), std::abs(place.K3));
        return !place.at_surface && place.K1 < 0.0 && std::abs(place.K1) > of_mesh * other;
      });
  if (!overlaps) {
    return {};
  }
  return front.is_tip() ? "K1 is negative there: the crack faces overlap, or the mesh at the tip "
                          "is too coarse"
                        : "K1 is negative at some points there: the crack faces overlap";
}

const results::LoadPathResult& find_load_path(const results::RunResult& run,
                                              const std::string& name, double t,
                                              std::optional<double> a) {
  const results::LoadPathResult& path = path_of(run, name, a);
  if (!(t >= path.t.front() && t <= path.t.back())) {
    throw MissingQuantity(fmt::format("load path {} goes from t = {:.6g} to {:.6g}{}{}", name,
                                      path.t.front(), path.t.back(),
                                      path.stopped.empty() ? "" : ": ", path.stopped));
  }
  return path;
}

double evaluate_path_quantity(CheckLine& line) {
  auto& [model, run, quantity, args] = line;
  if (quantity == "PATH.K1.SUM") {
    return of_two(args, run);
  }
  if (quantity == "PATH.KNOTS") {
    const std::string name = args.required_name("a load path");
    return static_cast<double>(path_of(run, name, args.optional_number()).t.size()) - 2.0;
  }
  if (quantity == "PATH.OPENING") {
    const std::string contact_name = args.required_name("a contact");
    const std::string name = args.required_name("a load path");
    const results::LoadPathResult& path = path_of(run, name, args.optional_number());
    const results::LoadPathContact* contact = results::find_contact(path, contact_name);
    if (contact == nullptr) {
      throw MissingQuantity(fmt::format("contact {} is not mounted", contact_name));
    }
    if (!contact->opening) {
      throw MissingQuantity(
          fmt::format("no closed pair of {} opens on load path {}", contact_name, name));
    }
    return *contact->opening;
  }
  return slope_at(args, run);
}

} // namespace spricka::program
