#pragma once
/* Dapple for C, and for whatever calls C: pictures into stipple drawings.
 *
 *     dapple_stippler* stippler = dapple_stippler_new(0);
 *     dapple_set_picture(stippler, pixels, width, height, 3);
 *     dapple_drawing* drawing = dapple_draw(stippler, "{\"drawing\": {\"count\": 20000}}", NULL, NULL);
 *     char* svg = dapple_drawing_text(drawing, "svg", &size);
 *
 * What fails returns NULL or -1, and dapple_error() then says why in one sentence. One thread at a time may
 * use a stippler; a drawing never changes and is for any number of threads.
 */

#include <stddef.h>

#ifndef DAPPLE_API
#if defined(__GNUC__)
#define DAPPLE_API __attribute__((visibility("default")))
#else
#define DAPPLE_API
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef struct dapple_stippler dapple_stippler;
typedef struct dapple_drawing dapple_drawing;

/* Why the last call of this thread that failed did so; "" if none has. Valid until the next one fails. */
DAPPLE_API const char* dapple_error(void);

/* What dapple_... returned to be freed: texts and pixels. NULL does nothing. */
DAPPLE_API void dapple_free(void* returned);

/* How many threads work, up to 1024; 0: one for each core. */
DAPPLE_API dapple_stippler* dapple_stippler_new(int threads);
DAPPLE_API void dapple_stippler_free(dapple_stippler* stippler);

/* Pixels of 8 bits a channel, sRGB-encoded, row after row from the top, without gaps: 1 channel is grey, 2
 * grey and alpha, 3 red, green and blue, 4 the same and alpha. They are copied. 0, or -1. */
DAPPLE_API int dapple_set_picture(dapple_stippler* stippler, const unsigned char* pixels, int width,
                                  int height, int channels);

/* Linear light instead: width * height values of luminance, 0 black, 1 paper; and 3 * width * height of red,
 * green and blue, or NULL for a grey picture. 0, or -1. */
DAPPLE_API int dapple_set_light(dapple_stippler* stippler, const float* light, const float* colours,
                                int width, int height);

/* The density of the dots itself, which no tone changes: width * height values of 0 to 1, each of which holds
 * for all of its cell: no dot lies where it is 0. 0, or -1. */
DAPPLE_API int dapple_set_density(dapple_stippler* stippler, const float* values, int width, int height);

/* The same, but that each value holds for the middle of its cell, and that the density changes evenly between
 * four middles, as a picture's does. 0, or -1. */
DAPPLE_API int dapple_set_linear_density(dapple_stippler* stippler, const float* values, int width,
                                         int height);

/* The text of a tile file for all drawings from now on; NULL or "": the settings' tile again. 0, or -1. */
DAPPLE_API int dapple_set_tile(dapple_stippler* stippler, const char* text);

/* Told now and then how much is done, 0 to 1. Anything but 0 ends it. */
typedef int (*dapple_progress)(double share, void* data);

/* `settings`: JSON as in Dapple's projects; NULL: the usual ones. dapple_usual_settings() lists all fields.
 * `progress` may be NULL; `data` is handed on to it. NULL if it failed, or was ended ("stopped"). */
DAPPLE_API dapple_drawing* dapple_draw(dapple_stippler* stippler, const char* settings,
                                       dapple_progress progress, void* data);
DAPPLE_API void dapple_drawing_free(dapple_drawing* drawing);

/* All settings with their usual values, as JSON; to be freed. */
DAPPLE_API char* dapple_usual_settings(void);

DAPPLE_API size_t dapple_drawing_count(const dapple_drawing* drawing);
DAPPLE_API void dapple_drawing_page_mm(const dapple_drawing* drawing, double* width, double* height);

/* Fills arrays of dapple_drawing_count() values, each of which may be NULL: millimetres from the page's upper
 * left corner, radii, and the pen of each dot, from 0 on. 0, or -1. */
DAPPLE_API int dapple_drawing_dots(const dapple_drawing* drawing, float* x, float* y, float* radius,
                                   int* pen);

/* A file's text: "svg", "gcode", "hpgl", "dxf", "csv" or "json". It ends in a zero, which `size` leaves out;
 * `size` may be NULL. To be freed. */
DAPPLE_API char* dapple_drawing_text(const dapple_drawing* drawing, const char* format, size_t* size);

/* Pixels of red, green and blue, sRGB-encoded, row after row from the top; to be freed. */
DAPPLE_API unsigned char* dapple_drawing_pixels(const dapple_drawing* drawing, double dpi, int* width,
                                                int* height);

#ifdef __cplusplus
}
#endif
