"""What a box survives: a screen that comes late, another console, a program that is killed, frames that stop."""
import time

from box import DOUBLED, STILL, Expected, Session, doubled
from guest import Guest

_SIZE = "160x120"
_SCREEN = ["-device", "virtio-gpu-pci,xres=320,yres=240"]


def late_screen(folder, say):
    """The kernel has no display at all until its driver is loaded: QEMU's cards cannot be plugged in."""
    with Guest("arm64", folder, devices=_SCREEN) as guest:
        still = doubled(Expected(guest)(_SIZE))
        session = Session(guest, f"--display drm --buttons script --size {_SIZE}", script=STILL, config=DOUBLED)
        time.sleep(5)
        if not session.alive():
            raise AssertionError(f"it does not wait for a screen: {session.said()}")
        guest.run("modprobe virtio_gpu")
        session.await_picture(guest.screen, still)
        say(f"started without a display, process {session.pid} shows the picture once there is one")
        session.stop()


def switched(folder, say):
    """Somebody asks for another console: it is shown, and the picture again after it."""
    with Guest("arm64", folder, devices=_SCREEN) as guest:
        guest.run("modprobe virtio_gpu; printf '\\033[2J\\033[Hanother console' >/dev/tty2")
        still = doubled(Expected(guest)(_SIZE))
        session = Session(guest, f"--display drm --buttons script --size {_SIZE}", script=STILL, config=DOUBLED)
        session.await_picture(guest.screen, still)
        guest.run("chvt 2", seconds=60)  # which waits until the program has given the screen away
        for _ in range(20):
            colours = len(guest.screen("console").getcolors(1 << 20))
            if colours < 20:
                break
            time.sleep(0.3)
        else:
            raise AssertionError(f"console 2 has {colours} colours: it is still the picture")
        guest.run("chvt 1", seconds=60)
        session.await_picture(guest.screen, still)
        say(f"console 2 is asked for and shows its text ({colours} colours); console 1 shows the picture again")
        session.stop()


def killed(folder, say):
    """After kill -9 the console is what it was."""
    with Guest("arm64", folder, devices=_SCREEN) as guest:
        guest.run("modprobe virtio_gpu")
        still = doubled(Expected(guest)(_SIZE))
        before = guest.run("console_mode")
        for signal in ("TERM", "KILL"):
            guest.run("printf '\\033[2J\\033[Hthe console' >/dev/tty1; sleep 0.5")
            console = guest.screen("console")
            session = Session(guest, f"--display drm --buttons script --size {_SIZE}", script=STILL, config=DOUBLED)
            session.await_picture(guest.screen, still)
            during = guest.run("console_mode")
            if during == before:
                raise AssertionError(f"the console is not held while the box draws: {during}")
            session.kill(signal)
            guest.await_true(f"test \"$(console_mode)\" = '{before}'", 30,
                             f"the console is not given back after SIG{signal}")
            session.await_picture(guest.screen, console)
            guest.run("printf ' answers' >/dev/tty1")
            for _ in range(20):
                if guest.screen("answer").tobytes() != console.tobytes():
                    break
                time.sleep(0.3)
            else:
                raise AssertionError("the console shows nothing new")
            say(f"SIG{signal}: console '{during}' becomes '{before}' again, shows its text and what is written to it")


def watchdog(folder, say):
    """Messages to the service manager follow frames: they stop when frames stop."""
    with Guest("arm64", folder, devices=_SCREEN) as guest:
        guest.run("modprobe virtio_gpu; notify_listener /run/notify >/run/notified & sleep 1")
        session = Session(guest, f"--display drm --buttons script --size {_SIZE}", script=STILL, config=DOUBLED,
                          environment="NOTIFY_SOCKET=/run/notify WATCHDOG_USEC=4000000")
        guest.await_true("grep -q READY=1 /run/notified", 60, "no READY")

        def beats():
            return int(guest.run("grep -c WATCHDOG=1 /run/notified", check=False))

        at = beats()
        time.sleep(8)
        going = beats() - at
        session.kill("STOP")
        time.sleep(1)
        at = beats()
        time.sleep(8)
        stopped = beats() - at
        session.kill("CONT")
        at = beats()
        guest.await_true(f"test $(grep -c WATCHDOG=1 /run/notified) -gt {at}", 30, "no beat after SIGCONT")
        say(f"WATCHDOG_USEC 4 s: {going} beats in 8 s with frames, {stopped} in 8 s without, beats again after them")
        if going < 2 or stopped:
            raise AssertionError(guest.run("tail -n 20 /run/notified"))
        ready = float(guest.run("grep READY=1 /run/notified | head -n 1").split()[0])
        session.stop()
        said = guest.run("cut -d ' ' -f 2- /run/notified | sort | uniq -c | sort -n | tail -n 5")
        say(f"READY {ready:.1f} s after boot; STOPPING: {'STOPPING=1' in said or guest.run('grep -c STOPPING=1 /run/notified', check=False)}")
