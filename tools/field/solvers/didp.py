"""Domain-independent dynamic programming (didppy): robots play one after another; a state is the looks that are left, the robot
whose turn it is, where it is, and when. Complete anytime beam search, CABS. Both objectives are its true ones."""

import didppy as dp

from common import solve

MOST_LOOKS = 300


class Model:
    def __init__(self, problem):
        self.problem, self.by_time = problem, problem.by_time
        self.model = dp.Model(maximize=not self.by_time, float_cost=True)
        self.look = self.model.add_object_type(number=problem.looks)
        self.node = self.model.add_object_type(number=problem.looks + problem.starts)
        self.robot = self.model.add_object_type(number=problem.robots)
        self.left = self.model.add_set_var(object_type=self.look, target=list(range(problem.looks)))
        self.turn = self.model.add_element_var(object_type=self.robot, target=0)
        self.at = self.model.add_element_var(object_type=self.node, target=problem.start_node(0))
        self.add_clock()
        for look in range(problem.looks):
            self.add_look(look)
        for robot in range(1, problem.robots):
            self.add_turn(robot)
        self.model.add_base_case([self.left.is_empty()])
        self.model.add_dual_bound(self.least_table()[self.left])

    def add_clock(self):
        """Expected time: the step; discounted: gamma^(step - 1). To be somewhere sooner, with the same left to do, is never
        worse."""
        gamma = self.problem.gamma
        if self.by_time:
            self.begin = 0
            self.now = self.model.add_int_resource_var(target=self.begin, less_is_better=True)
            self.way = self.model.add_int_table(self.table(lambda way: way, 0))
        else:
            self.begin = 1 / gamma
            self.now = self.model.add_float_resource_var(target=self.begin, less_is_better=False)
            self.way = self.model.add_float_table(self.table(lambda way: gamma ** way, 0.0))

    def table(self, of_way, none):
        """By robot, node and look."""
        matrices = [[[none if way is None else of_way(way) for way in row] for row in matrix] for matrix in self.problem.steps]
        return [matrices[of_class] for of_class in self.problem.class_of]

    def ways(self, look):
        rows = [row[look] for matrix in self.problem.steps for row in matrix]
        return [way for way in rows if way]

    def least_table(self):
        """Each look that is left, at the end of the shortest way to it."""
        return self.model.add_float_table([self.worth(look, min(self.ways(look))) for look in range(self.problem.looks)])

    def worth(self, look, when):
        if self.by_time:
            return self.problem.share[look] / self.problem.findable * when
        return self.problem.value_of(look, when)

    def add_look(self, look):
        way = self.way[self.turn, self.at, look]
        if self.by_time:
            when = self.now + way
            worth = self.problem.share[look] / self.problem.findable * when
        else:
            when = self.now * way
            worth = 10 * self.problem.share[look] * when
        self.model.add_transition(dp.Transition(
            name=f"look {look}", cost=worth + dp.FloatExpr.state_cost(),
            preconditions=[self.left.contains(look), way > 0],
            effects=[(self.left, self.left.remove(look)), (self.at, look), (self.now, when)]))

    def add_turn(self, robot):
        self.model.add_transition(dp.Transition(
            name=f"robot {robot}", cost=dp.FloatExpr.state_cost(), preconditions=[self.turn == robot - 1],
            effects=[(self.turn, robot), (self.at, self.problem.start_node(robot)), (self.now, self.begin)]))

    def routes(self, transitions):
        routes = [[]]
        for transition in transitions:
            kind, number = transition.name.split()
            if kind == "robot":
                routes.append([])
            else:
                routes[-1].append(int(number))
        return routes + [[] for _ in range(self.problem.robots - len(routes))]


def optimise(problem, clock, teller):
    if problem.looks > MOST_LOOKS:
        teller.note("its model would be too large")
        return
    made = Model(problem)
    solver = dp.CABS(made.model, f_operator=dp.FOperator.Plus, time_limit=100 * clock.limit + 10, threads=1, quiet=True)
    over, best = False, None
    while not over:
        solution, over = solver.search_next()
        if solution.cost is not None and solution.cost != best:
            best = solution.cost
            teller.routes(made.routes(solution.transitions))
        if solution.best_bound is not None:
            teller.bound(solution.best_bound)
        if solution.is_optimal:
            teller.proved()


if __name__ == "__main__":
    solve(optimise)
