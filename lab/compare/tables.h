#pragma once
// What dapple-lab compare measured, as rows of words for text and page alike.

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

/// Tables for grey, for each picture and for growth, where something was to be measured. With several counts
/// of grey there is also the worst of each column over those after the first.
std::vector<CompareTable> compare_tables(std::span<const MeasuredMethod> measured,
                                         const CompareRequest& request);

/// Who has the best of each column of marks, and what the better of dapple's rows has.
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

/// The places on grey at the first count, and on each picture; none where dapple was not measured.
std::vector<PlacesTable> places_tables(std::span<const MeasuredMethod> measured,
                                       const CompareRequest& request);

}  // namespace dapple
