"""Reads GIF89a films as the specification has it, apart from any library."""
import struct


def unpacked(data, bits):
    """LZW codes from `bits` + 1 bits on, as numbers of colours."""
    clear, end = 1 << bits, (1 << bits) + 1
    out, table, width, last = bytearray(), {}, bits + 1, None
    buffer = held = 0
    for byte in data:
        buffer |= byte << held
        held += 8
        while held >= width:
            code = buffer & ((1 << width) - 1)
            buffer >>= width
            held -= width
            if code == end:
                return bytes(out)
            if code == clear:
                table = {i: bytes([i]) for i in range(clear)}
                size, width, last = end + 1, bits + 1, None
                continue
            entry = table[code] if code in table else last + last[:1]
            out += entry
            if last is not None and size < 4096:
                table[size] = last + entry[:1]
                size += 1
                if size == 1 << width and width < 12:
                    width += 1
            last = entry
    raise ValueError("no end of LZW data")


def blocks(data, at):
    """The sub-blocks from `at` on, joined, and what follows them."""
    joined = bytearray()
    while data[at]:
        joined += data[at + 1:at + 1 + data[at]]
        at += 1 + data[at]
    return bytes(joined), at + 1


def read_film(data):
    """Width, height, frames: each a list of rows of (red, green, blue)."""
    assert data[:6] == b"GIF89a"
    width, height, flags = struct.unpack("<HHB", data[6:11])
    count = 2 << (flags & 7)
    colours = [tuple(data[13 + 3 * i:16 + 3 * i]) for i in range(count)]
    at, frames = 13 + 3 * count, []
    screen = [[None] * width for _ in range(height)]
    while data[at] != 0x3B:
        if data[at] == 0x21:
            at = blocks(data, at + 2)[1]
            continue
        assert data[at] == 0x2C
        x, y, w, h, flags = struct.unpack("<HHHHB", data[at + 1:at + 10])
        assert flags == 0 and x + w <= width and y + h <= height
        packed, after = blocks(data, at + 11)
        pixels = unpacked(packed, data[at + 10])
        assert len(pixels) == w * h
        for row in range(h):
            screen[y + row][x:x + w] = [colours[i] for i in pixels[row * w:(row + 1) * w]]
        frames.append([list(row) for row in screen])
        at = after
    assert at == len(data) - 1
    return width, height, frames
