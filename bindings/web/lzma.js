// The inverse of `xz --format=lzma`, which packs the engine a fifth smaller than what browsers can unpack themselves.
// After the LZMA specification of Igor Pavlov (www.7-zip.org/sdk.html), whose names the numbers have.

// `packed`: a Uint8Array that begins with the format's header, in which the size is said.
function unpackLzma(packed) {
    const header = new DataView(packed.buffer, packed.byteOffset);
    const lc = packed[0] % 9, lp = Math.floor(packed[0] / 9) % 5, pb = Math.floor(packed[0] / 45);
    const out = new Uint8Array(header.getUint32(5, true));
    let range = 0xffffffff, code = header.getUint32(14), read = 18;

    // Each chance, of a bit to be 0, in 2048ths.
    const chances = (count) => new Uint16Array(count).fill(1024);
    function next() {
        if (range >= 0x1000000) return;
        range = (range << 8) >>> 0;
        code = ((code << 8) | packed[read++]) >>> 0;
    }
    function bit(of, at) {
        const bound = (range >>> 11) * of[at];
        const one = code >= bound;
        if (one) {
            range -= bound;
            code -= bound;
            of[at] -= of[at] >> 5;
        } else {
            range = bound;
            of[at] += (2048 - of[at]) >> 5;
        }
        next();
        return one ? 1 : 0;
    }
    function evenBits(count) {
        let bits = 0;
        while (count--) {
            range >>>= 1;
            const one = code >= range;
            if (one) code -= range;
            bits = 2 * bits + (one ? 1 : 0);
            next();
        }
        return bits;
    }
    function tree(of, bits, from = 0) {
        let node = 1;
        for (let i = 0; i < bits; ++i) node = 2 * node + bit(of, from + node);
        return node - (1 << bits);
    }
    function reverseTree(of, bits, from = 0) {
        let node = 1, value = 0;
        for (let i = 0; i < bits; ++i) {
            const one = bit(of, from + node);
            node = 2 * node + one;
            value |= one << i;
        }
        return value;
    }
    const lengths = () => ({choice: chances(2), low: chances(128), mid: chances(128), high: chances(256)});
    const length = ({choice, low, mid, high}, pos) =>
        !bit(choice, 0) ? tree(low, 3, 8 * pos) : !bit(choice, 1) ? 8 + tree(mid, 3, 8 * pos) : 16 + tree(high, 8);

    const literal = chances(0x300 << (lc + lp)), isMatch = chances(192), isRep = chances(12), isRepG0 = chances(12),
          isRepG1 = chances(12), isRepG2 = chances(12), isRep0Long = chances(192), slots = chances(256),
          places = chances(115), align = chances(16), matchLength = lengths(), repLength = lengths();
    let state = 0, size = 0, [rep0, rep1, rep2, rep3] = [0, 0, 0, 0];
    const copy = (count) => { for (; count; --count, ++size) out[size] = out[size - rep0 - 1]; };
    function repeat(count) {
        state = state < 7 ? 8 : 11;
        copy(count);
    }
    function literalByte() {
        const from = 0x300 * (((size & ((1 << lp) - 1)) << lc) + ((size ? out[size - 1] : 0) >> (8 - lc)));
        let symbol = 1;
        if (state >= 7) {
            let expected = out[size - rep0 - 1], same = true;
            while (same && symbol < 0x100) {
                const like = (expected >> 7) & 1, one = bit(literal, from + ((1 + like) << 8) + symbol);
                symbol = 2 * symbol + one;
                expected <<= 1;
                same = like === one;
            }
        }
        while (symbol < 0x100) symbol = 2 * symbol + bit(literal, from + symbol);
        return symbol & 0xff;
    }
    function distance(count) {
        const slot = tree(slots, 6, 64 * Math.min(count, 3));
        if (slot < 4) return slot;
        const bits = (slot >> 1) - 1, far = (2 | (slot & 1)) << bits;
        if (slot < 14) return far + reverseTree(places, bits, far - slot);
        return far + 16 * evenBits(bits - 4) + reverseTree(align, 4);
    }
    while (size < out.length) {
        const pos = size & ((1 << pb) - 1);
        if (!bit(isMatch, 16 * state + pos)) {
            out[size] = literalByte();
            ++size;
            state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
        } else if (!bit(isRep, state)) {
            const count = length(matchLength, pos);
            [rep0, rep1, rep2, rep3] = [distance(count), rep0, rep1, rep2];
            state = state < 7 ? 7 : 10;
            copy(count + 2);
        } else if (bit(isRepG0, state)) {
            if (!bit(isRepG1, state)) [rep0, rep1] = [rep1, rep0];
            else if (!bit(isRepG2, state)) [rep0, rep1, rep2] = [rep2, rep0, rep1];
            else [rep0, rep1, rep2, rep3] = [rep3, rep0, rep1, rep2];
            repeat(length(repLength, pos) + 2);
        } else if (bit(isRep0Long, 16 * state + pos)) {
            repeat(length(repLength, pos) + 2);
        } else {
            state = state < 7 ? 9 : 11;
            copy(1);
        }
    }
    return out;
}
