"""test_schema.py --quarter PROGRAM --source FOLDER: what a mission may say is said once. docs/mission.md and
docs/mission.schema.json are what `quarter keys` prints; each key has its row in the one and its property in the other, and the
reader knows it; the reader and the schema, by a validator that shares nothing with them, come to one verdict of each key's
example, of values at the ends of its range, of other kinds of values, and of the missions that are shipped.
"""

import argparse
import copy
import io
import json
import pathlib
import re
import subprocess

import jsonschema
from check_source import report, self_test
from ruamel.yaml import YAML

ROW = re.compile(r"^\| `(\w+)`(?:, also ((?:`\w+`(?:, | or )?)+))? \|.*\| `(.*)` \|$", re.MULTILINE)
BASE = {"map": "map.yaml", "robots": [{"x": 0.5, "y": 1.5}], "places": [{"x": 2.5, "y": 1.5}, {"x": 4.5, "y": 1.5}]}
FILES = {
    "map.pgm": "P2 20 20 1\n" + "1 " * 400,
    "map.yaml": "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\nmode: scale\n",
    "places.csv": "x,y,weight\n5.5,5.5,1\n",
    "places.geojson": '{"type": "Point", "coordinates": [6.5, 6.5], "crs": {"properties": {"name": "local"}}}',
    "keepout.pgm": "P2 20 20 255\n" + "0 " + "255 " * 399,
    "terrain.pgm": "P2 20 20 255\n" + "2 " * 400,
    "likelihood.pgm": "P2 20 20 255\n" + "0 " * 210 + "9 " + "0 " * 189,
}


def load(text):
    return YAML(typ="safe", pure=True).load(text)


def dump(mission):
    out = io.StringIO()
    YAML(typ="safe", pure=True).dump(mission, out)
    return out.getvalue()


def examples_of(reference):
    """{heading: {key or another word for it: its example}} of the page."""
    parts = re.split(r"^## (.*)$", reference, flags=re.MULTILINE)
    return {
        title: {word: example for name, also, example in ROW.findall(text) for word in [name, *re.findall(r"`(\w+)`", also)]}
        for title, text in zip(parts[1::2], parts[2::2])
        if ROW.search(text)
    }


def schema_of(root, title):
    """The schema of a mapping by its heading; what a list, a mapping or a name holds has its own `title`."""
    if root.get("title") == title:
        return root
    parts = [part for part in root.values() if isinstance(part, dict)]
    return next((found for part in parts if (found := schema_of(part, title)) is not None), None)


def without_twins(item, schema, key):
    """The item without what may not stand beside the key: another position, another word for it."""
    apart = {word for rule in schema.get("allOf", []) for word in rule["not"]["required"] if key in rule["not"]["required"]}
    if key in schema.get("dependencies", {}):
        apart |= set(schema["dependencies"])
    return {name: value for name, value in item.items() if name not in apart or name == key}


def item_of(mission, title, root, tops):
    """The mission's mapping of that title; where it has none, the one in the example of its key."""
    if root["title"] == title:
        return mission
    for key, of in root["properties"].items():
        if of.get("title") == title:
            return mission.setdefault(key, load(tops[key]))
        if of.get("items", {}).get("title") == title:
            return mission.setdefault(key, load(tops[key]))[0]
        if of.get("items", {}).get("items", {}).get("title") == title:
            return mission.setdefault(key, load(tops[key]))[0][0]
        if isinstance(of.get("additionalProperties"), dict) and of["additionalProperties"]["title"] == title:
            return next(iter(mission.setdefault(key, load(tops[key])).values()))
    raise KeyError(title)


# What else a mission says that has such a key.
BESIDE = {
    "deadline_seconds": {"objective": "deadline"},
    "home_weight": {"objective": "time"},
    "class": {"classes": {"drone": {}}},
    "avoid": {"places": [{"x": 2.5, "y": 1.5, "name": "Bay 3"}]},
}


def set_key(mission, title, schema, key, value, examples, root, tops):
    """A copy of the mission with the key of its mapping `title` set, and what must stand beside it."""
    mission = copy.deepcopy({**mission, **BESIDE.get(key, {})})
    item = item_of(mission, title, root, tops)
    kept = without_twins(item, schema, key)
    for beside in schema.get("dependencies", {}).get(key, []):
        kept[beside] = load(examples[beside])
    kept[key] = value
    item.clear()
    item.update(kept)
    return mission


OTHER_KINDS = {"string": [[1]], "number": ["many", [1]], "integer": ["many", [1], 1.5], "array": [7]}
ENDS = {"minimum": -1, "maximum": 1, "exclusiveMinimum": 0, "exclusiveMaximum": 0}


def bad_values(schema):
    """Values that a property's schema refuses, for its kind and at the ends of its range."""
    kind = schema.get("type", "enum")
    others = OTHER_KINDS.get(kind, ["no such word", [1]]) if isinstance(kind, str) else [[1], {"a": 1}]
    return others + [schema[end] + beyond for end, beyond in ENDS.items() if end in schema]


def cases_of_key(title, of, key, examples, put):
    """`put`: the schema of the mapping, a key, its value -> a mission with that."""
    example = load(examples[key])
    cases = [(f"{key} of {title}", put(of, key, example), True)]
    cases += [(f"{key} of {title}: {value}", put(of, key, value), False) for value in bad_values(of["properties"][key])]
    return [*cases, (f"{key}_x of {title}", put({}, key + "_x", example), False)]


def cases_of(reference, schema):
    """(what, mission, verdict that both must come to) for each key."""
    cases = [("the base", BASE, True)]
    pages = examples_of(reference)
    for title, examples in pages.items():

        def put(of, key, value, title=title, examples=examples):
            return set_key(BASE, title, of, key, value, examples, schema, pages[schema["title"]])

        for first, second in [rule["not"]["required"] for rule in schema_of(schema, title).get("allOf", [])]:
            both = put(schema_of(schema, title), first, load(examples[first]))
            item_of(both, title, schema, pages[schema["title"]])[second] = load(examples[second])
            cases.append((f"{first} and {second} of {title}", both, False))
        for key in examples:
            cases += cases_of_key(title, schema_of(schema, title), key, examples, put)
    cases += [
        (f"a robot {robot}", {**BASE, "robots": [robot]}, False)
        for robot in ({"x": 1}, {"row": 1}, {}, {"x": 1, "y": 1, "column": 1, "row": 1}, {"x": 1, "row": 1})
    ]
    return cases + [("no map", {key: value for key, value in BASE.items() if key != "map"}, False)]


def check_one_list(reference, schema):
    """Each heading's keys are its schema's properties."""
    faults = []
    for title, examples in examples_of(reference).items():
        properties = set((schema_of(schema, title) or {}).get("properties", {}))
        faults += [f"{title}: {key} is in one of docs/mission.md and the schema" for key in sorted(properties ^ set(examples))]
    return faults


def check_page(path, printed):
    held = path.read_text(encoding="utf-8")
    return [] if held == printed else [f"{path} is not what `quarter keys` prints: make it anew"]


def verdict_of_reader(quarter, path):
    done = subprocess.run([quarter, "draw", path, "-o", "-"], capture_output=True, encoding="utf-8", errors="replace")
    return done.returncode == 0, done.stderr.strip()


def check_verdicts(cases, validator, read):
    """`read`: mission -> (verdict, what the reader said)."""
    faults = []
    for what, mission, wanted in cases:
        by_schema = validator.is_valid(mission)
        by_reader, said = read(mission)
        if by_schema != wanted:
            faults.append(f"{what}: the schema says {by_schema}: {[error.message for error in validator.iter_errors(mission)]}")
        if by_reader != wanted:
            faults.append(f"{what}: the reader says {by_reader}: {said}")
    return faults


def check_shipped(source, validator, quarter):
    faults = []
    missions = sorted(source.glob("demo/missions/*/mission.yaml"))
    if len(missions) < 4:
        faults.append(f"{len(missions)} missions are shipped")
    for path in missions:
        faults += [f"{path}: {error.message}" for error in validator.iter_errors(load(path.read_text(encoding="utf-8")))]
        verdict, said = verdict_of_reader(quarter, path)
        faults += [] if verdict else [f"{path}: {said}"]
    return faults


def prove():
    """That the checks can fail."""
    schema = {"title": "The mission", "properties": {"a": {"type": "number", "exclusiveMinimum": 0}}, "type": "object"}
    page = "\n## The mission\n\n| `a` | x | a number |  | 1 | `2` |\n"
    validator = jsonschema.Draft7Validator(schema)
    read = {"yes": lambda _: (True, ""), "no": lambda _: (False, "x")}
    self_test(
        [
            ("alike", (page, schema), 0),
            ("a key more", (page + "| `b` | x | a text |  |  | `c` |\n", schema), 1),
        ],
        check_one_list,
    )
    self_test(
        [
            ("both take it", ([("x", {"a": 1}, True)], validator, read["yes"]), 0),
            ("the reader does not", ([("x", {"a": 1}, True)], validator, read["no"]), 1),
            ("the schema does", ([("x", {"a": 1}, False)], validator, read["no"]), 1),
        ],
        check_verdicts,
    )


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--quarter", required=True, type=pathlib.Path)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    options = parser.parse_args()
    prove()
    printed = [
        subprocess.run([options.quarter, "keys", *words], capture_output=True, check=True, encoding="utf-8").stdout
        for words in ([], ["--json"])
    ]
    schema = json.loads(printed[1])
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    for name, text in FILES.items():
        pathlib.Path(name).write_text(text, encoding="utf-8")

    def read(mission):
        pathlib.Path("mission.yaml").write_text(dump(mission), encoding="utf-8")
        return verdict_of_reader(options.quarter, "mission.yaml")

    cases = cases_of(printed[0], schema)
    faults = check_page(options.source / "docs/mission.md", printed[0])
    faults += check_page(options.source / "docs/mission.schema.json", printed[1])
    faults += check_one_list(printed[0], schema)
    faults += check_verdicts(cases, validator, read)
    faults += check_shipped(options.source, validator, options.quarter)
    report(faults, f"{len(cases)} missions judged alike")


if __name__ == "__main__":
    main()
