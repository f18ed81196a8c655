#!/usr/bin/env python3
"""Draws the maps of the studies: make_maps.py FOLDER. Same bits every time."""

import random
import sys
from collections import deque


class Map:
    def __init__(self, side, blocked=False):
        self.side = side
        self.rows = [[blocked] * side for _ in range(side)]

    def box(self, x0, y0, x1, y1):
        """Blocks the cells from (x0, y0) to (x1 - 1, y1 - 1)."""
        for y in range(max(0, y0), min(self.side, y1)):
            for x in range(max(0, x0), min(self.side, x1)):
                self.rows[y][x] = True

    def disc(self, cx, cy, radius):
        for y in range(self.side):
            for x in range(self.side):
                if (x - cx) ** 2 + (y - cy) ** 2 <= radius ** 2:
                    self.rows[y][x] = True

    def polygon(self, *corners):
        """Blocks the cells whose centres lie inside, by the rule of even and odd."""
        for y in range(self.side):
            for x in range(self.side):
                inside = False
                for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
                    if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
                        inside = not inside
                if inside:
                    self.rows[y][x] = True

    def free(self, x, y):
        return 0 <= x < self.side and 0 <= y < self.side and not self.rows[y][x]

    def write(self, file):
        if file.endswith(".pbm"):  # large maps: one bit a cell
            self.write_pbm(file)
            return
        with open(file, "w", encoding="ascii") as out:
            out.write(f"type octile\nheight {self.side}\nwidth {self.side}\nmap\n")
            for row in self.rows:
                out.write("".join("@" if b else "." for b in row) + "\n")

    def write_pbm(self, file):
        with open(file, "wb") as out:
            out.write(f"P4\n{self.side} {self.side}\n".encode("ascii"))
            for row in self.rows:
                bits = "".join("1" if b else "0" for b in row)
                bits += "0" * (-len(bits) % 8)
                out.write(int(bits, 2).to_bytes(len(bits) // 8, "big"))


def steps(m, start, goal):
    """Cells of a shortest way by four neighbours, or nothing."""
    came = {start: None}
    queue = deque([start])
    while queue:
        at = queue.popleft()
        if at == goal:
            way = []
            while at:
                way.append(at)
                at = came[at]
            return way
        for dx, dy in ((0, -1), (-1, 0), (1, 0), (0, 1)):
            to = (at[0] + dx, at[1] + dy)
            if m.free(*to) and to not in came:
                came[to] = at
                queue.append(to)
    return None


def second_route(m, start, goal):
    """Length of the shortest way that misses a cell of the best one, over the best's length."""
    best = steps(m, start, goal)
    least = None
    for x, y in best[1:-1]:
        m.rows[y][x] = True
        other = steps(m, start, goal)
        m.rows[y][x] = False
        if other and (least is None or len(other) < least):
            least = len(other)
    return (least - 1) / (len(best) - 1) if least else 99.0


def maze(side, seed, detour):
    """Corridors one cell wide: a random tree on the even cells, some walls opened again, each one
    a loop more. From bottom left to top right a best way at least `detour` times as long as without
    walls, and another one at most 10% longer."""
    rng = random.Random(seed)
    while True:
        m = Map(side, blocked=True)
        seen = {(0, 0)}
        stack = [(0, 0)]
        walls = []
        m.rows[0][0] = False
        while stack:
            x, y = stack[-1]
            ways = [(dx, dy) for dx, dy in ((2, 0), (-2, 0), (0, 2), (0, -2))
                    if 0 <= x + dx < side and 0 <= y + dy < side and (x + dx, y + dy) not in seen]
            if not ways:
                stack.pop()
                continue
            dx, dy = rng.choice(ways)
            m.rows[y + dy // 2][x + dx // 2] = m.rows[y + dy][x + dx] = False
            seen.add((x + dx, y + dy))
            stack.append((x + dx, y + dy))
        for y in range(0, side, 2):
            for x in range(0, side, 2):
                for dx, dy in ((1, 0), (0, 1)):
                    if not m.free(x + dx, y + dy) and (x + 2 * dx, y + 2 * dy) in seen:
                        walls.append((x + dx, y + dy))
        for x, y in rng.sample(walls, max(3, side * side // 60)):
            m.rows[y][x] = False
        m.rows[side - 1][0] = m.rows[0][side - 1] = False
        start, goal = (0, side - 1), (side - 1, 0)
        best = steps(m, start, goal)
        if best and len(best) - 1 >= detour * 2 * (side - 1) and second_route(m, start, goal) <= 1.1:
            return m


def blocks(side, seed, count, largest):
    """Rectangles at random, the corners and their surroundings left free."""
    rng = random.Random(seed)
    m = Map(side)
    for _ in range(count):
        w, h = rng.randint(1, largest), rng.randint(1, largest)
        x, y = rng.randint(0, side - w), rng.randint(0, side - h)
        m.box(x, y, x + w, y + h)
    for x in (0, 1, side - 2, side - 1):
        for y in (0, 1, side - 2, side - 1):
            m.rows[y][x] = False
    return m


def free_space(text):
    rows = text.split()
    m = Map(len(rows))
    for y, row in enumerate(rows):
        for x, c in enumerate(row):
            m.rows[y][x] = c == "@"
    return m


def workspace(boxes, polygons=(), discs=()):
    """500 x 500 cells with these shapes blocked."""
    m = Map(500)
    for box in boxes:
        m.box(*box)
    for corners in polygons:
        m.polygon(*corners)
    for disc in discs:
        m.disc(*disc)
    return m


# Four walls about the goal at (400, 450), with a door below.
ROOM = [(340, 395, 446, 401), (440, 395, 446, 491), (340, 395, 346, 500), (358, 485, 446, 491)]


def simple_workspace():
    """One slanting bar across the way, and blocks off it."""
    return workspace(
        boxes=[
            (60, 150, 120, 210), (330, 330, 390, 370), (300, 30, 400, 70), (40, 400, 130, 450)],
        polygons=[
            ((128, 327), (310, 143), (326, 159), (144, 343))],
        discs=[(420, 210, 30)])


def relatively_complex_workspace():
    """A longer bar, and a room about the goal at (400, 450) with its door below."""
    return workspace(
        boxes=ROOM + [
            (88, 366, 104, 500), (60, 140, 110, 220), (170, 40, 230, 110), (400, 160, 450, 230),
            (330, 260, 390, 310), (180, 400, 250, 450)],
        polygons=[
            ((88, 366), (343, 114), (359, 130), (104, 382))],
        discs=[(440, 330, 25)])


def complex_workspace():
    """Two long walls, the room again, and many blocks of several shapes."""
    return workspace(
        boxes=ROOM + [
            (108, 0, 116, 272), (250, 240, 258, 500), (30, 120, 80, 170), (20, 340, 90, 380),
            (60, 430, 200, 450), (150, 30, 220, 90), (350, 40, 370, 130), (350, 110, 440, 130),
            (410, 190, 460, 240), (285, 330, 320, 380), (460, 20, 480, 90), (470, 350, 490, 400)],
        polygons=[
            ((20, 230), (70, 250), (40, 300)),
            ((150, 130), (220, 150), (190, 220), (140, 200)),
            ((300, 200), (360, 190), (340, 240)),
            ((280, 420), (320, 430), (300, 480))],
        discs=[(150, 360, 32), (290, 120, 35), (420, 300, 22)])


def free_spaces():
    """The last is figure 6 of the lecture, "---" blocked; the others are of our own."""
    return {
        "simple": free_space("""
            .......... ...@@..... ...@@..... .......... ......@... .@@...@... .@@.......
            .......@.. ....@..@.. .........."""),
        "average": free_space("""
            ....@..... .@@.@..@.. .@.....@.. ...@@..... .@....@@.. .@.@...... ...@.@@.@.
            .@.....@.. .@.@@.@@.. ...@......"""),
        "complex": free_space("""
            .......@.. ....@..... .......@.. .......... .......... ....@..... ........@.
            ....@..... ........@. .@.@@.@@.."""),
    }


MAZES = ((10, 1.0), (10, 1.4), (12, 1.2), (16, 1.2), (16, 1.6), (20, 1.4), (24, 1.5), (32, 1.5))


def main(folder):
    for i, (side, detour) in enumerate(MAZES, start=1):
        maze(side, i, detour).write(f"{folder}/maze{i}-{side}x{side}.map")
    blocks(20, 85, 22, 4).write(f"{folder}/grid20a.map")
    blocks(20, 119, 22, 4).write(f"{folder}/grid20b.map")
    blocks(30, 34, 36, 5).write(f"{folder}/grid30a.map")
    blocks(30, 35, 36, 5).write(f"{folder}/grid30b.map")
    for name, m in free_spaces().items():
        m.write(f"{folder}/free-space-{name}.map")
    simple_workspace().write(f"{folder}/workspace-simple.pbm")
    relatively_complex_workspace().write(f"{folder}/workspace-relatively-complex.pbm")
    complex_workspace().write(f"{folder}/workspace-complex.pbm")


if __name__ == "__main__":
    main(sys.argv[1])
