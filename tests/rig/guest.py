"""A machine that runs a real kernel in emulation. The host types commands on a console, as somebody would,
moves its button lines and looks at its screen."""
import queue
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

    def __init__(self, machine, folder, devices=(), board=None, memory="256M", boot="", limit=480):
        """`board`: a function that edits the DeviceTree. `boot`: more words for the kernel. `limit`: seconds, of the
        whole guest's life."""
        self.folder = Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        images = prepare(machine)
        self._give_up = time.monotonic() + limit
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
        if board:
            tree = DeviceTree(start, self.folder)
            board(tree)
            command += ["-dtb", str(tree.write())]
        self._errors = open(self.folder / "qemu.log", "w", encoding="utf-8")
        self._qemu = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self._errors, stderr=self._errors)
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
        self.lines = GpioLines(self.qmp, Qtest(self.folder / "qtest"))
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
        status = int(self._marker(said, seconds))
        text = "\n".join(said).rstrip("\n")
        if check and status:
            raise GuestError(f"`{command}` ended with {status}: {text}")
        return text

    def await_true(self, command, seconds=30, what=None):
        """Waits until a shell command succeeds."""
        until = time.monotonic() + seconds
        while True:
            text = self.run(f"{command} && echo '# yes'", check=False)
            if text.endswith("# yes"):
                return text.removesuffix("# yes").rstrip("\n")
            if time.monotonic() > until:
                raise GuestError(f"{what or command}: not within {seconds} s {text}")
            time.sleep(0.2)

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

    def _marker(self, said=None, seconds=None):
        """What comes behind the next "@@"; the lines before it are added to `said`."""
        until = self._give_up if seconds is None else min(self._give_up, time.monotonic() + seconds)
        lately = []
        while True:
            try:
                line = self._lines.get(timeout=max(0.01, until - time.monotonic()))
            except queue.Empty:
                raise GuestError(f"no answer in time; the last lines: {lately[-5:]}") from None
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
