#pragma once
// A drawing as PDF, for print.

#include <glm/vec3.hpp>
#include <optional>
#include <ostream>
#include <span>
#include <string>

#include "core/image/colour.h"
#include "core/output/progress.h"
#include "core/output/sheet.h"
#include "core/pens/pen.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"
#include "core/text/length.h"

namespace dapple {

/// A side of a PDF's page, 14,400 points: readers take no larger ones.
inline constexpr double kLongestPdfSideMm = 14'400 / 72.0 * kMmPerInch;
/// The library keeps a page in memory until it is whole, about 20 bytes a dot, and layers until all are.
inline constexpr std::uint64_t kMostPdfDots = 20'000'000;

struct PdfStyle {
    double dot_radius_mm = 0;  // where dots have none of their own; rounded to 0.001 mm, which is the least
    glm::vec3 ink = kBlack;
    std::span<const Pen> pens = {};              // several, for the dots' or strokes' pens: a layer each
    std::span<const CutMark> registration = {};  // registration_marks(): lines that each of these draws
    std::optional<glm::vec3> background;         // a rectangle under everything
    std::string title = {};                      // UTF-8
    std::span<const CutMark> cut_marks = {};     // of a sheet, in black on top
};

/// Throws std::runtime_error if a PDF cannot have such a page, or so many dots.
void check_fits_pdf(const PageSize& page, std::uint64_t dots);

/// One page of exactly that size, all dots vector discs: lines of no length with round ends, a quarter of
/// the bytes of circles, which is how PDF defines a dot. Throws what check_fits_pdf() throws; what the stream
/// throws passes through.
void write_pdf(std::ostream& out, const DotStream& dots, const PageSize& page, const PdfStyle& style,
               const WritingProgress& progress = {});

/// The same for strokes, as wide as the pen, with round ends; their points count as dots.
void write_pdf(std::ostream& out, const StrokeStream& strokes, const PageSize& page, const PdfStyle& style,
               const WritingProgress& progress = {});

}  // namespace dapple
