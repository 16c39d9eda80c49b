"""Tests that wait most of the time, run side by side."""

import collections
import concurrent.futures
import sys
import unittest


AT_ONCE = 8


class Telling(unittest.TextTestRunner):
    """Says what was skipped, and why, as `./run test` shows it. Ends with 77 if that was all."""

    def run(self, test):
        result = super().run(test)
        for reason, times in collections.Counter(reason for _, reason in result.skipped).items():
            print(f"SKIPPED: {times} of {result.testsRun} cases: {reason}", flush=True)
        if result.skipped and len(result.skipped) == result.testsRun and result.wasSuccessful():
            sys.exit(77)
        return result


class Runner(Telling):
    def run(self, test):
        return super().run(SideBySide(flatten(test)))


def flatten(suite):
    for test in suite:
        yield from flatten(test) if isinstance(test, unittest.TestSuite) else [test]


class SideBySide(unittest.TestSuite):
    """Reports one test after the other. Fixtures of classes and modules are not run."""

    def run(self, result, debug=False):
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            futures = [(test, pool.submit(self.run_one, test)) for test in self]
            for test, future in futures:
                self.report(test, future.result(), result)
        return result

    def run_one(self, test):
        own = unittest.TestResult()
        test.run(own)
        return own

    def report(self, test, own, result):
        result.startTest(test)
        result.failures += own.failures
        result.errors += own.errors
        result.skipped += own.skipped
        if own.wasSuccessful() and not own.skipped:
            result.addSuccess(test)
        elif result.showAll or result.dots:
            result.stream.writeln("skipped" if own.wasSuccessful() else "FAILED")
        result.stopTest(test)
