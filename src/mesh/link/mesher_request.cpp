// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/link/mesher_request.hpp"

#include "base/by_dimension.hpp"
#include "mesh/gmsh_elements.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spricka::mesh {
namespace {

constexpr base::ByDimension fill_kind{MesherFrameKind::fill, MesherFrameKind::fill_solid};
constexpr base::ByDimension filling_kind{MesherFrameKind::filling, MesherFrameKind::solid_filling};

ByteWriter frame(MesherFrameKind kind) {
  ByteWriter out;
  out.exchange_fields(kind);
  return out;
}

// What both sides write and read, in this order: `bytes` is a ByteWriter or a ByteReader.

template <class Bytes, class Region, class Sources>
void exchange_region(Bytes& bytes, Region& region, Sources& sources) {
  bytes.exchange_fields(region.points, region.boundaries, region.embedded);
  bytes.exchange_list(sources, [&](auto& source) {
    bytes.exchange_fields(source.at, source.size, source.growth, source.radius);
  });
}

template <class Bytes, class Fill> void exchange_fill(Bytes& bytes, Fill& filling) {
  bytes.exchange_fields(filling.added, filling.cells, filling.trouble);
}

template <class Bytes, class Import> void exchange_import(Bytes& bytes, Import& import) {
  bytes.exchange_fields(import.name, import.text, import.script, import.quadratic,
                        import.constants);
}

template <class Bytes, class Requests> void exchange_sizes(Bytes& bytes, Requests& requests) {
  bytes.exchange_list(requests, [&](auto& request) {
    bytes.exchange_fields(request.at, request.size, request.fresh);
  });
}

template <class Bytes, class Step> void exchange_step_request(Bytes& bytes, Step& step) {
  bytes.exchange_fields(step.solids, step.size, step.finer);
  bytes.exchange_list(step.groups, [&](auto& group) {
    bytes.exchange_fields(group.name, group.solid, group.faces, group.size);
  });
}

template <class Bytes, class Contents> void exchange_solids(Bytes& bytes, Contents& contents) {
  bytes.exchange_list(contents.solids, [&](auto& solid) {
    bytes.exchange_fields(solid.name, solid.volume, solid.low, solid.high);
    bytes.exchange_list(solid.faces, [&](auto& face) {
      bytes.exchange_fields(face.entity, face.kind, face.radius, face.hollow, face.direction,
                            face.area, face.centre, face.points);
    });
  });
  bytes.exchange_fields(contents.free_faces, contents.errors, contents.warnings, contents.gave_up);
}

bool is_finite(const StepFace& face) {
  return std::isfinite(face.radius) && std::isfinite(face.area) && face.direction.allFinite() &&
         face.centre.allFinite() &&
         std::ranges::all_of(face.points, [](const base::Vec3& x) { return x.allFinite(); });
}

template <class Bytes, class Model> void exchange_model(Bytes& bytes, Model& model) {
  bytes.exchange_fields(model.dim, model.node_tags, model.x);
  for (auto* const blocks : {&model.elements, &model.sides}) {
    bytes.exchange_list(*blocks, [&](auto& block) {
      bytes.exchange_fields(block.entity, block.type, block.type_name, block.tags, block.nodes);
    });
  }
  bytes.exchange_list(model.groups, [&](auto& group) {
    bytes.exchange_fields(group.dim, group.tag, group.name, group.entities, group.nodes);
  });
  bytes.exchange_list(model.constants, [&](auto& constant) {
    bytes.exchange_fields(constant.first, constant.second);
  });
  bytes.exchange_fields(model.errors, model.warnings, model.gave_up);
}

/// The nodes of a block are as many as its elements have, and these are of the right dimension.
bool belong_together(const GmshElementBlock& block, int dim) {
  const auto known = find_gmsh_element_type(block.type);
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

/// Whether the points that parts of a boundary, or cells, name are among `points`.
bool are_within(int point, std::size_t points) {
  return point >= 0 && static_cast<std::size_t>(point) < points;
}

template <class List> bool are_within(const List& list, std::size_t points) {
  return std::ranges::all_of(list, [&](const auto& item) { return are_within(item, points); });
}

} // namespace

template <int dim>
std::string encode_fill_request(const FillRegion<dim>& region, const SizeGrading<dim>& size) {
  ByteWriter out = frame(fill_kind.at(dim));
  exchange_region(out, region, size.sources());
  return out.release();
}

template <int dim>
bool decode_fill_request(ByteReader& in, FillRegion<dim>& region, SizeGrading<dim>& size) {
  std::vector<typename SizeGrading<dim>::SizeSource> sources;
  exchange_region(in, region, sources);
  for (const auto& source : sources) {
    size.add_size_source(source);
  }
  return in.at_end() && are_within(region.boundaries, region.points.size()) &&
         are_within(region.embedded, region.points.size());
}

template <int dim> std::string encode_fill_answer(const MeshFill<dim>& filling) {
  ByteWriter out = frame(filling_kind.at(dim));
  exchange_fill(out, filling);
  return out.release();
}

template <int dim>
bool decode_fill_answer(ByteReader& in, const FillRegion<dim>& region, MeshFill<dim>& filling) {
  if (in.read_value<MesherFrameKind>() != filling_kind.at(dim)) {
    return false;
  }
  exchange_fill(in, filling);
  return in.at_end() && are_within(filling.cells, region.points.size() + filling.added.size()) &&
         std::ranges::all_of(filling.added, [](const auto& x) { return x.allFinite(); });
}

template std::string encode_fill_request(const PlaneRegion&, const Grading&);
template std::string encode_fill_request(const SolidRegion&, const SolidGrading&);
template bool decode_fill_request(ByteReader&, PlaneRegion&, Grading&);
template bool decode_fill_request(ByteReader&, SolidRegion&, SolidGrading&);
template std::string encode_fill_answer(const TriangleFill&);
template std::string encode_fill_answer(const TetrahedronFill&);
template bool decode_fill_answer(ByteReader&, const PlaneRegion&, TriangleFill&);
template bool decode_fill_answer(ByteReader&, const SolidRegion&, TetrahedronFill&);

std::string encode_import_request(const MesherImportRequest& import) {
  ByteWriter out = frame(MesherFrameKind::import);
  exchange_import(out, import);
  out.exchange_fields(static_cast<bool>(import.size));
  if (import.size) {
    out.exchange_fields(import.size.scale);
    exchange_sizes(out, import.size.map->requests());
  }
  out.exchange_fields(import.step.has_value());
  if (import.step) {
    exchange_step_request(out, *import.step);
  }
  return out.release();
}

bool decode_import_request(ByteReader& in, MesherImportRequest& import) {
  exchange_import(in, import);
  if (in.read_value<char>() != 0) {
    in.exchange_fields(import.size.scale);
    std::vector<SizeMap::SizeRequest> requests;
    exchange_sizes(in, requests);
    import.size.map = std::make_shared<const SizeMap>(std::move(requests));
  }
  if (in.read_value<char>() != 0) {
    exchange_step_request(in, import.step.emplace());
  }
  return in.at_end();
}

std::string encode_model_answer(const GmshModel& model) {
  ByteWriter out = frame(MesherFrameKind::model);
  exchange_model(out, model);
  return out.release();
}

bool decode_model_answer(ByteReader& in, GmshModel& model) {
  exchange_model(in, model);
  const auto belongs = [&](int dim) {
    return [dim](const GmshElementBlock& block) { return belong_together(block, dim); };
  };
  return in.at_end() && std::ranges::all_of(model.elements, belongs(model.dim)) &&
         std::ranges::all_of(model.sides, belongs(model.dim - 1)) && model.dim >= 0 &&
         model.dim <= 3 && model.x.size() == 3 * model.node_tags.size() &&
         std::all_of(model.x.begin(), model.x.end(), [](double x) { return std::isfinite(x); });
}

std::string encode_describe_request(const StepFileText& file) {
  ByteWriter out = frame(MesherFrameKind::describe);
  out.exchange_fields(file.name, file.text);
  return out.release();
}

bool decode_describe_request(ByteReader& in, StepFileText& file) {
  in.exchange_fields(file.name, file.text);
  return in.at_end();
}

std::string encode_solids_answer(const StepFileContents& contents) {
  ByteWriter out = frame(MesherFrameKind::solids);
  exchange_solids(out, contents);
  return out.release();
}

bool decode_solids_answer(ByteReader& in, StepFileContents& contents) {
  exchange_solids(in, contents);
  return in.at_end() && std::ranges::all_of(contents.solids, [](const StepSolid& solid) {
           return std::isfinite(solid.volume) && solid.low.allFinite() && solid.high.allFinite() &&
                  std::ranges::all_of(solid.faces, is_finite);
         });
}

} // namespace spricka::mesh
