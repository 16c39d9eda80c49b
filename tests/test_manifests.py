"""test_manifests.py --source FOLDER --bundle FOLDER --work FOLDER --cc CC [--cmake WHERE] [--generator NAME]: what PlatformIO,
Arduino, ESP-IDF and Zephyr are told of the robot side. The version is the library's; the sources that are named are all of the
robot side, and an application links them under the sizes of a robot.
"""

import argparse
import json
import pathlib
import re
import subprocess

from check_source import report, self_test

SIDES = ("core", "robot")


def read(path):
    return path.read_text(encoding="utf-8")


def check_versions(version, named):
    """`named`: {manifest: the version that it says}."""
    return [f"{name}: version {said}, and the library's is {version}" for name, said in named.items() if said != version]


def versions_of(source, bundle):
    return {
        "library.json": json.loads(read(source / "library.json"))["version"],
        "idf_component.yml": re.search(r'^version: "([^"]+)"$', read(source / "idf_component.yml"), re.MULTILINE).group(1),
        "library.properties": re.search(r"^version=(.+)$", read(bundle / "library.properties"), re.MULTILINE).group(1),
    }


def filtered(folder, patterns):
    """The files that a srcFilter of PlatformIO leaves: `-<*>` takes them out, `+<core/*.c>` puts them in."""
    left = set()
    for pattern in patterns:
        found = {path for path in folder.glob(pattern[2:-1]) if path.is_file()}
        left = left | found if pattern[0] == "+" else left - found
    return left


def check_sources(left, wanted):
    return [f"not compiled: {path}" for path in sorted(wanted - left)] + [f"compiled: {path}" for path in sorted(left - wanted)]


def make_program(cc, program, sources, flags):
    command = [cc, *flags, *map(str, sources), "-o", str(program)]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", errors="replace")
    if done.returncode != 0:
        return [" ".join(command) + "\n" + done.stderr]
    return [] if subprocess.run([program]).returncode == 0 else [f"{program}: built under other sizes than a robot's"]


def check_platformio(options):
    manifest = json.loads(read(options.source / "library.json"))["build"]
    folder = options.source / manifest["srcDir"]
    sources = filtered(folder, manifest["srcFilter"])
    faults = check_sources(sources, {path for side in SIDES for path in (options.source / "lib" / side).glob("*.c")})
    # PlatformIO takes flags from the library's own folder on.
    flags = [re.sub("^-I", f"-I{options.source}/", flag) for flag in manifest["flags"]]
    flags += [f"-I{options.source / manifest['includeDir']}", "-DPLATFORMIO=60100"]
    application = options.source / "tests" / "manifests" / "application.c"
    return faults or make_program(options.cc, options.work / "platformio", [application, *sorted(sources)], flags)


def check_arduino(options):
    """The bundle's folder: a library of the flat layout, whose header the manifest names."""
    said = dict(line.split("=", 1) for line in read(options.bundle / "library.properties").splitlines())
    wanted = ("name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url", "architectures", "includes")
    faults = [f"library.properties: no {key}" for key in wanted if key not in said]
    application = options.work / "application.c"
    text = read(options.source / "tests" / "manifests" / "application.c")
    application.write_text(text.replace("<quarter/robot.h>", f"<{said['includes']}>"), encoding="utf-8")
    sources = [application, *options.bundle.glob("*.c")]
    return faults + make_program(options.cc, options.work / "arduino", sources, [f"-I{options.bundle}", "-DARDUINO=10800"])


def settings_of(kconfig):
    """{setting: default} of a Kconfig file."""
    blocks = re.split(r"^config ", kconfig, flags=re.MULTILINE)[1:]
    found = {}
    for block in blocks:
        default = re.search(r"^\tdefault (\S+)$", block, re.MULTILINE)
        found["CONFIG_" + block.split("\n", 1)[0]] = default.group(1) if default else "0"
    return found


def check_settings(settings, build_file):
    used = set(re.findall(r"CONFIG_QUARTER\w*", build_file))
    return [f"zephyr: {name} is set or used alone" for name in sorted(used ^ set(settings))]


def check_framework(options, framework, *definitions):
    folder = options.work / framework
    project = options.source / "tests" / "manifests"
    commands = [
        [options.cmake, "-S", project, "-B", folder, "-G", options.generator, f"-DCMAKE_C_COMPILER={options.cc}",
         f"-DFRAMEWORK={framework}", *definitions],
        [options.cmake, "--build", folder],
        [folder / "application"],
    ]
    for command in commands:
        done = subprocess.run([str(word) for word in command], capture_output=True, encoding="utf-8", errors="replace")
        if done.returncode != 0:
            return [f"{framework}: {done.stdout}{done.stderr}"]
    return []


def check_zephyr(options):
    settings = settings_of(read(options.source / "zephyr" / "Kconfig"))
    faults = check_settings(settings, read(options.source / "zephyr" / "CMakeLists.txt"))
    module = read(options.source / "zephyr" / "module.yml")
    faults += [] if re.search(r"^  kconfig: zephyr/Kconfig$", module, re.MULTILINE) else ["zephyr/module.yml: names no Kconfig"]
    joined = ";".join(f"{name}={value}" for name, value in settings.items())
    return faults + check_framework(options, "zephyr", f"-DSETTINGS={joined}")


def prove_that_it_fails():
    self_test([("an old version", ("0.2.0", {"a": "0.1.0", "b": "0.2.0"}), 1)], check_versions)
    self_test([("a source too few and too many", ({"a", "b"}, {"b", "c"}), 2)], check_sources)
    used = "CONFIG_QUARTER CONFIG_QUARTER_USED"
    self_test([("a setting without use", ({"CONFIG_QUARTER": "0", "CONFIG_QUARTER_SET": "1"}, used), 2)], check_settings)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--source", type=pathlib.Path, required=True)
    parser.add_argument("--bundle", type=pathlib.Path, required=True)
    parser.add_argument("--work", type=pathlib.Path, required=True)
    parser.add_argument("--cc", default="cc")
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--generator", default="Ninja")
    options = parser.parse_args()
    prove_that_it_fails()
    options.work.mkdir(parents=True, exist_ok=True)
    version = re.search(r'QTR_VERSION_STRING "([\d.]+)"', read(options.source / "include" / "quarter" / "status.h")).group(1)
    faults = check_versions(version, versions_of(options.source, options.bundle))
    faults += check_platformio(options) + check_arduino(options) + check_framework(options, "esp-idf") + check_zephyr(options)
    report(faults, "PlatformIO, Arduino, ESP-IDF and Zephyr: an application each")


main()
