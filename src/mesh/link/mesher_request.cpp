// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/mesher_request.hpp"

#include "mesh/gmsh_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::mesh {
namespace {

ByteWriter frame(MesherFrameKind kind) {
  ByteWriter out;
  out.write_value(kind);
  return out;
}

void write(ByteWriter& out, const std::vector<GmshBlock>& blocks) {
  out.write_items(blocks, [&](const GmshBlock& block) {
    out.write_value(block.entity);
    out.write_value(block.type);
    out.write_text(block.type_name);
    out.write_list(block.tags);
    out.write_list(block.nodes);
  });
}

/// The nodes of a block are as many as its elements have, and these are of the right dimension.
bool belong_together(const GmshBlock& block, int dim) {
  const auto known = from_gmsh(block.type);
  if (known && base::element_info(known->type).dim != dim) {
    return false;
  }
  if (block.tags.empty()) {
    return block.nodes.empty();
  }
  return known ? block.nodes.size() ==
                     block.tags.size() *
                         static_cast<std::size_t>(base::element_info(known->type).nodes)
               : block.nodes.size() % block.tags.size() == 0;
}

std::vector<GmshBlock> read_blocks(ByteReader& in, int dim, bool& good) {
  return in.read_items([&] {
    GmshBlock block;
    block.entity = in.read_value<int>();
    block.type = in.read_value<int>();
    block.type_name = in.read_text();
    block.tags = in.read_list<std::size_t>();
    block.nodes = in.read_list<std::size_t>();
    good = good && belong_together(block, dim);
    return block;
  });
}

/// Whether the points that parts of a boundary, or cells, name are among `points`.
bool are_within(int point, std::size_t points) {
  return point >= 0 && static_cast<std::size_t>(point) < points;
}

template <class List> bool are_within(const List& list, std::size_t points) {
  return std::ranges::all_of(list, [&](const auto& item) { return are_within(item, points); });
}

} // namespace

template <int dim>
std::string fill_request(const FillRegion<dim>& region, const SizeGrading<dim>& size) {
  ByteWriter out = frame(dim == 2 ? MesherFrameKind::fill : MesherFrameKind::fill_solid);
  out.write_items(region.points, [&](const auto& x) { out.write_point(x); });
  for (const auto* list : {&region.boundaries, &region.embedded}) {
    out.write_items(*list, [&](const auto& boundary) { out.write_list(boundary); });
  }
  out.write_items(size.sources(), [&](const typename SizeGrading<dim>::SizeSource& source) {
    out.write_point(source.at);
    out.write_value(source.size);
    out.write_value(source.growth);
    out.write_value(source.radius);
  });
  return out.release();
}

template <int dim>
bool read_fill_request(ByteReader& in, FillRegion<dim>& region, SizeGrading<dim>& size) {
  region.points = in.read_items([&] { return in.read_point<dim>(); });
  for (auto* list : {&region.boundaries, &region.embedded}) {
    using Part = typename FillRegion<dim>::Boundary::value_type;
    *list = in.read_items([&] { return in.read_list<Part>(); });
  }
  const auto sources = in.read_items([&] {
    typename SizeGrading<dim>::SizeSource source;
    source.at = in.read_point<dim>();
    source.size = in.read_value<double>();
    source.growth = in.read_value<double>();
    source.radius = in.read_value<double>();
    return source;
  });
  for (const auto& source : sources) {
    size.add_source(source);
  }
  return in.at_end() && are_within(region.boundaries, region.points.size()) &&
         are_within(region.embedded, region.points.size());
}

template <int dim> std::string fill_answer(const MeshFill<dim>& filling) {
  ByteWriter out = frame(dim == 2 ? MesherFrameKind::filling : MesherFrameKind::solid_filling);
  out.write_items(filling.added, [&](const auto& x) { out.write_point(x); });
  out.write_list(filling.cells);
  out.write_text(filling.trouble);
  return out.release();
}

template <int dim>
bool read_fill_answer(ByteReader& in, const FillRegion<dim>& region, MeshFill<dim>& filling) {
  if (in.read_value<MesherFrameKind>() !=
      (dim == 2 ? MesherFrameKind::filling : MesherFrameKind::solid_filling)) {
    return false;
  }
  filling.added = in.read_items([&] { return in.read_point<dim>(); });
  filling.cells = in.read_list<std::array<int, dim + 1>>();
  filling.trouble = in.read_text();
  return in.at_end() && are_within(filling.cells, region.points.size() + filling.added.size()) &&
         std::ranges::all_of(filling.added, [](const auto& x) { return x.allFinite(); });
}

template std::string fill_request(const PlaneRegion&, const Grading&);
template std::string fill_request(const SolidRegion&, const SolidGrading&);
template bool read_fill_request(ByteReader&, PlaneRegion&, Grading&);
template bool read_fill_request(ByteReader&, SolidRegion&, SolidGrading&);
template std::string fill_answer(const TriangleFill&);
template std::string fill_answer(const TetrahedronFill&);
template bool read_fill_answer(ByteReader&, const PlaneRegion&, TriangleFill&);
template bool read_fill_answer(ByteReader&, const SolidRegion&, TetrahedronFill&);

std::string import_request(const MesherImport& import) {
  ByteWriter out = frame(MesherFrameKind::import);
  out.write_text(import.name);
  out.write_text(import.text);
  out.write_value(import.script);
  out.write_value(import.quadratic);
  out.write_texts(import.constants);
  out.write_value(static_cast<bool>(import.size));
  if (import.size) {
    out.write_value(import.size.scale);
    out.write_items(import.size.map->requests(), [&](const SizeMap::SizeRequest& request) {
      out.write_point(request.at);
      out.write_value(request.size);
      out.write_value(request.fresh);
    });
  }
  return out.release();
}

bool read_import_request(ByteReader& in, MesherImport& import) {
  import.name = in.read_text();
  import.text = in.read_text();
  import.script = in.read_value<bool>();
  import.quadratic = in.read_value<bool>();
  import.constants = in.read_texts();
  if (in.read_value<bool>()) {
    import.size.scale = in.read_value<double>();
    import.size.map = std::make_shared<const SizeMap>(in.read_items([&] {
      SizeMap::SizeRequest request;
    request.at = in.read_point<2>();
    request.size = in.read_value<double>();
    request.fresh = in.read_value<bool>();
    return request;
  }));
}
return in.at_end();
} // namespace spricka::mesh

std::string model_answer(const GmshModel& model) {
  ByteWriter out = frame(MesherFrameKind::model);
  out.write_value(model.dim);
  out.write_list(model.node_tags);
  out.write_list(model.x);
  write(out, model.elements);
  write(out, model.sides);
  out.write_items(model.groups, [&](const GmshGroup& group) {
    out.write_value(group.dim);
    out.write_value(group.tag);
    out.write_text(group.name);
    out.write_list(group.entities);
    out.write_list(group.nodes);
  });
  out.write_items(model.constants, [&](const auto& constant) {
    out.write_text(constant.first);
    out.write_value(constant.second);
  });
  out.write_texts(model.errors);
  out.write_texts(model.warnings);
  out.write_value(static_cast<char>(model.gave_up ? 1 : 0));
  return out.release();
}

bool read_model_answer(ByteReader& in, GmshModel& model) {
  bool good = true;
  model.dim = in.read_value<int>();
  model.node_tags = in.read_list<std::size_t>();
  model.x = in.read_list<double>();
  model.elements = read_blocks(in, model.dim, good);
  model.sides = read_blocks(in, model.dim - 1, good);
  model.groups = in.read_items([&] {
    GmshGroup group;
    group.dim = in.read_value<int>();
    group.tag = in.read_value<int>();
    group.name = in.read_text();
    group.entities = in.read_list<int>();
    group.nodes = in.read_list<std::size_t>();
    return group;
  });
  model.constants = in.read_items([&] {
    std::string name = in.read_text();
    return std::pair(std::move(name), in.read_value<double>());
  });
  model.errors = in.read_texts();
  model.warnings = in.read_texts();
  model.gave_up = in.read_value<char>() != 0;
  return in.at_end() && good && model.dim >= 0 && model.dim <= 3 &&
         model.x.size() == 3 * model.node_tags.size() &&
         std::all_of(model.x.begin(), model.x.end(), [](double x) { return std::isfinite(x); });
}

} // namespace spricka::mesh
