// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/refine/contact_places.hpp"

#include "estimate/error_bar.hpp"
#include "mesh/plane_element.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace spricka::analysis {

namespace {

constexpr double most_for_mouth = 1.2; // of a patch in one round because of its mouth alone
constexpr double most_for_faces = 2.0; // because of where its crack's faces part
// Surfaces whose elements at an edge are smaller than this part of the others' see it well enough.
constexpr double much_smaller = 0.7;

// Size of the patch's element at a place; 0 where the host goes on.
double patch_size(const results::CrackLengthResult& increment, const base::Vec2& at) {
  double closest = std::numeric_limits<double>::infinity();
  double size = 0.0;
  for (std::size_t e = increment.kept; e < increment.mesh.element_count(); ++e) {
    const double distance =
        (mesh::element_centroid(increment.mesh, base::ElementId(e)) - at).norm();
    if (distance < closest) {
      closest = distance;
      size = mesh::mean_side_length(increment.mesh, base::ElementId(e));
    }
  }
  // Farther off than one element the place belongs to the host.
  return closest < size ? size : 0.0;
}

const mesh::SizeMap::SizeRequest* nearest(const std::vector<mesh::SizeMap::SizeRequest>& list,
                                          const base::Vec2& at) {
  const auto found =
      std::ranges::min_element(list, {}, [&](const mesh::SizeMap::SizeRequest& request) {
        return (request.at - at).squaredNorm();
      });
  return found == list.end() ? nullptr : &*found;
}

} // namespace

base::CrackId crack_of_face_contact(const model::Model& model, const std::string& contact) {
  for (std::size_t c = 0; c < model.cracks.size(); ++c) {
    if (contact == model.cracks[c].name + ".FACES") {
      return base::CrackId(c);
    }
  }
  return {};
}

void add_points_that_widen_bar(const model::Model& model, const ExcessiveErrorBar& wide,
                               std::vector<RefinementPoint>& places) {
  const double may = most_of_bar * wide.allowed;
  if (wide.bar.edge <= may) {
    return;
  }
  // K changes by the pressure that one pair more takes: with the square of its distance
  // (tolerance.4).
  const double factor = std::max(least_factor, std::sqrt(may / wide.bar.edge));
  const double ends = estimate::share_of_set_change * wide.bar.set_change;
  for (const results::ContactResult& contact : wide.at.step.contacts) {
    for (std::size_t i = 1; i < contact.points.size() && ends > least_share * may; ++i) {
      const results::ContactPoint& a = contact.points[i - 1];
      const results::ContactPoint& b = contact.points[i];
      if ((a.state == results::ContactState::open) != (b.state == results::ContactState::open)) {
        const base::CrackId faces = crack_of_face_contact(model, contact.name);
        places.push_back({.at = 0.5 * (a.x + b.x).head<2>(),
                          .factor = factor,
                          .crack = faces,
                          .on_faces = faces.valid()});
      }
    }
    for (const base::Vec3& x : contact.unbounded) {
      if (wide.bar.edge - ends > least_share * may) {
        places.push_back({.at = x.head<2>(),
                          .factor = factor,
                          .crack = wide.at.crack,
                          .patch = patch_size(wide.at.increment, x.head<2>())});
      }
    }
  }
}

RefinedSizeRequests request_sizes_near_points(const std::vector<RefinementPoint>& places,
                                              const PresentElementSizes& elements,
                                              std::size_t cracks) {
  RefinedSizeRequests followers{{}, std::vector<double>(cracks, 1.0)};
  for (const RefinementPoint& place : places) {
    if (place.on_faces) {
      double& finer = followers.patch[place.crack.index()];
      finer = std::max(finer, std::min(1.0 / place.factor, most_for_faces));
      continue;
    }
    std::map<std::string, double> here; // size by net
    double largest = place.patch;
    for (const auto& [net, list] : elements.kept) {
      const auto cavity = elements.cut.find(net);
      const mesh::SizeMap::SizeRequest* own = nearest(list, place.at);
      const mesh::SizeMap::SizeRequest* cut =
          cavity == elements.cut.end() ? nullptr : nearest(cavity->second, place.at);
      const auto distance = [&](const mesh::SizeMap::SizeRequest* request) {
        return request == nullptr ? std::numeric_limits<double>::infinity()
                                  : (request->at - place.at).norm();
      };
      const bool in_patch = distance(cut) < distance(own);
      const mesh::SizeMap::SizeRequest* there = in_patch ? cut : own;
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
    // The patch is the coarsest at this mouth.
    if (place.patch > 0.0 && place.patch >= largest) {
      double& finer = followers.patch[place.crack.index()];
      finer = std::max(finer, std::min(1.0 / place.factor, most_for_mouth));
    }
  }
  return followers;
}

} // namespace spricka::analysis
