// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "model/wanted_steps.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/set_members.hpp"
#include "report/report.hpp"
#include "report/units_line.hpp"
#include "results/output_word.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>

namespace spricka::report {

namespace {

/// Writes the rows of one request at one step's end.
class RequestedRows {
public:
  RequestedRows(const results::Increment& increment, const results::StepResult& step,
                const model::OutputRequest& request, std::string& text)
      : increment_(increment), step_(step), request_(request), text_(text) {}

  void write() {
    if (request_.quantity == "K") {
      tips();
      fronts();
    } else if (request_.quantity == "CPRESS") {
      pressures();
    } else if (request_.quantity == "REACTION") {
      reactions();
    } else if (request_.quantity == "U") {
      displacements();
    } else {
      stresses();
    }
  }

private:
  // `where` holds node,x,y, in space node,x,y,z, each of which may be empty.
  void row(const std::string& where, const std::string& component, double value) {
    fmt::format_to(std::back_inserter(text_), "{},{},{},{},{},{},{}\n", increment_.number,
                   step_.step, request_.quantity, request_.name, where, component, value);
  }

  [[nodiscard]] std::string place(base::NodeId n) const {
    const base::Vec3& x = increment_.mesh.x[n.index()];
    std::string text = fmt::format("{},{},{}", increment_.mesh.node_label[n.index()], x.x(), x.y());
    return increment_.mesh.dim == 3 ? fmt::format("{},{}", text, x.z()) : text;
  }

  [[nodiscard]] std::string nowhere() const { return increment_.mesh.dim == 3 ? ",,," : ",,"; }

  void tips() {
    for (const results::TipResult& tip : step_.tips) {
      if (tip.name == request_.name || tip.name.starts_with(request_.name + ".")) {
        for (const results::TipQuantity& q : results::tip_quantities) {
          if (q.appears_in(results::in_output) && q.is_number(tip)) {
            row(nowhere(), results::output_column_name(q.name), q.extract_value(tip));
          }
        }
      }
    }
  }

  void fronts() {
    for (const results::FrontResult& front : step_.fronts) {
      if (front.name != request_.name && !front.name.starts_with(request_.name + ".")) {
        continue;
      }
      for (const results::FrontPointResult& place : front.points) {
        const std::string where =
            fmt::format("{},{},{},{}", place.number, place.x.x(), place.x.y(), place.x.z());
        for (const results::FrontQuantity& q : results::front_quantities) {
          if (q.checked) {
            row(where, results::output_column_name(q.name), q.extract_value(place));
          }
        }
      }
    }
  }

  void pressures() {
    const results::ContactResult* contact = results::find_contact(step_, request_.name);
    if (contact == nullptr || !contact->mounted) {
      return;
    }
    for (const results::ContactPoint& p : contact->points) {
      for (const bool friction : {false, true}) {
        for (const results::ContactPointQuantity& q : results::point_quantities) {
          if (q.appears_in(results::in_pressure_output) && q.friction == friction &&
              (contact->rubs || !friction)) {
            row(place(p.node), results::output_column_name(q.name), q.extract_value(p));
          }
        }
      }
    }
  }

  [[nodiscard]] std::vector<base::NodeId> members() const {
    return set_members(increment_.mesh, request_.name);
  }

  void reactions() {
    base::Vec3 sum = base::Vec3::Zero();
    const int dim = increment_.mesh.dim;
    for (const base::NodeId n : members()) {
      sum.head(dim) += step_.reaction.segment(static_cast<Eigen::Index>(n.index()) * dim, dim);
    }
    for (int c = 0; c < dim; ++c) {
      row(nowhere(), axes[static_cast<std::size_t>(c)], sum[c]);
    }
  }

  void displacements() {
    const int dim = increment_.mesh.dim;
    for (const base::NodeId n : members()) {
      for (int c = 0; c < dim; ++c) {
        row(place(n), axes[static_cast<std::size_t>(c)],
            step_.u[static_cast<Eigen::Index>(n.index()) * dim + c]);
      }
    }
  }

  void stresses() {
    static constexpr std::array components{"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
    static constexpr std::array principal{"P1", "P2", "P3"};
    if (step_.stress.empty()) {
      return;
    }
    for (const StressPoint& at : stress_points(increment_.mesh, request_.name)) {
      const results::Stress& s = step_.stress[at.point];
      const std::string where = place(at.node);
      for (std::size_t c = 0; c < 6; ++c) {
        row(where, components[c], s[c]);
      }
      row(where, "MISES", results::von_mises(s));
      const std::array<double, 3> p = results::principal_stresses(s);
      for (std::size_t c = 0; c < 3; ++c) {
        row(where, principal[c], p[c]);
      }
    }
  }

  static constexpr std::array axes{"X", "Y", "Z"};

  const results::Increment& increment_;
  const results::StepResult& step_;
  const model::OutputRequest& request_;
  std::string& text_;
};

ColumnUnits units_of(bool solid) {
  using enum base::Quantity;
  ColumnUnits units;
  for (const char* coordinate : {"x", "y", "z"}) {
    if (solid || *coordinate != 'z') {
      units.add_column(length, coordinate);
    }
  }
  for (const char* what : {"A", "U", "GAP"}) {
    units.add_column(length, what);
  }
  units.add_column(stress, "P");
  units.add_column(stress, "S");
  units.add_column(stress_intensity, "K");
  units.add_column(force, "REACTION");
  for (const results::TipQuantity& q : results::tip_quantities) {
    if (q.appears_in(results::in_output) && q.kind != stress_intensity) { // which all begin with K
      units.add_column(q.kind, results::output_column_name(q.name));
    }
  }
  return units;
}

} // namespace

void write_requested_csv(const std::filesystem::path& file, const model::Model& model,
                         const model::Output& output, const results::RunResult& run) {
  const bool solid = model.mesh.dim == 3;
  std::string text =
      fmt::format("# units: {}\nincrement,step,quantity,name,node,x,y,{}component,value\n",
                  units_of(solid).units_text(model.units), solid ? "z," : "");
  for (const results::Increment& increment : run.increments) {
    const bool last = &increment == &run.increments.back();
    for (const std::size_t s : model::output_steps(model, output, last)) {
      for (const model::OutputRequest& request : output.requests) {
        RequestedRows(increment, increment.steps[s], request, text).write();
      }
    }
  }
  write_file(file, text);
}

} // namespace spricka::report
