"""OR-Tools' routing library: insertion, then guided local search. It plays for the expected time, each look's arrival weighed
in its cost; there is no cost in it that is discounted, so that discounted problems are played for the time, too."""

from ortools.constraint_solver import pywrapcp, routing_enums_pb2

from common import solve


def matrix_of(problem, of_class):
    """Nodes: looks, starts, and an end that costs nothing."""
    far = 10 * problem.horizon() + 1
    rows = [[far if way is None else way for way in row] + [far] * problem.starts + [0] for row in problem.steps[of_class]]
    return rows + [[0] * (problem.looks + problem.starts + 1)]


def add_time(problem, routing, manager):
    """Each vehicle by its class's times; what is weighed is each arrival. Ways cost their steps, too: next to nothing beside the
    arrivals, and insertion and search find much better plans by it."""
    transits = [routing.RegisterTransitMatrix(matrix_of(problem, c)) for c in range(problem.classes)]
    routing.AddDimensionWithVehicleTransits([transits[c] for c in problem.class_of], 0, 20 * problem.horizon(), True, "time")
    for robot, of_class in enumerate(problem.class_of):
        routing.SetArcCostEvaluatorOfVehicle(transits[of_class], robot)
    dimension = routing.GetDimensionOrDie("time")
    for look, weight in enumerate(problem.units()[0]):
        dimension.SetCumulVarSoftUpperBound(manager.NodeToIndex(look), 0, weight)
    return dimension


def routes_of(problem, routing, manager):
    routes = []
    for robot in range(problem.robots):
        index, route = routing.NextVar(routing.Start(robot)).Value(), []
        while not routing.IsEnd(index):
            route.append(manager.IndexToNode(index))
            index = routing.NextVar(index).Value()
        routes.append(route)
    return routes


def optimise(problem, clock, teller):
    end = problem.looks + problem.starts
    starts = [problem.start_node(robot) for robot in range(problem.robots)]
    manager = pywrapcp.RoutingIndexManager(end + 1, problem.robots, starts, [end] * problem.robots)
    routing = pywrapcp.RoutingModel(manager)
    add_time(problem, routing, manager)
    best = [None]

    def note():
        cost = routing.CostVar().Max()
        if best[0] is None or cost < best[0]:
            best[0] = cost
            teller.routes(routes_of(problem, routing, manager))

    routing.AddAtSolutionCallback(note)
    parameters = pywrapcp.DefaultRoutingSearchParameters()
    parameters.first_solution_strategy = routing_enums_pb2.FirstSolutionStrategy.PARALLEL_CHEAPEST_INSERTION
    parameters.local_search_metaheuristic = routing_enums_pb2.LocalSearchMetaheuristic.GUIDED_LOCAL_SEARCH
    parameters.guided_local_search_lambda_coefficient = 10.0  # ways are little of the cost: penalties must be felt
    parameters.time_limit.FromSeconds(int(100 * clock.limit) + 10)  # the clock's timer ends it
    if routing.SolveWithParameters(parameters) is None and best[0] is None:
        teller.note("it found no plan")


if __name__ == "__main__":
    solve(optimise)
