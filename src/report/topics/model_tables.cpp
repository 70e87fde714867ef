// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/model_tables.hpp"

#include "base/tidy.hpp"
#include "model/model.hpp"
#include "report/drawing/columns.hpp"
#include "report/topics/dimension_columns.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace spricka::report {

std::string deck_units_note(const base::UnitSystem& units) {
  return units.output.is_any()
             ? fmt::format(
                   "The deck itself, and with it warnings and notes, are in {}, {}, {}, {}.",
                   units.length_name, units.force_name, units.stress_name(),
                   units.stress_intensity_name())
             : std::string();
}

std::string symmetry_note(const model::Model& model) {
  std::string sides;
  for (const model::MirrorPlane& plane : model.mirrors) {
    sides += fmt::format(
        "{}{} {} {:.6g}", sides.empty() ? "" : ", ", "xyz"[plane.axis],
        plane.above ? ">=" : "<=", model.units.output_length().from_deck(plane.at.value_or(0.0)));
  }
  return sides.empty() ? sides
                       : fmt::format("Symmetry: only the part {} is modelled. Forces, energies and "
                                     "areas are those of this part.",
                                     sides);
}

namespace {

/// What a net has of each kind.
struct NetCount {
  std::string name;
  std::size_t nodes = 0;
  std::size_t elements = 0;
  std::string types;
};

NetCount count_net(const model::Mesh& mesh, const std::vector<bool>& used, base::NetId net) {
  NetCount found;
  for (std::size_t i = 0; i < used.size(); ++i) {
    found.nodes += used[i] && mesh.node_net[i] == net ? 1 : 0;
  }
  std::array<std::size_t, base::element_infos.size()> count{};
  for (std::size_t e = 0; e < mesh.element_count(); ++e) {
    if (mesh.element_net[e] == net) {
      ++count[static_cast<std::size_t>(mesh.type[e])];
      ++found.elements;
    }
  }
  for (std::size_t t = 0; t < count.size(); ++t) {
    if (count[t] > 0) {
      found.types += fmt::format("{}{} {}", found.types.empty() ? "" : ", ", count[t],
                                 base::element_infos[t].name);
    }
  }
  return found;
}

const std::string& master_name(const model::Model& model, const model::Contact& contact) {
  return contact.rigid.valid() ? model.rigids[contact.rigid.index()].name
                               : model.mesh.set_with_id(contact.master).name;
}

} // namespace

ReportTable net_size_table(const model::Model& model) {
  const std::vector<bool> used = model::mark_nodes_in_use(model.mesh);
  std::vector<NetCount> nets;
  for (std::size_t n = 0; n < model.nets.size(); ++n) {
    NetCount net = count_net(model.mesh, used, base::NetId(n));
    net.name = model.nets[n].name.empty() ? "(deck)" : model.nets[n].name;
    if (net.nodes > 0 || net.elements > 0) {
      nets.push_back(std::move(net));
    }
  }
  return Columns<NetCount>()
      .words("net", &NetCount::name)
      .number("nodes", "", &NetCount::nodes)
      .number("elements", "", &NetCount::elements)
      .words("of type", &NetCount::types)
      .table("Nets", nets);
}

ReportTable property_table(const model::Model& model) {
  using Property = model::ElementProperty;
  static constexpr std::array state{"plane stress", "plane strain", "axisymmetric", "solid"};
  const auto material = [&](const Property& p) -> const model::ElasticMaterial& {
    return model.materials[p.material.index()];
  };
  Columns<Property> columns;
  columns
      .words("elements", [&](const Property& p) { return model.mesh.set_with_id(p.elements).name; })
      .words("material", [&](const Property& p) { return material(p).name; })
      .number("E", model.units.output_stress(), [&](const Property& p) { return material(p).E; })
      .number(
          "nu", "", [&](const Property& p) { return material(p).nu; }, "{:.4g}")
      .words("state", [](const Property& p) { return state[static_cast<std::size_t>(p.state)]; })
      .fill_only_if([](const Property& p) {
        return p.state == model::StressState::plane_stress ||
               p.state == model::StressState::plane_strain;
      })
      .number("thickness", model.units.output_length(), &Property::thickness);
  return columns.table("Properties", model.properties);
}

ReportTable contact_pair_table(const model::Model& model) {
  using model::Contact;
  const base::OutputUnit length = model.units.output_length();
  Columns<Contact> columns;
  columns.words("contact", &Contact::name)
      .words("slave", [&](const Contact& c) { return model.mesh.set_with_id(c.slave).name; })
      .words("master", [&](const Contact& c) { return master_name(model, c); })
      .words("type",
             [](const Contact& c) {
               return c.type == model::ContactType::bonded ? "bonded" : "unilateral";
             })
      .words("pairing",
             [](const Contact& c) {
               return c.pairing == model::PairingMethod::node ? "node" : "segment";
             })
      .number("declared gap", length.name,
              [length](const Contact& c) {
                return c.gap ? cell_text(length.from_deck(*c.gap)) : "measured";
              })
      .number("mu", "", &Contact::mu, "{:.4g}");
  return columns.table("Contacts", model.contacts);
}

ReportTable rigid_target_table(const model::Model& model) {
  using Target = model::RigidTarget;
  using Shape = model::RigidTargetShape;
  static constexpr std::array shapes{"line", "arc", "plane", "cylinder", "cone", "sphere"};
  const base::OutputUnit unit = model.units.output_length();
  const int dim = model.mesh.dim;
  Columns<Target> columns;
  columns.words("target", &Target::name)
      .words("shape",
             [](const Target& r) {
               return fmt::format("{}{}", shapes[static_cast<std::size_t>(r.shape)],
                                  r.radius < 0.0 || r.second_radius < 0.0 ? ", a bore" : "");
             })
      .words(
          "from or centre",
          [=](const Target& r) { return base::format_coordinates(r.first, dim, unit); }, unit.name)
      .fill_only_if(
          [](const Target& r) { return r.shape != Shape::arc && r.shape != Shape::sphere; })
      .words(
          "to", [=](const Target& r) { return base::format_coordinates(r.second, dim, unit); },
          unit.name)
      .fill_only_if([](const Target& r) { return r.radius != 0.0 || r.second_radius != 0.0; })
      .number("radius", unit.name, [unit](const Target& r) {
        const std::string radius = cell_text(unit.from_deck(std::abs(r.radius)));
        return r.shape == Shape::cone
                   ? fmt::format("{} to {:.6g}", radius, unit.from_deck(std::abs(r.second_radius)))
                   : radius;
      });
  return columns.table("Rigid targets", model.rigids);
}

ReportTable load_total_table(const std::vector<results::LoadTotal>& loads,
                             const base::UnitSystem& units, int dim) {
  using Total = results::LoadTotal;
  const base::OutputUnit force = units.output_force();
  base::OutputUnit moment = force * units.output_length();
  moment.name = force.name + " " + units.output_length().name;
  Columns<Total> columns;
  columns.words("case", &Total::load_case);
  for (int d = 0; d < dim; ++d) {
    columns.number(fmt::format("F{}", "xyz"[d]), force,
                   [d](const Total& load) { return load.force[d]; });
  }
  for (const char axis : dimension_columns.at(dim).moment_axes) {
    columns.number(fmt::format("M{}", axis), moment,
                   [d = axis - 'x'](const Total& load) { return load.moment[d]; });
  }
  return columns.table(
      "Load cases: totals with factor 1 (moments about the origin; without loads on crack faces)",
      loads);
}

namespace {

ReportTable script_constant_table(const std::vector<results::ReportedScriptConstant>& constants) {
  using Constant = results::ReportedScriptConstant;
  return Columns<Constant>()
      .words("script", &Constant::file)
      .words("constant", &Constant::name)
      .number("value", "", &Constant::value)
      .words("from", &Constant::from)
      .table("Constants of geometry scripts", constants);
}

/// Numbers that round-off leaves of zero are zero.
std::string place_words(const base::Vec3& x, double size, const base::OutputUnit& unit = {}) {
  constexpr double little = 1e-7;
  const auto number = [&](double value) {
    return std::abs(value) < little * size ? 0.0 : unit.from_deck(value);
  };
  return fmt::format("{:.6g} {:.6g} {:.6g}", number(x.x()), number(x.y()), number(x.z()));
}

ReportTable solid_table(const std::vector<results::ReportedSolid>& solids,
                        const base::OutputUnit& length) {
  using Solid = results::ReportedSolid;
  const auto corner = [length](const base::Vec3& x, const Solid& s) {
    return place_words(x, (s.high - s.low).norm(), length); // of a box that is a little larger
  };
  return Columns<Solid>()
      .words("file", &Solid::file)
      .number("number", "", &Solid::number)
      .words("SOLID", &Solid::name)
      .words("set",
             [](const Solid& s) {
               return s.sets.empty() ? "not meshed" : fmt::format("{}", fmt::join(s.sets, " "));
             })
      .number("volume", base::raised(length, 3), &Solid::volume)
      .words(
          "from", [&](const Solid& s) { return corner(s.low, s); }, length.name)
      .words(
          "to", [&](const Solid& s) { return corner(s.high, s); }, length.name)
      .table("Solids of STEP files", solids);
}

ReportTable solid_face_table(const std::vector<results::ReportedSolidFace>& faces,
                             const base::OutputUnit& length) {
  using Face = results::ReportedSolidFace;
  Columns<Face> columns;
  columns.words("face", [](const Face& f) { return fmt::format("{}", fmt::join(f.sets, " ")); })
      .words("kind", &Face::kind);
  columns.fill_only_if([](const Face& f) { return f.radius > 0.0; });
  columns.number("radius", length, &Face::radius);
  columns.fill_only_if([](const Face& f) { return f.direction.norm() > 0.0; });
  columns.words("normal or axis", [](const Face& f) { return place_words(f.direction, 1e3); });
  columns.fill_only_if([](const Face&) { return true; });
  columns.number("area", base::raised(length, 2), &Face::area);
  columns.words(
      "centre",
      [length](const Face& f) { return place_words(f.centre, std::sqrt(f.area), length); },
      length.name);
  return columns.table("Faces of solids", faces);
}

} // namespace

std::string imported_geometry_section(const results::ReportedGeometry& geometry,
                                      const base::OutputUnit& length) {
  return to_text_after_blank_line(script_constant_table(geometry.scripts)) +
         to_text_after_blank_line(solid_table(geometry.solids, length)) +
         to_text_after_blank_line(solid_face_table(geometry.faces, length));
}

} // namespace spricka::report
