// The worker: the module of lasius_wasm.js, which stands before this text, asked by messages.
//
//   <- {module}                    a WebAssembly.Module; answered by {ready}
//   <- {id, name, words}           a call of tools/playground/binding.cpp; -> {id, answer}
//   <- {id, map, question, most}  a plan; -> {id, frame} by iteration, then {id, answer}

let lasius, world, worldMap, worldRadius;

function instantiateWith(module) {
  return (imports, done) => {
    WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
    return {};
  };
}

/** The map's world for a disc; the last one is kept. */
function worldOf(map, radius = worldRadius ?? 0) {
  if (worldMap?.number !== map.number || worldRadius !== radius) {
    world?.delete();
    world = new lasius.World(map.width, map.height, map.cells, radius);
    [worldMap, worldRadius] = [map, radius];
  }
  return world;
}

function plan({ id, map, question, most }) {
  const watch = (frame) =>
    postMessage({ id, frame }, [frame.path.buffer, frame.trail.buffer, frame.tracks.buffer]);
  const begin = performance.now();
  const answer = worldOf(map, question.radius).plan(question, most > 0 ? watch : null, most);
  return { ...answer, elapsed_ms: performance.now() - begin };
}

function answerTo(message) {
  if (message.question) return plan(message);
  if (message.name === "text") return worldOf(message.map).text();
  return lasius[message.name](...(message.words ?? []));
}

onmessage = async ({ data }) => {
  if (data.module) {
    lasius = await makeLasius({ instantiateWasm: instantiateWith(data.module) });
    return postMessage({ ready: true });
  }
  try {
    postMessage({ id: data.id, answer: answerTo(data) });
  } catch (error) {
    postMessage({ id: data.id, answer: { error: `the library failed: ${error.message ?? error}` } });
  }
};
