# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests that look at pages have in common."""

import subprocess
import sys
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "manual" / "site"))

WIDTHS = (1280, 400)  # of a screen and of a telephone
LOOK = (Path(__file__).parent / "look.js").read_text(encoding="utf-8")


def run(*command):
    done = subprocess.run([str(c) for c in command], text=True, capture_output=True, timeout=600, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command}: {done.returncode}\n{done.stdout}{done.stderr}")
