"""Screens of every shape: frame buffer memory with 16, 24 and 32 bits a pixel, odd widths, padded rows, red and blue
swapped. What is in the memory must be the headless display's picture, in as many bits as
there are."""
from box import STILL, Expected, Session
from guest import Guest, GuestError
from pictures import FrameBuffer, differing, largest_step, turned

_BUFFERS = {
    "16 bits": FrameBuffer(160, 120, 320, "r5g6b5"),
    "odd and padded": FrameBuffer(163, 121, 352, "r5g6b5"),
    "24 bits": FrameBuffer(163, 121, 491, "r8g8b8"),
    "red and blue swapped": FrameBuffer(160, 120, 640, "a8b8g8r8"),
}


def frame_buffer(name):
    buffer = _BUFFERS[name]
    exact = buffer.layout.count("8") >= 3

    def scenario(folder, say):
        with Guest("arm64", folder, board=lambda tree: tree.add_frame_buffer(buffer)) as guest:
            expected = Expected(guest)
            rotations = (0,)
            for rotation in rotations:
                upright = (buffer.width, buffer.height) if rotation % 180 == 0 else (buffer.height, buffer.width)
                wanted = turned(expected(f"{upright[0]}x{upright[1]}"), rotation)
                session = Session(guest, "--display fbdev --buttons script", script=STILL,
                                  config=f"[display]\nrotation = {rotation}\n")

                def look():
                    return guest.frame_buffer(buffer, f"memory-{rotation}")

                if exact:
                    session.await_picture(look, wanted)
                    say(f"{buffer.layout} {buffer.width}x{buffer.height}, rows of {buffer.stride} bytes: equal")
                else:
                    shown = _await_near(session, look, wanted, 9)
                    say(f"{buffer.layout} {buffer.width}x{buffer.height}, rows of {buffer.stride} bytes, turned by"
                        f" {rotation}: no channel is off by more than {largest_step(shown, wanted)} of 255")
                session.stop()
    return scenario


def _await_near(session, look, wanted, step):
    """Waits until no channel is further off than a dithered pixel of few bits may be."""
    for _ in range(100):
        shown = look()
        if shown.size == wanted.size and largest_step(shown, wanted) <= step:
            return shown
        session.guest.run("sleep 0.3")
    raise GuestError(f"the memory differs in {differing(shown, wanted)} pixels, by up to"
                     f" {largest_step(shown, wanted)} of 255; it said: {session.said()}")
