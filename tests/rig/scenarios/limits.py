"""How quick, how large, how whole: press to picture, memory, and pictures that are never torn."""
import random
import time

from box import WIRING, Session
from guest import Guest

_FRAMES = "sed -n 's/^vitrine_frames_total //p' /run/health.prom"
_TRACED = "sed -n 's/^vitrine_frame_seconds_count //p' /run/health.prom"  # presented while a pass was under way
_HEALTH = '[health]\nfile = "/run/health.prom"\nevery_s = 0.5\n'


def press_time(folder, say):
    """Live at 320x240: from the kernel's time stamp of the contact's edge, the debouncing included, to the end of the flip
    that shows the answer, as the program reports it. Emulation is many times slower than a board, so the guest's
    clock is not the host's: it counts instructions, a nanosecond each (QEMU's -icount shift=0). The machine is thus a
    single core of 10^9 instructions a second, whatever else the host does: what a core at 1 GHz comes near. Boards have
    several; here the one that answers is the one that traces."""
    screen = ["-device", "virtio-gpu-pci,xres=320,yres=240"]
    with Guest("arm64", folder, devices=screen, board=lambda tree: tree.name_lines(), counted=True) as guest:
        guest.run("modprobe virtio_gpu")
        session = Session(guest, "--display drm --buttons gpio", config=WIRING + _HEALTH)
        guest.await_true(f"test 0$({_TRACED}) -gt 20", 120, "it does not trace")
        chance = random.Random(1)
        presses = 8
        for _ in range(presses):
            guest.lines.set(0, 1)
            guest.sleep(0.04)
            guest.lines.set(0, 0)
            guest.sleep(0.04 + chance.uniform(0.0, 0.05))  # they meet a pass at any moment
        report = session.stop(seconds=60)
        slowest = report["slowest_press_ms"]
        say(f"320x240, {report['presses']} presses while it traces: the slowest was answered on the screen after"
            f" {slowest:.1f} ms of guest time, one core, an instruction a nanosecond; {report['frames']} frames in"
            f" {report['seconds']:.1f} s. On the host: tests/press_to_label cornell")
        if report["presses"] != presses:
            raise AssertionError(f"{presses} presses became {report['presses']}")
        if slowest > 100.0:
            raise AssertionError(f"a press was answered after {slowest:.1f} ms")


def memory(folder, say):
    """The richest scene in a small machine, with as many threads as a board has cores."""
    screen = ["-device", "virtio-gpu-pci,xres=640,yres=480"]
    with Guest("arm64", folder, devices=screen, memory="128M", limit=300) as guest:
        guest.run("modprobe virtio_gpu")
        session = Session(guest, "--display drm --buttons script", script="", config=_HEALTH, threads=4,
                          scene="/usr/share/vitrine/scenes/gallery.gltf")
        guest.await_true(f"test 0$({_FRAMES}) -ge 3", 200, "it does not come to its third frame")
        peak = int(guest.run(f"sed -n 's/^VmHWM: *//p' /proc/{session.pid}/status").split()[0])
        total = int(guest.run("sed -n 's/^MemTotal: *//p' /proc/meminfo").split()[0])
        colours = guest.screen().getcolors(1 << 20)
        report = session.stop(seconds=60)
        say(f"gallery at 640x480, 4 threads, in a guest of 128 MiB ({total / 1024:.0f} MiB beside its kernel):"
            f" {report['frames']} frames, at most {peak / 1024:.1f} MiB resident")
        if len(colours) < 1000:
            raise AssertionError(f"the screen shows {len(colours)} colours")


def tearing(folder, say):
    """Each frame is one colour, which is its number: a screenshot with two colours would be torn. QEMU shows what the
    kernel last handed to the card, so this tells of unfinished pictures, not of a real screen's scan-out."""
    screen = ["-device", "virtio-gpu-pci,xres=320,yres=240"]
    with Guest("arm64", folder, devices=screen) as guest:
        guest.run("modprobe virtio_gpu; tearing_pattern >/run/pattern.log 2>&1 & sleep 2")
        numbers = []
        for _ in range(100):
            colours = guest.screen().getcolors(4)
            if colours is None or len(colours) > 1:
                raise AssertionError(f"a torn frame, {folder / 'screen.png'}: {colours}")
            numbers.append(colours[0][1])
            time.sleep(0.03)
        different = len(set(numbers))
        say(f"100 screenshots of 320x240 show {different} frames, each whole")
        if different < 30 or (0, 0, 0) in numbers[-50:]:
            raise AssertionError(f"it does not animate: {guest.run('cat /run/pattern.log')}")
