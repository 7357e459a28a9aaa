"""Where and with what a comparison ran."""

from __future__ import annotations

import datetime
import hashlib
import os
import platform
import re
import subprocess
from pathlib import Path


def _first_match(file: str, pattern: str) -> str:
    try:
        found = re.search(pattern, Path(file).read_text(), re.MULTILINE)
    except OSError:
        return "unknown"
    return found.group(1).strip() if found else "unknown"


def _output(*command: str | os.PathLike) -> str:
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def compiler_of(program: Path) -> str:
    """What the compilers left in the program's .comment section."""
    text = program.read_bytes()
    found = sorted(set(re.findall(rb"(?:GCC: \([^)]*\) [0-9.]+|clang version [0-9.]+)", text)))
    return ", ".join(f.decode() for f in found) or "unknown"


def _cache_value(program: Path, key: str) -> str:
    """A value of the CMake cache of the build that made `program` (build/<preset>/bin/visibility)."""
    return _first_match(str(program.resolve().parent.parent / "CMakeCache.txt"), rf"^{key}:[A-Z]+=(.*)$")


def describe(program: Path, source: Path) -> dict:
    """`source`: the checkout. `program_digest` tells builds apart."""
    modified = _output("git", "-C", source, "status", "--porcelain", "--untracked-files=no")
    return {
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "processor": _first_match("/proc/cpuinfo", r"^model name\s*:\s*(.*)$"),
        "cores": os.cpu_count(),
        "memory": _first_match("/proc/meminfo", r"^MemTotal:\s*(.*)$"),
        "system": f"{platform.system()} {platform.release()}",
        "compiler": compiler_of(program),
        "build_type": _cache_value(program, "CMAKE_BUILD_TYPE"),
        "commit": _output("git", "-C", source, "rev-parse", "--short", "HEAD") + (", modified" if modified else ""),
        "program_digest": hashlib.sha256(program.read_bytes()).hexdigest()[:16],
    }
