// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/refinement_plan.hpp"

#include "estimate/error_bar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include <fmt/ranges.h>

namespace spricka::run {

namespace {

// The error of K falls with the q-th power of the element size: 3 to 4 away from the tip, where u
// and z are smooth; 3 asks for a little more than needed.
constexpr double q = 3.0;
constexpr double aim = 0.9;          // of what is allowed: a round more costs more than this margin
constexpr double least_factor = 0.3; // of an element's size in one round: eta is a guess
constexpr double most_finer = 2.0;   // of a patch in one round
constexpr double most_for_mouth = 1.2; // of it because of its mouth alone
constexpr double no_change = 0.95;     // of a size: not worth a new mesh
constexpr double most_of_bar = 0.3;    // of what is allowed that ends of contacts may take
constexpr double least_share = 0.2;    // of the error that patch and host may keep at least

/// One K whose bar is too large.
struct Entry {
  const results::Increment& increment;
  const results::StepResult& step;
  const results::TipResult& tip;
  const results::KBar& bar;
  int mode = 1;
  base::CrackId crack;
  double allowed = 0.0; ///< [stress intensity]
  double wanted = 0.0;  ///< TOL
};

/// The crack that a tip's name begins with: "C1", or "C1.2" of two tips.
base::CrackId crack_of(const model::Model& model, const std::string& tip) {
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    const std::string& name = model.cracks[c].name;
    if (tip == name || tip.starts_with(name + ".")) {
      return base::CrackId(c);
    }
  }
  return {};
}

std::optional<double> tolerance_of(const model::Model& model, base::CrackId crack) {
  for (const model::TipNet& tip : model.tip_nets) {
    if (tip.crack == crack) {
      return tip.tolerance;
    }
  }
  return std::nullopt;
}

// K below this part of the largest of the run is what round-off leaves of unloaded steps.
constexpr double no_K = 1e-9;

template <class F> void for_each_tip(const model::Model& model, const results::Run& run, F&& f) {
  double largest = 0.0;
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        largest = std::max(largest, std::hypot(tip.K1, tip.K2));
      }
    }
  }
  for (const results::Increment& increment : run.increments) {
    for (const results::StepResult& step : increment.steps) {
      for (const results::TipResult& tip : step.tips) {
        const std::optional<double> tolerance = tolerance_of(model, crack_of(model, tip.name));
        const bool loaded = std::hypot(tip.K1, tip.K2) > no_K * largest || !tip.doubt.empty();
        if (tolerance && loaded) {
          f(increment, step, tip, *tolerance);
        }
      }
    }
  }
}

std::vector<Entry> too_large(const model::Model& model, const results::Run& run) {
  std::vector<Entry> list;
  for_each_tip(model, run,
               [&](const results::Increment& increment, const results::StepResult& step,
                   const results::TipResult& tip, double tolerance) {
                 const double allowed = tolerance * std::hypot(tip.K1, tip.K2);
                 for (std::size_t m = 0; m < 2 && tip.no_bar.empty(); ++m) {
                   if (tip.bar[m].size() > allowed && allowed > 0.0) {
                     list.push_back({increment, step, tip, tip.bar[m], static_cast<int>(m) + 1,
                                     crack_of(model, tip.name), allowed, tolerance});
                   }
                 }
               });
  return list;
}

base::Vec2 centre_of(const model::Mesh& mesh, base::ElementId e) {
  const auto corners = static_cast<std::size_t>(base::info(mesh.type[e.index()]).corners);
  base::Vec2 sum = base::Vec2::Zero();
  for (const base::NodeId n : mesh.nodes_of(e).first(corners)) {
    sum += mesh.x[n.index()].head<2>();
  }
  return sum / static_cast<double>(corners);
}

double size_of(const model::Mesh& mesh, base::ElementId e) {
  const auto corners = static_cast<std::size_t>(base::info(mesh.type[e.index()]).corners);
  const std::span<const base::NodeId> nodes = mesh.nodes_of(e);
  double sum = 0.0;
  for (std::size_t i = 0; i < corners; ++i) {
    sum += (mesh.x[nodes[(i + 1) % corners].index()] - mesh.x[nodes[i].index()]).norm();
  }
  return sum / static_cast<double>(corners);
}

/// Factors on the sizes of one increment's host elements and of the patches, from its entries.
struct Factors {
  std::vector<double> host;  ///< [kept host element] of its size
  std::vector<double> patch; ///< [crack] to be divided by
};

double power_sum(const std::vector<double>& error, std::size_t from, std::size_t to, double power) {
  return std::accumulate(error.begin() + static_cast<std::ptrdiff_t>(from),
                         error.begin() + static_cast<std::ptrdiff_t>(to), 0.0,
                         [&](double sum, double e) { return sum + std::pow(std::abs(e), power); });
}

// Least freedoms sum f_e^-2 at a sum of |eta_e| f_e^q: f_e = c |eta_e|^(-1/(q + 2)).
void share_out(const Entry& entry, Factors& factors) {
  const std::vector<double>& error = entry.bar.of_element;
  const std::size_t kept = factors.host.size();
  const double patch = power_sum(error, kept, error.size(), 1.0);
  const double host = power_sum(error, 0, kept, 1.0);
  const double room = aim * (entry.allowed - entry.bar.floor -
                             std::min(entry.bar.edge, most_of_bar * entry.allowed));
  const double over = room > 0.0 ? entry.bar.mesh / room : 1.0 / std::pow(least_factor, q);
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
    double& finer = factors.patch[entry.crack.index()];
    finer = std::max(finer, std::min(std::pow(patch / for_patch, 1.0 / q), most_finer));
  }
  if (host <= for_host) {
    return;
  }
  const double c = std::pow(for_host / power_sum(error, 0, kept, 2.0 / (q + 2.0)), 1.0 / q);
  for (std::size_t e = 0; e < kept; ++e) {
    const double f = error[e] == 0.0 ? 1.0 : c * std::pow(std::abs(error[e]), -1.0 / (q + 2.0));
    factors.host[e] = std::min(factors.host[e], std::clamp(f, least_factor, 1.0));
  }
}

using Wishes = std::map<std::string, std::vector<mesh::SizeMap::Wish>>; // by net

/// A place on contact surfaces that needs smaller elements.
struct Place {
  base::Vec2 at;
  double factor = 1.0; ///< of the largest element there
  base::CrackId crack; ///< an edge of one surface whose pressure this crack feels; else invalid
  double patch = 0.0;  ///< size of a patch's element that has that edge
};

// Size of the patch's element at a place; 0 where the host goes on.
double patch_size(const results::Increment& increment, const base::Vec2& at) {
  double closest = std::numeric_limits<double>::infinity();
  double size = 0.0;
  for (std::size_t e = increment.kept; e < increment.mesh.element_count(); ++e) {
    const double distance = (centre_of(increment.mesh, base::ElementId(e)) - at).norm();
    if (distance < closest) {
      closest = distance;
      size = size_of(increment.mesh, base::ElementId(e));
    }
  }
  return closest < size ? size : 0.0;
}

// Where contact ends between two points that lie farther apart than K bears, and edges that it is
// closed up to.
void add_places(const Entry& entry, std::vector<Place>& places) {
  const double may = most_of_bar * entry.allowed;
  if (entry.bar.edge <= may) {
    return;
  }
  // K changes by the pressure that one pair more takes: with the square of its distance
  const double factor = std::max(least_factor, std::sqrt(may / entry.bar.edge));
  const double ends = estimate::share_of_flip * entry.bar.flip;
  for (const results::ContactResult& contact : entry.step.contacts) {
    for (std::size_t i = 1; i < contact.points.size() && ends > least_share * may; ++i) {
      const results::ContactPoint& a = contact.points[i - 1];
      const results::ContactPoint& b = contact.points[i];
      if ((a.state == results::ContactState::open) != (b.state == results::ContactState::open)) {
        places.push_back({0.5 * (a.x + b.x).head<2>(), factor, {}, 0.0});
      }
    }
    for (const base::Vec3& x : contact.unbounded) {
      if (entry.bar.edge - ends > least_share * may) {
        places.push_back(
            {x.head<2>(), factor, entry.crack, patch_size(entry.increment, x.head<2>())});
      }
    }
  }
}

const mesh::SizeMap::Wish* nearest(const std::vector<mesh::SizeMap::Wish>& list,
                                   const base::Vec2& at) {
  const auto found = std::ranges::min_element(
      list, {}, [&](const mesh::SizeMap::Wish& wish) { return (wish.at - at).squaredNorm(); });
  return found == list.end() ? nullptr : &*found;
}

/// Elements of the present mesh where they are and as large as they are, by net.
struct Elements {
  Wishes kept; ///< of the host
  Wishes cut;  ///< what patches stand in for
};

/// What follows the places.
struct Followers {
  Wishes nets;
  std::vector<double> patch; ///< [crack] its patch is to be finer by this
};

// Surfaces whose elements at an edge are smaller than this part of the others' see it well enough.
constexpr double much_smaller = 0.7;

// Nets whose nearest element is no further from a place than it is large follow it.
Followers followers_of(const std::vector<Place>& places, const Elements& elements,
                       std::size_t cracks) {
  Followers followers{{}, std::vector<double>(cracks, 1.0)};
  for (const Place& place : places) {
    std::map<std::string, double> here; // size by net
    double largest = place.patch;
    for (const auto& [net, list] : elements.kept) {
      const auto cavity = elements.cut.find(net);
      const mesh::SizeMap::Wish* own = nearest(list, place.at);
      const mesh::SizeMap::Wish* cut =
          cavity == elements.cut.end() ? nullptr : nearest(cavity->second, place.at);
      const auto distance = [&](const mesh::SizeMap::Wish* wish) {
        return wish == nullptr ? std::numeric_limits<double>::infinity()
                               : (wish->at - place.at).norm();
      };
      const bool in_patch = distance(cut) < distance(own);
      const mesh::SizeMap::Wish* there = in_patch ? cut : own;
      if (there != nullptr && distance(there) < there->size && !(in_patch && place.patch > 0.0)) {
        here.emplace(net, there->size);
        largest = std::max(largest, there->size);
      }
    }
    const double least = place.crack.valid() ? much_smaller * largest : 0.0;
    for (const auto& [net, size] : here) {
      if (size >= least) {
        followers.nets[net].push_back({place.at, place.factor * largest, true});
      }
    }
    if (place.patch > 0.0 && place.patch >= largest) {
      double& finer = followers.patch[place.crack.index()];
      finer = std::max(finer, std::min(1.0 / place.factor, most_for_mouth));
    }
  }
  return followers;
}

std::string net_of(const model::Model& model, const model::Mesh& mesh, std::size_t e) {
  return model.nets[mesh.element_net[e].index()].name;
}

// What patches stand in for keeps its size: it is cut out again.
void add_cavities(const model::Model& model, const results::Increment& increment, Wishes& wishes) {
  const model::Mesh& host = model.mesh;
  std::set<std::pair<std::int32_t, base::Label>> kept;
  for (std::size_t e = 0; e < increment.kept; ++e) {
    kept.emplace(increment.mesh.element_net[e].value, increment.mesh.element_label[e]);
  }
  for (std::size_t e = 0; e < host.element_count(); ++e) {
    if (!kept.contains({host.element_net[e].value, host.element_label[e]})) {
      wishes[net_of(model, host, e)].push_back(
          {centre_of(host, base::ElementId(e)), size_of(host, base::ElementId(e)), false});
    }
  }
}

// Part of a net's size that its errors ask for as a whole, for meshes that are refined evenly.
double even_factor(const model::Mesh& mesh, const Factors& factors, base::NetId net) {
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

} // namespace

Shortfall shortfall(const model::Model& model, const results::Run& run) {
  Shortfall worst;
  for_each_tip(model, run,
               [&](const results::Increment& increment, const results::StepResult& step,
                   const results::TipResult& tip, double tolerance) {
                 if (!tip.no_bar.empty()) {
                   worst.no_bar = fmt::format("{}, step {}: {}", tip.name, step.step, tip.no_bar);
                   return;
                 }
                 const double K = std::hypot(tip.K1, tip.K2);
                 for (std::size_t m = 0; m < 2 && K > 0.0; ++m) {
                   const double part = tip.bar[m].size() / K;
                   worst.below_floor = worst.below_floor || tip.bar[m].floor >= tolerance * K;
                   if (part / tolerance > worst.ratio) {
                     worst.ratio = part / tolerance;
                     worst.bar = part;
                     worst.wanted = tolerance;
                     worst.where = fmt::format("K{} of {}, step {}, a = {:.6g}", m + 1, tip.name,
                                               step.step, tip.a > 0.0 ? tip.a : increment.a);
                   }
                 }
               });
  return worst;
}

RefinementPlan::RefinementPlan(const model::Model& model) : finer_(model.cracks.size(), 1.0) {
  for (const model::TipNet& tip : model.tip_nets) {
    finer_[tip.crack.index()] = tip.finer;
  }
}

std::string RefinementPlan::refine(const model::Model& model, const results::Run& run) {
  std::vector<Entry> entries = too_large(model, run);
  Wishes wishes;
  Elements elements;
  std::map<std::string, double> even;
  std::vector<Place> places;
  std::vector<double> patch(model.cracks.size(), 1.0);
  for (const results::Increment& increment : run.increments) {
    Factors factors{std::vector<double>(increment.kept, 1.0), patch};
    for (const Entry& entry : entries) {
      if (&entry.increment == &increment) {
        if (entry.bar.edge <=
            entry.allowed) { // else eta, too, comes from contacts that are too coarse
          share_out(entry, factors);
        }
        add_places(entry, places);
      }
    }
    patch = factors.patch;
    add_cavities(model, increment, elements.cut);
    for (std::size_t e = 0; e < increment.kept; ++e) {
      const double f = factors.host[e];
      const std::string net = net_of(model, increment.mesh, e);
      const base::Vec2 centre = centre_of(increment.mesh, base::ElementId(e));
      const double size = size_of(increment.mesh, base::ElementId(e));
      elements.kept[net].push_back({centre, size, false});
      wishes[net].push_back({centre, f * size, f < no_change});
    }
    for (std::size_t n = 0; n < model.nets.size(); ++n) {
      double& f = even.try_emplace(model.nets[n].name, 1.0).first->second;
      f = std::min(f, even_factor(increment.mesh, factors, base::NetId(n)));
    }
  }
  const Followers followers = followers_of(places, elements, patch.size());
  for (const Wishes* more : {&std::as_const(elements.cut), &followers.nets}) {
    for (const auto& [net, list] : *more) {
      wishes[net].insert(wishes[net].end(), list.begin(), list.end());
    }
  }
  std::vector<std::string> moved;
  for (std::size_t c = 0; c < patch.size(); ++c) {
    patch[c] = std::max(patch[c], followers.patch[c]);
    if (patch[c] > 1.0 / no_change) {
      finer_[c] *= patch[c];
      moved.push_back(fmt::format("patch of {} {:.2f} times", model.cracks[c].name, patch[c]));
    }
  }
  for (auto& [net, list] : wishes) {
    const bool near_ends = followers.nets.contains(net);
    const double f = even[net];
    if (!near_ends && f >= no_change) {
      continue;
    }
    deck::Refinement& refinement = nets_[net];
    const auto sizes = std::make_shared<const mesh::SizeMap>(std::move(list));
    refinement.size = [sizes](double x, double y) { return (*sizes)({x, y}); };
    refinement.counts =
        static_cast<int>(std::ceil(refinement.counts / std::min(f, near_ends ? 0.7 : 1.0)));
    refinement.splits += 1;
    moved.push_back(fmt::format("{} {:.2f} times{}", net.empty() ? "the mesh" : "net " + net,
                                1.0 / f, near_ends ? ", most where contact ends" : ""));
  }
  return fmt::format("{}", fmt::join(moved, "; "));
}

void RefinementPlan::apply(model::Model& model) const {
  for (model::TipNet& tip : model.tip_nets) {
    tip.finer = finer_[tip.crack.index()];
  }
}

} // namespace spricka::run
