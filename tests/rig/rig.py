"""The display rig: boots Debian's own kernels for ARM in emulation with the real program, presses its buttons and looks
at its screens. `tests/rig/run [NAME...]` runs all scenarios, or those whose names start so."""
import shutil
import sys
import time
import traceback
from concurrent.futures import ThreadPoolExecutor

from machines import BUILD, Skip
from scenarios.frame_buffers import frame_buffers
from scenarios.hotplug import hotplug
from scenarios.limits import memory, press_time, tearing
from scenarios.kernel_keys import keys
from scenarios.read_only import read_only_root
from scenarios.screen_and_buttons import press_to_picture
from scenarios.service import service
from scenarios.sixteen_bits import cirrus, spi_panel
from scenarios.supervision import killed, late_screen, switched, watchdog

# Longest first: two guests run at a time.
SCENARIOS = {
    "press-time": press_time,
    "service": service,
    "read-only-root": read_only_root,
    "memory": memory,
    "spi-panel": spi_panel,
    "buttons-arm64": press_to_picture("arm64"),
    "buttons-armhf": press_to_picture("armhf"),
    "buttons-armel": press_to_picture("armel"),
    "buttons-libgpiod2": press_to_picture("arm64-trixie"),
    "killed": killed,
    "switched": switched,
    "frame-buffers": frame_buffers,
    "late-screen": late_screen,
    "watchdog": watchdog,
    "keys": keys,
    "hotplug": hotplug,
    "cirrus": cirrus,
    "tearing": tearing,
}
AT_A_TIME = 2


def run(name):
    """Runs one scenario: "passed", "FAILED" or "skipped"."""
    folder = BUILD / "runs" / name
    shutil.rmtree(folder, ignore_errors=True)
    said = []
    begin = time.monotonic()
    try:
        SCENARIOS[name](folder, said.append)
        verdict = "passed"
    except Skip as reason:
        verdict = "skipped"
        said.append(str(reason))
    except Exception as error:  # pylint: disable=broad-except
        verdict = "FAILED"
        said += [f"{type(error).__name__}: {error}", f"kept: {folder}"]
        if not isinstance(error, (AssertionError, RuntimeError)) and type(error).__module__ == "builtins":
            said.append(traceback.format_exc())
    lines = [f"-- {name}: {verdict}, {time.monotonic() - begin:.0f} s", *(f"   {line}" for line in said)]
    print("\n".join(lines), flush=True)
    return verdict


def main(names):
    chosen = [name for name in SCENARIOS if not names or any(name.startswith(wanted) for wanted in names)]
    if not chosen:
        print(f"tests/rig/run: no scenario {' '.join(names)}; there are: {' '.join(SCENARIOS)}", file=sys.stderr)
        return 2
    with ThreadPoolExecutor(AT_A_TIME) as pool:
        verdicts = list(pool.map(run, chosen))
    passed, failed, skipped = (verdicts.count(verdict) for verdict in ("passed", "FAILED", "skipped"))
    print(f"rig: {passed} passed, {failed} failed, {skipped} skipped")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
