"""test_viewer.py TEMPLATE SAMPLE: the demo's viewer in a browser without a window. Ends with 77 where there is none.

SAMPLE is a replay; what the page is to show is worked out from it here, by code that shares nothing with the page's.
"""

import json
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout

import webdriver  # noqa: E402
from pages import LINE, SAMPLE, asked  # noqa: E402
from viewer_ghost import Ghost  # noqa: E402, F401
from viewer_live import Live  # noqa: E402, F401
from viewer_playing import Playing, Refusing  # noqa: E402, F401
from viewer_showing import Showing  # noqa: E402, F401
from viewer_telling import Telling  # noqa: E402, F401
from viewer_terms import Terms  # noqa: E402, F401


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    if webdriver.installed() is None:
        print("SKIPPED: the replay page in a browser: there is no chromium with a chromedriver (Ubuntu's packages of these names are stubs)")
        sys.exit(77)
    if not webdriver.knows_localhost():
        print("SKIPPED: the replay page in a browser: this machine does not know the name localhost (/etc/hosts)")
        sys.exit(77)
    template, sample = sys.argv[1:3]
    asked.template = pathlib.Path(template).read_text(encoding="utf-8")
    SAMPLE.update(json.loads(pathlib.Path(sample).read_text(encoding="utf-8")))
    assert asked.template.count(LINE) == 1, "the line that the host program replaces is there once"
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
