// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "base/source.hpp"
#include "model/forward.hpp"
#include "results/load_total.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <string>

/// Writers: each makes one file of the run folder from the results. All throw std::system_error
/// when a file cannot be written; each file is written under a temporary name and renamed.
namespace spricka::report {

/// k.csv: a line with the units, then a row for each step end and point of a front, in the plane
/// tip: increment, step, crack, in space a, point and whether it is at the surface and closed, and
/// the quantities that belong there (results/k_quantities.hpp).
void write_k_csv(const std::filesystem::path& file, const model::Model& model,
                 const results::RunResult& run);

/// pressure.csv: the same of contact points (results/contact_point.hpp): increment, step, contact,
/// quantities; theta in degrees; both faces of a crack mouth are rows of their own.
void write_pressure_csv(const std::filesystem::path& file, const model::Model& model,
                        const results::RunResult& run);

/// The table that a card $OUTPUT FORMAT=CSV asks for, one value a row:
/// increment,step,quantity,name,node,x,y,component,value; in space z behind y. EVERY=STEP: each
/// step; INCREMENT: KMAX of a growth run, else the last step, of each length; END: that step of the
/// last length.
void write_requested_csv(const std::filesystem::path& file, const model::Model& model,
                         const model::OutputFileRequest& output, const results::RunResult& run);

/// One .vtu for an increment and step: cells of all types, displacement, reaction, stress (6
/// components, principal, von Mises; nodal and mean of each element), net number. A node where
/// properties meet is one point for each, so that stresses may jump. Appended binary, zlib.
void write_step_vtu(const std::filesystem::path& file, const model::Model& model,
                    const results::CrackLengthResult& increment,
                    const results::LoadStepResult& step);

/// The surfaces of the contacts between solids that are mounted at the end of a step: triangles
/// between nodes with pressures, gap and whether they touch; `contact` numbers the deck's contacts.
void write_contact_vtu(const std::filesystem::path& file, const model::Model& model,
                       const results::LoadStepResult& step);

/// The fronts of cracks in space at the end of a step: lines between their points with K1, K2, K3,
/// G, T and the direction of growth; `crack` numbers the deck's cracks.
void write_front_vtu(const std::filesystem::path& file, const model::Model& model,
                     const results::LoadStepResult& step);

/// A mesh alone: element sets as cell arrays, node and face sets as point arrays, 1 for members.
/// Face sets must be given as node sets by the caller.
void write_mesh_sets_vtu(const std::filesystem::path& file, const model::Mesh& mesh);

/// A file of a collection; files of one time are parts of one picture.
struct PvdEntry {
  double time = 0.0;
  int part = 0;
  std::string name;
};

/// The collection that ParaView opens.
void write_pvd(const std::filesystem::path& file, const std::vector<PvdEntry>& entries);

/// The listing: deck echo with line numbers, model summary with the totals of the load cases,
/// processor log with times, tables.
std::string listing_text(const base::SourceTexts& sources, const model::Model& model,
                         const results::RunResult& run,
                         const std::vector<results::LoadTotal>& loads = {});

/// report.html: one page with its pictures, data and scripts in it; no network.
std::string html_report(const base::SourceTexts& sources, const model::Model& model,
                        const results::RunResult& run,
                        const std::vector<results::LoadTotal>& loads = {});

} // namespace spricka::report
