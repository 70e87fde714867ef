// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "model/forward.hpp"
#include "report/drawing/table.hpp"
#include "report/topics/figures.hpp"
#include "results/results.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// How K answers to loads, fits, moduli and crack lengths: file, table and pictures. A small change
/// stands for all: 1 %, of a fit one micrometre.
namespace spricka::report {

/// sensitivity.csv:
/// increment,step,crack,a,cause,name,value,dK1_below,dK1_above,dK2_below,dK2_above, from,to;
/// derivatives by the value, below and above it, and the values between which the contact stays as
/// it is. In space a row for each point, by the value above it:
/// increment,step,crack,a,point,at_surface,s,cause,name,value,dK1,dK2,dK3,from,to. Not written
/// without cracks.
void write_sensitivity_csv(const std::filesystem::path& file, const model::Model& model,
                           const results::RunResult& run);

/// The leading step of one increment, strongest first, tip by tip; of a front in space at the point
/// inside with the largest K1.
ReportTable sensitivity_table(const model::Model& model,
                              const results::CrackLengthResult& increment);
/// What is not given there and why, each note once.
std::vector<std::string> missing_sensitivity_reasons(const model::Model& model,
                                                     const results::CrackLengthResult& increment);

/// A tornado of K1 for each tip or front of the leading step, at three crack lengths at most.
std::vector<Figure> sensitivity_figures(const model::Model& model, const results::RunResult& run);

} // namespace spricka::report
