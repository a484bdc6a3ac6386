"""How quick and how whole: press to picture, and pictures that are never torn."""
import time

from box import WIRING, Session
from guest import Guest


def press_time(folder, say):
    """Live at 320x240: from the kernel's time stamp of the edge to the end of the flip that shows the answer."""
    screen = ["-device", "virtio-gpu-pci,xres=320,yres=240"]
    with Guest("arm64", folder, devices=screen, board=lambda tree: tree.name_lines()) as guest:
        guest.run("modprobe virtio_gpu")
        session = Session(guest, "--display drm --buttons gpio", config=WIRING)
        time.sleep(10)
        for _ in range(6):
            guest.lines.press(0)
            time.sleep(0.5)
        report = session.stop()
        say(f"320x240, {report['presses']} presses while it traces: the slowest was answered on the screen after"
            f" {report['slowest_press_ms']:.0f} ms of guest time; {report['frames']} frames in {report['seconds']:.0f} s")
        if report["presses"] != 6:
            raise AssertionError(f"6 presses became {report['presses']}")


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
