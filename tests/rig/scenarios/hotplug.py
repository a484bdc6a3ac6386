"""A monitor that is unplugged and comes back as another. The card is a real KMS driver's, and so is the hotplug."""
import time

from box import DOUBLED, STILL, Expected, Session, doubled
from display_cable import DisplayCable
from guest import Guest
from pictures import within

_SIZE = "160x120"


def hotplug(folder, say):
    cable = DisplayCable(folder, 320, 240)
    with Guest("arm64", folder, devices=cable.devices) as guest:
        guest.run("modprobe virtio_gpu")
        still = Expected(guest)(_SIZE)
        picture = doubled(still)
        session = Session(guest, f"--display drm --buttons script --size {_SIZE}", script=STILL, config=DOUBLED)
        session.await_picture(guest.screen, picture)

        cable.unplug()
        guest.await_true("grep -q disconnected /sys/class/drm/card0-Virtual-1/status")
        time.sleep(3)
        if not session.alive():
            raise AssertionError(f"it ends without a monitor: {session.said()}")
        say(f"the monitor is unplugged: process {session.pid} waits")

        cable.plug(480, 320)
        session.await_picture(guest.screen, within(picture, (480, 320)))
        say("another of 480x320 is plugged in: the picture is in its middle")
        cable.plug(400, 300)
        session.await_picture(guest.screen, within(picture, (400, 300)))
        say("its preferred mode changes to 400x300: the picture follows")

        # An EDID cannot say so small a size: this monitor prefers none of its modes, the largest of which is 5120x2160.
        cable.plug(160, 120)
        session.await_picture(guest.screen, within(still.resize((1440, 1080), 0), (1920, 1080)))
        say("one that prefers no mode: the picture is shown at 1920x1080")
        if not session.alive():
            raise AssertionError(f"it ended: {session.said()}")
        session.stop()
