// pack.mjs ENGINE.wasm STILL_LIFE.webp ICON.png PAGE.html: everything in one file, which works wherever it lies.
import {execFileSync} from "node:child_process";
import {readFileSync, writeFileSync} from "node:fs";
import {gzipSync} from "node:zlib";

const [engine, picture, icon, page] = process.argv.slice(2);
const text = (name) => readFileSync(new URL(name, import.meta.url), "utf8");
// Without indents, and lines of comments.
const script = (...names) => names.map(text).join("").replace(/^ *(\/\/.*\n)?/gm, "");
const inBase64 = (bytes) => bytes.toString("base64");
// For lzma.js. xz leaves the size open, which it reads from a pipe.
function packedEngine() {
    const bytes = readFileSync(engine);
    const packed = execFileSync("xz", ["--format=lzma", "--lzma1=preset=9e,pb=0,nice=64"], {input: bytes, maxBuffer: bytes.length});
    packed.writeBigUInt64LE(BigInt(bytes.length), 5);
    return packed;
}
const parts = {
    ICON: inBase64(readFileSync(icon)),
    ENGINE: inBase64(packedEngine()),
    PICTURE: inBase64(readFileSync(picture)),
    THREAD: script("engine.mjs", "worker.js").replaceAll("export ", ""),
    SCRIPT: script("lzma.js", "canvas.js", "rows.js", "page.js"),
};
const packed = text("page.html").replace(/\b(ICON|ENGINE|PICTURE|THREAD|SCRIPT)\b/g, (part) => parts[part]);
writeFileSync(page, packed);
console.log(`${page}: ${packed.length} bytes, ${gzipSync(packed, {level: 9}).length} packed by gzip`);
