"""The cable between a virtio-gpu card and its monitor. QEMU tells the card of a monitor's size, or that there is none,
when a VNC viewer resizes its window: a viewer whose messages are these few bytes plugs and unplugs (RFB 3.8, the
messages SetEncodings and SetDesktopSize). The guest's kernel sees a true hotplug, with the new monitor's EDID."""
import struct
import threading

from qmp import QemuError, connect

_EXTENDED_DESKTOP_SIZE = -308  # the encoding that says: this viewer resizes


class DisplayCable:
    def __init__(self, folder, width, height):
        """At first there is a monitor that prefers this size."""
        self._socket = folder / "vnc"
        self._first = width, height
        self._viewer = None

    @property
    def devices(self):
        """The card and QEMU's end of the cable, for Guest's `devices`."""
        width, height = self._first
        return ["-device", f"virtio-gpu-pci,xres={width},yres={height}", "-vnc", f"unix:{self._socket}"]

    def plug(self, width, height):
        """A monitor that prefers this size."""
        self._resize(width, height)

    def unplug(self):
        self._resize(0, 0)

    def _resize(self, width, height):
        if self._viewer is None:
            self._viewer = self._connect()
            self._resize(*self._first)  # QEMU drops a size equal to the last, which to it was 0x0
        screen = struct.pack(">IHHHHI", 0, 0, 0, width, height, 0)
        self._viewer.sendall(struct.pack(">BxHHBx", 251, width, height, 1) + screen)

    def _connect(self):
        viewer = connect(self._socket)
        answers = viewer.makefile("rb")
        version = answers.read(12)
        viewer.sendall(b"RFB 003.008\n")
        ways = answers.read(answers.read(1)[0])
        if 1 not in ways:  # 1: nobody is asked who he is
            raise QemuError(f"no VNC: {version} {ways}")
        viewer.sendall(b"\1")
        answers.read(4)
        viewer.sendall(b"\1")  # others may look too
        _, _, name = struct.unpack(">HH16xI", answers.read(24))
        answers.read(name)
        viewer.sendall(struct.pack(">BxHi", 2, 1, _EXTENDED_DESKTOP_SIZE))
        # Nobody asked for pictures, but QEMU confirms each size.
        threading.Thread(target=lambda: _drain(viewer), daemon=True).start()
        return viewer


def _drain(viewer):
    try:
        while viewer.recv(65536):
            pass
    except OSError:
        pass
