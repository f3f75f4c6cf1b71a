/* The same picture from C, as a table of a thousand dots on the standard output: disc_to_text svg|csv|... */
#include <dapple/dapple.h>
#include <math.h>
#include <stdio.h>

enum { kSide = 400 };

static unsigned char pixels[kSide * kSide];

static int failed(void) {
    fprintf(stderr, "%s\n", dapple_error());
    return 1;
}

int main(int argc, char** argv) {
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double across = x / 200.0 - 1, down = y / 200.0 - 1;
            const double height2 = 0.8 - across * across - down * down;
            pixels[y * kSide + x] = height2 < 0 ? 255 : (unsigned char)(230 * sqrt(height2));
        }
    }
    dapple_stippler* stippler = dapple_stippler_new(0);
    if (dapple_set_picture(stippler, pixels, kSide, kSide, 1) != 0) return failed();
    dapple_drawing* drawing =
        dapple_draw(stippler, "{\"drawing\": {\"count\": 1000, \"page\": {\"width_mm\": 150}}}", NULL, NULL);
    if (!drawing) return failed();
    char* text = dapple_drawing_text(drawing, argc > 1 ? argv[1] : "csv", NULL);
    if (!text) return failed();
    fputs(text, stdout);
    dapple_free(text);
    dapple_drawing_free(drawing);
    dapple_stippler_free(stippler);
    return 0;
}
