// pack.mjs ENGINE.wasm STILL_LIFE.webp ICON.png PAGE.html: everything in one file, which works wherever it lies.
// Ends with 1 if it is larger than it may be.
import {execFileSync} from "node:child_process";
import {readFileSync, writeFileSync} from "node:fs";
import {gzipSync} from "node:zlib";

const [engine, picture, icon, page] = process.argv.slice(2);
const text = (name) => readFileSync(new URL(name, import.meta.url), "utf8");
const inBase64 = (bytes) => bytes.toString("base64");
const MOST = 400_000;  // bytes, as servers send the page
// For lzma.js. xz leaves the size open, which it reads from a pipe.
function packedEngine() {
    const bytes = readFileSync(engine);
    const packed = execFileSync("xz", ["--format=lzma", "--lzma1=preset=9e,pb=0"], {input: bytes, maxBuffer: bytes.length});
    packed.writeBigUInt64LE(BigInt(bytes.length), 5);
    return packed;
}
const parts = {
    ICON: inBase64(readFileSync(icon)),
    ENGINE: inBase64(packedEngine()),
    PICTURE: inBase64(readFileSync(picture)),
    THREAD: text("engine.mjs").replaceAll("export ", "") + text("worker.js"),
    SCRIPT: text("lzma.js") + text("canvas.js") + text("rows.js") + text("page.js"),
};
const packed = text("page.html").replace(/\b(ICON|ENGINE|PICTURE|THREAD|SCRIPT)\b/g, (part) => parts[part]);
writeFileSync(page, packed);
const sent = gzipSync(packed, {level: 9}).length;
console.log(`${page}: ${packed.length} bytes, ${sent} packed by gzip`);
if (sent > MOST) {
    console.error(`${page} may have ${MOST} bytes packed by gzip; make the engine smaller`);
    process.exit(1);
}
