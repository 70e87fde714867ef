// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/bodies/condense_bodies.hpp"

#include "analysis/bodies/factorise_nets.hpp"
#include "analysis/bodies/net_work.hpp"
#include "base/parallel.hpp"
#include "model/model.hpp"

#include <optional>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace spricka::analysis {

namespace {

std::span<const std::int32_t> external_freedoms(const fe::DofMap& map) {
  return std::span(map.freedom).subspan(static_cast<std::size_t>(map.locals));
}

// Externals of a part are unknowns of the region or follow some, by construction of split().
fe::Superelement super_of(const Substructure& part) {
  fe::Superelement super;
  const std::span<const std::int32_t> rim = external_freedoms(part.map);
  super.freedom.assign(rim.begin(), rim.end());
  super.stiffness = &part.factor->schur();
  return super;
}

// What this increment did not use, no later one will: its crack has grown on.
void forget_unused(const std::vector<NetTask>& parts, const std::vector<NetTask>& regions,
                   CondensationCache& cache) {
  // Keys of nets and bodies are one set: a body has that of its region, early rows that of their
  // part.
  std::set<HashKey> used;
  for (const std::vector<NetTask>* tasks : {&parts, &regions}) {
    for (const NetTask& task : *tasks) {
      used.insert(task.key);
    }
  }
  std::erase_if(cache.nets, [&](const auto& entry) { return !used.contains(entry.first); });
  std::erase_if(cache.bodies, [&](const auto& entry) { return !used.contains(entry.first); });
  std::erase_if(cache.early, [&](const auto& entry) { return !used.contains(entry.first); });
}

solve::SubstructuredFactor factor_of(const SubstructuredBody& body) {
  std::vector<solve::FactorisedPart> parts;
  for (const std::unique_ptr<Substructure>& part : body.parts) {
    parts.push_back({part->factor, part->map.locals,
                     equation_numbers(body.region.map, external_freedoms(part->map))});
  }
  return {std::move(parts), body.region.factor, body.region.map.size()};
}

void condense_loads(const CondensationRequest& request, SubstructuredBody& body) {
  CondensedLoad load = condense_load(body, *request.ties, request.case_load);
  body.part_load = std::move(load.part);
  body.region_load = std::move(load.region);
  body.external_load = std::move(load.external);
}

} // namespace

bool externals_can_stay_factorised(const SubstructuredBody& body) {
  return body.parts.size() == 1 && body.free_rigid_modes.cols() == 0 && !body.is_uncondensed() &&
         body.region.map.external_count() > 0;
}

CondensedLoad condense_load(const SubstructuredBody& body, const fe::ConstraintTransformation& ties,
                            const base::Matrix& nodal) {
  CondensedLoad out;
  if (body.is_uncondensed()) {
    out.external = rows_of_freedoms(nodal, body.contact_freedoms());
    return out;
  }
  out.region = rows_of_freedoms(nodal, body.region.map.freedom);
  const auto add = [&](std::int32_t freedom, double c, const Eigen::RowVectorXd& load) {
    const std::int32_t row = body.region.map.row[static_cast<std::size_t>(freedom)];
    if (row >= 0) {
      out.region.row(row) += c * load;
    }
  };
  for (const std::unique_ptr<Substructure>& part : body.parts) {
    // What the part's locals hand over to its externals; their own loads are in already.
    const base::Matrix& load = out.part.emplace_back(rows_of_freedoms(nodal, part->map.freedom));
    const base::Matrix condensed = part->factor->condense_load(load);
    const std::vector<std::int32_t>& freedom = part->map.freedom;
    const auto locals = static_cast<std::size_t>(part->map.locals);
    for (std::size_t i = locals; i < freedom.size(); ++i) {
      const Eigen::RowVectorXd more = condensed.row(static_cast<Eigen::Index>(i - locals)) -
                                      load.row(static_cast<Eigen::Index>(i));
      const fe::ConstraintTransformation::DependentRow* tie = ties.find_row(freedom[i]);
      if (tie == nullptr) {
        add(freedom[i], 1.0, more);
        continue;
      }
      for (const fe::FreedomTerm& t : tie->terms) {
        add(t.freedom, t.coefficient, more);
      }
    }
  }
  out.external = body.region.factor->condense_load(out.region);
  return out;
}

std::vector<SubstructuredBody> condense_bodies(const CondensationRequest& request,
                                               CondensationCache& cache,
                                               CondensationStatistics& log) {
  std::vector<SubstructuredBody> bodies = partition_bodies(request);

  // All hashes first: what no net asks for is forgotten before memory for the new ones is needed.
  const std::vector<SubstructureHashes> keys = hash_bodies(request, bodies);
  std::vector<NetTask> parts;
  std::vector<NetTask> regions;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (std::size_t p = 0; p < bodies[b].parts.size(); ++p) {
      NetTask& part = parts.emplace_back();
      part.net = bodies[b].parts[p].get();
      part.key = keys[b].parts[p];
      part.work.name = substructure_name(request.model, request.mesh, bodies[b].name,
                                         {part.net->elements, bodies[b].region.elements});
    }
    NetTask& region = regions.emplace_back();
    region.net = &bodies[b].region;
    region.key = keys[b].region;
    region.layered = externals_can_stay_factorised(bodies[b]);
    region.work.name = bodies[b].name + (bodies[b].parts.empty() ? "" : ": region");
  }
  forget_unused(parts, regions, cache);

  factorise_nets(request, parts, cache, log);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    for (const std::unique_ptr<Substructure>& part : bodies[b].parts) {
      log.trouble =
          log.trouble ? log.trouble : factorisation_failure(request.mesh, bodies[b].name, *part);
      if (!log.trouble) {
        // A part's Schur complement enters the region as an element does.
        regions[b].supers.push_back(super_of(*part));
      }
    }
  }
  if (log.trouble) {
    return bodies;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (regions[b].layered) {
      // Rows that only the part has are eliminated once; they last as long as it does, whatever the
      // region becomes.
      regions[b].early = cache.early[keys[b].parts.front()];
    }
  }
  factorise_nets(request, regions, cache, log);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (regions[b].early) {
      cache.early[keys[b].parts.front()] = regions[b].early;
    }
  }
  for (const SubstructuredBody& body : bodies) {
    log.trouble =
        log.trouble ? log.trouble : factorisation_failure(request.mesh, body.name, body.region);
  }
  if (log.trouble) {
    return bodies;
  }

  base::parallel_for(bodies.size(), request.threads, [&](std::size_t b) {
    SubstructuredBody& body = bodies[b];
    condense_loads(request, body);
    if (body.contact_unknown_count() > 0) {
      // A factor from the cache has given its Schur complement away: what was made of that is kept
      // too.
      const auto known = cache.bodies.find(regions[b].key);
      if (known != cache.bodies.end()) {
        body.condensed = known->second;
        return;
      }
      if (body.is_uncondensed()) {
        const std::vector<std::int32_t> all = body.contact_freedoms();
        body.condensed = std::make_shared<contact::CondensedBody>(
            all, contact::UncondensedBody{factor_of(body), body.region.weighed},
            rows_of_freedoms(body.free_rigid_modes, all));
        return;
      }
      const std::vector<std::int32_t>& freedom = body.region.map.freedom;
      const auto locals = static_cast<std::size_t>(body.region.map.locals);
      std::vector<std::int32_t> external(freedom.begin() + body.region.map.locals, freedom.end());
      if (std::optional<solve::FactoredSchurComplement> factor =
              body.region.factor->take_factored_schur()) {
        body.condensed =
            std::make_shared<contact::CondensedBody>(std::move(external), std::move(*factor));
        return;
      }
      body.condensed = std::make_shared<contact::CondensedBody>(
          std::move(external), body.region.factor->take_schur(),
          rows_of_freedoms(body.free_rigid_modes, freedom, locals));
    }
  });
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (bodies[b].condensed) {
      if (!bodies[b].condensed->is_factorised() && !log.trouble) {
        log.trouble = base::OperationFailure{
            .kind = base::ProgramOutcome::not_solvable,
            .why = fmt::format("{}: the condensed stiffness is singular (a mechanism?)",
                               bodies[b].name)};
      }
      cache.bodies.emplace(regions[b].key, bodies[b].condensed);
    }
  }
  if (!log.trouble) {
    base::parallel_for(bodies.size(), request.threads, [&](std::size_t b) {
      SubstructuredBody& body = bodies[b];
      if (body.is_uncondensed()) {
        // A step adds these up, where a condensed body has a small matrix to ask.
        body.case_motion = body.condensed->displacements_under_forces(body.external_load);
      }
    });
  }
  return bodies;
}

void recover_body_displacements(const SubstructuredBody& body, const base::Matrix& u_external,
                                const CondensedLoad& load, double constant, base::Matrix& u) {
  const base::Matrix own =
      body.is_uncondensed() ? u_external : body.region.factor->recover(u_external, load.region);
  const std::vector<std::int32_t> freedoms =
      body.is_uncondensed() ? body.contact_freedoms() : body.region.map.freedom;
  for (std::size_t i = 0; i < freedoms.size(); ++i) {
    u.row(freedoms[i]) = own.row(static_cast<Eigen::Index>(i));
  }
  // Dependent freedoms as prescribed ones and constants alone move them: the loads of a part have
  // this in them already (reduced_case_loads).
  const bool parts_follow = !body.parts.empty() && !body.is_uncondensed();
  const base::Matrix given = parts_follow ? u : base::Matrix();
  if (body.region.map.ties) {
    for (Eigen::Index k = 0; k < u.cols(); ++k) {
      body.region.map.ties->set_dependent_displacements(u.col(k), constant);
    }
  }
  for (std::size_t p = 0; parts_follow && p < body.parts.size(); ++p) {
    const Substructure& part = *body.parts[p];
    const std::vector<std::int32_t>& freedom = part.map.freedom;
    const auto locals = static_cast<std::size_t>(part.map.locals);
    base::Matrix rim(static_cast<Eigen::Index>(freedom.size() - locals), u.cols());
    for (std::size_t i = locals; i < freedom.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i - locals);
      // Externals of the part as the region, and the ties, have moved them.
      rim.row(row) = u.row(freedom[i]);
      if (body.region.map.ties && body.region.map.ties->find_row(freedom[i]) != nullptr) {
        rim.row(row) -= given.row(freedom[i]);
      }
    }
    const base::Matrix all = part.factor->recover(rim, load.part[p]);
    for (std::size_t i = 0; i < locals; ++i) {
      u.row(freedom[i]) = all.row(static_cast<Eigen::Index>(i));
    }
  }
}

void recover_body_displacements(const SubstructuredBody& body, const base::Vector& u_external,
                                const base::Vector& case_factors, base::Vector& u) {
  CondensedLoad load;
  if (!body.is_uncondensed()) {
    load.region = body.region_load * case_factors;
  }
  for (const base::Matrix& part : body.part_load) {
    load.part.emplace_back(part * case_factors);
  }
  base::Matrix all = u;
  // Where ties have constants the last column is theirs; else there is nothing that it could scale.
  recover_body_displacements(body, u_external, load,
                             case_factors.size() > 0 ? case_factors.tail(1)[0] : 0.0, all);
  u = all.col(0);
}

} // namespace spricka::analysis
