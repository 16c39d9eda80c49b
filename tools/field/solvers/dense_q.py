"""Plain Q-learning, as one would write it first: the joint game, a table of all that is met, looks left and where each robot is
bound for with the steps that remain; epsilon-greedy, one-step backups, no bound and nothing proved."""

import random

from common import solve

MOST_LOOKS = 20
EPSILON = 0.2
GREEDY_EVERY = 20  # games


class Game:
    """Robots choose one after another when they are idle; a robot may also stop for good."""

    def __init__(self, problem):
        self.problem = problem

    def begin(self):
        nodes = tuple((self.problem.start_node(robot), 0) for robot in range(self.problem.robots))
        return (frozenset(range(self.problem.looks)), nodes)

    def chooser(self, state):
        """The first idle robot; None: all are under way, or have stopped."""
        return next((robot for robot, (node, left) in enumerate(state[1]) if node is not None and left == 0), None)

    def choices(self, state, robot):
        free, robots = state
        node = robots[robot][0]
        ways = [look for look in free if self.problem.way(robot, node, look) is not None]
        in_game = sum(1 for node, _ in robots if node is not None)
        return ways + [None] if in_game > 1 or not ways else ways

    def choose(self, state, robot, look):
        """Looks that somebody is bound for are nobody else's to choose."""
        free, robots = state
        node = robots[robot][0]
        to = (None, 0) if look is None else (look, self.problem.way(robot, node, look))
        return (free - {look}, robots[:robot] + (to,) + robots[robot + 1:])

    def advance(self, state):
        """Steps until the next arrival, the looks made then, and the state."""
        free, robots = state
        step = min((left for node, left in robots if left > 0), default=0)
        made = [node for node, left in robots if 0 < left == step]
        return step, made, (free, tuple((node, max(left - step, 0)) for node, left in robots))


class Learner:
    """Q of a state and a choice: the cost (or worth) that is still to come, counted from then."""

    def __init__(self, problem, seed):
        self.problem, self.game, self.q, self.random = problem, Game(problem), {}, random.Random(seed)

    def key(self, state, look):
        return (state, look)

    def pick(self, state, choices, greedy):
        if not greedy and self.random.random() < EPSILON:
            return self.random.choice(choices)
        best = min if self.problem.by_time else max
        return best(choices, key=lambda look: (self.q.get(self.key(state, look), 0.0), look is None, look or 0))

    def value(self, state):
        robot = self.game.chooser(state)
        values = [self.q.get(self.key(state, look), 0.0) for look in self.game.choices(state, robot)]
        return min(values) if self.problem.by_time else max(values)

    def pass_time(self, state, pending):
        """On to the next choice: what comes meanwhile, its discount, the state (None: the game is over), the looks made."""
        worth, discount, made_all, now = 0.0, 1.0, [], 0
        while self.game.chooser(state) is None:
            step, made, state = self.game.advance(state)
            if step == 0:
                return worth, discount, None, made_all
            now += step
            worth += self.worth(now, step, made, pending)
            pending -= sum(self.problem.share[look] for look in made)
            discount = self.problem.gamma ** now
            made_all += made
        return worth, discount, state, made_all

    def worth(self, now, step, made, pending):
        if self.problem.by_time:
            return pending * step
        return sum(10 * self.problem.share[look] for look in made) * self.problem.gamma ** (now - 1)

    def play(self, greedy):
        state, pending = self.game.begin(), self.problem.findable
        routes = [[] for _ in range(self.problem.robots)]
        while state is not None:
            robot = self.game.chooser(state)
            look = self.pick(state, self.game.choices(state, robot), greedy)
            if look is not None:
                routes[robot].append(look)
            worth, discount, after, made = self.pass_time(self.game.choose(state, robot, look), pending)
            if not greedy:
                self.back_up(state, look, worth, discount, after)
            pending -= sum(self.problem.share[made_look] for made_look in made)
            state = after
        return routes

    def back_up(self, state, look, worth, discount, after):
        discount = 1.0 if self.problem.by_time else discount
        rest = 0.0 if after is None else self.value(after)
        if after is None and self.problem.by_time and state[0] - {look}:
            worth += 1e9  # looks are left, and nobody is in the game
        self.q[self.key(state, look)] = worth + discount * rest


def cost_of(problem, routes):
    """To be minimised."""
    cost, made = 0.0, 0
    for robot, route in enumerate(routes):
        for look, when in zip(route, problem.arrivals(robot, route)):
            cost += problem.share[look] * when if problem.by_time else -problem.value_of(look, when)
            made += 1
    return cost if made == problem.looks else float("inf")


def optimise(problem, clock, teller):
    if problem.looks > MOST_LOOKS:
        teller.note("more looks than its table is for")
        return
    learner, best, games = Learner(problem, 1), float("inf"), 0
    while clock.left() > 0:
        games += 1
        routes = learner.play(greedy=games % GREEDY_EVERY == 0)
        if games % GREEDY_EVERY == 0 and cost_of(problem, routes) < best - 1e-12:
            best = cost_of(problem, routes)
            teller.routes(routes)


if __name__ == "__main__":
    solve(optimise)
