#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/output/drawing_format.h"
#include "core/text/text_lines.h"

namespace dapple {
namespace {

constexpr int kDxfDecimals = 3;
constexpr double kLeastDxfRadiusMm = 0.001;

// Each value stands on a line of its own, below the number of its group, which says what it is. What has a
// name or is drawn has a handle, a hexadecimal number (group 5), by which it is told whose another is (330)
// and what another has (340, 350). Here they are those that AutoCAD gives. Layers and entities go on from so
// far that all their handles have as many digits, up to 15 million.
constexpr std::int64_t kFirstDxfHandle = 0x100000;

constexpr const char* kDxfTablesBegin =
    "  0\nSECTION\n  2\nTABLES\n"
    "  0\nTABLE\n  2\nVPORT\n  5\n8\n330\n0\n100\nAcDbSymbolTable\n 70\n0\n"
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nLTYPE\n  5\n5\n330\n0\n100\nAcDbSymbolTable\n 70\n3\n"
    "  0\nLTYPE\n  5\n14\n330\n5\n100\nAcDbSymbolTableRecord\n100\nAcDbLinetypeTableRecord\n"
    "  2\nByBlock\n 70\n0\n  3\n\n 72\n65\n 73\n0\n 40\n0.0\n"
    "  0\nLTYPE\n  5\n15\n330\n5\n100\nAcDbSymbolTableRecord\n100\nAcDbLinetypeTableRecord\n"
    "  2\nByLayer\n 70\n0\n  3\n\n 72\n65\n 73\n0\n 40\n0.0\n"
    "  0\nLTYPE\n  5\n16\n330\n5\n100\nAcDbSymbolTableRecord\n100\nAcDbLinetypeTableRecord\n"
    "  2\nContinuous\n 70\n0\n  3\nSolid line\n 72\n65\n 73\n0\n 40\n0.0\n"
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nLAYER\n  5\n2\n330\n0\n100\nAcDbSymbolTable\n 70\n";  // the number of layers
constexpr const char* kDxfTablesEnd =
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nSTYLE\n  5\n3\n330\n0\n100\nAcDbSymbolTable\n 70\n1\n"
    "  0\nSTYLE\n  5\n11\n330\n3\n100\nAcDbSymbolTableRecord\n100\nAcDbTextStyleTableRecord\n"
    "  2\nStandard\n 70\n0\n 40\n0.0\n 41\n1.0\n 50\n0.0\n 71\n0\n 42\n2.5\n  3\ntxt\n  4\n\n"
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nVIEW\n  5\n6\n330\n0\n100\nAcDbSymbolTable\n 70\n0\n"
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nUCS\n  5\n7\n330\n0\n100\nAcDbSymbolTable\n 70\n0\n"
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nAPPID\n  5\n9\n330\n0\n100\nAcDbSymbolTable\n 70\n1\n"
    "  0\nAPPID\n  5\n12\n330\n9\n100\nAcDbSymbolTableRecord\n100\nAcDbRegAppTableRecord\n"
    "  2\nACAD\n 70\n0\n"
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nDIMSTYLE\n  5\nA\n330\n0\n100\nAcDbSymbolTable\n 70\n1\n"
    "100\nAcDbDimStyleTable\n"
    "  0\nDIMSTYLE\n105\n27\n330\nA\n100\nAcDbSymbolTableRecord\n100\nAcDbDimStyleTableRecord\n"
    "  2\nStandard\n 70\n0\n"
    "  0\nENDTAB\n"
    "  0\nTABLE\n  2\nBLOCK_RECORD\n  5\n1\n330\n0\n100\nAcDbSymbolTable\n 70\n2\n"
    "  0\nBLOCK_RECORD\n  5\n1F\n330\n1\n100\nAcDbSymbolTableRecord\n100\nAcDbBlockTableRecord\n"
    "  2\n*Model_Space\n340\n22\n"
    "  0\nBLOCK_RECORD\n  5\n1B\n330\n1\n100\nAcDbSymbolTableRecord\n100\nAcDbBlockTableRecord\n"
    "  2\n*Paper_Space\n340\n1E\n"
    "  0\nENDTAB\n"
    "  0\nENDSEC\n";
constexpr const char* kDxfBlocks =
    "  0\nSECTION\n  2\nBLOCKS\n"
    "  0\nBLOCK\n  5\n20\n330\n1F\n100\nAcDbEntity\n  8\n0\n100\nAcDbBlockBegin\n"
    "  2\n*Model_Space\n 70\n0\n 10\n0.0\n 20\n0.0\n 30\n0.0\n  3\n*Model_Space\n  1\n\n"
    "  0\nENDBLK\n  5\n21\n330\n1F\n100\nAcDbEntity\n  8\n0\n100\nAcDbBlockEnd\n"
    "  0\nBLOCK\n  5\n1C\n330\n1B\n100\nAcDbEntity\n 67\n1\n  8\n0\n100\nAcDbBlockBegin\n"
    "  2\n*Paper_Space\n 70\n0\n 10\n0.0\n 20\n0.0\n 30\n0.0\n  3\n*Paper_Space\n  1\n\n"
    "  0\nENDBLK\n  5\n1D\n330\n1B\n100\nAcDbEntity\n 67\n1\n  8\n0\n100\nAcDbBlockEnd\n"
    "  0\nENDSEC\n";
// An empty dictionary of groups, and the two layouts that a file of that release has: the space that is drawn
// in, and a sheet of paper.
constexpr const char* kDxfObjects =
    "  0\nSECTION\n  2\nOBJECTS\n"
    "  0\nDICTIONARY\n  5\nC\n330\n0\n100\nAcDbDictionary\n281\n1\n"
    "  3\nACAD_GROUP\n350\nD\n  3\nACAD_LAYOUT\n350\n1A\n"
    "  0\nDICTIONARY\n  5\nD\n330\nC\n100\nAcDbDictionary\n281\n1\n"
    "  0\nDICTIONARY\n  5\n1A\n330\nC\n100\nAcDbDictionary\n281\n1\n"
    "  3\nModel\n350\n22\n  3\nLayout1\n350\n1E\n"
    "  0\nLAYOUT\n  5\n22\n330\n1A\n100\nAcDbPlotSettings\n  1\n\n  2\nnone_device\n  4\n\n  6\n\n"
    " 70\n1024\n 72\n1\n 73\n0\n 74\n5\n  7\n\n 75\n16\n"
    "100\nAcDbLayout\n  1\nModel\n 70\n1\n 71\n0\n330\n1F\n"
    "  0\nLAYOUT\n  5\n1E\n330\n1A\n100\nAcDbPlotSettings\n  1\n\n  2\nnone_device\n  4\n\n  6\n\n"
    " 70\n0\n 72\n1\n 73\n0\n 74\n5\n  7\n\n 75\n16\n"
    "100\nAcDbLayout\n  1\nLayout1\n 70\n1\n 71\n1\n330\n1B\n"
    "  0\nENDSEC\n  0\nEOF\n";

struct DxfLayer {
    std::string name;
    int colour = 7;  // black on white, white on black
};

// The colour of that number, sRGB-encoded: nine by themselves, then rings of 24 hues, five dark steps each
// with a pale sister, and six greys.
glm::vec3 dxf_colour(int number) {
    constexpr std::array<glm::vec3, 10> kFirst{{{},
                                                {1, 0, 0},
                                                {1, 1, 0},
                                                {0, 1, 0},
                                                {0, 1, 1},
                                                {0, 0, 1},
                                                {1, 0, 1},
                                                {0, 0, 0},
                                                glm::vec3(0.5f),
                                                glm::vec3(0.75f)}};
    constexpr std::array<float, 5> kValues{1, 0.8f, 0.6f, 0.5f, 0.3f};
    if (number < 10) return kFirst[static_cast<std::size_t>(number)];
    if (number >= 250) return glm::vec3(static_cast<float>(number - 250) / 5);
    const auto hue = static_cast<float>(number / 10 - 1) * 15;
    const float value = kValues[static_cast<std::size_t>(number % 10 / 2)];
    glm::vec3 colour;
    for (int i = 0; i < 3; ++i) {
        const float away = std::abs(std::remainder(hue - 120 * static_cast<float>(i), 360.0f));
        colour[i] = std::clamp(2 - away / 60, 0.0f, 1.0f);
    }
    if (number % 2 == 1) colour = 0.5f + 0.5f * colour;
    return value * colour;
}

int nearest_dxf_colour(glm::vec3 colour) {
    int nearest = 7;
    const auto distance = [&](int number) { return glm::distance(colour, dxf_colour(number)); };
    for (int number = 1; number < 256; ++number)
        if (distance(number) < distance(nearest)) nearest = number;
    return nearest;
}

// Its name has letters, digits, - and _ only, 31 at most, as the names of layers in older programs have.
DxfLayer layer_of(std::size_t number, const Pen& pen) {
    std::string name = std::to_string(number + 1) + '_' + pen.name.substr(0, 28);
    const auto is_allowed = [](char c) { return std::string_view(" .()").find(c) == std::string_view::npos; };
    std::ranges::replace_if(name, std::not_fn(is_allowed), '_');
    return {std::move(name), nearest_dxf_colour(pen.colour)};
}

// `single`: what the only one is called.
std::vector<DxfLayer> layers_of(std::span<const Pen> pens, const char* single) {
    if (pens.empty()) return {{single}};
    std::vector<DxfLayer> layers;
    for (std::size_t i = 0; i < pens.size(); ++i) layers.push_back(layer_of(i, pens[i]));
    return layers;
}

class DxfWriter : public InkWriter {
 public:
    DxfWriter(std::ostream& out, const InkPage& page)
        : text_(out),
          height_mm_(page.size.height_mm),
          layers_(layers_of(page.pens, page.strokes ? "Lines" : "Dots")) {
        text_ << "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1015\n"
              << "  9\n$DWGCODEPAGE\n  3\nANSI_1252\n"
              << "  9\n$HANDSEED\n  5\nFFFFFFFF\n"  // above all handles
              << "  9\n$INSUNITS\n 70\n4\n"         // millimetres
              << "  9\n$MEASUREMENT\n 70\n1\n"      // metric
              << "  9\n$EXTMIN\n 10\n0.0\n 20\n0.0\n 30\n0.0\n"
              << "  9\n$EXTMAX\n 10\n";
        text_.fixed(page.size.width_mm, kDxfDecimals) << "\n 20\n";
        text_.fixed(page.size.height_mm, kDxfDecimals) << "\n 30\n0.0\n  0\nENDSEC\n";
        text_ << kDxfTablesBegin << static_cast<std::int64_t>(layers_.size() + 1) << '\n';
        text_ << "  0\nLAYER\n  5\n10\n";
        end_layer({"0"});
        for (const DxfLayer& layer : layers_) {
            text_ << "  0\nLAYER\n";
            write_handle();
            end_layer(layer);
        }
        text_ << kDxfTablesEnd << kDxfBlocks << "  0\nSECTION\n  2\nENTITIES\n";
    }

    void begin_pen(int number, const Pen&, double) override { layer_ = static_cast<std::size_t>(number); }

    void dot(const InkDot& dot) override {
        begin_entity("CIRCLE", "AcDbCircle");
        place(dot.at);
        text_ << " 30\n0.0\n 40\n";
        text_.fixed(std::max(dot.radius_mm, kLeastDxfRadiusMm), kDxfDecimals) << '\n';
    }

    void stroke(std::span<const glm::dvec2> points) override {
        if (points.size() == 1) {
            begin_entity("POINT", "AcDbPoint");
            place(points[0]);
            text_ << " 30\n0.0\n";
            return;
        }
        begin_entity("LWPOLYLINE", "AcDbPolyline");
        text_ << " 90\n" << static_cast<std::int64_t>(points.size()) << "\n 70\n0\n";
        for (const glm::dvec2 p : points) place(p);
    }

    void end() override {
        text_ << "  0\nENDSEC\n" << kDxfObjects;
        text_.flush();
    }

 private:
    void write_handle() {
        std::array<char, 16> digits;
        char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), next_handle_++, 16).ptr;
        for (char* digit = digits.data(); digit < end; ++digit)
            if (*digit >= 'a') *digit = static_cast<char>(*digit - 'a' + 'A');
        text_ << "  5\n"
              << std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())) << '\n';
    }

    void end_layer(const DxfLayer& layer) {
        text_ << "330\n2\n100\nAcDbSymbolTableRecord\n100\nAcDbLayerTableRecord\n  2\n"
              << std::string_view(layer.name) << "\n 70\n0\n 62\n"
              << std::int64_t{layer.colour} << "\n  6\nContinuous\n";
    }

    void begin_entity(std::string_view kind, std::string_view as) {
        text_ << "  0\n" << kind << '\n';
        write_handle();
        text_ << "100\nAcDbEntity\n  8\n"
              << std::string_view(layers_[layer_].name) << "\n100\n"
              << as << '\n';
    }

    void place(glm::dvec2 p) {
        text_ << " 10\n";
        text_.fixed(p.x, kDxfDecimals) << "\n 20\n";
        text_.fixed(height_mm_ - p.y, kDxfDecimals) << '\n';
    }

    TextBuffer text_;
    double height_mm_;
    std::vector<DxfLayer> layers_;
    std::size_t layer_ = 0;  // of the pen that draws
    std::int64_t next_handle_ = kFirstDxfHandle;
};

}  // namespace

void write_dxf(std::ostream& out, const InkPage& page, const WritingProgress& progress) {
    DxfWriter writer(out, page);
    write_ink(writer, page, progress);
}

}  // namespace dapple
