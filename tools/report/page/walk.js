// Points along a polyline, and along a disc's curve.
//
//   arcAngles(curve, i)           -> [from, to] of the arc that is entry i, between two points
//   pointsOf(curve)               -> the points of a curve, its arcs as many short chords
//   cumulated(points)             -> Float64Array: length up to each point, in the plane or in space
//   nearestOn(points, sums, x, y) -> {distance, at: [x, y], length, segment, part} of the nearest point,
//                                    `part` of the way along its segment

export function arcAngles(curve, i) {
  const { centre: [x, y], turn } = curve[i], round = 2 * Math.PI;
  const [from, to] = [curve[i - 1], curve[i + 1]].map((end) => Math.atan2(end[1] - y, end[0] - x));
  const angle = ((turn * (to - from)) % round + round) % round;
  return [from, from + turn * (angle > Math.PI ? 0 : angle)];  // at most a quarter, or less than nothing by rounding
}

export function pointsOf(curve) {
  return curve.flatMap((entry, i) => {
    if (Array.isArray(entry)) return [entry];
    const { centre, radius } = entry, [from, to] = arcAngles(curve, i), angle = to - from, count = Math.ceil(64 * Math.abs(angle));
    return Array.from({ length: Math.max(0, count - 1) }, (_, k) => {
      const at = from + (angle * (k + 1)) / count;
      return [centre[0] + radius * Math.cos(at), centre[1] + radius * Math.sin(at)];
    });
  });
}

export function cumulated(points) {
  const sums = new Float64Array(points.length);
  for (let i = 1; i < points.length; ++i)
    sums[i] = sums[i - 1] + Math.hypot(...Array.from(points[i], (value, axis) => value - points[i - 1][axis]));
  return sums;
}

export function nearestOn(points, sums, x, y) {
  let best = { distance: Infinity, at: null, length: 0, segment: 0, part: 0 };
  const offer = (at, length, segment, part) => {
    const distance = Math.hypot(at[0] - x, at[1] - y);
    if (distance < best.distance) best = { distance, at, length, segment, part };
  };
  if (points.length === 1) offer(points[0], 0, 0, 0);
  for (let i = 1; i < points.length; ++i) {
    const [ax, ay] = points[i - 1], dx = points[i][0] - ax, dy = points[i][1] - ay;
    const square = dx * dx + dy * dy;
    const t = square > 0 ? Math.min(Math.max(((x - ax) * dx + (y - ay) * dy) / square, 0), 1) : 0;
    offer([ax + t * dx, ay + t * dy], sums[i - 1] + t * Math.sqrt(square), i - 1, t);
  }
  return best;
}
