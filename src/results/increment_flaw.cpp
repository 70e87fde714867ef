// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/increment_flaw.hpp"

#include "base/element_type.hpp"
#include "model/property_points.hpp"
#include "results/store_fields.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

namespace spricka::results {

namespace {

/// The last word of an enumeration that files keep as a number.
template <class E> inline constexpr E last_of = E{};
template <>
inline constexpr SensitivityParameter last_of<SensitivityParameter> = SensitivityParameter::axis;
template <> inline constexpr ContactState last_of<ContactState> = ContactState::slip;

/// Looks through the fields of records, as the files have them, for indices of no node and no
/// element.
class IndexReader {
public:
  explicit IndexReader(const model::Mesh& mesh) : mesh_(mesh) {}

  [[nodiscard]] const std::string& flaw() const { return flaw_; }
  template <class T> void look(const char* name, const std::vector<T>& records) {
    (*this)(name, records);
  }

  template <class T> void operator()(const char* name, const T& value) {
    if constexpr (std::is_same_v<T, base::NodeId>) {
      within(name, value.value, mesh_.node_count());
    } else if constexpr (std::is_same_v<T, base::ElementId>) {
      within(name, value.value, mesh_.element_count());
    } else if constexpr (std::is_enum_v<T>) {
      within(name, static_cast<std::int64_t>(value), static_cast<std::size_t>(last_of<T>) + 1);
    } else if constexpr (requires { value.value_or(value); }) {
      if (value) {
        (*this)(name, *value);
      }
    } else if constexpr (std::is_same_v<T, base::Vec3> || std::is_same_v<T, Note>) {
      // numbers and words, which name nothing
    } else if constexpr (std::is_class_v<T> && requires(IndexReader & v) { fields(v, value); }) {
      fields(*this, value);
    }
  }
  void operator()(const char* /*name*/, const std::string& /*value*/) {}
  void operator()(const char* /*name*/, const base::PiecewiseLinear& /*value*/) {}
  template <class T> void operator()(const char* name, const std::vector<T>& values) {
    for (const T& value : values) {
      (*this)(name, value);
    }
  }
  template <class T, std::size_t n>
  void operator()(const char* name, const std::array<T, n>& values) {
    for (const T& value : values) {
      (*this)(name, value);
    }
  }

private:
  void within(const char* name, std::int64_t index, std::size_t count) {
    if (flaw_.empty() && (index < 0 || static_cast<std::size_t>(index) >= count)) {
      flaw_ = fmt::format("{} {} of {}", name, index, count);
    }
  }

  const model::Mesh& mesh_;
  std::string flaw_;
};

std::string flaw_of_connectivity(const model::Mesh& mesh) {
  const std::size_t elements = mesh.element_count();
  if (mesh.first.size() != elements + 1 || mesh.first.front() != 0) {
    return "elements without nodes";
  }
  for (std::size_t e = 0; e < elements; ++e) {
    const auto type = static_cast<std::size_t>(mesh.type[e]);
    if (type >= base::element_infos.size() ||
        mesh.first[e + 1] - mesh.first[e] != base::element_infos.at(type).nodes) {
      return fmt::format("element {} of no known type", e);
    }
  }
  if (static_cast<std::size_t>(mesh.first.back()) != mesh.nodes.size()) {
    return "nodes without an element";
  }
  return {};
}

std::string flaw_of_mesh(const model::Mesh& mesh) {
  const std::size_t nodes = mesh.node_count();
  const std::size_t elements = mesh.element_count();
  constexpr std::array known{2, 3};
  if (std::ranges::find(known, mesh.dim) == known.end()) {
    return fmt::format("a mesh of {} dimensions", mesh.dim);
  }
  if (mesh.node_label.size() != nodes || mesh.node_net.size() != nodes ||
      mesh.element_label.size() != elements || mesh.element_net.size() != elements ||
      mesh.property.size() != elements) {
    return "a mesh whose arrays are of different lengths";
  }
  if (std::string flaw = flaw_of_connectivity(mesh); !flaw.empty()) {
    return flaw;
  }
  IndexReader reader(mesh);
  reader.look("node", mesh.nodes);
  reader.look("node set", mesh.node_sets);
  reader.look("element set", mesh.element_sets);
  reader.look("face set", mesh.face_sets);
  for (const model::FaceSet& set : mesh.face_sets) {
    for (const model::Face& face : set.faces) {
      if (reader.flaw().empty() &&
          (face.side < 0 ||
           face.side >= base::element_info(mesh.type[face.element.index()]).sides)) {
        return fmt::format("side {} of an element", face.side);
      }
    }
  }
  return reader.flaw();
}

std::string flaw_of_contact(const ContactResult& contact) {
  const auto is_point = [&](int point) {
    return point >= 0 && static_cast<std::size_t>(point) < contact.points.size();
  };
  const bool whole =
      contact.corners.size() % 3 == 0 && std::ranges::all_of(contact.corners, is_point);
  return whole ? "" : fmt::format("corners of contact {}", contact.name);
}

std::string flaw_of_path(const LoadPathResult& path) {
  const std::size_t knots = path.t.size();
  for (const LoadPathFront& front : path.fronts) {
    if (front.points.empty()) {
      return fmt::format("points of front {} on path {}", front.front_without_points.name,
                         path.name);
    }
  }
  for (const LoadPathContact& contact : path.contacts) {
    if (contact.from.size() != contact.to.size() || contact.from.size() != contact.closed.size() ||
        contact.from.size() > knots) {
      return fmt::format("knots of contact {} on path {}", contact.name, path.name);
    }
  }
  return {};
}

std::string flaw_of_front(const FrontResult& front) {
  const auto fits = [&](const auto& side) {
    return side.empty() || side.size() == front.points.size();
  };
  const bool whole =
      !front.points.empty() &&
      std::ranges::all_of(front.sensitivities.by_parameter,
                          [&](const Sensitivity& s) { return fits(s.below) && fits(s.above); });
  return whole ? "" : fmt::format("points of front {}", front.name);
}

/// Arrays that a step has either for all of its mesh or not at all.
std::string flaw_of_lengths(const LoadStepResult& step, const model::Mesh& mesh,
                            std::size_t points) {
  const auto is = [](std::size_t size, std::size_t wanted) { return size == 0 || size == wanted; };
  const std::size_t vector = mesh.node_count() * static_cast<std::size_t>(mesh.dim);
  if (!is(static_cast<std::size_t>(step.u.size()), vector) ||
      !is(static_cast<std::size_t>(step.reaction.size()), vector) ||
      !is(static_cast<std::size_t>(step.temperature.size()), mesh.nodes.size()) ||
      !is(step.stress.size(), points) || !is(step.element_stress.size(), mesh.element_count())) {
    return fmt::format("arrays of step {} that are not as long as its mesh", step.step);
  }
  const auto bars_fit = [&](const auto& bars) {
    return std::ranges::all_of(bars, [&](const KErrorBar& bar) {
      return is(bar.of_element.size(), mesh.element_count());
    });
  };
  bool fit = true;
  for (const FrontResult& front : step.fronts) {
    fit = fit && std::ranges::all_of(front.points,
                                     [&](const FrontPointResult& p) { return bars_fit(p.bar); });
  }
  return fit ? "" : fmt::format("error bars of step {} for another mesh", step.step);
}

} // namespace

std::string describe_increment_corruption(const CrackLengthResult& increment) {
  const model::Mesh& mesh = increment.mesh;
  if (std::string flaw = flaw_of_mesh(mesh); !flaw.empty()) {
    return flaw;
  }
  if (increment.kept > mesh.element_count()) {
    return "more elements kept than there are";
  }
  IndexReader reader(mesh);
  reader.look("surface", increment.surface);
  reader.look("load path", increment.paths);
  for (const LoadPathResult& path : increment.paths) {
    if (std::string flaw = flaw_of_path(path); !flaw.empty()) {
      return flaw;
    }
  }
  const std::size_t points = model::property_points(mesh).node.size();
  for (const LoadStepResult& step : increment.steps) {
    reader.look("front", step.fronts);
    reader.look("contact", step.contacts);
    reader.look("error", step.errors);
    if (std::string flaw = flaw_of_lengths(step, mesh, points); !flaw.empty()) {
      return flaw;
    }
    for (const FrontResult& front : step.fronts) {
      if (std::string flaw = flaw_of_front(front); !flaw.empty()) {
        return flaw;
      }
    }
    for (const ContactResult& contact : step.contacts) {
      if (std::string flaw = flaw_of_contact(contact); !flaw.empty()) {
        return flaw;
      }
    }
  }
  return reader.flaw();
}

} // namespace spricka::results
