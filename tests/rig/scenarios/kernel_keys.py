"""Buttons that the kernel makes keys of."""
from box import DOUBLED, STILL, Expected, Session, doubled
from guest import Guest

_SIZE = "160x120"
_KEYS = """
[[evdev]]
name = "rig-keys"
keys = {KEY_RIGHT = "exposure-up", KEY_LEFT = "exposure-down"}
"""


def keys(folder, say):
    """Two lines are keys of the kernel's, which it debounces itself."""
    def board(tree):
        tree.name_lines().add_keys()

    screen = ["-device", "virtio-gpu-pci,xres=320,yres=240"]
    with Guest("arm64", folder, devices=screen, board=board) as guest:
        guest.run("modprobe -a virtio_gpu gpio_keys evdev")
        expected = Expected(guest)
        still, brighter = doubled(expected(_SIZE)), doubled(expected(_SIZE, ["exposure-up"]))
        darker = doubled(expected(_SIZE, ["exposure-up", "exposure-down"]))
        session = Session(guest, f"--display drm --buttons evdev --size {_SIZE}", script=STILL, config=DOUBLED + _KEYS)
        session.await_picture(guest.screen, still)
        for line, wanted in ((6, brighter), (7, darker), (6, brighter)):
            guest.lines.press(line)
            session.await_picture(guest.screen, wanted)
        presses = session.stop()["presses"] - STILL.count("tap")
        if presses != 3:
            raise AssertionError(f"3 keys became {presses} actions")
        say("3 keys of a gpio-keys device, each with bounces: 3 actions")
