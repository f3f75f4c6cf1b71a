#include "core/strokes/stroke_font.h"

#include <cctype>

namespace dapple {
namespace {

constexpr double kHigh = 6, kAdvance = 6, kWide = 4;

std::string_view lines_of(char letter) {
    switch (std::toupper(static_cast<unsigned char>(letter))) {
        // clang-format off
        case 'A': return "0602204246 0444";
        case 'B': return "00063645443303 0030414233";
        case 'C': return "4130100105163645";
        case 'D': return "00062644422000";
        case 'E': return "40000646 0333";
        case 'F': return "400006 0333";
        case 'G': return "41301001051636454323";
        case 'H': return "0006 4046 0343";
        case 'I': return "1030 1636 2026";
        case 'J': return "4045361605";
        case 'K': return "0006 400346";
        case 'L': return "000646";
        case 'M': return "0600234046";
        case 'N': return "06004640";
        case 'O': case '0': return "100105163645413010";
        case 'P': return "06003041423303";
        case 'Q': return "100105163645413010 2446";
        case 'R': return "06003041423303 2346";
        case 'S': return "413010010213334445361605";
        case 'T': return "0040 2026";
        case 'U': return "000516364540";
        case 'V': return "002640";
        case 'W': return "0016233640";
        case 'X': return "0046 4006";
        case 'Y': return "002340 2326";
        case 'Z': return "00400646";
        case '1': return "112026 1636";
        case '2': return "01103041420646";
        case '3': return "0110304142334445361605 1333";
        case '4': return "36300444";
        case '5': return "400002324345361605";
        case '6': return "413010010516364544331304";
        case '7': return "004016";
        case '8': return "13334241301001021304051636454433";
        case '9': return "051636454130100102133342";
        case '.': return "2526";
        case '-': return "1333";
        case '+': return "2125 0343";
        case '(': return "30212536";
        case ')': return "10212516";
        case '_': return "0646";
        default: return "";
            // clang-format on
    }
}

}  // namespace

void add_text(Strokes& strokes, std::string_view text, glm::dvec2 corner, double height_mm, int pen) {
    const double step = height_mm / kHigh;
    for (const char letter : text) {
        std::string_view lines = lines_of(letter);
        while (!lines.empty()) {
            if (lines.front() == ' ') {
                end_stroke(strokes, pen);
                lines.remove_prefix(1);
            }
            strokes.points.push_back(corner + step * glm::dvec2(lines[0] - '0', lines[1] - '0'));
            lines.remove_prefix(2);
        }
        end_stroke(strokes, pen);
        corner.x += step * kAdvance;
    }
}

double text_width_mm(std::string_view text, double height_mm) {
    if (text.empty()) return 0;
    return height_mm / kHigh * (kAdvance * static_cast<double>(text.size() - 1) + kWide);
}

}  // namespace dapple
