// Drawing on a map view: blocked cells, free cells, start and goal.
//
//   tools = new Drawing(host, view, {onCells, onStart, onGoal, size})
//     onCells([[x, y], ...], blocked)   cells to change, inside the map
//     onStart({x, y}), onGoal({x, y})
//     size()                            -> {width, height} of the map
//   tools.use(view)                     another view, of another map
//   tools.cursor                        {x, y} where keys draw, null without
//
// Keys with the focus on the map, unless the tool is "move": arrows move a cursor, with shift by ten
// cells; Enter or space draws there.

import { element } from "./dom.js";
import { field } from "./fields.js";
import { choices } from "./sheet.js";

const kTools = [["move", "Look"], ["wall", "Draw walls"], ["free", "Erase"], ["start", "Start"], ["goal", "Goal"]];

/** The cells of a line, ends included. */
export function cellsBetween([x, y], [toX, toY]) {
  const steps = Math.max(Math.abs(toX - x), Math.abs(toY - y), 1), cells = [];
  for (let i = 0; i <= steps; ++i) cells.push([Math.round(x + ((toX - x) * i) / steps), Math.round(y + ((toY - y) * i) / steps)]);
  return cells;
}

export class Drawing {
  constructor(host, { onCells, onStart, onGoal, size }) {
    Object.assign(this, { onCells, onStart, onGoal, size, tool: "move", last: null, cursor: null });
    this.brush = element("input", { type: "range", min: 1, max: 15, step: 2, value: 3, "aria-label": "Brush, cells" });
    host.append(choices("Tool", kTools, "move", (tool) => this.choose(tool)), field("brush", this.brush));
  }

  choose(tool) {
    this.tool = tool;
    this.view.canvas.style.touchAction = tool === "move" ? "" : "none";
    this.view.canvas.style.cursor = tool === "move" ? "" : "crosshair";
    if (tool === "move") this.cursor = null;
    this.view.draw();
  }

  /** Events reach this before the view's own listeners. */
  use(view) {
    this.view = view;
    const on = (type, call) => view.frame.addEventListener(type, (event) => {
      if (this.tool === "move" || event.target !== view.canvas) return;
      call(event);
      event.stopPropagation();
    }, true);
    on("pointerdown", (event) => {
      view.canvas.setPointerCapture(event.pointerId);
      this.apply(this.cellAt(event));
    });
    on("pointermove", (event) => {
      view.onHover(...view.place(...view.own(event)));
      if (this.last) this.apply(this.cellAt(event));
    });
    for (const end of ["pointerup", "pointercancel"]) on(end, () => (this.last = null));
    on("keydown", (event) => this.key(event));
    this.choose(this.tool);
  }

  cellAt(event) {
    return this.view.place(...this.view.own(event)).map(Math.floor);
  }

  inside([x, y]) {
    const { width, height } = this.size();
    return x >= 0 && y >= 0 && x < width && y < height;
  }

  apply(cell) {
    if (this.tool === "start" || this.tool === "goal") {
      if (!this.inside(cell)) return;
      (this.tool === "start" ? this.onStart : this.onGoal)({ x: cell[0], y: cell[1] });
    } else {
      const reach = (Number(this.brush.value) - 1) / 2, cells = new Map();
      for (const [x, y] of cellsBetween(this.last ?? cell, cell))
        for (let dy = -reach; dy <= reach; ++dy)
          for (let dx = -reach; dx <= reach; ++dx)
            if (dx * dx + dy * dy <= reach * reach + 1 && this.inside([x + dx, y + dy])) cells.set(`${x + dx},${y + dy}`, [x + dx, y + dy]);
      this.onCells([...cells.values()], this.tool === "wall");
    }
    this.last = cell;
  }

  key(event) {
    const far = event.shiftKey ? 10 : 1, { width, height } = this.size();
    const moves = { ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far] };
    this.cursor ??= { x: width >> 1, y: height >> 1 };
    if (event.key in moves) {
      const [dx, dy] = moves[event.key];
      this.cursor = { x: Math.min(Math.max(this.cursor.x + dx, 0), width - 1), y: Math.min(Math.max(this.cursor.y + dy, 0), height - 1) };
    } else if (event.key === "Enter" || event.key === " ") {
      this.apply([this.cursor.x, this.cursor.y]);
      this.last = null;
    } else return;
    event.preventDefault();
    this.view.onHover(this.cursor.x + 0.5, this.cursor.y + 0.5);
    this.view.draw();
  }
}
