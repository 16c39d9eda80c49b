"""test_processes.py --programs FOLDER --lcm FOLDER [unittest's words]: the demo's programs, from outside.

Games over udpm, each in a network of its own, with packets lost, robots killed, strangers on the bus, forged signals and bad input. The
tests run side by side: a game in real time waits most of the time. What must come soon is counted in messages, in the
order in which they were heard: how fast the machine is does not matter. Writes into the working directory alone.
"""

import sys

sys.dont_write_bytecode = True  # a test leaves nothing in the checkout

from processes_bus import LcmTools, Strangers  # noqa: E402, F401
from processes_ends import Ends  # noqa: E402, F401
from processes_games import Games, RobotAlone, Terms  # noqa: E402, F401
from processes_input import BadInput  # noqa: E402, F401
from processes_live import Live  # noqa: E402, F401
from processes_seals import Seals  # noqa: E402, F401
from programs import main  # noqa: E402

if __name__ == "__main__":
    main(__doc__, "lcm")
