// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/job/remedy.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace spricka::program {

std::string failure_remedy(const base::OperationFailure& answer) {
  if (answer.kind == base::Outcome::not_converged) {
    return "with friction more SUBSTEPS or a smaller MU; spricka help E520 says more";
  }
  using Remedy = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Remedy, 10> remedies{
      {{"next to nothing holds",
        "hold it by a support ($FREEDOM), friction (MU=) or a contact that it runs against"},
       {"slides", "more friction, more pressure or less load, or a support: $FREEDOM"},
       {"is not mounted before", "mount it before the body is loaded, or hold the body until then"},
       {"was dismounted", "hold the body by a support or another contact before it is dismounted"},
       {"only presses",
        "look at the sign of the load and at its total (TYPE=FORCE acts on each node of a set, "
        "TYPE=RESULTANT once on all); else a support ($FREEDOM), or TYPE=BONDED"},
       {"not held", "add a support ($FREEDOM), or the $CONTACT that holds it"},
       {"singular", "add a support ($FREEDOM), or join the parts"},
       {"mechanism", "add a support ($FREEDOM), or join the parts"},
       {"memory",
        "take fewer or coarser elements or, where rows of contact take it, MULTIPLIER=CORNER on "
        "$CONTACT; or a machine with more memory"},
       {"mesh", "another place or length of the crack, or RADIUS and SIZE on $TIPNET"}}};
  for (const auto& [word, remedy] : remedies) {
    if (answer.why.find(word) != std::string::npos) {
      return std::string(remedy);
    }
  }
  return "spricka help E510 says what can be done";
}

} // namespace spricka::program
