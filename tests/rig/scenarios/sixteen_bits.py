"""KMS cards whose pixels have 16 bits: what they show is the headless display's picture, dithered as it must be for each
place of the screen."""
import time

from box import STILL, Expected, Session
from guest import Guest
from pictures import turned
from screen_memory import seen_in, shown_in
from spi_panel import SpiPanel

_LAYOUT = "r5g6b5"
_FRAMES = 9


def cirrus(folder, say):
    """An old PC's card, told to use RGB565. There is no VGA BIOS here to say that its registers are a colour screen's."""
    width, height = 640, 480
    with Guest("arm64", folder, devices=["-device", "cirrus-vga"]) as guest:
        guest.run("for d in /sys/bus/pci/devices/*; do grep -q 0x1013 $d/vendor || continue; echo 1 >$d/enable;"
                  " devmem $(($(sed -n '2s/ .*//p' $d/resource) + 2)) 8 1; done; modprobe cirrus")
        expected = Expected(guest)
        for rotation, size in ((0, (160, 120)), (90, (120, 160))):
            size = f"{size[0]}x{size[1]}"
            picture = turned(expected(size), rotation).resize((width, height), 0)
            session = Session(guest, f"--display drm --buttons script --size {size}", script=STILL,
                              config=f'[display]\nformat = "rgb565"\nmode = "{width}x{height}"\nscaling = "integer"\n'
                                     f"rotation = {rotation}\n")
            session.await_picture(lambda: seen_in(_LAYOUT, guest.screen()), shown_in(_LAYOUT, picture), 150)
            say(f"RGB565 at {width}x{height}, turned by {rotation}, every pixel right")
            session.stop()


def spi_panel(folder, say):
    """The kernel's panel-mipi-dbi on a bit-banged bus: the picture is read off the wires. A picture takes so long that
    only a few are shown, with their labels."""
    panel = SpiPanel(64, 48, folder / "wires.log")
    with Guest("armhf-spi", folder, boot="fbcon=map:9", board=lambda tree: tree.add_spi_panel(panel),
               devices=panel.devices) as guest:
        say(f"Linux {guest.kernel}")
        (folder / "panel.bin").write_bytes(panel.firmware)
        guest.run(f"cp /host/panel.bin /lib/firmware/{panel.FIRMWARE}.bin; modprobe -a spi_gpio panel_mipi_dbi")
        guest.await_true("test -e /dev/dri/card0 -a -e /dev/fb0")
        picture = Expected(guest)(f"{panel.width}x{panel.height}", frames=_FRAMES)
        # This driver offers XRGB8888 too, which it cuts to 16 bits without a dither, and does not say what it prefers.
        # The other display's picture is turned: what is left of the first does not pass for it.
        for display, rotation in (("drm", 0), ("fbdev", 180)):
            session = Session(guest, f"--display {display} --buttons script --frames {_FRAMES}", script=STILL,
                              config=f'[display]\nformat = "rgb565"\nrotation = {rotation}\n')
            session.report(200)
            before, wanted = len(panel.shown), panel.wanted(turned(picture, rotation))
            until = time.monotonic() + 30
            while wanted not in panel.follow():
                if time.monotonic() > until:
                    raise AssertionError(f"none of {len(panel.shown) - before} pictures on the wire is frame {_FRAMES}:"
                                         f" {session.said()}")
                time.sleep(0.5)
            say(f"{display}: {len(panel.shown) - before} pictures of {panel.width}x{panel.height} on the wire, and frame"
                f" {_FRAMES} is right in every bit")
