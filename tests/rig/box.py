"""The program in a guest: a session that runs beside the shell, and the pictures that the headless display gives for
the same script, which is what a screen must show."""
import json
import time

import pictures
from guest import GuestError

SCENE = "/usr/share/vitrine/scenes/cornell.gltf"
# A few frames, without labels, then a still picture: the same on every display.
STILL = "0.02 tap hud\n0.08 tap pause\n"
LABEL_FRAMES = 150  # of 1/60 s: after a press the labels stay for two seconds

# Buttons on the lines 0 to 3, with everything that can be done with them. A is short only and so acts at once.
WIRING = """
[[gpio]]
button = "a"
line = "BTN_A"
[[gpio]]
button = "b"
line = "BTN_B"
[[gpio]]
button = "c"
line = "BTN_C"
[[gpio]]
button = "d"
line = "BTN_D"
[[gesture]]
button = "a"
action = "exposure-up"
[[gesture]]
button = "b"
action = "exposure-down"
[[gesture]]
button = "b"
on = "long"
action = "exposure-up"
after_ms = 800
[[gesture]]
button = "c"
action = "exposure-up"
[[gesture]]
button = "d"
action = "exposure-up"
[[gesture]]
buttons = ["c", "d"]
on = "chord"
action = "exposure-down"
"""

# A screen of twice the size shows each pixel as 2 x 2 of its own.
DOUBLED = '[display]\nscaling = "integer"\n'


def doubled(picture):
    return picture.resize((2 * picture.width, 2 * picture.height), 0)


def script_of(presses):
    """STILL, then presses of actions, in synthetic time."""
    return STILL + "".join(f"{0.1 + 0.02 * index:.2f} tap {action}\n" for index, action in enumerate(presses))


class Expected:
    """Pictures of the headless display, made once for each script and size by the guest's own program."""

    def __init__(self, guest, scene=SCENE):
        self._guest, self._scene = guest, scene
        self._known = {}

    def __call__(self, size, presses=(), frames=LABEL_FRAMES):
        key = (size, tuple(presses), frames)
        if key not in self._known:
            name = f"expected-{size}-{len(self._known)}"
            (self._guest.folder / f"{name}.script").write_text(script_of(presses), encoding="utf-8")
            self._guest.run(f"vitrine run {self._scene} --display headless --size {size} --threads 1"
                            f" --script /host/{name}.script --frames {frames} --out /host/{name}.png")
            self._known[key] = pictures.load(self._guest.folder / f"{name}.png")
        return self._known[key]


class Session:
    """`vitrine run OPTIONS`, started in the background. It ends with the scenario's guest, or by stop()."""

    def __init__(self, guest, options, script=None, config=None, environment="", name="session", scene=SCENE,
                 threads=1):
        self.guest, self._name = guest, name
        words = ["run", scene, "--threads", str(threads), "--json", options]
        if script is not None:
            (guest.folder / f"{name}.script").write_text(script, encoding="utf-8")
            words += ["--script", f"/host/{name}.script"]
        if config is not None:
            (guest.folder / f"{name}.toml").write_text(config, encoding="utf-8")
            words += ["--config", f"/host/{name}.toml"]
        guest.run(f"rm -f /run/{name}.*; {environment} vitrine {' '.join(words)}"
                  f" >/run/{name}.json 2>/run/{name}.log & echo $! >/run/{name}.pid")
        self.pid = int(guest.run(f"cat /run/{name}.pid"))

    def alive(self):
        return self.guest.run(f"test -d /proc/{self.pid} && echo yes", check=False) == "yes"

    def said(self):
        return self.guest.run(f"cat /run/{self._name}.log", check=False)

    def kill(self, signal):
        self.guest.run(f"kill -{signal} {self.pid}")

    def stop(self, signal="TERM", seconds=30):
        """Ends it and returns its JSON report."""
        self.kill(signal)
        return self.report(seconds)

    def report(self, seconds):
        """The JSON report of a session that ends by itself."""
        self.guest.await_true(f"test ! -d /proc/{self.pid} || grep -q '^State:.Z' /proc/{self.pid}/status", seconds,
                              "the program does not end")
        text = self.guest.run(f"cat /run/{self._name}.json")
        if not text:
            raise GuestError(f"no report; it said: {self.said()}")
        return json.loads(text)

    def await_picture(self, look, wanted, seconds=60, but=0):
        """Waits until `look()`, a picture, has at most `but` pixels unlike `wanted`."""
        passed = self.guest.deadline(seconds)
        while True:
            shown = look()
            wrong = pictures.differing(shown, wanted)
            if wrong <= but:
                return shown
            if passed():
                wanted.save(self.guest.folder / "wanted.png")
                alive = "" if self.alive() else "; the program has ended"
                raise GuestError(f"{wrong} of {wanted.width * wanted.height} pixels of the screen {shown.size} are"
                                 f" unlike the picture {wanted.size}{alive}; it said: {self.said()}")
            time.sleep(0.3)
