// browse.mjs PAGE.html DAPPLE FOLDER: the page in Chromium without a screen. What it saves is compared with the program's
// drawing of the project that it saves; pictures of it are left in the folder. Prints how long things took.
import {execFileSync} from "node:child_process";
import {copyFileSync, readFileSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";
import {deflateSync} from "node:zlib";

const [page_file, dapple, folder] = process.argv.slice(2);
const {chromium} = createRequire(resolve(folder, "x"))("playwright-core");
const url = pathToFileURL(resolve(page_file)).href;
const launched = (...args) => chromium.launch({executablePath: "/usr/bin/chromium", args: ["--no-sandbox", ...args]});
const browser = await launched("--use-angle=swiftshader", "--enable-unsafe-swiftshader");
const PATIENCE = 300_000;  // milliseconds: nothing here is about speed, and a busy machine takes its time
let failed = 0;
function check(right, sentence) {
    console.log(`${right ? "right" : "WRONG"}: ${sentence}`);
    failed += !right;
}
const requests = [];
async function opened({hash = "", by = browser, before, ...look} = {}) {
    const page = await by.newPage({viewport: {width: 1280, height: 800}, ...look});
    page.setDefaultTimeout(PATIENCE);
    if (before) await page.addInitScript(before);
    page.on("pageerror", (error) => check(false, `no error: ${error.message}`));
    page.on("request", (request) => requests.push(request.url()));
    await page.goto(url + hash);
    await settled(page);
    return page;
}
const settled = (page) => page.waitForFunction(() => {
    const [work, message, count] = ["work", "message", "count"].map((id) => document.getElementById(id).textContent);
    return message || (count && work === "");
}, null, {timeout: PATIENCE});
const text = (page, id) => page.textContent(`#${id}`);
async function saved(page, button, name) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`#${button}`)]);
    const file = `${folder}/${name ?? download.suggestedFilename()}`;
    await download.saveAs(file);
    return file;
}
const shot = (page, name) => page.screenshot({path: `${folder}/${name}.png`});
// Waits until it is seen.
async function seen(what, sentence) {
    for (const end = Date.now() + PATIENCE; Date.now() < end;) {
        if (await what()) return check(true, sentence);
        await new Promise((resolve) => setTimeout(resolve, 50));
    }
    check(false, sentence);
}
// Of the canvas as it is on screen: where its page begins in the middle row, and its mean light, 0 to 255.
async function onScreen(page) {
    const png = (await page.screenshot({clip: await page.locator("#view").boundingBox()})).toString("base64");
    return page.evaluate(async (png) => {
        const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (c) => c.charCodeAt(0))]));
        const {width, height} = bitmap, context = new OffscreenCanvas(width, height).getContext("2d");
        context.drawImage(bitmap, 0, 0);
        const {data} = context.getImageData(0, 0, width, height), row = 4 * width * Math.floor(height / 2);
        let left = 0, sum = 0;
        while (left < width && Math.abs(data[row + 4 * left] - data[row]) < 5) ++left;
        for (let i = 0; i < data.length; i += 4) sum += data[i];
        return {left, light: sum / (width * height)};
    }, png);
}

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
        seen.links = [];
        const replace = history.replaceState.bind(history);
        history.replaceState = (...args) => { seen.links.push(performance.now()); replace(...args); };
    });
    await page.mouse.move(box.x + box.width * 0.6, box.y + box.height / 2);
    await page.mouse.down();
    let moves = 0;
    await seen(async () => {
        for (let i = 0; i <= 60; ++i, ++moves) {
            await page.mouse.move(box.x + box.width * (0.6 - 0.1 * Math.sin(moves / 10)), box.y + box.height / 2);
            await page.waitForTimeout(16);
        }
        return page.evaluate(() => seen.counts.size > 3);
    }, "dots follow the slider while it is dragged");
    await page.mouse.up();
    const {frames, counts} = await page.evaluate(() => {
        cancelAnimationFrame(seen.next);
        return {frames: seen.frames, counts: seen.counts.size};
    });
    const gaps = frames.slice(1).map((at, i) => at - frames[i]).sort((a, b) => a - b);
    const part = (share) => gaps[Math.floor(share * (gaps.length - 1))].toFixed(0);
    console.log(`dragging: ${frames.length} frames, half of them within ${part(0.5)} ms, 95 % within ${part(0.95)} ms; ${counts} drawings seen`);
    await settled(page);
    const links = await page.evaluate(() => seen.links);
    check(links.length > 0 && links.every((at, i) => !i || at - links[i - 1] > 100), "the link is written when the hand rests");

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
    for (const [typed, count] of [["2M", 2e6], ["1,500", 1500], ["1.5k", 1500], ["15e2", 1500], ["0.012M", 12000]]) {
        await page.getByLabel("Dots, typed").fill(typed);
        await page.keyboard.press("Enter");
        await page.waitForFunction((count) => document.getElementById("count").textContent === count, `${count.toLocaleString("en")} dots`);
        check(true, `${typed} is read as the program reads it`);
    }
    await settled(page);
    for (const typed of ["3M", "1e9", "2,5", "0", "-5", "10.000", "1.5", "40 thousand", "1,00", "12kk", "."]) {
        await page.getByLabel("Dots, typed").fill(typed);
        await page.keyboard.press("Enter");
        check((await text(page, "message")) === `Dots: ${typed} is not possible; give a whole number from 1 to 2,000,000.` &&
              (await text(page, "count")) === "12,000 dots", `${typed} is refused`);
    }
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
    const wrong = await opened({hash: "#" + encodeURIComponent('{"drawing": {"count": 0}}')});
    check((await text(wrong, "message")).startsWith("The link's settings are not right: settings: drawing.count is 0"), "a wrong link is refused");
    await wrong.waitForFunction(() => document.getElementById("count").textContent === "40,000 dots");
    check((await text(wrong, "message")) !== "", "the message stays while the still life is drawn");
    await wrong.getByLabel("Dots, typed").fill("12k");
    await wrong.keyboard.press("Enter");
    await wrong.waitForFunction(() => document.getElementById("count").textContent === "12,000 dots");
    check((await text(wrong, "message")) === "", "a change takes the message away");
    await wrong.close();
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
// A picture by ImageMagick.
const picture = (name, ...how) => (execFileSync("convert", [...how, `${folder}/${name}`]), `${folder}/${name}`);
// A chunk of a PNG.
function chunk(kind, data) {
    const named = Buffer.concat([Buffer.from(kind), data]), ends = Buffer.alloc(8);
    let crc = ~0;
    for (const byte of named) {
        crc ^= byte;
        for (let bit = 0; bit < 8; ++bit) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
    }
    ends.writeUInt32BE(data.length);
    ends.writeUInt32BE(~crc >>> 0, 4);
    return Buffer.concat([ends.subarray(0, 4), named, ends.subarray(4)]);
}
// Once its drawing, or why there is none, is there.
async function opens(page, file) {
    await page.setInputFiles("#file", file);
    await page.waitForFunction((name) => document.getElementById("name").textContent === name, file.split("/").at(-1));
    await settled(page);
}
{
    // Nothing is shown or saved but what the heading names.
    const page = await opened({before: () => {
        const real = window.createImageBitmap.bind(window);
        window.createImageBitmap = async (...given) => {
            if (window.held) await window.held.splice(0)[0];
            return real(...given);
        };
    }});
    let downloads = 0;
    page.on("download", () => ++downloads);
    await opens(page, picture("white.png", "-size", "60x40", "xc:white"));
    check((await text(page, "message")).startsWith("there is nothing to draw"), "a white picture's sentence is said");
    check((await text(page, "count")) === "no dots" && (await text(page, "page")) === "", "a white picture has no dots");
    const blank = (await onScreen(page)).light;
    await page.click("#svg");
    await page.waitForFunction(() => document.getElementById("message").textContent.startsWith("Nothing was saved: there is nothing to draw"));
    check(downloads === 0, "nothing is saved of a white picture");
    await opens(page, picture("grey.png", "-size", "60x40", "xc:gray40"));
    check((await text(page, "message")) === "" && (await text(page, "count")) === "40,000 dots" && (await onScreen(page)).light < blank - 20,
          "the next picture is drawn where a white one left the page bare");

    await page.evaluate(() => { window.held = [new Promise((resolve) => { window.release = resolve; })]; });
    await page.setInputFiles("#file", picture("early.png", "-size", "30x30", "xc:gray20"));
    await page.waitForFunction(() => window.held.length === 0);
    await opens(page, picture("late.png", "-size", "60x20", "xc:gray60"));
    await page.evaluate(() => window.release());
    await opens(page, picture("late2.png", "-size", "60x20", "xc:gray60"));
    check((await text(page, "page")) === "200 x 67 mm", "of two pictures that are dropped one after the other the later one stays");
    await page.close();

    const many = await opened({hash: "#" + encodeURIComponent('{"drawing": {"count": 100000000}}')});
    check(/ask for 100000000 dots, and this page draws 2000000 at most/.test(await text(many, "message")) && (await text(many, "count")) === "no dots",
          "a link with too many dots is told so");
    await many.getByLabel("Dots, typed").fill("12k");
    await many.keyboard.press("Enter");
    await many.waitForFunction(() => document.getElementById("count").textContent === "12,000 dots");
    await many.close();
}
{
    // Pictures that a canvas does not hold, or not as they are.
    const page = await opened({hash: "#" + encodeURIComponent(JSON.stringify({drawing: {count: 3000}}))});
    const about = () => text(page, "about");
    // ImageMagick makes none so high.
    const tall = Buffer.alloc(401 * 70000);
    for (let y = 0; y < 70000; ++y) tall.fill(y % 2000 / 8, 401 * y + 1, 401 * (y + 1));
    const header = Buffer.from([0, 0, 1, 144, 0, 1, 17, 112, 8, 0, 0, 0, 0]);
    writeFileSync(`${folder}/tall.png`, Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", header),
                                                      chunk("IDAT", deflateSync(tall)), chunk("IEND", Buffer.alloc(0))]));
    await opens(page, `${folder}/tall.png`);
    check((await about()) === "400 x 70000 pixels, read as 94 x 16384" && (await text(page, "count")) === "3,000 dots", `a picture over the limit is read smaller: ${await about()}`);
    await opens(page, picture("deep.png", "-size", "64x64", "gradient:black-white", "-depth", "16", "-define", "png:bit-depth=16"));
    check((await about()) === "64 x 64 pixels, read with 8 of their 16 bits", "16 bits are told");
    const whole = readFileSync("assets/still_life.png");
    writeFileSync(`${folder}/half.png`, whole.subarray(0, whole.length / 2));
    await page.setInputFiles("#file", `${folder}/half.png`);
    await page.waitForFunction(() => document.getElementById("message").textContent === "half.png is damaged.");
    check((await text(page, "name")) === "deep.png", "a damaged picture is called damaged, and the one before stays");

    // What is transparent is paper: beside the program, by how many dots each part has.
    const ramp = ["-size", "60x60", "gradient:gray10-gray90"];
    const see_through = ["(", ...ramp, ")", "(", "-size", "30x60", "xc:black", "xc:white", "+append", ")", "-alpha", "off", "-compose", "CopyOpacity", "-composite"];
    const half = ["(", ...ramp, ")", "(", "-size", "30x60", "xc:gray50", "xc:white", "+append", ")", "-alpha", "off", "-compose", "CopyOpacity", "-composite"];
    for (const [name, ...how] of [["colours.png", ...see_through, "-define", "png:color-type=6"], ["greys.png", ...see_through, "-define", "png:color-type=4"],
                                  ["half.png", ...half, "-define", "png:color-type=4"], ["one.gif", ...see_through],
                                  ["one.webp", ...see_through, "-define", "webp:lossless=true"],
                                  ["key.png", "-size", "30x60", "xc:black", "gradient:gray20-gray90", "+append", "-transparent", "black", "-define", "png:color-type=2"]]) {
        const file = picture(name, ...how);
        await opens(page, file);
        const theirs = `${folder}/${name}.svg`;
        execFileSync(dapple, ["render", file, "-o", theirs, "--dots", "3000"], {stdio: "ignore"});
        const parts = [await saved(page, "svg"), theirs].map((svg) => {
            const counts = [0, 0, 0, 0, 0, 0];
            for (const [, x, y] of readFileSync(svg, "utf8").matchAll(/cx="([\d.]+)" cy="([\d.]+)"/g))
                ++counts[(x * 25.4 / 96 < 100 ? 0 : 3) + Math.min(Math.floor(y * 25.4 / 96 / 67), 2)];
            return counts;
        });
        check(parts[1].some((each) => each > 0) && parts[0].every((each, i) => Math.abs(each - parts[1][i]) <= 15), `${name} has its dots where the program has them: ${parts[0]}, ${parts[1]}`);
    }
    await page.close();
}
{
    // The worker that places dots, which is the first one, comes late with an older drawing: it does not show any more.
    const page = await opened({before: () => {
        window.Worker = class extends Worker {
            constructor(script) {
                super(script);
                window.placing ??= this;
            }
            postMessage(message) {
                const send = () => super.postMessage(message);
                this === window.placing && window.held && message.ask === "draw" ? window.held.push(send) : send();
            }
        };
    }});
    await page.evaluate(() => { window.held = []; });
    await page.getByLabel("Dots", {exact: true}).focus();
    for (let i = 0; i < 2; ++i) await page.keyboard.press("ArrowRight");
    await settled(page);
    const count = await text(page, "count");
    await page.evaluate(() => window.held.pop()());
    await page.waitForFunction(() => window.held.length === 1);
    check(await text(page, "count") === count && await text(page, "work") === "", "the newest drawing stays when an older one comes late");
    await page.close();
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
{
    // One tile beside another, and what they repeat.
    const page = await opened({hash: "#" + encodeURIComponent(JSON.stringify({drawing: {relax: 0, count: 30000}}))});
    await page.getByLabel("Split view", {exact: true}).check();
    await page.getByLabel("Spectrum", {exact: true}).check();
    const captions = () => page.locator("figcaption").allTextContents();
    await seen(async () => (await captions()).length === 2, "both sides have a spectrum");
    const numbers = (await captions()).map((text) => Number(/^(?:kinds4096|best32): periodicity (.*)$/.exec(text)?.[1]));
    check(numbers[0] < 0.1 && numbers[1] > 0.5, `one tile repeats, eight do not: ${await captions()}`);
    await page.locator("#spectra").scrollIntoViewIfNeeded();
    await shot(page, "spectrum");
    await page.close();
}
{
    // Fingers.
    const page = await opened({hasTouch: true});
    const cdp = await page.context().newCDPSession(page);
    const touch = (type, ...points) => cdp.send("Input.dispatchTouchEvent", {type, touchPoints: points.map(([x, y], id) => ({x, y, id}))});
    const {left} = await onScreen(page);
    await touch("touchStart", [400, 400]);
    for (let x = 400; x <= 460; x += 10) await touch("touchMove", [x, 400]);
    await touch("touchEnd");
    await seen(async () => Math.abs((await onScreen(page)).left - left - 60) <= 1, "a finger moves the page");
    const zoom = async () => parseInt(await text(page, "zoom"));
    const before = await zoom();
    await touch("touchStart", [380, 400], [480, 400]);
    for (let by = 0; by <= 50; by += 10) await touch("touchMove", [380 - by, 400], [480 + by, 400]);
    await touch("touchEnd");
    await seen(async () => Math.abs(await zoom() - 2 * before) <= 2, `two fingers zoom: from ${before} % to twice as much`);

    // On a slider a finger scrolls up and down, and moves it to the sides, or where it taps.
    const count = () => text(page, "count");
    const {x, y, width, height} = await page.getByLabel("Dots", {exact: true}).boundingBox(), middle = y + height / 2;
    const finger = async (...points) => {
        await touch("touchStart", points[0]);
        for (const point of points.slice(1)) await touch("touchMove", point);
        await touch("touchEnd");
    };
    const down = [...Array(12)].map((_, i) => [x + 0.2 * width + i, middle - 14 * i]);
    await finger(...down);
    await seen(() => page.evaluate(() => document.getElementById("rows").scrollTop > 50), "a swipe that begins on a slider scrolls");
    await settled(page);
    check((await count()) === "40,000 dots", `and leaves the slider alone: ${await count()}`);
    // The panel scrolls on for a while after a swipe; while it does, a finger stops it and moves nothing.
    await seen(() => page.evaluate(() => new Promise((told) => {
        const rows = document.getElementById("rows");
        rows.scrollTop = 0;
        requestAnimationFrame(() => requestAnimationFrame(() => told(rows.scrollTop === 0)));
    })), "the panel is back where it was");
    await finger(...[...Array(8)].map((_, i) => [x + width * (0.5 - 0.04 * i), middle + i]));
    await seen(async () => (await count()) !== "40,000 dots", "a swipe to the side moves it");
    await settled(page);
    const swiped = await count();
    await finger([x + 0.7 * width, middle]);
    await seen(async () => (await count()) !== swiped, "a tap too");
    await page.close();
}
{
    // Without WebGL.
    const plain = await launched("--disable-3d-apis");
    const pages = [await opened(), await opened({by: plain})];
    check(await pages[1].evaluate(() => !document.createElement("canvas").getContext("webgl2")), "there is no WebGL");
    const lights = [];
    for (const page of pages) lights.push((await onScreen(page)).light);
    // Dots' edges, which it does not blend in linear light, come out darker.
    check(Math.abs(lights[0] - lights[1]) < 20, `a plain canvas shows the same: mean light ${lights.map((light) => light.toFixed(1))}`);
    await shot(pages[1], "plain");
    for (const page of pages) await page.close();
    await plain.close();
}
check(requests.every((each) => /^(file|blob|data):/.test(each)), "nothing is sent anywhere");
await browser.close();
process.exit(failed ? 1 : 0);
