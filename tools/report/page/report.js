// Shows the content of the page.

import { showArm } from "./arm_page.js";
import { showBitmap } from "./bitmap_page.js";
import { showDrive } from "./drive_page.js";
import { showPolygon } from "./polygon_page.js";
import { showStudy } from "./study_page.js";
import { showTour } from "./tour_page.js";
import { showVehicle } from "./vehicle_page.js";

const kViews = { arm: showArm, bitmap: showBitmap, drive: showDrive, polygon: showPolygon, study: showStudy, tour: showTour,
                 vehicle: showVehicle };

async function main() {
  const content = JSON.parse(document.getElementById("content").textContent);
  const told = document.documentElement.dataset, rest = await kViews[content.kind](content);
  told.ready = String(Math.round(performance.now()));
  await rest?.();  // what is far below
  told.whole = "yes";
}

main();
