"""Tests that wait most of the time, run side by side."""

import collections
import concurrent.futures
import sys
import unittest


AT_ONCE = 12


class Runner(unittest.TextTestRunner):
    """Tests side by side. Where all were skipped, status 77."""

    def run(self, test):
        result = super().run(SideBySide(flatten(test)))
        tell_skipped(result)
        return result


def tell_skipped(result):
    """A line for each reason why tests were skipped, which `./run test` shows; ends with 77 if there were no others."""
    for reason, times in collections.Counter(reason for _, reason in result.skipped).items():
        print(f"SKIPPED: {times} of {result.testsRun} cases: {reason}", flush=True)
    if result.skipped and len(result.skipped) == result.testsRun and result.wasSuccessful():
        sys.exit(77)


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
