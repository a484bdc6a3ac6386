"""A machine that runs a real kernel in emulation. The host types commands on a console, as somebody would,
moves its button lines and looks at its screen."""
import os
import queue
import re
import subprocess
import threading
import time
from pathlib import Path

import pictures
from device_tree import DeviceTree
from gpio_lines import GpioLines
from machines import MACHINES, prepare
from qmp import Qmp, Qtest, connect


class GuestError(Exception):
    """The guest did not do what was asked in time, or a command failed in it."""


class Guest:
    """`with Guest("arm64", folder, devices=[...]) as guest:` boots; `folder` on the host is /host in the guest."""

    def __init__(self, machine, folder, devices=(), board=None, memory="256M", boot="", counted=False, limit=240):
        """`board`: a function that edits the DeviceTree. `boot`: more words for the kernel. `counted`: the guest's clock
        is not the host's, but counts instructions, a nanosecond each, as long as there is something to do. `limit`:
        seconds, of the whole guest's life, as deadline() counts them."""
        self.folder = Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        images = prepare(machine)
        start = [*MACHINES[machine].qemu, "-m", memory]
        command = [*start, "-nodefaults", "-no-reboot", "-display", "none",
                   "-kernel", str(images["kernel"]), "-initrd", str(images["initrd"]),
                   "-append", f"console=ttyAMA0 quiet loglevel=3 panic=-1 rdinit=/init vt.global_cursor_default=0 {boot}",
                   "-fsdev", f"local,id=host,path={self.folder},security_model=none",
                   "-device", "virtio-9p-pci,fsdev=host,mount_tag=host"]
        command += ["-chardev", f"socket,id=shell,path={self.folder / 'shell'},server=on,wait=off",
                    "-device", "virtio-serial-pci", "-device", "virtconsole,chardev=shell",
                    "-serial", f"file:{self.folder / 'kernel.log'}"]
        for name, option in (("qmp", "-qmp"), ("qtest", "-qtest")):
            (self.folder / name).unlink(missing_ok=True)
            command += [option, f"unix:{self.folder / name},server=on,wait=off"]
        command += ["-qtest-log", "none", *devices]
        self._counted = counted
        if counted:
            command += ["-icount", "shift=0"]
        if board:
            tree = DeviceTree(start, self.folder)
            board(tree)
            command += ["-dtb", str(tree.write())]
        self._errors = open(self.folder / "qemu.log", "w", encoding="utf-8")
        self._qemu = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self._errors, stderr=self._errors)
        self._give_up = self.deadline(limit)
        try:
            self._meet()
        except BaseException:
            self.close()
            raise

    def _meet(self):
        self._lines = queue.Queue()
        self._serial = connect(self.folder / "shell")
        threading.Thread(target=self._listen, daemon=True).start()
        self.qmp = Qmp(self.folder / "qmp")
        self.lines = GpioLines(self.qmp, Qtest(self.folder / "qtest"), self.sleep)
        _, self.kernel, uptime = self._marker().split()
        self.boot_seconds = float(uptime)
        self.run("mkdir -p /host && modprobe -a virtio_pci 9pnet_virtio 9p; mount -t 9p -o trans=virtio,version=9p2000.L host /host")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        self._qemu.kill()
        self._qemu.wait()
        self._errors.close()

    def run(self, command, check=True, seconds=None):
        """What a shell command prints. One that fails is an error, unless `check` is off."""
        self._serial.sendall(f"{{ {command}\n}} </dev/null 2>&1; printf '\\n@@ %d\\n' $?\n".encode())
        said = []
        status = int(self._marker(said, self.deadline(seconds) if seconds else None))
        text = "\n".join(said).rstrip("\n")
        if check and status:
            raise GuestError(f"`{command}` ended with {status}: {text}")
        return text

    def await_true(self, command, seconds=30, what=None):
        """Waits until a shell command succeeds."""
        passed = self.deadline(seconds)
        while True:
            text = self.run(f"{command} && echo '# yes'", check=False)
            if text.endswith("# yes"):
                return text.removesuffix("# yes").rstrip("\n")
            if passed():
                raise GuestError(f"{what or command}: not within {seconds} s {text}")
            time.sleep(0.2)

    def deadline(self, seconds):
        """A function that says whether `seconds` have passed. They are those of an emulator that has a core of the host
        for itself: where it must share, they last longer, up to eight times."""
        began, spent = time.monotonic(), self._processor_time()

        def passed():
            waited = time.monotonic() - began
            return waited > 8 * seconds or (waited > seconds and 2 * (self._processor_time() - spent) > seconds)
        return passed

    def sleep(self, seconds):
        """Waits, by the guest's clock."""
        if not self._counted:
            return time.sleep(seconds)
        until = self._clock() + seconds
        while self._clock() < until:
            time.sleep(0.001)
        return None

    def _clock(self):
        """The guest's, when it is not the host's, in seconds since some moment."""
        said = self.qmp("human-monitor-command", **{"command-line": "info jit"})
        behind = re.search(r"Host - Guest clock +(-?\d+) ms", said)
        return time.monotonic() - int(behind[1]) / 1000

    def _processor_time(self):
        try:
            words = Path(f"/proc/{self._qemu.pid}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
            return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")
        except (OSError, IndexError):
            return float("inf")  # it has ended

    def screen(self, name="screen", device=None):
        """What a person sees on the screen now; kept as a PNG in the folder."""
        file = self.folder / f"{name}.png"
        more = {"device": device} if device else {}
        self.qmp("screendump", filename=str(file), format="png", **more)
        return pictures.load(file)

    def memory(self, address, size, name="memory"):
        """The bytes of the guest's memory at a physical address, now; kept in the folder."""
        file = self.folder / f"{name}.raw"
        self.qmp("pmemsave", val=address, size=size, filename=str(file))
        return file.read_bytes()

    def _marker(self, said=None, passed=None):
        """What comes behind the next "@@"; the lines before it are added to `said`."""
        lately = []
        while True:
            try:
                line = self._lines.get(timeout=1)
            except queue.Empty:
                if self._give_up() or (passed and passed()):
                    raise GuestError(f"no answer in time; the last lines: {lately[-5:]}") from None
                continue
            if line is None:
                raise GuestError(f"the guest ended; the last lines: {lately[-5:]}")
            if line.startswith("@@ "):
                return line[3:]
            lately.append(line)
            if said is not None:
                said.append(line)

    def _listen(self):
        with open(self.folder / "console.log", "w", encoding="utf-8") as log:
            pending = b""
            while data := self._serial.recv(65536):
                pending += data
                *lines, pending = pending.split(b"\n")
                for line in lines:
                    text = line.decode(errors="replace").rstrip("\r")
                    log.write(text + "\n")
                    log.flush()
                    self._lines.put(text)
        self._lines.put(None)
