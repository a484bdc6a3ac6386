"""Pictures as the tests compare them: a PIL image in RGB. They come from files and from QEMU's screen."""
from PIL import Image, ImageChops


def load(path):
    with Image.open(path) as picture:
        return picture.convert("RGB")


def turned(picture, degrees):
    """Turned clockwise, as somebody sees it who looks at a panel mounted that way."""
    return picture.rotate(-degrees, expand=True)


def differing(one, other):
    """How many pixels differ; all of them where the sizes do."""
    if one.size != other.size:
        return max(one.width * one.height, other.width * other.height)
    difference = ImageChops.difference(one, other)
    any_channel = difference.split()
    worst = ImageChops.lighter(ImageChops.lighter(any_channel[0], any_channel[1]), any_channel[2])
    return one.width * one.height - worst.histogram()[0]


def within(picture, size):
    """The picture in the middle of a black screen."""
    screen = Image.new("RGB", size)
    screen.paste(picture, ((size[0] - picture.width) // 2, (size[1] - picture.height) // 2))
    return screen

