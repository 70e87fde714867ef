// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/topics/load_path_tables.hpp"

#include "model/model.hpp"
#include "report/drawing/file.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace spricka::report {

namespace {

constexpr double degrees_of_place = 180.0 / std::numbers::pi;

double printed_place(const results::LoadPathContact& contact, double place) {
  return contact.round ? place * degrees_of_place : place;
}

// "-PIN@152.3 +BUSH@90": pairs that open and close at this t; between solids "-PIN@36/0/7", the
// node's place.
std::string changes_at(const model::Mesh& mesh, const results::LoadPathResult& path, double t) {
  std::string text;
  for (const results::ContactStatusChange& change : path.changes) {
    if (change.t != t) {
      continue;
    }
    if (mesh.dim == 3) {
      const base::Vec3& x = mesh.x[change.node.index()];
      text += fmt::format("{}{}{}@{:.6g}/{:.6g}/{:.6g}", text.empty() ? "" : " ",
                          change.closes ? '+' : '-', change.contact, x.x(), x.y(), x.z());
      continue;
    }
    const results::LoadPathContact* contact = results::find_contact(path, change.contact);
    text += fmt::format("{}{}{}@{:.6g}", text.empty() ? "" : " ", change.closes ? '+' : '-',
                        change.contact,
                        contact == nullptr ? change.place : printed_place(*contact, change.place));
  }
  return text;
}

// The first modes of K at a knot, then their slopes before and behind it.
template <class Out>
void add_k_at_knot(Out out, const results::LoadPathFrontPoint& point, std::size_t modes,
                   std::size_t knot) {
  for (std::size_t mode = 0; mode < modes; ++mode) {
    fmt::format_to(out, ",{}", point.K[mode].at_knot(knot));
  }
  for (std::size_t mode = 0; mode < modes; ++mode) {
    fmt::format_to(out, ",{},{}", point.K[mode].slope_before(knot),
                   point.K[mode].slope_after(knot));
  }
}

struct PathPlace {
  std::size_t knot = 0;
  bool space = false;
};

void add_row(std::string& text, const std::vector<std::string>& contacts,
             const results::LoadPathResult& path, const PathPlace& at,
             const std::vector<std::string>& tips) {
  const std::size_t k = at.knot;
  auto out = std::back_inserter(text);
  for (const std::string& name : tips) {
    const results::LoadPathFront* tip = results::find_front(path, name);
    if (tip == nullptr) {
      text += ",,,,,,";
      continue;
    }
    add_k_at_knot(out, tip->tip(), 2, k);
  }
  for (const std::string& name : contacts) {
    const results::LoadPathContact* contact = results::find_contact(path, name);
    if (contact == nullptr) {
      text += ",,,";
      continue;
    }
    fmt::format_to(out, ",{}", contact->closed[k]);
    if (contact->closed[k] > 0 && !at.space) { // solids have no arcs
      fmt::format_to(out, ",{},{}", printed_place(*contact, contact->from[k]),
                     printed_place(*contact, contact->to[k]));
    } else {
      text += ",,";
    }
  }
  text += '\n';
}

// One row for each point of a front at a knot.
template <class Out>
void add_front(Out out, int increment, const results::LoadPathResult& path,
               const results::LoadPathFront& front, std::size_t k) {
  for (const results::LoadPathFrontPoint& point : front.points) {
    fmt::format_to(out, "{},{},{},{},{},{:d},{},", increment, path.name, path.t[k], front.is.name,
                   point.is.number, point.is.at_surface, point.is.s);
    if (front.is.has_angles) {
      fmt::format_to(out, "{}", point.is.phi * degrees_of_place);
    }
    fmt::format_to(out, ",{},{},{}", point.is.x.x(), point.is.x.y(), point.is.x.z());
    add_k_at_knot(out, point, point.K.size(), k);
    fmt::format_to(out, "\n");
  }
}

std::vector<std::string> path_tip_names(const results::RunResult& run) {
  std::vector<std::string> names;
  for (const results::Increment& increment : run.increments) {
    for (const results::LoadPathResult& path : increment.paths) {
      for (const results::LoadPathFront& front : path.fronts) {
        if (front.is_tip() && std::ranges::find(names, front.is.name) == names.end()) {
          names.push_back(front.is.name);
        }
      }
    }
  }
  return names;
}

// The deck's contacts, and the faces of its cracks where they touch.
std::vector<std::string> contact_names(const model::Model& model, const results::RunResult& run) {
  std::vector<std::string> names;
  for (const model::Contact& contact : model.contacts) {
    names.push_back(contact.name);
  }
  for (const results::Increment& increment : run.increments) {
    for (const results::LoadPathResult& path : increment.paths) {
      for (const results::LoadPathContact& contact : path.contacts) {
        if (std::ranges::find(names, contact.name) == names.end()) {
          names.push_back(contact.name);
        }
      }
    }
  }
  return names;
}

} // namespace

void write_load_path_csv(const std::filesystem::path& file, const model::Model& model,
                         const results::RunResult& run) {
  if (model.load_paths.empty()) {
    return;
  }
  const std::vector<std::string> tips = path_tip_names(run);
  std::string text = fmt::format(
      "# units: K1 K2 and slopes by t [{}], from to [deg] on circles, else [{}], t [1]\n"
      "increment,path,t,changes",
      model.units.stress_intensity_name(), model.units.length_name);
  for (const std::string& tip : tips) {
    text += fmt::format(",{0}.K1,{0}.K2,{0}.dK1_before,{0}.dK1_after,{0}.dK2_before,{0}.dK2_after",
                        tip);
  }
  const std::vector<std::string> contacts = contact_names(model, run);
  for (const std::string& contact : contacts) {
    text += fmt::format(",{0}.closed,{0}.from,{0}.to", contact);
  }
  text += '\n';
  for (const results::Increment& increment : run.increments) {
    for (const results::LoadPathResult& path : increment.paths) {
      for (std::size_t k = 0; k < path.t.size(); ++k) {
        text += fmt::format("{},{},{},{}", increment.number, path.name, path.t[k],
                            changes_at(increment.mesh, path, path.t[k]));
        add_row(text, contacts, path, {k, increment.mesh.dim == 3}, tips);
      }
    }
  }
  write_file(file, text);
}

void write_load_path_fronts_csv(const std::filesystem::path& file, const model::Model& model,
                                const results::RunResult& run) {
  if (model.load_paths.empty() || model.mesh.dim != 3 || model.cracks.empty()) {
    return;
  }
  std::string text = fmt::format(
      "# units: K1 K2 K3 and slopes by t [{}], s x y z [{}], phi [deg], t [1]\n"
      "increment,path,t,crack,point,at_surface,s,phi,x,y,z,K1,K2,K3,dK1_before,dK1_after,"
      "dK2_before,dK2_after,dK3_before,dK3_after\n",
      model.units.stress_intensity_name(), model.units.length_name);
  auto out = std::back_inserter(text);
  for (const results::Increment& increment : run.increments) {
    for (const results::LoadPathResult& path : increment.paths) {
      for (std::size_t k = 0; k < path.t.size(); ++k) {
        for (const results::LoadPathFront& front : path.fronts) {
          add_front(out, increment.number, path, front, k);
        }
      }
    }
  }
  write_file(file, text);
}

} // namespace spricka::report
