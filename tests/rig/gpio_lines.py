"""The wires of the box's buttons: the eight inputs of the emulated machine's PL061, set from outside while the guest
runs. A real button's contacts bounce, so a press here does too, unless it is asked not to."""
# What the lines are called in the guest's device tree (device_tree.gpio_names), line 0 first.
LINE_NAMES = ["BTN_A", "BTN_B", "BTN_C", "BTN_D", "BTN_E", "BTN_F", "KEY_A", "KEY_B"]

_MAKE = [(1, 0.001), (0, 0.001), (1, 0.002), (0, 0.001), (1, 0)]  # contacts close: level, seconds
_BREAK = [(0, 0.001), (1, 0.001), (0, 0.001), (1, 0.002), (0, 0)]
BOUNCES = (len(_MAKE) + len(_BREAK)) // 2  # presses that a naive reader would count


class GpioLines:
    """`sleep`: waits for some seconds of the guest's clock."""

    def __init__(self, qmp, qtest, sleep):
        self._qtest = qtest
        self._sleep = sleep
        self._chip = qmp.find_object("pl061")

    def set(self, line, level):
        self._qtest(f"set_irq_in {self._chip} unnamed-gpio-in {line} {level}")

    def down(self, *lines):
        """The contacts of buttons close, all at once, and bounce."""
        self._play(lines, _MAKE)

    def up(self, *lines):
        self._play(lines, _BREAK)

    def press(self, *lines, seconds=0.15):
        """Presses buttons, holds them, and leaves them alone for a while."""
        self.down(*lines)
        self._sleep(seconds)
        self.up(*lines)
        self._sleep(0.25)

    def _play(self, lines, pattern):
        for level, seconds in pattern:
            for line in lines:
                self.set(line, level)
            self._sleep(seconds)
