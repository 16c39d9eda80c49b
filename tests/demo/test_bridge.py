"""test_bridge.py [--quarter PATH] [--lcm-gen PATH] [--no-rerun] [unittest's words]: tools/bridge, from outside.

Needs the packages of tools/bridge/requirements.txt; with --no-rerun those of requirements-mcap.txt, and what a Rerun
recording must hold is reported as skipped. QUARTER_TOOL and QUARTER_LCM_GEN stand for the paths. The live bus is in a
network namespace of its own.
"""

import argparse
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout

from bridge_live import TestLive, publish  # noqa: E402, F401
from bridge_mcap import TestMcap  # noqa: E402, F401
from bridge_refusals import TestFiles, TestRefusals  # noqa: E402, F401
from bridge_rerun import TestRerun  # noqa: E402, F401
from bridging import ROOT, asked  # noqa: E402
from side_by_side import Telling  # noqa: E402


def find_lcm_gen():
    found = importlib.util.find_spec("lcm")
    return str(Path(found.origin).parent.parent / "bin" / "lcm-gen") if found else "lcm-gen"


def load_types(folder):
    subprocess.run([asked.lcm_gen, "--python", "--ppath", folder, *map(str, (ROOT / "lcmtypes").glob("*.lcm"))],
                   check=True)
    sys.path.insert(0, folder)
    import quarter
    sys.path.remove(folder)
    return quarter


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quarter", default=os.environ.get("QUARTER_TOOL") or shutil.which("quarter"))
    parser.add_argument("--lcm-gen", default=os.environ.get("QUARTER_LCM_GEN") or find_lcm_gen())
    parser.add_argument("--no-rerun", action="store_true")
    parser.add_argument("--publish", nargs=argparse.REMAINDER, help=argparse.SUPPRESS)
    _, rest = parser.parse_known_args(namespace=asked)
    needed = ["lcm"] if asked.publish else ["lcm", "mcap"] if asked.no_rerun else ["lcm", "mcap", "rerun"]
    missing = [module for module in needed if importlib.util.find_spec(module) is None]
    if missing:
        sys.exit(f"test_bridge.py: no Python package {', '.join(missing)}; install tools/bridge/requirements.txt")
    with tempfile.TemporaryDirectory(prefix="quarter-bridge-types-") as folder:
        asked.types = load_types(folder)
    if asked.publish:
        sys.exit(publish(*asked.publish))
    if asked.quarter is None:
        sys.exit("test_bridge.py: no quarter; name it: --quarter PATH")
    asked.quarter = str(Path(asked.quarter).resolve())
    unittest.main(argv=[sys.argv[0], *rest], testRunner=Telling)


if __name__ == "__main__":
    main()
