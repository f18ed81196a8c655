// Arrays as a page holds them: zlib streams in base64.
//
//   await unpacked(text)            -> Uint8Array
//   await numbersOf(text)           -> Float32Array (little-endian in the stream)
//   framesOf(bytes, size)           -> [Uint8Array]: each frame of `size` bytes is stored as the
//                                      difference to the one before, modulo 256; undone in place

export async function unpacked(text) {
  const letters = atob(text), packed = new Uint8Array(letters.length);
  for (let i = 0; i < packed.length; ++i) packed[i] = letters.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function numbersOf(text) {
  return new Float32Array((await unpacked(text)).buffer);
}

export function framesOf(bytes, size) {
  for (let i = size; i < bytes.length; ++i) bytes[i] += bytes[i - size];
  const frames = [];
  for (let at = 0; at + size <= bytes.length; at += size) frames.push(bytes.subarray(at, at + size));
  return frames;
}
