"""The pixels of OpenEXR pictures as rpict writes them: 32 bit float channels, ZIP compression, one part.

source: the OpenEXR file layout; of its ZIP compression that the bytes of 16 scanlines are split into even and odd
ones and stored as differences before they are deflated.
"""
import array
import struct
import zlib

ROWS_A_BLOCK = 16


def _attributes(data):
    """name -> bytes, and where the header ends."""
    position, found = 8, {}
    while data[position]:
        end = data.index(b"\0", position)
        name = data[position:end].decode()
        position = data.index(b"\0", end + 1) + 1
        size, = struct.unpack_from("<i", data, position)
        found[name] = data[position + 4:position + 4 + size]
        position += 4 + size
    return found, position + 1


def _channel_names(text):
    names, position = [], 0
    while text[position]:
        end = text.index(b"\0", position)
        names.append(text[position:end].decode())
        if struct.unpack_from("<i", text, end + 1)[0] != 2:
            raise ValueError("channels of another type than float")
        position = end + 17
    return names


def _plain(block, size):
    """Undoes the compression of a block; one that would not shrink is stored as it is."""
    if len(block) == size:
        return block
    deltas = zlib.decompress(block)
    total, values = deltas[0], bytearray(size)
    values[0] = total
    for i in range(1, size):
        total = (total + deltas[i] - 128) & 255
        values[i] = total
    result = bytearray(size)
    half = (size + 1) // 2
    result[0::2], result[1::2] = values[:half], values[half:]
    return bytes(result)


def read_exr(path):
    """R G B of all pixels in file order, rows from the top, as read_hdr gives them."""
    with open(path, "rb") as file:
        data = file.read()
    header, position = _attributes(data)
    if header["compression"][0] != 3:
        raise ValueError(f"{path}: not ZIP compressed")
    names = _channel_names(header["channels"])
    x0, y0, x1, y1 = struct.unpack("<4i", header["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    blocks = (height + ROWS_A_BLOCK - 1) // ROWS_A_BLOCK
    result = array.array("d", bytes(8 * 3 * width * height))
    for offset in struct.unpack_from(f"<{blocks}Q", data, position):
        first, size = struct.unpack_from("<2i", data, offset)
        rows = min(ROWS_A_BLOCK, y1 + 1 - first)
        floats = array.array("f", _plain(data[offset + 8:offset + 8 + size], 4 * len(names) * width * rows))
        for row in range(rows):
            start = 3 * width * (first - y0 + row)
            for c, name in enumerate("RGB"):
                line = (row * len(names) + names.index(name)) * width
                result[start + c:start + 3 * width:3] = array.array("d", floats[line:line + width])
    return result
