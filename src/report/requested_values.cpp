// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/requested_values.hpp"

#include "model/property_points.hpp"
#include "results/k_quantities.hpp"
#include "results/output_word.hpp"
#include "results/stress_component.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace spricka::report {
namespace {

/// Nodes of the node or element set of that name, ascending, each once; empty without such a set.
std::vector<base::NodeId> set_members(const model::Mesh& mesh, std::string_view name) {
  std::vector<base::NodeId> found;
  for (const model::NodeSet& set : mesh.node_sets) {
    if (set.name == name) {
      found = set.nodes;
    }
  }
  for (const model::ElementSet& set : mesh.element_sets) {
    if (set.name == name) {
      for (const base::ElementId e : set.elements) {
        const std::span<const base::NodeId> own = mesh.element_nodes(e);
        found.insert(found.end(), own.begin(), own.end());
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Where the stresses of a set stand in the results (model/property_points.hpp), node by node: of
/// an element set those of its own elements' properties, of a node set all.
struct StressPoint {
  base::NodeId node;
  std::size_t point = 0;
};
/// The stress points of the sets of that name, ascending by node; empty without such a set.
std::vector<StressPoint> stress_points(const model::Mesh& mesh, std::string_view name) {
  const model::FieldPointsByProperty points = model::property_points(mesh);
  std::vector<bool> wanted(points.node.size(), false);
  for (const model::ElementSet& set : mesh.element_sets) {
    for (std::size_t i = 0; set.name == name && i < set.elements.size(); ++i) {
      const std::size_t e = set.elements[i].index();
      for (std::int32_t k = mesh.first[e]; k < mesh.first[e + 1]; ++k) {
        wanted[static_cast<std::size_t>(points.of[static_cast<std::size_t>(k)])] = true;
      }
    }
  }
  for (const model::NodeSet& set : mesh.node_sets) {
    if (set.name == name) {
      std::vector<bool> inside(mesh.node_count(), false);
      for (const base::NodeId n : set.nodes) {
        inside[n.index()] = true;
      }
      for (std::size_t p = 0; p < wanted.size(); ++p) {
        wanted[p] = wanted[p] || inside[points.node[p].index()];
      }
    }
  }
  std::vector<StressPoint> found;
  for (std::size_t p = 0; p < wanted.size(); ++p) {
    if (wanted[p]) {
      found.push_back({points.node[p], p});
    }
  }
  std::ranges::stable_sort(found, {}, &StressPoint::node);
  return found;
}

/// Collects the numbers of one request.
class RequestCollector {
public:
  RequestCollector(const results::CrackLengthResult& increment, const results::LoadStepResult& step,
                   const model::RequestedQuantity& request)
      : mesh_(increment.mesh), step_(step), request_(request) {}

  std::vector<RequestedValue> collect() {
    if (request_.quantity == "K") {
      add_fronts();
    } else if (request_.quantity == "CPRESS") {
      add_pressures();
    } else if (request_.quantity == "REACTION") {
      base::Vec3 sum = base::Vec3::Zero();
      for (const base::NodeId n : set_members(mesh_, request_.name)) {
        sum += at_node(step_.reaction, n);
      }
      add_vector({}, sum, base::QuantityKind::force);
    } else if (request_.quantity == "U") {
      for (const base::NodeId n : set_members(mesh_, request_.name)) {
        add_vector(place(n), at_node(step_.u, n), base::QuantityKind::length);
      }
    } else if (!step_.stress.empty()) {
      for (const StressPoint& at : stress_points(mesh_, request_.name)) {
        add_stress(place(at.node), step_.stress[at.point]);
      }
    }
    return std::move(values_);
  }

private:
  using Where = decltype(RequestedValue::where);

  [[nodiscard]] Where place(base::NodeId n) const {
    return std::pair(mesh_.node_label[n.index()], mesh_.x[n.index()]);
  }

  [[nodiscard]] base::Vec3 at_node(const base::Vector& vector, base::NodeId n) const {
    base::Vec3 value = base::Vec3::Zero();
    value.head(mesh_.dim) =
        vector.segment(static_cast<Eigen::Index>(n.index()) * mesh_.dim, mesh_.dim);
    return value;
  }

  void add_vector(const Where& where, const base::Vec3& vector, base::QuantityKind kind) {
    for (int c = 0; c < mesh_.dim; ++c) {
      values_.push_back({where, std::string(1, "XYZ"[c]), vector[c], kind});
    }
  }

  void add_stress(const Where& where, const results::Stress& stress) {
    for (std::size_t c = 0; c < stress.size(); ++c) {
      add_stress(where, results::stress_component_names[c], stress[c]);
    }
    add_stress(where, "MISES", results::von_mises(stress));
    const std::array<double, 3> p = results::principal_stresses(stress);
    for (std::size_t c = 0; c < p.size(); ++c) {
      add_stress(where, results::principal_stress_names[c], p[c]);
    }
  }

  void add_stress(const Where& where, std::string_view component, double value) {
    values_.push_back({where, std::string(component), value, base::QuantityKind::stress});
  }

  void add_fronts() {
    for (const results::FrontResult& front : step_.fronts) {
      for (const results::FrontPointResult& point : front.points) {
        for (const results::KQuantity& q : results::k_quantities) {
          if (request_names_front(request_, front) && q.appears_in(results::in_output, mesh_.dim) &&
              q.is_given_or_zero(front, point)) {
            const Where where(std::pair<base::Label, base::Vec3>(point.number, point.x));
            values_.push_back({front.is_tip() ? Where() : where,
                               results::uppercase_column_name(q.name),
                               q.extract_value(front, point), q.kind});
          }
        }
      }
    }
  }

  void add_pressures() {
    const results::ContactResult* contact = results::find_contact(step_, request_.name);
    if (contact == nullptr || !contact->mounted) {
      return;
    }
    for (const results::ContactPoint& p : contact->points) {
      for (const bool friction : {false, true}) {
        for (const results::ContactPointQuantity& q : results::point_quantities) {
          if (q.appears_in(results::in_pressure_output) && q.friction == friction &&
              (contact->rubs || !friction)) {
            values_.push_back({place(p.node), results::uppercase_column_name(q.name),
                               q.extract_value(p), q.kind});
          }
        }
      }
    }
  }

  const model::Mesh& mesh_;
  const results::LoadStepResult& step_;
  const model::RequestedQuantity& request_;
  std::vector<RequestedValue> values_;
};

} // namespace

std::vector<RequestedValue> collect_requested_values(const results::CrackLengthResult& increment,
                                                     const results::LoadStepResult& step,
                                                     const model::RequestedQuantity& request) {
  return RequestCollector(increment, step, request).collect();
}

bool request_names_front(const model::RequestedQuantity& request,
                         const results::FrontResult& front) {
  return front.name == request.name || front.name.starts_with(request.name + ".");
}

} // namespace spricka::report
