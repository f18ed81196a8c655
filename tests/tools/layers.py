"""Small maps, and layers of costs for them, as the files that lasius reads."""
import struct


def random_map(rng, width, height, share=0.2):
    rows = [["@" if rng.random() < share else "." for _ in range(width)] for _ in range(height)]
    rows[0][0] = rows[-1][-1] = "."
    return ["".join(row) for row in rows]


def map_text(rows):
    return f"type octile\nheight {len(rows)}\nwidth {len(rows[0])}\nmap\n" + "".join(row + "\n" for row in rows)


def pgm(rows, most=255):
    """Rows of levels from the top."""
    body = b"".join(struct.pack(f">{len(row)}{'H' if most > 255 else 'B'}", *row) for row in rows)
    return f"P5\n{len(rows[0])} {len(rows)}\n{most}\n".encode() + body


def pfm(rows):
    """Rows of values from the top; the file has them from the bottom."""
    return f"Pf\n{len(rows[0])} {len(rows)}\n-1\n".encode() + b"".join(
        struct.pack(f"<{len(row)}f", *row) for row in reversed(rows))


def npy(rows):
    head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({len(rows)}, {len(rows[0])}), }}".encode()
    head += b" " * (63 - (len(head) + 10) % 64) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head + b"".join(
        struct.pack(f"<{len(row)}d", *row) for row in rows)


def yaml(image, resolution, origin, mode="trinary", occupied=0.65, free=0.25, negate=0):
    return (f"image: {image}\nresolution: {resolution}\norigin: {list(origin)}\nmode: {mode}\n"
            f"negate: {negate}\noccupied_thresh: {occupied}\nfree_thresh: {free}\n")
