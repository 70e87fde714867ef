# SPDX-License-Identifier: GPL-3.0-or-later
"""A headless Chromium for the manual and for tests, driven by its DevTools protocol through a pipe:
nothing but Python's own library is needed."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

PROGRAM = shutil.which("chromium")
FLAGS = ("--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --hide-scrollbars "
         "--disable-background-networking --disable-component-update --disable-sync "
         "--disable-extensions --remote-debugging-pipe").split()
WEBGL = "--use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader".split()  # without a graphics card
NO_WEBGL = ["--disable-3d-apis"]
SLOW = "GPU stall due to ReadPixels"  # as a picture of the page is taken: not the page's fault
SECONDS = 300.0  # that one answer may take, as a PDF on a busy machine does


class BrowserError(Exception):
    pass


class Browser:
    """One browser with one page. `errors`: what scripts, the console and loading had to complain of
    since the last open(). `webgl`: it draws in space."""

    def __init__(self, webgl=True):
        self._profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_browser, self._out = os.pipe()
        self._in, from_browser = os.pipe()

        def hand_over():  # the browser reads from 3 and writes to 4
            reading, writing = os.dup(to_browser), os.dup(from_browser)
            os.dup2(reading, 3)
            os.dup2(writing, 4)

        self._child = subprocess.Popen(
            [PROGRAM, *FLAGS, *(WEBGL if webgl else NO_WEBGL), f"--user-data-dir={self._profile.name}", "about:blank"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            preexec_fn=hand_over, pass_fds=(3, 4))
        os.close(to_browser)
        os.close(from_browser)
        self._rest = b""
        self._count = 0
        self._session = None
        self._events = []
        self.errors = []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self._session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        try:
            self._session = None
            self.call("Browser.close")
            self._child.wait(timeout=10)
        except (BrowserError, OSError, subprocess.TimeoutExpired):
            self._child.kill()
            self._child.wait()
        os.close(self._in)
        os.close(self._out)
        self._profile.cleanup()

    def _read(self, deadline):
        while b"\0" not in self._rest:
            if not select.select([self._in], [], [], max(0.0, deadline - time.monotonic()))[0]:
                raise BrowserError("no answer from chromium")
            piece = os.read(self._in, 1 << 20)
            if not piece:
                raise BrowserError("chromium has ended")
            self._rest += piece
        message, self._rest = self._rest.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **params):
        """The result of a method of the protocol."""
        self._count += 1
        message = {"id": self._count, "method": method, "params": params}
        if self._session:
            message["sessionId"] = self._session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self._out, data):]
        deadline = time.monotonic() + SECONDS
        while True:
            answer = self._read(deadline)
            if answer.get("id") == self._count:
                if "error" in answer:
                    raise BrowserError(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self._take(answer)

    def _take(self, event):
        method, params = event.get("method"), event.get("params", {})
        self._events.append(method)
        if method == "Runtime.exceptionThrown":
            details = params["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description") or details["text"])
        elif method == "Runtime.consoleAPICalled" and params["type"] in ("error", "warning", "assert"):
            self.errors.append(" ".join(str(a.get("value", a.get("description"))) for a in params["args"]))
        elif method == "Log.entryAdded" and params["entry"]["level"] in ("error", "warning"):
            entry = params["entry"]
            if SLOW not in entry["text"]:
                self.errors.append(f"{entry['text']} {entry.get('url', '')}")
        elif method == "Network.loadingFailed" and not params.get("canceled"):
            self.errors.append(f"not loaded: {params['errorText']}")

    def width(self, pixels, height=900):
        self.call("Emulation.setDeviceMetricsOverride", width=pixels, height=height,
                  deviceScaleFactor=1, mobile=False)

    def open(self, url):
        """Loads a page and waits until scripts, pictures and fonts are there."""
        self._events.clear()
        self.errors.clear()
        failed = self.call("Page.navigate", url=url).get("errorText")
        if failed:
            raise BrowserError(f"{url}: {failed}")
        deadline = time.monotonic() + SECONDS
        while "Page.loadEventFired" not in self._events:
            self._take(self._read(deadline))
        self.value("document.fonts.ready.then(() => true)")

    def value(self, expression):
        """The value of an expression, or of what it promises, in the page."""
        result = self.call("Runtime.evaluate", expression=expression, awaitPromise=True,
                           returnByValue=True)
        if "exceptionDetails" in result:
            raise BrowserError(result["exceptionDetails"]["exception"]["description"])
        return result["result"].get("value")

    def picture(self, x, y, width, height):
        """A part of the page as it is seen, PNG; pixels of the window."""
        self.settle()
        left, top = self.value("[window.scrollX, window.scrollY]")
        clip = {"x": left + x, "y": top + y, "width": width, "height": height, "scale": 1}
        picture = self.call("Page.captureScreenshot", format="png", clip=clip, optimizeForSpeed=True)
        return base64.b64decode(picture["data"])

    def settle(self):
        """Waits until what was changed has been drawn."""
        self.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")

    def mouse(self, kind, x, y, buttons=0, **more):
        """Moves ("mouseMoved"), presses, lets go or rolls the mouse at a pixel of the window; `buttons` are held."""
        button = "left" if kind in ("mousePressed", "mouseReleased") else "none"
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons,
                  clickCount=1 if button == "left" else 0, **more)

    def drag(self, begin, end):
        """The mouse pressed at a pixel, moved to another one, and let go."""
        self.mouse("mouseMoved", *begin)
        self.mouse("mousePressed", *begin, buttons=1)
        for part in (0.3, 0.6, 1.0):
            self.mouse("mouseMoved", *(a + part * (b - a) for a, b in zip(begin, end)), buttons=1)
        self.mouse("mouseReleased", *end)
