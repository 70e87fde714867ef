// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/nastran_import.hpp"

#include "mesh/import/inp_import.hpp"
#include "mesh/import/inp_words.hpp"
#include "mesh/import/make_nastran_model.hpp"
#include "mesh/import/nastran_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <utility>

namespace spricka::mesh {
namespace {

/// What to do about entries that are not read.
struct NastranAdvice {
  std::string_view entries; ///< each between blanks
  std::string_view words;
};
constexpr std::array<NastranAdvice, 6> nastran_advices{
    {{" RBE1 RBE2 RBE3 RBAR RROD RSPLINE RTRPLT MPC MPCADD RJOINT ", "ties are $MPC in the deck"},
     {" BCTABLE BCTSET BCTADD BCONP BCONTACT BCBODY BSURF BSURFS BGSET BGADD BGPARM BCTPARM "
      "CGAP CONTACT TIE SURF ",
      "contact is $CONTACT in the deck, a tie TYPE=BONDED"},
     {" MAT2 MAT3 MAT4 MAT5 MAT8 MAT9 MAT10 MATT1 MATS1 MATHP MATHE CREEP ",
      "materials are isotropic and linear elastic"},
     {" CBAR CBEAM CROD CTUBE CONROD CBEND CELAS1 CELAS2 CELAS3 CELAS4 CBUSH CBUSH1D CDAMP1 "
      "CDAMP2 CFAST CWELD CSEAM CVISC ",
      "there are no bars and springs"},
     {" CONM1 CONM2 CMASS1 CMASS2 ", "there are no point masses"},
     {" CQUADR CTRIAR CQUAD CTRIAX CTRIAX6 CQUADX CSHEAR CPYRAM PCOMP PCOMPG PCOMPS PLPLANE "
      "PLSOLID PSHEAR ",
      "solids are CTETRA, CPENTA and CHEXA, plane parts CTRIA3, CTRIA6, CQUAD4 and CQUAD8"}}};

constexpr std::string_view skip_loads_words =
    "supports are $FREEDOM, loads $LOAD in the deck; $IMPORT SKIP=LOADS passes over those of the "
    "file and makes sets of where they act";
constexpr std::size_t most_kinds = 30; ///< of entries in one list

const NastranAdvice* find_nastran_advice(const std::string& name) {
  const std::string word = fmt::format(" {} ", name);
  const auto* const at =
      std::find_if(nastran_advices.begin(), nastran_advices.end(), [&](const NastranAdvice& a) {
        return a.entries.find(word) != std::string_view::npos;
      });
  return at == nastran_advices.end() ? nullptr : at;
}

InpLabelList as_list(const std::vector<base::Label>& labels) {
  InpLabelList list;
  for (const base::Label label : labels) {
    list.append(label);
  }
  return list;
}

/// The model as input files of Abaqus have theirs; materials are called "M<number>".
InpData as_inp_data(const NastranModel& model, const NastranBulk& bulk) {
  InpData data;
  data.files = bulk.files;
  data.node = model.node;
  data.x = model.x;
  data.element = model.element;
  for (std::size_t e = 0; e < model.type.size(); ++e) {
    data.type.push_back({model.type[e], model.state[e]});
  }
  data.element_place = model.element_place;
  data.first = model.first;
  data.connectivity = model.connectivity;
  data.special = model.special;
  for (const NastranModel::NastranSet& set : model.node_sets) {
    data.node_sets.push_back({set.name, as_list(set.members), {}, set.place});
  }
  for (const NastranModel::NastranSet& set : model.element_sets) {
    data.element_sets.push_back({set.name, as_list(set.members), {}, set.place});
  }
  for (const NastranModel::NastranSurface& surface : model.surfaces) {
    data.surfaces.push_back({surface.name, {}, surface.place});
    for (const auto& [element, side] : surface.sides) {
      data.surfaces.back().members.push_back({{}, element, side, surface.place});
    }
  }
  for (const NastranModel::NastranSection& section : model.sections) {
    data.sections.push_back({section.elements, section.material, section.thickness, section.place});
  }
  for (const auto& [label, from] : bulk.materials) {
    data.materials.push_back({fmt::format("M{}", label), from.E, from.nu,
                              from.rho * bulk.density_factor, from.alpha, true, from.place});
  }
  return data;
}

class NastranImport {
public:
  NastranImport(model::Mesh& mesh, const ImportRequest& request, base::Diagnostics& diagnostics)
      : mesh_(mesh), request_(request), diagnostics_(diagnostics) {}

  ImportedMaterialsAndEquations run() {
    bulk_ = read_nastran_bulk(request_.file, complaints_);
    add_loaded_bars();
    const NastranModel model = make_nastran_model(bulk_, complaints_);
    if (request_.skip != InpSkip::all) {
      for (const auto& [name, met] : bulk_.refused) {
        refuse(name, met);
      }
      complaints_.insert(complaints_.end(), model.stray_skins.begin(), model.stray_skins.end());
    }
    const auto held = std::find_if(model.node_sets.begin(), model.node_sets.end(),
                                   [](const auto& set) { return set.name.starts_with("PS_"); });
    if (held != model.node_sets.end()) {
      bulk_.loads["PS of GRID"] = {held->place, held->members.size()};
    }
    if (request_.skip == InpSkip::nothing) {
      refuse_loads();
    }
    InpData data = as_inp_data(model, bulk_);
    if (complaints_.empty()) {
      warn(model, data);
    }
    std::vector<InpIssue> issues;
    for (NastranIssue& issue : complaints_) {
      issues.push_back({issue.place, std::move(issue.text), std::move(issue.hint)});
    }
    return import_inp_data(mesh_, request_, std::move(data), std::move(issues), diagnostics_);
  }

private:
  /// Bars with a property carry load.
  void add_loaded_bars() {
    for (const NastranBulk::NastranBar& bar : bulk_.bars) {
      if (bulk_.bar_properties.contains(bar.property)) {
        bulk_.refused[bar.name].add(bar.place);
      }
    }
  }

  void refuse(const std::string& name, const NastranEntries& met) {
    const NastranAdvice* const advice = find_nastran_advice(name);
    const std::string skip = "; SKIP=ALL passes over all that is not read";
    // the first word of a line may be anything in a file that is included by mistake
    complaints_.push_back({met.first,
                           fmt::format("{} is not imported ({} {})",
                                       advice == nullptr ? fmt::format("'{}'", name) : name,
                                       met.count, met.count == 1 ? "entry" : "entries"),
                           (advice == nullptr ? "take it out of the file if it has no say"
                                              : std::string(advice->words)) +
                               skip});
  }

  void refuse_loads() {
    if (bulk_.loads.empty()) {
      return;
    }
    InpLocation first = bulk_.loads.begin()->second.first;
    for (const auto& [name, met] : bulk_.loads) {
      first = std::min(first, met.first, [](InpLocation a, InpLocation b) {
        return std::pair(a.file, a.line) < std::pair(b.file, b.line);
      });
    }
    complaints_.push_back(
        {first, fmt::format("supports and loads are not imported: {}", list_of(bulk_.loads)),
         std::string(skip_loads_words)});
  }

  static std::string list_of(const std::map<std::string, NastranEntries>& met) {
    std::string list;
    std::size_t kinds = 0;
    for (const auto& [name, items] : met) {
      if (kinds++ == most_kinds) {
        return list + fmt::format(" and {} more kinds", met.size() - most_kinds);
      }
      list += fmt::format("{}{} ({})", list.empty() ? "" : ", ", name, items.count);
    }
    return list;
  }

  /// The sets of supports and loads in words.
  std::string where_loads_act(const NastranModel& model) const {
    if (model.load_sets.empty()) {
      return {};
    }
    const bool turned = std::any_of(bulk_.grids.begin(), bulk_.grids.end(), [&](const auto& grid) {
      return (grid.directions == NastranBulk::blank ? bulk_.default_directions : grid.directions) >
             0;
    });
    return fmt::format("; where they act are the sets {}{}", fmt::join(model.load_sets, ", "),
                       turned ? "; freedoms of some nodes have directions of their own (CD)" : "");
  }

  void warn(const NastranModel& model, const InpData& data) {
    InpMessages words(request_, data, diagnostics_);
    if (!model.bars.empty()) {
      words.warning(model.bars.begin()->second.first, "W466",
                    fmt::format("bars without a property are left out: {}", list_of(model.bars)));
    }
    std::map<std::string, NastranEntries> skipped = bulk_.loads;
    for (const auto& [name, met] : bulk_.refused) {
      const bool any_text = find_nastran_advice(name) == nullptr && met.first.file != 0;
      NastranEntries& items = skipped[any_text ? "others in included files" : name];
      items.first = met.first;
      items.count += met.count;
    }
    std::string list = list_of(skipped);
    for (const NastranIssue& stray :
         request_.skip == InpSkip::all ? model.stray_skins : std::vector<NastranIssue>()) {
      list += (list.empty() ? "" : "; ") + stray.text;
    }
    if (!list.empty()) {
      words.warning({}, "W467",
                    fmt::format("passed over, as SKIP={} asks for: {}{}",
                                request_.skip == InpSkip::all ? "ALL" : "LOADS", list,
                                where_loads_act(model)));
    }
    if (!model.skins_with_stiffness.empty()) {
      words.warning({}, "W466",
                    fmt::format("shells on faces of solids are surfaces here, and their stiffness "
                                "is left out: {}",
                                fmt::join(model.skins_with_stiffness, ", ")));
    }
  }

  model::Mesh& mesh_;
  const ImportRequest& request_;
  base::Diagnostics& diagnostics_;
  std::vector<NastranIssue> complaints_;
  NastranBulk bulk_;
};

} // namespace

ImportedMaterialsAndEquations import_nastran(model::Mesh& mesh, const ImportRequest& request,
                                             base::Diagnostics& diagnostics) {
  return NastranImport(mesh, request, diagnostics).run();
}

} // namespace spricka::mesh
