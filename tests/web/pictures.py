"""Pictures that are nearly the same."""
from PIL import ImageChops

VISIBLE = 48  # of 255, in one channel: another driver's edges stay below, another word or mark does not


def difference(picture, other):
    """The share of pixels that differ visibly; 1 for another size."""
    if picture.size != other.size:
        return 1.0
    channels = ImageChops.difference(picture.convert("RGB"), other.convert("RGB")).split()
    greatest = ImageChops.lighter(ImageChops.lighter(channels[0], channels[1]), channels[2])
    return sum(greatest.histogram()[VISIBLE:]) / (picture.width * picture.height)
