// browse.mjs PAGE.html DAPPLE FOLDER: the page in Chromium without a screen. What it saves is compared with the program's
// drawing of the project that it saves; pictures of it are left in the folder. Prints how long things took.
import {execFileSync} from "node:child_process";
import {copyFileSync, readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";

const [page_file, dapple, folder] = process.argv.slice(2);
const {chromium} = createRequire(resolve(folder, "x"))("playwright-core");
const url = pathToFileURL(resolve(page_file)).href;
const browser = await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
let failed = 0;
function check(right, sentence) {
    console.log(`${right ? "right" : "WRONG"}: ${sentence}`);
    failed += !right;
}
const requests = [];
async function opened({hash = "", ...look} = {}) {
    const page = await browser.newPage({viewport: {width: 1280, height: 800}, ...look});
    page.on("pageerror", (error) => check(false, `no error: ${error.message}`));
    page.on("request", (request) => requests.push(request.url()));
    await page.goto(url + hash);
    await settled(page);
    return page;
}
const settled = (page) => page.waitForFunction(() => {
    const [work, message, count] = ["work", "message", "count"].map((id) => document.getElementById(id).textContent);
    return message || (count && work === "");
}, null, {timeout: 120_000});
const text = (page, id) => page.textContent(`#${id}`);
async function saved(page, button, name) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#${button}`)]);
    const file = `${folder}/${name ?? download.suggestedFilename()}`;
    await download.saveAs(file);
    return file;
}
const shot = (page, name) => page.screenshot({path: `${folder}/${name}.png`});

{
    const page = await opened();
    check((await text(page, "message")) === "", "no message");
    check((await text(page, "count")) === "40,000 dots", "the still life has 40,000 dots");
    const first = await page.evaluate(() => performance.getEntriesByName("first dots")[0].startTime);
    console.log(`first dots after ${Math.round(first)} ms`);
    await shot(page, "wide");

    // A picture that every program decodes alike, and a slider dragged.
    await page.setInputFiles("#file", "assets/still_life.png");
    await page.waitForFunction(() => document.getElementById("about").textContent.startsWith("1024"));
    await settled(page);
    const slider = page.getByLabel("Dots", {exact: true});
    const box = await slider.boundingBox();
    await page.evaluate(() => {
        const seen = window.seen = {frames: [], counts: new Set()};
        const note = (now) => {
            seen.frames.push(now);
            seen.counts.add(document.getElementById("count").textContent);
            seen.next = requestAnimationFrame(note);
        };
        note(performance.now());
    });
    await page.mouse.move(box.x + box.width * 0.6, box.y + box.height / 2);
    await page.mouse.down();
    for (let i = 0; i <= 60; ++i) {
        await page.mouse.move(box.x + box.width * (0.6 - 0.1 * Math.sin(i / 10)), box.y + box.height / 2);
        await page.waitForTimeout(16);
    }
    await page.mouse.up();
    const {frames, counts} = await page.evaluate(() => {
        cancelAnimationFrame(seen.next);
        return {frames: seen.frames, counts: seen.counts.size};
    });
    const gaps = frames.slice(1).map((at, i) => at - frames[i]).sort((a, b) => a - b);
    const part = (share) => gaps[Math.floor(share * (gaps.length - 1))].toFixed(0);
    console.log(`dragging: ${frames.length} frames, half of them within ${part(0.5)} ms, 95 % within ${part(0.95)} ms; ${counts} drawings seen`);
    check(counts > 3, "dots follow the slider while it is dragged");
    await settled(page);

    // Keys and a typed value.
    await slider.focus();
    const before = await text(page, "count");
    await page.keyboard.press("ArrowRight");
    await settled(page);
    check((await text(page, "count")) !== before, "an arrow key moves a slider");
    await page.getByLabel("Dots, typed").fill("12k");
    await page.keyboard.press("Enter");
    await settled(page);
    check((await text(page, "count")) === "12,000 dots", "12k is typed");
    check((await text(page, "said")) === "12,000 dots on 200 x 200 mm", "the count is said aloud");
    await page.getByLabel("Contrast", {exact: true}).focus();
    await page.keyboard.press("ArrowRight");
    await settled(page);

    // What goes out.
    copyFileSync("assets/still_life.png", `${folder}/still_life.png`);
    const svg = await saved(page, "svg"), project = await saved(page, "project");
    const native = `${folder}/native.svg`;
    execFileSync(dapple, ["render", project, "-o", native], {stdio: "ignore"});
    check(readFileSync(svg, "utf8") === readFileSync(native, "utf8"), "the program draws the page's project as the page does");
    const png = await saved(page, "png", "saved.png");
    execFileSync(dapple, ["render", project, "-o", `${folder}/native.png`], {stdio: "ignore"});
    const differ = execFileSync("sh", ["-c", `compare -metric AE "$0" "$1" null: 2>&1 || true`, png, `${folder}/native.png`]).toString();
    check(parseInt(differ) === 0, `the pixels too: ${differ} differ`);

    const link = new URL(page.url()).hash;
    await page.close();
    const other = await opened({hash: link});
    check((await text(other, "count")) === "12,000 dots", "a link carries the settings");
    await other.setInputFiles("#file", {name: "mine.dapple", mimeType: "", buffer: Buffer.from('{"dapple": 1, "drawing": {"count": 0}}')});
    await other.waitForFunction(() => document.getElementById("message").textContent);
    check((await text(other, "message")).startsWith("settings: drawing.count is 0"), "a wrong project is refused by the library's sentence");
    await other.setInputFiles("#file", {name: "mine.txt", mimeType: "", buffer: Buffer.from("no picture")});
    await other.waitForFunction(() => document.getElementById("message").textContent.startsWith("mine.txt"));
    check(true, "what is no picture is refused by name");
    await other.close();
}
for (const [name, look] of Object.entries({
    narrow: {viewport: {width: 400, height: 800}},
    dark: {colorScheme: "dark", hash: "#" + encodeURIComponent(JSON.stringify({drawing: {pens: "cmyk", count: 20000}}))},
    contrast: {contrast: "more", hash: "#" + encodeURIComponent(JSON.stringify({drawing: {tone: {invert: true}, ink: "#ffffff", paper: "#000000"}}))},
})) {
    const page = await opened(look);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    check(wide <= (look.viewport?.width ?? 1280), `${name}: nothing is cut off`);
    await shot(page, name);
    await page.close();
}
check(requests.every((each) => /^(file|blob|data):/.test(each)), "nothing is sent anywhere");
await browser.close();
process.exit(failed ? 1 : 0);
