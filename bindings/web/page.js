// The page around the engine. It keeps settings in one object, as projects have them; each change goes to a worker that
// places the dots at once, and, when the hand rests, to another one where they settle.

const byId = (id) => document.getElementById(id);
const say = (text) => { byId("message").textContent = text; };
const SETTLE_AFTER = 150;  // milliseconds of rest, after which the link is written too: browsers refuse more than a few a second

// An engine in a worker of its own.
function engineThread(script, module) {
    const worker = new Worker(script), waiting = new Map();
    let asked = 0;
    worker.onmessage = ({data: {id, answer, error}}) => {
        const {resolve, reject} = waiting.get(id);
        waiting.delete(id);
        error === undefined ? resolve(answer) : reject(new Error(error));
    };
    const ask = (what, with_) => {
        const answer = new Promise((resolve, reject) => {
            waiting.set(++asked, {resolve, reject});
            worker.postMessage({id: asked, ask: what, what: with_});
        });
        answer.catch(() => {});  // nobody may wait for it
        return answer;
    };
    ask("start", module);
    return {
        ask,
        // Whoever waits is told so by an error with `ended`.
        end() {
            worker.terminate();
            for (const {reject} of waiting.values()) reject(Object.assign(new Error("ended"), {ended: true}));
        },
    };
}

// Works on the newest of what it is given, one after the other; what was overtaken is left out.
function latest(work) {
    let wanted, running = false;
    const take = async (next) => {
        wanted = next;
        if (running) return;
        running = true;
        while (wanted) {
            const now = wanted;
            wanted = undefined;
            await work(now);
        }
        running = false;
    };
    return Object.assign(take, {busy: () => running});
}

const clone = (value) => JSON.parse(JSON.stringify(value));
// What of `value` is not as in `usual`; undefined if nothing.
function changedFrom(usual, value) {
    if (JSON.stringify(usual) === JSON.stringify(value)) return undefined;
    if (!usual || !value || typeof value !== "object") return value;
    return Object.fromEntries(Object.entries(value).map(([name, each]) => [name, changedFrom(usual[name], each)])
        .filter(([, each]) => each !== undefined));
}
function merged(usual, changed) {
    const result = {...usual};
    for (const [name, value] of Object.entries(changed ?? {}))
        if (value !== undefined)
            result[name] = value && usual[name] && typeof value === "object" ? merged(usual[name], value) : value;
    return result;
}

const bytesOf = (id) => Uint8Array.from(atob(byId(id).textContent), (c) => c.charCodeAt(0));

// Beyond these canvases are empty, in one browser or another, and memory is short.
const MOST_SIDE = 16384, MOST_PIXELS = 16e6;

// Orientation and colour profile are the browser's work.
async function pictureOf(source, options) {
    const bitmap = await createImageBitmap(source, options);
    const {width, height} = bitmap;
    const context = new OffscreenCanvas(width, height).getContext("2d", {willReadFrequently: true});
    context.drawImage(bitmap, 0, 0);
    return {pixels: new Uint8Array(context.getImageData(0, 0, width, height).data.buffer), width, height};
}
// {read, width, height} of a file, read smaller where it is too large; `note` says what it lost.
async function pictureIn(file, called) {
    const image = new Image();
    image.src = URL.createObjectURL(file);
    const unreadable = new Error(`${called}: the browser cannot read this as a picture; try a PNG or a JPEG`);
    try {
        await new Promise((resolve, reject) => Object.assign(image, {onload: resolve, onerror: reject}));
    } catch {
        throw unreadable;
    } finally {
        URL.revokeObjectURL(image.src);
    }
    const [width, height] = [image.naturalWidth, image.naturalHeight];
    const share = Math.min(1, MOST_SIDE / Math.max(width, height), Math.sqrt(MOST_PIXELS / (width * height)));
    const smaller = (side) => Math.max(Math.round(side * share), 1);
    let read;
    try {
        read = await pictureOf(file, share < 1 ? {resizeWidth: smaller(width), resizeHeight: smaller(height), resizeQuality: "high"} : {});
    } catch {
        throw file.type === "image/svg+xml" ? unreadable : new Error(`${called} is damaged`);
    }
    const start = new Uint8Array(await file.slice(0, 25).arrayBuffer());
    const has16 = String.fromCharCode(...start.subarray(1, 4)) === "PNG" && start[24] === 16;
    const notes = [share < 1 && `read as ${read.width} x ${read.height}`, has16 && "read with 8 of their 16 bits"];
    return {read, width, height, note: notes.filter(Boolean).map((each) => `, ${each}`).join("")};
}
function sample() {
    return new File([bytesOf("picture")], "Still life", {type: "image/webp"});
}

async function main() {
    const script = URL.createObjectURL(new Blob([byId("thread").textContent], {type: "text/javascript"}));
    const module = await WebAssembly.compile(unpackLzma(bytesOf("engine")));
    const placing = engineThread(script, module);
    let settling = engineThread(script, module);
    const {usual, rows: table, tiles, most} = await placing.ask("describe");

    let settings = clone(usual), picture, name = "", drawn, undrawn, ofSample = false;
    let taken = 0;  // what was opened, dropped or pasted: of several, the last one counts
    const drawing = () => settings.drawing;

    // Of the window's surround, as the theme has it.
    const canvas = pageCanvas(document.querySelector("canvas"), byId("over"), {
        colours: () => {
            const style = getComputedStyle(document.documentElement);
            const full = (hex) => hex.length === 4 ? "#" + [...hex.slice(1)].map((c) => c + c).join("") : hex;
            return {surround: full(style.getPropertyValue("--surround").trim()), line: full(style.getPropertyValue("--line").trim())};
        },
        moved: (zoom) => { byId("zoom").textContent = `${Math.round(zoom * 25.4 / 96 * 100)} %`; },
        painted: () => { if (drawn && !performance.getEntriesByName("first dots").length) performance.mark("first dots"); },
    });
    for (const theme of ["(prefers-color-scheme: dark)", "(prefers-contrast: more)"])
        matchMedia(theme).addEventListener("change", canvas.repaint);

    function showDrawn(result, done) {
        drawn = result;
        const several = result.pens.length > 1;
        canvas.show(result, {paper: drawing().paper, pens: result.pens, transparent: several && drawing().pen_ink === "transparent"});
        const dots = `${result.dots.toLocaleString("en")} ${result.dots === 1 ? "dot" : "dots"}`;
        const page = `${Math.round(result.width)} x ${Math.round(result.height)} mm`;
        byId("count").textContent = dots;
        byId("page").textContent = page;
        byId("work").textContent = done ? "" : "relaxing";
        if (done) {
            byId("said").textContent = `${dots} on ${page}`;
            document.querySelector("canvas").ariaLabel = `${name}, drawn with ${dots} on ${page}`;
        }
        refresh();
    }

    // What was drawn before has another picture or other settings: nobody sees or saves it any more.
    function showNothing(why) {
        say(undrawn = `${why}.`);
        const {width, height} = picture;
        canvas.show({width: 200, height: 200 * height / width, positions: new Float32Array(0)}, {paper: drawing().paper, pens: [{colour: [0, 0, 0]}], transparent: false});
        drawn = undefined;
        byId("count").textContent = "no dots";
        byId("page").textContent = byId("work").textContent = "";
        refresh();
    }

    // The right side of the split view, which no file has.
    let rightTile;
    function beside(tile) {
        rightTile = tile;
        byId("divider").hidden = tile === undefined;
        canvas.splitAt(tile === undefined ? undefined : Number(byId("divider").value));
        change(() => {});
    }
    byId("divider").oninput = () => canvas.splitAt(Number(byId("divider").value));
    let spectrumShown = false;
    // `spectra`: of both sides, from left to right, if they are shown and the dots have settled.
    async function drawnBy(thread, wanted) {
        const spectra = [];
        const drawn = async (settings) => {
            const result = await thread.ask("draw", settings);
            if (spectrumShown && thread === settling)
                spectra.unshift({tile: settings.drawing.tile, ...await thread.ask("spectrum")});
            return result;
        };
        // The drawing itself last: it is what is saved then.
        const right = rightTile && await drawn(merged(wanted, {drawing: {tile: rightTile}}));
        return {right, result: await drawn(wanted), spectra};
    }
    const spectraShown = Object.assign(element("div", {id: "spectra"}), {refresh() {}, applies: () => spectrumShown});
    function showSpectra(spectra) {
        spectraShown.replaceChildren(...spectra.map(({tile, width, height, rgba, periodicity}) => {
            const canvas = element("canvas", {width, height, role: "img", ariaLabel: `Spectrum of ${tile}`});
            canvas.getContext("2d").putImageData(new ImageData(rgba, width, height), 0, 0);
            const said = periodicity === null ? "too few tiles to see one repeat" : `periodicity ${Math.max(periodicity, 0).toFixed(2)}`;
            return element("figure", {}, canvas, element("figcaption", {textContent: `${tile}: ${said}`}));
        }));
    }

    let newest, settled, timer, camera, waiting = [];  // settings: those wanted, and those whose dots have settled
    const whenSettled = () => newest === settled ? undefined : new Promise((resolve) => waiting.push(resolve));
    const settle = latest(async (wanted) => {
        try {
            const {result, right, spectra} = await drawnBy(settling, wanted);
            if (wanted !== newest) return;
            if (right) canvas.showBeside(right);
            showSpectra(spectra);
            showDrawn(result, true);
        } catch (failed) {
            if (failed.ended || wanted !== newest) return;
            showNothing(failed.message);
        }
        settled = wanted;
        for (const resolve of waiting.splice(0)) resolve();
    });
    const place = latest(async (wanted) => {
        try {
            const {result, right} = await drawnBy(placing, merged(wanted, {drawing: {relax: 0}}));
            if (wanted === settled || newest === settled) return;  // it comes late
            if (right) canvas.showBeside(right);
            showDrawn({...result, steps: drawn?.steps ?? result.steps}, false);
        } catch (failed) {
            if (wanted === newest && wanted !== settled) showNothing(failed.message);
        }
    });
    // What is wanted now. A picture that was read smaller has its crop in the pixels of the file.
    function wantedNow() {
        const wanted = clone(settings), {crop} = wanted.drawing.page;
        if (crop.unit === "pixels") for (const side of ["left", "top", "right", "bottom"]) crop[side] *= picture.read.width / picture.width;
        return wanted;
    }
    // Draws what is wanted now.
    function draw() {
        if (!picture) return;
        say("");
        newest = wantedNow();
        byId("work").textContent = "relaxing";
        place(newest);
        clearTimeout(timer);
        if (camera) return;
        timer = setTimeout(() => {
            if (settle.busy()) {
                // What it works at is no longer wanted.
                settling.end();
                settling = engineThread(script, module);
                settling.ask("picture", picture.read);
            }
            settle(newest);
        }, SETTLE_AFTER);
    }

    // Rows. A row changes the settings by change(), which draws and writes the link.
    const writeLink = () => {
        const changed = changedFrom(usual, settings);
        history.replaceState(null, "", changed ? `#${encodeURIComponent(JSON.stringify(changed))}` : location.pathname + location.search);
    };
    let linkTimer;
    const link = () => {
        clearTimeout(linkTimer);
        linkTimer = setTimeout(writeLink, SETTLE_AFTER);
    };
    function change(work) {
        work(drawing());
        refresh();
        draw();
        link();
    }
    const parts = (path) => ({within: path.slice(0, -1).reduce((at, part) => at[part], settings), last: path.at(-1), usual: path.reduce((at, part) => at?.[part], usual)});
    // A row of the field "drawing.tone.contrast"; `own` says what is other than usual about it.
    function row(kind, field, own = {}) {
        const path = field.split("."), about = table[field];
        const words = (choice) => [choice, (own.words?.[choice] ?? choice).replaceAll("_", " ")];
        const made = kind({...about, ...own.about}, {
            get: () => parts(path).within[parts(path).last],
            set: (value) => change(() => {
                const {within, last, usual: as_usual} = parts(path);
                within[last] = value ?? as_usual;
            }),
            choices: about.choices?.map(words),
            ...own,
        });
        made.applies = own.applies;
        return made;
    }
    const TONE = ["black_point", "white_point", "contrast", "brightness", "gamma"];
    // The curve of the tone: automatic until one of these rows is moved, and then the person's own, from there on.
    const toneRow = (field) => row(sliderRow, `drawing.tone.${field}`, {
        get: () => (drawing().automatic_tone && drawn ? drawn.tone : drawing().tone)[field],
        set: (value) => change((d) => {
            if (d.automatic_tone && drawn) for (const each of [...TONE, "black"]) d.tone[each] = drawn.tone[each];
            d.automatic_tone = false;
            d.tone[field] = value ?? usual.drawing.tone[field];
            if (field === "black_point") d.tone.white_point = Math.max(d.tone.white_point, d.tone.black_point + 0.01);
            if (field === "white_point") d.tone.black_point = Math.min(d.tone.black_point, d.tone.white_point - 0.01);
        }),
    });
    const isTrue = () => !drawing().automatic_tone && TONE.every((field) => drawing().tone[field] === usual.drawing.tone[field]);
    const automaticTone = row(sliderRow, "drawing.tone_strength", {
        get: () => (isTrue() ? 0 : drawing().tone_strength),
        shown: (strength) => isTrue() || (drawing().automatic_tone && strength === 0) ? "true" : drawing().automatic_tone ? undefined : "custom",
        set: (value) => change((d) => {
            const strength = value ?? usual.drawing.tone_strength, before = d.automatic_tone;
            for (const field of TONE) d.tone[field] = usual.drawing.tone[field];
            d.automatic_tone = strength > 0;
            if (d.automatic_tone) d.tone_strength = strength;
            if (d.automatic_tone && before) return;
            d.tone.black = usual.drawing.tone.black;
            d.tone.detail = d.automatic_tone ? usual.drawing.tone.detail : 0;
        }),
    });

    const INKS = {one: "one ink", white: "white on black", greys: "greys", cmyk: "CMYK", "auto:4": "automatic"};
    const isWhite = () => drawing().pens === "one" && drawing().tone.invert && drawing().ink === "#ffffff" && drawing().paper === "#000000";
    const inks = row(choiceRow, "drawing.pens", {
        choices: Object.entries(INKS).concat([["own", "custom pens"]]),
        get: () => (isWhite() ? "white" : drawing().pens in INKS ? drawing().pens : "own"),
        set: (value) => change((d) => {
            if (value === "own") return;
            const white = value === "white";
            if (white || isWhite()) {
                d.tone.invert = white;
                [d.ink, d.paper] = white ? ["#ffffff", "#000000"] : ["#000000", "#ffffff"];
            }
            d.pens = white ? "one" : value;
        }),
    });

    const byTone = () => drawing().dot_size.sizing === "by_tone";
    const asPicture = () => drawing().page.paper === table["drawing.page.paper"].choices[0];
    const sides = () => ["top", "right", "bottom", "left"];
    const sections = {
        Drawing: [
            row(sliderRow, "drawing.count", {get: () => (byTone() && drawn ? drawn.dots : drawing().count), most, whole: true,
                set: (value) => change((d) => { d.count = Math.round(value ?? usual.drawing.count); }), applies: () => !byTone()}),
            row(segmentsRow, "drawing.dot_size.sizing", {words: {automatic: "auto"},
                set: (value) => change(({dot_size: size}) => {
                    // From the size that they have.
                    if (drawn && value === "fixed") size.radius_mm = Number(drawn.radius.toFixed(3));
                    if (drawn && value === "by_tone") {
                        size.smallest_mm = Number((drawn.radius * 0.7).toFixed(3));
                        size.largest_mm = Number((drawn.radius * 1.6).toFixed(3));
                    }
                    size.sizing = value;
                })}),
            row(sliderRow, "drawing.dot_size.radius_mm", {applies: () => drawing().dot_size.sizing === "fixed"}),
            row(sliderRow, "drawing.dot_size.smallest_mm", {applies: byTone,
                set: (value) => change(({dot_size: size}) => {
                    size.smallest_mm = value ?? usual.drawing.dot_size.smallest_mm;
                    size.largest_mm = Math.max(size.largest_mm, size.smallest_mm);
                })}),
            row(sliderRow, "drawing.dot_size.largest_mm", {applies: byTone,
                set: (value) => change(({dot_size: size}) => {
                    size.largest_mm = value ?? usual.drawing.dot_size.largest_mm;
                    size.smallest_mm = Math.min(size.largest_mm, size.smallest_mm);
                })}),
            row(sliderRow, "drawing.relax", {get: () => drawing().relax ?? drawn?.steps ?? 0,
                set: (value) => change((d) => { d.relax = value === undefined ? null : Math.round(value); })}),
        ],
        Tone: [automaticTone, toneRow("brightness"), toneRow("contrast"), row(sliderRow, "drawing.tone.detail"),
               {"More tone settings": [toneRow("black_point"), toneRow("white_point"), toneRow("gamma"), row(sliderRow, "drawing.tone.blur")]}],
        "Ink and paper": [inks, row(colourRow, "drawing.ink", {applies: () => drawing().pens === "one"}),
                          row(colourRow, "drawing.paper"), row(switchRow, "drawing.background")],
        Page: [
            row(choiceRow, "drawing.page.paper", {set: (value) => change(({page}) => {
                page.paper = value;
                if (page.paper === "custom" && drawn) [page.width_mm, page.height_mm] = [drawn.width, drawn.height];
                if (page.paper !== "custom") page.height_mm = null;
            })}),
            row(choiceRow, "drawing.page.orientation", {applies: () => !asPicture()}),
            row(segmentsRow, "drawing.page.fit", {applies: () => !asPicture()}),
            row(sliderRow, "drawing.page.width_mm", {applies: () => asPicture() || drawing().page.paper === "custom"}),
            row(sliderRow, "drawing.page.height_mm", {get: () => drawing().page.height_mm ?? drawn?.height ?? 100,
                applies: () => drawing().page.paper === "custom"}),
            row(sliderRow, "drawing.page.margins_mm", {
                get: () => drawing().page.margins_mm?.top ?? drawn?.radius ?? 0,
                shown: () => (drawing().page.margins_mm ? undefined : "auto"),
                set: (value) => change(({page}) => {
                    page.margins_mm = value === undefined ? null : Object.fromEntries(sides().map((side) => [side, value]));
                })}),
            row(sliderRow, "saving.dpi"),
        ],
        "The method": [
            row(choiceRow, "drawing.tile", {choices: tiles.map((tile) => [tile, tile])}),
            row(switchRow, "drawing.show_tiles"),
            row(switchRow, "drawing.tile", {
                about: {row: "Split view", tip: "Shows another tile to the right of a line that you can drag."},
                get: () => rightTile !== undefined,
                set: (on) => beside(on ? "best32" : undefined)}),
            row(choiceRow, "drawing.tile", {
                about: {row: "Right tile", tip: "The tile of the right side's dots."},
                choices: tiles.map((tile) => [tile, tile]), get: () => rightTile, set: beside, applies: () => rightTile !== undefined}),
            row(switchRow, "drawing.tile", {
                about: {row: "Spectrum", tip: "The spectrum of the dots, low frequencies in the middle: a dark disc with an even ring is good. Orange spots are stronger than chance. Periodicity is the share of dots that meet another when all are shifted by whole tiles: 0 = random, 1 = repeats exactly."},
                get: () => spectrumShown,
                set: (on) => change(() => { spectrumShown = on; })}),
            spectraShown,
        ],
    };
    const made = [];
    const withRows = (list) => list.flatMap((each) => {
        if (each instanceof HTMLElement) return made.push(each), [each];
        return Object.entries(each).map(([title, more]) => section(title, more, false));
    });
    const section = (title, list, open = true) =>
        element("details", {open}, element("summary", {textContent: title}), ...withRows(list));
    byId("sections").replaceChildren(...Object.entries(sections).map(([title, list]) => section(title, list)));
    function refresh() {
        for (const each of made) {
            each.hidden = each.applies ? !each.applies() : false;
            each.refresh();
        }
    }

    // Pictures and settings that come in.
    async function takeSettings(text, overtaken) {
        const {drawing: changed, saving: files} = await placing.ask("changed", text);
        if (overtaken?.()) return;
        settings = merged(clone(usual), {drawing: changed, saving: files});
        refresh();
        link();
        draw();
    }
    function nameIs(called) {
        name = called;
        byId("name").textContent = name;
        byId("about").textContent = `${picture.width} x ${picture.height} pixels${picture.note}`;
    }
    async function takePicture(file, called, overtaken) {
        const opened = await pictureIn(file, called);
        if (overtaken()) return;
        endCamera();
        picture = opened;
        ofSample = file === still;
        nameIs(called);
        placing.ask("picture", picture.read);
        settling.ask("picture", picture.read);
        draw();
    }
    // Draws one frame after the other; where it is ended, the last one settles.
    async function startCamera() {
        const own = ++taken;
        const stream = await navigator.mediaDevices.getUserMedia({video: {width: 640, height: 480}});
        if (own !== taken) return stream.getTracks().forEach((track) => track.stop());
        const video = element("video", {srcObject: stream, muted: true, playsInline: true});
        await video.play();
        camera = stream;
        byId("camera").ariaPressed = true;
        while (camera === stream) {
            const frame = await pictureOf(video);
            if (camera !== stream) break;
            picture = {read: frame, width: frame.width, height: frame.height, note: ""};
            await placing.ask("picture", picture.read);
            if (camera !== stream) break;
            nameIs("Camera");
            newest = wantedNow();
            await place(newest);
            await new Promise(requestAnimationFrame);
        }
    }
    function endCamera() {
        if (!camera) return;
        camera.getTracks().forEach((track) => track.stop());
        camera = undefined;
        byId("camera").ariaPressed = false;
        settling.ask("picture", picture.read);
        draw();
    }
    async function take(file, called = file.name) {
        const own = ++taken, overtaken = () => own !== taken;
        try {
            say("");
            if (/\.(dapple|json)$/i.test(called)) return await takeSettings(await file.text(), overtaken);
            const kept = /\.svg$/i.test(called) && /<dapple:settings[^>]*>([^<]*)</.exec(await file.text());
            if (kept) return await takeSettings(kept[1].replaceAll("&quot;", '"'), overtaken);
            await takePicture(file, called, overtaken);
        } catch (failed) {
            if (!overtaken()) say(`${failed.message}.`);
        }
    }
    const still = sample();

    byId("open").onclick = () => byId("file").click();
    byId("file").onchange = () => { if (byId("file").files[0]) take(byId("file").files[0]); byId("file").value = ""; };
    byId("camera").onclick = async () => {
        if (camera) return endCamera();
        try {
            await startCamera();
        } catch (failed) {
            say(`There is no picture from a camera: ${failed.message}.`);
        }
    };
    byId("sample").onclick = () => take(still);
    addEventListener("dragover", (event) => { event.preventDefault(); document.body.classList.add("dropping"); });
    addEventListener("dragleave", (event) => { if (!event.relatedTarget) document.body.classList.remove("dropping"); });
    addEventListener("drop", (event) => {
        event.preventDefault();
        document.body.classList.remove("dropping");
        if (event.dataTransfer.files[0]) take(event.dataTransfer.files[0]);
    });
    addEventListener("paste", (event) => { if (event.clipboardData.files[0]) take(event.clipboardData.files[0], "Pasted picture"); });
    addEventListener("keydown", (event) => {
        if ((event.ctrlKey || event.metaKey) && event.key === "o") { event.preventDefault(); byId("open").click(); }
    });
    addEventListener("hashchange", () => takeLink());

    // Files that go out.
    const stem = () => name.replace(/\.[a-z0-9]+$/i, "").replaceAll(" ", "-").toLowerCase() || "drawing";
    function save(blob, called) {
        const link = element("a", {href: URL.createObjectURL(blob), download: called});
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
    }
    const saving = (button, work) => {
        byId(button).onclick = async () => {
            try {
                if (!picture) return;
                byId("work").textContent = "saving";
                for (let ended = true; ended;) {
                    await whenSettled();
                    if (!drawn) throw new Error(`Nothing was saved: ${undrawn.slice(0, -1)}`);
                    // As the heading is now; what is changed meanwhile may end it.
                    ended = await work(stem()).catch((failed) => { if (!failed.ended) throw failed; return true; });
                }
            } catch (failed) {
                say(`${failed.message}.`);
            }
            byId("work").textContent = "";
        };
    };
    saving("svg", async (called) => save(new Blob([await settling.ask("file", "svg")], {type: "image/svg+xml"}), `${called}.svg`));
    saving("png", async (called) => {
        const {width, height, rgba} = await settling.ask("pixels", settings.saving.dpi);
        const canvas = new OffscreenCanvas(width, height);
        canvas.getContext("2d").putImageData(new ImageData(rgba, width, height), 0, 0);
        save(await canvas.convertToBlob({type: "image/png"}), `${called}.png`);
    });
    saving("project", async (called) => {
        const project = {dapple: 1, picture: ofSample ? null : {file: name}, ...changedFrom(usual, settings)};
        save(new Blob([JSON.stringify(project, null, 2) + "\n"], {type: "application/json"}), `${called}.dapple`);
    });
    byId("link").onclick = async () => {
        writeLink();
        await navigator.clipboard.writeText(location.href);
        byId("said").textContent = byId("work").textContent = "link copied";
    };

    async function takeLink() {
        try {
            if (location.hash.length > 1) await takeSettings(decodeURIComponent(location.hash.slice(1)));
        } catch (failed) {
            say(`The link's settings are not right: ${failed.message}.`);
        }
    }
    refresh();
    await takeLink();
    const wrong = byId("message").textContent;
    if (taken === 0) await take(still);
    if (wrong) say(wrong);
}

main().catch((failed) => { byId("message").textContent = `Dapple cannot work in this browser: ${failed.message}.`; });
