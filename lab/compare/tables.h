#pragma once
// What was measured as rows of words, for text and page alike.

#include <span>
#include <string>
#include <vector>

#include "lab/compare/measure.h"

namespace dapple {

struct CompareTable {
    std::string title;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
};

/// Grey, each picture, growth; those of which something was to be measured. Where there are several counts
/// of grey, also the worst of each column over those after the first.
std::vector<CompareTable> compare_tables(std::span<const MeasuredMethod> measured,
                                         const CompareRequest& request);

/// For each column of marks who has the best, and what dapple's better row has.
struct PlacesTable {
    struct Row {
        std::vector<std::string> cells;
        bool dapple_first = false;
    };
    std::string title;
    std::vector<Row> rows;
    std::string sentence;  // in how many columns dapple is not first
};
inline const std::vector<std::string> kPlacesHead{"what", "first", "has", "Dapple's better", "has"};

/// Of grey at the first count and of each picture; none where dapple was not measured.
std::vector<PlacesTable> places_tables(std::span<const MeasuredMethod> measured,
                                       const CompareRequest& request);

}  // namespace dapple
