// Shows the content of the page.

import { showArm } from "./arm_page.js";
import { showBitmap } from "./bitmap_page.js";
import { showDrive } from "./drive_page.js";
import { showPolygon } from "./polygon_page.js";
import { showStudy } from "./study_page.js";

const kViews = { arm: showArm, bitmap: showBitmap, drive: showDrive, polygon: showPolygon, study: showStudy };

async function main() {
  const content = JSON.parse(document.getElementById("content").textContent);
  await kViews[content.kind](content);
  document.documentElement.dataset.ready = String(Math.round(performance.now()));
}

main();
