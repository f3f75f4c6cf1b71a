// compare.mjs ENGINE.wasm DAPPLE DAPPLE-LAB FOLDER [SEED]: whether the engine's tables and drawings are the program's, byte for byte, also
// with settings at random, others for each seed.
import {execFileSync} from "node:child_process";
import {readFileSync, writeFileSync} from "node:fs";
import {startEngine} from "../engine.mjs";

const [wasm, dapple, lab, folder, seed = "1"] = process.argv.slice(2);
const engine = await startEngine(new WebAssembly.Module(readFileSync(wasm)));

// A picture's bytes as a file that needs no decoder worth the name.
function written(name, {pixels, width, height}) {
    const rgb = Buffer.alloc(3 * width * height);
    for (let i = 0; i < width * height; ++i) rgb.set(pixels.subarray(4 * i, 4 * i + 3), 3 * i);
    const file = `${folder}/${name}.ppm`;
    writeFileSync(file, Buffer.concat([Buffer.from(`P6 ${width} ${height} 255\n`), rgb]));
    return file;
}
function painted(width, height, colour) {
    const pixels = new Uint8Array(4 * width * height).fill(255);
    for (let y = 0, i = 0; y < height; ++y)
        for (let x = 0; x < width; ++x, i += 4) pixels.set(colour(x, y).map((c) => Math.min(Math.max(c, 0), 255)), i);
    return {pixels, width, height};
}
const ball = (x, y) => {
    const height = Math.sqrt(Math.max(0, 1 - ((x - 150) / 120) ** 2 - ((y - 110) / 100) ** 2));
    return height ? [255 * height, 200 * height + x / 8, 90 + 150 * height] : [230, 228, 40 + y];
};
const pictures = {
    ramp: painted(256, 100, (x) => [x, x, x]),
    ball: painted(300, 220, ball),
    grain: painted(97, 181, (x, y) => Array(3).fill(((x * 7919 + y * 104729) % 251 + x) / 1.4)),
    board: painted(160, 120, (x, y) => ((x >> 4) + (y >> 4)) % 2 ? [40, 60, 220] : [250, 240, 200]),
    rings: painted(200, 200, (x, y) => [0, 2, 4].map((turn) => 128 + 120 * Math.sin(Math.hypot(x - 60, y - 90) / 9 + turn))),
};
const cases = [
    ["ramp", {}, []],
    ["ball", {drawing: {count: 3000, relax: 0}}, ["--dots", "3000", "--relax", "0"]],
    ["ball", {drawing: {count: 12000, pens: "cmyk"}}, ["--dots", "12000", "--pens", "cmyk"]],
    ["grain", {drawing: {dot_size: {sizing: "by_tone", smallest_mm: 0.2, largest_mm: 0.6}, page: {paper: "A5"}}},
     ["--dot-radius", "0.2..0.6", "--page", "a5"]],
    ["ball", {drawing: {count: 8000, automatic_tone: false, tone: {contrast: 0.3, brightness: -0.1, detail: 0.8, invert: true},
                        tile: "best32", page: {width_mm: 120}}},
     ["--dots", "8000", "--tone", "true", "--contrast", "0.3", "--brightness", "-0.1", "--detail", "0.8", "--invert", "--tile", "best32",
      "--width", "120"]],
    ["grain", {drawing: {count: 6000, pens: "auto:3", tone: {black: 0.9}}}, ["--dots", "6000", "--pens", "auto:3", "--black", "0.9"]],
    // Many of Figure 8's dots are as far from each other: C++ libraries order them as they like.
    ["ramp", {drawing: {count: 5000, relax: 0, placer: "figure8", style: "line"}}, ["--dots", "5000", "--relax", "0", "--placer", "figure8",
                                                                                   "--style", "line"]],
];

let failed = 0;
for (const [number, [name, settings, options]] of cases.entries()) {
    engine.setPicture(pictures[name]);
    const drawn = engine.draw(settings);
    const file = written(name, pictures[name]);
    // Several pens' tables differ in the last digits of some dots, and tables have no lines.
    for (const format of settings.drawing?.pens || settings.drawing?.style ? ["svg"] : ["csv", "svg"]) {
        const theirs = `${folder}/${number}.${format}`;
        execFileSync(dapple, ["render", file, "-o", theirs, ...options], {stdio: "ignore"});
        const same = readFileSync(theirs, "utf8") === engine.file(format);
        if (!same) writeFileSync(`${folder}/${number}-here.${format}`, engine.file(format));
        failed += !same;
        console.log(`${same ? "same" : "NOT THE SAME"}: ${drawn.dots} dots of ${name}.${format} ${options.join(" ")}`);
    }
}

// Settings at random, of all rows that have a range or a choice; small drawings, as there are many. What one refuses, the
// other does, too, but for a tile that the page leaves out.
let state = Number(seed);
const random = (most = 1) => ((state = (Math.imul(state, 1103515245) + 12345) >>> 0) >>> 8) / 2 ** 24 * most;
const one_of = (list) => list[Math.floor(random(list.length))];
const atRandom = {
    "drawing.count": () => Math.round(10 ** (2 + random(2))), "drawing.relax": () => Math.max(0, Math.round(random(24) - 12)),
    "drawing.pens": () => one_of(["one", "greys", "cmyk", "auto:3"]), "drawing.tile": () => one_of(engine.tiles()),
    "drawing.page.margins_mm": () => Object.fromEntries(["top", "right", "bottom", "left"].map((side) => [side, random(30)])),
    "drawing.page.quarter_turns": () => Math.floor(random(4)),
    ...Object.fromEntries(["automatic_tone", "background", "show_tiles", "tone.invert"].map((each) => [`drawing.${each}`, () => random() < 0.5])),
};
const notHere = ["drawing.sheet_overlap_mm", "drawing.contours", "drawing.solid"];
for (let round = 0; round < 30; ++round) {
    const settings = {drawing: {}}, name = one_of(Object.keys(pictures));
    for (const [field, {choices, from, to, logarithmic}] of Object.entries(engine.rows())) {
        if (!field.startsWith("drawing.") || notHere.includes(field) || random() < 0.7) continue;
        const value = atRandom[field] ?? (choices && (() => one_of(choices))) ??
            (from !== undefined && (() => logarithmic ? from * (Math.min(to, 400) / from) ** random() : from + random(to - from)));
        const path = field.split("."), last = path.pop();
        if (value) path.reduce((at, part) => at[part] ??= {}, settings)[last] = value();
    }
    const file = written(name, pictures[name]), project = `${folder}/random.dapple`, table = `${folder}/random.csv`;
    writeFileSync(project, JSON.stringify({dapple: 1, picture: {file}, ...settings}));
    engine.setPicture(pictures[name]);
    let refusal, theirs = "";
    try {
        engine.draw(settings);
    } catch (error) {
        refusal = error.message;
    }
    try {
        execFileSync(dapple, ["render", project, "-o", table], {stdio: "ignore"});
        theirs = readFileSync(table, "utf8");
    } catch {
    }
    const here = refusal ? "" : engine.file("csv");
    const right = refusal ? refusal.includes("leaves out the tile") || !theirs : here === theirs;
    failed += !right;
    console.log(`${!right ? "NOT THE SAME" : refusal ? "refused" : "same"}: ${refusal ?? `dots of ${name}`} ${JSON.stringify(settings.drawing)}`);
}
// The spectrum is the one that the program measures of the same dots, to what another Fourier transform rounds; and of one
// tile that repeats it says so.
for (const [tile, repeats] of [["best32", true], ["kinds4096", false]]) {
    const settings = {drawing: {count: 30000, relax: 0, tile, automatic_tone: false}};
    engine.setPicture(painted(100, 100, () => [120, 120, 120]));
    engine.draw(settings);
    const here = engine.spectrum(), table = `${folder}/${tile}.csv`;
    writeFileSync(table, engine.file("csv"));
    execFileSync(lab, ["analyse", table, "-o", `${folder}/${tile}.png`]);
    execFileSync(lab, ["analyse", table, "-o", `${folder}/${tile}.json`, "--period", String(here.period)]);
    const pixels = execFileSync("convert", [`${folder}/${tile}.png`, "-depth", "8", "rgba:-"], {maxBuffer: 1e9});
    const other = pixels.length === here.rgba.length ? pixels.filter((value, i) => Math.abs(value - here.rgba[i]) > 1).length : NaN;
    const value = JSON.parse(readFileSync(`${folder}/${tile}.json`)).periodicity;
    const right = other <= pixels.length / 1e5 && Math.abs(value - here.periodicity) < 1e-3 && value > 0.9 === repeats;
    failed += !right;
    console.log(`${right ? "same" : "NOT THE SAME"}: spectrum of ${here.dots} dots of ${tile}, ${other} of ${pixels.length} values differ; ` +
                `periodicity ${here.periodicity}, the program's ${value}`);
}
for (const [drawing, sentence] of [
    [{count: 0}, "settings: drawing.count is 0; give a whole number from 1 to 10000000000, or null"],
    [{contours: 0.5}, "this page draws neither contours nor solid blacks, which these settings ask for; draw them with the program"]]) {
    try {
        engine.draw({drawing});
        failed += console.log(`NOT REFUSED: ${JSON.stringify(drawing)}`) ?? 1;
    } catch (error) {
        failed += error.message !== sentence;
        console.log(`refused: ${error.message}`);
    }
}
process.exit(failed ? 1 : 0);
