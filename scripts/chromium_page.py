# Copyright (c) 2026 The Area Projection Transform authors.
#
# This file is part of the Area_projection_transform package.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A page in a headless Chromium, driven through its DevTools protocol over a pair of pipes: no screen, no network,
no other package."""

import base64
import fcntl
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]
# Drawn by the processor (SwiftShader), so that it works everywhere and looks the same.
FLAGS = ["--headless", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--hide-scrollbars", "--no-first-run", "--disable-extensions", "--disable-background-networking",
         "--disable-component-update", "--disable-dev-shm-usage", "--remote-debugging-pipe"]


class PageError(Exception):
    """What went wrong, in one line."""


def find_chromium():
    """The browser: that of the environment variable CHROMIUM, or the first that is installed; or None."""
    return os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)


class Page:
    """A page of its own browser, which ends with it: use it in a `with`.

    `errors` has what the page threw or logged as an error, `requests` the addresses that it asked for. `before` is a
    script that runs ahead of those of the page.
    """

    def __init__(self, address, size=(1200, 900), dark=False, scale=1, before="", timeout=120):
        self.errors, self.requests = [], []
        self._timeout = timeout
        self._answers, self._received, self._last = {}, b"", 0
        self._profile = tempfile.TemporaryDirectory(prefix="report-page-", ignore_cleanup_errors=True)
        self._start()
        try:
            self._open(address, size, dark, scale, before)
        except BaseException:
            self.__exit__()
            raise

    def _open(self, address, size, dark, scale, before):
        target = self._call("Target.createTarget", {"url": "about:blank"}, session=False)["targetId"]
        self._session = self._call("Target.attachToTarget", {"targetId": target, "flatten": True},
                                   session=False)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self._call(f"{domain}.enable")
        self.resize(*size, scale=scale)
        self._call("Emulation.setEmulatedMedia",
                   {"features": [{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})
        self._call("Page.addScriptToEvaluateOnNewDocument", {"source": before})
        self._call("Page.navigate", {"url": address})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self._call("Browser.close", session=False)
            self._browser.wait(10)
        except (PageError, subprocess.TimeoutExpired):
            self._browser.kill()
            self._browser.wait()
        os.close(self._input)
        os.close(self._output)
        self._profile.cleanup()

    def resize(self, width, height, scale=1):
        self._call("Emulation.setDeviceMetricsOverride",
                   {"width": width, "height": height, "deviceScaleFactor": scale, "mobile": False})

    def evaluate(self, expression):
        """The value of a JavaScript expression; a promise is waited for."""
        answer = self._call("Runtime.evaluate", {"expression": expression, "returnByValue": True, "awaitPromise": True})
        if "exceptionDetails" in answer:
            raise PageError(_message(answer["exceptionDetails"]))
        return answer["result"].get("value")

    def wait_for(self, condition, timeout=None):
        """Waits until a JavaScript expression is true."""
        end = time.monotonic() + (timeout or self._timeout)
        while not self.evaluate(condition):
            if time.monotonic() > end:
                reason = f": {self.errors[0]}" if self.errors else ""
                raise PageError(f"'{condition}' did not become true{reason}")
            time.sleep(0.05)

    def move_mouse(self, x, y):
        self._call("Input.dispatchMouseEvent", {"type": "mouseMoved", "x": x, "y": y})

    def press(self, key):
        for kind in ("keyDown", "keyUp"):
            self._call("Input.dispatchKeyEvent", {"type": kind, "key": key})

    def screenshot(self):
        """The page as it is seen, as a PNG file."""
        return base64.b64decode(self._call("Page.captureScreenshot", {"format": "png"})["data"])

    def _start(self):
        chromium = find_chromium()
        if not chromium:
            raise PageError("no Chromium found: install it (Debian, Ubuntu: chromium), or name it in CHROMIUM")
        for_browser, self._output = os.pipe()
        self._input, from_browser = os.pipe()
        # It reads commands from 3 and writes answers to 4. Far numbers first: a pipe may be 3 or 4 itself.
        far = [fcntl.fcntl(end, fcntl.F_DUPFD, 16) for end in (for_browser, from_browser)]
        self._browser = subprocess.Popen([chromium, *FLAGS, f"--user-data-dir={self._profile.name}"],
                                         preexec_fn=lambda: [os.dup2(end, 3 + i) for i, end in enumerate(far)],
                                         pass_fds=(3, 4), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for end in far:
            os.close(end)
        os.close(for_browser)
        os.close(from_browser)

    def _call(self, method, parameters=None, session=True):
        self._last += 1
        message = {"id": self._last, "method": method, "params": parameters or {}}
        if session:
            message["sessionId"] = self._session
        try:
            _write_all(self._output, json.dumps(message).encode() + b"\0")
        except BrokenPipeError:
            raise PageError("the browser ended early") from None
        end = time.monotonic() + self._timeout
        while self._last not in self._answers:
            self._receive(end - time.monotonic())
        answer = self._answers.pop(self._last)
        if "error" in answer:
            raise PageError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def _receive(self, seconds):
        readable, _, _ = select.select([self._input], [], [], max(seconds, 0))
        if not readable:
            raise PageError(f"the browser did not answer within {self._timeout} s")
        received = os.read(self._input, 1 << 20)
        if not received:
            raise PageError("the browser ended early")
        *messages, self._received = (self._received + received).split(b"\0")
        for message in map(json.loads, messages):
            if "id" in message:
                self._answers[message["id"]] = message
            else:
                self._notice(message["method"], message["params"])

    def _notice(self, event, details):
        if event == "Network.requestWillBeSent":
            self.requests.append(details["request"]["url"])
        elif event == "Runtime.exceptionThrown":
            self.errors.append(_message(details["exceptionDetails"]))
        elif event == "Log.entryAdded" and details["entry"]["level"] == "error":
            self.errors.append(details["entry"]["text"])
        elif event == "Runtime.consoleAPICalled" and details["type"] in ("error", "assert"):
            self.errors.append(" ".join(str(a.get("value", a.get("description"))) for a in details["args"]))


def _message(details):
    return details.get("exception", {}).get("description", details["text"])


def _write_all(file, data):
    while data:
        data = data[os.write(file, data):]
