// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace spricka::mesh {
namespace {

class Writer {
public:
  template <class T> void one(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T> void list(const std::vector<T>& values, std::size_t first = 0) {
    one(values.size() - first);
    bytes.append(reinterpret_cast<const char*>(values.data() + first),
                 (values.size() - first) * sizeof(T));
  }
  void text(const std::string& value) {
    one(value.size());
    bytes += value;
  }

  std::string bytes;
};

class Reader {
public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <class T> T one() {
    T value{};
    take(&value, sizeof value);
    return value;
  }
  template <class T> void list(std::vector<T>& into) {
    const auto count = one<std::size_t>();
    if (count > rest_.size() / sizeof(T)) {
      sound_ = false;
      return;
    }
    const std::size_t first = into.size();
    into.resize(first + count);
    take(into.data() + first, count * sizeof(T));
  }
  std::string text() {
    const std::size_t count = std::min(one<std::size_t>(), rest_.size());
    std::string value(rest_.substr(0, count));
    rest_.remove_prefix(count);
    return value;
  }
  [[nodiscard]] bool sound() const { return sound_; }
  [[nodiscard]] bool at_end() const { return sound_ && rest_.empty(); }

private:
  void take(void* into, std::size_t size) {
    if (size > rest_.size()) {
      sound_ = false;
      return;
    }
    if (size > 0) {
      std::memcpy(into, rest_.data(), size);
    }
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
  bool sound_ = true;
};

/// A set of one kind: its name and its members.
template <class Set, class Members>
void write_sets(Writer& out, const std::vector<Set>& sets, std::size_t first, Members members) {
  out.one(sets.size() - first);
  for (std::size_t s = first; s < sets.size(); ++s) {
    out.text(sets[s].name);
    out.list(sets[s].*members);
  }
}

template <class Set, class Members>
void read_sets(Reader& in, base::Span span, Members members, std::vector<Set>& sets) {
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    Set set;
    set.name = in.text();
    in.list(set.*members);
    set.span = span;
    sets.push_back(std::move(set));
  }
}

bool fits(const model::Mesh& mesh) {
  const auto node = [&](base::NodeId n) { return n.valid() && n.index() < mesh.node_count(); };
  const auto element = [&](base::ElementId e) {
    return e.valid() && e.index() < mesh.element_count();
  };
  const auto face = [&](const model::Face& f) {
    return element(f.element) && f.side >= 0 &&
           f.side < base::info(mesh.type[f.element.index()]).sides;
  };
  std::size_t connected = 0;
  for (const base::ElementType type : mesh.type) {
    if (static_cast<std::size_t>(type) >= base::element_infos.size()) {
      return false;
    }
    connected += static_cast<std::size_t>(base::info(type).nodes);
  }
  const std::size_t n = mesh.element_count();
  return mesh.x.size() == mesh.node_label.size() && mesh.x.size() == mesh.node_net.size() &&
         mesh.nodes.size() == connected && mesh.element_label.size() == n &&
         mesh.element_net.size() == n && std::all_of(mesh.nodes.begin(), mesh.nodes.end(), node) &&
         std::all_of(mesh.node_sets.begin(), mesh.node_sets.end(),
                     [&](const model::NodeSet& s) {
                       return std::all_of(s.nodes.begin(), s.nodes.end(), node);
                     }) &&
         std::all_of(mesh.element_sets.begin(), mesh.element_sets.end(),
                     [&](const model::ElementSet& s) {
                       return std::all_of(s.elements.begin(), s.elements.end(), element);
                     }) &&
         std::all_of(mesh.face_sets.begin(), mesh.face_sets.end(), [&](const model::FaceSet& s) {
           return std::all_of(s.faces.begin(), s.faces.end(), face);
         });
}

void cut_back(model::Mesh& mesh, const MeshEnd& end, std::size_t connected, int dim) {
  mesh.dim = dim;
  mesh.x.resize(end.nodes);
  mesh.node_label.resize(end.nodes);
  mesh.node_net.resize(end.nodes);
  mesh.type.resize(end.elements);
  mesh.nodes.resize(connected);
  mesh.element_label.resize(end.elements);
  mesh.element_net.resize(end.elements);
  mesh.node_sets.resize(end.node_sets);
  mesh.element_sets.resize(end.element_sets);
  mesh.face_sets.resize(end.face_sets);
}

} // namespace

std::string to_bytes(const model::Mesh& mesh, const MeshEnd& end,
                     const base::Diagnostics& diagnostics) {
  Writer out;
  out.one(mesh.dim);
  out.one(mesh.node_count() - end.nodes);
  for (std::size_t n = end.nodes; n < mesh.node_count(); ++n) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      out.one(mesh.x[n][c]);
    }
  }
  out.list(mesh.node_label, end.nodes);
  out.list(mesh.node_net, end.nodes);
  out.list(mesh.type, end.elements);
  out.list(mesh.nodes, mesh.first.empty() ? 0 : static_cast<std::size_t>(mesh.first[end.elements]));
  out.list(mesh.element_label, end.elements);
  out.list(mesh.element_net, end.elements);
  write_sets(out, mesh.node_sets, end.node_sets, &model::NodeSet::nodes);
  write_sets(out, mesh.element_sets, end.element_sets, &model::ElementSet::elements);
  write_sets(out, mesh.face_sets, end.face_sets, &model::FaceSet::faces);
  out.one(diagnostics.all().size());
  for (const base::Diagnostic& d : diagnostics.all()) {
    out.one(d.severity);
    out.text(d.code);
    out.text(d.text);
    out.text(d.hint);
  }
  return std::move(out.bytes);
}

bool from_bytes(std::string_view bytes, base::Span span, model::Mesh& mesh,
                base::Diagnostics& diagnostics) {
  const MeshEnd end(mesh);
  const std::size_t connected = mesh.nodes.size();
  const int dim = mesh.dim;
  Reader in(bytes);
  mesh.dim = in.one<int>();
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    const auto x = in.one<double>();
    const auto y = in.one<double>();
    const auto z = in.one<double>();
    mesh.x.emplace_back(x, y, z);
  }
  in.list(mesh.node_label);
  in.list(mesh.node_net);
  in.list(mesh.type);
  in.list(mesh.nodes);
  in.list(mesh.element_label);
  in.list(mesh.element_net);
  read_sets(in, span, &model::NodeSet::nodes, mesh.node_sets);
  read_sets(in, span, &model::ElementSet::elements, mesh.element_sets);
  read_sets(in, span, &model::FaceSet::faces, mesh.face_sets);
  base::Diagnostics messages;
  for (auto count = in.one<std::size_t>(); count > 0 && in.sound(); --count) {
    const auto severity = in.one<base::Severity>();
    std::string code = in.text();
    std::string text = in.text();
    std::string hint = in.text();
    if (severity == base::Severity::error) {
      messages.error(span, std::move(code), std::move(text), std::move(hint));
    } else {
      messages.warning(span, std::move(code), std::move(text), std::move(hint));
    }
  }
  if (!in.at_end() || !fits(mesh)) {
    cut_back(mesh, end, connected, dim);
    return false;
  }
  if (mesh.first.empty()) {
    mesh.first.push_back(0);
  }
  for (std::size_t e = end.elements; e < mesh.element_count(); ++e) {
    mesh.first.push_back(mesh.first.back() + base::info(mesh.type[e]).nodes);
  }
  mesh.property.resize(mesh.element_count());
  for (const base::Diagnostic& d : messages.all()) {
    if (d.severity == base::Severity::error) {
      diagnostics.error(d.span, d.code, d.text, d.hint);
    } else {
      diagnostics.warning(d.span, d.code, d.text, d.hint);
    }
  }
  return true;
}

} // namespace spricka::mesh
