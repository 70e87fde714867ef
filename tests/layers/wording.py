# SPDX-License-Identifier: GPL-3.0-or-later
"""Rules on names: no word that only this project uses, one type of a name, few branches on the dimension."""

import re

from measures import Measures

# What the field does not say, or says of something else -> what it says.
DENIED = {
    "owed": "deferred_advance", "astray": "uncertain_fraction", "lever": "extent_rate_ratio",
    "leap": "breakthrough", "leapt": "breakthrough", "wake": "front_history (a wake is plastic)",
    "ways": "kinematics", "march": "integrator", "sight": "projection", "sighting": "projection",
    "told": "reported", "rung": "variant", "knob": "mesh_parameter", "wish": "request",
    "dig": "build_cavities", "lay": "place", "stretch": "interval, range or segment",
    "partner": "auxiliary_field, or what it is", "flip": "active_set_change", "doubt": "concern or invalid_reason",
    "rough": "discontinuous", "lost": "what it is: missing, removed, unprojected",
}
# Lines of src and grammar that ask for the dimension, and files with such lines: to go down, never up.
BRANCHES, BRANCHING_FILES = 28, 27


def word_errors(measures):
    errors = []
    for name, place in measures.identifiers.items():
        for part in re.findall(r"[A-Z]?[a-z]+|[A-Z]+", name):
            word = next((w for w in (part.lower(), part.lower().removesuffix("s"), part.lower().removesuffix("es"))
                         if w in DENIED), None)
            if word:
                errors.append(f"{place}: {name}: for '{word}' the field says {DENIED[word]}")
    return errors


def type_errors(measures):
    return [f"types of one name, {name}: {', '.join(places)}" for name, places in measures.named_twice().items()]


def branch_errors(measures):
    files = len({place.split(":")[0] for place in measures.branches})
    if len(measures.branches) <= BRANCHES and files <= BRANCHING_FILES:
        return []
    return [f"{len(measures.branches)} lines in {files} files branch on the dimension, more than {BRANCHES} in "
            f"{BRANCHING_FILES} (measures.py --branches names them): write it once for both"]


def wording_errors(top):
    """What breaks these rules in TOP/src and TOP/grammar."""
    measures = Measures(top)
    return [error for rule in (word_errors, type_errors, branch_errors) for error in rule(measures)]
