"""A page in headless Chromium, by its debugging protocol over a pipe."""

import base64
import json
import os
import shutil
import subprocess
import tempfile
import time


class Browser:
    """One page; `log` has what it said on its console, its errors, and what it asked the network for."""

    def __init__(self, program, width, height):
        self.folder = tempfile.mkdtemp()
        self.log = []
        self.count = 0
        self.answers = {}
        self.buffer = b""
        to_read, self.to = os.pipe()
        self.back, back_write = os.pipe()

        def place():
            # The protocol is spoken on descriptors 3 and 4.
            a, b = os.dup(to_read), os.dup(back_write)
            os.dup2(a, 3)
            os.dup2(b, 4)

        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--no-first-run", "--disable-background-networking",
             "--disable-component-update", "--disable-sync", "--disable-quic", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--remote-debugging-pipe", f"--user-data-dir={self.folder}",
             f"--window-size={width},{height}", "about:blank"],
            preexec_fn=place, close_fds=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(back_write)
        self.session = None
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(each for each in targets if each["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def call(self, method, **parameters):
        self.count += 1
        words = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            words["sessionId"] = self.session
        os.write(self.to, json.dumps(words).encode() + b"\0")
        while self.count not in self.answers:
            while b"\0" not in self.buffer:
                more = os.read(self.back, 1 << 20)
                if not more:
                    raise RuntimeError("the browser went away")
                self.buffer += more
            line, self.buffer = self.buffer.split(b"\0", 1)
            message = json.loads(line)
            if "id" in message:
                self.answers[message["id"]] = message
            else:
                self.note(message)
        answer = self.answers.pop(self.count)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def note(self, message):
        method, parameters = message["method"], message.get("params", {})
        if method == "Runtime.exceptionThrown":
            self.log.append(("error", json.dumps(parameters["exceptionDetails"])[:500]))
        elif method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
            self.log.append((parameters["type"], str([each.get("value") for each in parameters["args"]])))
        elif method == "Log.entryAdded" and parameters["entry"]["level"] == "error":
            self.log.append(("error", parameters["entry"]["text"]))
        elif method == "Network.requestWillBeSent":
            self.log.append(("asked", parameters["request"]["url"].split(",")[0][:200]))

    def open(self, url):
        self.call("Page.navigate", url=url)

    def run(self, script):
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(json.dumps(answer["exceptionDetails"])[:500])
        return answer["result"].get("value")

    def wait(self, script, seconds=60.0):
        end = time.monotonic() + seconds
        while not self.run(script):
            if time.monotonic() > end:
                raise RuntimeError(f"'{script}' did not come true in {seconds} s; log: {self.log}")
            time.sleep(0.05)

    def drag(self, start, end, button="left"):
        mask = {"left": 1, "right": 2}[button]
        mouse = lambda kind, at, held: self.call(
            "Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], button=button, buttons=held, clickCount=1)
        mouse("mousePressed", start, mask)
        for i in range(1, 11):
            mouse("mouseMoved", [a + (b - a) * i / 10 for a, b in zip(start, end)], mask)
        mouse("mouseReleased", end, 0)

    def click(self, at):
        self.drag(at, at)

    def wheel(self, at, delta):
        self.call("Input.dispatchMouseEvent", type="mouseWheel", x=at[0], y=at[1], deltaX=0, deltaY=delta)

    def picture(self, path):
        data = self.call("Page.captureScreenshot", format="png")["data"]
        with open(path, "wb") as file:
            file.write(base64.b64decode(data))

    def close(self):
        try:
            self.session = None
            self.call("Browser.close")
        except (RuntimeError, OSError):
            self.process.terminate()
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.to)
        os.close(self.back)
        shutil.rmtree(self.folder, ignore_errors=True)
