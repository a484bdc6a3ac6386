"""The machines that guests are: which of Debian's kernels, which userland, which emulated board; and what is made once
for each, in build/rig, before a guest can start."""
import subprocess
import threading
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "rig"
_IMAGES = Path(__file__).resolve().parent / "images"

_MODULES = """9p 9pnet_virtio virtio_pci virtio_console virtio_gpu cirrus bochs spi_gpio panel_mipi_dbi gpio_keys evdev
virtio_input uinput virtio_blk squashfs""".split()
_DATA = ["cornell", "gallery", "furnace"]  # scenes that guests show

_AARCH64 = ("qemu-system-aarch64", "-machine", "virt", "-cpu", "cortex-a53")
_ARM = ("qemu-system-arm", "-machine", "virt,highmem=off", "-cpu", "cortex-a7")


class Skip(Exception):
    """This cannot be tried on this machine; the message says why."""


@dataclass(frozen=True)
class Machine:
    preset: str  # of CMake: the program and its tools
    sysroot: str  # SUITE-ARCH of firmware/sysroot
    kernels: tuple  # (suite, arch, package), tried in this order
    qemu: tuple
    required: bool = True  # its kernel comes with the same suite as everything else: no kernel, no pass

    @property
    def arch(self):
        return self.sysroot.split("-")[1]


MACHINES = {
    "arm64": Machine("arm64", "bookworm-arm64", (("bookworm", "arm64", "linux-image-arm64"),), _AARCH64),
    "arm64-trixie": Machine("arm64-trixie", "trixie-arm64", (("trixie", "arm64", "linux-image-arm64"),), _AARCH64,
                            required=False),
    "armhf": Machine("armhf", "bookworm-armhf", (("bookworm", "armhf", "linux-image-armmp"),), _ARM),
    "armel": Machine("armel", "bookworm-armel", (("bookworm", "armhf", "linux-image-armmp"),), _ARM),
    # A kernel with panel-mipi-dbi: bookworm's own has none.
    "armhf-spi": Machine("armhf", "bookworm-armhf", (("trixie", "armhf", "linux-image-armmp"),
                                                     ("bookworm-backports", "armhf", "linux-image-armmp")), _ARM,
                         required=False),
}

_lock = threading.Lock()


def _command(words):
    done = subprocess.run([str(word) for word in words], cwd=ROOT, capture_output=True, text=True, check=False,
                          stdin=subprocess.DEVNULL)
    if done.returncode:
        said = (done.stderr.strip() or done.stdout.strip()).splitlines()
        raise RuntimeError(f"{Path(words[0]).name} {' '.join(map(str, words[1:4]))}: {said[-1] if said else 'failed'}")
    return done.stdout


def packages(suite, arch, package, *more):
    """The folder of a package, and more that it needs, which were downloaded and unpacked."""
    folder = BUILD / f"{suite}-{arch}" / package
    _command([_IMAGES / "packages", suite, arch, folder, package, *more])
    return folder


def kernel(machine):
    """The folder of its kernel; skips where no mirror has it."""
    problems = []
    for suite, arch, package in machine.kernels:
        try:
            return packages(suite, arch, package)
        except RuntimeError as error:
            problems.append(str(error))
    problem = "; ".join(problems)
    if machine.required:
        raise RuntimeError(problem)
    raise Skip(problem)


def programs(machine):
    """The folder of what was built for it."""
    suite, arch = machine.sysroot.split("-")
    _command([ROOT / "firmware" / "sysroot", arch, suite])
    _command(["nice", ROOT / "firmware" / "build", machine.preset, "vitrine", "rig_tools"])
    return ROOT / "build" / machine.preset


def prepare(name):
    """Kernel and initramfs of a machine: {"kernel": FILE, "initrd": FILE}."""
    machine = MACHINES[name]
    with _lock:
        kernel_folder = kernel(machine)
        built = programs(machine)
        busybox = packages("bookworm", machine.arch, "busybox-static")
        initrd = BUILD / f"{name}.cpio.gz"
        tools = sorted((built / "tests" / "rig" / "tools").glob("*"))
        files = [f for f in [built / "firmware" / "vitrine", *tools] if f.exists()]
        made_of = [*files, *_IMAGES.iterdir(), Path(__file__)]
        if not initrd.exists() or any(file.stat().st_mtime > initrd.stat().st_mtime for file in made_of):
            scenes = [file for scene in _DATA for file in sorted((ROOT / "scenes").glob(f"{scene}[.-]*"))]
            pairs = [f"{file}=usr/bin/{file.name}" for file in [*files, _IMAGES / "rig_shell"]]
            pairs += [f"{file}=usr/share/vitrine/scenes/{file.name}" for file in scenes if file.is_file()]
            _command([_IMAGES / "initramfs", initrd, kernel_folder, busybox,
                      ROOT / "build" / "sysroots" / machine.sysroot, " ".join(_MODULES), _IMAGES / "init", *pairs])
        return {"kernel": next((kernel_folder / "boot").glob("vmlinuz-*")), "initrd": initrd}


def systemd_root(name):
    """A disk image for a machine: a read-only root with systemd, and the program installed as a service."""
    machine = MACHINES[name]
    prepare(name)
    with _lock:
        built = ROOT / "build" / machine.preset
        tools = sorted((built / "tests" / "rig" / "tools").glob("*"))
        image = BUILD / f"{name}-systemd.squashfs"
        made_of = [built / "firmware" / "vitrine", *tools, *_IMAGES.iterdir(), *(ROOT / "firmware").glob("*vitrine*"),
                   *(ROOT / "scenes").iterdir()]
        if not image.exists() or any(file.stat().st_mtime > image.stat().st_mtime for file in made_of):
            suite, arch = machine.sysroot.split("-")
            busybox = packages("bookworm", arch, "busybox-static")
            _command([_IMAGES / "systemd_root", image, suite, arch, built, busybox, _IMAGES / "rig_shell", *tools])
        return image
