#pragma once
// A drawing as PDF, for print.

#include <ostream>
#include <string>

#include "core/output/ink.h"
#include "core/text/number_words.h"

namespace dapple {

/// A side of a PDF's page, 14,400 points: readers take no larger ones.
inline constexpr double kLongestPdfSideMm = 14'400 / 72.0 * kMmPerInch;
/// The library keeps a page in memory until it is whole, about 20 bytes a dot, and layers until all are.
inline constexpr std::uint64_t kMostPdfDots = 20'000'000;

/// Throws std::runtime_error if a PDF cannot have such a page, or so many dots.
void check_fits_pdf(const PageSize& page, std::uint64_t dots);

/// One page of exactly that size with that title in UTF-8, all dots vector discs: lines of no length with
/// round ends, a quarter of the bytes of circles, which is how PDF defines a dot. Radii are rounded to
/// 0.001 mm, which is the least. Strokes are as wide as the pen, with round ends; their points count as dots.
/// Several pens have a layer each, "1 Cyan". Throws what check_fits_pdf() throws; what the stream throws
/// passes through.
void write_pdf(std::ostream& out, const InkPage& page, const std::string& title,
               const WritingProgress& progress = {});

}  // namespace dapple
