// Rows that change settings. Their names, ranges and tips are the engine's (Settings::rows()).

// "%.2f" and its like, as the table has them.
function formatted(format, number) {
    const [, sign, digits, kind, rest] = /^%(\+?)\.(\d)([fg])(.*)$/.exec(format);
    if (kind === "g") return String(Number(number.toPrecision(digits))) + rest;
    const text = Number(digits) === 0 ? Math.round(number).toLocaleString("en") : number.toFixed(digits);
    return (sign && number > 0 ? "+" : "") + text.replace(/^-(?=[0.]*$)/, "") + rest;
}
// What is typed, as the program's options read it: 40,000, 40k, 1.5M, 1e5; NaN if it is none of these. Nobody has to guess
// what the point of a whole number stands for.
function typedNumber(text, unit, whole) {
    const [, sign, digits, rest, power, times] =
        /^(-?)(\d{1,3}(?:,\d{3})+|\d*)(\.\d*)?(e[-+]?\d+)?([kKMG]?)$/.exec(text.replace(unit.trim(), "").trim()) ?? [];
    if (!(digits || rest?.length > 1) || (whole && rest && !power && !times)) return NaN;
    const number = Number(sign + digits.replaceAll(",", "") + (rest ?? "") + (power ?? "")) * ({k: 1e3, K: 1e3, M: 1e6, G: 1e9}[times] ?? 1);
    return !whole ? number : Math.abs(number - Math.round(number)) > 1e-6 ? NaN : Math.round(number);
}

let rowsMade = 0;
function element(name, properties = {}, ...within) {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...within);
    return made;
}
function rowOf(name, tip, ...controls) {
    const id = `row${++rowsMade}`;
    controls[0].id = id;
    const row = element("div", {className: "row", title: tip ?? ""}, element("label", {htmlFor: id, textContent: name}), ...controls);
    return row;
}

// `about`: a field of Settings::rows(). `row` says get() and set(value), which may be undefined for the usual value,
// and `shown(value)`, where its text is another. Returned rows have refresh().
// `whole`: a count.
function sliderRow(about, {get, set, most = about.most, shown, whole}) {
    const to = Math.min(most, about.to), ratio = about.logarithmic;
    const steps = /\.0f/.test(about.format) && !ratio ? to - about.from : 200;
    const [low, high] = ratio ? [Math.log(about.from), Math.log(to)] : [about.from, to];
    const slider = element("input", {type: "range", min: low, max: high, step: (high - low) / steps});
    const value = element("input", {className: "value", inputMode: "decimal", ariaLabel: `${about.row}, typed`});
    const unit = about.unit ? ` ${about.unit}` : /[fg](.*)$/.exec(about.format)[1];
    const inWords = (number) => formatted(about.format, number) + (about.unit ? unit : "");
    const text = (number) => shown?.(number) ?? inWords(number);
    const take = (number) => set(Math.min(Math.max(number, about.least), most));
    const slide = () => {
        const number = ratio ? Math.exp(slider.value) : Number(slider.value);
        // Three digits are all that a hand can choose.
        take(ratio ? Number(number.toPrecision(3)) : Number(number.toFixed(4)));
    };
    // A finger that begins here may want to scroll: it moves the slider once it has moved to the side, or was lifted.
    let finger;
    slider.addEventListener("pointerdown", ({pointerType, clientX, clientY}) => {
        finger = pointerType === "touch" ? {clientX, clientY, before: slider.value} : undefined;
    });
    slider.addEventListener("pointermove", ({clientX, clientY}) => {
        if (!finger || Math.abs(clientX - finger.clientX) < Math.max(6, Math.abs(clientY - finger.clientY))) return;
        finger = undefined;
        slide();
    });
    slider.addEventListener("pointerup", () => {
        if (finger) slide();
        finger = undefined;
    });
    slider.addEventListener("pointercancel", () => {
        if (finger) slider.value = finger.before;
        finger = undefined;
    });
    slider.addEventListener("input", () => { if (!finger) slide(); });
    slider.addEventListener("dblclick", () => set(undefined));
    slider.addEventListener("keydown", (event) => {
        if (event.key === "Backspace" || event.key === "Delete") set(undefined);
    });
    value.addEventListener("change", () => {
        const number = typedNumber(value.value, unit, whole);
        const numbers = `${whole ? "a whole number" : "a number"} from ${inWords(about.least)} to ${inWords(most)}`;
        if (number >= about.least && number <= most) take(number);
        else say(`${about.row}: ${value.value} is not possible; give ${numbers}.`);
        row.refresh();
    });
    value.addEventListener("blur", () => row.refresh());
    const row = rowOf(about.row, about.tip && `${about.tip} A double click takes the usual value again.`, slider, value);
    row.refresh = () => {
        const number = get();
        if (document.activeElement !== slider || !slider.matches(":active")) slider.value = ratio ? Math.log(number) : number;
        slider.ariaValueText = text(number);
        if (document.activeElement !== value) value.value = text(number);
    };
    return row;
}

// `choices`: [value, word] of each.
function choiceRow(about, {get, set, choices}) {
    const select = element("select", {}, ...choices.map(([value, word]) => element("option", {value, textContent: word})));
    select.addEventListener("change", () => set(select.value));
    const row = rowOf(about.row, about.tip, select);
    row.refresh = () => { select.value = get(); };
    return row;
}
function segmentsRow(about, {get, set, choices}) {
    const group = element("div", {className: "segments", role: "radiogroup", ariaLabel: about.row});
    for (const [value, word] of choices) {
        const radio = element("input", {type: "radio", name: about.row, value});
        radio.addEventListener("change", () => set(value));
        group.append(element("label", {}, radio, word));
    }
    const row = rowOf(about.row, about.tip, group);
    row.refresh = () => group.querySelectorAll("input").forEach((radio) => { radio.checked = radio.value === get(); });
    return row;
}
function colourRow(about, {get, set}) {
    const colour = element("input", {type: "color"});
    colour.addEventListener("input", () => set(colour.value));
    const row = rowOf(about.row, about.tip, colour);
    row.refresh = () => { colour.value = get(); };
    return row;
}
function switchRow(about, {get, set}) {
    const box = element("input", {type: "checkbox"});
    box.addEventListener("change", () => set(box.checked));
    const row = rowOf(about.row, about.tip, box);
    row.refresh = () => { box.checked = get(); };
    return row;
}
