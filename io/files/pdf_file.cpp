#include "io/files/pdf_file.h"

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <sstream>
#include <vector>

#include "core/failure.h"
#include "core/text/number_words.h"
#include "io/files/pdf_layers.h"

namespace dapple {
namespace {

constexpr double kPointsPerMm = 72 / kMmPerInch;
constexpr std::size_t kDotsAtOnce = 1 << 14;  // sorted by their radii
constexpr std::size_t kDotsOfAPath = 1000;    // printers' memory for one is small
constexpr double kMicrometresPerMm = 1000;
constexpr double kCutMarkMm = 0.1;
constexpr double kBytesADot = 9.5;         // in a file, about
constexpr double kShareOfGathering = 0.2;  // of the time, before the library begins to write

// How many dots, or points of strokes.
std::uint64_t ink_of(const InkPage& page) {
    return page.strokes ? page.strokes->points : page.dots.count;
}

// A page for each layer, which the library makes and writes into a stream; one over the other in the end. A
// page of a single pen has no layers. What the stream throws is kept while the C library is in between.
class PdfWriter : public InkWriter {
 public:
    PdfWriter(std::ostream& out, const InkPage& page, const std::string& title,
              const WritingProgress& progress)
        : page_(page),
          layered_(!page.pens.empty()),
          file_(out),
          out_(layered_ ? pages_ : out),
          progress_(progress),
          surface_(cairo_pdf_surface_create_for_stream(
              &PdfWriter::take, this, page.size.width_mm * kPointsPerMm, page.size.height_mm * kPointsPerMm)),
          context_(cairo_create(surface_)) {
        pages_.exceptions(std::ios::badbit);
        cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_TITLE, title.c_str());
        cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_CREATOR, "Dapple");
        // The library writes the time of day unless it is given one, and the same drawing is to be the same
        // file.
        cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
        cairo_set_line_cap(context_, CAIRO_LINE_CAP_ROUND);
        cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
        if (page.background) {
            begin_layer("Paper");
            set_colour(*page.background);
            cairo_paint(context_);
        }
    }
    PdfWriter& operator=(PdfWriter&&) = delete;
    ~PdfWriter() override {
        dropped_ = true;
        cairo_destroy(context_);
        cairo_surface_destroy(surface_);
    }

    void begin_pen(int number, const Pen& pen, double width_mm) override {
        draw();
        begin_layer(fmt::format("{} {}", number + 1, pen.name), pen.ink);
        set_colour(pen.colour);
        width_mm_ = width_mm;
    }

    // Dots with a common radius are drawn together: overlapping ones unite all the same.
    void dot(const InkDot& dot) override {
        dots_[std::max(std::lround(dot.radius_mm * kMicrometresPerMm), 1L)].push_back(dot.at * kPointsPerMm);
        count_if_shown(dot.at);
        if (++waiting_dots_ == kDotsAtOnce) draw();
    }

    void stroke(std::span<const glm::dvec2> points) override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2 p = points[i] * kPointsPerMm;
            count_if_shown(points[i]);
            if (i == 0) cairo_move_to(context_, p.x, p.y);
            if (i > 0 || points.size() == 1) cairo_line_to(context_, p.x, p.y);
            if (++points_of_path_ % kDotsOfAPath != 0) continue;
            draw_path(width_mm_);
            cairo_move_to(context_, p.x, p.y);  // the stroke goes on: its ends are round
        }
    }

    void shape(const InkArea& area) override {
        for (const std::vector<glm::dvec2>& ring : area.rings) {
            const glm::dvec2 begin = ring.front() * kPointsPerMm;
            cairo_move_to(context_, begin.x, begin.y);
            for (const Cubic& curve : smooth_curve(ring)) {
                const glm::dvec2 leave = curve[1] * kPointsPerMm, arrive = curve[2] * kPointsPerMm,
                                 to = curve[3] * kPointsPerMm;
                cairo_curve_to(context_, leave.x, leave.y, arrive.x, arrive.y, to.x, to.y);
                ++shown_;
            }
            cairo_close_path(context_);
        }
        cairo_fill(context_);
    }

    // How much of the ink was gathered before the library begins to write.
    void gathered(double share) { report(kShareOfGathering * share); }

    void end() override {
        if (!page_.cut_marks.empty()) {
            const auto layer = static_cast<int>(page_.pens.size());
            begin_pen(layer, {.name = "Cut marks", .ink = PenInk::opaque}, kCutMarkMm);
            write_marks(*this, page_.cut_marks);
        }
        draw();
        if (layers_.empty()) begin_layer("Paper");  // a sheet without dots
        // The library leaves out what does not lie on the page.
        bytes_expected_ = static_cast<double>(shown_) * kBytesADot + 1;
        cairo_show_page(context_);
        const cairo_status_t drawn = cairo_status(context_);
        cairo_surface_finish(surface_);
        if (thrown_) std::rethrow_exception(thrown_);
        for (const cairo_status_t status : {drawn, cairo_surface_status(surface_)}) {
            if (status == CAIRO_STATUS_SUCCESS) continue;
            throw failure("the PDF cannot be written: {}", cairo_status_to_string(status));
        }
        if (layered_) write_as_layers(file_, pages_.view(), layers_);
    }

 private:
    void begin_layer(const std::string& name, PenInk ink = PenInk::opaque) {
        if (layered_ && !layers_.empty()) cairo_show_page(context_);
        layers_.push_back({name, ink == PenInk::transparent});
    }

    void set_colour(glm::vec3 colour) { cairo_set_source_rgb(context_, colour.r, colour.g, colour.b); }

    // All that waits: lines lie below dots.
    void draw() {
        draw_path(width_mm_);
        for (const auto& [radius, places] : dots_) {
            const double width_mm = 2 * static_cast<double>(radius) / kMicrometresPerMm;
            for (std::size_t i = 0; i < places.size(); ++i) {
                cairo_move_to(context_, places[i].x, places[i].y);
                cairo_line_to(context_, places[i].x, places[i].y);
                if ((i + 1) % kDotsOfAPath == 0) draw_path(width_mm);
            }
            draw_path(width_mm);
        }
        dots_.clear();
        waiting_dots_ = 0;
    }

    void draw_path(double width_mm) {
        cairo_set_line_width(context_, width_mm * kPointsPerMm);
        cairo_stroke(context_);
    }

    void count_if_shown(glm::dvec2 at) {
        shown_ += at.x >= 0 && at.y >= 0 && at.x <= page_.size.width_mm && at.y <= page_.size.height_mm;
    }

    static cairo_status_t take(void* self, const unsigned char* bytes, unsigned size) {
        return static_cast<PdfWriter*>(self)->put(reinterpret_cast<const char*>(bytes), size);
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

    const InkPage& page_;
    const bool layered_;
    std::ostream& file_;
    std::ostringstream pages_;
    std::ostream& out_;  // the pages, or the file
    const WritingProgress& progress_;
    double bytes_expected_ = static_cast<double>(ink_of(page_)) * kBytesADot + 1, bytes_ = 0, share_ = 0;
    std::vector<PdfLayer> layers_;
    double width_mm_ = 0;                           // of the pen's lines
    std::map<long, std::vector<glm::dvec2>> dots_;  // that wait, in points, by radius in micrometres
    std::size_t waiting_dots_ = 0, points_of_path_ = 0;
    std::uint64_t shown_ = 0;
    bool dropped_ = false;
    std::exception_ptr thrown_;
    cairo_surface_t* surface_;
    cairo_t* context_;
};

}  // namespace

void check_fits_pdf(const PageSize& page, std::uint64_t dots) {
    // What is rounded up to a hundredth of a millimetre is taken too.
    if (std::max(page.width_mm, page.height_mm) > kLongestPdfSideMm + 0.01) {
        throw failure(
            "a page in a PDF is at most {:g} mm wide and high, and this one is {:g} x {:g} mm; "
            "choose a smaller width, a part of the page or SVG",
            kLongestPdfSideMm, page.width_mm, page.height_mm);
    }
    if (dots > kMostPdfDots) {
        throw failure(
            "a PDF has at most {} dots, as it is made in memory, and this one would have {}; choose fewer, a "
            "part of the page or SVG",
            grouped(kMostPdfDots), grouped(dots));
    }
}

void write_pdf(std::ostream& out, const InkPage& page, const std::string& title,
               const WritingProgress& progress) {
    check_fits_pdf(page.size, ink_of(page));
    PdfWriter writer(out, page, title, progress);
    write_ink(writer, page, [&](double share) { writer.gathered(share); });
}

}  // namespace dapple
