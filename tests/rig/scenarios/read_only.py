"""A root that cannot be written: what the program opens for writing, makes, renames or removes."""
import re
import shutil

from box import STILL, Session
from guest import Guest
from machines import packages

_RUNTIME = "/run/vitrine"
_CALLS = "openat,?openat2,mkdirat,mknodat,unlinkat,?renameat,renameat2,linkat,symlinkat,truncate,fchmodat,fchownat,utimensat"
_LIBRARIES = ("libunwind.so.8", "liblzma.so.5")


def read_only_root(folder, say):
    """strace sees every call of a session that loads scenes, takes a screenshot, reads its config anew and writes its
    health, and of one that fails. An attempt counts, whether or not the kernel refused it."""
    screen = ["-device", "virtio-gpu-pci,xres=320,yres=240"]
    with Guest("arm64", folder, devices=screen) as guest:
        _unpack_strace(folder)
        guest.run("modprobe virtio_gpu; mkdir -p /etc; mount -o remount,ro /")
        guest.run("! touch /etc/writable 2>/dev/null")
        guest.run(f"mkdir {_RUNTIME}")
        script = STILL + "0.30 tap screenshot\n0.40 tap mode\n2.00 tap quit\n"
        session = Session(guest, f"--display drm --buttons script --size 160x120 --runtime-dir {_RUNTIME}", script=script,
                          config='[health]\nevery_s = 0.5\n', environment=_strace("/run/session.trace"))
        guest.await_true(f"test -s {_RUNTIME}/vitrine.prom", 60, "no health file")
        guest.run(f"kill -HUP $(cat /proc/{session.pid}/task/{session.pid}/children)")
        session.report(120)
        (folder / "wrong.toml").write_text('playlist = "nowhere.toml"\n', encoding="utf-8")
        guest.run(f"{_strace('/run/failure.trace')} vitrine run --display headless --frames 1 --config /host/wrong.toml"
                  f" --runtime-dir {_RUNTIME}", check=False)
        guest.run("cp /run/*.trace /host")
        kept = guest.run(f"ls {_RUNTIME}").split()
    opened, written = _read(folder / "session.trace")
    _, written_by_failure = _read(folder / "failure.trace")
    written += written_by_failure
    elsewhere = {name for name in written if not name.startswith((_RUNTIME + "/", "/dev/"))}
    files = {name for name in written if not name.startswith("/dev/")}
    say(f"{opened} files opened, {len(files)} of them written, all in {_RUNTIME}; devices:"
        f" {' '.join(sorted(name for name in set(written) - files))}")
    if elsewhere:
        raise AssertionError(f"written elsewhere: {' '.join(sorted(elsewhere))}")
    if not {"vitrine.prom", "last-words"} <= set(kept) or not any(name.endswith(".png") for name in kept):
        raise AssertionError(f"the runtime directory holds only {kept}")
    if not {f"{_RUNTIME}/{name}" for name in ("last-words",)} <= files:
        raise AssertionError(f"the trace misses what was written: {files}")
    if (folder / "session.trace").read_text(encoding="utf-8").count('session.toml", O_RDONLY') < 2:
        raise AssertionError("the config was not read anew")


def _unpack_strace(folder):
    """Onto /host: the guest's root holds nothing that only this scenario needs."""
    unpacked = packages("bookworm", "arm64", "strace", "libunwind8", "liblzma5")
    for file in ["usr/bin/strace", *(f"usr/lib/aarch64-linux-gnu/{name}" for name in _LIBRARIES)]:
        shutil.copy(unpacked / file, folder)


def _strace(trace):
    return (f"LD_LIBRARY_PATH=/host /host/strace --seccomp-bpf -f -qq -o {trace} -e trace={_CALLS} -e signal=none"
            " -E LD_LIBRARY_PATH")


def _read(trace):
    """How many files were opened, and the names of those that were to be changed."""
    opened, changed = 0, []
    for line in trace.read_text(encoding="utf-8").splitlines():
        call = re.match(r"\d+ +(\w+)\((.*)", line)
        if not call:
            continue
        names = re.findall(r'"((?:[^"\\]|\\.)*)"', call[2])
        if not call[1].startswith("openat"):
            changed += names
            continue
        opened += 1
        if re.search(r"O_WRONLY|O_RDWR|O_CREAT|O_TRUNC", call[2]):
            changed += names
    return opened, changed
