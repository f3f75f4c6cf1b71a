#pragma once
// Draws the sheet, the picture under it, dots and tile outlines with OpenGL 3.3.
//
// The page is as light as in a file (core/output/raster.h): ink and paper are mixed in linear light, dots
// that overlap unite, each pen's among themselves, and what of them lies beyond the page's edges is cut off.
// For that the dots are first drawn by themselves, with more samples than the canvas has pixels where they
// are small; how much of a sample each of several pens covers stands in a component of its own.
//
// Where OpenGL is a program, and so is slow, dots and lines are drawn by ours instead (processor_dots.h), but
// for those that have colours of their own.
//
// Nothing here takes longer for more dots unless it is told to: a drawing goes forward in steps, as long as
// one likes, and dots are handed to OpenGL as they are drawn, through buffers of constant size.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/background/preview_dots.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/canvas/processor_dots.h"
#include "app/viewer/view/camera.h"
#include "app/viewer/view/dot_raster.h"
#include "app/viewer/view/frame_budget.h"
#include "core/image/rectangle.h"
#include "core/pens/pen.h"
#include "core/placing/dots.h"
#include "core/placing/placer.h"

namespace dapple {

/// Where the photograph's picture on the page comes from, in shares of the photograph's width and height: its
/// upper left corner, and the ways along its upper and its left edge.
struct PictureView {
    glm::vec2 corner{0, 0}, across{1, 0}, down{0, 1};

    bool operator==(const PictureView&) const = default;
};

/// How the drawing looks on screen; colours sRGB-encoded 0..1.
struct CanvasLook {
    glm::vec3 desk{0.8f}, paper{1.0f}, ink{0.0f};
    glm::dvec2 page_size{1, 1};  // of the picture, page units
    /// The sheet, page units; none: the picture's edges are the sheet's.
    std::optional<Rectangle<double>> sheet = {};
    PictureView picture_view = {};
    double dot_radius = 0.002;      // page units; of dots that have none of their own
    float picture_opacity = 0;      // 0: bare paper
    float picture_gain = 1;         // its light is multiplied by this
    bool dots = true;               // shown
    std::uint32_t hidden_pens = 0;  // whose dots or lines are not: a bit for each, see hidden_among()
    bool tiles = false;             // outlines shown
    double fade_scale = 0;          // dots fade in below this scale; 0: none does
    float pixel_scale = 1;          // pixels of a line meant to be one pixel wide at 96 dpi

    bool operator==(const CanvasLook&) const = default;
};

/// What lies beside the sheet, with its shadow.
enum class Desk {
    drawn,
    kept,  // it is in the picture already
};

/// Whether that, and where the sheets lie on it, is the same for the same camera.
bool have_same_desk(const CanvasLook& a, const CanvasLook& b);

/// Columns of the canvas, from the first to before the end.
struct Columns {
    int first = 0, end = std::numeric_limits<int>::max();
};

/// Shared with whoever made them: they are looked at until they are uploaded.
using PictureLevels = std::shared_ptr<const std::vector<Grid<glm::u8vec4>>>;

class Renderer {
 public:
    explicit Renderer(DotsBy dots_by = usual_dots_by());

    // What is set with these three is looked at again whenever it is drawn: it has to stay until the next.

    /// Positions are relative to the window's corner. Dots::critical is for fading in and for a part of the
    /// dots. All pieces have it or none, and so it is with Dots::radius. The blocks are dot_blocks() of them.
    void set_dots(const DotPieces& dots, std::span<const DotBlock> blocks, const PageWindow& window = {});
    /// How the dots cover paper, and how many there are in a page unit by one where the density is 1; until
    /// the next set_dots(). Without it they are as placed.
    void set_ink(const InkedDots& ink, double at_full_density);
    /// Several, for Dots::pen and ShownStrokes::pens, each over those before it; none: all is in ink. Until
    /// the next set_dots().
    void set_pens(std::span<const Pen> pens);
    /// One colour a dot, or none for the ink or the pens'; until the next set_dots().
    void set_dot_colours(std::span<const glm::u8vec4> colours);
    /// What is drawn in place of the dots, if there is any; until the next set_dots().
    void set_strokes(const ShownStrokes& strokes);
    /// What is drawn beside either; until the next set_dots().
    void set_inking(const ShownStrokes& inking);
    /// Large tiles before small ones: drawn last, their lines stay on top.
    void set_tiles(std::span<const PlacedTile> tiles, const PageWindow& window = {});
    /// mipmaps_of() it, or nothing. It is seen once upload() has handed all of it to OpenGL.
    void set_picture(PictureLevels levels);
    /// Goes on with that for about so many seconds. True if all of it is there, or there is none.
    bool upload(double seconds);

    /// camera.canvas must be the picture's size; its first row is the top one. Returns full if drawn fully it
    /// would look the same.
    Fineness draw(const GlFramebuffer& picture, const Camera& camera, const CanvasLook& look,
                  Fineness fineness = Fineness::full, Columns columns = {});

    /// The same quickly: of more dots than can be drawn in about that time (seconds), preview_dots(). All,
    /// where that is about as quick.
    Fineness draw_quickly(const GlFramebuffer& picture, const Camera& camera, const CanvasLook& look,
                          Columns columns, double seconds, Desk desk = Desk::drawn);

    /// How long the dots of that took.
    double dots_seconds() const { return dots_seconds_; }

    /// Whether that left dots out.
    bool leaves_out() const { return every_ > 1; }

    /// The same fully and in steps. Setting anything, or another drawing, ends it.
    void begin(const Camera& camera, const CanvasLook& look, Columns columns);
    /// Goes on with what was begun for about so many seconds. True once all of it is in the picture; columns
    /// of others are left alone.
    bool step(const GlFramebuffer& picture, double seconds);

 private:
    /// Where dots can be seen, and how finely.
    struct DotGrid {
        glm::ivec2 low, high;  // pixels of the canvas, y down
        int samples;           // of a pixel's side; 0: there are no dots to be seen
    };

    /// Dots, or lines in place of them.
    struct Shown {
        const DotPieces* dots = nullptr;
        std::span<const DotBlock> blocks;
        std::span<const glm::u8vec4> colours = {};  // none: all in ink, or their pens'
        bool has_radii = false;
        double mean_radius = 0, largest_radius = 0;  // page units, if they have one each
    };

    /// A drawing under way: dots, then the page with them, then tiles.
    struct Job {
        Camera camera;
        CanvasLook look;
        Columns columns;
        DotGrid grid{};
        const Shown* shown = nullptr;       // all of them, or a preview
        std::vector<std::size_t> blocks{};  // in view
        std::size_t in_view = 0;            // dots in them
        std::size_t every = 1;              // one line in so many is drawn; of dots, a preview so small
        std::size_t tiles = 0;              // still to be drawn: the first ones
        std::size_t next_block = 0;
        int next_row = 0;
        Fineness fineness = Fineness::full;
        Desk desk = Desk::drawn;
        bool prepared = false;                   // there is an empty picture for the dots
        std::optional<RasterGrain> raster = {};  // the processor draws them, so finely
        bool uploaded = false;                   // and OpenGL has what it drew

        bool is_done() const {
            if (next_row < static_cast<int>(camera.canvas.y)) return false;
            return tiles == 0 || columns.first >= columns.end;
        }
    };
    class Turn;

    Job job_of(const Camera& camera, const CanvasLook& look, Fineness fineness, Columns columns) const;
    static void measure_radii(Shown& shown);
    /// The mean radius of the dots that are looked at, in pixels.
    double mean_radius(const Camera& camera, const CanvasLook& look) const;
    DotGrid dot_grid(const Camera& camera, const CanvasLook& look, Fineness fineness, Columns columns) const;
    /// Its dots, then the page with them, then tiles, for about so many seconds. True once all is there.
    bool go_on(Job& job, const GlFramebuffer& picture, double seconds);
    void begin_dots(Job& job, Turn& turn);
    void add_dots(Job& job, Turn& turn);
    void draw_all_dots(Job& job, Turn& turn);
    void hand_over_dots(Job& job, const Turn& turn);
    void add_page(Job& job, const GlFramebuffer& picture, Turn& turn);
    void add_tiles(Job& job, Turn& turn);
    GlFramebuffer& dots_of(const Job& job);
    RasterView raster_view(const Job& job) const;
    std::optional<RasterGrain> raster_of(const Job& job) const;
    /// The radius of a dot of that many pixels in what it is drawn with.
    double in_samples(const Job& job, double radius) const;
    void prepare_dots(const Job& job);
    InkToDraw ink_to_draw(const Job& job);
    void draw_dots(Job& job, std::size_t most);
    void draw_lines(Job& job, std::size_t most);
    void draw_inking(const Job& job);
    void begin_ink(const Job& job, const GlProgram& program, double guard);
    void draw_handed_over(const Job& job, double width, double grow);
    void show_preview(Job& job);
    bool has_colours() const { return !all_.colours.empty(); }
    bool by_pen() const { return !pens_.empty() && !has_colours(); }
    /// Pictures that have so many pens' dots.
    std::size_t pictures_of_dots() const { return by_pen() ? (pens_.size() + 3) / 4 : 1; }
    // Pixels of the canvas from the low to before the high ones.
    void draw_page(const Job& job, const GlFramebuffer& picture, const Rectangle<int>& box);
    void draw_page(const Job& job, const Rectangle<int>& box, const GlProgram& program);
    void draw_around(const Job& job, const Rectangle<int>& box, const Rectangle<int>& hole,
                     const GlProgram& program);
    void draw_tiles(Job& job, std::size_t most);
    void attach_columns(const Shown& shown);

    // The first four: see page.frag.
    GlProgram page_, sheet_, sheet_with_picture_, desk_, dot_, line_, tile_;
    GlVertexArray empty_, dot_array_, dot_quad_array_, line_array_, tile_array_;
    GlStreamBuffer dot_x_, dot_y_, dot_critical_, dot_colour_, dot_radius_, line_ends_, line_widths_, tiles_,
        tile_looks_;
    // One for each fineness: to make room for the fine one's samples takes longer than a frame may.
    GlFramebuffer quick_dots_, full_dots_;
    GlTexture picture_;
    PagePoint dot_origin_{0, 0};
    PageWindow tile_window_;
    std::size_t dot_count_ = 0;
    Shown all_, previewed_;
    PreviewDots preview_;
    InkedDots ink_;
    double at_full_density_ = 0;
    std::vector<glm::vec4> pens_;  // linear light; what of that below is seen: 1, multiplied, or 0
    std::span<const PlacedTile> tiles_shown_;
    const ShownStrokes* strokes_ = nullptr;  // instead of the dots; none: these
    const ShownStrokes* inking_ = nullptr;   // beside them
    std::vector<glm::vec4> lines_handed_over_;
    std::vector<float> line_widths_handed_over_;
    Dots handed_over_;  // to OpenGL, when dots are drawn
    std::vector<glm::u8vec4> colours_handed_over_;
    std::optional<Job> job_;
    DotsBy dots_by_;
    ProcessorDots processor_dots_;
    // Measured while drawing in steps.
    double seconds_per_dot_ = 1e-6, seconds_per_row_ = 1e-3;
    DotCost quick_cost_;
    std::size_t every_ = 1;    // of which one was drawn in the last quick drawing
    double dots_seconds_ = 0;  // of the last quick drawing
    bool has_critical_ = false;
    bool has_picture_ = false;
    PictureLevels uploading_;       // none: nothing is left to be
    std::size_t upload_level_ = 0;  // the next rows: of this copy,
    int upload_row_ = 0;            // from this one on
    double largest_point_ = 1, point_step_ = 1;
    SampleLimits limits_;
};

}  // namespace dapple
