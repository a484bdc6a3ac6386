"""The box as a service: a small root with systemd, read-only, in which the program is installed as its package does it.
The guest's clock counts instructions, so that none of the service manager's times depends on how fast emulation is."""
from guest import Guest
from machines import systemd_root

_SCREEN = ["-device", "virtio-gpu-pci,xres=320,yres=240"]


def service(folder, say):
    root = systemd_root("arm64")
    devices = [*_SCREEN, "-drive", f"file={root},if=none,id=root,format=raw,read-only=on",
               "-device", "virtio-blk-pci,drive=root"]
    boot = "rig.root=/dev/vda modprobe.blacklist=virtio_gpu systemd.show_status=no"
    with Guest("arm64", folder, devices=devices, boot=boot, counted=True, limit=400) as guest:
        try:
            for part in (_readiness, _cage, _restart, _console, _crash_loop):
                part(guest, say)
        finally:
            # Kept with what the guest says on its console.
            guest.run("systemctl status --no-pager vitrine vitrine-safe; journalctl --no-pager", check=False)


def _show(guest, unit="vitrine"):
    """What systemd knows of a unit."""
    names = "ActiveState,SubState,Result,MainPID,NRestarts,NotifyAccess,WatchdogUSec,WatchdogTimestampMonotonic,StatusText,User"
    lines = guest.run(f"systemctl show {unit} -p {names}").splitlines()
    return dict(line.split("=", 1) for line in lines if "=" in line)


def _await_state(guest, state, unit="vitrine", seconds=120):
    """Asks seldom: the answer takes the guest long."""
    guest.await_true(f"sleep 1; systemctl show {unit} -p ActiveState | grep -qx ActiveState={state}", seconds,
                     f"{unit} does not become {state}")


def _expect(shown, **wanted):
    wrong = {key: shown.get(key) for key, value in wanted.items() if shown.get(key) != value}
    if wrong:
        raise AssertionError(f"systemd says {wrong} where {wanted} was expected: {shown}")


def _readiness(guest, say):
    """There is no screen yet, so no frame, so no READY: the service is not active before there is one."""
    guest.await_true("sleep 1; systemctl show vitrine -p StatusText | grep -q 'waiting for a screen'", 100,
                     "it does not say that it waits for a screen")
    before = _show(guest)
    _expect(before, ActiveState="activating", SubState="start", NotifyAccess="main", User="vitrine")
    guest.run("modprobe virtio_gpu")
    guest.await_true("grep -qsx 'vitrine_waiting_for_screen 0' /run/vitrine/vitrine.prom", 100, "it does not see the screen")
    _await_state(guest, "active")
    after = _show(guest)
    _expect(after, SubState="running", MainPID=before["MainPID"], WatchdogUSec="15s", NRestarts="0")
    say(f"Type=notify: {before['ActiveState']} ('{before['StatusText']}') until the first flip, then {after['ActiveState']}"
        f" ('{after['StatusText']}'), watchdog {after['WatchdogUSec']}")


def _cage(guest, say):
    user = guest.run("sed -n 's/^vitrine:x:\\([0-9]*\\):.*/\\1/p' /etc/passwd")
    pid = _show(guest)["MainPID"]
    status = dict(line.split(":\t", 1) for line in guest.run(f"cat /proc/{pid}/status").splitlines() if ":\t" in line)
    if status["Uid"].split()[0] != user or int(status["CapEff"], 16) or status["NoNewPrivs"] != "1" or status["Seccomp"] != "2":
        raise AssertionError(f"it runs with {status}")
    owner = guest.run("stat -c %U /run/vitrine/vitrine.prom")
    if owner != "vitrine":
        raise AssertionError(f"the health file is {owner}'s")
    say(f"user vitrine ({user}) by sysusers, without capabilities; health in /run/vitrine")


def _restart(guest, say):
    before = _show(guest)
    guest.run(f"kill -KILL {before['MainPID']}")
    guest.run(f"while test -d /proc/{before['MainPID']}; do sleep 1; done; sleep 3")  # RestartSec
    _await_state(guest, "active")
    after = _show(guest)
    _expect(after, SubState="running", NRestarts="1")
    if after["MainPID"] == before["MainPID"]:
        raise AssertionError("the same process as before")
    say("after kill -9: a new process, active again")


def _console(guest, say):
    """Whoever could give the console back is killed too; only the service manager is left."""
    during = guest.run("console_mode")
    guest.run("systemctl kill --kill-whom=all --signal=KILL vitrine && systemctl stop vitrine")
    after = guest.run("console_mode")
    say(f"all its processes killed at once: console '{during}' becomes '{after}'")
    if after != "text on" or during == after:
        raise AssertionError("the console is not given back")


def _crash_loop(guest, say):
    """Each new process is killed, until systemd has had enough."""
    guest.run("systemctl reset-failed vitrine; systemctl start --no-block vitrine")
    kills = int(guest.run("""kills=0 rest=0
      until [ $rest = 6 ]; do  # seconds, twice RestartSec
        if kill -KILL $(cat /sys/fs/cgroup/system.slice/vitrine.service/cgroup.procs); then
          kills=$((kills + 1)) rest=0
        else
          rest=$((rest + 1))
        fi 2>/dev/null
        sleep 1
      done; echo $kills"""))
    _expect(_show(guest), ActiveState="failed")
    _await_state(guest, "active", "vitrine-safe")
    shown = guest.screen("safe")
    colours, status = len(shown.getcolors(1 << 20)), _show(guest, "vitrine-safe")["StatusText"]
    say(f"killed {kills} times: failed; vitrine-safe is active ('{status}'), its screen has {colours} colours")
    if kills != 5 or colours < 50 or "error card" not in status:
        raise AssertionError("the limit is another, or the screen is empty")
