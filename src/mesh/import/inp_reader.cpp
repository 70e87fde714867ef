// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/import/inp_reader.hpp"

#include "mesh/import/inp_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace spricka::mesh {
namespace {

/// A file that is wrong everywhere is not worth more words.
constexpr std::size_t most_complaints = 50;

/// Keywords without a say in the mechanics: titles, what is printed or kept, the frame of parts.
constexpr std::array<std::string_view, 21> harmless{
    "HEADING",      "PREPRINT",    "OUTPUT",      "NODEOUTPUT", "ELEMENTOUTPUT", "CONTACTOUTPUT",
    "ENERGYOUTPUT", "NODEPRINT",   "NODEFILE",    "ELPRINT",    "ELFILE",        "ELEMENTPRINT",
    "CONTACTPRINT", "CONTACTFILE", "ENERGYPRINT", "ENERGYFILE", "SECTIONPRINT",  "MONITOR",
    "FILEFORMAT",   "ENDPART",     "ENDSTEP"};

bool is_harmless(std::string_view keyword) {
  return std::ranges::find(harmless, keyword) != harmless.end();
}

/// Where the deck says what a keyword of the file says.
struct Advice {
  std::string_view keywords; ///< each between blanks
  std::string_view words;
};
constexpr std::array<Advice, 7> advices{
    {{" BOUNDARY ", "supports are $FREEDOM, prescribed values $LOAD TYPE=DISP in the deck"},
     {" CLOAD DLOAD DSLOAD ", "loads are $LOAD in the deck"},
     {" STEP STATIC FREQUENCY BUCKLE DYNAMIC ", "steps are $STEP in the deck"},
     {" CONTACTPAIR CONTACT CONTACTINCLUSIONS SURFACEINTERACTION SURFACEBEHAVIOR FRICTION ",
      "contact is $CONTACT in the deck"},
     {" TIE ", "a tie is $CONTACT TYPE=BONDED in the deck"},
     {" MPC RIGIDBODY COUPLING KINEMATIC DISTRIBUTING ", "ties are $MPC in the deck"},
     {" PLASTIC HYPERELASTIC CREEP VISCOELASTIC ORIENTATION USERMATERIAL ",
      "materials are isotropic and linear elastic"}}};

/// How many of the above SKIP=LOADS passes over, from the first one on.
constexpr std::size_t skippable = 3;

/// The advice for a keyword; the end of the table without one.
const Advice* find_advice(const std::string& name) {
  const std::string word = fmt::format(" {} ", name);
  return std::find_if(advices.begin(), advices.end(), [&](const Advice& a) {
    return a.keywords.find(word) != std::string_view::npos;
  });
}

bool is_load(const std::string& name) {
  return name == "AMPLITUDE" || name == "INITIALCONDITIONS" || name == "TEMPERATURE" ||
         find_advice(name) < advices.begin() + skippable;
}

std::string advice(const std::string& name) {
  const Advice* const at = find_advice(name);
  const std::string words(at == advices.end() ? "" : fmt::format("{}; ", at->words));
  return fmt::format("{}$IMPORT SKIP={} passes over {}", words, is_load(name) ? "LOADS" : "ALL",
                     is_load(name) ? "them" : "it");
}

class InpFileReader {
public:
  InpFileReader(const std::filesystem::path& file, InpData& data, std::vector<InpIssue>& complaints,
                InpSkip skip)
      : complaints_(complaints), skip_(skip),
        text_(file,
              [this](InpLocation at, std::string words) { complain(at, std::move(words), {}); }),
        shared_{text_, data, [this](InpLocation at, std::string words, std::string hint) {
                  complain(at, std::move(words), std::move(hint));
                }} {
    shared_.lenient = skip == InpSkip::all;
  }

  void run() {
    std::unique_ptr<InpKeywordReader> lines;
    while (text_.next_line()) {
      if (text_.is_at_keyword()) {
        if (lines != nullptr) {
          lines->finish_keyword();
        }
        at_instance_ = false;
        lines = lines_of(text_.keyword());
      } else if (lines != nullptr) {
        lines->read_line();
      } else if (at_instance_) {
        complain(text_.location(), "an *INSTANCE that is moved or turned is not imported", {});
      }
    }
    if (lines != nullptr) {
      lines->finish_keyword();
    }
    for (const auto& [name, met] : refused_) {
      complain(met.first, fmt::format("*{} is not imported{}", met.shown, and_more(met.count)),
               advice(name));
    }
    for (const InpData::InpElementKind& kind : shared_.data.unknown) {
      complain(kind.first,
               fmt::format("elements of type {} are not known ({} lines)", kind.name, kind.count),
               is_inp_connector(kind.name)
                   ? "$IMPORT SKIP=ALL leaves springs, masses and the like out"
                   : "known: CPS, CPE and CAX with 3, 4, 6, 8 nodes; C3D with 4, 6, 8, 10, 15, 20");
    }
    for (const auto& [words, met] : said_) {
      complaints_[met.complaint].text += and_more(met.count);
    }
    shared_.data.files = text_.file_paths();
  }

private:
  struct Refused {
    std::string shown;
    InpLocation first;
    std::size_t count = 0;
  };

  static std::string and_more(std::size_t count) {
    return count > 1 ? fmt::format(" (and {} more)", count - 1) : "";
  }

  /// What is said of many lines in the same words is said at the first of them.
  void complain(InpLocation at, std::string words, std::string hint) {
    const auto met = said_.find(words);
    if (met != said_.end()) {
      ++met->second.count;
    } else if (complaints_.size() < most_complaints) {
      said_.emplace(words, Said{complaints_.size(), 1});
      complaints_.push_back({at, std::move(words), std::move(hint)});
    }
  }

  // All that stands in a step, and what loads or holds outside of one.
  bool passed_over(const InpKeyword& key) {
    if (skip_ == InpSkip::nothing) {
      return false;
    }
    const bool inside = shared_.in_step || key.name == "STEP";
    shared_.in_step = inside && key.name != "ENDSTEP";
    if (!inside && !is_load(key.name)) {
      return false;
    }
    leave_out(key);
    return true;
  }
  void leave_out(const InpKeyword& key) const {
    if (!is_harmless(key.name)) {
      shared_.leave_out(key.shown, key.place);
    }
  }

  std::unique_ptr<InpKeywordReader> lines_of(const InpKeyword& key) {
    if (passed_over(key)) {
      return make_inp_joint_reader(shared_, key);
    }
    for (const auto make :
         {make_inp_mesh_reader, make_inp_set_reader, make_material_and_equation_reader}) {
      if (auto lines = make(shared_, key)) {
        return lines;
      }
    }
    if (frame(key)) {
      return nullptr;
    }
    if (skip_ == InpSkip::all) {
      leave_out(key);
      return make_inp_joint_reader(shared_, key);
    }
    if (!is_harmless(key.name)) {
      Refused& refused = refused_[key.name];
      if (refused.count++ == 0) {
        refused.shown = key.shown;
        refused.first = key.place;
      }
    }
    return nullptr;
  }

  /// *PART, *ASSEMBLY, *INSTANCE: one part, used once as it stands. False for other keywords.
  bool frame(const InpKeyword& key) {
    static constexpr std::string_view apart =
        "write each body as a file of its own and import it into its own $NET";
    if (key.name == "PART") {
      if (++parts_ > 1) {
        complain(key.place, "a second *PART is not imported", std::string(apart));
      }
    } else if (key.name == "ASSEMBLY") {
      shared_.in_assembly = true;
    } else if (key.name == "ENDASSEMBLY") {
      shared_.in_assembly = false;
    } else if (key.name == "INSTANCE") {
      if (++instances_ > 1) {
        complain(key.place, "a second *INSTANCE is not imported", std::string(apart));
      }
      at_instance_ = true;
      if (const std::string* name = key.find("NAME")) {
        shared_.instance = *name;
      }
    } else {
      return key.name == "ENDINSTANCE";
    }
    return true;
  }

  struct Said {
    std::size_t complaint = 0; ///< its place
    std::size_t count = 0;
  };

  std::vector<InpIssue>& complaints_;
  std::map<std::string, Said> said_; ///< by its words
  InpSkip skip_;
  InpLineReader text_;
  InpReaderContext shared_;
  std::map<std::string, Refused> refused_;
  int parts_ = 0;
  int instances_ = 0;
  bool at_instance_ = false; ///< lines below are how it is moved and turned
};

} // namespace

InpData read_inp_data(const std::filesystem::path& file, std::vector<InpIssue>& complaints,
                      InpSkip skip) {
  InpData data;
  InpFileReader(file, data, complaints, skip).run();
  return data;
}

} // namespace spricka::mesh
