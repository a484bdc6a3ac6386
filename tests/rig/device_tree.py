"""What the guest's kernel is told about the board. QEMU writes the tree of its machine; an overlay adds what the box
has: names of the button lines, keys on lines, plain frame buffers, a panel on a wire."""
import re
import subprocess

from gpio_lines import LINE_NAMES

_PL061 = "/pl061@9030000"
KEY_LINES = {6: 106, 7: 105}  # KEY_RIGHT and KEY_LEFT of linux/input-event-codes.h


class DeviceTree:
    """The tree of `qemu` (the start of a command line, with machine and memory), to be edited and written."""

    def __init__(self, qemu, folder):
        self._file = folder / "board.dtb"
        at = qemu.index("-machine") + 1
        dumping = qemu[:at] + [f"{qemu[at]},dumpdtb={self._file}"] + qemu[at + 1:]
        _run(dumping + ["-display", "none"])
        # QEMU's own key, "poweroff", sits on a line that a button has here.
        _run(["fdtput", "-r", self._file, "/gpio-keys"])
        self.gpio = _run(["fdtget", "-t", "u", self._file, _PL061, "phandle"]).strip()

    def add(self, path, text):
        """Adds properties and nodes below the node at `path`."""
        source = f'/dts-v1/; /plugin/; / {{ fragment@0 {{ target-path = "{path}"; __overlay__ {{ {text} }}; }}; }};'
        overlay = self._file.with_suffix(".dtbo")
        _run(["dtc", "-q", "-I", "dts", "-O", "dtb", "-o", overlay, "-"], source)
        _run(["fdtoverlay", "-i", self._file, "-o", self._file, overlay])
        return self

    def name_lines(self):
        return self.add(_PL061, "gpio-line-names = " + ", ".join(f'"{name}"' for name in LINE_NAMES) + ";")

    def add_keys(self):
        """Lines 6 and 7 become keys, of an input device "rig-keys"."""
        keys = "".join(f'key{line} {{ label = "key{line}"; linux,code = <{code}>; debounce-interval = <10>;'
                       f' gpios = <{self.gpio} {line} 0>; }}; ' for line, code in KEY_LINES.items())
        return self.add("/", f'rig-keys {{ compatible = "gpio-keys"; label = "rig-keys"; {keys} }};')

    def add_frame_buffer(self, buffer):
        """A screen that firmware left on: memory at `buffer.address` that the kernel must leave alone."""
        size = -(-buffer.bytes // 65536) * 65536
        at, length = f"0x0 {buffer.address:#x}", f"0x0 {size:#x}"
        return self.add("/", f"""
            reserved-memory {{ #address-cells = <2>; #size-cells = <2>; ranges;
              screen@{buffer.address:x} {{ reg = <{at} {length}>; no-map; }}; }};
            framebuffer@{buffer.address:x} {{ compatible = "simple-framebuffer"; reg = <{at} {length}>;
              width = <{buffer.width}>; height = <{buffer.height}>; stride = <{buffer.stride}>;
              format = "{buffer.layout}"; }};""")

    def add_spi_panel(self, panel):
        """A MIPI DBI panel on a bit-banged SPI bus; spi_panel.py tells which line is which wire."""
        def wire(line, active_low=0):
            return f"<{self.gpio} {line} {active_low}>"
        timing = "".join(f"{name} = <0>; " for name in ("hback-porch", "hfront-porch", "hsync-len", "vback-porch",
                                                        "vfront-porch", "vsync-len", "clock-frequency"))
        return self.add("/", f"""
            spi-panel {{ compatible = "spi-gpio"; #address-cells = <1>; #size-cells = <0>; num-chipselects = <1>;
              sck-gpios = {wire(panel.CLOCK)}; mosi-gpios = {wire(panel.DATA)}; cs-gpios = {wire(panel.SELECT, 1)};
              display@0 {{ compatible = "{panel.FIRMWARE}", "panel-mipi-dbi-spi"; reg = <0>; write-only;
                spi-max-frequency = <10000000>; dc-gpios = {wire(panel.IS_ARGUMENT)};
                reset-gpios = {wire(panel.RESET, 1)}; width-mm = <35>; height-mm = <28>;
                panel-timing {{ hactive = <{panel.width}>; vactive = <{panel.height}>; {timing} }}; }}; }};""")

    def write(self):
        """The finished tree, a file for -dtb."""
        return self._file


def _run(command, text=None):
    done = subprocess.run([str(word) for word in command], input=text, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{re.sub(r' .*', '', str(command[0]))}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout
