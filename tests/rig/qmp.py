"""QEMU's two control sockets: QMP, a JSON line for each command (screenshots, memory, devices that come and go), and
qtest, which sets the level of an interrupt or GPIO input while the guest runs."""
import json
import socket
import time


class QemuError(Exception):
    """QEMU refused a command, or its socket is gone."""


def connect(path, seconds=20):
    """A connected UNIX socket; QEMU may take a moment to make it."""
    give_up = time.monotonic() + seconds
    while True:
        try:
            connection = socket.socket(socket.AF_UNIX)
            connection.connect(str(path))
            return connection
        except OSError as error:
            connection.close()
            if time.monotonic() > give_up:
                raise QemuError(f"no socket {path}: {error}") from error
            time.sleep(0.05)


class Qmp:
    """Commands of the machine: `qmp("screendump", filename=..., format="png")` returns what QEMU returns."""

    def __init__(self, path):
        self._lines = connect(path).makefile("rw")
        self._lines.readline()  # the greeting
        self("qmp_capabilities")

    def __call__(self, command, **arguments):
        self._lines.write(json.dumps({"execute": command, "arguments": arguments}) + "\n")
        self._lines.flush()
        while True:
            line = self._lines.readline()
            if not line:
                raise QemuError(f"QEMU ended during {command}")
            answer = json.loads(line)
            if "error" in answer:
                raise QemuError(f"{command}: {answer['error']['desc']}")
            if "return" in answer:  # all else are events
                return answer["return"]

    def find_object(self, kind, path="/machine", depth=3):
        """The path of the first device of a kind, such as "pl061", or None."""
        children = self("qom-list", path=path)
        for child in children:
            if child["type"] == f"child<{kind}>":
                return f"{path}/{child['name']}"
        for child in children:
            skip = "memory-region" in child["type"] or "irq" in child["type"]
            if depth > 0 and child["type"].startswith("child<") and not skip:
                found = self.find_object(kind, f"{path}/{child['name']}", depth - 1)
                if found:
                    return found
        return None


class Qtest:
    """The test socket: one line there, one line back."""

    def __init__(self, path):
        self._lines = connect(path).makefile("rw")

    def __call__(self, command):
        self._lines.write(command + "\n")
        self._lines.flush()
        answer = self._lines.readline().strip()
        if not answer.startswith("OK"):
            raise QemuError(f"qtest: {command}: {answer or 'QEMU ended'}")
        return answer
