// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/model.hpp"
#include "model/wanted_steps.hpp"
#include "report/drawing/file.hpp"
#include "report/drawing/set_members.hpp"
#include "report/report.hpp"
#include "report/units_line.hpp"
#include "results/k_quantities.hpp"
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
    std::string text = fmt::format("{}", increment_.mesh.node_label[n.index()]);
    for (int d = 0; d < increment_.mesh.dim; ++d) {
      text += fmt::format(",{}", x[d]);
    }
    return text;
  }

  [[nodiscard]] std::string nowhere() const {
    return std::string(static_cast<std::size_t>(increment_.mesh.dim), ',');
  }

  void fronts() {
    const int dim = increment_.mesh.dim;
    for (const results::FrontResult& front : step_.fronts) {
      if (front.name != request_.name && !front.name.starts_with(request_.name + ".")) {
        continue;
      }
      for (const results::FrontPointResult& point : front.points) {
        const std::string where =
            front.is_tip()
                ? nowhere()
                : fmt::format("{},{},{},{}", point.number, point.x.x(), point.x.y(), point.x.z());
        for (const results::KQuantity& q : results::k_quantities) {
          if (q.appears_in(results::in_output, dim) && q.is_number(front, point)) {
            row(where, results::output_column_name(q.name), q.extract_value(front, point));
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

ColumnUnits column_units(std::string_view axes) {
  using enum base::Quantity;
  ColumnUnits units;
  for (const char axis : axes) {
    units.add_column(length, std::string(1, axis));
  }
  for (const char* what : {"A", "U", "GAP"}) {
    units.add_column(length, what);
  }
  units.add_column(stress, "P");
  units.add_column(stress, "S");
  units.add_column(stress_intensity, "K");
  units.add_column(force, "REACTION");
  for (const results::KQuantity& q : results::k_quantities) {
    // those of tips; K and its bars all begin with K
    if (q.appears_in(results::in_output, 2) && q.kind != stress_intensity) {
      units.add_column(q.kind, results::output_column_name(q.name));
    }
  }
  return units;
}

} // namespace

void write_requested_csv(const std::filesystem::path& file, const model::Model& model,
                         const model::Output& output, const results::RunResult& run) {
  const std::string_view axes = std::string_view("xyz").substr(0, model.mesh.dim);
  std::string text =
      fmt::format("# units: {}\nincrement,step,quantity,name,node,{},component,value\n",
                  column_units(axes).units_text(model.units), fmt::join(axes, ","));
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
