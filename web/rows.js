// Rows that change settings. Their names, ranges and tips are the engine's (Settings::rows()).

// "%.2f" and its like, as the table has them.
function formatted(format, number) {
    const [, sign, digits, kind, rest] = /^%(\+?)\.(\d)([fg])(.*)$/.exec(format);
    if (kind === "g") return String(Number(number.toPrecision(digits))) + rest;
    const text = Number(digits) === 0 ? Math.round(number).toLocaleString("en") : number.toFixed(digits);
    return (sign && number > 0 ? "+" : "") + text.replace(/^-(?=[0.]*$)/, "") + rest;
}
// What is typed: 40,000 and 40k too.
function typedNumber(text) {
    const [, number, thousands] = /^([-+]?[\d.]+)\s*(k?)/i.exec(text.replaceAll(",", "").trim()) ?? [];
    return number === undefined ? NaN : Number(number) * (thousands ? 1000 : 1);
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
function sliderRow(about, {get, set, most, shown, grouped}) {
    const to = Math.min(most ?? about.to, about.to), ratio = about.logarithmic;
    const steps = /\.0f/.test(about.format) && !ratio ? to - about.from : 200;
    const [low, high] = ratio ? [Math.log(about.from), Math.log(to)] : [about.from, to];
    const slider = element("input", {type: "range", min: low, max: high, step: (high - low) / steps});
    const value = element("input", {className: "value", inputMode: "decimal", ariaLabel: `${about.row}, typed`});
    const text = (number) => shown?.(number) ?? formatted(about.format, number) + (about.unit ? ` ${about.unit}` : "");
    const take = (number) => set(Math.min(Math.max(number, about.least), most ?? about.most));
    slider.addEventListener("input", () => {
        const number = ratio ? Math.exp(slider.value) : Number(slider.value);
        // Three digits are all that a hand can choose.
        take(ratio ? Number(number.toPrecision(3)) : Number(number.toFixed(4)));
    });
    slider.addEventListener("dblclick", () => set(undefined));
    slider.addEventListener("keydown", (event) => {
        if (event.key === "Backspace" || event.key === "Delete") set(undefined);
    });
    value.addEventListener("change", () => {
        const number = typedNumber(value.value);
        if (Number.isFinite(number)) take(number);
        row.refresh();
    });
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
