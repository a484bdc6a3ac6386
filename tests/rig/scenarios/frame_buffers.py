"""Frame buffer memory of every shape, all on one box: 16, 24 and 32 bits a pixel, odd widths, rows with a gap, red and
blue swapped, bits that say "opaque"; and each way to mount a panel. The memory is read from outside and must be the
headless display's picture to the last bit. (vfb, whose red and blue are swapped too, is in no kernel of Debian's for
ARM.)"""
from box import STILL, Expected, Session, doubled
from guest import Guest
from pictures import turned, within
from screen_memory import FrameBuffer

_WIDTH, _HEIGHT = 83, 61
_SMALL = (32, 24)  # shown twice as large, off the dither's grid
_BUFFERS = [FrameBuffer(_WIDTH, _HEIGHT, stride, layout, 0x4F000000 + number * 0x100000)
            for number, (layout, stride) in enumerate([
                ("r5g6b5", 180), ("r5g5b5a1", 166), ("r8g8b8", 251), ("a8b8g8r8", 340), ("x2r10g10b10", 332)])]


def frame_buffers(folder, say):
    def board(tree):
        for buffer in _BUFFERS:
            tree.add_frame_buffer(buffer)

    with Guest("arm64", folder, board=board) as guest:
        expected = Expected(guest)
        upright = expected(f"{_WIDTH}x{_HEIGHT}")
        sideways = expected(f"{_HEIGHT}x{_WIDTH}")
        small = expected(f"{_SMALL[0]}x{_SMALL[1]}")
        dithered, *others = _BUFFERS
        _show(guest, dithered, upright)
        for rotation, picture in ((90, sideways), (180, upright), (270, sideways)):
            _show(guest, dithered, turned(picture, rotation), f"rotation = {rotation}")
        say(f"{dithered.layout}, {_WIDTH}x{_HEIGHT}, rows of {dithered.stride} bytes, turned by 0, 90, 180, 270: every"
            f" one of {dithered.bytes} bytes is right, dither included")
        _show(guest, dithered, within(doubled(small), dithered.size), 'scaling = "integer"',
              f"--size {small.width}x{small.height}")
        say("the same for a smaller picture, twice as large in the middle")
        for buffer in others:
            _show(guest, buffer, upright)
            say(f"{buffer.layout}, rows of {buffer.stride} bytes: all {buffer.bytes} bytes")


def _show(guest, buffer, picture, display="", options=""):
    """Runs the program on a frame buffer until its memory is what the picture must be there."""
    # The kernel numbers them as it likes, and names their devices by their addresses.
    device = guest.run(f"for f in /sys/class/graphics/fb*; do case $(readlink -f $f/device) in"
                       f" */{buffer.address:x}.framebuffer) echo /dev/${{f##*/}};; esac; done")
    session = Session(guest, f"--display fbdev --buttons script {options}", script=STILL,
                      config=f'[display]\ndevice = "{device}"\n{display}\n')
    wanted = buffer.memory(picture)
    session.await_picture(lambda: buffer.picture(guest.memory(buffer.address, buffer.bytes)), buffer.picture(wanted))
    if guest.memory(buffer.address, buffer.bytes) != wanted:
        raise AssertionError(f"{buffer}: bytes between the rows, or bits of no colour, are not what they must be")
    session.stop()
