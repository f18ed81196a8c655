// The command that gives the same run.
//
//   commandOf(map, run)   map.source: {kind: "generated", wish}, {kind: "file", name} or
//                         {kind: "drawn"}; run: {algorithm, preset, seed, values, start, goal, radius}, where
//                         values are those that are not the preset's

function quoted(word) {
  return /^[\w.,:=/+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

export function mapFileOf({ source }) {
  return source.kind === "file" ? source.name : "playground.map";
}

function generateWords({ kind, width, height, density, seed }, file) {
  const words = ["lasius", "generate", kind, "--size", `${width}x${height}`, "--seed", String(seed)];
  if (density >= 0) words.push("--density", String(density));
  return [...words, "-o", file];
}

export function commandOf(map, { algorithm, preset, seed, values, start, goal, radius }) {
  const file = mapFileOf(map), lines = [];
  if (map.source.kind === "generated") lines.push(generateWords(map.source.wish, file));
  const words = ["lasius", "plan", file, "--start", `${start.x},${start.y}`, "--goal", `${goal.x},${goal.y}`,
                 "--algorithm", algorithm];
  if (preset !== "usual") words.push("--preset", preset);
  if (radius > 0) words.push("--radius", String(radius));
  words.push("--seed", String(seed));
  for (const [name, value] of Object.entries(values)) words.push("--set", `${name}=${value}`);
  lines.push(words);
  return lines.map((line) => line.map(quoted).join(" ")).join(" &&\n");
}
