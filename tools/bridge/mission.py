"""The map, the places and the plan, as `quarter inspect` tells them."""

import json
import subprocess

from faults import Fault


class Mission:
    """Positions are in metres in the map frame; without metres a cell is one metre and the origin the lower left."""

    def __init__(self, told):
        self.told = told
        self.take_map(told)
        self.places = [self.middle(place) for place in told["place"]]
        self.likelihood = [float(place["probability"]) for place in told["place"]]
        self.starts = [self.middle(start) for start in told["start"]]
        self.take_routes(told)

    def take_map(self, told):
        self.columns, self.rows = int(told["columns"]), int(told["rows"])
        self.cell = float(told.get("cell_size", 1.0))
        self.left, self.bottom = float(told.get("origin_x", 0.0)), float(told.get("origin_y", 0.0))
        self.map = told.get("map")
        if self.map is not None and [len(row) for row in self.map] != [self.columns] * self.rows:
            raise ValueError("map")

    def take_routes(self, told):
        self.routes = {int(route["seeker"]): [int(p) for p in route["places"]] for route in told["routes"]}
        self.owner = {place: seeker for seeker, places in self.routes.items() for place in places}
        if any(not 0 <= place < len(self.places) for place in self.owner):
            raise ValueError("routes")

    def middle(self, cell):
        return (self.left + (cell["column"] + 0.5) * self.cell,
                self.bottom + (self.rows - cell["row"] - 0.5) * self.cell)

    def planned(self, seeker):
        """The points that a robot is to come by, from its start on."""
        return [*self.starts[seeker : seeker + 1], *(self.places[place] for place in self.routes[seeker])]


def inspect(quarter, table):
    try:
        done = subprocess.run([quarter, "inspect", table, "--json"], capture_output=True, text=True, errors="replace")
    except OSError as error:
        raise Fault(f"{quarter}: the host tool does not start ({error.strerror}); build it, ./run quarter --version, "
                    "and name it, --quarter build/release/quarter") from None
    if done.returncode != 0:
        said = done.stderr.strip().splitlines()
        raise Fault(said[-1].removeprefix("quarter: ") if said
                    else f"{table}: {quarter} inspect failed with status {done.returncode}; try it by hand")
    try:
        return Mission(json.loads(done.stdout))
    except (ValueError, LookupError, TypeError, AttributeError):
        raise Fault(f"{quarter}: its inspect speaks otherwise than this bridge; take both from one checkout") from None
