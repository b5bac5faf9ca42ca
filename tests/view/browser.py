# SPDX-License-Identifier: BSD-3-Clause
"""Chromium without a window, driven by the pipe of its DevTools protocol."""
import base64
import json
import os
import shutil
import struct
import subprocess
import tempfile
import zlib


def chromium():
    """The program, or None."""
    return shutil.which("chromium") or shutil.which("chromium-browser")


class Browser:
    """One page in a browser of its own. `problems` collects what the page reports on its console."""

    def __init__(self, size=(1000, 700)):
        self.profile = tempfile.mkdtemp(prefix="ogive_browser_")
        commands, self.to_browser = os.pipe()
        self.from_browser, answers = os.pipe()

        def place_pipes():
            # Copies first: either end may already have the number that the other needs.
            pair = os.dup(commands), os.dup(answers)
            os.dup2(pair[0], 3)
            os.dup2(pair[1], 4)

        self.process = subprocess.Popen(
            [chromium(), "--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--no-first-run",
             "--disable-dev-shm-usage", "--disable-extensions", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             "--proxy-server=127.0.0.1:9", f"--user-data-dir={self.profile}", f"--window-size={size[0]},{size[1]}",
             "about:blank"],
            preexec_fn=place_pipes, pass_fds=(3, 4, commands, answers), stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(commands)
        os.close(answers)
        self.number, self.rest, self.problems, self.session = 0, b"", [], None
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target["targetId"] for target in targets if target["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=1, mobile=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.session = None
            self.call("Browser.close")
            self.process.wait(10)
        except (OSError, EOFError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.to_browser)
        os.close(self.from_browser)
        shutil.rmtree(self.profile, ignore_errors=True)

    def _receive(self):
        while b"\0" not in self.rest:
            more = os.read(self.from_browser, 1 << 20)
            if not more:
                raise EOFError("the browser has gone")
            self.rest += more
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **parameters):
        """The result of one command of the protocol."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        while True:
            answer = self._receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self._note(answer)

    def _note(self, event):
        parameters = event.get("params", {})
        if event.get("method") == "Runtime.exceptionThrown":
            self.problems.append(parameters["exceptionDetails"].get("exception", {}).get("description", "exception"))
        if event.get("method") == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
            self.problems.append(" ".join(str(a.get("value", a.get("description"))) for a in parameters["args"]))
        if event.get("method") == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            self.problems.append(parameters["entry"]["text"])

    def value(self, expression):
        """The value of a JavaScript expression in the page."""
        result = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{expression}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def wait_for(self, expression, seconds=120):
        """Waits until an expression is true."""
        done = self.value(f"""new Promise(resolve => {{
            const end = performance.now() + {1000 * seconds};
            const look = () => {expression} ? resolve(true) : performance.now() > end ? resolve(false) : setTimeout(look, 20);
            look();
        }})""")
        if not done:
            raise TimeoutError(f"{expression} after {seconds} s; console: {self.problems}")

    def open(self, path):
        self.call("Page.navigate", url=f"file://{path}")

    def press(self, key, shift=False):
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, modifiers=8 if shift else 0,
                      **({"text": key} if kind == "keyDown" and len(key) == 1 else {}))

    def point(self, x, y):
        self.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def picture(self, selector=None):
        """What the page shows, or one element of it: width, height, and rows of red, green and blue."""
        parameters = {}
        if selector:
            box = self.value(f"""(() => {{ const b = document.querySelector({json.dumps(selector)}).getBoundingClientRect();
                return {{x: b.x, y: b.y, width: b.width, height: b.height, scale: 1}}; }})()""")
            parameters["clip"] = box
        self.value("new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(() => resolve(true))))")
        return base64.b64decode(self.call("Page.captureScreenshot", format="png", **parameters)["data"])


def pixels(png):
    """A PNG of 8 bits without a palette or interlacing: width, height, and the (r, g, b) of all pixels, row by row."""
    at, data = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, colours = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            data += body
        at += 12 + length
    size = {2: 3, 6: 4}[colours]
    raw, row_bytes = zlib.decompress(data), size * width
    above, found = bytearray(row_bytes), []
    for y in range(height):
        kind, line = raw[y * (row_bytes + 1)], bytearray(raw[y * (row_bytes + 1) + 1:(y + 1) * (row_bytes + 1)])
        for x in range(row_bytes):
            a, b, c = (line[x - size] if x >= size else 0), above[x], (above[x - size] if x >= size else 0)
            guess = a + b - c
            paeth = min((abs(guess - a), 0, a), (abs(guess - b), 1, b), (abs(guess - c), 2, c))[2]
            line[x] = (line[x] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        found += [tuple(line[x:x + 3]) for x in range(0, row_bytes, size)]
        above = line
    return width, height, found
