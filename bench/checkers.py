# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference data beside the project and the independent checkers that come with it (Python with numpy)."""

import functools
import json
import os
import subprocess
import sys
from pathlib import Path

root = Path(__file__).resolve().parent.parent
data = Path(os.environ.get("DSC_SHARED_DATA", root.parent / "shared/data"))


@functools.cache
def python_with_numpy():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import numpy"], capture_output=True, check=False).returncode == 0:
            return python
    return None


def checker(name):
    return data.parent / "tools" / f"{name}.py"


def checked(name, *words):
    """What the checker says: a dictionary, or None without it."""
    python = python_with_numpy()
    if python is None or not checker(name).exists():
        return None
    run = subprocess.run([python, checker(name), *map(str, words), "--json"], capture_output=True, text=True, check=False)
    return json.loads(run.stdout) if run.stdout else {"error": run.stderr}
