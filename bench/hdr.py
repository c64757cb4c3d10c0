"""Reads RADIANCE pictures and rays' results for comparisons: flat lists of floats."""
import array
import math


def _scanline(data, position, width):
    """One scanline as width tuples (r, g, b, exponent) and where the next begins; flat or run lengths per channel."""
    packed = 8 <= width <= 32767 and data[position] == 2 and data[position + 1] == 2 and data[position + 2] < 128
    if not packed:
        end = position + 4 * width
        return [tuple(data[k:k + 4]) for k in range(position, end, 4)], end
    position += 4
    channels = []
    for _ in range(4):
        values = bytearray()
        while len(values) < width:
            code = data[position]
            if code > 128:
                values += data[position + 1:position + 2] * (code - 128)
                position += 2
            else:
                values += data[position + 1:position + 1 + code]
                position += 1 + code
        channels.append(values)
    return list(zip(*channels)), position


def read_hdr(path):
    """All channels of all pixels in file order, divided by the exposure."""
    with open(path, "rb") as file:
        data = file.read()
    end = data.index(b"\n\n")
    exposure = 1.0
    for line in data[:end].split(b"\n"):
        if line.startswith(b"EXPOSURE="):
            exposure *= float(line[9:])
    position = data.index(b"\n", end + 2) + 1
    words = data[end + 2:position].split()
    height, width = int(words[1]), int(words[3])
    scales = [0.0] + [math.ldexp(1 / exposure, exponent - 136) for exponent in range(1, 256)]
    result = array.array("d")
    for _ in range(height):
        pixels, position = _scanline(data, position, width)
        for r, g, b, exponent in pixels:
            scale = scales[exponent]
            result.extend(((r + .5) * scale, (g + .5) * scale, (b + .5) * scale))
    return result


def read_floats(path):
    """The 32 bit floats that `rtrace -h -ff` writes."""
    result = array.array("f")
    with open(path, "rb") as file:
        result.frombytes(file.read())
    return result


def difference(ours, theirs):
    """Relative to the mean of `theirs`: difference of the means, and root mean square difference of the values."""
    if len(ours) != len(theirs):
        raise ValueError(f"{len(ours)} values against {len(theirs)}")
    mean = sum(theirs) / len(theirs)
    if mean == 0:
        raise ValueError("the reference is black")
    rms = math.sqrt(sum((a - b) ** 2 for a, b in zip(ours, theirs)) / len(ours))
    return (sum(ours) / len(ours) - mean) / mean, rms / mean
