// Shows the content of the page.

import { showBitmap } from "./bitmap_page.js";

const kViews = { bitmap: showBitmap };

async function main() {
  const content = JSON.parse(document.getElementById("content").textContent);
  await kViews[content.kind](content);
  document.documentElement.dataset.ready = String(Math.round(performance.now()));
}

main();
