"""test_failures.py --programs FOLDER [unittest's words]: what the demo does when something fails around it.

Disks that are full, worlds and robots that stop, strangers on the bus and at the viewer's port. Each game is in a network
of its own. Writes into the working directory alone.
"""

import sys

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout

from failures_followed import Followed  # noqa: E402, F401
from failures_outputs import Outputs  # noqa: E402, F401
from failures_served import Crowds, Doors  # noqa: E402, F401
from failures_stops import BrokenOff  # noqa: E402, F401
from programs import main  # noqa: E402

if __name__ == "__main__":
    main(__doc__)
