#include "io/files/pdf_file.h"

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/vec2.hpp>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/output/plotted.h"
#include "core/text/length.h"
#include "core/text/shown_text.h"
#include "io/files/pdf_layers.h"

namespace dapple {
namespace {

constexpr double kPointsPerMm = 72 / kMmPerInch;
constexpr std::size_t kDotsAtOnce = 1 << 14;  // sorted by their radii
constexpr std::size_t kDotsOfAPath = 1000;    // printers' memory for one is small
constexpr double kMicrometresPerMm = 1000;
constexpr double kCutMarkMm = 0.1;
constexpr double kUsualMarkMm = 0.3;       // of a pen whose width is not told
constexpr double kBytesADot = 9.5;         // in a file, about
constexpr double kShareOfGathering = 0.2;  // of the time, before the library begins to write

// Pages that the library makes and writes into a stream. What the stream throws is kept while the C library
// is in between.
class PdfPages {
 public:
    PdfPages(std::ostream& out, double width_pt, double height_pt, std::uint64_t dots,
             const WritingProgress& progress)
        : out_(out),
          progress_(progress),
          bytes_expected_(static_cast<double>(dots) * kBytesADot + 1),
          surface_(cairo_pdf_surface_create_for_stream(&PdfPages::write, this, width_pt, height_pt)),
          context_(cairo_create(surface_)) {}
    PdfPages(const PdfPages&) = delete;
    PdfPages& operator=(const PdfPages&) = delete;
    ~PdfPages() {
        dropped_ = true;
        cairo_destroy(context_);
        cairo_surface_destroy(surface_);
    }

    cairo_surface_t* surface() const { return surface_; }
    cairo_t* context() const { return context_; }

    // What follows belongs to this one: a page for each, one over the other in the end.
    void begin_layer(const std::string& name, PenInk ink = PenInk::opaque) {
        if (!layers_.empty()) cairo_show_page(context_);
        layers_.push_back({name, ink == PenInk::transparent});
    }
    const std::vector<PdfLayer>& layers() const { return layers_; }

    // How much of the dots was gathered before the library begins to write.
    void gathered(double share) { report(kShareOfGathering * share); }

    // So many of the dots lie on the page: the library leaves the others out.
    void finish(std::uint64_t dots_on_page) {
        bytes_expected_ = static_cast<double>(dots_on_page) * kBytesADot + 1;
        cairo_show_page(context_);
        const cairo_status_t drawn = cairo_status(context_);
        cairo_surface_finish(surface_);
        if (thrown_) std::rethrow_exception(thrown_);
        for (const cairo_status_t status : {drawn, cairo_surface_status(surface_)}) {
            if (status == CAIRO_STATUS_SUCCESS) continue;
            throw std::runtime_error(
                fmt::format("the PDF cannot be written: {}", cairo_status_to_string(status)));
        }
    }

 private:
    static cairo_status_t write(void* self, const unsigned char* bytes, unsigned size) {
        return static_cast<PdfPages*>(self)->put(reinterpret_cast<const char*>(bytes), size);
    }
    cairo_status_t put(const char* bytes, unsigned size) {
        if (dropped_ || thrown_) return CAIRO_STATUS_WRITE_ERROR;
        try {
            out_.write(bytes, static_cast<std::streamsize>(size));
            bytes_ += size;
            report(kShareOfGathering + (1 - kShareOfGathering) * std::min(bytes_ / bytes_expected_, 1.0));
            return CAIRO_STATUS_SUCCESS;
        } catch (...) {
            thrown_ = std::current_exception();
            return CAIRO_STATUS_WRITE_ERROR;
        }
    }

    // It gathers a page while it has written others.
    void report(double share) {
        share_ = std::max(share_, share);
        if (progress_) progress_(share_);
    }

    std::ostream& out_;
    const WritingProgress& progress_;
    double bytes_expected_, bytes_ = 0, share_ = 0;
    std::vector<PdfLayer> layers_;
    bool dropped_ = false;
    std::exception_ptr thrown_;
    cairo_surface_t* surface_;
    cairo_t* context_;
};

void set_colour(cairo_t* context, glm::vec3 colour) {
    cairo_set_source_rgb(context, colour.r, colour.g, colour.b);
}

// Dots with a common radius are drawn together: overlapping ones unite all the same.
class PdfDots {
 public:
    explicit PdfDots(cairo_t* context) : context_(context) {
        cairo_set_line_cap(context_, CAIRO_LINE_CAP_ROUND);
    }

    void add(glm::dvec2 place_pt, double radius_mm) {
        const auto radius = std::max(std::lround(radius_mm * kMicrometresPerMm), 1L);
        waiting_[radius].push_back(place_pt);
        if (++count_ == kDotsAtOnce) draw();
    }

    void draw() {
        for (auto& [radius, places] : waiting_) {
            const double radius_mm = static_cast<double>(radius) / kMicrometresPerMm;
            cairo_set_line_width(context_, 2 * radius_mm * kPointsPerMm);
            for (std::size_t i = 0; i < places.size(); ++i) {
                cairo_move_to(context_, places[i].x, places[i].y);
                cairo_line_to(context_, places[i].x, places[i].y);
                if ((i + 1) % kDotsOfAPath == 0) cairo_stroke(context_);
            }
            if (places.size() % kDotsOfAPath != 0) cairo_stroke(context_);
        }
        waiting_.clear();
        count_ = 0;
    }

 private:
    cairo_t* context_;
    std::map<long, std::vector<glm::dvec2>> waiting_;  // by radius in micrometres
    std::size_t count_ = 0;
};

void draw_marks(cairo_t* context, std::span<const CutMark> marks, double width_mm) {
    cairo_set_line_width(context, width_mm * kPointsPerMm);
    for (const CutMark& mark : marks) {
        cairo_move_to(context, mark.from.x * kPointsPerMm, mark.from.y * kPointsPerMm);
        cairo_line_to(context, mark.to.x * kPointsPerMm, mark.to.y * kPointsPerMm);
        cairo_stroke(context);
    }
}

bool lies_on(const PageSize& page, glm::dvec2 at_mm) {
    return at_mm.x >= 0 && at_mm.y >= 0 && at_mm.x <= page.width_mm && at_mm.y <= page.height_mm;
}

void begin_pen(PdfPages& pdf, const PdfStyle& style, int pen) {
    const Pen& drawn = style.pens[static_cast<std::size_t>(pen)];
    pdf.begin_layer(fmt::format("{} {}", pen + 1, drawn.name), drawn.ink);
    set_colour(pdf.context(), drawn.colour);
    draw_marks(pdf.context(), style.registration, drawn.width_mm > 0 ? drawn.width_mm : kUsualMarkMm);
}

}  // namespace

void check_fits_pdf(const PageSize& page, std::uint64_t dots) {
    // What is rounded up to a hundredth of a millimetre is taken too.
    if (std::max(page.width_mm, page.height_mm) > kLongestPdfSideMm + 0.01) {
        throw std::runtime_error(
            fmt::format("a page in a PDF is at most {:g} mm wide and high, and this one is {:g} x {:g} mm; "
                        "choose a smaller width, a part of the page or SVG",
                        kLongestPdfSideMm, page.width_mm, page.height_mm));
    }
    if (dots > kMostPdfDots) {
        throw std::runtime_error(
            fmt::format("a PDF is made in memory and has at most {} dots, and this one would have {}; choose "
                        "fewer, a part of the page or SVG",
                        grouped(kMostPdfDots), grouped(dots)));
    }
}

namespace {

// The page, with what draw(pdf, progress of gathering) puts on it: it tells how many of the dots lie there.
template <class Draw>
void write_page(std::ostream& out, std::uint64_t dots, const PageSize& page, const PdfStyle& style,
                const WritingProgress& progress, const Draw& draw) {
    check_fits_pdf(page, dots);
    const bool layered = !style.pens.empty();
    std::ostringstream pages;
    pages.exceptions(std::ios::badbit);
    PdfPages pdf(layered ? pages : out, page.width_mm * kPointsPerMm, page.height_mm * kPointsPerMm, dots,
                 progress);
    cairo_pdf_surface_set_metadata(pdf.surface(), CAIRO_PDF_METADATA_TITLE, style.title.c_str());
    cairo_pdf_surface_set_metadata(pdf.surface(), CAIRO_PDF_METADATA_CREATOR, "Dapple");
    // The library writes the time of day unless it is told one, and the same drawing is to be the same file.
    cairo_pdf_surface_set_metadata(pdf.surface(), CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
    if (style.background) {
        if (layered) pdf.begin_layer("Paper");
        set_colour(pdf.context(), *style.background);
        cairo_paint(pdf.context());
    }
    set_colour(pdf.context(), style.ink);
    const std::uint64_t on_page = draw(pdf, [&](double share) { pdf.gathered(share); });
    if (!style.cut_marks.empty()) {
        if (layered) pdf.begin_layer(fmt::format("{} Cut marks", style.pens.size() + 1));
        set_colour(pdf.context(), kBlack);
        draw_marks(pdf.context(), style.cut_marks, kCutMarkMm);
    }
    if (layered && pdf.layers().empty()) pdf.begin_layer("Paper");  // a sheet without dots
    pdf.finish(on_page);
    if (layered) write_as_layers(out, pages.view(), pdf.layers());
}

}  // namespace

void write_pdf(std::ostream& out, const DotStream& dots, const PageSize& page, const PdfStyle& style,
               const WritingProgress& progress) {
    write_page(out, dots.count, page, style, progress, [&](PdfPages& pdf, const WritingProgress& gathering) {
        PdfDots drawn(pdf.context());
        DotsReport report(dots.count, page, gathering);
        std::uint64_t on_page = 0;
        int pen = -1;
        dots.for_each_piece([&](const Dots& piece) {
            if (!style.pens.empty() && piece.pen != pen) {
                drawn.draw();
                pen = piece.pen;
                begin_pen(pdf, style, pen);
            }
            for (std::size_t i = 0; i < piece.size(); ++i) {
                const double radius_mm =
                    piece.radius.empty() ? style.dot_radius_mm : piece.radius[i] * page.mm_per_page_unit;
                const glm::dvec2 at_mm = glm::dvec2(piece.x[i], piece.y[i]) * page.mm_per_page_unit;
                report.next(at_mm.x, at_mm.y, radius_mm);
                on_page += lies_on(page, at_mm) ? 1 : 0;
                drawn.add(at_mm * kPointsPerMm, radius_mm);
            }
            return true;
        });
        drawn.draw();
        return on_page;
    });
}

void write_pdf(std::ostream& out, const StrokeStream& strokes, const PageSize& page, const PdfStyle& style,
               const WritingProgress& progress) {
    const auto draw = [&](PdfPages& pdf, const WritingProgress& gathering) {
        cairo_t* const context = pdf.context();
        cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_width(context, strokes.width_mm * kPointsPerMm);
        std::size_t waiting = 0;  // points of the path
        std::uint64_t on_page = 0;
        int pen = -1;
        for_each_stroke(strokes, page, gathering, [&](std::span<const glm::dvec2> points, int its_pen) {
            if (!style.pens.empty() && its_pen != pen) {
                cairo_stroke(context);
                pen = its_pen;
                begin_pen(pdf, style, pen);
                cairo_set_line_width(context, strokes.width_of(pen) * kPointsPerMm);
            }
            for (std::size_t i = 0; i < points.size(); ++i) {
                const glm::dvec2 p = points[i] * kPointsPerMm;
                on_page += lies_on(page, points[i]) ? 1 : 0;
                if (i == 0) cairo_move_to(context, p.x, p.y);
                if (i > 0 || points.size() == 1) cairo_line_to(context, p.x, p.y);
                if (++waiting % kDotsOfAPath != 0) continue;
                cairo_stroke(context);
                cairo_move_to(context, p.x, p.y);  // the stroke goes on: its ends are round
            }
        });
        cairo_stroke(context);
        return on_page;
    };
    write_page(out, strokes.points, page, style, progress, draw);
}

}  // namespace dapple
