"""From a button's contacts to the screen. The picture is held still, so that a press that acts twice, or not at all, is
another picture: brighter and darker are counted in pixels."""
from box import DOUBLED, STILL, WIRING, Expected, Session, doubled
from gpio_lines import BOUNCES
from guest import Guest

_SIZE = "160x120"


def press_to_picture(machine):
    def scenario(folder, say):
        screen = ["-device", "virtio-gpu-pci,xres=320,yres=240"]
        with Guest(machine, folder, devices=screen, board=lambda tree: tree.name_lines()) as guest:
            guest.run("modprobe virtio_gpu")
            say(f"Linux {guest.kernel} booted in {guest.boot_seconds} s")
            expected = Expected(guest)
            still, brighter = doubled(expected(_SIZE)), doubled(expected(_SIZE, ["exposure-up"]))
            darker = doubled(expected(_SIZE, ["exposure-up", "exposure-down"]))

            session = Session(guest, f"--display drm --buttons gpio --size {_SIZE}", script=STILL, config=DOUBLED + WIRING)
            session.await_picture(guest.screen, still)
            say(f"the screen shows the headless display's picture, all {_SIZE} pixels of it, twice as large")

            guest.lines.press(0)
            session.await_picture(guest.screen, brighter)
            say(f"a press with {BOUNCES} bounces acts once")
            guest.lines.press(1)
            session.await_picture(guest.screen, darker)
            guest.lines.press(1, seconds=1.5)
            session.await_picture(guest.screen, brighter)
            say("a short press and a long one of the same button are told apart")
            guest.lines.press(2, 3)
            session.await_picture(guest.screen, darker)
            guest.lines.press(2)
            session.await_picture(guest.screen, brighter)
            say("a chord is not its buttons, and these still act alone")

            report = session.stop()
            scripted = STILL.count("tap")
            presses = report["presses"] - scripted
            if presses != 5:
                raise AssertionError(f"5 gestures became {presses} actions: {report}")
            say(f"5 gestures, {presses} actions; {report['frames']} frames; it ended by SIGTERM")
    return scenario
