"""What goes wrong from outside, said in one line that names the mend."""


class Fault(Exception):
    pass


def missing(package):
    return Fault(f"the Python package {package} is missing; python3 -m pip install --require-hashes "
                 "-r tools/bridge/requirements.txt installs it")
