// Points along a polyline.
//
//   cumulated(points)             -> Float64Array: length up to each point, in the plane or in space
//   nearestOn(points, sums, x, y) -> {distance, at: [x, y], length, segment, part} of the nearest point,
//                                    `part` of the way along its segment

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
