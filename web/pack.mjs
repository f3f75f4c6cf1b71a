// pack.mjs ENGINE.wasm STILL_LIFE.jpg ICON.png PAGE.html: everything in one file, which works wherever it lies.
import {readFileSync, writeFileSync} from "node:fs";
import {gzipSync} from "node:zlib";

const [engine, picture, icon, page] = process.argv.slice(2);
const text = (name) => readFileSync(new URL(name, import.meta.url), "utf8");
const inBase64 = (bytes) => bytes.toString("base64");
const parts = {
    ICON: inBase64(readFileSync(icon)),
    ENGINE: inBase64(gzipSync(readFileSync(engine), {level: 9})),
    PICTURE: inBase64(readFileSync(picture)),
    THREAD: text("engine.mjs").replaceAll("export ", "") + text("worker.js"),
    SCRIPT: text("canvas.js") + text("rows.js") + text("page.js"),
};
const packed = text("page.html").replace(/\b(ICON|ENGINE|PICTURE|THREAD|SCRIPT)\b/g, (part) => parts[part]);
writeFileSync(page, packed);
console.log(`${page}: ${packed.length} bytes, ${gzipSync(packed, {level: 9}).length} packed by gzip`);
