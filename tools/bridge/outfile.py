"""An output is written beside its place and moved there once it is whole."""

import os
import tempfile
from pathlib import Path

from faults import Fault


class Outfile:
    def __init__(self, path):
        self.path = Path(path)
        if self.path.is_dir():
            raise Fault(f"{path}: a folder; name a file")
        try:
            number, self.partial = tempfile.mkstemp(dir=self.path.parent, prefix=self.path.name + ".", suffix=".part")
            mask = os.umask(0)
            os.umask(mask)
            os.fchmod(number, 0o666 & ~mask)
            os.close(number)
        except OSError as error:
            raise Fault(f"{path}: cannot be written ({error.strerror}); name a file in a folder of yours") from None

    def keep(self):
        os.replace(self.partial, self.path)

    def drop(self):
        if os.path.exists(self.partial):
            os.remove(self.partial)
