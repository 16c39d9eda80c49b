"""OR-Tools' CP-SAT: one tour through all looks and all robots' starts, in which a robot's route ends where the next robot's
start follows; arrivals as integers. Expected time and discounted value are both its true objective, the latter by a table of
whole numbers for each look. It begins from the plan that goes to what is nearest."""

from ortools.sat.python import cp_model

from common import nearest_first, solve

SCALE = 1_000_000       # of discounted worth, to whole numbers
LITERALS = 400_000      # more ways than these it does not come to grips with in any time of ours
TABLE = 2_000_000       # entries of all tables of worth


class Tour:
    """The model. Nodes: looks, then robots; arcs into a robot's node end the route before it."""

    def __init__(self, problem):
        self.problem, self.model = problem, cp_model.CpModel()
        self.horizon = 2 * problem.horizon()
        self.arrival = [self.model.new_int_var(0, self.horizon, f"t{look}") for look in range(problem.looks)]
        self.arcs, self.taken = [], {}
        self.of_class = [[self.model.new_bool_var("") for _ in range(problem.classes)] for _ in range(problem.looks)]
        self.add_ways()
        self.model.add_circuit(self.arcs)

    def add_arc(self, tail, head, of_class):
        literal = self.model.new_bool_var("")
        self.arcs.append((tail, head, literal))
        self.taken[tail, head, of_class] = literal
        return literal

    def add_ways(self):
        problem = self.problem
        for look in range(problem.looks):
            self.model.add_exactly_one(self.of_class[look])
            for robot in range(problem.robots):
                self.add_arc(look, problem.looks + robot, None)
            for other in range(problem.looks):
                for c in range(problem.classes):
                    self.add_way(look, other, c)
        for robot in range(problem.robots):
            for other in range(problem.robots):
                if problem.robots == 1 or robot != other:
                    self.add_arc(problem.looks + robot, problem.looks + other, None)
            for look in range(problem.looks):
                self.add_way(problem.looks + robot, look, problem.class_of[robot])

    def add_way(self, tail, look, of_class):
        """From a look or a robot's start to a look, by a class's time."""
        problem = self.problem
        is_start = tail >= problem.looks
        node = problem.start_node(tail - problem.looks) if is_start else tail
        steps = problem.steps[of_class][node][look]
        if tail == look or steps is None:
            return
        literal = self.add_arc(tail, look, of_class)
        before = 0 if is_start else self.arrival[tail]
        self.model.add(self.arrival[look] == before + steps).only_enforce_if(literal)
        self.model.add_implication(literal, self.of_class[look][of_class])
        if not is_start:
            self.model.add_implication(literal, self.of_class[tail][of_class])

    def set_objective(self):
        """The objective, and what makes its own unit of the model's."""
        problem = self.problem
        if problem.by_time:
            weights, unit = problem.units()
            self.model.minimize(sum(w * t for w, t in zip(weights, self.arrival)))
            return lambda bound: bound * unit / problem.findable
        worths = []
        for look in range(problem.looks):
            table = [round(SCALE * problem.value_of(look, when)) for when in range(self.horizon + 1)]
            worths.append(self.model.new_int_var(0, table[0], ""))
            self.model.add_element(self.arrival[look], table, worths[-1])
        self.model.maximize(sum(worths))
        return lambda bound: (bound + problem.looks * 0.5) / SCALE

    def hint(self, routes):
        chosen = set()
        for robot, route in enumerate(routes):
            nodes = [self.problem.looks + robot] + route
            chosen.update((tail, head, self.problem.class_of[robot]) for tail, head in zip(nodes, nodes[1:]))
            chosen.add((nodes[-1], self.problem.looks + (robot + 1) % self.problem.robots, None))
            for look, when in zip(route, self.problem.arrivals(robot, route)):
                self.model.add_hint(self.arrival[look], when)
        for arc, literal in self.taken.items():
            self.model.add_hint(literal, arc in chosen)

    def routes(self, is_taken):
        after = {tail: head for (tail, head, _), literal in self.taken.items() if is_taken(literal)}
        routes = []
        for robot in range(self.problem.robots):
            node, route = after[self.problem.looks + robot], []
            while node < self.problem.looks:
                route.append(node)
                node = after[node]
            routes.append(route)
        return routes


class Watch(cp_model.CpSolverSolutionCallback):
    def __init__(self, tour, teller):
        super().__init__()
        self.tour, self.teller = tour, teller

    def on_solution_callback(self):
        self.teller.routes(self.tour.routes(self.boolean_value))


def too_large(problem):
    ways = problem.looks ** 2 * problem.classes
    return ways > LITERALS or (not problem.by_time and problem.looks * 2 * problem.horizon() > TABLE)


def optimise(problem, clock, teller):
    if too_large(problem):
        teller.note("its model would be too large")
        return
    tour = Tour(problem)
    in_own_unit = tour.set_objective()
    tour.hint(nearest_first(problem))
    solver = cp_model.CpSolver()
    solver.parameters.num_workers = 1
    solver.parameters.max_time_in_seconds = 100 * clock.limit + 10  # the clock's timer ends it
    solver.best_bound_callback = lambda bound: teller.bound(in_own_unit(bound))
    status = solver.solve(tour.model, Watch(tour, teller))
    if status == cp_model.OPTIMAL:
        teller.bound(in_own_unit(solver.best_objective_bound))
        teller.proved()


if __name__ == "__main__":
    solve(optimise)
