"""A browser without a window, driven through chromedriver by the W3C WebDriver protocol. The standard library alone.

What a test waits for the page itself looks for, and says when it has come.
"""

import base64
import functools
import json
import os
import pathlib
import re
import shutil
import socket
import subprocess
import tempfile
import threading
import urllib.error
import urllib.request

DEADLINE = 240  # seconds: no measure of anything, only what ends a test that hangs
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
)
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the key that the protocol wraps an element's name in
KEYS = {"space": " ", "end": "\ue010", "home": "\ue011", "left": "\ue012", "right": "\ue014", "shift": "\ue008"}


def runs(program):
    """Whether a program of that name is there and runs: Ubuntu has stubs, which only name another package."""
    if shutil.which(program) is None:
        return False
    return subprocess.run([program, "--version"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode == 0


def knows_localhost():
    """Whether the name is one of this machine's: chromedriver calls the browser by it. A bare root has no /etc/hosts."""
    try:
        return bool(socket.getaddrinfo("localhost", 80))
    except OSError:
        return False


@functools.lru_cache
def installed():
    """The paths of a browser and its driver; None where one is missing."""
    browser = next(filter(runs, BROWSERS), None)
    return (shutil.which(browser), shutil.which("chromedriver")) if browser and runs("chromedriver") else None


# Whether the condition holds is looked at now and with every frame that the page draws: whatever shows is in one of them.
AWAIT = """
const given = [...arguments], done = given.pop();
const holds = (...arguments) => { %s };
const look = () => holds(...given) ? done() : requestAnimationFrame(look);
%s;
look();
"""


class Browser:
    """One session. Ends the driver, and with it the browser, on close()."""

    def __init__(self, width=1280, height=900):
        browser, driver = installed()
        self.profile = tempfile.mkdtemp(prefix="browser-", dir=pathlib.Path.cwd())
        self.session = None
        self.opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))  # loopback goes through no proxy
        home = {name: self.profile for name in ("HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME")}
        environment = {**os.environ, **home}
        environment.pop("LD_PRELOAD", None)  # faketime's lock would bring a browser's many threads to a stand
        self.driver = subprocess.Popen(
            [driver, "--port=0"],
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            encoding="utf-8",
            env=environment,
        )
        try:
            self.port = self.listening_port()
            self.session = self.call("POST", "/session", self.wishes(browser, width, height))["sessionId"]
            self.post("/timeouts", script=1000 * DEADLINE)
        except BaseException:
            self.close()
            raise

    def wishes(self, browser, width, height):
        flags = [*FLAGS, f"--user-data-dir={self.profile}", f"--window-size={width},{height}"]
        options = {"binary": browser, "args": flags}
        wishes = {"browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
        return {"capabilities": {"alwaysMatch": wishes}}

    def listening_port(self):
        """The driver says when it listens, and where."""
        for line in self.driver.stdout:
            if match := re.search("started successfully on port ([0-9]+)", line):
                threading.Thread(target=self.driver.stdout.read, daemon=True).start()  # or it would fill
                return int(match[1])
        raise AssertionError(f"chromedriver ended with {self.driver.wait()} before it listened")

    def call(self, method, path, body=None):
        data = None if method in ("GET", "DELETE") else json.dumps(body or {}).encode()
        request = urllib.request.Request(
            f"http://127.0.0.1:{self.port}{path}", data, {"Content-Type": "application/json"}, method=method
        )
        try:
            with self.opener.open(request, timeout=DEADLINE) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise AssertionError(f"{method} {path}: {error.read().decode(errors='replace')[:600]}") from None

    def post(self, path, **body):
        return self.call("POST", f"/session/{self.session}{path}", body)

    def close(self):
        try:
            if self.session:
                self.call("DELETE", f"/session/{self.session}")
        finally:
            self.driver.terminate()
            self.driver.wait()
            shutil.rmtree(self.profile, ignore_errors=True)

    # What tests say.

    def open(self, url):
        self.post("/url", url=url)

    def run(self, script, *arguments):
        """What the function body `script` returns in the page."""
        return self.post("/execute/sync", script=script, args=list(arguments))

    def wait_for(self, condition, *arguments, first=""):
        """Until the function body `condition` returns something true in the page, once the statement `first` was done."""
        try:
            self.post("/execute/async", script=AWAIT % (condition, first), args=list(arguments))
        except AssertionError as error:
            raise AssertionError(f"waiting for: {condition} {arguments}: {error}") from None

    def draw(self, frames):
        """Until the page has drawn so many frames more."""
        count = "let left = arguments[0]; const done = arguments[1]; " \
            "requestAnimationFrame(function drawn() { left-- > 0 ? requestAnimationFrame(drawn) : done() })"
        self.post("/execute/async", script=count, args=[frames])

    def find(self, selector):
        return self.post("/element", using="css selector", value=selector)[ELEMENT]

    def click(self, selector):
        self.post(f"/element/{self.find(selector)}/click")

    def text(self, selector):
        """What the element holds, shown or not."""
        return self.run("return document.querySelector(arguments[0]).textContent", selector)

    def attribute(self, selector, name):
        return self.run("return document.querySelector(arguments[0]).getAttribute(arguments[1])", selector, name)

    def press(self, key, shift=False):
        """One key, by its name in KEYS or as a character, on whatever has the focus."""
        strokes = [("keyDown", KEYS.get(key, key)), ("keyUp", KEYS.get(key, key))]
        if shift:
            strokes = [("keyDown", KEYS["shift"]), *strokes, ("keyUp", KEYS["shift"])]
        actions = [{"type": kind, "value": value} for kind, value in strokes]
        self.post("/actions", actions=[{"type": "key", "id": "keyboard", "actions": actions}])

    def devtools(self, command, **parameters):
        return self.post("/goog/cdp/execute", cmd=command, params=parameters)

    def resize(self, width, height, ratio=1):
        """The page's size in CSS pixels; a window cannot be made as narrow as a phone."""
        self.devtools(
            "Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=ratio, mobile=False
        )

    def media(self, **features):
        """What the system wishes: prefers_color_scheme="dark", prefers_reduced_motion="reduce"."""
        wishes = [{"name": name.replace("_", "-"), "value": value} for name, value in features.items()]
        self.devtools("Emulation.setEmulatedMedia", features=wishes)

    def log(self):
        """The console's lines since the last call."""
        return self.post("/se/log", type="browser")

    def screenshot(self, path):
        """The whole page, not only what the window shows."""
        self.devtools("Emulation.setScrollbarsHidden", hidden=True)
        size = self.devtools("Page.getLayoutMetrics")["cssContentSize"]
        clip = {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}
        image = self.devtools("Page.captureScreenshot", captureBeyondViewport=True, clip=clip)["data"]
        pathlib.Path(path).write_bytes(base64.b64decode(image))
