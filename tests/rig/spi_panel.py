"""A MIPI DBI panel, seen from its wires: follows QEMU's trace of the GPIO outputs that bit-bang its SPI bus and keeps the
picture memory that a real panel would. Data is taken at each rising edge of the clock, most significant bit first; the
line "data/command" tells a command byte from its arguments. Commands: 2A and 2B set a window of columns and rows, 2C
fills it, row by row, with 16-bit pixels, most significant byte first."""
from screen_memory import FrameBuffer

_SET_COLUMNS, _SET_ROWS, _FILL = 0x2A, 0x2B, 0x2C
_WAKE, _SET_FORMAT, _TURN_ON = 0x11, 0x3A, 0x29
_DELAY = 0  # in the firmware: no command, but a pause of so many ms


class SpiPanel:
    CLOCK, DATA, SELECT, IS_ARGUMENT, RESET = range(5)  # lines of the GPIO chip
    FIRMWARE = "rig,panel"  # its name; the kernel asks for this file with ".bin"

    def __init__(self, width, height, trace):
        """`trace`: the file that QEMU writes, with the options `devices`."""
        self.width, self.height = width, height
        self.shown = []  # pictures, one for each window that was filled
        self._trace, self._read, self._pending = trace, 0, b""
        self._screen = FrameBuffer(width, height, 2 * width, "r5g6b5", 0)
        self._memory = bytearray(self._screen.bytes)
        self._window = {_SET_COLUMNS: (0, width - 1), _SET_ROWS: (0, height - 1)}
        self._levels = [0] * 8
        self._byte = self._bits = 0
        self._command, self._arguments = None, bytearray()

    @property
    def devices(self):
        """For Guest's `devices`."""
        return ["-trace", "pl061_set_output", "-D", str(self._trace)]

    @property
    def firmware(self):
        """The file that tells the kernel's driver how to wake the panel: commands, each with its arguments."""
        commands = ((_WAKE, b""), (_DELAY, b"\x0a"), (_SET_FORMAT, b"\x55"), (_TURN_ON, b""))
        return b"MIPI DBI".ljust(15, b"\0") + b"\1" + b"".join(
            bytes((command, len(arguments))) + arguments for command, arguments in commands)

    def wanted(self, picture):
        """The picture as one of `shown`."""
        return _swapped(self._screen.memory(picture))

    def follow(self):
        """Reads what was traced since the last time."""
        with open(self._trace, "rb") as trace:
            trace.seek(self._read)
            *lines, self._pending = (self._pending + trace.read()).split(b"\n")
            self._read = trace.tell()
        for line in lines:
            at = line.rfind(b" output ")
            if at >= 0:
                words = line[at + 8:].split()
                self._change(int(words[0]), int(words[-1]))
        return self.shown

    def _change(self, line, level):
        rising = level and not self._levels[line]
        self._levels[line] = level
        if line == self.SELECT:
            self._byte = self._bits = 0
        elif line == self.CLOCK and rising:
            self._byte = self._byte << 1 | self._levels[self.DATA]
            self._bits += 1
            if self._bits == 8:
                self._take(self._byte)
                self._byte = self._bits = 0

    def _take(self, byte):
        if not self._levels[self.IS_ARGUMENT]:
            self._command, self._arguments = byte, bytearray()
            return
        self._arguments.append(byte)
        if self._command in self._window and len(self._arguments) == 4:
            self._window[self._command] = (int.from_bytes(self._arguments[:2], "big"),
                                           int.from_bytes(self._arguments[2:], "big"))
        elif self._command == _FILL:
            self._store(len(self._arguments) - 1, byte)

    def _store(self, index, byte):
        (left, right), (top, bottom) = self._window[_SET_COLUMNS], self._window[_SET_ROWS]
        width = 2 * (right - left + 1)
        row, column = divmod(index, width)
        self._memory[((top + row) * self.width + left) * 2 + column] = byte
        if index + 1 == width * (bottom - top + 1):
            self.shown.append(bytes(self._memory))


def _swapped(words):
    swapped = bytearray(words)
    swapped[::2], swapped[1::2] = words[1::2], words[::2]
    return bytes(swapped)
