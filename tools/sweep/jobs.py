"""What a sweep consists of: each of the config's settings on each of its missions, by each seed."""

import glob
import re
import shlex
from pathlib import Path


class ConfigFault(ValueError):
    pass


def missions_of(patterns):
    """Files by name or pattern, each once, in order; a pattern that fits nothing is a mistake."""
    found = []
    for pattern in patterns:
        files = sorted(glob.glob(pattern, recursive=True))
        if not files:
            raise ConfigFault(f"missions: nothing fits '{pattern}'")
        found += [file for file in files if file not in found]
    return found


def plain(text):
    """As part of a file's name."""
    return re.sub(r"[^A-Za-z0-9.]+", "_", text).strip("_.") or "_"


def names_of(missions):
    """A short name for each that tells it from the others: its file's, with its folder's where that does not."""
    short = [plain(Path(mission).stem) for mission in missions]
    longer = [plain(str(Path(mission).with_suffix(""))) for mission in missions]
    return [long if short.count(name) > 1 else name for name, long in zip(short, longer)]


def checked(config):
    for key in ("missions", "settings"):
        if not config.get(key):
            raise ConfigFault(f"{key}: there are none")
    unknown = sorted(set(config) - {"tool", "missions", "settings", "seeds"})
    if unknown:
        raise ConfigFault(f"{unknown[0]}: is no key of a sweep; there are tool, missions, settings and seeds")
    return config


def words_of(tool, setting, mission, seed):
    """The setting's words begin with the tool's command; the mission comes behind it."""
    command, *options = shlex.split(setting)
    return [tool, command, mission, *options, "--seed", str(seed), "--quiet", "--json"]


def of_config(config):
    """The jobs by name."""
    config = checked(config)
    missions = missions_of(config["missions"])
    jobs = {}
    for mission, short in zip(missions, names_of(missions)):
        for setting, words in config["settings"].items():
            for seed in config.get("seeds", [1]):
                name = f"{short}-{plain(setting)}-{seed}"
                if name in jobs:
                    raise ConfigFault(f"two jobs have the name {name}")
                jobs[name] = {"mission": mission, "setting": setting, "seed": seed,
                              "words": words_of(config.get("tool", "quarter"), words, mission, seed)}
    return jobs
