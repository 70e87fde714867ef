// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/scene/scene_ties.hpp"

#include "fe/ties.hpp"
#include "model/model.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

using model::FreedomRole;

base::SourceSpan span_of(const model::Model& model, std::size_t mpc) {
  if (mpc >= model.mpcs.size()) { // the rim of a crack's patch
    return model.cracks[mpc - model.mpcs.size()].span;
  }
  return std::visit([](const auto& m) { return m.span; }, model.mpcs[mpc]);
}

// Ties of patches that are finer than their host; they count on behind those of the deck.
void add_rims(const model::Model& model, const mesh::CrackedMesh& cracked,
              std::vector<fe::Tie>& ties) {
  const int dim = cracked.mesh.dim;
  for (const mesh::HangingNodeTie& rim : cracked.ties) {
    for (int c = 0; c < dim; ++c) {
      const auto freedom = [&](base::NodeId n) {
        return static_cast<std::int32_t>(n.index()) * dim + c;
      };
      fe::Tie tie;
      tie.mpc = model.mpcs.size() + rim.crack.index();
      tie.terms.push_back({freedom(rim.slave), 1.0});
      for (std::size_t i = 0; i < rim.master.size(); ++i) {
        tie.terms.push_back({freedom(rim.master[i]), -rim.weight[i]});
      }
      ties.push_back(std::move(tie));
    }
  }
}

std::string freedom_name(const model::Mesh& mesh, std::int32_t freedom) {
  const auto dim = static_cast<std::size_t>(mesh.dim);
  const auto at = static_cast<std::size_t>(freedom);
  return fmt::format("{} of node {}", "XYZ"[at % dim], mesh.node_label[at / dim]);
}

// A crack patch has taken the place of elements whose node an MPC names: what it tied is gone.
bool keep_their_nodes(const model::Model& model, const Discretisation& scene,
                      const std::vector<fe::Tie>& ties, base::Diagnostics& diagnostics) {
  if (model.cracks.empty()) {
    return true;
  }
  const model::Mesh& mesh = scene.cracked.mesh;
  const std::vector<bool> before = model::mark_nodes_in_use(model.mesh);
  const std::vector<bool> now = model::mark_nodes_in_use(mesh);
  for (const fe::Tie& tie : ties) {
    for (const fe::FreedomTerm& t : tie.terms) {
      const auto n = static_cast<std::size_t>(t.freedom / mesh.dim);
      if (n < before.size() && before[n] && !now[n]) {
        diagnostics.error(
            span_of(model, tie.mpc), "E414",
            fmt::format("a crack has cut out node {} that this $MPC ties", mesh.node_label[n]),
            "keep the crack's patch away from it: a smaller RADIUS on $TIPNET");
        return false;
      }
    }
  }
  return true;
}

// Every crack length makes its ties anew.
void warn_once(base::Diagnostics& diagnostics, const base::SourceSpan& span,
               const std::string& text) {
  const auto& all = diagnostics.messages();
  if (std::none_of(all.begin(), all.end(),
                   [&](const base::Diagnostic& d) { return d.text == text; })) {
    diagnostics.warning(span, "W503", text,
                        "let the fine side's elements end where the coarse ones do");
  }
}

} // namespace

void make_freedom_external(std::size_t freedom, const fe::ConstraintTransformation& ties,
                           std::vector<FreedomRole>& cls) {
  const auto raise = [&](std::size_t f) {
    cls[f] = cls[f] == FreedomRole::local ? FreedomRole::external : cls[f];
  };
  raise(freedom);
  if (const fe::ConstraintTransformation::DependentRow* row =
          ties.find_row(static_cast<std::int32_t>(freedom))) {
    for (const fe::FreedomTerm& t : row->terms) {
      raise(static_cast<std::size_t>(t.freedom));
    }
  }
}

bool eliminate_ties(const model::Model& model, Discretisation& scene,
                    base::Diagnostics& diagnostics) {
  std::vector<fe::TieFailure> troubles;
  std::vector<fe::Tie> ties = fe::make_ties(model, scene.cracked.mesh, troubles);
  bool good = keep_their_nodes(model, scene, ties, diagnostics);
  for (const fe::TieFailure& trouble : troubles) {
    if (trouble.severity == fe::TieSeverity::warning) {
      warn_once(diagnostics, span_of(model, trouble.mpc), fmt::format("$MPC: {}", trouble.why));
    } else if (trouble.severity == fe::TieSeverity::error) {
      diagnostics.error(span_of(model, trouble.mpc), "E415", fmt::format("$MPC: {}", trouble.why),
                        "SLAVE is the finer side; MASTER the faces of the coarser one that it "
                        "lies on");
      good = false;
    } else {
      scene.notes.push_back(fmt::format("$MPC: {}", trouble.why));
    }
  }
  add_rims(model, scene.cracked, ties);
  scene.ties = std::make_shared<const fe::ConstraintTransformation>(ties, scene.cls);
  for (const fe::ConstraintTransformation::DependentRow& row : scene.ties->rows()) {
    const auto freedom = static_cast<std::size_t>(row.freedom);
    // Contact acts on the masters of a freedom that follows them.
    if (scene.cls[freedom] == FreedomRole::external) {
      make_freedom_external(freedom, *scene.ties, scene.cls);
    }
    scene.cls[freedom] = FreedomRole::dependent;
  }
  if (!ties.empty()) {
    scene.notes.push_back(fmt::format("{} freedoms follow others by {} ties ({} redundant)",
                                      scene.ties->rows().size(), ties.size(),
                                      scene.ties->redundant_tie_count()));
  }
  return good;
}

bool prescribe_dependent_freedoms(const model::Model& model, Discretisation& scene,
                                  base::Diagnostics& diagnostics) {
  const fe::ConstraintTransformation& ties = *scene.ties;
  const auto cases = static_cast<Eigen::Index>(model.cases.size());
  bool good = true;
  for (const fe::ConstraintTransformation::FullyGivenTie& demand : ties.fully_given_ties()) {
    std::string why;
    // A tie all of whose freedoms are held asks something of what holds them.
    if (std::abs(demand.rhs) > 1e-9 * demand.scale) {
      why = fmt::format("it leaves 0 = {:.6g}", demand.rhs);
    }
    for (Eigen::Index c = 0; c < cases && why.empty(); ++c) {
      double sum = 0.0;
      double size = 0.0;
      for (const fe::FreedomTerm& t : demand.terms) {
        sum += t.coefficient * scene.case_displacement(t.freedom, c);
        size += std::abs(t.coefficient * scene.case_displacement(t.freedom, c));
      }
      if (std::abs(sum) > 1e-9 * size) {
        why = fmt::format("with the displacements of load case {} it leaves {:.6g} = 0",
                          model.cases[static_cast<std::size_t>(c)].name, sum);
      }
    }
    if (!why.empty()) {
      const std::string freedoms =
          demand.terms.empty()
              ? ""
              : fmt::format(" ({} and others)",
                            freedom_name(scene.cracked.mesh, demand.terms.front().freedom));
      diagnostics.error(
          span_of(model, demand.mpc), "E416",
          fmt::format("this $MPC contradicts other ties or supports{}: {}", freedoms, why));
      good = false;
    }
  }
  for (Eigen::Index c = 0; c < scene.case_displacement.cols(); ++c) {
    // Constants of ties have a column of their own and count in no case.
    ties.set_dependent_displacements(scene.case_displacement.col(c), c < cases ? 0.0 : 1.0);
  }
  return good;
}

} // namespace spricka::analysis
